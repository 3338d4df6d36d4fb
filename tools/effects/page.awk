# SPDX-License-Identifier: MIT
#
# The table of docs/effects.md from effects.csv, whose columns run.sh names: a row for each effect, both targets in it.

function percent(from, to) { return from == "-" || to == "-" ? "" : sprintf("%+.2f %%", 100 * (to / from - 1)) }

BEGIN {
    FS = ","
    print "| effect | flash, M0+ | M4F | memory, M0+ | linked and not used, M0+: exact | tolerance | M4F: exact | tolerance | used, M0+ | M4F | greatest error, fixed | float |"
    print "|---|---|---|---|---|---|---|---|---|---|---|---|"
}
NR == 1 { next }
$2 == "m0plus" {
    flash = $4; memory = $5; exact = percent($6, $7); tolerance = percent($8, $9); used = $10 / 1e6
}
$2 == "m4f" {
    printf "| %s | %d | %d | %d | %s | %s | %s | %s | %.1f | %.1f | %s | %s |\n", $1, flash, $4, memory, exact, tolerance,
        percent($6, $7), percent($8, $9), used, $10 / 1e6, $11 == "-" ? "" : $11, $12 == "-" ? "" : $12
}
