# SPDX-License-Identifier: MIT
#
# The cheapest choice within each error: awk -v form=csv|words -f advice.awk targets.txt frames.csv
#
# Within an error: the greatest that was observed in this picture. What the library promised for it stands beside, for
# other pictures of the same scene. words: the same for a reader, with the knee of the curve (frames.awk says what it is).
BEGIN {
    FS = ","
    limits = split("0.75 1 2 4 8 16 255", limit, " ")
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
    p = value("scene") SUBSEP value("target")
    if (!(p in seen)) { plots[++plot_count] = p; seen[p] = 1 }
    row[++count] = $0
    plot[count] = p
    frame[count] = value("frame") + 0
    error[count] = value("max_error") + 0
    if (value("knee") == "yes") { knee[p] = count }
}

function value(name) { return $column[name] }

function cheapest(p, within,   i, best) {
    for (i = 1; i <= count; i++) {
        if (plot[i] == p && error[i] <= within + 0 && (!best || frame[i] < frame[best])) { best = i }
    }
    return best
}

function field(i, name,   part) {
    split(row[i], part, ",")
    return part[column[name]]
}

function choice(i) {
    return (field(i, "shading") == "auto" ? "tolerance " field(i, "tolerance") : field(i, "shading")) ", " field(i, "backend")
}

function amount(frame, unit) {
    return unit == "ns" ? sprintf("%.3g ms", frame / 1e6) : sprintf("%.2f million %s", frame / 1e6, unit)
}

function rounded(x) { return sprintf(x + 0 < 100 ? "%.3g" : "%.0f", x) }

function told(i,   promised) {
    promised = field(i, "promised")
    return sprintf("%s: %s a frame, %s a covered pixel, %s%s; errs by %s, %s", choice(i), \
        amount(field(i, "frame"), field(i, "unit")), field(i, "per_pixel"), \
        (field(i, "unit") == "instructions" ? "at most " : "") rounded(field(i, "frames_per_second")) " frames a second", \
        field(i, "clock_mhz") == "" ? "" : " at " field(i, "clock_mhz") " MHz", field(i, "max_error"), \
        promised == "" ? "nothing promised" : "promised " promised)
}

# Of the front, the next that is cheaper, or (dearer = 1) that errs less.
function neighbour(i, dearer,   k, best) {
    for (k = 1; k <= count; k++) {
        if (plot[k] == plot[i] && k != i && field(k, "front") == "yes" && (frame[k] > frame[i]) == dearer &&
            (!best || (frame[k] < frame[best]) == dearer)) {
            best = k
        }
    }
    return best
}

function line(head, text) { printf "  %-20s %s\n", head, text }

function words(p,   part, k, i, from, cheap, exact) {
    split(p, part, SUBSEP)
    print part[1] " on " title[part[2]] ":"
    from = 1
    for (k = 1; k <= limits; k++) {
        i = cheapest(p, limit[k])
        if (k < limits && i == cheapest(p, limit[k + 1])) { continue }
        line(k == limits ? (from == k ? "any error" : limit[from] " codes and more") : \
            "within " (from == k ? "" : limit[from] "-") limit[k] (limit[k] == 1 ? " code" : " codes"), i ? told(i) : "nothing")
        from = k + 1
    }
    if (p in knee) {
        i = knee[p]
        cheap = neighbour(i, 0)
        exact = neighbour(i, 1)
        line("the knee", choice(i) sprintf("; %s costs %.2f times as much and errs %.3g times as much, %s costs %.2f times and errs %.2f times as much", \
            choice(cheap), frame[cheap] / frame[i], error[cheap] / error[i], choice(exact), frame[exact] / frame[i], error[exact] / error[i]))
    } else {
        line("the knee", "none: the front has no corner")
    }
}

END {
    if (form == "csv") {
        print "scene,target,within,backend,shading,tolerance,frame,per_pixel,frames_per_second,max_error,promised"
    } else {
        print "The cheapest choice within each error, codes of 1/255. Errors are the greatest in this picture; for other views only"
        print "what is promised holds. The knee: where, on logarithmic axes, the front lies farthest below a line between its ends."
    }
    for (n = 1; n <= plot_count; n++) {
        if (form == "words") {
            words(plots[n])
            continue
        }
        split(plots[n], part, SUBSEP)
        for (k = 1; k <= limits; k++) {
            i = cheapest(plots[n], limit[k])
            if (i) {
                print part[1] "," part[2] "," limit[k] "," field(i, "backend") "," field(i, "shading") "," field(i, "tolerance") "," \
                    field(i, "frame") "," field(i, "per_pixel") "," field(i, "frames_per_second") "," field(i, "max_error") "," field(i, "promised")
            }
        }
    }
}
