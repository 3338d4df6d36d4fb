#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The figures of tools/figures.txt:
#
#     tools/figures.sh draw BUILD ENDING [FIGURE]   draws all, or one, into BUILD/figures as .ppm or .png
#     tools/figures.sh page                         prints docs/figures.md
#     tools/figures.sh names                        prints the figures' names
#
# A part whose last word is --tiers shows how its pixels were shaded instead of the picture.
set -eu
table=tools/figures.txt

# What glint-render is called with for a part's words, but for the file.
arguments() {
    case " $* " in
    *" --size "*) echo "$*" ;;
    *)
        scene=$1
        shift
        echo "$scene --size 240x180${*:+ }$*"
        ;;
    esac
}

names() {
    awk '$1 == "figure" { print $2 }' "$table"
}

finish_sheet() { # uses what draw() keeps of the figure that it has gone through
    case $count in
    0) ;;
    1) cp "$parts" "$out/$name.$ending" ;;
    *) # shellcheck disable=SC2086 # labels have no spaces
        "$build/contact-sheet" --tile 240 --columns "$columns" -o "$out/$name.$ending" $parts ;;
    esac
    count=0
    parts=
}

draw() {
    build=$1 ending=$2 only=${3:-}
    out=$build/figures
    name='' columns='' parts='' count=0
    while read -r word rest; do
        case $word in
        figure)
            finish_sheet
            name=${rest% *} columns=${rest#* }
            ;;
        part)
            [ -z "$only" ] || [ "$only" = "$name" ] || continue
            folder=$out/parts/$name
            file=$folder/${rest%% *}.$ending
            mkdir -p "$folder"
            # shellcheck disable=SC2046,SC2086 # words of the table
            case $rest in
            *--tiers) "$build/glint-render" $(arguments ${rest#* }) "$file" -o "$folder/unused.$ending" ;;
            *) "$build/glint-render" $(arguments ${rest#* }) -o "$file" ;;
            esac
            parts="$parts${parts:+ }$file"
            count=$((count + 1))
            ;;
        esac
    done <"$table"
    finish_sheet
}

page() {
    echo '# Figures'
    echo
    echo '<!-- Made by: tools/figures.sh page > docs/figures.md -->'
    echo
    echo 'Every figure of the lecture slides that this library follows, and every effect off and on, drawn by the fixed'
    echo 'backend. `make figures` draws them all into `build/figures`, `make figures FIGURE=phong` draws one; the commands'
    echo 'below each draw its parts. [tools/figures.txt](../tools/figures.txt) is the list.'
    text=
    while read -r word rest; do
        case $word in
        chapter) printf '\n## %s\n' "$rest" ;;
        figure) name=${rest% *} ;;
        title) printf '\n### %s\n\n' "$rest" && text= ;;
        text) printf '%s\n' "$rest" ;;
        part)
            [ -n "$text" ] || printf '\n![%s](figures/%s.png)\n\n' "$name" "$name"
            text=done
            # shellcheck disable=SC2086 # words of the table
            case $rest in
            *--tiers) printf '    build/glint-render %s %s.png -o picture.png\n' "$(arguments ${rest#* })" "${rest%% *}" ;;
            *) printf '    build/glint-render %s -o %s.png\n' "$(arguments ${rest#* })" "${rest%% *}" ;;
            esac
            ;;
        esac
    done <"$table"
}

case ${1:-} in
draw | page | names) "$@" ;;
*)
    echo "usage: tools/figures.sh draw BUILD ENDING [FIGURE] | page | names" >&2
    exit 2
    ;;
esac
