#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# The page: tools/atlas/page.sh ATLAS, from ATLAS/*.csv and ATLAS/pictures; writes ATLAS/index.html, advice.csv, peers.csv, and
# front.svg, the plot of scene A on the Cortex-M0+ alone.
set -euo pipefail

atlas=$1
here=tools/atlas
peers=tools/cost/peers.csv
targets=$here/targets.txt
work=$atlas/page
rm -rf "$work"
mkdir -p "$work"

echo "  PAGE  $atlas/index.html"
grep -v '^#' $peers >"$atlas/peers.csv"
awk -v form=csv -f $here/advice.awk $targets "$atlas/frames.csv" >"$atlas/advice.csv"
{
    awk -v folder="$work" -f $here/plot_labels.awk -f $here/plot_frames.awk $targets $peers "$atlas/frames.csv"
    awk -v folder="$work" -f $here/plot_labels.awk -f $here/plot_routines.awk $targets "$atlas/routines.csv"
    awk -v folder="$work" -v kind=stages -f $here/plot_bars.awk $here/groups.txt "$atlas/stages.csv"
    for kind in size effects; do
        [ ! -s "$atlas/$kind.csv" ] || awk -v folder="$work" -v kind=$kind -f $here/plot_bars.awk "$atlas/$kind.csv"
    done
} >"$work/plots.gp"
if ! command -v gnuplot >/dev/null; then
    echo "make atlas: gnuplot is not there (package gnuplot-nox): no page; the CSV files are in $atlas" >&2
    exit 1
fi
gnuplot "$work/plots.gp"

# The shapes of points come once, with what is shown first.
shapes=1
plot() { # NAME: a plot, if there is one
    [ -s "$work/$1.svg" ] || return 0
    echo '<div class="plot">'
    awk -v defs=$shapes -f $here/plot_svg.awk "$work/$1.svg"
    echo '</div>'
    shapes=0
}

picture() { # FILE CAPTION
    printf '<figure><img alt="%s" src="data:image/png;base64,%s"><figcaption>%s</figcaption></figure>\n' "$2" \
        "$(base64 <"$1" | tr -d '\n')" "$2"
}

