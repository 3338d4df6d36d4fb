# SPDX-License-Identifier: MIT
#
# Prints cost.csv beside the peers' figures, a line for each scene and shading, a column for each target:
# awk -f table.awk details.csv cost.csv peers.csv
#
# All have a line of column names, and # begins a comment.
BEGIN {
    FS = ","
    target_count = split("m0plus m3 m4f rv32imac m0plus-cycles avr-cycles", targets, " ")
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
    if (value("given") != "") {
        short[frame_name()] = 1
        notes[++note_count] = sprintf("  * %s, %s, %s %s %s: %d of the %d bytes of memory that it can use", value("target"), \
            value("scene"), value("backend"), value("shading"), value("tolerance"), value("given"), value("useful"))
    }
    next
}
{
    scene = value("scene")
    if (ours) {
        label = "Glint " value("backend") ", " value("shading") \
            (value("tolerance") == "" ? "" : ", tolerance " value("tolerance"))
    } else {
        label = value("renderer") ": " value("shading")
    }
    if (!(scene in rows)) {
        scenes[++scene_count] = scene
    }
    row = scene SUBSEP label
    if (!(row in seen)) {
        seen[row] = ++rows[scene]
        labels[scene, rows[scene]] = label
        own[scene, rows[scene]] = ours
    }
    cell[row, value("target")] = figure(value("frame"), value("per_pixel")) (ours && frame_name() in short ? "*" : " ")
    add(worst, row, value("max_error"))
    add(psnr, row, value("psnr_db"))
    if (ours) { add(promised, row, value("promised")) }
    if (ours) { has_target[value("target")] = 1 }
}

function frame_name() {
    return value("target") SUBSEP value("scene") SUBSEP value("backend") SUBSEP value("shading") SUBSEP value("tolerance")
}

function value(name) {
    return $column[name]
}

function figure(frame, per_pixel) {
    per_pixel = per_pixel == "" ? "" : sprintf("(%s)", per_pixel >= 100 ? int(per_pixel + 0.5) : sprintf("%.1f", per_pixel))
    return sprintf("%9s %7s", frame == "" ? "-" : sprintf("%.2f M", frame / 1e6), per_pixel)
}

# The figures of a row, each once, where targets differ.
function add(list, row, new) {
    if (index(" " list[row] " ", " " new " ") == 0) {
        list[row] = list[row] (list[row] == "" ? "" : " / ") new
    }
}

function line(label, row, i, text) {
    text = sprintf("  %-58s", label)
    for (i = 1; i <= target_count; i++) {
        if (targets[i] in has_target) {
            text = text sprintf(" %18s", (row, targets[i]) in cell ? cell[row, targets[i]] : "- ")
        }
    }
    text = text sprintf("  %8s %11s %8s", worst[row], psnr[row], promised[row])
    sub(/ +$/, "", text)
    print text
}

END {
    text = sprintf("  %-58s", "")
    for (i = 1; i <= target_count; i++) {
        if (targets[i] in has_target) {
            text = text sprintf(" %17s ", targets[i])
        }
    }
    print text sprintf("  %8s %11s %8s", "error", "PSNR dB", "promised")
    # in the order of cost.csv, the others' lines below ours
    for (s = 1; s <= scene_count; s++) {
        scene = scenes[s]
        print scene
        for (mine = 1; mine >= 0; mine--) {
            for (i = 1; i <= rows[scene]; i++) {
                if (own[scene, i] == mine) {
                    line(labels[scene, i], scene SUBSEP labels[scene, i])
                }
            }
        }
    }
    for (i = 1; i <= note_count; i++) { print notes[i] }
    print "A frame in millions of instructions (-cycles: of cycles), clears included, flush empty; in brackets for each"
    print "covered pixel. error: the greatest, in codes of 1/255, against per-pixel Phong in double precision, before display"
    print "quantisation but with the rounding to a code (0.5); PSNR of the same pixels. The others' errors are of the picture"
    print "that tools/cost/peers.csv tells of."
}
