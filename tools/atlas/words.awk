# SPDX-License-Identifier: MIT
#
# What the atlas teaches, for the README: awk -f words.awk frames.csv peers.csv routines.csv. A sentence whose frames were
# not counted is left out.
BEGIN { FS = "," }
/^#/ || NF == 0 { next }
/^target,/ {
    split("", column)
    for (i = 1; i <= NF; i++) { column[$i] = i }
    table = "renderer" in column ? "peers" : "routine" in column ? "routines" : "frames"
    next
}
table == "frames" {
    key = $1 " " $3 " " $4 " " $5 ($6 == "" ? "" : " " $6)
    frame[key] = $7; pixel[key] = $8; error[key] = $9
}
table == "peers" {
    shading = $column["shading"]
    sub(/;.*/, "", shading)
    key = $1 " " $2 " " $3 " " shading
    pixel[key] = $column["per_pixel"]; error[key] = $column["max_error"]
}
table == "routines" {
    key = $1 " " $3 " " $4
    pixel[key] = $7; error[key] = $9
}

function has(a, b, c, d) { return (a in error) && (b in error) && (c == "" || c in error) && (d == "" || d in error) }

# A point of a list, in lines of at most 120 characters.
function say(text,   words, count, i, row) {
    count = split(text, words, " ")
    row = "-"
    for (i = 1; i <= count; i++) {
        if (length(row) + 1 + length(words[i]) > 120) {
            print row
            row = " "
        }
        row = row " " words[i]
    }
    print row
}

function millions(key) { return sprintf("%.1f", frame[key] / 1e6) }

function codes(x) { return sprintf("%.1f", x) }

function round(x) { return sprintf("%.0f", x) }

function ratio(a, b) { return sprintf("%.1f", a / b) }

END {
    t = "m0plus-cycles A fixed auto 1"; g = "m0plus-cycles A fixed Gouraud"; e = "m0plus-cycles A fixed exact"
    if (has(t, g, e)) {
        say("One code of accuracy can be had for less than Gouraud shading costs. Scene A on the Cortex-M0+ takes " millions(t) \
            " million cycles within a tolerance of 1, where its worst pixel is off by " codes(error[t]) " codes; Gouraud shading takes " \
            millions(g) " and is off by " round(error[g]) "; the model evaluated at each pixel takes " millions(e) ".")
    }
    t = "m0plus A fixed auto 1"; g = "m0plus A small3dlib Gouraud RGB"; e = "m0plus A tgx Gouraud"
    if (has(t, g, e)) {
        say("In instructions a pixel on the same processor that is " round(pixel[t]) ", where the Gouraud shading of small3dlib takes " \
            round(pixel[g]) " and that of TGX " round(pixel[e]) ", off by " round(error[g]) " and " round(error[e]) " codes.")
    }
    a = "m0plus-cycles A fixed auto 8"; t = "m0plus-cycles A fixed auto 1"
    if (has(a, t)) {
        say("To ask for less hardly saves: there a tolerance of 8 costs " round(100 - 100 * frame[a] / frame[t]) " % less than one of 1.")
    }
    t = "m0plus-cycles C fixed auto 1"; g = "m0plus-cycles C fixed Gouraud"
    if (has(t, g)) {
        say("With few, large triangles it is the other way: scene C, of 100, takes " millions(t) " million cycles within 1 code and " \
            millions(g) " with Gouraud shading, which is off by " round(error[g]) ".")
    }
    t = "m4f A fixed auto 1"; g = "m4f A float auto 1"; a = "m4f A fixed exact"; e = "m4f A float exact"
    if (has(t, g, a, e)) {
        say("On the Cortex-M4F, which has a floating-point unit, fixed point takes " round(pixel[t]) " instructions a pixel and float " round(pixel[g]) \
            " within a tolerance of 1; with the model at each pixel it is " round(pixel[a]) " and " round(pixel[e]) ".")
    }
    t = "m3 reciprocal-root library-192-cells-linear"; a = "m3 reciprocal-root 24-cells-2-steps"; e = "m3 reciprocal-root 384-cells"
    if (has(t, a, e)) {
        say("For a reciprocal root on the Cortex-M3, a line between " 192 " cells takes " round(pixel[t]) " instructions and is off by " codes(error[t]) \
            " ulp of Q15; the nearest of 384 cells takes " round(pixel[e]) " and is off by " round(error[e]) "; two Newton steps from 24 cells take " \
            round(pixel[a]) " to get to " codes(error[a]) ".")
    }
    t = "m0plus-cycles power-32 library-32-cells"; a = "m0plus-cycles power-32 5-squarings-Q31"
    if (has(t, a)) {
        say("Where a material's exponent is a power of two, squarings would do: x^32 takes " round(pixel[a]) " cycles on the Cortex-M0+ and is off by " \
            codes(error[a]) " ulp of Q15, the library's power, which takes any exponent, " round(pixel[t]) " and " codes(error[t]) ".")
    }
}
