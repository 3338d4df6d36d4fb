# SPDX-License-Identifier: MIT
#
# gnuplot's SVG on standard input, made small and its colours variables: awk -v defs=0 -f plot_svg.awk
#
# The marks that plots are drawn with (#000001 ...) become var(--ink) ... of the page. The shapes of points are the same
# in each plot: with defs=0 they are left out, as the page has them from elsewhere.
BEGIN { split("ink grid fixed float peer front c1 c2 c3 c4 c5 c6 c7 c8", colour, " ") }
/<\?xml/ || /^<title>/ || /^<desc>/ || /^<!--/ { next }
/<filter/ { in_filter = 1 }
!in_filter { text = text $0 "\n" }
/<\/filter>/ { in_filter = 0 }
END {
    if (!defs) { gsub(/<defs>.*<\/defs>/, "", text) }
    gsub(/[ \t\n]+/, " ", text)
    while (gsub(/<g [^>]*> *<\/g>/, "", text)) { }
    gsub(/ stroke-linecap="butt" stroke-linejoin="miter"/, "", text)
    gsub(/<tspan font-family="sans-serif" >/, "<tspan>", text)
    gsub(/ id="gnuplot_plot_[0-9a-z]*" ?/, "", text)
    gsub(/ id="gnuplot_canvas"/, "", text)
    gsub(/<a xlink:title="[^"]*">/, "<a>", text)
    gsub(/ class="gridline"/, "", text)
    gsub(/ font-family="sans-serif"/, "", text)
    gsub(/ font-size="11.00"/, "", text)
    gsub(/"black"/, "\"var(--ink)\"", text)
    for (i = 1; i in colour; i++) {
        gsub("rgb\\( *0, *0, *" i "\\)", "var(--" colour[i] ")", text)
        gsub("#0000" sprintf("%02X", i), "var(--" colour[i] ")", text)
    }
    gsub(/> </, "><", text)
    gsub(/> +/, ">", text)
    gsub(/ +\/>/, "/>", text)
    sub(/^ /, "", text)
    print text
}
