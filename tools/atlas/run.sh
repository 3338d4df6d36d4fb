#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The atlas's runs. A run is kept while what it ran is the same: REPORT.of has the checksum of the program's code and data.
#
#     tools/atlas/run.sh frames BUILD TARGET PROGRAM REPORT    an empty program did not fit; then the report is empty too
#     tools/atlas/run.sh judge JUDGE TABLE REPORT...           the rows of a scene, FOLDER/TARGET.txt each
#     tools/atlas/run.sh merge ATLAS SCENE...                  ATLAS/frames.csv and frame-memory.csv of all scenes
#     tools/atlas/run.sh routines ATLAS TARGET...              ATLAS/routines.csv
#     tools/atlas/run.sh stages BUILD SCENE TABLE PROGRAM STAGES          profiles of the scene's frames
#     tools/atlas/run.sh pictures BUILD ATLAS SCENE VARIABLE SIZE         ATLAS/pictures/SCENE/...
#     tools/atlas/run.sh size|effects BUILD TABLE COMMAND...   what COMMAND, a make, finds; a table without rows if it fails
#     tools/atlas/run.sh how CC FLAGS RP2040JS [PROCESSOR CC FLAGS]...    versions
#     tools/atlas/run.sh variable SCENE                        of a built-in scene
#     tools/atlas/run.sh snapshot ATLAS FOLDER                 what is committed; the README's words
#     tools/atlas/run.sh check ATLAS FOLDER SCENE...           is what is committed well formed, and are its errors those of
#                                                              fresh frames? ATLAS/programs/SCENE/judge draws them
set -euo pipefail

# Of what a program loads; not of what is for debuggers, which names lines.
image() { # TARGET PROGRAM
    local objcopy=objcopy
    case $1 in
    m*) objcopy=arm-none-eabi-objcopy ;;
    rv*) objcopy=riscv64-unknown-elf-objcopy ;;
    avr*) objcopy=avr-objcopy ;;
    esac
    if [ -s "$2" ]; then "$objcopy" -O binary -R .note.gnu.build-id "$2" "$report.image" && cksum <"$report.image" && rm -f "$report.image"; else echo none; fi
}

# Is there a report of what has this checksum? As new, for make.
is_kept() {
    [ -f "$report" ] && [ "$1" = "$(cat "$report.of" 2>/dev/null)" ] && touch "$report"
}

# The built-in scenes, a line each: its name, its variable.
built_in() {
    awk '
        /^    \{"/ { row = "" }
        { row = row $0 }
        /^ +.*\},$/ && row ~ /^    \{"/ {
            name = row
            sub(/^ *\{"/, "", name)
            sub(/".*/, "", name)
            match(row, /&[a-z_0-9]+/)
            print name, substr(row, RSTART + 1, RLENGTH - 1)
        }' examples/scenes/table.c
}

words() {
    awk -f tools/atlas/words.awk "$1/frames.csv" tools/cost/peers.csv "$1/routines.csv"
}

verb=$1
shift
case $verb in
frames)
    build=$1 target=$2 program=$3 report=$4
    mkdir -p "${report%/*}"
    key=$(image "$target" "$program")
    is_kept "$key" && exit 0
    rm -f "$report" "$report.of"
    echo "  COUNT $report"
    if [ ! -s "$program" ]; then
        : >"$report"
    elif [ "$target" = host ]; then
        "$program" >"$report.part" && mv "$report.part" "$report"
    else
        tools/cost/run.sh run "$build" "$target" "$program" "$report" any-ram
    fi
    if [ -n "${ATLAS_OWN:-}" ] && grep -q '^failed' "$report"; then
        echo "$target: the parts of the library that fit it do not draw this scene: its frames are left out" >&2
        : >"$report"
    fi
    echo "$key" >"$report.of"
    ;;
judge)
    judge=$1 table=$2
    shift 2
    reports=()
    for report in "$@"; do
        if [ -s "$report" ]; then
            name=${report##*/}
            name=${name%.txt}
            reports+=("${name%+*}" "$report")
        fi
    done
    "$judge" "${table%.csv}-details.csv" "${reports[@]}" >"$table.part"
    mv "$table.part" "$table"
    ;;
merge)
    atlas=$1
    shift
    tables=() reports=() details=()
    for scene in "$@"; do
        details+=("$atlas/frames/$scene/frames-details.csv")
        tables+=("$atlas/frames/$scene/frames.csv")
        reports+=("$atlas/frames/$scene/"*.txt)
    done
    awk -f tools/atlas/frames.awk tools/atlas/targets.txt "$atlas"/frames/*/host.txt "${details[@]}" "${tables[@]}" >"$atlas/frames.csv.part"
    mv "$atlas/frames.csv.part" "$atlas/frames.csv"
    {
        echo "target,scene,backend,shading,tolerance,least_bytes,full_bytes,used_bytes"
        for report in "${reports[@]}"; do
            name=${report##*/}
            name=${name%.txt}
            awk -v target="${name%+*}" '$1 == "memory" {
                print target "," $2 "," $3 "," $4 "," ($5 == "-" ? "" : $5) "," $6 "," $7 "," ($8 ? $8 : "")
            }' "$report"
        done
    } >"$atlas/frame-memory.csv"
    ;;
routines)
    atlas=$1
    shift
    {
        echo "target,unit,routine,variant,origin,table_bytes,average,worst,error_ulp,error_inputs"
        for tables in full small; do
            reports=()
            for target in "$@"; do reports+=("$target" "$atlas/routines/$target-$tables.txt"); done
            "$atlas/programs/judge-routines-$tables" "${reports[@]}" host -
        done
    } >"$atlas/routines.csv.part"
    mv "$atlas/routines.csv.part" "$atlas/routines.csv"
    ;;
