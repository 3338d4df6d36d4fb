#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The atlas's runs. A run is kept while what it ran is the same: REPORT.of has the program's checksum.
#
#     tools/atlas/run.sh frames BUILD TARGET PROGRAM REPORT    an empty program did not fit; then the report is empty too
#     tools/atlas/run.sh judge JUDGE TABLE REPORT...           the rows of a scene, FOLDER/TARGET.txt each
#     tools/atlas/run.sh merge ATLAS SCENE...                  ATLAS/frames.csv and memory.csv of all scenes
set -euo pipefail

same() { # INPUTS... -- REPORT
    [ -f "$report" ] && [ -f "$report.of" ] && [ "$(cksum "$@")" = "$(cat "$report.of")" ]
}

verb=$1
shift
case $verb in
frames)
    build=$1 target=$2 program=$3 report=$4
    mkdir -p "${report%/*}"
    if same "$program"; then
        touch "$report"
        exit 0
    fi
    rm -f "$report" "$report.of"
    echo "  COUNT $report"
    if [ ! -s "$program" ]; then
        : >"$report"
    elif [ "$target" = host ]; then
        "$program" >"$report.part" && mv "$report.part" "$report"
    else
        tools/cost/run.sh run "$build" "$target" "$program" "$report" any-ram
    fi
    cksum "$program" >"$report.of"
    ;;
judge)
    judge=$1 table=$2
    shift 2
    reports=()
    for report in "$@"; do
        if [ -s "$report" ]; then
            name=${report##*/}
            reports+=("${name%.txt}" "$report")
        fi
    done
    "$judge" "${table%.csv}-details.csv" "${reports[@]}" >"$table.part"
    mv "$table.part" "$table"
    ;;
merge)
    atlas=$1
    shift
    tables=() reports=()
    for scene in "$@"; do
        tables+=("$atlas/frames/$scene/frames.csv")
        reports+=("$atlas/frames/$scene/"*.txt)
    done
    awk -f tools/atlas/frames.awk tools/atlas/targets.txt "$atlas"/frames/*/host.txt "${tables[@]}" >"$atlas/frames.csv.part"
    mv "$atlas/frames.csv.part" "$atlas/frames.csv"
    {
        echo "target,scene,backend,shading,tolerance,least_bytes,full_bytes,used_bytes"
        for report in "${reports[@]}"; do
            name=${report##*/}
            awk -v target="${name%.txt}" '$1 == "memory" {
                print target "," $2 "," $3 "," $4 "," ($5 == "-" ? "" : $5) "," $6 "," $7 "," ($8 ? $8 : "")
            }' "$report"
        done
    } >"$atlas/frame-memory.csv"
    ;;
*)
    echo "usage: tools/atlas/run.sh frames BUILD TARGET PROGRAM REPORT | judge JUDGE TABLE REPORT... | merge ATLAS SCENE..." >&2
    exit 2
    ;;
esac
