# SPDX-License-Identifier: MIT
#
# The examples for real boards, each run on an emulated one whose panel is compared with what the host draws:
# `make boards`. A board is a folder examples/NAME with
#
#     board.mk   names the board to this file (BOARDS += NAME) and has a target board-build-NAME, which builds what
#                run.sh needs into $(B)/boards/NAME
#     parts.c    the parts of the library that it links, see include/glint/parts.h
#     run.sh     examples/NAME/run.sh BUILD runs it. Leaves in BUILD/boards/NAME a report.txt with lines "name value", the
#                names being those of tools/boards/table.sh, and for each picture taken from the emulated panel
#                TITLE.panel.ppm with its twin drawn on the host, TITLE.host.ppm. Ends with another status than 0 if it
#                could not do so, and names the package of an emulator that is missing.

BOARDS :=
TARGET_SOURCES += $(wildcard tools/boards/*.c)

# A flavour of this Makefile for a board's processor: board, processor of target.mk or emulate.mk, its flags, targets.
board_make = $(SUBMAKE) -s BOARD=$(1) B=$(B)/boards/$(1) CC=$($(2)_CC) AR=$(patsubst %gcc,%ar,$($(2)_CC)) \
	CFLAGS="$(strip $(3) $($(2)_FLAGS))" PNG=no ASSIMP=no $(4)

# Firmware is compiled as the library is.
ifdef BOARD
$(B)/obj/examples/$(BOARD)/%.o: examples/$(BOARD)/%.c $(LIBRARY_STAMPS) | $(PARTS_HEADERS)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(LIBRARY_FLAGS) -I. -I$(B)/include -MMD -MP -c $< -o $@
$(B)/obj/examples/panels/%.o: examples/panels/%.c $(LIBRARY_STAMPS)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(LIBRARY_FLAGS) -I. -MMD -MP -c $< -o $@
$(B)/obj/examples/firmware/%.o: examples/firmware/%.c $(LIBRARY_STAMPS)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(LIBRARY_FLAGS) -I. -MMD -MP -c $< -o $@
endif

include $(sort $(wildcard examples/*/board.mk))

# What they depend on, of the boards' flavours and of the host's.
-include $(wildcard $(B)/obj/examples/*/*.d)

.PHONY: boards
boards: ## The example boards on emulated hardware: pictures equal to the host's? Frames a second, flash, RAM, stack
	@tools/install-packages.sh boards
	@+$(SUBMAKE) run-boards

.PHONY: run-boards
run-boards: $(BOARDS:%=board-%) ## Run them with what is installed
	@tools/boards/table.sh $(B) $(BOARDS)

# A board that cannot be built or run leaves no report, so the table tells of it beside the others. What boards share is
# built before, so that two do not build it at once.
.PHONY: $(BOARDS:%=board-%) $(BOARDS:%=board-build-%)
$(BOARDS:%=board-%): board-%: | $(HOST_ARCHIVES)
	@rm -f $(B)/boards/$*/report.txt $(B)/boards/$*/*.ppm
	@+{ $(SUBMAKE) board-build-$* && echo "  RUN   $*" && examples/$*/run.sh $(B); } || echo "$*: FAILED" >&2

# What a board's panel has to show: its picture.c on the host. A board asks for it by naming its picture.c as what it
# depends on.
BOARD_HOST := $(call objects,tools/boards/host_picture.c examples/render/panel.c)
$(BOARDS:%=board-%): | $(BOARD_HOST)
$(B)/boards/%/host-picture: $(B)/obj/examples/%/picture.o $(B)/obj/examples/%/parts.o $(BOARD_HOST) $(HOST_ARCHIVES)
	@mkdir -p $(@D)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.o,$^) $(HOST_ARCHIVES) $(OPTIONAL_LIBS) -lm

$(B)/boards/shrink: $(call objects,tools/boards/shrink.c) $(HOST_ARCHIVES)
	@mkdir -p $(@D)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(OPTIONAL_LIBS) -lm
.SECONDARY: $(foreach board,$(BOARDS),$(B)/obj/examples/$(board)/picture.o $(B)/obj/examples/$(board)/parts.o)
$(BOARDS:%=$(B)/obj/examples/%/parts.o): | $(PARTS_HEADERS)
-include $(patsubst %.o,%.d,$(call objects,tools/boards/host_picture.c tools/boards/shrink.c))

$(B)/tests/unit/test_oled_drivers: $(call objects,examples/panels/ssd0323.c examples/panels/ssd1306.c)
