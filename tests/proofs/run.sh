#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Runs every proof and every measurement and prints them side by side: tests/proofs/run.sh MEASURE OUT
# Set LONG=1 for the slower proof too.
#
# MEASURE is the program built from measure.c, OUT a folder for what the provers printed. Ends with status 1 if a proof
# fails, or if a proved or a measured bound exceeds the one that the source states. docs/proofs.md explains the rows.
set -euo pipefail

measure=$1
out=$2
here=$(dirname "$0")
rm -rf "$out"
mkdir -p "$out"
status=0

fail() {
    echo "proofs: $*" >&2
    status=1
}

# prove SCRIPT LOG NAME=value...: Gappa with the names replaced; its bounds are appended to LOG. A hint that is not an
# identity would be an assumption, so Gappa's warning about one counts as a failure.
prove() {
    local script=$here/$1 log=$out/$2 edits=(-e "")
    shift 2
    for parameter; do
        edits+=(-e "s|\\b${parameter%%=*}\\b|${parameter#*=}|g")
    done
    if ! sed "${edits[@]}" "$script" | gappa >"$out/bounds" 2>&1 ||
        grep -q 'not trivially equal\|Error\|pointless' "$out/bounds"; then
        cat "$out/bounds" >&2
        fail "$script does not hold for $*"
    fi
    cat "$out/bounds" >>"$log"
}

# limits LOG NAME: least and greatest value of NAME in all of Gappa's "NAME in [m b e {...}, m b e {...}]".
limits() {
    awk -v name="$2" '
        function value(text,   part) {
            sub(/ *\{[^}]*\}/, "", text)
            return split(text, part, "b") == 2 ? part[1] * 2 ^ part[2] : text + 0
        }
        index($0, "  " name " in [") == 1 {
            text = substr($0, length(name) + 8); sub(/\]$/, "", text)
            gsub(/\{[^}]*\}/, "", text); split(text, end, ",")
            low = value(end[1]); high = value(end[2])
            if (!found++ || low < least) { least = low }
            if (found == 1 || high > greatest) { greatest = high }
        }
        END { if (!found) { exit 1 }; printf "%.17g %.17g\n", least, greatest }' "$out/$1"
}

# larger LOG NAME: the greatest magnitude.
larger() {
    limits "$1" "$2" | awk '{ low = $1 < 0 ? -$1 : $1; high = $2 < 0 ? -$2 : $2; printf "%.17g\n", (low > high ? low : high) }'
}

# stated FILE 'TEXT BEFORE': the number that follows these words in a source file, line breaks of comments aside.
stated() {
    local found
    found=$(tr '\n' ' ' <"$here/../../$1" | sed 's/ \+\*\/\? \+/ /g' | grep -o -- "$2 [0-9.^-]*[0-9]" | head -n 1) ||
        { fail "$1 no longer says: $2" ; found="0"; }
    echo "${found##* }" | awk -F '^' '{ split($0, part, "^"); printf "%.17g\n", part[2] == "" ? part[1] : part[1] ^ part[2] }'
}

# row ROUTINE UNIT STATED PROVED KEY: one line of the table; the measured worst is what MEASURE printed for KEY.
row() {
    local measured tried
    read -r measured tried < <(sed -n "s/^$5 //p" "$out/measured")
    awk -v routine="$1" -v unit="$2" -v stated="$3" -v proved="$4" -v measured="$measured" -v tried="$tried" '
        function show(x) { return x > 0 && x < 0.0001 ? sprintf("2^%.3f", log(x) / log(2)) : sprintf("%.5g", x) }
        BEGIN {
            # the printed bounds are rounded, so equality up to 10^-9 is equality
            bad = proved > stated * (1 + 1e-9) || measured > stated * (1 + 1e-9) || measured > proved * (1 + 1e-9)
            printf "%-30s %-10s %9s %9s %9s %6.3f  %s%s\n", routine, unit, show(stated), show(proved), show(measured),
                proved / measured, tried, bad ? "  VIOLATED" : ""
            exit bad
        }' || status=1
}

# solve ROUTINE KEY EXPECTED SCRIPT [NAME=value...]: z3 must answer each query as expected; no counterexample measured.
solve() {
    local routine=$1 key=$2 expected=$3 script=$here/$4 mistakes tried edits=(-e "") verdict=$3 answers
    shift 4
    for parameter; do
        edits+=(-e "s|\\b${parameter%%=*}\\b|${parameter#*=}|g")
    done
    answers=$(sed "${edits[@]}" "$script" | z3 -in -T:300 | grep -v '[a-z] ' | sort | uniq) || true
    if [ "$answers" != "$expected" ]; then
        verdict=FAILED
        fail "$script $*: expected $expected, z3 says: $answers"
    fi
    read -r mistakes tried < <(sed -n "s/^$key //p" "$out/measured")
    [ "$mistakes" = 0 ] || fail "$key: $mistakes counterexamples"
    printf '%-50s %9s %9s  %s\n' "$routine" "$verdict" "$mistakes" "$tried"
}

"$measure" bounds >"$out/measured"

"$measure" reciprocal-cells >"$out/cells"
while read -r -a cell; do
    prove reciprocal.g reciprocal "${cell[@]}"
done <"$out/cells"

