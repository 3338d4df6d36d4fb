# SPDX-License-Identifier: MIT
#
# Where the labels of a plot's points go: beside, above or below, where they lie on no point and on no label placed before.
#
# Call labels_begin() with the plot's area in pixels and its ranges (both axes logarithmic), obstacle() for each point,
# then label() for each text; it returns a gnuplot command, "" for a text that finds no place.
function labels_begin(left, right, top, bottom, x_least, x_most, y_least, y_most) {
    area_left = left; area_right = right; area_top = top; area_bottom = bottom
    from_x = log(x_least); to_x = log(x_most); from_y = log(y_least); to_y = log(y_most)
    boxes = 0
}

function x_px(x) { return area_left + (log(x) - from_x) / (to_x - from_x) * (area_right - area_left) }
function y_px(y) { return area_bottom - (log(y) - from_y) / (to_y - from_y) * (area_bottom - area_top) }

function add_box(x0, y0, x1, y1) {
    boxes++
    box_x0[boxes] = x0; box_y0[boxes] = y0; box_x1[boxes] = x1; box_y1[boxes] = y1
}

function obstacle(x, y, radius) { add_box(x_px(x) - radius, y_px(y) - radius, x_px(x) + radius, y_px(y) + radius) }

function is_free(x0, y0, x1, y1,   i) {
    if (x0 < area_left || x1 > area_right || y0 < area_top || y1 > area_bottom) { return 0 }
    for (i = 1; i <= boxes; i++) {
        if (x0 < box_x1[i] && x1 > box_x0[i] && y0 < box_y1[i] && y1 > box_y0[i]) { return 0 }
    }
    return 1
}

# A thin line, which later labels keep off.
function leader(x0, y0, x1, y1, colour) {
    add_box((x0 < x1 ? x0 : x1) - 1, (y0 < y1 ? y0 : y1) - 1, (x0 < x1 ? x1 : x0) + 1, (y0 < y1 ? y1 : y0) + 1)
    return sprintf("set arrow from graph %.4f, graph %.4f to graph %.4f, graph %.4f nohead lw 0.5 lc rgb '%s'\n", \
        (x0 - area_left) / (area_right - area_left), (area_bottom - y0) / (area_bottom - area_top), \
        (x1 - area_left) / (area_right - area_left), (area_bottom - y1) / (area_bottom - area_top), colour)
}

function label(text, x, y, colour,   px, py, width, gap, height, k, x0, y0, dx, dy, far) {
    px = x_px(x); py = y_px(y)
    width = 6.3 * length(text) + 2; gap = 6; height = 12
    for (k = 0; k < 8 * 5; k++) { # right, left, above, below, the corners; then the same farther off
        dx = k % 8 == 0 ? gap : k % 8 == 1 ? -gap - width : k % 8 < 4 ? -width / 2 : k % 2 == 0 ? 2 : -2 - width
        dy = k % 8 < 2 ? 0 : k % 8 == 2 || k % 8 == 4 || k % 8 == 5 ? -gap - height / 2 : gap + height / 2
        if (k % 8 < 2) { dx *= 1 + int(k / 8) * 0.8 } else { dy *= 1 + int(k / 8) * 0.8 }
        x0 = px + dx
        y0 = py + dy - height / 2
        if (is_free(x0, y0, x0 + width, y0 + height)) {
            add_box(x0, y0, x0 + width, y0 + height)
            far = k < 8 ? "" : leader(px < x0 ? x0 : px > x0 + width ? x0 + width : px, \
                dy < 0 ? y0 + height - 1 : dy > 0 ? y0 + 1 : py, px, py, colour)
            return far sprintf("set label \"%s\" at graph %.4f, graph %.4f left textcolor rgb '%s' front\n", text, \
                (x0 + 1 - area_left) / (area_right - area_left), (area_bottom - py - dy) / (area_bottom - area_top), colour)
        }
    }
    return ""
}
