#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Runs the importer's fuzzer past what it finds, and tells whose finding each is:
# tests/fuzz/run-import.sh FUZZER ALONE FOLDER SECONDS SEED CORPUS...
#
# assimp is an input like any other, and it is known to crash, to hang, to fill memory and to lose it on broken files. So
# the fuzzer works in child processes (-fork=1) that may die; each input that killed one is run again. It is ours when a
# check of tests/fuzz failed, when a sanitizer spoke of a place in our own sources, or when the topmost frame outside of the
# system's libraries is ours; otherwise it is assimp's, is listed with its place, and does not fail the run. An input that no
# longer fails alone (a time limit on a busy machine) is listed as not repeated.
#
# Memory of a model is assimp's whoever forgets to release it, so a leak's stack does not tell. Its input is run through
# ALONE (tests/fuzz/assimp_alone.c), which only lets assimp read the file and releases it: where the same number of bytes in
# the same number of blocks leaks there too, after the first pass or after both, the leak is assimp's. Otherwise it is ours.
#
# Nothing stays behind, also when the run is interrupted: a fuzzer that dies cannot remove its folder (make_folder() in
# import_check.h), so that is done here.
set -eu

fuzzer=$1 alone=$2 folder=$3 seconds=$4 seed=$5
shift 5
# An earlier run's findings are not this run's.
rm -rf "$folder"
mkdir -p "$folder/new" "$folder/found" "$folder/tmp"

# Removes the folders of dead fuzzers that find's further conditions pick. One at work changes its folder with each input.
remove_folders() {
    for place in /dev/shm /tmp; do
        [ ! -d "$place" ] || find "$place" -maxdepth 1 -type d -name 'glint-fuzz-*' -user "$(id -u)" "$@" \
            -exec rm -rf {} + 2>/dev/null || :
    done
}

# A process group of its own lets the fuzzer's children be ended with it.
group=$(command -v setsid || :)
running=
finish() {
    trap '' INT TERM HUP
    if [ -n "$running" ]; then
        kill -TERM "${group:+-}$running" 2>/dev/null || :
        sleep 1
        kill -KILL "${group:+-}$running" 2>/dev/null || :
    fi
    # What changed during the run and no more after it.
    touch "$folder/tmp/ended"
    sleep 1
    remove_folders -newer "$folder/tmp/started" ! -newer "$folder/tmp/ended"
    rm -rf "$folder/tmp"
}
trap finish EXIT
trap 'exit 129' HUP
trap 'exit 130' INT
trap 'exit 143' TERM

remove_folders -mmin +1
touch "$folder/tmp/started"

status=0
TMPDIR=$folder/tmp $group "$fuzzer" -fork=1 -ignore_crashes=1 -ignore_ooms=1 -ignore_timeouts=1 -timeout=10 \
    -rss_limit_mb=1024 -max_len=4096 -seed="$seed" -max_total_time="$seconds" -artifact_prefix="$folder/found/" \
    "$folder/new" "$@" >"$folder/log" 2>&1 &
running=$!
wait "$running" || status=$?
running=
if ! grep -q '^#[0-9]*: cov: ' "$folder/log"; then
    tail -20 "$folder/log" >&2
    echo "fuzz-import: the fuzzer did not run (status $status)" >&2
    exit 1
fi

# One input through a program. Leaks need the whole stack, which takes unwinding with the debug information's tables.
run_once() { # program, input, report
    case $2 in
    */leak-*) unwind=fast_unwind_on_malloc=0 ;;
    *) unwind=fast_unwind_on_malloc=1 ;;
    esac
    ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}$unwind "$1" -timeout=10 -rss_limit_mb=1024 "$2" >"$3" 2>&1
}

# "N byte(s) leaked in M allocation(s)." of a report
leaked() {
    sed -n 's/^SUMMARY: AddressSanitizer: \(.*leaked.*\)/\1/p' "$1" | head -1
}

leaks_in_assimp_alone() { # input, its report
    for passes in 2 1; do
        FUZZ_ASSIMP_PASSES=$passes run_once "$alone" "$1" "$1.alone-$passes" || :
        if [ -n "$(leaked "$2")" ] && [ "$(leaked "$2")" = "$(leaked "$1.alone-$passes")" ]; then
            return 0
        fi
    done
    return 1
}

ours=0 theirs=0 leaks=0 once=0
: >"$folder/leaks"
for input in "$folder"/found/*; do
    [ -f "$input" ] || continue
    report=$input.report
    if run_once "$fuzzer" "$input" "$report"; then
        once=$((once + 1))
        continue
    fi
    if grep -q 'LeakSanitizer: detected' "$report"; then
        if leaks_in_assimp_alone "$input" "$report"; then
            leaks=$((leaks + 1))
            # The innermost of assimp's functions that has a name.
            sed -n 's/^ *#[0-9]* 0x[0-9a-f]* in \([^(]*\)(.*libassimp.*/\1/p' "$report" | head -1 >>"$folder/leaks"
        else
            ours=$((ours + 1))
            echo "fuzz-import: FOUND by $input: a leak that assimp alone does not have:" \
                "$(leaked "$report"), alone: $(leaked "$input.alone-2")"
            sed -n '/ERROR/,$p' "$report" | head -20
        fi
        continue
    fi
    # A check that failed, a sanitizer's remark on our source, or our frame before assimp's.
    frame=$(sed -n 's/^ *#[0-9]* 0x[0-9a-f]* //p' "$report" |
        grep -E 'libassimp|/(src|tools/import|tests/fuzz)/' | head -1)
    if grep -qE '(scene|import)_check\.h:[0-9]+: not so|^(\./)?(src|tools|tests)/.*runtime error' "$report" ||
        echo "$frame" | grep -qE '/(src|tools/import|tests/fuzz)/'; then
        ours=$((ours + 1))
        echo "fuzz-import: FOUND by $input:"
        sed -n '/not so\|runtime error\|ERROR/,$p' "$report" | head -20
    else
        theirs=$((theirs + 1))
        echo "  in assimp: $(sed -n 's/^SUMMARY: //p' "$report" | head -1 | cut -c 1-110) ($input)"
    fi
done
sort "$folder/leaks" | uniq -c | while read -r count place; do
    echo "  in assimp: $count inputs leak, alone as with the importer, what is taken in $place"
done
grep '^#[0-9]*: cov: ' "$folder/log" | tail -1
echo "fuzz-import: $ours found in this project; in assimp: $theirs and $leaks leaks; $once not repeated; after $seconds s"
[ "$ours" -eq 0 ]
