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

.PHONY: coverage
coverage: ## Line and branch coverage of src/ by the tests (needs gcovr)
	@command -v gcovr >/dev/null || { echo "make coverage needs gcovr: apt-get install gcovr" >&2; exit 1; }
	@find $(B)/coverage -name '*.gcda' -delete 2>/dev/null || true
	@+$(SUBMAKE) B=$(B)/coverage CC=gcc CFLAGS="-O0 -g --coverage -fprofile-update=atomic" run-tests
	gcovr --root . --filter src/ --object-directory $(B)/coverage $(B)/coverage
	gcovr --root . --filter src/ --object-directory $(B)/coverage --branches $(B)/coverage
