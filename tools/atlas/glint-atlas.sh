#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# What accuracy costs for a scene of one's own: counts its frames in each way on the host and the emulators that are
# installed, with the rules of atlas.mk, and prints the advice. The tree that it was made in is what it builds from.
set -euo pipefail

tree=@TREE@
build=@BUILD@
usage="usage: glint-atlas SCENE|MODEL [--size WxH] [--band ROWS] [--float]

SCENE is a built-in scene (glint-render --list), MODEL a model file (.obj, .gltf, .glb, .dae).
  --size WxH   pixels, each 1..2048 (default: the scene's own size; 320x240 for a file)
  --band ROWS  rows in a band (default: the whole frame)
  --float      counts the float backend also where the processor has no floating-point unit
Prints for each processor the cheapest choice within each error, and the knee of the curve."

wrong() {
    printf 'glint-atlas: %s\n%s\n' "$1" "$usage" >&2
    exit 2
}

scene='' size='' band='' quick=yes
while [ $# -gt 0 ]; do
    case $1 in
    --help)
        echo "$usage"
        exit 0
        ;;
    --float) quick= ;;
    --size | --band)
        [ $# -gt 1 ] || wrong "a value is expected after $1"
        if [ "$1" = --size ]; then size=$2; else band=$2; fi
        shift
        ;;
    -*) wrong "unknown option: $1" ;;
    *)
        [ -z "$scene" ] || wrong "one SCENE or MODEL expected, a second one given: $1"
        scene=$1
        ;;
    esac
    shift
done
[ -n "$scene" ] || wrong "SCENE or MODEL expected"
in_range() { [[ $1 =~ ^[1-9][0-9]{0,3}$ ]] && [ "$1" -le 2048 ]; }
if [ -n "$size" ] && ! { in_range "${size%%x*}" && in_range "${size#*x}"; }; then
    wrong "--size: WxH was expected, each from 1 to 2048, not $size"
fi
[ -z "$band" ] || in_range "$band" || wrong "--band: rows from 1 to 2048 were expected, not $band"

model=
[ ! -f "$scene" ] || model=$(realpath "$scene")
cd "$tree"
run_make() { make --no-print-directory -j"$(getconf _NPROCESSORS_ONLN)" B="$build" "$@" >&2; }
run_make -s "$build/glint-render" "$build/glint-import"

row=$("$build/glint-render" --list | awk -v name="$scene" '$1 == name')
if [ -n "$row" ] && [ -z "$model" ]; then
    variable=$(tools/atlas/run.sh variable "$scene")
    name=$scene
    size=${size:-$(echo "$row" | awk '{ print $2 }')}
elif [ -n "$model" ]; then
    variable=own_scene
    size=${size:-320x240}
    name=$(basename "$scene" | tr -c 'A-Za-z0-9\n' - | cut -c 1-24)
else
    wrong "neither a built-in scene nor a file: $scene"
fi
name=$name-$size${band:+-bands$band}
folder=$build/atlas-own/$name
mkdir -p "$folder"
source=
if [ -n "$model" ]; then
    source=$folder/own.c
    "$build/glint-import" "$model" -o "$source.new" --name own >&2 || exit $?
    # the same scene again keeps what was counted
    cmp -s "$source.new" "$source" || cp "$source.new" "$source"
fi
echo "$name $variable $size ${band:-0} all $source" >"$folder/scenes.new"
cmp -s "$folder/scenes.new" "$folder/scenes.txt" || cp "$folder/scenes.new" "$folder/scenes.txt"

export ATLAS_OWN=yes
run_make QUICK="$quick" ATLAS_OWN=yes ATLAS="$folder" ATLAS_LIST="$folder/scenes.txt" run-atlas-frames
awk -v form=words -f tools/atlas/advice.awk tools/atlas/targets.txt "$folder/frames.csv"
echo "All frames: $tree/$folder/frames.csv"
