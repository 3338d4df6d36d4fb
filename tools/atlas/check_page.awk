# SPDX-License-Identifier: MIT
#
# Is the page well formed? Each element is closed in the order it was opened, the five sections are there, nothing is
# loaded from elsewhere: awk -f check_page.awk index.html
BEGIN { split("area base br col hr img input link meta source", list, " "); for (i in list) { is_empty[list[i]] = 1 } }
{ text = text $0 "\n" }
END {
    if (text ~ /(src|href)="https?:/) { complain("something is loaded from elsewhere") }
    count = split("frames routines memory stages how", part, " ")
    for (i = 1; i <= count; i++) {
        if (index(text, "<h2 id=\"" part[i] "\">") == 0) { complain("no section " part[i]) }
    }
    if (text ~ /\n@[a-z]*@\n/) { complain("a part of the template was not filled in") }
    while (match(text, /<[^>]*>/)) {
        tag = substr(text, RSTART + 1, RLENGTH - 2)
        text = substr(text, RSTART + RLENGTH)
        name = tag
        sub(/^\//, "", name)
        sub(/[^A-Za-z0-9].*/, "", name)
        if (tag ~ /^!/ || tag ~ /\/$/ || tolower(name) in is_empty) { continue }
        if (tag !~ /^\//) {
            open[++depth] = name
        } else if (depth == 0 || open[depth--] != name) {
            complain("</" name "> closes nothing, or what is open within it")
            break
        }
    }
    if (depth > 0) { complain("<" open[depth] "> is not closed") }
    exit bad
}

function complain(what) {
    print FILENAME ": " what > "/dev/stderr"
    bad = 1
}
