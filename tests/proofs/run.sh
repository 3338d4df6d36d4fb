#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Runs every proof and every measurement and prints them side by side: tests/proofs/run.sh MEASURE MEASURE_SMALL OUT
# Set LONG=1 for the slower proof too.
#
# MEASURE is the program built from measure.c, MEASURE_SMALL the same with GLINT_SMALL_TABLES, OUT a folder for what the
# provers printed. Ends with status 1 if a proof fails, or if a proved or a measured bound exceeds the one that the
# source states. docs/proofs.md explains the rows.
set -euo pipefail

measure=$1
measure_small=$2
out=$3
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

# from_measure PROGRAM PART PREFIX: what it printed, each key with a prefix for the choice of tables.
from_measure() {
    "$1" "$2" | sed "s/^/$3/" >>"$out/measured"
}
from_measure "$measure" bounds ''
from_measure "$measure" table-bounds large_
from_measure "$measure_small" table-bounds small_

"$measure" reciprocal-cells >"$out/cells"
while read -r -a cell; do
    prove reciprocal.g reciprocal "${cell[@]}"
done <"$out/cells"

# Each of the next two appends to $out/roots, for each part of the range: least and greatest sqrt(S), and between which
# errors the relative error of inverse_root_q16 lies there.

root_proofs_large() {
    local cell
    while read -r -a cell; do
        : >"$out/part"
        prove inverse_root_table.g part "${cell[@]}"
        cat "$out/part" >>"$out/large_root"
        echo "${cell[0]#*=} ${cell[3]#*=} $(limits part 'Y * q - 1')" >>"$out/large_roots"
    done < <("$measure" root-cells)
}

root_proofs_small() {
    local cell low high
    while read -r -a cell; do
        : >"$out/first"
        : >"$out/second"
        prove inverse_root_first.g first "${cell[@]}"
        # the clamp of y to 1 - 2^-16 can only bring a result that is too large nearer, and no lower than -2^-16
        read -r low high < <(limits first 'Y * q - 1')
        low=$(awk -v low="$low" 'BEGIN { printf "%.15f", (low < -2 ^ -16 ? low : -2 ^ -16) - 1e-15 }')
        high=$(awk -v high="$high" 'BEGIN { printf "%.15f", high + 1e-15 }')
        prove inverse_root_second.g second "${cell[@]}" "ERROR_LOW=$low" "ERROR_HIGH=$high"
        cat "$out/second" >>"$out/small_root"
        # as above, for the last clamp
        read -r low high < <(limits second 'Y * q - 1')
        if awk -v high="$high" -v q="${cell[0]#*=}" 'BEGIN { exit (1 + high) / q < 1 }'; then
            echo "  Y * q - 1 in [-1b-16, 0]" >>"$out/small_root"
            low=$(awk -v low="$low" 'BEGIN { printf "%.17g", low < -2 ^ -16 ? low : -2 ^ -16 }')
        fi
        echo "${cell[0]#*=} ${cell[1]#*=} $low $high" >>"$out/small_roots"
    done < <("$measure_small" root-cells)
}

# Parameters of unit.g, from each part of the range of S and the error of the root there, in ulp of Q15. The vector's
# length in units of 2^32 after the shift is sqrt(S) or half of it; widened by what standing for one's half can do to it.
# The root's error sets the worst apart, which take more pieces.
unit_cases() {
    awk '{
        root = (-$3 > $4 ? -$3 : $4) * 32768
        for (half = 2; half >= 1; half--) {
            least = $1 / half - 2 ^ -15; m = 0.5 / ($2 / half + 2 ^ -15)
            if (least > sqrt(3)) { continue }
            if (m > 1) { m = 1 }
            share = sprintf("ROOT=%.12f R_LOW=%.12f R_HIGH=%.12f M=%.12f", root, least, 0.5 / m, m - 1e-12)
            if (2 * m * m <= 1) {
                pieces = root > 0.95 && half == 2 ? 400 : 100
                printf "%s CASE=even A_LOW=0 A_HIGH=1 PIECES=%d\n", share, pieces
            } else {
                printf "%s CASE=even A_LOW=%.12f A_HIGH=1 PIECES=40\n", share, m - 1e-12
                printf "%s CASE=uneven A_LOW=0 A_HIGH=%.12f PIECES=160\n", share, sqrt(1 - m * m) + 1e-12
            }
        }
    }' "$out/$1"
}

