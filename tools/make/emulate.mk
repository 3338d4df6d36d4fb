# SPDX-License-Identifier: MIT
#
# The self-test of tests/target on emulated processors: `make targets`. Compilers and flags that target.mk has are used
# from there. Everything is compiled with -O2, below which counts would be those of code that nobody runs.

EMULATED := m0plus m3 m4f rv32imac avr s390x i686
SELFTEST := tests/target

m3_CC := arm-none-eabi-gcc
m3_FLAGS := -mcpu=cortex-m3 -mthumb
s390x_CC := s390x-linux-gnu-gcc
i686_CC := i686-linux-gnu-gcc
host_CC = $(CC)

# The platform of each: its file of glue, and how the program is linked.
ARM_GLUE := $(SELFTEST)/platform_arm.c $(STARTUP)/cortex_m_startup.c
ARM_LINK := -nostdlib -Wl,--gc-sections,-T,$(STARTUP)/cortex_m.ld
ARM_LIBS := -lc_nano -lgcc
$(foreach arm,m0plus m3 m4f,$(eval $(arm)_GLUE := $(ARM_GLUE))$(eval $(arm)_EMULATED_LINK := $(ARM_LINK))$(eval \
	$(arm)_EMULATED_LIBS := $(ARM_LIBS)))
m0plus_EMULATED_LINK += -Wl,--defsym=link_ram_bytes=16K # the nRF51 of the micro:bit
rv32imac_GLUE := $(SELFTEST)/platform_riscv.c $(STARTUP)/riscv_startup.c
rv32imac_EMULATED_LINK := -nostartfiles -Wl,--gc-sections,-T,$(STARTUP)/riscv.ld
avr_GLUE := $(SELFTEST)/platform_avr.c
avr_EMULATED_LINK := -Wl,--gc-sections
$(foreach system,s390x i686 host,$(eval $(system)_GLUE := $(SELFTEST)/platform_stdio.c))
s390x_EMULATED_LINK := -static
i686_EMULATED_LINK := -static

SELFTEST_PARTS := $(sort $(wildcard $(SELFTEST)/selftest*.c))
SELFTEST_SCENES := examples/scenes/spheres.c examples/meshes/sphere_10x6.c examples/meshes/sphere_32x16.c \
	examples/meshes/sphere_64x32.c examples/meshes/box.c
TARGET_SOURCES += $(sort $(wildcard $(SELFTEST)/*.c))

.PHONY: targets
targets: ## Run the self-test on emulated Cortex-M, RISC-V, AVR, s390x and 32-bit x86: the same bits as here? Installs what is missing
	@tools/install-packages.sh targets
	@+$(SUBMAKE) run-targets

.PHONY: run-targets
run-targets: $(EMULATED:%=$(B)/targets/%/report.txt) $(B)/targets/host/report.txt $(B)/targets/check
	@tools/run-targets.sh table $(B)/targets $(EMULATED)

# Run again whenever anything was built again; the report stands only if the run came to its end.
$(B)/targets/%/report.txt: $(B)/targets/%/selftest.elf tools/run-targets.sh
	@tools/run-targets.sh run $* $(B)/targets

# The library comes from this Makefile with the target's compiler; the self-test is compiled and linked in one command.
$(B)/targets/%/selftest.elf: FORCE
	@mkdir -p $(@D)
	@+$(SUBMAKE) B=$(B)/targets/$* CC="$($*_CC)" AR=$(patsubst %gcc,%ar,$(filter-out $(CC),$($*_CC)) $(if $(filter \
		$(CC),$($*_CC)),$(AR))) CFLAGS="-O2 $(strip $($*_FLAGS))" PNG=no ASSIMP=no library
	@if [ ! -f $@ ] || [ -n "$$(find include src tests/target examples/meshes examples/scenes tools/make Makefile \
			-newer $@ -type f)" ]; then \
		echo "  LINK  $@"; \
		$($*_CC) $(STRICT) -O2 $($*_FLAGS) $(if $(filter rv32imac,$*),-Wa$(comma)-march=rv32imac_zicsr) \
			-ffunction-sections -fdata-sections -Iinclude -Isrc -I. $($*_EMULATED_LINK) $($*_GLUE) \
			$(SELFTEST_PARTS) $(SELFTEST_SCENES) $(B)/targets/$*/libglint.a $($*_EMULATED_LIBS) -o $@; \
	fi
comma := ,

$(B)/targets/check: $(call objects,$(SELFTEST)/check.c $(SELFTEST)/selftest_scenes.c) $(HOST_ARCHIVES)
	@mkdir -p $(@D)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm
