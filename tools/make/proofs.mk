# SPDX-License-Identifier: MIT
#
# Proofs of the number kernel's bounds (Gappa), of integer identities (z3), and what is measured beside them.

PROOFS_MEASURE := $(B)/measure-bounds

.PHONY: proofs
proofs: ## Bounds of the number kernel: stated, proved, measured; installs what is missing; LONG=1 for more
	@tools/install-packages.sh proofs
	@+$(SUBMAKE) $(PROOFS_MEASURE)
	@LONG=$(LONG) tests/proofs/run.sh $(PROOFS_MEASURE) $(B)/proofs

# The routines are included as text, local ones too; the library gives the tables.
$(PROOFS_MEASURE): $(B)/obj/tests/proofs/measure.o $(LIBRARY)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm

-include $(B)/obj/tests/proofs/measure.d
