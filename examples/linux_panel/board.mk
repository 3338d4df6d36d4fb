# SPDX-License-Identifier: MIT
#
# glint-panel for this machine; its tests with libgpiod 1.6 and 2.x; and what its run on an emulated arm64 board takes.
# gpio_v1.c and gpio_v2.c are what differs between the versions of libgpiod.

BOARDS += linux_panel

LINUX_PANEL := examples/linux_panel
LINUX_PANEL_TESTS := tests/linux_panel
LINUX_PANEL_BUILD := $(B)/boards/linux_panel
GPIO_SOURCES := $(addprefix $(LINUX_PANEL)/,gpio_common.c gpio_v1.c gpio_v2.c)
LINUX_PANEL_MAIN := $(LINUX_PANEL)/glint-panel.c
LINUX_PANEL_SOURCES := $(filter-out $(GPIO_SOURCES) $(LINUX_PANEL_MAIN),$(sort $(wildcard $(LINUX_PANEL)/*.c))) \
	examples/panels/st7789.c examples/panels/ili9341.c examples/render/panel.c

# ------------------------------------------------------------------------------------------------------------- libgpiod

# libgpiod 2 is not in all distributions yet: the source package of its Python binding has the library's own source.
# SYSTEM_GPIOD2=yes takes the system's.
GPIOD2_VERSION := 2.2.0
GPIOD2_TREE ?= $(LINUX_PANEL_BUILD)/gpiod-$(GPIOD2_VERSION)
ifdef SYSTEM_GPIOD2
GPIOD2_FLAGS = $(shell pkg-config --cflags libgpiod)
GPIOD2_LIBS = $(shell pkg-config --libs libgpiod)
else
GPIOD2_HEADER := $(GPIOD2_TREE)/include/gpiod.h
GPIOD2_FLAGS := -isystem $(GPIOD2_TREE)/include
GPIOD2_LIBRARY := $(B)/libgpiod2.a
endif

$(GPIOD2_TREE)/include/gpiod.h: $(LINUX_PANEL_TESTS)/gpiod-requirements.txt
	@mkdir -p $(GPIOD2_TREE)
	$(call run,GET )python3 -m pip download --quiet --disable-pip-version-check --no-deps --no-binary gpiod \
		--require-hashes -r $< -d $(GPIOD2_TREE)
	@tar -xzf $(GPIOD2_TREE)/gpiod-$(GPIOD2_VERSION).tar.gz -C $(GPIOD2_TREE) --strip-components=1
	@touch $@

# Of the system, but for the flavour that compiles for the emulated board.
GPIOD1_FLAGS ?= $(shell pkg-config --cflags libgpiod 2>/dev/null)
GPIOD1_LIBS ?= $(or $(shell pkg-config --libs libgpiod 2>/dev/null),-lgpiod)

# As it is compiled by its own package.
$(B)/libgpiod2.a: $(GPIOD2_TREE)/include/gpiod.h $(B)/host-flags
	@rm -rf $(B)/obj/libgpiod2 && mkdir -p $(B)/obj/libgpiod2
	$(call run,CC  )cd $(B)/obj/libgpiod2 && $(CC) -std=gnu89 -O2 -w -D_GNU_SOURCE \
		-DGPIOD_VERSION_STR='"$(GPIOD2_VERSION)"' -I$(abspath $(GPIOD2_TREE))/include -I$(abspath $(GPIOD2_TREE))/lib \
		-c $(abspath $(GPIOD2_TREE))/lib/*.c
	@rm -f $@ && $(AR) rcs $@ $(B)/obj/libgpiod2/*.o

# ---------------------------------------------------------------------------------------------------------- the program

# Objects that see one version's header.
$(B)/obj/gpiod1/%.o: %.c $(HOST_STAMPS)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(HOST_FLAGS) $(GPIOD1_FLAGS) -MMD -MP -c $< -o $@

$(B)/obj/gpiod2/%.o: %.c $(HOST_STAMPS) $(GPIOD2_HEADER)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(HOST_FLAGS) $(GPIOD2_FLAGS) -MMD -MP -c $< -o $@

gpiod_objects = $(patsubst %.c,$(B)/obj/gpiod$(1)/%.o,$(LINUX_PANEL)/gpio_common.c $(LINUX_PANEL)/gpio_v$(1).c $(2))
LINUX_PANEL_LIBS = -Wl,--as-needed $(OPTIONAL_LIBS) -pthread -lm

$(B)/glint-panel-gpiod1 $(B)/glint-panel-gpiod2: $(B)/glint-panel-gpiod%: \
		$(call objects,$(LINUX_PANEL_MAIN) $(LINUX_PANEL_SOURCES)) $(HOST_ARCHIVES)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.o,$^) $(HOST_ARCHIVES) $(GPIOD$*_LIBRARY) $(GPIOD$*_LIBS) \
		$(LINUX_PANEL_LIBS)
$(B)/glint-panel-gpiod1: $(call gpiod_objects,1)
$(B)/glint-panel-gpiod2: $(call gpiod_objects,2) $(GPIOD2_LIBRARY)

# For this machine, with the libgpiod that it has.
GPIOD_MAJOR = $(firstword $(subst ., ,$(shell pkg-config --modversion libgpiod 2>/dev/null)))

.PHONY: glint-panel
glint-panel: ## Build build/glint-panel for this Linux board, with the libgpiod that it has
	@test -n "$(GPIOD_MAJOR)" || \
		{ echo "glint-panel needs libgpiod: sudo apt-get install libgpiod-dev pkg-config" >&2; exit 1; }
	@+$(SUBMAKE) $(if $(filter 2,$(GPIOD_MAJOR)),SYSTEM_GPIOD2=yes) $(B)/glint-panel-gpiod$(GPIOD_MAJOR)
	@cp $(B)/glint-panel-gpiod$(GPIOD_MAJOR) $(B)/glint-panel

# ---------------------------------------------------------------------------------------------------- the emulated board

LINUX_PANEL_EMULATED := $(LINUX_PANEL_TESTS)/emulated
LINUX_PANEL_ARM64 := $(LINUX_PANEL_BUILD)/arm64

# Debian's kernel, libgpiod 1.6 and tools for arm64, unpacked; nothing is installed.
$(LINUX_PANEL_ARM64)/kernel: $(LINUX_PANEL_EMULATED)/packages.sh
	$(call run,GET )$(LINUX_PANEL_EMULATED)/packages.sh $(@D)

$(B)/pl061-events: $(call objects,$(LINUX_PANEL_EMULATED)/pl061-events.c)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^

.PHONY: linux-panel-arm64
linux-panel-arm64: $(LINUX_PANEL_ARM64)/kernel $(GPIOD2_TREE)/include/gpiod.h
	@+$(SUBMAKE) -s B=$(LINUX_PANEL_ARM64) CC=aarch64-linux-gnu-gcc AR=aarch64-linux-gnu-ar CFLAGS=-O2 PNG=no ASSIMP=no \
		GPIOD2_TREE=$(GPIOD2_TREE) GPIOD1_FLAGS="-I$(LINUX_PANEL_ARM64)/root/usr/include" \
		GPIOD1_LIBS="-L$(LINUX_PANEL_ARM64)/root/usr/lib/aarch64-linux-gnu -lgpiod" \
		$(LINUX_PANEL_ARM64)/glint-panel-gpiod1 $(LINUX_PANEL_ARM64)/glint-panel-gpiod2

.PHONY: board-build-linux_panel
board-build-linux_panel: linux-panel-arm64 $(B)/pl061-events $(B)/glint-panel-decode $(B)/glint-render

-include $(patsubst %.o,%.d,$(call objects,$(LINUX_PANEL_MAIN) $(LINUX_PANEL_SOURCES)) $(call gpiod_objects,1) \
	$(call gpiod_objects,2))
