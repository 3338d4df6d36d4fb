# SPDX-License-Identifier: MIT
#
# gnuplot commands for bars from the left to the right:
#
#     awk -v folder=FOLDER -v kind=stages  -f plot_bars.awk groups.txt stages.csv   where each scene's frames go, in percent
#     awk -v folder=FOLDER -v kind=size    -f plot_bars.awk size.csv                flash of the library's variants
#     awk -v folder=FOLDER -v kind=effects -f plot_bars.awk effects.csv             flash that each effect adds
BEGIN { FS = "," }
/^#/ || NF == 0 { next }
FILENAME ~ /groups\.txt$/ {
    group = $0
    sub(/: .*/, "", group)
    names = $0
    sub(/^[^:]*: /, "", names)
    groups++
    count = split(names, stage, "; ")
    for (i = 1; i <= count; i++) {
        gsub(/,/, ";", stage[i])
        group_of[stage[i]] = groups
    }
    next
}
FNR == 1 {
    for (i = 1; i <= NF; i++) { column[$i] = i }
    next
}
kind == "stages" {
    scene = value("scene")
    bar = scene SUBSEP (value("shading") == "auto" ? "≤ " value("tolerance") : value("shading"))
    if (!(scene in bars)) { plots[++plot_count] = scene }
    if (!(bar in total)) {
        bars[scene]++
        bar_of[scene, bars[scene]] = bar
    }
    g = value("stage") in group_of ? group_of[value("stage")] : 3
    part[bar, g] += value("cycles")
    total[bar] += value("cycles")
}
kind == "size" || kind == "effects" {
    bars["all"]++
    bar_of["all", bars["all"]] = kind == "size" ? $1 : value("effect")
    if (kind == "size") {
        part[bars["all"], 1] = value("text")
        part[bars["all"], 2] = value("rodata") + value("data")
    } else {
        if (value("target") != "m0plus") { bars["all"]-- }
        part[value("effect"), value("target")] = value("flash")
    }
}

function value(name) { return $column[name] }

function begin(name, width, height, left, heading, axis) {
    printf "reset\nset output '%s/%s.svg'\n", folder, name
    print "set terminal svg size " width "," height " dynamic font 'sans-serif,11'"
    printf "set margins at screen %.4f, screen %.4f, screen %.4f, screen %.4f\n", left / width, 1 - 24 / width, 52 / height, 1 - 30 / height
    print "set border 3 lc rgb '#000001'\nset tics textcolor rgb '#000001' nomirror out\nset grid x lc rgb '#000002' lw 0.6\nset style fill solid 1 noborder"
    printf "set title \"%s\" textcolor rgb '#000001' font 'sans-serif,12' offset 0,-0.4\n", heading
    printf "set xlabel '%s' textcolor rgb '#000001' offset 0,0.3\n", axis
}

function bar_row(y, from, to, half) { return sprintf("%g %g %g %g %g %g", (from + to) / 2, y, from, to, y - half, y + half) }

# A series of boxes a colour; rows collected by add().
function add(series, row) { boxes[series] = boxes[series] row "\n" }

function draw_boxes(count, first_colour,   k, list) {
    for (k = 1; k <= count; k++) {
        if (boxes[k] != "") {
            printf "$s%d << E\n%sE\n", k, boxes[k]
            list = list sprintf(", $s%d using 1:2:3:4:5:6 with boxxyerror lc rgb '#0000%02X' notitle", k, first_colour + k - 1)
        }
        boxes[k] = ""
    }
    print "plot " substr(list, 3) "\nset output"
}

function tics(list) { printf "set ytics (%s)\n", substr(list, 3) }

function draw_stages(scene,   n, bar, at, g, list, name) {
    begin("stages-" scene, 420, 190, 70, scene ": Cortex-M0+, fixed", "share of the cycles of a frame, %")
    print "set xrange [0:128]\nset xtics 0,20,100\nset yrange [" bars[scene] + 0.6 ":0.4]"
    for (n = 1; n <= bars[scene]; n++) {
        bar = bar_of[scene, n]
        name = bar
        sub(".*" SUBSEP, "", name)
        list = list ", \"" name "\" " n
        at = 0
        for (g = 1; g <= groups; g++) {
            if (part[bar, g] > 0) {
                add(g, bar_row(n, at, at + 100 * part[bar, g] / total[bar], 0.36))
                at += 100 * part[bar, g] / total[bar]
            }
        }
        printf "set label \"%.1f M\" at 102,%d left textcolor rgb '#000001' font 'sans-serif,11'\n", total[bar] / 1e6, n
    }
    tics(list)
    draw_boxes(groups, 7)
}

function draw_size(   n, list) {
    begin("size", 420, 60 + 26 * bars["all"], 130, "Flash of a variant with a small scene, -Os", "bytes")
    print "set xrange [0:*]\nset xtics 0,20000\nset format x '%g'\nset yrange [" bars["all"] + 0.6 ":0.4]"
    for (n = 1; n <= bars["all"]; n++) {
        name = bar_of["all", n]
        gsub(/_/, " ", name)
        list = list ", \"" name "\" " n
        add(1, bar_row(n, 0, part[n, 1], 0.34))
        add(2, bar_row(n, part[n, 1], part[n, 1] + part[n, 2], 0.34))
    }
    tics(list)
    draw_boxes(2, 3)
}

function draw_effects(   n, list, name) {
    begin("effects", 420, 60 + 26 * bars["all"], 100, "Flash that a part adds, -Os", "bytes")
    print "set xrange [0:*]\nset yrange [" bars["all"] + 0.6 ":0.4]"
    for (n = 1; n <= bars["all"]; n++) {
        name = bar_of["all", n]
        list = list ", \"" name "\" " n
        add(1, bar_row(n - 0.19, 0, part[name, "m0plus"], 0.17))
        add(2, bar_row(n + 0.19, 0, part[name, "m4f"], 0.17))
    }
    tics(list)
    draw_boxes(2, 3)
}

END {
    if (kind == "stages") {
        for (i = 1; i <= plot_count; i++) { draw_stages(plots[i]) }
    } else if (bars["all"] > 0) {
        if (kind == "size") { draw_size() } else { draw_effects() }
    }
}
