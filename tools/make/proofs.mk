# SPDX-License-Identifier: MIT
#
# Proofs of the number kernel's bounds (Gappa), of integer identities (z3), and what is measured beside them.

PROOFS_MEASURE := $(B)/measure-bounds
PROOFS_MEASURE_SMALL := $(B)/measure-bounds-small

.PHONY: proofs
proofs: ## Bounds of the number kernel: stated, proved, measured; installs what is missing; LONG=1 for more
	@tools/install-packages.sh proofs
	@+$(SUBMAKE) $(PROOFS_MEASURE) $(PROOFS_MEASURE_SMALL)
	@LONG=$(LONG) tests/proofs/run.sh $(PROOFS_MEASURE) $(PROOFS_MEASURE_SMALL) $(B)/proofs

# The routines and their tables are included as text, local routines too.
$(PROOFS_MEASURE): $(B)/obj/tests/proofs/measure.o
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

$(PROOFS_MEASURE_SMALL): tests/proofs/measure.c $(HOST_STAMPS)
	$(call run,CC  )$(CC) $(HOST_FLAGS) -DGLINT_SMALL_TABLES=1 $(LDFLAGS) -MMD -MP -MF $@.d -o $@ $< -lm

-include $(B)/obj/tests/proofs/measure.d $(PROOFS_MEASURE_SMALL).d

# What the choice of tables changes, with the smaller ones: the number tests, the lighting tests, the match with the
# reference.
SMALL_TABLES_TESTS = tests/unit/test_number tests/unit/test_number_unit tests/unit/test_lighting \
	tests/unit/test_lighting_shapes tests/image/test_reference_match

.PHONY: test-small-tables
test-small-tables: ## The number, lighting and reference-match tests with GLINT_SMALL_TABLES
	@+$(SUBMAKE) B=$(B)/small-tables CFLAGS="$(CFLAGS) -DGLINT_SMALL_TABLES=1" run-small-tables

.PHONY: run-small-tables
run-small-tables: $(addprefix $(B)/,$(SMALL_TABLES_TESTS))
	@tools/check-tests.sh $(JOBS) $^
