# SPDX-License-Identifier: MIT
#
# Prints what frames should cost, and how exact they should be, beside what they are:
# awk -f goals.awk details.csv peers.csv cost.csv
#
# A line a goal, ending in "met" or in "MISSED"; then a count. A goal that is missed fails nothing: cost-judge fails on
# what is wrong. A goal whose frames were not counted is left out. Instructions; targets in cycles have no goals.
#
# Set-up of a triangle: of a frame at two sizes, f240 and f60, all that is proportional to the area is taken off:
# (16 f60 - f240) / 15. What a frame of one pixel costs is taken off too: the vertices, and the triangles that face away.
# The rest is for the triangles that are drawn. Work for each row of a triangle counts among it, by 1/4 - 1/16 of it.
BEGIN {
    FS = ","
    target_count = split("m0plus m3 m4f rv32imac", targets, " ")
    frame_goal["m0plus"] = 2.5e6; frame_goal["m3"] = 1.9e6; frame_goal["m4f"] = 1.4e6; frame_goal["rv32imac"] = 2.0e6
    flat_goal["m0plus"] = 1.3e6; flat_goal["m3"] = 0.9e6
    set_up_goal["m0plus"] = 1500; set_up_goal["m3"] = 600
    tolerance_count = split("0.75 1 2 4 8", tolerances, " ")
}
/^#/ { next }
/^target,/ {
    split("", column)
    for (i = 1; i <= NF; i++) { column[$i] = i }
    ours = "backend" in column
    is_details = "useful" in column
    next
}
is_details {
    triangles[frame_name()] = value("triangles")
    next
}
!ours {
    if (value("scene") == "A" && value("frame") != "") {
        peers[value("target")] = peers[value("target")] \
            sprintf("; %s %s: %.2f M", value("renderer"), substr(value("shading") ";", 1, index(value("shading") ";", ";") - 1), \
                    value("frame") / 1e6)
    }
    next
}
{
    key = frame_name()
    names[++name_count] = key
    frame[key] = value("frame")
    error[key] = value("max_error")
    promised[key] = value("promised")
}

function frame_name() {
    return value("target") SUBSEP value("backend") SUBSEP value("scene") SUBSEP value("shading") SUBSEP value("tolerance")
}

function value(name) {
    return $column[name]
}

function key_of(target, backend, scene, tolerance) {
    return target SUBSEP backend SUBSEP scene SUBSEP (tolerance == "" ? "exact" : "auto") SUBSEP tolerance
}

function goal(met, text) {
    printf "  %-6s  %s\n", met ? "met" : "MISSED", text
    goals++
    missed += !met
}

function cheaper(target, scene, tolerance,   fixed, other) {
    fixed = key_of(target, "fixed", scene, tolerance)
    other = key_of(target, "float", scene, tolerance)
    return !(fixed in frame) || ((other in frame) && frame[other] + 0 < frame[fixed] + 0) ? "float" : "fixed"
}

function frames(   t, target, backend, key) {
    print "Scene A at tolerance 1, the cheaper backend:"
    for (t = 1; t <= target_count; t++) {
        target = targets[t]
        backend = cheaper(target, "A", "1")
        key = key_of(target, backend, "A", "1")
        if (key in frame) {
            goal(frame[key] <= frame_goal[target], sprintf("%-8s %s %.2f M, goal %.1f M%s", target, backend, \
                frame[key] / 1e6, frame_goal[target] / 1e6, peers[target]))
        }
    }
}

function flat(   t, target, key) {
    print "Scene B, flat, fixed backend:"
    for (t = 1; t <= target_count; t++) {
        target = targets[t]
        key = target SUBSEP "fixed" SUBSEP "B" SUBSEP "flat" SUBSEP ""
        if ((key in frame) && (target in flat_goal)) {
            goal(frame[key] <= flat_goal[target], sprintf("%-8s %.2f M, goal %.1f M", target, frame[key] / 1e6, \
                flat_goal[target] / 1e6))
        }
    }
}

