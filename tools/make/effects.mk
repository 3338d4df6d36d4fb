# SPDX-License-Identifier: MIT
#
# What each effect adds where it is linked and where it is used: `make effects`. Firmware with and without the part of
# an effect, for two processors: as small as it gets (-Os, exact shading alone), and as fast (-O2, with tolerances).

EFFECTS := tools/effects/effects.txt
effect_rows := $(shell awk '!/^\#/ && NF { print $$1 ":" $$2 }' $(EFFECTS))
EFFECT_NAMES := $(foreach row,$(effect_rows),$(firstword $(subst :, ,$(row))))
$(foreach row,$(effect_rows),$(eval EFFECT_PART_$(firstword $(subst :, ,$(row))) := GLINT_PART_$(lastword $(subst :, ,$(row)))))

EFFECT_TARGETS := m0plus m4f
EFFECT_LEVELS := Os O2
EFFECT_FLAVOURS := $(foreach target,$(EFFECT_TARGETS),$(EFFECT_LEVELS:%=$(target)-%))
EFFECT_IN_FLOAT_m0plus := 0
EFFECT_IN_FLOAT_m4f := 1

# What an effect is added to, or for one of these, taken from.
EFFECT_BASE_Os := GLINT_PART_SPECULAR GLINT_PART_POINTS GLINT_PART_SPANS GLINT_PART_LISTS
EFFECT_BASE_O2 := $(EFFECT_BASE_Os) GLINT_PART_TIERS

TARGET_SOURCES += $(sort $(wildcard tools/effects/*.c))
# For the analysers, one of them.
$(patsubst %,tidy/tools/effects/%.c,parts program): HOST_FLAGS += -DEFFECT=GLINT_PART_FOG -DEFFECT_IN_FLOAT=0 \
	-DGLINT_PARTS=GLINT_PART_FOG

.PHONY: effects
effects: ## What each effect adds to flash, memory and frames on emulated processors, linked or not; installs what is missing
	@tools/install-packages.sh targets
	@+$(SUBMAKE) run-effects

.PHONY: run-effects
run-effects: $(EFFECT_FLAVOURS:%=effects-%) $(B)/effect-errors ## Count with what is installed
	@tools/effects/run.sh $(B)

.PHONY: $(EFFECT_FLAVOURS:%=effects-%)
$(EFFECT_FLAVOURS:%=effects-%): effects-%: library
	@+$(SUBMAKE) -s EFFECTS_OF=$* B=$(B)/effects/$* PNG=no ASSIMP=no CC=$($(call size_target,$*)_CC) \
		AR=$(patsubst %gcc,%ar,$($(call size_target,$*)_CC)) \
		CFLAGS="-$(lastword $(subst -, ,$*)) $(strip $($(call size_target,$*)_FLAGS))" effect-programs

$(B)/effect-errors: $(B)/obj/tools/effects/errors.o $(HOST_ARCHIVES)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

.PHONY: effects-page
effects-page: ## Refresh the table of docs/effects.md from the last `make effects`
	@test -f $(B)/effects/effects.csv || { echo "make effects-page: make effects first" >&2; exit 1; }
	@awk -f tools/effects/page.awk $(B)/effects/effects.csv > $(B)/effects/page
	@tools/replace-marked.sh docs/effects.md effects-table $(B)/effects/page

# Within a flavour.
ifdef EFFECTS_OF
EFFECT_TARGET := $(firstword $(subst -, ,$(EFFECTS_OF)))
EFFECT_BASE := $(EFFECT_BASE_$(lastword $(subst -, ,$(EFFECTS_OF))))
EFFECT_SETTINGS := -DEFFECT_IN_FLOAT=$(EFFECT_IN_FLOAT_$(EFFECT_TARGET))

# Sets of parts: base; with-NAME; for what is in the base, without-NAME.
effect_is_base = $(filter $(EFFECT_PART_$(1)),$(EFFECT_BASE))
effect_set_with = $(if $(call effect_is_base,$(1)),base,with-$(1))
effect_set_without = $(if $(call effect_is_base,$(1)),without-$(1),base)
effect_name = $(patsubst without-%,%,$(patsubst with-%,%,$(1)))
effect_parts = $(if $(filter without-%,$(1)),$(filter-out $(EFFECT_PART_$(call effect_name,$(1))),$(EFFECT_BASE)),$(strip \
	$(EFFECT_BASE) $(if $(filter with-%,$(1)),$(EFFECT_PART_$(call effect_name,$(1))))))
sum_of = $(subst $() $(),|,$(strip $(call effect_parts,$(1))))
EFFECT_START := $(call objects,$(SELFTEST)/selftest_report.c $(STARTUP)/cortex_m_startup.c tools/cost/calibrate.c)

.PHONY: effect-programs
effect-programs: $(foreach name,$(EFFECT_NAMES),$(B)/$(name)-with.elf $(B)/$(name)-without.elf)

.PRECIOUS: $(B)/parts/%.o
$(B)/parts/%.o: tools/effects/parts.c $(PARTS_HEADERS) $(LIBRARY_STAMPS)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(LIBRARY_FLAGS) -I$(B)/include $(EFFECT_SETTINGS) '-DGLINT_PARTS=($(call sum_of,$*))' -c $< -o $@

define effect_program # name, with|without, set of parts
$(B)/$(1)-$(2).elf: tools/effects/program.c $(B)/parts/$(3).o $(EFFECT_START) $(SELFTEST)/platform_arm.c $(SCENES) $(LIBRARY)
	$$(call run,LINK)$$(CC) $$(LIBRARY_FLAGS) -I. -DPLATFORM_MPS2 $$(EFFECT_SETTINGS) -DEFFECT=$$(EFFECT_PART_$(1)) \
		'-DGLINT_PARTS=($(call sum_of,$(3)))' -Wl,--gc-sections $$(m3_SCRIPT) \
		-Wl,--defsym=link_flash_bytes=512K,--defsym=link_ram_bytes=1M -o $$@ tools/effects/program.c \
		$(SELFTEST)/platform_arm.c $(B)/parts/$(3).o $$(EFFECT_START) $$(SCENES) $$(LIBRARY) $$(m3_LIBS)
endef
$(foreach name,$(EFFECT_NAMES),$(eval $(call effect_program,$(name),with,$(call effect_set_with,$(name)))))
$(foreach name,$(EFFECT_NAMES),$(eval $(call effect_program,$(name),without,$(call effect_set_without,$(name)))))
endif
