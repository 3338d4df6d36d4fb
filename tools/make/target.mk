# SPDX-License-Identifier: MIT
#
# Target processors: the library compiled for each, the README's example linked, sizes, and the same bits everywhere.

TARGETS := m0plus m4f rv32imac avr

m0plus_CC := arm-none-eabi-gcc
m0plus_FLAGS := -mcpu=cortex-m0plus -mthumb
m4f_CC := arm-none-eabi-gcc
m4f_FLAGS := -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
# picolibc is a package of its own beside Debian's RISC-V compiler; elsewhere the compiler brings newlib.
rv32imac_CC := riscv64-unknown-elf-gcc
rv32imac_FLAGS = -march=rv32imac -mabi=ilp32 $(if $(wildcard $(shell \
	riscv64-unknown-elf-gcc -print-file-name=picolibc.specs 2>/dev/null)),--specs=picolibc.specs)
avr_CC := avr-gcc
avr_FLAGS := -mmcu=atmega1284p

target_make = $(SUBMAKE) B=$(B)/cross/$(1) CC=$($(1)_CC) AR=$(patsubst %gcc,%ar,$($(1)_CC)) \
	CFLAGS="-Os $(strip $($(1)_FLAGS))" PNG=no ASSIMP=no

.PHONY: cross $(TARGETS:%=cross-%)
cross: $(TARGETS:%=cross-%) ## Compile library and scenes for Cortex-M0+, Cortex-M4F, RV32IMAC and AVR, warnings as errors
$(TARGETS:%=cross-%): cross-%:
	@+$(call target_make,$*) library target-scenes
	@echo "$*: library and scenes compile without a warning"

# The example as a reader of the README would take it: the first c block after the mark.
STARTUP := tests/target/startup
TARGET_SOURCES := $(sort $(wildcard $(STARTUP)/*.c))
FIRMWARE := $(B)/cross/m0plus/firmware-example
LINK_ARM = -nostdlib -Wl,--gc-sections,-T,$(STARTUP)/cortex_m.ld $(STARTUP)/cortex_m_startup.c

.PHONY: firmware-example
firmware-example: ## Compile the README's example for Cortex-M0+, link it, and look at what it pulls in
	@+$(SUBMAKE) cross-m0plus
	@awk '/^<!-- firmware example -->/ { marked = 1 } /^```/ && inside { exit } inside { print } \
		/^```c$$/ && marked { inside = 1 }' README.md > $(FIRMWARE).c
	@test -s $(FIRMWARE).c || { echo "README.md has no c block after <!-- firmware example -->" >&2; exit 1; }
	$(m0plus_CC) $(STRICT) -ffunction-sections -fdata-sections -Os $(m0plus_FLAGS) -Iinclude -Iexamples -I. \
		$(LINK_ARM) $(FIRMWARE).c $(B)/cross/m0plus/libscenes.a $(B)/cross/m0plus/libglint.a -lc_nano -lgcc \
		-Wl,-Map=$(FIRMWARE).map -o $(FIRMWARE).elf
	@tools/check-firmware.sh arm-none-eabi-nm $(FIRMWARE).elf

.PHONY: target-scenes
target-scenes: $(SCENES)
	@:

# Size programs: PROCESSOR-BACKEND for each pair below.
SIZE_PROGRAMS := m0plus-fixed m0plus-fixed_phong m0plus-fixed_diffuse m0plus-float m4f-fixed m4f-float m4f-float_phong \
	avr-fixed_phong avr-fixed_diffuse
size_target = $(firstword $(subst -, ,$(1)))
size_backend = $(lastword $(subst -, ,$(1)))
# Loops that copy or set bytes stay loops: else those of small_memory.c would be calls of themselves.
m0plus_LINK := $(LINK_ARM) -fno-tree-loop-distribute-patterns $(STARTUP)/small_memory.c
m0plus_LINK_LIBS := -lc_nano -lgcc
m4f_LINK := $(LINK_ARM)
m4f_LINK_LIBS := -lc_nano -lgcc
avr_LINK := -Wl,--gc-sections
avr_LINK_LIBS :=

.PHONY: size $(SIZE_PROGRAMS:%=size-%)
size: $(SIZE_PROGRAMS:%=size-%) ## Flash and RAM per backend and processor, with the difference to docs/size-baseline.txt
	@tools/size-report.sh $(B)/cross $(SIZE_PROGRAMS)
$(SIZE_PROGRAMS:%=size-%): size-%: cross-m0plus cross-m4f cross-avr
	@target=$(call size_target,$*); \
	$($(call size_target,$*)_CC) $(STRICT) -ffunction-sections -fdata-sections -Os $($(call size_target,$*)_FLAGS) \
		-Iinclude -DGLINT_SIZE_RENDER=glint_$(call size_backend,$*)_render $($(call size_target,$*)_LINK) \
		$(STARTUP)/size_program.c $(B)/cross/$$target/libglint.a $($(call size_target,$*)_LINK_LIBS) \
		-o $(B)/cross/$$target/size-$(call size_backend,$*).elf

# The fixed backend gives the same bits whatever the compiler, its optimisation and the height of the bands.
BIT_BUILDS := gcc-O0 gcc-O2 gcc-Os clang-O0 clang-O2 clang-Os

.PHONY: bit-identical $(BIT_BUILDS:%=bits-%)
bit-identical: $(BIT_BUILDS:%=bits-%) ## All scenes, fixed backend: the same bits for gcc and clang at -O0 -O2 -Os, any band height
	@tools/check-bit-identical.sh $(B)/bits $(BIT_BUILDS)
$(BIT_BUILDS:%=bits-%): bits-%:
	@+$(SUBMAKE) B=$(B)/bits/$* CC=$(firstword $(subst -, ,$*)) CFLAGS=-$(lastword $(subst -, ,$*)) PNG=no ASSIMP=no \
		$(B)/bits/$*/glint-render >/dev/null
