# SPDX-License-Identifier: MIT
#
# Fuzzing with libFuzzer under AddressSanitizer and UndefinedBehaviorSanitizer, and the ranges of fixed-point quantities.

FUZZ := tests/fuzz
FUZZ_SECONDS ?= 600
FUZZ_SEED ?= 0

FUZZ_SANITIZE := -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all -fno-omit-frame-pointer
FUZZ_SOURCES := $(sort $(wildcard $(FUZZ)/fuzz_*.c)) $(FUZZ)/assimp_alone.c
TARGET_SOURCES += $(FUZZ_SOURCES)

.PHONY: fuzz fuzz-short run-fuzz
fuzz: ## Each fuzzer for FUZZ_SECONDS (default 600); what is found is kept in build/fuzz. Installs what is missing
	@tools/install-packages.sh fuzz
	@+$(SUBMAKE) B=$(B)/fuzz CC=clang CFLAGS="-O2 -g -fsanitize=fuzzer-no-link $(FUZZ_SANITIZE)" run-fuzz

fuzz-short: ## Each fuzzer for 30 s with a fixed seed
	@+$(MAKE) --no-print-directory fuzz FUZZ_SECONDS=30 FUZZ_SEED=1

# Within the flavour. One after the other: each takes one processor.
.PHONY: run-fuzz run-fuzz-scene run-fuzz-import
run-fuzz:
	@+$(MAKE) --no-print-directory run-fuzz-scene
	@+$(if $(filter yes,$(ASSIMP)),$(MAKE) --no-print-directory run-fuzz-import,echo "fuzz-import: not run, no assimp")

run-fuzz-scene: $(B)/fuzz-scene
	@mkdir -p $(B)/scene/new $(B)/scene/found
	@$(B)/fuzz-scene -seed=$(FUZZ_SEED) -max_len=1024 -timeout=20 -max_total_time=$(FUZZ_SECONDS) -print_final_stats=1 \
		-artifact_prefix=$(B)/scene/found/ $(B)/scene/new $(FUZZ)/corpus-scene >$(B)/scene/log 2>&1 \
		|| { grep -v '^#\|NEW_FUNC' $(B)/scene/log | tail -40; echo "fuzz-scene: FOUND, see $(B)/scene"; exit 1; }
	@awk '/number_of_executed_units/ { n = $$2 } /average_exec_per_sec/ { a = $$2 } \
		END { print "fuzz-scene: nothing found in " n " scenes, " a " a second" }' $(B)/scene/log

run-fuzz-import: $(B)/fuzz-import $(B)/assimp-alone
	@$(FUZZ)/run-import.sh $^ $(B)/import $(FUZZ_SECONDS) $(FUZZ_SEED) $(FUZZ)/corpus-import

# The importer's fuzzer with another import_scene(), which is found before the archive's.
$(B)/assimp-alone: $(B)/obj/$(FUZZ)/fuzz_import.o $(B)/obj/$(FUZZ)/assimp_alone.o $(HOST_ARCHIVES)
	$(call run,LINK)$(CC) $(CFLAGS) -fsanitize=fuzzer $(LDFLAGS) -o $@ $^ $(OPTIONAL_LIBS) -lm

$(B)/fuzz-%: $(B)/obj/$(FUZZ)/fuzz_%.o $(HOST_ARCHIVES)
	$(call run,LINK)$(CC) $(CFLAGS) -fsanitize=fuzzer $(LDFLAGS) -o $@ $^ $(OPTIONAL_LIBS) -lm

-include $(patsubst %.o,%.d,$(call objects,$(FUZZ_SOURCES)))

# The checking build: UBSan at every arithmetic operation of the library, and the interval of each quantity that its
# sources trace (tests/fuzz/trace.h), held against tests/fuzz/ranges_table.h. No ASan: its redzones would break up the
# linker's list of traces.
RANGE_SANITIZE := -fsanitize=undefined,float-cast-overflow -fno-sanitize-recover=all
RANGE_SEED ?= 7
RANGE_SCENES ?= $(if $(LONG),2000000,100000)

.PHONY: ranges
ranges: ## The range of each named fixed-point quantity over a corpus, beside the documented one; LONG=1 for more scenes
	@tools/install-packages.sh fuzz
	@+$(SUBMAKE) B=$(B)/ranges CC=clang CFLAGS="-O2 -g $(RANGE_SANITIZE) -include $(abspath $(FUZZ)/trace.h)" \
		PNG=no ASSIMP=no run-ranges

.PHONY: run-ranges
run-ranges: $(B)/check-ranges
	@$(B)/check-ranges $(RANGE_SEED) $(RANGE_SCENES)

TARGET_SOURCES += $(FUZZ)/ranges.c
$(B)/check-ranges: $(B)/obj/$(FUZZ)/ranges.o $(HOST_ARCHIVES)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm
-include $(B)/obj/$(FUZZ)/ranges.d
