#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Makes every generated file again and compares: tools/check-generated.sh BUILD [MESH_GENERATOR]
set -euo pipefail

build=$1
mesh_generator=${2:-}
out=$build/generated
rm -rf "$out"
mkdir -p "$out/meshes"
status=0

compare() {
    if cmp -s "$1" "$2"; then
        echo "same  $1"
    else
        echo "differs from what its generator makes ($2): $1" >&2
        status=1
    fi
}

if [ -x "$build/generate-tables" ] && [ -f src/number/tables.c ]; then
    "$build/generate-tables" >"$out/tables.c"
    compare src/number/tables.c "$out/tables.c"
fi
if [ -x "$build/generate-environment" ] && [ -f examples/scenes/environment_sky.c ]; then
    "$build/generate-environment" 64 >"$out/environment_sky.c"
    compare examples/scenes/environment_sky.c "$out/environment_sky.c"
fi
if [ -n "$mesh_generator" ] && [ -f tools/mesh/regenerate.sh ]; then
    sh tools/mesh/regenerate.sh "$mesh_generator" "$out/meshes" >"$out/log" 2>&1 || {
        cat "$out/log" >&2
        exit 1
    }
    made=0
    for file in "$out"/meshes/*; do
        [ -e "$file" ] || continue
        made=$((made + 1))
        compare "examples/meshes/${file##*/}" "$file"
    done
    [ "$made" -gt 0 ] || {
        echo "tools/mesh/regenerate.sh made no file" >&2
        status=1
    }
fi
if [ -x "$build/generate-textures" ]; then
    for file in examples/textures/*.c; do
        name=${file##*/}
        "$build/generate-textures" "${name%.c}" >"$out/$name"
        compare "$file" "$out/$name"
    done
fi

# The figures: their page, that each has a picture and no other is there, and the pictures' pixels, where PNG can be read
tools/figures.sh page >"$out/figures.md"
compare docs/figures.md "$out/figures.md"
tools/figures.sh names | sort >"$out/names"
(cd docs/figures && ls) | sed 's/\.png$//' | sort >"$out/pictures"
compare "$out/pictures" "$out/names"
for name in $(grep -o 'figures/[a-z0-9-]*\.png' docs/effects.md | sed 's|.*/||; s|\.png$||'); do
    grep -qx "$name" "$out/names" || {
        echo "docs/effects.md shows a figure that is not in tools/figures.txt: $name" >&2
        status=1
    }
done
if tools/figures.sh draw "$build" png 2>"$out/log"; then
    while read -r name; do
        if "$build/glint-compare" "$build/figures/$name.png" "docs/figures/$name.png" --max 0 >"$out/log"; then
            echo "same  docs/figures/$name.png"
        else
            echo "differs from what tools/figures.sh draws: docs/figures/$name.png" >&2
            status=1
        fi
    done <"$out/names"
elif grep -q libpng "$out/log"; then
    echo "figures: no libpng, so their pictures are not compared"
else
    cat "$out/log" >&2
    status=1
fi
exit $status