# Parameters of unit_q28.g: S in steps, with the greatest errors of the root over all.
unit_q28_cases() {
    awk 'NR == 1 || $3 < low { low = $3 } NR == 1 || $4 > high { high = $4 }
        END {
            for (i = 0; i < 48; i++) {
                s = 1 + i / 16; t = s + 1 / 16
                printf "ROOT_LOW=%.12f ROOT_HIGH=%.12f LOW=%.4f HIGH=%.4f ERROR_LOW=%.12f ERROR_HIGH=%.12f\n",
                    sqrt(s) - 1e-12, sqrt(t) + 1e-12, s, t, low - 1e-12, high + 1e-12
            }
        }' "$out/$1"
}

# The proofs of what depends on the choice of tables, `large` or `small`.
for tables in large small; do
    "root_proofs_$tables"
    while read -r -a case; do
        prove unit.g "${tables}_unit" "${case[@]}"
    done < <(unit_cases "${tables}_roots")
    while read -r -a case; do
        prove unit_q28.g "${tables}_unit_q28" "${case[@]}"
    done < <(unit_q28_cases "${tables}_roots")
    program=$measure
    [ $tables = large ] || program=$measure_small
    while read -r -a cell; do
        prove power.g "${tables}_power" "${cell[@]}"
    done < <("$program" power-cells)
done

# What unit.g leaves out, in ulp of Q15: rounding of the result, 1/2, and less than 0.0002 for the bits that the sum of
# squares loses, for the half that is added (2^-17), and for the direction that the root's error is taken along.
unit_bound() {
    { larger "$1_unit" even && larger "$1_unit" uneven; } | sort -g | tail -n 1 |
        awk '{ printf "%.17g\n", $1 + 0.5 + 0.0002 }'
}

# The same in ulp of Q28 for unit_q28.g: the rounding, and 10^-6 for products of two errors.
unit_q28_bound() {
    larger "$1_unit_q28" unit_q28 | awk '{ printf "%.17g\n", $1 + 0.5 + 1e-6 }'
}

prove display_light.g display_light

printf '%-30s %-10s %9s %9s %9s %6s  %s\n' routine unit stated proved measured ratio 'measured over'
row glint_reciprocal_q31 relative "$(stated src/number/fixed.h 'Result in \[2^30, 2^31 - 1\]. Relative error at most')" \
    "$(larger reciprocal '1 - X * R2')" reciprocal
# table_rows TABLES SUFFIX ROOT UNIT UNIT_Q28 POWER: the words before the bounds that the source states.
table_rows() {
    row "inverse_root_q16$2" relative "$(stated src/number/fixed.c "$3")" "$(larger "$1_root" 'Y * q - 1')" "$1_inverse_root"
    row "glint_unit_q15$2" 'ulp Q15' "$(stated src/number/fixed.h "$4")" "$(unit_bound "$1")" "$1_unit_q15"
    row "glint_unit_q28$2" 'ulp Q28' "$(stated src/number/fixed.h "$5")" "$(unit_q28_bound "$1")" "$1_unit_q28"
    row "glint_power_q15$2" absolute "$(stated src/number/fixed.h "$6")" "$(larger "$1_power" power)" "$1_power"
}
table_rows large '' 'within one of 192 cells. Relative error at most' 'Error of a component at most' 'in Q28 with an error of at most' \
    'Error at most'
table_rows small ', small tables' 'and two Newton steps. Relative error at most' \
    'Error of a component with GLINT_SMALL_TABLES at most' 'in Q28 with an error of at most' \
    'for any exponent; with GLINT_SMALL_TABLES at most'
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
solve "edges: sign of E' = sign of E, L = 2881" edges unsat edge_identity.smt2
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
