# SPDX-License-Identifier: MIT
#
# What a frame costs on emulated processors: `make cost`, `make profile`. Each processor is a flavour of this Makefile,
# called with COST=NAME; compilers, flags, start-up code and scripts are those of target.mk and emulate.mk.

COST_FLAGS ?= -O2
# At -O2 the library and the scenes are 80 KB more than the AVR's flash holds; and so are its scenes, which have no point
# lights, with all parts of the backend.
COST_FLAGS_avr ?= -Os -fno-inline -DSMALL_PARTS=0x1c00dul -mcall-prologues -mrelax -mstrict-X -fno-move-loop-invariants
cost_flags = $(or $(COST_FLAGS_$(1)),$(COST_FLAGS))
COST_TARGETS := m0plus m3 m4f rv32imac m0plus-cycles avr-cycles
COST_PROCESSORS := m0plus m3 m4f rv32imac avr
RP2040JS := 1.4.1
COST_NODE := $(B)/cost/node
STACK_SHADINGS := exact "auto 1"

COST_SOURCES := $(sort $(wildcard tools/cost/*.c))
COST_FIRMWARE := $(patsubst %,tools/cost/%.c,calibrate cases cost frames) $(SELFTEST)/selftest_report.c
TARGET_SOURCES += $(COST_SOURCES)

# The programs of each processor: cost.elf for QEMU or simavr; for the RP2040's emulator cycles.elf, with that chip's RAM,
# and profile.elf, with as much RAM as any scene takes. Each has its RAM, its settings of program.c and its platform.
cost_programs = $(patsubst %,$(B)/cost/$(1)/%.elf,$(or $(COST_PROGRAMS_$(1)),cost))
COST_PROGRAMS_m0plus := cost cycles profile
COST_RAM_cost := 2M
COST_RAM_cycles := 264K
COST_DEFINE_cycles := -DPROGRAM_MEMORY_BYTES=262144
# Software floating point would take minutes in that emulator, and m0plus counts it in instructions.
COST_DEFINE_cycles += -DPROGRAM_BACKENDS=1
COST_PLATFORM_cycles := $(SELFTEST)/platform_rp2040.c
COST_RAM_profile := $(COST_RAM_cost)
COST_PLATFORM_profile := $(COST_PLATFORM_cycles)

.PHONY: cost
cost: ## What a frame costs on emulated processors, beside other renderers: build/cost/cost.csv. Installs what is missing
	@tools/install-packages.sh cost || echo "Going on with what is there."
	@+$(SUBMAKE) run-cost

.PHONY: run-cost
run-cost: $(patsubst %,cost-count-%,$(COST_TARGETS)) $(B)/cost-judge ## Count with what is installed; COST_FLAGS=-O2
	@tools/cost/run.sh table $(B) tools/cost/peers.csv $(COST_TARGETS)

cost_processor = $(patsubst %-cycles,%,$(1))
# What a target runs, of its processor's programs.
cost_program = $(B)/cost/$(call cost_processor,$(1))/$(if $(filter m0plus-cycles,$(1)),cycles,cost).elf

.PHONY: $(COST_TARGETS:%=cost-count-%)
$(COST_TARGETS:%=cost-count-%): cost-count-%:
	@mkdir -p $(B)/cost && rm -f $(B)/cost/$*.txt $(B)/cost/$*.flags
	@+if tools/cost/run.sh probe $*; then \
		$(if $(filter m0plus-cycles,$*),$(SUBMAKE) -s $(COST_NODE)/node_modules/rp2040js &&) \
		echo "  RUN   $*" && tools/cost/run.sh run $(B) $* $(call cost_program,$*) $(B)/cost/$*.txt && \
		{ $($(call cost_processor,$*)_CC) --version | head -n 1; \
		echo '$(strip $(call cost_flags,$(call cost_processor,$*)) $($(call cost_processor,$*)_FLAGS))'; } \
			> $(B)/cost/$*.flags; \
	fi
$(foreach target,$(COST_TARGETS),$(eval cost-count-$(target): cost-build-$(call cost_processor,$(target))))

.PHONY: profile
profile: ## Where a frame's instructions go: SCENE=A TARGET=m0plus BACKEND=fixed SHADING=exact
	@case "$(or $(TARGET),m0plus)" in m0plus) ;; *) echo "make profile: TARGET=m0plus is the only one" >&2; exit 2 ;; esac
	@tools/cost/run.sh probe m0plus-cycles
	@+$(SUBMAKE) -s cost-build-m0plus $(COST_NODE)/node_modules/rp2040js
	@node tools/cost/rp2040.js $(COST_NODE) $(B)/cost/m0plus/profile.elf --profile \
		"$(strip $(or $(SCENE),A) $(or $(BACKEND),fixed) $(SHADING))"

.PHONY: stack
stack: ## Bytes of stack and of RAM in all that a frame takes on the Cortex-M0+: SCENE=A-bands16
	@tools/cost/run.sh probe m0plus-cycles
	@+$(SUBMAKE) -s cost-build-m0plus $(COST_NODE)/node_modules/rp2040js
	@echo "Bytes of stack; of memory given, and with the stack in all: the least; with lists and vertices; all it uses."
	@echo "The library has no variables beside these. RGB565."
	@printf '%-24s%7s%14s%14s%14s\n' case stack 'least   all' 'lists   all' 'used   all'
	@for shading in $(STACK_SHADINGS); do \
		node tools/cost/rp2040.js $(COST_NODE) $(B)/cost/m0plus/profile.elf \
			--stack "$(or $(SCENE),A-bands16) fixed $$shading" || exit 1; \
	done

.PHONY: cost-pages
cost-pages: ## Refresh the figures of README.md and docs/performance.md from the last `make cost`, and from profiles
	@test -f $(B)/cost/cost.csv || { echo "make cost-pages: make cost first" >&2; exit 1; }
	@tools/cost/run.sh probe m0plus-cycles
	@+$(SUBMAKE) -s cost-build-m0plus $(COST_NODE)/node_modules/rp2040js
	@tools/cost/pages.sh $(B)

$(COST_NODE)/node_modules/rp2040js:
	@mkdir -p $(COST_NODE)
	@npm install --prefix $(COST_NODE) --no-audit --no-fund --loglevel=error rp2040js@$(RP2040JS)

.PHONY: $(COST_PROCESSORS:%=cost-build-%)
$(COST_PROCESSORS:%=cost-build-%): cost-build-%:
	@+! command -v $($*_CC) >/dev/null || $(SUBMAKE) -s COST=$* B=$(B)/cost/$* PNG=no ASSIMP=no \
		CC=$($*_CC) AR=$(patsubst %gcc,%ar,$($*_CC)) CFLAGS="$(call cost_flags,$*) -g $(strip $($*_FLAGS))" \
		$(call cost_programs,$*)

$(B)/cost-judge: $(call objects,$(addprefix tools/cost/,judge.c cases.c frames.c) \
		$(addprefix $(SELFTEST)/,selftest_report.c platform_stdio.c)) $(HOST_ARCHIVES)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

# Firmware but for the judge, which is a tool of the host.
$(B)/obj/tools/cost/%.o: tools/cost/%.c $(LIBRARY_STAMPS)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(LIBRARY_FLAGS) -I. -MMD -MP -c $< -o $@
$(B)/obj/tools/cost/judge.o: LIBRARY_FLAGS = $(HOST_FLAGS)
-include $(patsubst %.o,%.d,$(call objects,$(COST_SOURCES)))

# Within the flavour: start-up code and script that emulate.mk names, the script with the RAM asked for.
ifdef COST
COST_PLATFORM_cost := $(firstword $($(COST)_GLUE))
COST_START := $(wordlist 2,9,$($(COST)_GLUE))
ifneq ($(filter m%,$(COST)),)
# Both backends and all scenes at -O2: more than 256 KB.
COST_LINK = $(m3_SCRIPT) -Wl,--defsym=link_flash_bytes=512K,--defsym=link_ram_bytes=$(COST_RAM_$(1))
else ifeq ($(COST),rv32imac)
COST_LINK = -nostartfiles -T $(B)/riscv.ld
$(B)/cost.elf: $(B)/riscv.ld
$(B)/riscv.ld: $(STARTUP)/riscv.ld $(BUILD_FILES)
	@sed -e 's/LENGTH = 256K/LENGTH = 512K/; s/ORIGIN = 0x80040000, LENGTH = 32K/ORIGIN = 0x80080000, LENGTH = $(COST_RAM_cost)/' $< > $@
else
# Of its 16 KB of RAM 0.8 KB is for variables and constants; the rest is stack, of which a frame within a tolerance takes
# less than 2.5 KB. What is enough for exact shading.
COST_DEFINE_cost := -DPROGRAM_MEMORY_BYTES=12800
endif

COST_LINKED := $(call objects,$(filter-out tools/cost/cases.c,$(COST_FIRMWARE)) $(COST_START))
COST_PREREQUISITES := $(COST_LINKED) tools/cost/program.c $(COST_PLATFORM_cost) $(COST_PLATFORM_cycles) $(SCENES) $(LIBRARY)
# name of a program, and what has its cases
cost_link = $(CC) $(LIBRARY_FLAGS) -I. -Wl,--gc-sections -DPLATFORM_MPS2 -o $@ $(call COST_LINK,$(1)) $(COST_DEFINE_$(1)) \
	tools/cost/program.c $(COST_PLATFORM_$(1)) $(2) $(COST_LINKED) $(SCENES) $(LIBRARY) $($(COST)_LIBS)

$(B)/%.elf: $(COST_PREREQUISITES) $(call objects,tools/cost/cases.c)
	$(call run,LINK)$(call cost_link,$*,$(call objects,tools/cost/cases.c))
endif