stages)
    build=$1 scene=$2 report=$3
    shift 3
    program=$1
    mkdir -p "${report%/*}"
    key=$(image m0plus "$program")$(cksum "$2" tools/cost/rp2040.js)
    is_kept "$key" && exit 0
    echo "  PROFILE $scene"
    for shading in exact Gouraud flat "auto 1"; do
        node tools/cost/rp2040.js "$build/cost/node" "$program" --profile "$scene fixed $shading" | awk \
            -v scene="$scene" -v shading="${shading% *}" -v tolerance="${shading#"${shading% *}"}" '
            BEGIN { sub(/ /, "", tolerance) }
            /^By stage/ { on = 1; next }
            on && $1 ~ /^[0-9]+$/ {
                stage = $0
                sub(/^ *[0-9]+ +[0-9.]+ +[0-9]+ +/, "", stage)
                gsub(/,/, ";", stage)
                print scene ",fixed," shading "," tolerance "," stage "," $1 "," $3
            }'
    done >"$report.part"
    mv "$report.part" "$report"
    echo "$key" >"$report.of"
    ;;
pictures)
    build=$1 folder=$2/pictures/$3 variable=$4 size=$5
    mkdir -p "$folder"
    name=$(built_in | awk -v variable="$variable" '$2 == variable { print $1 }')
    echo "  PICTURES $3"
    "$build/glint-render" "$name" --size "$size" --tolerance 1 --tiers "$folder/tiers.png" -o "$folder/frame.png"
    "$build/glint-render" "$name" --size "$size" --shading gouraud -o "$folder/gouraud.png"
    "$build/glint-render" "$name" --size "$size" --backend reference -o "$folder/reference.png"
    for kind in frame gouraud; do
        "$build/glint-compare" "$folder/$kind.png" "$folder/reference.png" --amplify 32 --picture "$folder/$kind-off.png"
    done >"$folder/done"
    ;;
size)
    build=$1 table=$2
    shift 2
    mkdir -p "${table%/*}"
    if ! "$@" >"$table.log" 2>&1; then
        echo "make atlas: the sizes of variants are left out, as make size fails: $table.log" >&2
        : >"$build/cross/size.txt"
    fi
    {
        echo "program,text,rodata,data,bss,flash"
        awk '$1 !~ /:/ && NF == 6 { print $1 "," $2 "," $3 "," $4 "," $5 "," $6 }' "$build/cross/size.txt"
    } >"$table.part"
    mv "$table.part" "$table"
    ;;
effects)
    build=$1 table=$2
    shift 2
    mkdir -p "${table%/*}"
    rm -f "$build/effects/effects.csv"
    "$@" >"$table.log" 2>&1 || echo "make atlas: make effects does not hold: $table.log" >&2
    if [ -f "$build/effects/effects.csv" ]; then
        cp "$build/effects/effects.csv" "$table"
    else
        echo "make atlas: what effects add is left out" >&2
        : >"$table"
    fi
    ;;
how)
    version() { command -v "$1" >/dev/null && { "$@" 2>&1 | head -n 1 | tr ',"' '; '; } || echo "not there"; }
    echo "what,is"
    echo "host compiler,$(version "$1" --version); $2"
    echo "Cortex-M emulator,$(version qemu-system-arm --version)"
    echo "RV32IMAC emulator,$(version qemu-system-riscv32 --version)"
    echo "RP2040 emulator,rp2040js $3 on node $(version node --version)"
    echo "AVR emulator,$(command -v simavr >/dev/null && dpkg-query -W -f 'simavr ${Version}' simavr 2>/dev/null || echo simavr)"
    echo "plots,$(version gnuplot --version)"
    shift 3
    while [ $# -gt 0 ]; do
        echo "$1 compiler,$(version "$2" --version); $3"
        shift 3
    done
    ;;
variable)
    built_in | awk -v name="$1" '$1 == name { print $2 }'
    ;;
snapshot)
    atlas=$1 folder=$2
    mkdir -p "$folder"
    rm -f "$folder"/*.csv
    cp "$atlas"/index.html "$atlas"/front.svg "$atlas"/*.csv "$folder"
    words "$folder" >"$atlas/words"
    tools/replace-marked.sh README.md atlas "$atlas/words"
    echo "Written: $folder, $(du -sk "$folder" | cut -f 1) KB, and the atlas's words of README.md"
    ;;
check)
    atlas=$1 folder=$2
    shift 2
    good=1
    for scene in "$@"; do
        "$atlas/programs/$scene/judge" errors >"$atlas/programs/$scene/errors.csv" || good=
    done
    fresh=()
    for scene in "$@"; do fresh+=("$atlas/programs/$scene/errors.csv"); done
    awk -f tools/atlas/check.awk "${fresh[@]}" "$folder/frames.csv" || good=
    awk -f tools/atlas/check_page.awk "$folder/index.html" || good=
    words "$folder" >"$atlas/words"
    awk 'inside && /^<!-- end -->/ { exit } inside && NF { print } /^<!-- atlas: / { inside = 1 }' README.md |
        cmp -s - "$atlas/words" || { echo "README.md does not say what $folder teaches: make atlas-snapshot" >&2; good=; }
    [ -n "$good" ] && echo "same  $folder: errors of the fixed backend, words"
    ;;
*)
    sed -n 's/^#     /usage: /p' "$0" >&2
    exit 2
    ;;
esac
