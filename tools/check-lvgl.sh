#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# tools/check-lvgl.sh BUILD COMPILER FLAGS...: compiles examples/lvgl_canvas against LVGL's own headers, which the Rust
# package lvgl-sys carries: cargo fetches it into BUILD/lvgl. Without cargo, or if it cannot fetch, against the few
# declarations of examples/lvgl_canvas/stand_in. Nothing is linked.
set -euo pipefail

build=$1
shift
version=0.6.2 # has LVGL 8.3.5
folder=$build/lvgl
source=examples/lvgl_canvas/teapot_canvas.c

mkdir -p "$folder/src"
printf '[package]\nname = "lvgl-headers"\nversion = "0.0.0"\nedition = "2021"\n[dependencies]\nlvgl-sys = "=%s"\n' \
    $version >"$folder/Cargo.toml"
echo 'fn main() {}' >"$folder/src/main.rs"

headers() {
    find "$folder/cargo/registry/src" -maxdepth 4 -path "*/lvgl-sys-$version/vendor/lvgl" 2>/dev/null | head -n 1 || true
}

if [ -z "$(headers)" ] && command -v cargo >/dev/null; then
    (cd "$folder" && CARGO_HOME=$PWD/cargo timeout 120 cargo fetch --quiet) >"$folder/fetch.txt" 2>&1 || true
fi
lvgl=$(headers)
if [ -n "$lvgl" ]; then
    "$@" -DLV_CONF_SKIP -DLV_COLOR_DEPTH=16 -isystem "$lvgl" -c $source -o "$folder/teapot_canvas.o"
    echo "$source compiles against LVGL $(awk '/define LVGL_VERSION_(MAJOR|MINOR|PATCH) / { v = v sep $3; sep = "." }
        END { print v }' "$lvgl/lvgl.h")"
else
    "$@" -isystem examples/lvgl_canvas/stand_in -c $source -o "$folder/teapot_canvas.o"
    echo "$source compiles against the stand-in only: cargo is not there, or cannot fetch lvgl-sys"
fi
