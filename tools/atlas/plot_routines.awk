# SPDX-License-Identifier: MIT
#
# gnuplot commands for the routines, error against cost, a plot for each routine and target:
#
#     awk -v folder=FOLDER -f plot_labels.awk -f plot_routines.awk targets.txt routines.csv
#
# Writes FOLDER/ROUTINE-TARGET.svg. Filled: the library's; hollow: the atlas's own and the C library's.
BEGIN {
    FS = ","
    width = 420; height = 320; left = 82; right = 400; top = 34; bottom = 270
    y_least = 1e-5; y_most = 1e4
}
/^#/ || NF == 0 { next }
FILENAME ~ /targets\.txt$/ {
    split($0, word, / +/)
    title[word[1]] = $0
    sub(/^[^ ]+ +[^ ]+ +[^ ]+ +/, "", title[word[1]])
    next
}
FNR == 1 {
    for (i = 1; i <= NF; i++) { column[$i] = i }
    next
}
{
    p = value("routine") SUBSEP value("target")
    if (!(p in rows)) { plots[++plot_count] = p }
    n = ++rows[p]
    x[p, n] = value("average") > 0.05 ? value("average") : 0.05
    y[p, n] = value("error_ulp")
    name = value("variant")
    gsub(/-/, " ", name)
    sub(/^library/, "lib.", name)
    text[p, n] = name
    kind[p, n] = value("origin") == "libm" ? "libm" : (value("origin") == "library" ? "own_" : "other_") \
        (value("variant") ~ /float/ ? "float" : "fixed")
    unit[p] = value("unit")
}

function value(name) { return $column[name] }

function points(p, which, colour, mark,   n, any) {
    print "$" which " << E"
    for (n = 1; n <= rows[p]; n++) {
        if (kind[p, n] == which) { print x[p, n], y[p, n]; any = 1 }
    }
    print "E"
    return any ? ", $" which " using 1:2 with points pt " mark " ps 0.7 lw 1.5 lc rgb '" colour "' notitle" : ""
}

function colour_of(k) { return k == "libm" ? "#000005" : k ~ /float/ ? "#000004" : "#000003" }

function draw(p,   part, n, least, most, list, decade, step) {
    split(p, part, SUBSEP)
    least = 1e30; most = 0
    for (n = 1; n <= rows[p]; n++) {
        if (x[p, n] + 0 < least) { least = x[p, n] + 0 }
        if (x[p, n] + 0 > most) { most = x[p, n] + 0 }
    }
    least /= 1.6; most *= 1.8
    labels_begin(left, right, top, bottom, least, most, y_least, y_most)
    for (n = 1; n <= rows[p]; n++) { obstacle(x[p, n], y[p, n], 4) }
    printf "reset\nset output '%s/%s-%s.svg'\n", folder, part[1], part[2]
    print "set terminal svg size " width "," height " dynamic font 'sans-serif,11'"
    printf "set margins at screen %.4f, screen %.4f, screen %.4f, screen %.4f\n", left / width, right / width, 1 - bottom / height, 1 - top / height
    print "set border lc rgb '#000001'\nset tics textcolor rgb '#000001' nomirror\nset grid x y lc rgb '#000002' lw 0.6"
    printf "set logscale xy\nset xrange [%g:%g]\nset yrange [%g:%g]\nset mxtics 1\nset mytics 1\n", least, most, y_least, y_most
    print "set ytics (\"0.00001\" 1e-5, \"0.0001\" 1e-4, \"0.001\" 1e-3, \"0.01\" 0.01, \"0.1\" 0.1, \"1\" 1, \"10\" 10, \"100\" 100, \"1000\" 1e3)"
    list = ""
    step = most / least > 100 ? 10 : 1
    for (decade = 0.01; decade < 1e6; decade *= 10) {
        for (n = 1; n <= 5; n += n == 2 ? 3 : 1) {
            if (n * decade > least && n * decade < most && (n == 1 || step == 1)) {
                list = list (list == "" ? "" : ", ") sprintf("\"%g\" %g", n * decade, n * decade)
            }
        }
    }
    print "set xtics (" list ")"
    name = part[1]
    gsub(/-/, " ", name)
    printf "set title \"%s: %s\" textcolor rgb '#000001' font 'sans-serif,12' offset 0,-0.4\n", name, title[part[2]]
    printf "set xlabel '%s a call, average' textcolor rgb '#000001' offset 0,0.3\n", unit[p]
    print "set ylabel 'greatest error, ulp of Q15' textcolor rgb '#000001' offset 1,0"
    for (n = 1; n <= rows[p]; n++) { printf "%s", label(text[p, n], x[p, n], y[p, n], colour_of(kind[p, n])) }
    list = points(p, "other_fixed", "#000003", 6) points(p, "other_float", "#000004", 6) points(p, "libm", "#000005", 4) \
        points(p, "own_fixed", "#000003", 7) points(p, "own_float", "#000004", 7)
    print "plot " substr(list, 3) "\nset output"
}

END {
    for (i = 1; i <= plot_count; i++) { draw(plots[i]) }
}
