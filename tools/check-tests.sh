#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Runs cmocka test programs and adds up their counts: tools/check-tests.sh JOBS PROGRAM...
#
# Goes on after a program that fails. A program that crashes, runs out of time, or runs no test at all counts as one
# failure beside those that it reported. The last line is "N passed, N failed"; the exit status is 1 if anything failed.
set -u

jobs=$1
shift
limit_s=${GLINT_TEST_SECONDS:-900}
[ $# -gt 0 ] || {
    echo "check-tests: no test program given" >&2
    echo "0 passed, 1 failed"
    exit 1
}

# One program: its output goes to PROGRAM.log, its exit status to PROGRAM.status.
run_one() {
    local run=()
    command -v timeout >/dev/null && run=(timeout "$2")
    case $1 in /*) path=$1 ;; *) path=./$1 ;; esac
    CMOCKA_MESSAGE_OUTPUT=stdout "${run[@]}" "$path" >"$1.log" 2>&1
    echo $? >"$1.status"
    echo "ran $1"
}
export -f run_one
rm -f "${@/%/.status}"
printf '%s\n' "$@" | xargs -P "$jobs" -I{} bash -c 'run_one "$1" "$2"' _ {} "$limit_s"

# Sum of N over the lines "[  PASSED  ] N test(s)." and the like; a program may hold several groups.
count() {
    sed -n "s/^\[  *$1  *\] \([0-9][0-9]*\) test(s).*/\1/p" "$2" | awk '{ sum += $1 } END { print sum + 0 }'
}

passed=0 failed=0 skipped=0
for program in "$@"; do
    log=$program.log
    status=$(cat "$program.status" 2>/dev/null || echo 127)
    program_passed=$(count PASSED "$log")
    program_failed=$(count FAILED "$log")
    program_skipped=$(count SKIPPED "$log")
    reason=
    if [ "$status" -eq 124 ]; then
        reason="did not end within $limit_s s"
    elif [ "$status" -ne 0 ] && [ "$program_failed" -eq 0 ]; then
        reason="ended with status $status"
    elif [ "$status" -ge 126 ]; then
        reason="crashed with status $status"
    elif [ $((program_passed + program_failed + program_skipped)) -eq 0 ]; then
        reason="ran no test"
    fi
    if [ -n "$reason" ] || [ "$program_failed" -gt 0 ]; then
        echo "---- $program"
        cat "$log"
        [ -z "$reason" ] || echo "---- $program: $reason"
    fi
    [ -z "$reason" ] || program_failed=$((program_failed + 1))
    printf '%-44s %4d passed %4d failed %4d skipped\n' "$program" "$program_passed" "$program_failed" "$program_skipped"
    passed=$((passed + program_passed))
    failed=$((failed + program_failed))
    skipped=$((skipped + program_skipped))
done
[ "$skipped" -eq 0 ] || echo "$skipped skipped"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