# Parameters of unit.g for a root's error and a range of sqrt(S): the vector's length is that, or half of it; widened by
# what the components' rounding can do to it.
unit_cases() {
    awk -v low="$1" -v high="$2" -v root="$3" '
        function put(own, others, largest,   m, b) {
            m = largest / r_high; if (m > 1) { m = 1 }
            even = 2 * m * m <= 1 && own == 1
            b = even || own == 2 ? 0 : sqrt(1 - m * m) + 1e-9
            printf "ROOT=%.12f OWN=%d OTHERS=%d R_LOW=%.12f R_HIGH=%.12f M=%.12f A_LOW=%.12f A_HIGH=1 B_LOW=0 B_HIGH=%.12f\n",
                root, own, others, r_low, r_high, m - 1e-12, even ? 0 : m - 1e-12, b
        }
        BEGIN {
            for (half = 2; half >= 1; half--) {
                r_low = low / half - 2 ^ -15; r_high = high / half + 2 ^ -15
                if (r_low > sqrt(3)) { continue }
                put(1, 1, 0.5 - 2 ^ -16)
                if (r_high >= 1 - 2 ^ -15) { put(2, 1, 1 - 2 ^ -15); put(1, 2, 1 - 2 ^ -15) }
            }
        }'
}

"$measure" root-cells >"$out/cells"
while read -r -a cell; do
    : >"$out/first"
    : >"$out/second"
    prove inverse_root_first.g first "${cell[@]}"
    # the clamp of y to 1 - 2^-16 can only bring a result that is too large nearer, and no lower than -2^-16
    read -r error_low error_high < <(limits first 'Y * q - 1')
    error_low=$(awk -v low="$error_low" 'BEGIN { printf "%.15f", (low < -2 ^ -16 ? low : -2 ^ -16) - 1e-15 }')
    error_high=$(awk -v high="$error_high" 'BEGIN { printf "%.15f", high + 1e-15 }')
    prove inverse_root_second.g second "${cell[@]}" "ERROR_LOW=$error_low" "ERROR_HIGH=$error_high"
    cat "$out/second" >>"$out/inverse_root"
    read -r error_low error_high < <(limits second 'Y * q - 1')
    root_low=${cell[0]#*=} root_high=${cell[1]#*=}
    # as above, for the last clamp; and 0.0003 ulp of Q15 for what the sum of squares loses and for the way from v to w
    read -r clamped root < <(awk -v low="$error_low" -v high="$error_high" -v q="$root_low" 'BEGIN {
        clamped = (1 + high) / q >= 1
        if (clamped && low > -2 ^ -16) { low = -2 ^ -16 }
        printf "%d %.12f\n", clamped, (-low > high ? -low : high) * 32768 + 0.0003 }')
    if [ "$clamped" = 1 ]; then
        echo "  Y * q - 1 in [-1b-16, 0]" >>"$out/inverse_root"
    fi
    unit_cases "$root_low" "$root_high" "$root" >"$out/unit-cells"
    while read -r -a case; do
        prove unit.g unit "${case[@]}"
    done <"$out/unit-cells"
done <"$out/cells"
unit_bound=$(printf '%s\n%s\n' "$(larger unit even)" "$(larger unit uneven)" | sort -g | tail -n 1 |
    awk '{ printf "%.17g\n", $1 + 0.5 }')

"$measure" power-cells >"$out/cells"
while read -r -a cell; do
    prove power.g power "${cell[@]}"
done <"$out/cells"

prove display_light.g display_light

printf '%-30s %-10s %9s %9s %9s %6s  %s\n' routine unit stated proved measured ratio 'measured over'
row glint_reciprocal_q31 relative "$(stated src/number/fixed.h 'Result in \[2^30, 2^31 - 1\]. Relative error at most')" \
    "$(larger reciprocal '1 - X * R2')" reciprocal
row inverse_root_q16 relative "$(stated src/number/fixed.c 'Relative error at most')" \
    "$(larger inverse_root 'Y * q - 1')" inverse_root
row glint_unit_q15 'ulp Q15' "$(stated src/number/fixed.h 'Error of a component at most')" "$unit_bound" unit
row glint_power_q15 absolute "$(stated src/number/fixed.h 'any 16-bit value. Error at most')" "$(larger power power)" power
row 'level, no dither' codes 0.5 "$(larger display_light level_nearest)" level_nearest
row 'level, dithered' codes 1 "$(larger display_light level_dithered)" level_dithered
row luma_q15 'ulp Q15' 0.5 "$(larger display_light luma)" luma
row light_multiply 'ulp Q15' 0.5 "$(larger display_light multiply)" multiply
row light_add 'ulp Q16' 0.5 "$(larger display_light add)" add
row light_clamp 'ulp Q15' 0.5 "$(larger display_light clamp)" clamp
row 'colour of three terms' codes 0.02 "$(larger display_light colour)" colour
echo
printf '%-50s %9s %9s  %s\n' identity z3 mistakes 'measured over'
solve 'multiply_high_narrow_u32, _s32 = wide product' multiply_high unsat multiply_high.smt2
solve 'multiply_q16 = floor(a b / 2^16)' multiply_q16 unsat multiply_q16.smt2
solve 'shift_round64 to nearest, |value| < 2^62' shift_round64 unsat shift_round64.smt2
solve "edges: sign of E' = sign of E, L = 2880" edges unsat edge_identity.smt2
solve 'edges: |E| <= L^2' edges unsat edge_range.smt2
# edges_at COORDINATE WORD EXPECTED
edges_at() {
    solve "edges with $1-bit coordinates, words of $2 bits" edges "$3" edge_words.smt2 "COORDINATE=$1" "PIXEL=$(($1 - 2))" \
        "ABOVE=$((12 - $1))" "BEYOND=$((14 - $1))" "WORD=$2" "TOP=$(($2 - 1))"
}
edges_at 3 5 unsat
edges_at 3 4 sat # as it must: 4 L^2 is not below 2^3
if [ -n "${LONG:-}" ]; then
    edges_at 4 7 unsat
    edges_at 4 6 sat
fi
echo
[ $status = 0 ] && echo "proofs: every bound holds" || echo "proofs: FAILED"
exit $status
