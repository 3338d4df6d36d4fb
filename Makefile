# SPDX-License-Identifier: MIT
#
# Builds Glint. `make help` lists the targets. GNU make 4.3 or later; nothing is written outside $(B).
#
# One set of rules builds every flavour (host, sanitizers, each target processor): a flavour is this same Makefile called
# again with another build directory B, compiler and flags. The fragments in tools/make/ hold the checks.

.DEFAULT_GOAL := library
.DELETE_ON_ERROR:
.SUFFIXES:

B ?= build
PREFIX ?= /usr/local
CFLAGS ?= -O2 -g
JOBS ?= $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)

VERSION := $(shell awk '/define GLINT_VERSION_/ { v = v sep $$3; sep = "." } END { print v }' include/glint/config.h)

# What runs is told in a word a file; make V=1 shows the commands.
run = $(if $(V),,@echo "  $(1)  $@";)

# ---------------------------------------------------------------------------------------------------------------- flags

STRICT := -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Wdouble-promotion -Werror -ffp-contract=off

# Optional libraries of the host tools: yes or no, found by pkg-config unless given.
has = $(if $(shell pkg-config --exists $(1) 2>/dev/null && echo yes),yes,no)
PNG ?= $(call has,libpng)
ASSIMP ?= $(call has,assimp)

ifeq ($(PNG),yes)
OPTIONAL_FLAGS += -DGLINT_HAVE_PNG $(shell pkg-config --cflags libpng)
OPTIONAL_LIBS += $(shell pkg-config --libs libpng)
endif
ifeq ($(ASSIMP),yes)
OPTIONAL_FLAGS += -DGLINT_HAVE_ASSIMP $(shell pkg-config --cflags assimp)
OPTIONAL_LIBS += $(shell pkg-config --libs assimp)
endif

# The library sees only the freestanding part of C and its own folders; sections let the linker drop what is not called.
LIBRARY_FLAGS = $(STRICT) -ffreestanding -ffunction-sections -fdata-sections -Iinclude -Isrc $(CFLAGS)
HOST_INCLUDES := -Iinclude -Isrc -I. -I$(B)/include
HOST_FLAGS = $(STRICT) -D_POSIX_C_SOURCE=200809L $(HOST_INCLUDES) $(OPTIONAL_FLAGS) $(CFLAGS)
TEST_LIBS = $(shell pkg-config --libs cmocka libcjson 2>/dev/null || echo -lcmocka -lcjson) -pthread

# -------------------------------------------------------------------------------------------------------------- sources

