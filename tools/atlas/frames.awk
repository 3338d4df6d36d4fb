# SPDX-License-Identifier: MIT
#
# The table of all frames: awk -f frames.awk targets.txt HOST-REPORT... TABLE-details.csv... TABLE.csv...
# Beside the columns of judge.c:
#
#     covered            pixels that the scene covers
#     clock_mhz, frames_per_second   at the clock of targets.txt; of instructions, at one a cycle: at most so many
#     lower, upper       quartiles of the host's times; empty for what is counted
#     front              yes: no frame of the scene on this target is cheaper and errs less (the Pareto front)
#     knee               yes: of the front, in logarithms of cost and error, what lies farthest below the line between
#                        its ends; empty for a front of fewer than three
BEGIN { FS = "," }
FILENAME ~ /targets\.txt$/ {
    if (!/^#/ && NF) {
        split($0, word, / +/)
        clock[word[1]] = word[3]
    }
    next
}
FILENAME ~ /host\.txt$/ {
    split($0, word, " ")
    if (word[1] == "spread") {
        name = word[2] SUBSEP word[3] SUBSEP word[4] SUBSEP (word[5] == "-" ? "" : word[5])
        lower[name] = word[7]
        upper[name] = word[8]
    }
    next
}
FNR == 1 { next }
FILENAME ~ /-details\.csv$/ {
    covered[$2] = $9
    next
}
{
    line[++count] = $0
    plot[count] = $1 SUBSEP $3
    cost[count] = $7
    error[count] = $9
    target[count] = $1
    scene[count] = $3
    spread[count] = $3 SUBSEP $4 SUBSEP $5 SUBSEP $6
}

function is_front(i,   k) {
    for (k = 1; k <= count; k++) {
        if (plot[k] == plot[i] && k != i && cost[k] + 0 <= cost[i] + 0 && error[k] + 0 <= error[i] + 0 &&
            (cost[k] + 0 < cost[i] + 0 || error[k] + 0 < error[i] + 0 || k < i)) {
            return 0
        }
    }
    return 1
}

# Farthest below the line between the ends of its front, both axes logarithmic.
function mark_knees(   i, p, least, most, x0, x1, y0, y1, below, best) {
    for (i = 1; i <= count; i++) {
        if (front[i]) {
            p = plot[i]
            if (!(p in least) || cost[i] < cost[least[p]]) { least[p] = i }
            if (!(p in most) || cost[i] > cost[most[p]]) { most[p] = i }
        }
    }
    for (i = 1; i <= count; i++) {
        p = plot[i]
        if (front[i] && i != least[p] && i != most[p]) {
            x0 = log(cost[least[p]]); x1 = log(cost[most[p]])
            y0 = log(error[least[p]]); y1 = log(error[most[p]])
            below = (log(cost[i]) - x0) / (x1 - x0) + (log(error[i]) - y1) / (y0 - y1)
            if (below < 1 && (!(p in best) || below < depth[p])) {
                best[p] = i
                depth[p] = below
            }
        }
    }
    for (p in best) { knee[best[p]] = 1 }
}

END {
    for (i = 1; i <= count; i++) {
        cost[i] += 0
        error[i] += 0
    }
    for (i = 1; i <= count; i++) { front[i] = is_front(i) }
    mark_knees()
    print "target,unit,scene,backend,shading,tolerance,frame,per_pixel,max_error,psnr_db,promised," \
        "covered,clock_mhz,frames_per_second,lower,upper,front,knee"
    for (i = 1; i <= count; i++) {
        host = target[i] == "host"
        hertz = host ? 1e9 : 1e6 * clock[target[i]]
        print line[i] "," covered[scene[i]] "," (host ? "" : clock[target[i]]) "," sprintf("%.4g", hertz / cost[i]) "," \
            (host ? lower[spread[i]] "," upper[spread[i]] : ",") "," (front[i] ? "yes" : "") "," (knee[i] ? "yes" : "")
    }
}
