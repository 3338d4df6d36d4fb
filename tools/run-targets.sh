#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Runs the self-test on a target's emulator, and tells of all targets in one table:
#
#     tools/run-targets.sh run BUILD TARGET        BUILD/targets/TARGET/selftest.elf -> report.txt beside it
#     tools/run-targets.sh table BUILD TARGET...   the first target is what the others are compared with
#
# A report is there only if the self-test came to its end: emulators end with status 0 whatever happened.
set -euo pipefail

verb=$1
build=$2
shift 2

# The longest run takes 4 s on a desktop computer.
limit=120

# What is emulated, as the table has it.
emulator_of() {
    case $1 in
    m0plus) echo "qemu microbit (Cortex-M0)" ;;
    m3) echo "qemu mps2-an385" ;;
    m4f) echo "qemu mps2-an386" ;;
    rv32imac) echo "qemu riscv32 virt" ;;
    avr) echo "simavr atmega1284p" ;;
    s390x) echo "qemu-s390x" ;;
    i686) echo "qemu-i386 (x87)" ;;
    host) echo "none" ;;
    *)
        echo "unknown target '$1'" >&2
        return 1
        ;;
    esac
}

# One instruction a nanosecond of emulated time, so that counters count instructions.
bare=(-nographic -monitor none -icount shift=0)
semihosting=(-serial none -chardev stdio,id=out -semihosting-config enable=on,target=native,chardev=out)

run() {
    local elf=$2
    case $1 in
    m0plus) timeout $limit qemu-system-arm -M microbit "${bare[@]}" "${semihosting[@]}" -kernel "$elf" ;;
    m3) timeout $limit qemu-system-arm -M mps2-an385 "${bare[@]}" "${semihosting[@]}" -kernel "$elf" ;;
    m4f) timeout $limit qemu-system-arm -M mps2-an386 "${bare[@]}" "${semihosting[@]}" -kernel "$elf" ;;
    rv32imac) timeout $limit qemu-system-riscv32 -M virt -bios none "${bare[@]}" -serial stdio -kernel "$elf" ;;
    # simavr colours the text, and shows a line's end as a dot besides
    avr) timeout $limit simavr -m atmega1284p -f 16000000 "$elf" 2>&1 | sed 's/\x1b\[[0-9;]*m//g; s/\.$//' ;;
    s390x) timeout $limit qemu-s390x "$elf" ;;
    i686) timeout $limit qemu-i386 "$elf" ;;
    host) timeout $limit "$elf" ;;
    esac
}

case $verb in
run)
    target=$1
    folder=$build/targets/$target
    emulator_of "$target" >/dev/null
    rm -f "$folder/report.txt"
    status=0
    run "$target" "$folder/selftest.elf" >"$folder/output.txt" </dev/null || status=$?
    if [ $status -ne 0 ] || ! grep -qx end "$folder/output.txt"; then
        echo "$target: the self-test did not come to its end (status $status, 124 after $limit s); its last lines:" >&2
        tail -n 5 "$folder/output.txt" >&2
        exit 1
    fi
    mv "$folder/output.txt" "$folder/report.txt"
    ;;
table)
    first=$1
    status=0
    "$build/check-selftest" --head
    for target in "$@"; do
        "$build/check-selftest" "$build/targets/$first/report.txt" "$build/targets/$target/report.txt" \
            "$target" "$(emulator_of "$target")" || status=1
    done
    "$build/check-selftest" --foot
    awk '$1 == "count" && $2 == "unit-q15" {
        printf "glint_unit_q15 on ARMv6-M: %.1f instructions on average, %.1f at worst; the goal is 120: %s\n", $3 / 10, $4 / 10,
            $4 <= 1200 ? "met" : "MISSED" }' "$build/targets/m0plus/report.txt"
    [ $status -eq 0 ] || echo "FAILED: see the messages above" >&2
    exit $status
    ;;
*)
    echo "usage: tools/run-targets.sh run|table BUILD TARGET..." >&2
    exit 2
    ;;
esac
