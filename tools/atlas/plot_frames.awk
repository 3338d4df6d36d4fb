# SPDX-License-Identifier: MIT
#
# gnuplot commands for cost against error, a plot for each scene and target:
#
#     awk -v folder=FOLDER -f plot_labels.awk -f plot_frames.awk targets.txt peers.csv frames.csv
#
# Writes FOLDER/SCENE-TARGET.svg. Colours are marks that page.sh makes variables of: 1 ink, 2 grid, 3 fixed, 4 float,
# 5 peers, 6 front.
BEGIN {
    FS = ","
    width = 420; height = 340; left = 52; right = 400; top = 62; bottom = 286
    point["exact"] = 7; point["q2"] = 5; point["q1"] = 9; point["Gouraud"] = 13; point["flat"] = 11; point["auto"] = 6
}
/^#/ || NF == 0 { next }
FILENAME ~ /targets\.txt$/ {
    split($0, word, / +/)
    clock[word[1]] = word[3]
    title[word[1]] = $0
    sub(/^[^ ]+ +[^ ]+ +[^ ]+ +/, "", title[word[1]])
    next
}
FNR == 1 || /^target,/ {
    split("", column)
    for (i = 1; i <= NF; i++) { column[$i] = i }
    is_peers = "renderer" in column
    next
}
is_peers {
    if (value("max_error") != "" && value("per_pixel") != "") {
        words = value("shading")
        sub(/;.*/, "", words)
        sub(/ RGB$/, "", words)
        sub(/per-pixel Phong.*/, "Phong", words)
        p = value("scene") SUBSEP value("target")
        peer_x[p, ++peers[p]] = value("per_pixel")
        peer_y[p, peers[p]] = value("max_error")
        peer_text[p, peers[p]] = value("renderer") " " words
    }
    next
}
{
    p = value("scene") SUBSEP value("target")
    if (!(p in rows)) { plots[++plot_count] = p }
    n = ++rows[p]
    x[p, n] = value("frame") / value("covered")
    y[p, n] = value("max_error")
    backend[p, n] = value("backend")
    shading[p, n] = value("shading")
    tolerance[p, n] = value("tolerance")
    lower[p, n] = value("lower")
    upper[p, n] = value("upper")
    front[p, n] = value("front")
    pixels[value("scene")] = value("covered")
    unit[p] = value("unit")
}

function value(name) { return $column[name] }

function name_of(p, n) { return shading[p, n] == "auto" ? "≤ " tolerance[p, n] : shading[p, n] }

function data(name, p, which, mark,   n, any, area) {
    area = pixels[scene_of(p)]
    print "$" name " << E"
    for (n = 1; n <= rows[p]; n++) {
        if (backend[p, n] == which && shading[p, n] == mark) {
            print x[p, n], y[p, n], (lower[p, n] == "" ? x[p, n] : lower[p, n] / area), (upper[p, n] == "" ? x[p, n] : upper[p, n] / area)
            any = 1
        }
    }
    print "E"
    return any
}

# Labels of the fixed backend's points; those of points that lie on one another are one.
function fixed_labels(p,   n, k, text, done) {
    for (n = 1; n <= rows[p]; n++) {
        if (backend[p, n] != "fixed" || done[n]) { continue }
        text = name_of(p, n)
        for (k = n + 1; k <= rows[p]; k++) {
            if (backend[p, k] == "fixed" && !done[k] && near(x_px(x[p, n]), x_px(x[p, k])) && near(y_px(y[p, n]), y_px(y[p, k]))) {
                text = text (shading[p, n] == "auto" && shading[p, k] == "auto" ? ", " tolerance[p, k] : ", " name_of(p, k))
                done[k] = 1
            }
        }
        printf "%s", label(text, x[p, n], y[p, n], "#000003")
    }
}

function scene_of(p,   part) {
    split(p, part, SUBSEP)
    return part[1]
}

function near(a, b) { return a - b < 7 && b - a < 7 }

function extend(to) {
    if (to + 0 < least) { least = to + 0 }
    if (to + 0 > most) { most = to + 0 }
}

