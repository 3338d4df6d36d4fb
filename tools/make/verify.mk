# SPDX-License-Identifier: MIT
#
# What stands beside the tests: sanitizers, the second compiler, static analysis, format, generated files.

VERIFY_STAGES := format-check generated-check cppcheck tidy cross firmware-example size consumer-check lvgl-check hard-cases \
	proofs bit-identical targets effects test-clang test-asan test-small-tables ranges fuzz-short boards

.PHONY: verify
verify: ## Tests under sanitizers and with clang, static analysis, target processors, sizes; installs what is missing
	@tools/install-packages.sh test
	@tools/install-packages.sh verify
	@+failed=; for stage in $(VERIFY_STAGES); do \
		echo "==== $$stage"; start=$$(date +%s); \
		$(SUBMAKE) $$stage && result=passed || { result=FAILED; failed="$$failed $$stage"; }; \
		echo "==== $$stage $$result after $$(($$(date +%s) - start)) s"; \
	done; \
	if [ -n "$$failed" ]; then echo "verify: failed:$$failed"; exit 1; fi; \
	echo "verify: all $(words $(VERIFY_STAGES)) stages passed"

# gcc warns of conversions that only its sanitizers' own rewriting brings in, so those two warnings rest here.
# A sanitizer's report ends the program; float-to-integer overflow is undefined in C but not part of -fsanitize=undefined.
SANITIZE := -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all -fno-omit-frame-pointer \
	-Wno-conversion -Wno-sign-conversion

.PHONY: test-asan
test-asan: ## The tests under AddressSanitizer and UndefinedBehaviorSanitizer (gcc)
	@+$(SUBMAKE) B=$(B)/asan CC=gcc CFLAGS="-O1 -g $(SANITIZE)" run-tests

.PHONY: test-clang
test-clang: ## The tests with clang
	@+$(SUBMAKE) B=$(B)/clang CC=clang run-tests

# Tables and meshes are data: generated, long, and checked against their generators instead.
CHECKED_SOURCES := $(filter-out src/number/tables.c examples/meshes/% examples/textures/%,$(ALL_SOURCES) $(TARGET_SOURCES))
FORMATTED := $(sort $(CHECKED_SOURCES) \
	$(foreach folder,include src tools tests examples,$(call rwildcard,$(folder),%.h %.inc)))

.PHONY: format-check
format-check: ## All C files are as .clang-format wants them
	@clang-format --dry-run -Werror $(FORMATTED)

.PHONY: format
format: ## Format all C files
	clang-format -i $(FORMATTED)

# FOREIGN_SOURCES include headers that only another processor's compiler has; its own warnings watch over them.
TIDY_TARGETS := $(patsubst %,tidy/%,$(filter-out tests/target/% $(FOREIGN_SOURCES),$(CHECKED_SOURCES)))

# In tests: the analyzer does not know that a cmocka assertion which fails does not return, so it follows NULL past it
# (the sanitizers see the real thing); running a program through the shell is what a test of a tool does; whole indices
# like i / 3 stand within floating-point sums; and bytes that must not be written are compared as bytes, padding included.
TIDY_TESTS := -clang-analyzer-core.NullDereference,-clang-analyzer-core.NonNullParamChecker,-cert-env33-c,$(strip \
	-bugprone-integer-division),-bugprone-suspicious-memory-comparison,-cert-exp42-c,-cert-flp37-c

# In variants of a backend: what a part that is left out would read is stored in vain.
TIDY_VARIANTS := -clang-analyzer-deadcode.DeadStores
tidy_checks = $(if $(filter tests/%,$(1)),$(TIDY_TESTS))$(if $(filter src/backend/%_phong.c src/backend/%_diffuse.c,$(1)),$(TIDY_VARIANTS))

.PHONY: tidy $(TIDY_TARGETS)
tidy: $(TIDY_TARGETS) ## clang-tidy over library, tools, examples and tests
$(TIDY_TARGETS): tidy/%: %
	@echo "  TIDY  $<"
	@clang-tidy --quiet $(addprefix --checks=,$(call tidy_checks,$<)) $< -- $(HOST_FLAGS) $(SIMAVR_FLAGS) 2>$(B)/$(subst /,-,$*).tidy \
		|| { cat $(B)/$(subst /,-,$*).tidy; exit 1; }
	@rm -f $(B)/$(subst /,-,$*).tidy
$(TIDY_TARGETS): | $(B)/host-flags $(PARTS_HEADERS)

# ctuuninitvar does not see what a callee sets of a structure whose other members follow after the call.
# missingIncludeSystem is about the system's headers; for want of them cppcheck mistakes the types of printf's
# arguments, which -Wformat of both compilers checks with the true ones.
.PHONY: cppcheck
cppcheck: ## cppcheck over library, tools, examples and tests
	@mkdir -p $(B)/cppcheck
	@cppcheck --quiet --std=c99 --enable=warning,performance,portability --inline-suppr --error-exitcode=1 -j $(JOBS) \
		--cppcheck-build-dir=$(B)/cppcheck --suppress=missingIncludeSystem --suppress=preprocessorErrorDirective \
		--suppress=ctuuninitvar \
		--suppress=invalidPrintfArgType_sint --suppress=invalidPrintfArgType_uint \
		-D__GNUC__ $(HOST_INCLUDES) $(filter-out tests/target/% $(FOREIGN_SOURCES),$(CHECKED_SOURCES))

# Generated files are what their generators print today.
.PHONY: generated-check
generated-check: $(B)/generate-tables $(B)/generate-textures $(MESH_GENERATOR) $(B)/glint-render $(B)/contact-sheet $(B)/glint-compare \
		atlas-check ## Generated tables, meshes, textures, figures and docs/atlas are what their generators make
	@tools/check-generated.sh $(B) $(MESH_GENERATOR)

.PHONY: generate
generate: $(B)/generate-tables $(B)/generate-textures $(MESH_GENERATOR) figures ## Make the generated tables, meshes, textures and figures again, in place
	tools/figures.sh page > $(B)/figures.md && cp $(B)/figures.md docs/figures.md
	if [ "$(PNG)" = yes ]; then mkdir -p docs/figures && rm -f docs/figures/*.png && cp $(B)/figures/*.png docs/figures; fi
	$(B)/generate-tables > $(B)/tables.c && cp $(B)/tables.c src/number/tables.c
	tools/mesh/regenerate.sh $(MESH_GENERATOR) examples/meshes
	for name in tiles planks globe; do \
		$(B)/generate-textures $$name > $(B)/$$name.c && cp $(B)/$$name.c examples/textures/$$name.c || exit 1; \
	done

.PHONY: consumer-check
consumer-check: ## A C and a C++ program build against the installed library through pkg-config
	@rm -rf $(B)/install
	@+$(SUBMAKE) install PREFIX=$(abspath $(B)/install)
	@tools/check-consumer.sh $(abspath $(B)/install) $(patsubst %,$(STARTUP)/%.c,consumer consumer_parts)

.PHONY: lvgl-check
lvgl-check: ## The LVGL canvas example compiles against LVGL's headers, where cargo can fetch them
	@tools/check-lvgl.sh $(B) $(CC) $(STRICT) -Iinclude -I.
