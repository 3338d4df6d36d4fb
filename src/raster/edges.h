/* SPDX-License-Identifier: MIT */
/*
 * Coverage: exact edge functions on snapped vertices, and the spans of pixels that they enclose.
 *
 * Fill rule: a pixel belongs to a triangle when its centre lies inside, or on a left edge, or on a horizontal top edge.
 *
 * For an edge from i to j, with d = v_j - v_i in sub-pixels, E(p) = dx (p_y - v_iy) - dy (p_x - v_ix) is twice the area
 * of (v_i, v_j, p), positive inside since triangles are set up clockwise as seen on the display (y down). E is a number
 * of squared sub-pixels and needs 41 bits; but pixel centres are 256 sub-pixels apart, so with p = v_i + 256 (m, n) +
 * f, f what is left, 0..255 in x and y, E >= 0 holds just when E' = dx n - dy m + floor((dx f_y - dy f_x + bias) / 256)
 * >= 0, bias = 0 on left and top edges, -1 elsewhere, since the first two terms of E / 256 are whole. |E'| <= 2 area /
 * 256 <= 256 L^2, L the side in px of the bounding box of triangle and sample points: below 2^31 for L < 2896. The
 * guard band keeps L at or below 2 GLINT_GUARD_PX = 2880. The products wrap modulo 2^32 on the way, which the final
 * range makes good.
 */
#ifndef GLINT_RASTER_EDGES_H
#define GLINT_RASTER_EDGES_H

#include <stdbool.h>
#include <stdint.h>

#include "geometry/view.h"

typedef char
    glint_assert_edge_range[(uint64_t)(2 * GLINT_GUARD_PX) * (2 * GLINT_GUARD_PX) * GLINT_SUBPIXEL < 0x80000000u ? 1
                                                                                                                 : -1];

/* A projected vertex. */
typedef struct glint_screen_vertex {
    int32_t x, y;      /* 1/4096 px */
    int32_t depth_q30; /* see GLINT_DEPTH_BIAS */
} glint_screen_vertex;

/* A vertex snapped to the sub-pixel grid. */
typedef struct glint_point {
    int32_t x, y; /* 1/256 px */
} glint_point;

static inline glint_point glint_snap(const glint_screen_vertex *vertex)
{
    const int down = GLINT_FINE_BITS - GLINT_SUBPIXEL_BITS;
    const glint_point point = {(vertex->x + (1 << (down - 1))) >> down, (vertex->y + (1 << (down - 1))) >> down};
    return point;
}

/* The pixels of a rectangle: first..last, both included; empty when last < first. */
typedef struct glint_box {
    int16_t x_first, x_last, y_first, y_last;
} glint_box;

/*
 * A triangle has one or two edges on its left and on its right. Of two, the upper one bounds the rows above the corner
 * at which they meet and the lower one those below; a row through that corner may take either, since they agree there.
 * Rows are those whose centres lie at or below the highest corner and above the lowest: so a horizontal edge needs no
 * test of its own, and neither does a single corner, which its right edge leaves out.
 */
typedef struct glint_edges {
    glint_box box;             /* pixels that the triangle may cover, within the display */
    uint8_t order[3];          /* corner i of the set-up is corner order[i] of the caller: clockwise */
    bool bend_left;            /* the side that has two */
    uint8_t left[2], right[2]; /* upper and lower edge of each side */
    int16_t row_of_bend;       /* first row of the lower one; INT16_MAX: there is none */
    uint32_t value[3];         /* E' of the edge opposite corner i at pixel (box.x_first, box.y_first), modulo 2^32 */
    int32_t step_x[3];         /* E' per pixel to the right (-dy) */
    int32_t step_y[3];         /* E' per pixel down (dx) */
} glint_edges;

/* Twice the signed area in squared sub-pixels: positive for corners clockwise on the display. Exact. */
int64_t glint_signed_area(const glint_point corner[3]);

/* Pixels whose centres lie in the corners' bounding box, within width x height. */
glint_box glint_bounding_box(const glint_point corner[3], uint16_t width_px, uint16_t height_px);

/* Last row or column whose pixels' centres are at or before a coordinate: -1..size_px - 1. */
int16_t glint_last_pixel(int32_t subpixels, uint16_t size_px);

/*
 * Sets up a triangle whose corners all lie within the guard band; clockwise tells the sign of its area, which is not 0.
 * `box` is from glint_bounding_box and not empty.
 */
void glint_edges_set_up(glint_edges *edges, const glint_point corner[3], bool clockwise, glint_box box);

/* One end of a row: E' of its edge there, its growth for a pixel into the triangle (> 0) and for a row down. */
typedef struct glint_side {
    uint32_t value, inwards, down;
    int inset; /* pixels from the box's end on this side: 0..columns, where the row is empty */
} glint_side;

/* Runs over the covered pixels of a triangle, row by row. Coordinates are int, which small processors load faster. */
typedef struct glint_spans {
    glint_side left, right;
    int x_first, x_last, columns; /* of the triangle's box */
    int y, y_stop, y_end;         /* the next row; where the triangle bends or ends; behind the last row */
    const glint_edges *edges;
} glint_spans;

/* Rows y_first..y_last of the triangle's box, no row outside of it. */
void glint_spans_begin(glint_spans *spans, const glint_edges *edges, int16_t y_first, int16_t y_last);

/* Takes up the lower of two edges. */
void glint_spans_bend(glint_spans *spans);

/* Moves a side to its outermost pixel of the row that the edge holds inside, and its value to the row below. Returns
 * the inset of the pixel. */
static inline int glint_side_move(glint_side *side, int columns)
{
    uint32_t value = side->value;
    const uint32_t inwards = side->inwards;
    int inset = side->inset;
    if ((int32_t)value < 0) {
        while (inset != columns) {
            inset++;
            value += inwards;
            if ((int32_t)value >= 0) {
                break;
            }
        }
    } else {
        while (inset != 0 && (int32_t)(value - inwards) >= 0) {
            value -= inwards;
            inset--;
        }
    }
    side->value = value + side->down;
    side->inset = inset;
    return inset;
}

/* Is there another row? */
static inline bool glint_spans_more(glint_spans *spans)
{
    if (spans->y >= spans->y_stop) {
        if (spans->y >= spans->y_end) {
            return false;
        }
        glint_spans_bend(spans);
    }
    return true;
}

/* Takes that row: pixels x_first..x_last. False where no pixel is covered. */
static inline bool glint_spans_row(glint_spans *spans, int *x_first, int *x_last)
{
    spans->y++;
    const int left = glint_side_move(&spans->left, spans->columns);
    const int right = glint_side_move(&spans->right, spans->columns);
    *x_first = spans->x_first + left;
    *x_last = spans->x_last - right;
    return left + right < spans->columns;
}

/*
 * The next row with covered pixels: x_first..x_last of row y. False after the last. The ends move by as many pixels as
 * the edges do from row to row, so a triangle takes no more steps than its box has columns on either side, and no
 * division.
 */
static inline bool glint_spans_next(glint_spans *spans, int16_t *y, int16_t *x_first, int16_t *x_last)
{
    while (glint_spans_more(spans)) {
        int first, last;
        if (glint_spans_row(spans, &first, &last)) {
            *y = (int16_t)(spans->y - 1);
            *x_first = (int16_t)first;
            *x_last = (int16_t)last;
            return true;
        }
    }
    return false;
}

#endif