# Errors are of the pictures, which do not depend on the target.
function errors_within_one(   i, part, key, seen) {
    print "Tolerance 1: the greatest error, promised and observed, is at most 1 code:"
    for (i = 1; i <= name_count; i++) {
        key = names[i]
        split(key, part, SUBSEP)
        if (part[4] == "auto" && part[5] == "1" && !seen[part[2], part[3]]++) {
            goal(promised[key] != "" && promised[key] <= 1 && error[key] <= 1, sprintf("%-10s %s promised %s, observed %s", \
                part[3], part[2], promised[key] == "" ? "nothing" : promised[key], error[key]))
        }
    }
}

# Each step to a larger tolerance: at most 2 % dearer, the error at least as great. Each picture: within its tolerance.
function order_of_tolerances(   t, target, b, backend, i, key, last, text, met, worst, order) {
    print "Scene A: a larger tolerance costs at most 2 % more (errors in brackets), a smaller one errs no more, each within itself:"
    for (t = 1; t <= target_count; t++) {
        for (b = 1; b <= 2; b++) {
            target = targets[t]
            backend = b == 1 ? "fixed" : "float"
            last = key_of(target, backend, "A", "")
            text = (last in frame) ? sprintf("exact %.2f M", frame[last] / 1e6) : ""
            met = worst = order = 1
            for (i = 1; i <= tolerance_count; i++) {
                key = key_of(target, backend, "A", tolerances[i])
                if (!(key in frame)) { continue }
                if ((last in frame) && frame[key] > 1.02 * frame[last]) { met = 0 }
                if (error[key] > tolerances[i] + 0) { worst = 0 }
                if ((last in error) && error[key] + 0 < error[last] + 0) { order = 0 }
                text = text sprintf(", %s: %.2f M (%.2f)", tolerances[i], frame[key] / 1e6, error[key])
                last = key
            }
            if (text != "") {
                goal(met && worst && order, sprintf("%-8s %s %s%s%s%s", target, backend, text, met ? "" : ": dearer", \
                    worst ? "" : ": beyond its tolerance", order ? "" : ": a smaller tolerance errs more"))
            }
        }
    }
}

# Frames of `scene` against those of scene A at tolerance 1.
function against_a(scene, what, percent,   t, target, b, backend, key, base, more) {
    printf "%s at tolerance 1, at most %d %% more than scene A:\n", what, percent
    for (t = 1; t <= target_count; t++) {
        for (b = 1; b <= 2; b++) {
            target = targets[t]
            backend = b == 1 ? "fixed" : "float"
            key = key_of(target, backend, scene, "1")
            base = key_of(target, backend, "A", "1")
            if ((key in frame) && (base in frame)) {
                more = 100 * (frame[key] / frame[base] - 1)
                goal(more <= percent, sprintf("%-8s %s %.2f M to %.2f M: %+.1f %%", target, backend, frame[base] / 1e6, \
                    frame[key] / 1e6, more))
            }
        }
    }
}

function set_up(tolerance, what,   t, target, large, small, one, all, each) {
    printf "Set-up of a triangle that is drawn, fixed backend, %s, instructions:\n", what
    for (t = 1; t <= target_count; t++) {
        target = targets[t]
        large = key_of(target, "fixed", "A", tolerance)
        small = key_of(target, "fixed", "A-60x60", tolerance)
        one = key_of(target, "fixed", "A-1x1", tolerance)
        if (!((large in frame) && (small in frame) && (one in frame))) { continue }
        all = (16 * frame[small] - frame[large]) / 15
        each = (all - frame[one]) / triangles[large]
        text = sprintf("%-8s %.0f for each of %d (at 60 x 60: %d), beside %.2f M for vertices and triangles facing away", \
            target, each, triangles[large], triangles[small], frame[one] / 1e6)
        if (target in set_up_goal) {
            goal(each <= set_up_goal[target], text ", goal " set_up_goal[target])
        } else {
            print "          " text
        }
    }
}

END {
    frames()
    flat()
    set_up("", "exact shading")
    set_up("1", "tolerance 1")
    order_of_tolerances()
    errors_within_one()
    against_a("A-8-lights", "Eight lights", 25)
    against_a("A-bands16", "Bands of 16 rows", 15)
    printf "%d goals, %d missed\n", goals, missed
}
