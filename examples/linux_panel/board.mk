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
board-build-linux_panel: linux-panel-arm64 linux-panel-tests $(B)/pl061-events $(B)/glint-panel-decode $(B)/glint-render

# ----------------------------------------------------------------------------------------------------------- the tests

# A board of fakes stands behind libgpiod and behind the system's calls: the linker puts it there.
GPIOD1_WRAPPED := chip_num_lines chip_get_line chip_find_line line_update line_consumer line_request line_set_value \
	line_event_get_fd line_event_read line_release
GPIOD2_WRAPPED := chip_get_info chip_info_free chip_info_get_num_lines chip_get_line_offset_from_name chip_get_line_info \
	line_info_get_consumer line_info_free line_settings_new line_settings_free line_settings_set_direction \
	line_settings_set_edge_detection line_settings_set_bias line_settings_set_active_low \
	line_settings_set_output_value line_config_new line_config_free line_config_add_line_settings \
	request_config_new request_config_free request_config_set_consumer chip_request_lines line_request_release \
	line_request_set_value line_request_get_fd edge_event_buffer_new edge_event_buffer_free \
	line_request_read_edge_events edge_event_buffer_get_event edge_event_get_event_type edge_event_get_timestamp_ns
SYSTEM_WRAPPED := open close ioctl fopen stat getgrgid glob globfree clock_gettime clock_nanosleep ppoll pthread_create \
	calloc malloc
wrap_all = $(patsubst %,-Wl$(comma)--wrap=%,$(SYSTEM_WRAPPED) $(patsubst %,gpiod_%,chip_open chip_close $(GPIOD$(1)_WRAPPED)))
comma := ,

LINUX_PANEL_FAKES := $(addprefix $(LINUX_PANEL_TESTS)/,fake_board.c fake_system.c expected.c)
LINUX_PANEL_TEST_SOURCES := $(addprefix $(LINUX_PANEL_TESTS)/,test_gpio.c test_parts.c test_program.c test_spi.c)
LINUX_PANEL_GPIOD_TESTS := $(foreach version,1 2,$(patsubst %.c,$(B)/%-gpiod$(version),$(LINUX_PANEL_TEST_SOURCES)))

$(LINUX_PANEL_GPIOD_TESTS): $(call objects,$(LINUX_PANEL_SOURCES) $(LINUX_PANEL_FAKES)) $(HOST_ARCHIVES)
	@mkdir -p $(@D)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.o,$^) $(HOST_ARCHIVES) \
		$(call wrap_all,$(patsubst %-gpiod1,1,$(patsubst %-gpiod2,2,$(notdir $@)))) $(TEST_LIBS) $(LINUX_PANEL_LIBS)
define linux_panel_tests # version of libgpiod
$(filter %-gpiod$(1),$(LINUX_PANEL_GPIOD_TESTS)): $(B)/%-gpiod$(1): $(B)/obj/%.o \
	$(call gpiod_objects,$(1),$(addprefix $(LINUX_PANEL_TESTS)/,fake_gpiod.c fake_gpiod_v$(1).c))
endef
$(eval $(call linux_panel_tests,1))
$(eval $(call linux_panel_tests,2))

.PHONY: linux-panel-tests test-linux-panel
linux-panel-tests: $(LINUX_PANEL_GPIOD_TESTS)
test-linux-panel: linux-panel-tests ## Tests of glint-panel's parts and of the whole program, on a board of fakes
	@tools/check-tests.sh $(JOBS) $(LINUX_PANEL_GPIOD_TESTS)

# --------------------------------------------------------------------------------------------------------------- checks

LINUX_PANEL_ALL := $(LINUX_PANEL_MAIN) $(LINUX_PANEL_SOURCES) $(GPIO_SOURCES) \
	$(sort $(wildcard $(LINUX_PANEL_TESTS)/*.c $(LINUX_PANEL_EMULATED)/*.c))
TARGET_SOURCES += $(filter examples/linux_panel/% tests/linux_panel/% examples/panels/ili9341.c,$(LINUX_PANEL_ALL))
tidy/$(LINUX_PANEL)/gpio_v2.c tidy/$(LINUX_PANEL_TESTS)/fake_gpiod_v2.c: HOST_FLAGS += $(GPIOD2_FLAGS)
tidy/$(LINUX_PANEL)/gpio_v2.c tidy/$(LINUX_PANEL_TESTS)/fake_gpiod_v2.c: | $(GPIOD2_HEADER)

-include $(patsubst %.o,%.d,$(call objects,$(LINUX_PANEL_MAIN) $(LINUX_PANEL_SOURCES) $(LINUX_PANEL_FAKES) \
	$(LINUX_PANEL_TEST_SOURCES)) $(call gpiod_objects,1) $(call gpiod_objects,2))
