#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Runs the importer's fuzzer past what it finds, and tells whose finding each is:
# tests/fuzz/run-import.sh FUZZER FOLDER SECONDS SEED CORPUS...
#
# assimp is an input like any other, and it is known to crash, to hang and to fill memory on broken files. So the fuzzer
# works in child processes (-fork=1) that may die; each input that killed one is run again. It is ours when a check of
# tests/fuzz failed, when a sanitizer spoke of a place in our own sources, or when the topmost frame outside of the system's
# libraries is ours; otherwise it is assimp's, is listed with its place, and does not fail the run. An input that no longer
# fails alone (a time limit on a busy machine) is listed as not repeated. Leaks are listed apart and do not fail the run.
set -eu

fuzzer=$1 folder=$2 seconds=$3 seed=$4
shift 4
# An earlier run's findings are not this run's.
rm -rf "$folder"
mkdir -p "$folder/new" "$folder/found"

status=0
"$fuzzer" -fork=1 -ignore_crashes=1 -ignore_ooms=1 -ignore_timeouts=1 -timeout=10 -rss_limit_mb=1024 -max_len=4096 \
    -seed="$seed" -max_total_time="$seconds" -artifact_prefix="$folder/found/" "$folder/new" "$@" \
    >"$folder/log" 2>&1 || status=$?
if ! grep -q '^#[0-9]*: cov: ' "$folder/log"; then
    tail -20 "$folder/log" >&2
    echo "fuzz-import: the fuzzer did not run (status $status)" >&2
    exit 1
fi

ours=0 theirs=0 leaks=0 once=0
for input in "$folder"/found/*; do
    [ -f "$input" ] || continue
    if "$fuzzer" -timeout=10 -rss_limit_mb=1024 "$input" >"$input.report" 2>&1; then
        once=$((once + 1))
        continue
    fi
    # Memory of a model is assimp's whoever forgets to release it, so a leak's stack does not tell.
    if grep -q 'LeakSanitizer: detected' "$input.report"; then
        leaks=$((leaks + 1))
        echo "  leak, to be judged: $(sed -n 's/^SUMMARY: //p' "$input.report" | head -1) ($input)"
        continue
    fi
    # A check that failed, a sanitizer's remark on our source, or our frame before assimp's.
    frame=$(sed -n 's/^ *#[0-9]* 0x[0-9a-f]* //p' "$input.report" |
        grep -E 'libassimp|/(src|tools/import|tests/fuzz)/' | head -1)
    if grep -qE '(scene|import)_check\.h:[0-9]+: not so|^(\./)?(src|tools|tests)/.*runtime error' "$input.report" ||
        echo "$frame" | grep -qE '/(src|tools/import|tests/fuzz)/'; then
        ours=$((ours + 1))
        echo "fuzz-import: FOUND by $input:"
        sed -n '/not so\|runtime error\|ERROR/,$p' "$input.report" | head -20
    else
        theirs=$((theirs + 1))
        echo "  in assimp: $(sed -n 's/^SUMMARY: //p' "$input.report" | head -1 | cut -c 1-110) ($input)"
    fi
done
grep '^#[0-9]*: cov: ' "$folder/log" | tail -1
echo "fuzz-import: $ours found in this project, $theirs in assimp, $leaks leaks to be judged, $once not repeated, after $seconds s"
[ "$ours" -eq 0 ]
