#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Size tables: tools/size-report.sh FOLDER PROCESSOR-BACKEND..., with FOLDER/PROCESSOR/size-BACKEND.elf and libglint.a.
#
# First the linked size programs (tests/target/startup/size_program.c), then the library's objects one by one, which
# counts what a program that does not call it leaves out. Where docs/size-baseline.txt holds an earlier report, each
# figure that changed is followed by the difference. The report itself is written to FOLDER/size.txt: copy it over the
# baseline at a release.
set -euo pipefail

folder=$1
shift
baseline=docs/size-baseline.txt
report=$folder/size.txt

size_tool() {
    case $1 in avr) echo avr-size ;; *) echo arm-none-eabi-size ;; esac
}

# Bytes of the sections that start with .NAME, one column for each of the four.
sections() {
    awk -v key="$1" '
        /^\.(text|vectors)/ { text += $2 }
        /^\.rodata|^\.ARM\.ex|^\.progmem/ { rodata += $2 }
        /^\.data/ { data += $2 }
        /^\.bss|^\.noinit/ { bss += $2 }
        END { printf "%-40s %8d %8d %8d %8d %8d\n", key, text, rodata, data, bss, text + rodata + data }'
}

{
    for program in "$@"; do
        target=${program%%-*}
        "$(size_tool "$target")" -A "$folder/$target/size-${program##*-}.elf" | sections "$program"
    done
    for target in $(printf '%s\n' "${@%%-*}" | sort -u); do
        find "$folder/$target/obj/src" -name '*.o' | sort | while read -r object; do
            name=${object#"$folder/$target/obj/src/"}
            "$(size_tool "$target")" -A "$object" | sections "$target:${name%.o}"
        done
    done
} >"$report"

[ -f "$baseline" ] || baseline=/dev/null
printf '%-40s %8s %8s %8s %8s %8s\n' "bytes" .text .rodata .data .bss flash
awk '
    NR == FNR && FILENAME != ARGV[2] { for (i = 2; i <= 6; i++) { old[$1, i] = $i } next }
    {
        change = ""
        for (i = 2; i <= 6; i++) {
            if (($1, i) in old && old[$1, i] != $i) {
                change = change sprintf(" %s %+d", substr("text  rodatadata  bss   flash ", (i - 2) * 6 + 1, 6), $i - old[$1, i])
            }
        }
        if (($1, 6) in old == 0 && length(old) > 0) { change = " new" }
        seen[$1] = 1
        print $0 change
    }
    END { for (key in old) { split(key, part, SUBSEP); if (part[2] == 6 && !(part[1] in seen)) { print part[1] " gone" } } }
' "$baseline" "$report"

# Goals, printed and not enforced. Stack: as the self-test measured it (`make targets` in the same build folder), painted,
# while it drew its pictures; its flush function and printing are in it.
goal() { # met? text
    if [ "$1" -eq 1 ]; then printf '  met     %s\n' "$2"; else printf '  MISSED  %s\n' "$2"; fi
}
echo "Goals: flash of the fixed backend on Cortex-M0+ with -Os 10240 bytes, all tiers, diffuse and specular; stack 1024 bytes:"
flash=$(awk '$1 == "m0plus-fixed" { print $6 }' "$report")
[ -z "$flash" ] || goal $((flash <= 10240)) "m0plus   flash of size-fixed.elf: $flash bytes"
for variant in phong:10240 diffuse:7168; do
    flash=$(awk -v name="m0plus-fixed_${variant%:*}" '$1 == name { print $6 }' "$report")
    [ -z "$flash" ] || goal $((flash <= ${variant#*:})) \
        "m0plus   flash of size-fixed_${variant%:*}.elf: $flash bytes, goal ${variant#*:}"
done
for target in m0plus m4f avr; do
    measured=$folder/../targets/$target/report.txt
    if [ ! -f "$measured" ]; then
        echo "          $target: no stack was measured: make targets"
        continue
    fi
    grep '^stack ' "$measured" | tr -d '\r' | while read -r _ what bytes; do
        goal $((bytes <= 1024)) "$target $what: $bytes bytes of stack"
    done
done
