#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Runs the tests of the hard cases and prints them as a table: tools/hard-cases.sh BUILD
#
# BUILD is the directory with tests/hard/test_*, compiled. Each test prints one line (tests/hard/hard.h) with what a
# naive version does and what Glint does, both measured. Exits with 1 when a row is missing or failed. Rows that ask for
# an effect that is not built yet, and rows whose tool is not installed, are named below the table with their reason.
# The environment (CC, GLINT_IMPORT, GLINT_LONG ...) is handed on to the tests.
set -u

build=${1:-build}
export GLINT_BUILD=$build GLINT_IMPORT=${GLINT_IMPORT:-$build/glint-import} CMOCKA_MESSAGE_OUTPUT=stdout
programs=$(find "$build/tests/hard" -maxdepth 1 -type f -name 'test_hard_*' -perm -u+x ! -name '*.*' 2>/dev/null | sort)
[ -n "$programs" ] || {
    echo "hard-cases: no program $build/tests/hard/test_hard_* was found; build the tests first" >&2
    exit 1
}
output=$(mktemp)
trap 'rm -f "$output"' EXIT
for program in $programs; do
    # a program that crashes is told by its missing rows; the status by itself names the program
    case $program in /*) path=$program ;; *) path=./$program ;; esac
    "$path" >>"$output" 2>&1 || echo "STOPPED $program $?" >>"$output"
done

awk -F '|' '
function expect(letter, count,    i) {
    for (i = 1; i <= count; i++) {
        order[++rows] = letter i
    }
}
function wrap(label, words,    n, part, i, line) {
    n = split(words, part, " ")
    line = label
    for (i = 1; i <= n; i++) {
        if (length(line) + length(part[i]) + 1 > 118) {
            print line
            line = "              "
        }
        line = line " " part[i]
    }
    print line
}
BEGIN {
    expect("A", 12); expect("B", 8); expect("C", 11); expect("D", 9); expect("E", 16); expect("F", 11)
    expect("G", 5); expect("H", 5); expect("I", 12)
}
/^HARD\|/ {
    seen[$2]++
    what[$2] = $3; naive[$2] = $4; glint[$2] = $5; result[$2] = $6
    next
}
/FAILED.*test_[A-I][0-9]+_/ {
    name = $0
    sub(/.*test_/, "", name)
    id = name
    sub(/_.*/, "", id)
    failed[id] = "test_" name
}
/^STOPPED / { stopped = stopped "  " substr($0, 9) "\n" }
END {
    for (r = 1; r <= rows; r++) {
        id = order[r]
        if (id in failed) {
            printf "%-4s FAIL  %s\n\n", id, failed[id]
            bad = bad " " id
            failures++
        } else if (!(id in seen)) {
            printf "%-4s FAIL  no test printed this row\n\n", id
            bad = bad " " id
            failures++
        } else {
            printf "%-4s %-5s %s\n", id, result[id], what[id]
            wrap("           naive:", naive[id])
            wrap("           Glint:", glint[id])
            print ""
            if (result[id] == "skip") {
                skipped++
                notes = notes "  " id ": " glint[id] "\n"
            } else if (result[id] != "pass") {
                bad = bad " " id
                failures++
            } else {
                passed++
                at = index(glint[id], "not built yet: ")
                if (at) {
                    reason = substr(glint[id], at)
                    sub(/;.*/, "", reason)
                    notes = notes "  " id ": " reason "\n"
                }
            }
        }
    }
    if (notes) {
        printf "Rows that ask for more than is built, or were left out; what exists of them is tested:\n%s\n", notes
    }
    if (stopped) {
        printf "Programs that ended with an error status:\n%s\n", stopped
    }
    if (bad) {
        print "Missing or failed:" bad
    }
    printf "%d rows: %d passed, %d skipped with a reason, %d missing or failed\n", rows, passed, skipped, failures
    exit failures > 0 || rows != 89 || stopped != ""
}' "$output"
