#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Counts the frames on the targets' emulators:
#
#     tools/cost/run.sh probe TARGET          says what is missing to compile and run it, with its package; status 1 then
#     tools/cost/run.sh run BUILD TARGET PROGRAM REPORT [any-ram]
#                                             what the program prints -> REPORT. BUILD/cost/node has rp2040js, which has the
#                                             chip's RAM, or any that the program was linked for
#     tools/cost/run.sh table BUILD PEERS TARGET...   reports -> BUILD/cost/cost.csv, with PEERS as a table, and the goals
#
# A report is there only if its program came to its end. A target without a report has no rows.
set -euo pipefail

# The longest run, float without a floating-point unit, takes half a minute on a desktop computer.
limit=900

need() {
    command -v "$1" >/dev/null && return 0
    echo "$target: $1 is not there (package $2): its rows are left out" >&2
    return 1
}

probe() {
    case $target in
    m0plus* | m3 | m4f) need arm-none-eabi-gcc "gcc-arm-none-eabi and libnewlib-arm-none-eabi" || return 1 ;;
    rv32imac) need riscv64-unknown-elf-gcc "gcc-riscv64-unknown-elf and picolibc-riscv64-unknown-elf" || return 1 ;;
    avr-cycles) need avr-gcc "gcc-avr and avr-libc" || return 1 ;;
    *)
        echo "unknown target '$target'" >&2
        return 1
        ;;
    esac
    case $target in
    m0plus-cycles) need node nodejs && need npm npm ;;
    m0plus | m3 | m4f) need qemu-system-arm qemu-system-arm ;;
    rv32imac) need qemu-system-riscv32 qemu-system-misc ;;
    avr-cycles) need simavr simavr ;;
    esac
}

# One instruction a nanosecond of emulated time, so that counters count instructions. ARMv6-M code runs on the Cortex-M3
# board, whose RAM holds a whole frame.
bare=(-nographic -monitor none -icount shift=0)
semihosting=(-serial none -chardev stdio,id=out -semihosting-config enable=on,target=native,chardev=out)

run() {
    case $target in
    m0plus | m3) timeout $limit qemu-system-arm -M mps2-an385 "${bare[@]}" "${semihosting[@]}" -kernel "$program" ;;
    m4f) timeout $limit qemu-system-arm -M mps2-an386 "${bare[@]}" "${semihosting[@]}" -kernel "$program" ;;
    rv32imac)
        timeout $limit qemu-system-riscv32 -M virt -bios none "${bare[@]}" -serial stdio -kernel "$program"
        ;;
    m0plus-cycles) timeout $limit node tools/cost/rp2040.js "$build/cost/node" "$program" ${any_ram:+--any-ram} ;;
    # simavr colours the text, and shows a line's end as a dot besides
    avr-cycles)
        timeout $limit simavr -m atmega1284p -f 16000000 "$program" 2>&1 |
            sed 's/\x1b\[[0-9;]*m//g; s/\.$//'
        ;;
    esac
}

verb=$1
shift
case $verb in
probe)
    target=$1
    probe
    ;;
run)
    build=$1
    target=$2
    program=$3
    report=$4
    any_ram=${5:-}
    output=${report%.txt}.output
    rm -f "$report"
    status=0
    run >"$output" </dev/null || status=$?
    if [ $status -ne 0 ] || ! grep -qx end "$output"; then
        echo "$target: did not come to its end (status $status, 124 after $limit s); its last lines:" >&2
        tail -n 5 "$output" >&2
        exit 1
    fi
    mv "$output" "$report"
    ;;
table)
    build=$1
    peers=$2
    shift 2
    reports=() status=0
    for target in "$@"; do
        if [ -f "$build/cost/$target.txt" ]; then
            reports+=("$target" "$build/cost/$target.txt")
        fi
    done
    if [ ${#reports[@]} -eq 0 ]; then
        echo "make cost: no target could be counted" >&2
        exit 1
    fi
    table=$build/cost/cost.csv details=$build/cost/details.csv
    rm -f "$table" "$details"
    "$build/cost-judge" "$details" "${reports[@]}" >"$table" || status=$?
    awk -f tools/cost/table.awk "$details" "$table" "$peers"
    echo "Compiled with:"
    for target in "$@"; do
        if [ -f "$build/cost/$target.txt" ]; then
            printf '  %-14s %s: %s\n' "$target" "$(head -n 1 "$build/cost/$target.flags")" "$(tail -n 1 "$build/cost/$target.flags")"
        fi
    done
    awk -f tools/cost/goals.awk "$details" "$peers" "$table"
    echo "Written: $build/cost/cost.csv"
    exit $status
    ;;
*)
    echo "usage: tools/cost/run.sh probe TARGET | run BUILD TARGET PROGRAM REPORT [any-ram] | table BUILD PEERS TARGET..." >&2
    exit 2
    ;;
esac