mapfile -t scenes < <(awk -F , 'NR > 1 && !seen[$3]++ { print $3 }' "$atlas/frames.csv")
mapfile -t present < <(awk -F , 'NR == FNR { if (FNR > 1) { there[$1] = 1 } next } { split($0, word, / +/) }
    !/^#/ && (word[1] in there) { print word[1] }' "$atlas/frames.csv" $targets)
mapfile -t routines < <(awk -F , 'NR > 1 && !seen[$3]++ { print $3 }' "$atlas/routines.csv")

details() { # SUMMARY: a table on standard input, folded
    echo "<details><summary>$1</summary><div class=\"table\">"
    cat
    echo '</div></details>'
}

frames() {
    for scene in "${scenes[@]}"; do
        echo "<h3>$(awk -v name="$scene" '$1 == name { print $1 ", " $3 " pixels" ($4 ? " in bands of " $4 " rows" : "") }' "$list")</h3>"
        if [ -f "$atlas/pictures/$scene/done" ]; then
            echo '<div class="pictures">'
            picture "$atlas/pictures/$scene/frame.png" "Drawn with a tolerance of 1 code, fixed point"
            picture "$atlas/pictures/$scene/tiers.png" "How it was shaded: flat light grey, curved cyan, q1 green, q2 yellow, exact red"
            picture "$atlas/pictures/$scene/frame-off.png" "Its difference from the reference, times 32"
            picture "$atlas/pictures/$scene/gouraud-off.png" "That of Gouraud shading, times 32"
            echo '</div>'
        fi
        echo '<div class="plots">'
        for target in "${present[@]}"; do plot "$scene-$target"; done
        echo '</div>'
        awk -v scene="$scene" -v part=advice -f $here/page_tables.awk $targets "$atlas/advice.csv" |
            details "The cheapest choice within each error"
        awk -v scene="$scene" -v part=frames -f $here/page_tables.awk $targets "$atlas/frames.csv" |
            details "All frames as numbers"
    done
    echo '<h3>Other renderers</h3>'
    sed -n 's/^# \{0,1\}//p' $peers | tr '\n' ' ' | sed 's/.*How: /<p>How they were measured: /; s/$/<\/p>/'
    awk -v part=plain -f $here/page_tables.awk $targets "$atlas/peers.csv" | details "Their figures and sources"
}

list=${2:-$here/scenes.txt}
frames >"$work/frames"
shapes=0
for routine in "${routines[@]}"; do
    echo '<div class="plots">'
    for target in "${present[@]}"; do plot "$routine-$target"; done
    echo '</div>'
    awk -v scene="$routine" -v part=routines -f $here/page_tables.awk $targets "$atlas/routines.csv" |
        details "${routine//-/ } as numbers"
done >"$work/routines"
{
    echo '<div class="plots">'
    for scene in "${scenes[@]}"; do plot "stages-$scene"; done
    echo '</div>'
    awk -v part=stages -f $here/page_tables.awk $targets "$atlas/stages.csv" | details "All stages as numbers"
} >"$work/stages-part"
{
    if [ -s "$atlas/size.csv" ]; then
        echo '<div class="plots">'
        plot size
        plot effects
        echo '</div>'
        cat <<'TEXT'
<ul class="legend"><li>Of variants: <i style="background:var(--fixed)"></i> code <i style="background:var(--float)"></i> constants</li>
<li>Of parts: <i style="background:var(--fixed)"></i> Cortex-M0+, fixed <i style="background:var(--float)"></i> Cortex-M4F, float</li></ul>
<p>Of a variant it is the whole program, its scene and its start-up code included: a backend, or a variant of it with fewer
parts. Of a part it is what a program with it is larger by than one without. The library has no variables: its RAM is what
the caller gives, and the stack.</p>
TEXT
        awk -v part=plain -f $here/page_tables.awk $targets "$atlas/size.csv" | details "Sizes of variants, bytes"
        awk -v part=plain -f $here/page_tables.awk $targets "$atlas/effects.csv" |
            details "What each part adds: flash and memory in bytes; instructions of a frame that does not use it, not linked and linked; of one that does; errors in codes"
    else
        echo '<p>Flash of variants and effects is not within a quick run.</p>'
    fi
    awk -v part=memory -f $here/page_tables.awk $targets "$atlas/frame-memory.csv" |
        details "RAM that a frame takes of its caller, bytes: the least; with all vertices and lists; what it used"
} >"$work/memory"
awk -v part=plain -f $here/page_tables.awk $targets "$atlas/how.csv" >"$work/how"
if [ -s "$atlas/missing.txt" ]; then
    echo '<div class="missing"><p>Not counted, for want of what it takes:</p><ul>'
    sed 's/&/\&amp;/g; s/</\&lt;/g; s/: its rows are left out//; s/.*/<li>&<\/li>/' "$atlas/missing.txt"
    echo '</ul></div>'
fi >"$work/missing"
cat >"$work/legend" <<'TEXT'
<ul class="legend">
<li><svg viewBox="-2 -2 4 4"><use href="#gpPt6"/></svg> exact</li>
<li><svg viewBox="-2 -2 4 4"><use href="#gpPt4"/></svg> q2</li>
<li><svg viewBox="-2 -2 4 4"><use href="#gpPt8"/></svg> q1</li>
<li><svg viewBox="-2 -2 4 4"><use href="#gpPt12"/></svg> Gouraud</li>
<li><svg viewBox="-2 -2 4 4"><use href="#gpPt10"/></svg> flat</li>
<li><svg viewBox="-2 -2 4 4"><use href="#gpPt5"/></svg> within a tolerance</li>
<li><i style="background:var(--fixed)"></i> fixed point (labelled)</li>
<li><i style="background:var(--float)"></i> float</li>
<li><svg viewBox="-2 -2 4 4" style="color:var(--peer)"><use href="#gpPt1"/></svg> other renderers</li>
<li><i class="line" style="background:var(--front)"></i> Pareto front</li>
</ul>
TEXT

awk -v work="$work" '
    /^@[a-z]*@$/ {
        name = substr($0, 2, length($0) - 2)
        file = work "/" (name == "stages" ? "stages-part" : name)
        while ((getline line < file) > 0) { print line }
        close(file)
        next
    }
    { print }' $here/page.html >"$atlas/index.html.part"
mv "$atlas/index.html.part" "$atlas/index.html"

# For where a picture stands alone, in either light.
if [ -s "$work/A-m0plus.svg" ]; then
    awk -v defs=1 -f $here/plot_svg.awk "$work/A-m0plus.svg" | sed 's|<svg \([^>]*\)>|<svg \1 width="630" height="510"><style>svg{font:11px sans-serif;background:var(--page)}:root{--page:#fff;--ink:#1b2430;--grid:#d5dce5;--fixed:#1763b6;--float:#c2570c;--peer:#7a3fa0;--front:#b5dcc0}@media (prefers-color-scheme:dark){:root{--page:#12161c;--ink:#e3e9f0;--grid:#313a46;--fixed:#6fb0f5;--float:#f29a55;--peer:#c79aea;--front:#2f5f3f}}</style>|' >"$atlas/front.svg"
fi
rm -rf "$work"
