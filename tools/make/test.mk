# SPDX-License-Identifier: MIT
#
# The tests: installing what they need, running them, coverage.

# A make called from a recipe shares the caller's jobs if it has any; otherwise it takes as many as there are processors.
SUBMAKE = $(MAKE) --no-print-directory $(if $(filter -j%,$(MAKEFLAGS)),,-j$(JOBS))

.PHONY: test
test: ## Run all tests; installs what is missing through the system's package manager
	@tools/install-packages.sh test
	@+$(SUBMAKE) run-tests

# The environment tells the tests of the programs where this flavour's programs are.
.PHONY: run-tests
run-tests: $(TESTS) $(B)/glint-render $(TOOLS) ## Build and run the tests with what is installed
	@GLINT_BUILD=$(B) GLINT_RENDER=$(B)/glint-render GLINT_COMPARE=$(B)/glint-compare GLINT_IMPORT=$(B)/glint-import \
		tools/check-tests.sh $(JOBS) $(TESTS)

.PHONY: hard-cases
hard-cases: $(filter $(B)/tests/hard/%,$(TESTS)) $(B)/glint-import ## The table of hard cases: what a naive renderer does, what Glint does
	@tools/hard-cases.sh $(B)

.PHONY: golden
golden: $(B)/tests/image/test_same_image ## Take what the fixed backend draws now as golden; look at build/demo first
	tests/image/write-golden.sh $(B)

# Three flavours, whose counts are added up: the tests; those with threads, which have to count atomically, and as that
# takes five times as long, count only the part that meets the other thread; and what the preprocessor can choose on any
# machine, chosen the other way. Of the tests themselves the functions of src/ that they include are counted, and those
# that nothing calls are kept.
COVERAGE := $(B)/coverage
COVERAGE_FLAGS := -O0 -g --coverage -fkeep-inline-functions
SINGLE_FLAGS := $(COVERAGE_FLAGS) -fprofile-filter-files=^src/
THREADED_FLAGS := $(COVERAGE_FLAGS) -fprofile-filter-files=^src/display/flush -fprofile-update=atomic
NARROW_FLAGS := $(SINGLE_FLAGS) -DGLINT_SMALL_TABLES=1 -DGLINT_WIDE_MULTIPLY=0
THREADED_TESTS = $(shell grep -l '<pthread.h>' $(TEST_SOURCES))
SINGLE_TESTS = $(filter-out $(THREADED_TESTS),$(TEST_SOURCES))
NARROW_TESTS := tests/unit/test_number.c tests/unit/test_number_unit.c
COUNTED_MAKE = $(SUBMAKE) CC=gcc COUNTED=yes
COUNTED_TESTS = $(THREADED_TESTS:%.c=$(COVERAGE)/threads/%) $(SINGLE_TESTS:%.c=$(COVERAGE)/single/%) \
	$(NARROW_TESTS:%.c=$(COVERAGE)/narrow/%)

.PHONY: coverage
coverage: ## Line and branch coverage of src/ by the tests; fails where what is not covered is not explained
	@tools/install-packages.sh test
	@tools/install-packages.sh coverage
	@find $(COVERAGE) -name '*.gcda' -delete 2>/dev/null || true
	@+$(COUNTED_MAKE) B=$(COVERAGE)/single CFLAGS="$(SINGLE_FLAGS)" \
		TEST_SOURCES="$(SINGLE_TESTS)" counted-tests counted-tools
	@+$(COUNTED_MAKE) B=$(COVERAGE)/threads CFLAGS="$(THREADED_FLAGS)" \
		TEST_SOURCES="$(THREADED_TESTS)" counted-tests
	@+$(COUNTED_MAKE) B=$(COVERAGE)/narrow CFLAGS="$(NARROW_FLAGS)" \
		TEST_SOURCES="$(NARROW_TESTS)" counted-tests
	@GLINT_BUILD=$(COVERAGE)/single GLINT_RENDER=$(COVERAGE)/single/glint-render \
		GLINT_COMPARE=$(COVERAGE)/single/glint-compare GLINT_IMPORT=$(COVERAGE)/single/glint-import \
		tools/check-tests.sh $(JOBS) $(COUNTED_TESTS)
	@tools/coverage.sh $(COVERAGE) docs/coverage.md

.PHONY: counted-tests counted-tools
counted-tests: $(TESTS)
counted-tools: $(B)/glint-render $(TOOLS)

# What holds no function of src/ may be fast.
ifdef COUNTED
$(B)/obj/tests/reference/%.o $(B)/obj/tools/%.o $(B)/obj/examples/render/%.o: HOST_FLAGS += -O2
endif
