#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes every built-in mesh: regenerate.sh GENERATOR DIRECTORY
# With examples/meshes as the directory it makes the committed files; continuous integration writes them elsewhere and
# compares. A file is put in place only when it is complete.
set -eu

if [ $# -ne 2 ] || [ ! -x "$1" ] || [ ! -d "$2" ]; then
    echo "usage: $0 GENERATOR DIRECTORY, with the generate-mesh program and a directory that exists" >&2
    exit 2
fi
generator=$1
directory=$2

mesh() { # FILE SHAPE [NUMBER...]: the mesh's name is glint_mesh_FILE
    file=$1
    shift
    "$generator" "$@" "glint_mesh_$file" >"$directory/$file.c.part" || {
        status=$?
        rm -f "$directory/$file.c.part"
        exit $status
    }
    mv "$directory/$file.c.part" "$directory/$file.c"
}

mesh sphere_10x6 sphere 10 6
mesh sphere_24x12 sphere 24 12
mesh sphere_32x16 sphere 32 16
mesh sphere_64x32 sphere 64 32
mesh bowl bowl 32 8
mesh teapot teapot 8
mesh teapot_small teapot 4
mesh torus_knot torus-knot 2 3 96 12
mesh torus_knot_small torus-knot 2 3 64 10
mesh box box
mesh plane plane 8
mesh globe_32x16 globe 32 16
mesh floor_1 floor 1 12
mesh floor_8 floor 8 12
