#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Refreshes the figures of the documents: what stands between a line <!-- NAME: ... --> and the next <!-- end --> is
# replaced in README.md and docs/performance.md.
#
#     tools/cost/pages.sh BUILD        BUILD/cost has what `make cost` wrote, and BUILD/cost/m0plus/profile.elf
set -euo pipefail

build=$1
table=$build/cost/cost.csv
cases=("A fixed auto 1" "A fixed exact" "A fixed Gouraud" "B fixed flat")

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

awk -f tools/cost/pages.awk "$table" >"$work/tolerance"
tools/replace-marked.sh README.md cost-table "$work/tolerance"

{
    echo '```'
    awk -f tools/cost/goals.awk "$build/cost/details.csv" tools/cost/peers.csv "$table" | sed 's/ M; [a-z].*/ M/'
    echo '```'
} >"$work/goals"
tools/replace-marked.sh docs/performance.md goals "$work/goals"

for i in "${!cases[@]}"; do
    node tools/cost/rp2040.js "$build/cost/node" "$build/cost/m0plus/profile.elf" --profile "${cases[i]}" >"$work/case"
    sed -n '1s/.*: \([0-9]*\) instructions.*/\1 sum/p; /^By stage/,$p' "$work/case" >>"$work/profiles"
done
awk '
    / sum$/ { count++; sum[count] = $1; next }
    /^By stage/ || /^instructions/ || NF == 0 { next }
    {
        name = $4
        for (i = 5; i <= NF; i++) { name = name " " $i }
        if (!(name in known)) { known[name] = 1; order[++names] = name }
        part[name, count] = $1
        share[name, count] = $2
    }
    function cell(name, i) { return (name, i) in part ? sprintf("%.3f (%s %%)", part[name, i] / 1e6, share[name, i]) : "" }
    END {
        print "| stage | A, tolerance 1 | A, exact | A, Gouraud | B, flat |"
        print "|---|---|---|---|---|"
        for (n = 1; n <= names; n++) {
            text = "| " order[n] " |"
            for (i = 1; i <= count; i++) { text = text " " cell(order[n], i) " |" }
            if (order[n] != "other") { print text }
        }
        text = "| all |"
        for (i = 1; i <= count; i++) { text = text sprintf(" %.3f |", sum[i] / 1e6) }
        print text
    }' "$work/profiles" >"$work/stages"
tools/replace-marked.sh docs/performance.md stages "$work/stages"
