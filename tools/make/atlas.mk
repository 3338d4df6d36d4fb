# SPDX-License-Identifier: MIT
#
# The atlas, what accuracy costs in time: `make atlas`. The frames are counted by the programs of cost.mk, with one scene
# each (tools/atlas/cases.c), so that what is finished is kept: a part runs again when its program is another.

TARGET_SOURCES += $(sort $(wildcard tools/atlas/*.c))

ATLAS_LIST ?= tools/atlas/scenes.txt
ATLAS ?= $(B)/atlas$(if $(QUICK),-quick)
ATLAS_QUICK := A C-96x64
# The scenes whose frames are taken apart by stage, and whose pictures are shown.
ATLAS_SHOWN := A C teapot knot room point-light

# A row of the list is NAME:SCENE:WIDTHxHEIGHT:BAND:TARGETS, and for a scene that is not built in :SOURCE.
atlas_rows := $(shell awk '!/^\#/ && NF { gsub(/ +/, ":"); print }' $(ATLAS_LIST))
$(foreach row,$(atlas_rows),$(eval ATLAS_ROW_$(firstword $(subst :, ,$(row))) := $(subst :, ,$(row))))
atlas_field = $(word $(2),$(ATLAS_ROW_$(1)))
ATLAS_SCENES := $(foreach row,$(atlas_rows),$(firstword $(subst :, ,$(row))))
ifneq ($(and $(QUICK),$(if $(ATLAS_OWN),,shipped)),)
ATLAS_SCENES := $(filter $(ATLAS_QUICK),$(ATLAS_SCENES))
endif
ATLAS_SHOWN := $(filter $(ATLAS_SHOWN),$(ATLAS_SCENES))
ATLAS_OWN_SOURCE := $(foreach scene,$(ATLAS_SCENES),$(call atlas_field,$(scene),6))
atlas_defines = '-DATLAS_NAME="$(1)"' -DATLAS_SCENE=$(call atlas_field,$(1),2) -DATLAS_BAND_PX=$(call atlas_field,$(1),4) \
	$(join -DATLAS_WIDTH_PX= -DATLAS_HEIGHT_PX=,$(subst x, ,$(call atlas_field,$(1),3)))
atlas_cases = $(call atlas_defines,$(1)) tools/atlas/cases.c $(call atlas_field,$(1),6)

# Programs of a scene on a processor: clock.elf for the RP2040's emulator, in fixed point with as much RAM as any scene
# takes; the other for QEMU or simavr, in a quick run without what software floating point would take its time for.
ATLAS_KIND := $(if $(QUICK),fixed,cost)
ATLAS_KINDS_m0plus := $(ATLAS_KIND) clock
ATLAS_KINDS_m3 := $(ATLAS_KIND)
ATLAS_KINDS_m4f := cost
ATLAS_KINDS_rv32imac := $(ATLAS_KIND)
ATLAS_KINDS_avr := cost $(if $(QUICK),,float)
COST_RAM_fixed := $(COST_RAM_cost)
COST_DEFINE_fixed := -DPROGRAM_BACKENDS=1
COST_PLATFORM_fixed = $(COST_PLATFORM_cost)
# Of the AVR, whose flash does not hold both backends: the float one with the parts of the other.
COST_DEFINE_float := -DPROGRAM_BACKENDS=2 -DPROGRAM_MEMORY_BYTES=12800 -DFRAMES_IN_FLOAT
COST_PLATFORM_float = $(COST_PLATFORM_cost)
COST_RAM_clock := $(COST_RAM_cost)
COST_DEFINE_clock := $(COST_DEFINE_fixed)
COST_PLATFORM_clock := $(COST_PLATFORM_cycles)

# Of the targets' reports, one is in two: avr-cycles+float.txt.
atlas_on = $(foreach scene,$(ATLAS_SCENES),$(if $(filter avr,$(1)),$(if $(filter all,$(call atlas_field,$(scene),5)),$(scene)),$(scene)))
atlas_programs = $(foreach scene,$(call atlas_on,$(1)),$(foreach kind,$(ATLAS_KINDS_$(1)),atlas/$(scene)/$(kind).elf)) \
	$(if $(ATLAS_OWN),,$(addprefix atlas/routines/,$(foreach tables,full small,$(tables).elf $(if $(filter m0plus,$(1)),$(tables)-clock.elf))))

# ------------------------------------------------------------------------------------------------------------- the runs

ATLAS_TARGETS := $(shell awk '!/^\#/ && NF { print $$1 }' tools/atlas/targets.txt)
ifneq ($(findstring atlas,$(MAKECMDGOALS)),)
ATLAS_PRESENT := $(shell for target in $(filter-out host,$(ATLAS_TARGETS)); do \
	tools/cost/run.sh probe $$target 2>/dev/null && echo $$target; done) host
endif
atlas_kind = $(if $(filter %+float,$(1)),float,$(if $(filter m0plus-cycles,$(1)),clock,$(if $(filter avr m4f,$(call cost_processor,$(1))),cost,$(ATLAS_KIND))))

.PHONY: atlas
atlas: ## What accuracy costs in time, on every target, as a page: build/atlas/index.html. Installs what is missing; QUICK=1
	@tools/install-packages.sh atlas || echo "Going on with what is there."
	@+$(SUBMAKE) run-atlas

.PHONY: run-atlas
run-atlas: $(ATLAS)/index.html ## The same with what is installed
	@echo "Written: $<, and what it shows as $(ATLAS)/*.csv"

.PHONY: run-atlas-frames
run-atlas-frames: $(ATLAS)/frames.csv

.PHONY: atlas-snapshot
atlas-snapshot: ## Commit what the last `make atlas` made: docs/atlas, and what it teaches in README.md
	@test -f $(ATLAS)/index.html || { echo "make atlas-snapshot: make atlas first" >&2; exit 1; }
	@tools/atlas/run.sh snapshot $(ATLAS) docs/atlas

.PHONY: atlas-check
atlas-check: $(ATLAS_SCENES:%=$(ATLAS)/programs/%/judge) ## docs/atlas is well formed, its errors those of frames drawn now
	@tools/atlas/run.sh check $(ATLAS) docs/atlas $(ATLAS_SCENES)

# For a scene of one's own: the tree and the build folder are the script's.
$(B)/glint-atlas: tools/atlas/glint-atlas.sh
	@mkdir -p $(@D)
	$(call run,MAKE)sed -e 's|@TREE@|$(CURDIR)|; s|@BUILD@|$(B)|' $< >$@.part && chmod +x $@.part && mv $@.part $@
tools: $(B)/glint-atlas

# Built by one make a processor, since all programs share its objects.
.PHONY: $(COST_PROCESSORS:%=atlas-build-%)
$(COST_PROCESSORS:%=atlas-build-%): atlas-build-%:
	@+! command -v $($*_CC) >/dev/null || $(SUBMAKE) -s COST=$* B=$(B)/cost/$* PNG=no ASSIMP=no \
		CC=$($*_CC) AR=$(patsubst %gcc,%ar,$($*_CC)) CFLAGS="$(call cost_flags,$*) -g $(strip $($*_FLAGS))" \
		$(addprefix $(B)/cost/$*/,$(call atlas_programs,$*))

define atlas_built # processor
$(addprefix $(B)/cost/$(1)/,$(call atlas_programs,$(1))): atlas-build-$(1)
	@:
endef
ifndef COST
$(foreach processor,$(COST_PROCESSORS),$(eval $(call atlas_built,$(processor))))
endif

define atlas_frames # scene, target
$(ATLAS)/frames/$(1)/$(2).txt: $(B)/cost/$(call cost_processor,$(2:+float=))/atlas/$(1)/$(call atlas_kind,$(2)).elf \
		$(if $(filter m0plus-cycles,$(2)),$(COST_NODE)/node_modules/rp2040js)
	@tools/atlas/run.sh frames $(B) $(2:+float=) $$< $$@
ATLAS_REPORTS_$(1) += $(ATLAS)/frames/$(1)/$(2).txt
endef
ATLAS_COUNTING := $(filter-out host,$(ATLAS_PRESENT)) $(if $(QUICK),,$(patsubst %,%+float,$(filter avr-cycles,$(ATLAS_PRESENT))))
$(foreach target,$(ATLAS_COUNTING),$(foreach scene,$(call atlas_on,$(call cost_processor,$(target:+float=))),$(eval \
	$(call atlas_frames,$(scene),$(target)))))
ATLAS_COUNTED := $(foreach scene,$(ATLAS_SCENES),$(ATLAS_REPORTS_$(scene)))

# Routines: with the library's tables and with small ones, src/number compiled anew for each.
define atlas_routines # target, tables
$(ATLAS)/routines/$(1)-$(2).txt: $(B)/cost/$(call cost_processor,$(1))/atlas/routines/$(2)$(if $(filter m0plus-cycles,$(1)),-clock).elf \
		$(if $(filter m0plus-cycles,$(1)),$(COST_NODE)/node_modules/rp2040js)
	@tools/atlas/run.sh frames $(B) $(1) $$< $$@
ATLAS_ROUTINES += $(ATLAS)/routines/$(1)-$(2).txt
endef
$(foreach target,$(filter-out host,$(ATLAS_PRESENT)),$(foreach tables,full small,$(eval $(call atlas_routines,$(target),$(tables)))))

ROUTINE_SOURCES := $(wildcard src/number/*.c) tools/atlas/variants.c $(SELFTEST)/selftest_report.c
ROUTINE_TABLES_small := -DGLINT_SMALL_TABLES=1
$(ATLAS)/programs/judge-routines-%: tools/atlas/judge_routines.c tools/atlas/routines.h $(ROUTINE_SOURCES) $(HOST_STAMPS)
	@mkdir -p $(@D)
	$(call run,LINK)$(CC) $(HOST_FLAGS) $(ROUTINE_TABLES_$*) -o $@ $(filter %.c,$^) $(SELFTEST)/platform_stdio.c -lm

$(ATLAS)/routines.csv: $(ATLAS)/programs/judge-routines-full $(ATLAS)/programs/judge-routines-small $(ATLAS_ROUTINES)
	@tools/atlas/run.sh routines $(ATLAS) $(filter-out host,$(ATLAS_PRESENT))

# Where a frame goes: profiles of the RP2040's emulator.
define atlas_stages # scene
$(ATLAS)/stages/$(1).csv: $(B)/cost/m0plus/atlas/$(1)/clock.elf tools/cost/stages.txt $(COST_NODE)/node_modules/rp2040js
	@tools/atlas/run.sh stages $(B) $(1) $$@ $$< tools/cost/stages.txt
endef
$(foreach scene,$(ATLAS_SHOWN),$(eval $(call atlas_stages,$(scene))))
ATLAS_STAGES := $(if $(filter m0plus-cycles,$(ATLAS_PRESENT)),$(ATLAS_SHOWN:%=$(ATLAS)/stages/%.csv))
$(ATLAS)/stages.csv: $(ATLAS_STAGES)
	@{ echo "scene,backend,shading,tolerance,stage,instructions,cycles"; cat /dev/null $(ATLAS_STAGES); } >$@

# The frame, how it was shaded, and how far it and Gouraud shading are off.
$(ATLAS)/pictures/%/done: $(B)/glint-render $(B)/glint-compare $(ATLAS_LIST) tools/atlas/run.sh
	@tools/atlas/run.sh pictures $(B) $(ATLAS) $* $(call atlas_field,$*,2) $(call atlas_field,$*,3)

# Flash of variants and effects, as `make size` and `make effects` tell; not within a quick run.
ATLAS_BUILT_FROM := $(call rwildcard,src include tools/effects,%.c %.h %.inc %.sh %.txt) tools/size-report.sh
$(ATLAS)/size.csv: $(ATLAS_BUILT_FROM)
	@echo "  SIZES of variants"
	@+tools/atlas/run.sh size $(B) $@ $(SUBMAKE) size
$(ATLAS)/effects.csv: $(ATLAS_BUILT_FROM)
	@echo "  EFFECTS"
	@+tools/atlas/run.sh effects $(B) $@ $(SUBMAKE) run-effects
ATLAS_FLASH := $(if $(QUICK),,$(ATLAS)/size.csv $(ATLAS)/effects.csv)

$(ATLAS)/how.csv: FORCE
	@mkdir -p $(@D)
	@tools/atlas/run.sh how $(CC) '$(strip $(CFLAGS))' $(RP2040JS) $(foreach processor,$(COST_PROCESSORS),$(processor) $($(processor)_CC) \
		'$(strip $(call cost_flags,$(processor)) $($(processor)_FLAGS))') >$@.part
	@cmp -s $@.part $@ || cp $@.part $@

ATLAS_TABLES := $(ATLAS)/frames.csv $(ATLAS)/routines.csv $(ATLAS)/stages.csv $(ATLAS_FLASH) $(ATLAS)/how.csv
$(ATLAS)/index.html: $(ATLAS_TABLES) $(ATLAS_SHOWN:%=$(ATLAS)/pictures/%/done) tools/cost/peers.csv $(wildcard tools/atlas/page* tools/atlas/plot*)
	@tools/atlas/page.sh $(ATLAS) $(ATLAS_LIST)

# The host's are timed when all else is done, one after another.
ATLAS_BESIDE := $(if $(ATLAS_OWN),,$(ATLAS_ROUTINES) $(ATLAS_STAGES) $(ATLAS_FLASH))
define atlas_timed # scene
$(ATLAS)/frames/$(1)/host.txt: $(ATLAS)/programs/$(1)/host | $(ATLAS_COUNTED) $(ATLAS_BESIDE) $(ATLAS_TIMED_BEFORE)
	@tools/atlas/run.sh frames $(B) host $$< $$@
ATLAS_REPORTS_$(1) += $(ATLAS)/frames/$(1)/host.txt
ATLAS_TIMED_BEFORE := $(ATLAS)/frames/$(1)/host.txt
endef

ATLAS_HOST_OBJECTS := $(call objects,tools/cost/frames.c $(addprefix $(SELFTEST)/,selftest_report.c platform_stdio.c))
$(ATLAS)/programs/%/judge: tools/atlas/cases.c $(call objects,tools/cost/judge.c) $(ATLAS_HOST_OBJECTS) $(HOST_ARCHIVES) $(ATLAS_LIST) $(ATLAS_OWN_SOURCE)
	@mkdir -p $(@D)
	$(call run,LINK)$(CC) $(HOST_FLAGS) $(LDFLAGS) -o $@ $(call atlas_cases,$*) $(filter %.o,$^) $(HOST_ARCHIVES) -lm
$(ATLAS)/programs/%/host: tools/atlas/cases.c $(call objects,tools/atlas/host.c) $(ATLAS_HOST_OBJECTS) $(HOST_ARCHIVES) $(ATLAS_LIST) $(ATLAS_OWN_SOURCE)
	@mkdir -p $(@D)
	$(call run,LINK)$(CC) $(HOST_FLAGS) $(LDFLAGS) -o $@ $(call atlas_cases,$*) $(filter %.o,$^) $(HOST_ARCHIVES)

.SECONDARY: $(call objects,tools/atlas/host.c)

define atlas_judged # scene
$(ATLAS)/frames/$(1)/frames.csv: $(ATLAS)/programs/$(1)/judge $$(ATLAS_REPORTS_$(1))
	@tools/atlas/run.sh judge $$< $$@ $$(filter %.txt,$$^)
endef

$(foreach scene,$(ATLAS_SCENES),$(eval $(call atlas_timed,$(scene)))$(eval $(call atlas_judged,$(scene))))
ATLAS_JUDGED := $(ATLAS_SCENES:%=$(ATLAS)/frames/%/frames.csv)

$(ATLAS)/frames.csv: $(ATLAS_JUDGED) tools/atlas/frames.awk tools/atlas/targets.txt $(ATLAS)/missing.txt
	@tools/atlas/run.sh merge $(ATLAS) $(ATLAS_SCENES)

# What is not there, and its package.
$(ATLAS)/missing.txt: FORCE
	@mkdir -p $(@D)
	@for target in $(filter-out host,$(ATLAS_TARGETS)); do tools/cost/run.sh probe $$target; done 2>$@.part || true
	@cat $@.part >&2; cmp -s $@.part $@ || cp $@.part $@

-include $(patsubst %.o,%.d,$(call objects,$(wildcard tools/atlas/*.c)))

# Within a flavour of cost.mk.
ifdef COST
ATLAS_SCENE_PROGRAMS := $(foreach scene,$(call atlas_on,$(COST)),$(ATLAS_KINDS_$(COST):%=$(B)/atlas/$(scene)/%.elf))
$(ATLAS_SCENE_PROGRAMS): $(B)/atlas/%.elf: $(COST_PREREQUISITES) tools/atlas/cases.c $(ATLAS_LIST) $(ATLAS_OWN_SOURCE)
	@mkdir -p $(@D)
	$(call run,LINK)$(call cost_link,$(basename $(@F)),$(call atlas_cases,$(notdir $(@D)))) 2>$@.left || \
		{ grep -q 'will not fit in region\|overflowed by' $@.left || { cat $@.left >&2; exit 1; }; \
		echo "$(COST): the program of $(notdir $(@D)) does not fit its flash: its frames are left out" >&2; : >$@; }
ifeq ($(COST),avr)
$(filter %/float.elf,$(ATLAS_SCENE_PROGRAMS)): COST_LINKED := $(call objects,$(filter-out tools/cost/cases.c tools/cost/frames.c,$(COST_FIRMWARE))) \
	tools/cost/frames.c tools/atlas/small_float.c
endif

# Optimised for speed on the AVR too, where they alone fit.
ROUTINE_FLAGS_avr := -O2 -finline -mno-call-prologues
ROUTINE_PROGRAMS := $(filter $(B)/atlas/routines/%,$(addprefix $(B)/,$(call atlas_programs,$(COST))))
routine_link = $(CC) $(LIBRARY_FLAGS) -I. -Wl,--gc-sections -DPLATFORM_MPS2 $(ROUTINE_FLAGS_$(COST)) $(ROUTINE_TABLES_$(1)) \
	-o $@ $(call COST_LINK,cost) $(ROUTINE_SOURCES) tools/atlas/routines.c tools/cost/calibrate.c \
	$(if $(2),$(COST_PLATFORM_$(2)),$(COST_PLATFORM_cost)) $(filter $(STARTUP)/%,$($(COST)_GLUE)) -lm $($(COST)_LIBS)
$(ROUTINE_PROGRAMS): $(ROUTINE_SOURCES) tools/atlas/routines.c tools/atlas/routines.h $(LIBRARY_STAMPS)
	@mkdir -p $(@D)
	$(call run,LINK)$(call routine_link,$(firstword $(subst -, ,$(basename $(@F)))),$(word 2,$(subst -, ,$(basename $(@F)))))
ifeq ($(COST),rv32imac)
$(ROUTINE_PROGRAMS): $(B)/riscv.ld
$(ATLAS_SCENE_PROGRAMS): $(B)/riscv.ld
endif
endif
