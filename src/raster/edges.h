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
 * guard band keeps L at or below 2 GLINT_GUARD_PX + 1 = 2881, with a pixel beside the box. The products wrap modulo
 * 2^32 on the way, which the final range makes good.
 */
#ifndef GLINT_RASTER_EDGES_H
#define GLINT_RASTER_EDGES_H

#include <stdbool.h>
#include <stdint.h>

#include "geometry/view.h"

typedef char glint_assert_edge_range
    [(uint64_t)(2 * GLINT_GUARD_PX + 1) * (2 * GLINT_GUARD_PX + 1) * GLINT_SUBPIXEL < 0x80000000u ? 1 : -1];

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

int64_t glint_signed_area_wide(const glint_point corner[3]);

/* Twice the signed area in squared sub-pixels: positive for corners clockwise on the display. Exact. */
static inline int64_t glint_signed_area(const glint_point corner[3])
{
    const int32_t ax = corner[1].x - corner[0].x, ay = corner[1].y - corner[0].y;
    const int32_t bx = corner[2].x - corner[0].x, by = corner[2].y - corner[0].y;
    if (!GLINT_SHARE_CODE && ((ax ^ -(ax < 0)) | (ay ^ -(ay < 0)) | (bx ^ -(bx < 0)) | (by ^ -(by < 0))) >> 15 == 0) {
        /* -2^15..2^15 - 1, 128 px: 32 bits hold it, and small processors are spared wide products */
        return ax * by - bx * ay;
    }
    return glint_signed_area_wide(corner);
}

/* Pixels whose centres lie in the corners' bounding box, within width x height. */
void glint_bounding_box(glint_box *box, const glint_point corner[3], uint16_t width_px, uint16_t height_px);

/* Last row or column whose pixels' centres are at or before a coordinate: -1..size_px - 1. */
int16_t glint_last_pixel(int32_t subpixels, uint16_t size_px);

/*
 * Sets up a triangle whose corners all lie within the guard band; clockwise tells the sign of its area, which is not 0.
 * `box` is from glint_bounding_box and not empty.
 */
void glint_edges_set_up(glint_edges *edges, const glint_point corner[3], bool clockwise, glint_box box);

/* As much of that as it takes to ask of each pixel of the box whether the triangle covers it: not the sides of rows. */
void glint_edges_set_up_values(glint_edges *edges, const glint_point corner[3], bool clockwise, glint_box box);

/* The covered pixels of a row: first..end - 1, none where end <= first. */
typedef struct glint_span {
    uint16_t first, end;
} glint_span;

/* Rows whose spans are found at a time: first their left ends and then their right ones, so that what a side takes from
 * row to row stays in registers. */
#define GLINT_SPAN_ROWS 32

/*
 * One side of the rows. From row to row an edge moves one way only: inwards, where E' of the span's end falls below 0,
 * or outwards, where -1 - E' of the pixel next to it does. That value is the margin; it falls by `fall` (>= 0) a row,
 * and rises by `rise` (> 0) for each pixel that the side moves by.
 */
typedef struct glint_side {
    uint32_t margin, fall, rise;
    int x, move, stop; /* the end of the last span found; 1 or -1; where it moves no further: the box's end */
} glint_side;

/* Runs over the covered pixels of a triangle, row by row. Coordinates are int, which small processors load faster. */
typedef struct glint_spans {
    glint_side left, right;
    int y, y_bend, y_end; /* the next row; where the triangle bends, if it still does; behind the last row */
    int taken;            /* of the spans, by glint_spans_next() */
    int count;            /* spans, of the rows above y */
    const glint_edges *edges;
    glint_span row[GLINT_SPAN_ROWS];
} glint_spans;

/* Rows y_first..y_last of the triangle's box, no row outside of it. */
void glint_spans_begin(glint_spans *spans, const glint_edges *edges, int16_t y_first, int16_t y_last);

/*
 * Finds the spans of the next rows and returns how many, 0 after the last. The ends move by as many pixels as the edges
 * do from row to row, so a triangle takes no more steps than its box has columns on either side, and no division.
 */
int glint_spans_take(glint_spans *spans);

/* The next row with covered pixels: x_first..x_last of row y. False after the last. */
static inline bool glint_spans_next(glint_spans *spans, int16_t *y, int16_t *x_first, int16_t *x_last)
{
    do {
        while (spans->taken < spans->count) {
            const glint_span *span = &spans->row[spans->taken++];
            if (span->first < span->end) {
                *y = (int16_t)(spans->y - spans->count + spans->taken - 1);
                *x_first = (int16_t)span->first;
                *x_last = (int16_t)(span->end - 1);
                return true;
            }
        }
        spans->taken = 0;
    } while (glint_spans_take(spans) > 0);
    return false;
}

#endif