function draw(p,   part, n, k, area, marks, m, list, fps) {
    split(p, part, SUBSEP)
    area = pixels[part[1]]
    least = 1e30; most = 0
    for (n = 1; n <= rows[p]; n++) {
        extend(x[p, n])
        if (upper[p, n] != "") { extend(lower[p, n] / area); extend(upper[p, n] / area) }
    }
    for (n = 1; n <= peers[p]; n++) { extend(peer_x[p, n]) }
    least /= 1.4; most *= 1.6
    labels_begin(left, right, top, bottom, least, most, 0.35, 300)
    order_front(p)
    for (n = 2; n <= front_count; n++) { front_obstacles(n, p) }
    for (n = 1; n <= rows[p]; n++) { obstacle(x[p, n], y[p, n], 4) }
    for (n = 1; n <= peers[p]; n++) { obstacle(peer_x[p, n], peer_y[p, n], 4) }
    printf "reset\nset output '%s/%s-%s.svg'\n", folder, part[1], part[2]
    print "set terminal svg size " width "," height " dynamic font 'sans-serif,11'"
    printf "set margins at screen %.4f, screen %.4f, screen %.4f, screen %.4f\n", left / width, right / width, 1 - bottom / height, 1 - top / height
    print "set border lc rgb '#000001'\nset tics textcolor rgb '#000001' nomirror\nset grid x y lc rgb '#000002' lw 0.6"
    printf "set logscale xyx2\nset xrange [%g:%g]\nset yrange [0.35:300]\n", least, most
    print "set ytics (0.5, 1, 2, 4, 8, 16, 32, 64, 128, 255)\nset format x '%g'\nset mxtics 1"
    printf "set xtics add (%s)\n", tics(least, most)
    fps = clock[part[2]] ? clock[part[2]] * 1e6 / area : 1e9 / area
    printf "set x2range [%g:%g]\nset x2tics (%s) textcolor rgb '#000001'\n", fps / least, fps / most, tics(fps / most, fps / least)
    printf "set x2label 'frames a second%s' textcolor rgb '#000001' offset 0,-0.6\n", !clock[part[2]] ? "" : \
        sprintf(" at %d MHz%s", clock[part[2]], unit[p] == "cycles" ? "" : ", one instruction a cycle")
    printf "set title \"%s: %s\" textcolor rgb '#000001' font 'sans-serif,12' offset 0,-0.4\n", part[1], title[part[2]]
    printf "set xlabel '%s a covered pixel; times %d: a frame' textcolor rgb '#000001' offset 0,0.3\n", unit[p], area
    print "set ylabel 'greatest error, codes of 1/255' textcolor rgb '#000001' offset 1.5,0"
    fixed_labels(p)
    for (n = 1; n <= peers[p]; n++) { printf "%s", label(peer_text[p, n], peer_x[p, n], peer_y[p, n], "#000005") }
    print "$front << E"
    front_lines(p)
    print "E"
    list = "$front using 1:2 with lines lw 5 lc rgb '#000006' notitle"
    m = split("exact q2 q1 Gouraud flat auto", marks, " ")
    for (k = 1; k <= m; k++) {
        if (data("float_" marks[k], p, "float", marks[k])) {
            list = list series("$float_" marks[k], marks[k], "#000004", part[2])
        }
    }
    for (k = 1; k <= m; k++) {
        if (data("fixed_" marks[k], p, "fixed", marks[k])) {
            list = list series("$fixed_" marks[k], marks[k], "#000003", part[2])
        }
    }
    if (peers[p]) {
        print "$peers << E"
        for (n = 1; n <= peers[p]; n++) { print peer_x[p, n], peer_y[p, n] }
        print "E"
        list = list ", $peers using 1:2 with points pt 2 ps 0.7 lw 1.5 lc rgb '#000005' notitle"
    }
    print "plot " list "\nset output"
}

function series(name, mark, colour, target,   text) {
    text = ""
    if (target == "host") { text = ", " name " using 1:2:3:4 with xerrorbars pt 0 lw 1 lc rgb '" colour "' notitle" }
    if (mark == "auto") { text = text ", " name " using 1:2 with lines lw 1 dt 2 lc rgb '" colour "' notitle" }
    return text ", " name " using 1:2 with points pt " point[mark] " ps " (mark == "auto" ? 0.6 : 0.75) " lw 1.5 lc rgb '" colour "' notitle"
}

# The front's points by cost.
function order_front(p,   n, k, t) {
    front_count = 0
    for (n = 1; n <= rows[p]; n++) {
        if (front[p, n] == "yes") { order[++front_count] = n }
    }
    for (n = 1; n <= front_count; n++) {
        for (k = n + 1; k <= front_count; k++) {
            if (x[p, order[k]] < x[p, order[n]] || (x[p, order[k]] == x[p, order[n]] && y[p, order[k]] > y[p, order[n]])) { t = order[n]; order[n] = order[k]; order[k] = t }
        }
    }
}

function front_obstacles(n, p,   x0, x1, y0, y1) {
    x0 = x_px(x[p, order[n - 1]]); x1 = x_px(x[p, order[n]])
    y0 = y_px(y[p, order[n - 1]]); y1 = y_px(y[p, order[n]])
    add_box(x0, y0 - 2, x1, y0 + 2)
    add_box(x1 - 2, y0, x1 + 2, y1)
}

# Steps from each point of the front to the next: at each cost, the least error to be had for it.
function front_lines(p,   n) {
    for (n = 1; n <= front_count; n++) {
        if (n > 1) { print x[p, order[n]], y[p, order[n - 1]] }
        print x[p, order[n]], y[p, order[n]]
    }
}

# 1, 2 and 5 of each decade within a range; 1 alone where that are many.
function tics(least, most,   decade, k, list, few) {
    few = most / least > 200
    for (decade = 1e-4; decade < 1e9; decade *= 10) {
        for (k = 1; k <= 5; k += k == 2 ? 3 : 1) {
            if (k * decade >= least && k * decade <= most && (!few || k == 1)) {
                list = list (list == "" ? "" : ", ") sprintf("\"%g\" %g", k * decade, k * decade)
            }
        }
    }
    return list
}

END {
    for (i = 1; i <= plot_count; i++) { draw(plots[i]) }
}
