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
exit $status
