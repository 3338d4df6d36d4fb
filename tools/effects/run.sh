#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Runs the programs of effects.mk on their emulators, and prints what each effect costs:
#
#     tools/effects/run.sh BUILD      writes BUILD/effects/effects.csv; status 1 where something does not hold
#
# Held to: a scene that does not use an effect costs the same whether it is linked or not, within what effects.txt says; where
# it is not linked, the image has no function or table of it and a scene that asks for it is refused; the effect's scene
# is within one code of the reference in both backends.
set -euo pipefail

build=$1
list=tools/effects/effects.txt
limit=120
targets=(m0plus m4f)
failed=0

need() {
    command -v "$1" >/dev/null && return 0
    echo "make effects: $1 is not there (package $2)" >&2
    exit 1
}
need arm-none-eabi-nm binutils-arm-none-eabi
need qemu-system-arm qemu-system-arm

complain() {
    echo "make effects: $*" >&2
    failed=1
}

run_one() { # folder/name-with|without.elf
    local board=mps2-an385
    case $1 in */m4f-*) board=mps2-an386 ;; esac
    timeout $limit qemu-system-arm -M $board -nographic -monitor none -icount shift=0 -serial none \
        -chardev stdio,id=out -semihosting-config enable=on,target=native,chardev=out -kernel "$1" \
        >"${1%.elf}.txt" </dev/null || echo "failed $?" >>"${1%.elf}.txt"
}
export -f run_one
export limit

names=$(awk '!/^#/ && NF { print $1 }' "$list")
for target in "${targets[@]}"; do
    for name in $names; do
        printf '%s\n' "$build/effects/$target-O2/$name-with.elf" "$build/effects/$target-O2/$name-without.elf"
    done
done | xargs -P "$(getconf _NPROCESSORS_ONLN)" -I {} bash -c 'run_one {}'

flash() {
    arm-none-eabi-size "$1" | awk 'NR == 2 { print $1 + $2 }'
}

# Instructions of a line "KIND SHADING STEPS" of a report; - where there is none, "refused" where it says so.
frame() { # report kind shading
    awk -v kind="$2" -v shading="$3" '
        $1 == "calibration" { step = int($2 / $3 + 0.5) }
        $1 == kind && $2 == shading { print $3 == "refused" ? $3 : $3 * step; found = 1; exit }
        END { if (!found) { print "-" } }' "$1"
}

memory() { # report kind
    awk -v kind="$2" '$1 == "memory" && $2 == kind { bytes = $3 } END { print bytes + 0 }' "$1"
}

names_like() { # elf pattern
    arm-none-eabi-nm "$1" | awk -v pattern="$2" '$3 ~ pattern { print $3 }'
}

scenes=$(awk '!/^#/ && NF && $3 != "-" { print $3 }' "$list" | sort -u)
# shellcheck disable=SC2086 # several names
"$build/effect-errors" $scenes >"$build/effects/errors.txt" || complain "a scene could not be compared"

csv=$build/effects/effects.csv
echo "effect,target,most_percent,flash,memory,plain_exact_without,plain_exact_with,plain_tolerance_without,plain_tolerance_with,on,fixed_error,float_error" >"$csv"
while read -r name _ scene most symbols; do
    read -r fixed float < <(awk -v scene="$scene" '$1 == scene { print $2, $3; found = 1 } END { if (!found) { print "- -" } }' \
        "$build/effects/errors.txt") || true
    found=
    for target in "${targets[@]}"; do
        small=$build/effects/$target-Os/$name fast=$build/effects/$target-O2/$name
        for which in with without; do
            grep -qx end "$fast-$which.txt" && ! grep -q '^failed' "$fast-$which.txt" ||
                complain "$target $name $which: the program did not come to its end: $fast-$which.txt"
        done
        there=$(names_like "$small-without.elf" "$symbols" | tr '\n' ' ')
        [ -z "$there" ] || complain "$target $name: not linked, yet there: $there"
        found+=$(names_like "$small-with.elf" "$symbols")
        on=exact
        [ "$name" != tiers ] || on=tolerance
        [ "$(frame "$fast-without.txt" on $on)" = refused ] || complain "$target $name: not linked, yet not refused"
        echo "$name,$target,$most,$(($(flash "$small-with.elf") - $(flash "$small-without.elf"))),$((\
            $(memory "$fast-with.txt" on) - $(memory "$fast-with.txt" plain))),$(
            for shading in exact tolerance; do
                printf '%s,%s,' "$(frame "$fast-without.txt" plain $shading)" "$(frame "$fast-with.txt" plain $shading)"
            done)$(frame "$fast-with.txt" on $on),$fixed,$float" >>"$csv"
    done
    # in one of the images: a compiler may take a function into its caller
    [ -n "$found" ] || complain "$name: linked, yet no name matches $symbols"
done < <(grep -v '^#' "$list")

awk -F , '
    function percent(from, to) { return from == "-" || to == "-" ? "" : 100 * (to / from - 1) }
    function show(x) { return x == "" ? sprintf("%9s", "-") : sprintf("%+8.2f%%", x) }
    function held(x, what) {
        if (x != "" && (x > $3 || x < -$3)) {
            printf "make effects: %s %s: a scene that does not use it costs %+.2f %% when it is linked, %s\n", $2, $1, x, what > "/dev/stderr"
            bad = 1
        }
    }
    NR == 1 {
        print "Bytes added to flash (-Os) and to the memory of a frame of 240 x 240; instructions (-O2) of a frame of the"
        print "yardstick scene, which does not use the effect, linked against not linked, and in millions where it does;"
        print "greatest error of a scene with the effect, within a tolerance of 1, in codes. m0plus: fixed; m4f: float."
        printf "%-13s%-7s%7s%8s%10s%10s%9s%8s%8s\n", "effect", "", "flash", "memory", "exact", "tolerance", "used", "fixed", "float"
        next
    }
    {
        exact = percent($6, $7); tolerance = percent($8, $9)
        printf "%-13s%-7s%7d%8d %s %s%9.1f%8s%8s\n", $1, $2, $4, $5, show(exact), show(tolerance), $10 / 1e6, $11, $12
        held(exact, "exact"); held(tolerance, "within a tolerance")
        if ($11 > 1 || $12 > 1) {
            printf "make effects: %s: a scene with it errs by %s codes in fixed point, %s in float\n", $1, $11, $12 > "/dev/stderr"
            bad = 1
        }
    }
    END { exit bad }' "$csv" || failed=1
echo "Written: $csv"
[ $failed -eq 0 ] && echo "Every effect that is not linked is not there, every effect that is not used costs nothing."
exit $failed
