# SPDX-License-Identifier: MIT
#
# Prints the table of README.md's section "Tolerance" from cost.csv: awk -f pages.awk cost.csv
#
# A frame in millions of instructions, in the cheaper backend of each target; the greatest error promised and observed.
BEGIN {
    FS = ","
    target_count = split("m0plus m3 m4f rv32imac", targets, " ")
    scene_count = split("A B C teapot knot room point-light", scenes, " ")
    shading_count = split("exact Gouraud flat auto", shadings, " ")
    label["exact"] = "exact"; label["Gouraud"] = "Gouraud"; label["flat"] = "flat"; label["auto"] = "tolerance 1"
}
/^target,/ {
    for (i = 1; i <= NF; i++) { column[$i] = i }
    next
}
$column["tolerance"] == "" || $column["tolerance"] == "1" {
    key = $column["scene"] SUBSEP $column["shading"]
    cell = $column["target"] SUBSEP key
    if (!(cell in frame) || $column["frame"] + 0 < frame[cell]) { frame[cell] = $column["frame"] + 0 }
    if (!(key in observed) || $column["max_error"] + 0 > observed[key]) { observed[key] = $column["max_error"] + 0 }
    if ($column["promised"] != "" && $column["promised"] + 0 > promised[key] + 0) { promised[key] = $column["promised"] }
}
END {
    print "| scene | shading | Cortex-M0+ | Cortex-M3 | Cortex-M4F | RV32IMAC | error promised | observed |"
    print "|---|---|---|---|---|---|---|---|"
    for (s = 1; s <= scene_count; s++) {
        for (i = 1; i <= shading_count; i++) {
            key = scenes[s] SUBSEP shadings[i]
            # B is A flat: its tolerance is A's
            if (!(key in observed) || (scenes[s] == "B" && shadings[i] != "flat")) { continue }
            text = "| " scenes[s] " | " label[shadings[i]] " |"
            for (t = 1; t <= target_count; t++) {
                cell = targets[t] SUBSEP key
                text = text (cell in frame ? sprintf(" %.1f |", frame[cell] / 1e6) : " |")
            }
            print text " " (promised[key] == "" ? "none" : promised[key]) " | " sprintf("%.2f", observed[key]) " |"
        }
    }
}
