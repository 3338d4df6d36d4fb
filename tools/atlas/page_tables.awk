# SPDX-License-Identifier: MIT
#
# CSV as HTML tables: awk -v part=advice|frames|routines|memory|stages|plain -v scene=NAME -f page_tables.awk targets.txt FILE.csv
#
# Numbers stand as in the CSV, column by column of the targets where there are several.
BEGIN { FS = "," }
FILENAME ~ /targets\.txt$/ {
    if (!/^#/ && NF) {
        split($0, word, / +/)
        name = $0
        sub(/^[^ ]+ +[^ ]+ +[^ ]+ +/, "", name)
        title[word[1]] = name
        known[++known_count] = word[1]
    }
    next
}
FNR == 1 {
    for (i = 1; i <= NF; i++) { column[$i] = i; heading[i] = $i }
    columns = NF
    if (part == "plain") { head_row() }
    next
}
part == "plain" {
    printf "<tr>"
    for (i = 1; i <= columns; i++) { printf "<td%s>%s</td>", ($i ~ /[a-z].*[a-z; ]/ && i > 1 ? " class=\"words\"" : ""), html($i) }
    print "</tr>"
    next
}
part == "advice" && value("scene") == scene {
    put("≤ " value("within"), value("target"), choice() ": " value("per_pixel") " a pixel, " value("frames_per_second") " fps, errs " value("max_error") (value("promised") == "" ? "" : ", promised " value("promised")))
}
part == "frames" && value("scene") == scene {
    put(choice(), "0 greatest error, codes", value("max_error"))
    put(choice(), "1 promised", value("promised"))
    put(choice(), "2 PSNR, dB", value("psnr_db"))
    put(choice(), value("target"), value("per_pixel") "; " value("frame") "; " value("frames_per_second") (value("lower") == "" ? "" : "; " value("lower") "-" value("upper")))
}
part == "routines" && value("routine") == scene {
    row_name = value("variant") " (" value("origin") ")"
    put(row_name, "0 table bytes", value("table_bytes"))
    put(row_name, value("target"), value("average") "; " value("error_ulp"))
}
part == "memory" {
    put(value("scene") ", " choice(), value("target"), value("least_bytes") "; " value("full_bytes") (value("used_bytes") == "" ? "" : "; " value("used_bytes")))
}
part == "stages" {
    put(value("stage"), value("scene") ": " (value("shading") == "auto" ? "≤ " value("tolerance") : value("shading")), value("cycles") "; " value("instructions"))
}

function value(name) { return $column[name] }

function html(text) { gsub(/&/, "\\&amp;", text); gsub(/</, "\\&lt;", text); return text }

function choice() { return (value("shading") == "auto" ? "≤ " value("tolerance") : value("shading")) ", " value("backend") }

function put(row, at, text) {
    if (!(row in row_seen)) { row_seen[row] = 1; rows[++row_count] = row }
    if (!(at in at_seen)) { at_seen[at] = 1; ats[++at_count] = at }
    if (cell[row, at] == "") { cell[row, at] = text }
}

function head_row() {
    printf "<table><thead><tr>"
    for (i = 1; i <= columns; i++) { printf "<th>%s</th>", html(heading[i] ~ /_/ ? spaced(heading[i]) : heading[i]) }
    print "</tr></thead><tbody>"
}

function spaced(text) { gsub(/_/, " ", text); return text }

END {
    if (part != "plain") {
        if (part == "frames") { caption = "Of a target: cost a covered pixel; a frame; frames a second; on this computer the quartiles of a frame, ns" }
        if (part == "advice") { caption = "Of a target: the choice; its cost a covered pixel; frames a second, of instructions at one a cycle; greatest error here, and promised" }
        if (part == "routines") { caption = "Of a target: cost of a call, average; greatest error in ulp of Q15" }
        if (part == "stages") { caption = "Cycles; instructions" }
        if (part == "memory") { caption = "The least; full; used" }
        printf "<table>%s<thead><tr><th></th>", caption == "" ? "" : "<caption>" caption "</caption>"
        for (k = 1; k <= at_count; k++) {
            at = ats[k]
            sub(/^[0-9] /, "", at)
            printf "<th>%s</th>", html(at in title ? title[at] : at)
        }
        print "</tr></thead><tbody>"
        for (n = 1; n <= row_count; n++) {
            printf "<tr><td>%s</td>", html(rows[n])
            for (k = 1; k <= at_count; k++) { printf "<td>%s</td>", cell[rows[n], ats[k]] }
            print "</tr>"
        }
    }
    if (columns) { print "</tbody></table>" }
}