# Source files are found, not listed. Bodies that a file includes end in .inc and are never compiled alone.
rwildcard = $(foreach entry,$(wildcard $(1)/*),$(call rwildcard,$(entry),$(2)) $(filter $(2),$(entry)))

LIBRARY_SOURCES := $(sort $(call rwildcard,src,%.c))
SCENE_SOURCES := $(sort $(wildcard examples/meshes/*.c examples/textures/*.c examples/scenes/*.c))
HOST_SOURCES := $(sort $(wildcard tests/reference/*.c tests/panel/*.c tools/picture/*.c tools/import/*.c))
RENDER_SOURCES := $(sort $(wildcard examples/render/*.c))
OBSERVED_SOURCES := src/backend/fixed.c src/backend/float.c
TOOL_SOURCES := $(sort $(wildcard tools/*.c))
MESH_TOOL_SOURCES := $(sort $(wildcard tools/mesh/*.c))
TEST_SOURCES := $(sort $(wildcard tests/unit/test_*.c tests/image/test_*.c tests/hard/test_*.c \
	tests/metamorphic/test_*.c tests/fuzz/test_*.c))

objects = $(patsubst %.c,$(B)/obj/%.o,$(1))
TOOLS := $(patsubst tools/%.c,$(B)/%,$(TOOL_SOURCES))
TESTS := $(patsubst %.c,$(B)/%,$(TEST_SOURCES))

MESH_GENERATOR := $(B)/generate-mesh
LIBRARY := $(B)/libglint.a
SCENES := $(B)/libscenes.a
HOST := $(B)/libhost.a
# For a choice of parts of a program's own, see include/glint/parts.h: a backend's bodies in one header.
PARTS_HEADERS := $(patsubst %,$(B)/include/glint/%_parts.h,fixed float)
HOST_ARCHIVES := $(HOST) $(SCENES) $(LIBRARY)

# --------------------------------------------------------------------------------------------------------------- targets

.PHONY: library
library: $(LIBRARY) $(PARTS_HEADERS) ## Build the library, build/libglint.a (the default)

.PHONY: tools
tools: $(B)/glint-render $(TOOLS) $(MESH_GENERATOR) ## Build the renderer and the host tools

# Plain sh: the demo needs nothing but a C compiler. PNG copies only where the renderer can write them.
.PHONY: demo
demo: $(B)/glint-render $(B)/contact-sheet ## Draw every built-in scene and a contact sheet into build/demo; only a C compiler is needed
	@rm -rf $(B)/demo && mkdir -p $(B)/demo
	@set -e; for ending in ppm $(if $(filter yes,$(PNG)),png); do \
		pictures=; \
		for scene in $$($(B)/glint-render --list | awk '{ print $$1 }'); do \
			$(B)/glint-render $$scene -o $(B)/demo/$$scene.$$ending; \
			pictures="$$pictures $(B)/demo/$$scene.$$ending"; \
		done; \
		$(B)/contact-sheet -o $(B)/demo/contact-sheet.$$ending $$pictures; \
		echo "Wrote $$(echo $$pictures | wc -w) pictures to $(B)/demo/*.$$ending"; \
		echo "Look first at $(B)/demo/contact-sheet.$$ending"; \
	done

.PHONY: figures
figures: $(B)/glint-render $(B)/contact-sheet ## Draw the figures of docs/figures.md into build/figures; FIGURE=name draws one
	@$(if $(FIGURE),,rm -rf $(B)/figures)
	@set -e; for ending in ppm $(if $(filter yes,$(PNG)),png); do \
		tools/figures.sh draw $(B) $$ending $(FIGURE); \
		echo "Wrote $$(ls $(B)/figures/*.$$ending | wc -l) figures, $(B)/figures/*.$$ending"; \
	done

.PHONY: install
install: library ## Install headers, library and glint.pc under PREFIX (default /usr/local; DESTDIR is honoured)
	install -d $(DESTDIR)$(PREFIX)/include/glint $(DESTDIR)$(PREFIX)/lib/pkgconfig
	install -m 644 include/glint/*.h $(PARTS_HEADERS) $(DESTDIR)$(PREFIX)/include/glint
	install -m 644 $(LIBRARY) $(DESTDIR)$(PREFIX)/lib
	sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@VERSION@|$(VERSION)|' glint.pc.in > $(B)/glint.pc
	install -m 644 $(B)/glint.pc $(DESTDIR)$(PREFIX)/lib/pkgconfig

.PHONY: clean
clean: ## Remove the build directory
	rm -rf $(B)

.PHONY: help
help: ## List the targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-18s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

# ----------------------------------------------------------------------------------------------------------------- rules

# Objects depend on the makefiles and on the flags themselves, so that a package installed later is taken up at once.
BUILD_FILES := Makefile $(wildcard tools/make/*.mk)
LIBRARY_STAMPS := $(BUILD_FILES) $(B)/library-flags
HOST_STAMPS := $(BUILD_FILES) $(B)/host-flags

define stamp # name, text: a file that changes only when the text does
$(B)/$(1): FORCE
	@mkdir -p $$(@D)
	@printf '%s\n' '$(2)' | cmp -s - $$@ || printf '%s\n' '$(2)' > $$@
endef
$(eval $(call stamp,library-flags,$(CC) $(LIBRARY_FLAGS)))
$(eval $(call stamp,host-flags,$(CC) $(HOST_FLAGS)))
$(eval $(call stamp,sources,$(LIBRARY_SOURCES) $(SCENE_SOURCES) $(HOST_SOURCES)))

.PHONY: FORCE
FORCE:

$(B)/obj/src/%.o: src/%.c $(LIBRARY_STAMPS)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(LIBRARY_FLAGS) -MMD -MP -c $< -o $@

# Scenes and meshes are what firmware links, so they are compiled as the library is.
$(B)/obj/examples/meshes/%.o: examples/meshes/%.c $(LIBRARY_STAMPS)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(LIBRARY_FLAGS) -I. -MMD -MP -c $< -o $@

$(B)/obj/examples/textures/%.o: examples/textures/%.c $(LIBRARY_STAMPS)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(LIBRARY_FLAGS) -I. -MMD -MP -c $< -o $@

$(B)/obj/examples/scenes/%.o: examples/scenes/%.c $(LIBRARY_STAMPS)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(LIBRARY_FLAGS) -I. -MMD -MP -c $< -o $@

$(B)/obj/%.o: %.c $(HOST_STAMPS)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(HOST_FLAGS) -MMD -MP -c $< -o $@

define archive # file, sources
$(1): $(call objects,$(2)) $(B)/sources
	@rm -f $$@
	$$(call run,AR  )$(AR) rcs $$@ $(call objects,$(2))
endef
$(eval $(call archive,$(LIBRARY),$(LIBRARY_SOURCES)))
$(eval $(call archive,$(SCENES),$(SCENE_SOURCES)))
$(eval $(call archive,$(HOST),$(HOST_SOURCES)))

$(PARTS_HEADERS): $(B)/include/glint/%_parts.h: tools/parts-header.awk $(call rwildcard,src,%.h %.inc) $(BUILD_FILES)
	@mkdir -p $(@D)
	$(call run,MAKE)awk -v backend=$* -f tools/parts-header.awk >$@

# The renderer holds a second copy of the backends, which tells of each pixel: see examples/render/observed_backend.h.
# The library's own is what is counted as covered.
OBSERVED := $(patsubst src/backend/%.c,$(B)/obj/observed/%.o,$(OBSERVED_SOURCES))
$(OBSERVED): $(B)/obj/observed/%.o: src/backend/%.c $(LIBRARY_STAMPS)
	@mkdir -p $(@D)
	$(call run,CC  )$(CC) $(filter-out --coverage -fprofile-%,$(LIBRARY_FLAGS)) \
		-include examples/render/observed_backend.h -MMD -MP -c $< -o $@

$(B)/glint-render: $(call objects,$(RENDER_SOURCES)) $(OBSERVED) $(HOST_ARCHIVES)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(OPTIONAL_LIBS) -lm

$(TOOLS): $(B)/%: $(B)/obj/tools/%.o $(HOST_ARCHIVES)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(OPTIONAL_LIBS) -lm

# Of the tools it alone stands apart: it makes the meshes that the others are linked with.
$(MESH_GENERATOR): $(call objects,$(MESH_TOOL_SOURCES))
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

$(TESTS): $(B)/%: $(B)/obj/%.o $(HOST_ARCHIVES)
	@mkdir -p $(@D)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(TEST_LIBS) $(OPTIONAL_LIBS) -lm

ALL_SOURCES := $(LIBRARY_SOURCES) $(SCENE_SOURCES) $(HOST_SOURCES) $(RENDER_SOURCES) $(TOOL_SOURCES) \
	$(MESH_TOOL_SOURCES) $(TEST_SOURCES)
-include $(patsubst %.o,%.d,$(call objects,$(ALL_SOURCES)) $(OBSERVED))

include tools/make/test.mk
include tools/make/target.mk
include tools/make/emulate.mk
include tools/make/cost.mk
include tools/make/effects.mk
include tools/make/boards.mk
include tools/make/atlas.mk
include tools/make/fuzz.mk
include tools/make/proofs.mk
include tools/make/verify.mk
