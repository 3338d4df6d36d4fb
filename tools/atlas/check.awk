# SPDX-License-Identifier: MIT
#
# Is the committed table of frames well formed, and are its fixed-point errors those of fresh frames?
#
#     awk -f check.awk ERRORS.csv... frames.csv      ERRORS.csv as "cost-judge errors" prints it
#
# Each fresh fixed-point frame must be there and have the same greatest error, PSNR and promise, to the digit.
BEGIN { FS = "," }
FNR == 1 {
    split("", column)
    for (i = 1; i <= NF; i++) { column[$i] = i }
    columns = NF
    committed = "frames_per_second" in column
    next
}
{
    key = value("scene") " " value("backend") " " value("shading") " " value("tolerance")
    errors = value("max_error") " " value("psnr_db") " " value("promised")
}
!committed {
    if (value("backend") == "fixed") { fresh[key] = errors }
    next
}
{
    rows++
    if (NF != columns || !is_number(value("frame")) || !is_number(value("per_pixel")) || !is_number(value("max_error")) ||
        !is_number(value("frames_per_second"))) {
        complain("line " FNR " is not a row: " $0)
    }
    if (value("backend") == "fixed") {
        seen[key] = 1
        if (!(key in fresh)) {
            complain(key ": no such frame is drawn today")
        } else if (fresh[key] != errors) {
            complain(value("target") " " key ": error, PSNR and promise are " errors ", drawn now they are " fresh[key])
        }
    }
}

function value(name) { return $column[name] }

function is_number(text) { return text ~ /^[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?$/ }

function complain(text) {
    if (++complaints <= 20) { print FILENAME ": " text > "/dev/stderr" }
}

END {
    for (key in fresh) {
        if (!(key in seen)) { complain("lacks " key) }
    }
    if (!rows) { complain("no frames") }
    if (complaints) { print complaints " differences: make atlas, look, make atlas-snapshot" > "/dev/stderr" }
    exit complaints > 0
}
