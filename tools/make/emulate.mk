# SPDX-License-Identifier: MIT
#
# The self-test of tests/target on emulated processors: `make targets`. Each is a flavour of this Makefile, called with
# EMULATE=NAME and that target's compiler; compilers and flags that target.mk has are taken from there. All is compiled
# with -O2, as the host's library is, but for the AVR, whose flash is small.

EMULATED := m0plus m3 m4f rv32imac avr s390x i686
SELFTEST := tests/target

m3_CC := arm-none-eabi-gcc
m3_FLAGS := -mcpu=cortex-m3 -mthumb
s390x_CC := s390x-linux-gnu-gcc
# gcc -std=c99 evaluates float expressions in double on this processor (FLT_EVAL_METHOD 1), and warns of it.
s390x_FLAGS := -Wno-double-promotion
i686_CC := i686-linux-gnu-gcc
# Both backends and the self-test do not fit the AVR's 128 KB: its float routines are tested there, its float frames not,
# and its fixed frames without the parts that the self-test does not ask for. Inlining makes its code a sixth larger.
avr_LEVEL := -Os -fno-inline -mcall-prologues -mrelax -mstrict-X -fno-move-loop-invariants -DSELFTEST_FLOAT_FRAMES=0

# What stands beside the self-test on each, and how it is linked.
m0plus_GLUE := $(SELFTEST)/platform_arm.c $(STARTUP)/cortex_m_startup.c
m3_GLUE := $(m0plus_GLUE)
m4f_GLUE := $(m0plus_GLUE)
rv32imac_GLUE := $(SELFTEST)/platform_riscv.c $(STARTUP)/riscv_startup.c
avr_GLUE := $(SELFTEST)/platform_avr.c $(SELFTEST)/small_fixed.c
s390x_GLUE := $(SELFTEST)/platform_stdio.c
i686_GLUE := $(s390x_GLUE)
host_GLUE := $(s390x_GLUE)

m3_SCRIPT := -nostdlib -Wl,-T,$(STARTUP)/cortex_m.ld
m4f_SCRIPT := $(m3_SCRIPT)
m0plus_SCRIPT := $(m3_SCRIPT) -Wl,--defsym=link_ram_bytes=16K
# -T to the compiler, not to the linker: so that picolibc.specs leaves out its own script.
rv32imac_SCRIPT := -nostartfiles -T $(STARTUP)/riscv.ld
s390x_SCRIPT := -static
i686_SCRIPT := -static
m0plus_LIBS := -lc_nano -lgcc
m3_LIBS := $(m0plus_LIBS)
m4f_LIBS := $(m0plus_LIBS)

SELFTEST_SOURCES := $(sort $(wildcard $(SELFTEST)/selftest*.c)) examples/scenes/spheres.c \
	$(patsubst %,examples/meshes/%.c,box sphere_10x6 sphere_32x16 sphere_64x32)
TARGET_SOURCES += $(sort $(wildcard $(SELFTEST)/*.c))

.PHONY: targets
targets: ## The self-test on emulated Cortex-M, RISC-V, AVR, s390x and 32-bit x86: the same bits? Installs what is missing
	@tools/install-packages.sh targets
	@+$(SUBMAKE) run-targets

.PHONY: run-targets
run-targets: $(patsubst %,$(B)/targets/%/report.txt,host $(EMULATED)) $(B)/check-selftest ## Run it with what is installed
	@tools/run-targets.sh table $(B) host $(EMULATED)

$(B)/targets/%/report.txt: $(B)/targets/%/selftest.elf FORCE
	$(call run,RUN )tools/run-targets.sh run $(B) $*

.PRECIOUS: $(B)/targets/%/selftest.elf
$(B)/targets/%/selftest.elf: FORCE
	@+$(SUBMAKE) -s EMULATE=$* B=$(B)/targets/$* PNG=no ASSIMP=no CFLAGS="$(or $($*_LEVEL),-O2) $(strip $($*_FLAGS))" \
		CC="$(or $($*_CC),$(CC))" AR=$(or $(patsubst %gcc,%ar,$($*_CC)),$(AR)) $@

# It is firmware on most targets, so it is compiled as the library is; but the judge is a tool of the host.
$(B)/obj/$(SELFTEST)/%.o: $(SELFTEST)/%.c $(LIBRARY_STAMPS)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(LIBRARY_FLAGS) -I. -MMD -MP -c $< -o $@
$(B)/obj/$(SELFTEST)/check.o: LIBRARY_FLAGS = $(HOST_FLAGS)

$(B)/check-selftest: $(call objects,$(SELFTEST)/check.c $(SELFTEST)/selftest_scenes.c) $(HOST_ARCHIVES)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

-include $(patsubst %.o,%.d,$(call objects,$(TARGET_SOURCES)))

# Within the flavour.
ifdef EMULATE
$(B)/selftest.elf: $(call objects,$($(EMULATE)_GLUE) $(SELFTEST_SOURCES)) $(LIBRARY) $(wildcard $(STARTUP)/*.ld)
	$(call run,LINK)$(CC) $(CFLAGS) -Wl,--gc-sections $($(EMULATE)_SCRIPT) -o $@ $(filter %.o %.a,$^) \
		$($(EMULATE)_LIBS)
endif
