/* SPDX-License-Identifier: MIT */
#include "raster/edges.h"

#define NO_EDGE 3

int64_t glint_signed_area(const glint_point corner[3])
{
    const int64_t area = (int64_t)(corner[1].x - corner[0].x) * (corner[2].y - corner[0].y) -
                         (int64_t)(corner[2].x - corner[0].x) * (corner[1].y - corner[0].y);
    GLINT_TRACE("signed area q16", area);
    return area;
}

static int32_t least(int32_t a, int32_t b, int32_t c)
{
    const int32_t ab = a < b ? a : b;
    return ab < c ? ab : c;
}

static int32_t greatest(int32_t a, int32_t b, int32_t c)
{
    const int32_t ab = a > b ? a : b;
    return ab > c ? ab : c;
}

/* First pixel whose centre is at or after a coordinate, and last pixel whose centre is at or before; floor division. */
static int32_t first_pixel(int32_t subpixels)
{
    return (subpixels + GLINT_SUBPIXEL / 2 - 1) >> GLINT_SUBPIXEL_BITS;
}

static int16_t clamp_pixel(int32_t pixel, int32_t low, int32_t high)
{
    return (int16_t)(pixel < low ? low : pixel > high ? high : pixel);
}

int16_t glint_last_pixel(int32_t subpixels, uint16_t size_px)
{
    /* halved first: the least int32 is a coordinate too (of no corner at all) */
    return clamp_pixel(((subpixels >> 1) - GLINT_SUBPIXEL / 4) >> (GLINT_SUBPIXEL_BITS - 1), -1, (int32_t)size_px - 1);
}

glint_box glint_bounding_box(const glint_point corner[3], uint16_t width_px, uint16_t height_px)
{
    const glint_point *a = &corner[0], *b = &corner[1], *c = &corner[2];
    /* beyond the display: first = size or last = -1, which makes the box empty */
    const glint_box box = {
        .x_first = clamp_pixel(first_pixel(least(a->x, b->x, c->x)), 0, width_px),
        .x_last = glint_last_pixel(greatest(a->x, b->x, c->x), width_px),
        .y_first = clamp_pixel(first_pixel(least(a->y, b->y, c->y)), 0, height_px),
        .y_last = glint_last_pixel(greatest(a->y, b->y, c->y), height_px),
    };
    return box;
}

void glint_edges_set_up(glint_edges *edges, const glint_point corner[3], bool clockwise, glint_box box)
{
    edges->box = box;
    edges->order[0] = 0;
    edges->order[1] = clockwise ? 1 : 2;
    edges->order[2] = clockwise ? 2 : 1;
    for (int i = 0; i < 3; i++) {
        /* the edge opposite corner i, from j to k */
        const glint_point *from = &corner[edges->order[(i + 1) % 3]], *to = &corner[edges->order[(i + 2) % 3]];
        const int32_t dx = to->x - from->x, dy = to->y - from->y; /* < 2^20 */
        const bool left_or_top = dy < 0 || (dy == 0 && dx > 0);
        const int32_t pixel_x = from->x >> GLINT_SUBPIXEL_BITS, pixel_y = from->y >> GLINT_SUBPIXEL_BITS;
        const int32_t offset_x = GLINT_SUBPIXEL / 2 - (from->x & (GLINT_SUBPIXEL - 1)); /* |.| <= 128 */
        const int32_t offset_y = GLINT_SUBPIXEL / 2 - (from->y & (GLINT_SUBPIXEL - 1));
        const int32_t part =
            (dx * offset_y - dy * offset_x - (left_or_top ? 0 : 1)) >> GLINT_SUBPIXEL_BITS; /* < 2^28 */
        GLINT_TRACE("edge step", dx);
        GLINT_TRACE("edge step", dy);
        GLINT_TRACE("edge part", part);
        GLINT_TRACE("edge function",
                    (int64_t)dx * (box.y_first - pixel_y) - (int64_t)dy * (box.x_first - pixel_x) + part);
        edges->step_x[i] = -dy;
        edges->step_y[i] = dx;
        edges->value[i] = (uint32_t)dx * (uint32_t)(box.y_first - pixel_y) -
                          (uint32_t)dy * (uint32_t)(box.x_first - pixel_x) + (uint32_t)part;
    }
}

void glint_spans_begin(glint_spans *spans, const glint_edges *edges, int16_t y_first, int16_t y_last)
{
    int lefts = 0, rights = 0;
    spans->edges = edges;
    spans->flat_edge = NO_EDGE;
    spans->left_edge[0] = spans->left_edge[1] = spans->right_edge[0] = spans->right_edge[1] = NO_EDGE;
    spans->left[0] = spans->left[1] = spans->right[0] = spans->right[1] = spans->flat = 0;
    spans->x_left = edges->box.x_first;
    spans->x_right = edges->box.x_last;
    spans->y = y_first;
    spans->y_last = y_last;
    const uint32_t rows = (uint32_t)(y_first - edges->box.y_first);
    const uint32_t columns = (uint32_t)(edges->box.x_last - edges->box.x_first);
    for (uint8_t i = 0; i < 3; i++) {
        const uint32_t value = edges->value[i] + rows * (uint32_t)edges->step_y[i];
        GLINT_TRACE("edge function", (int32_t)edges->value[i] + (int64_t)rows * edges->step_y[i]);
        GLINT_TRACE("edge function", (int32_t)value + (int64_t)columns * edges->step_x[i]);
        if (edges->step_x[i] > 0) {
            spans->left[lefts] = value;
            spans->left_edge[lefts++] = i;
        } else if (edges->step_x[i] < 0) {
            spans->right[rights] = value + columns * (uint32_t)edges->step_x[i];
            spans->right_edge[rights++] = i;
        } else {
            spans->flat = value;
            spans->flat_edge = i;
        }
    }
}

/*
 * Moves one end of the span to where its edges are just satisfied. `value` holds E' of the (at most two) edges at x,
 * `step` their change when x moves by `direction` into the triangle, > 0. The ends move by as many pixels as the edge
 * does from row to row, so a triangle takes no more steps than its box has columns on either side, and no division.
 */
static int16_t settle(uint32_t value[2], const uint32_t step[2], int16_t x, int16_t direction, int16_t outermost,
                      int16_t beyond)
{
    if ((int32_t)value[0] < 0 || (int32_t)value[1] < 0) {
        do {
            value[0] += step[0];
            value[1] += step[1];
            x = (int16_t)(x + direction);
        } while (x != beyond && ((int32_t)value[0] < 0 || (int32_t)value[1] < 0));
    } else {
        while (x != outermost && (int32_t)(value[0] - step[0]) >= 0 && (int32_t)(value[1] - step[1]) >= 0) {
            value[0] -= step[0];
            value[1] -= step[1];
            x = (int16_t)(x - direction);
        }
    }
    return x;
}

bool glint_spans_next(glint_spans *spans, int16_t *y, int16_t *x_first, int16_t *x_last)
{
    const glint_edges *edges = spans->edges;
    const glint_box *box = &edges->box;
    uint32_t left_step[2], right_step[2], left_down[2], right_down[2];
    for (int i = 0; i < 2; i++) {
        const uint8_t l = spans->left_edge[i], r = spans->right_edge[i];
        left_step[i] = l == NO_EDGE ? 0 : (uint32_t)edges->step_x[l];
        left_down[i] = l == NO_EDGE ? 0 : (uint32_t)edges->step_y[l];
        right_step[i] = r == NO_EDGE ? 0 : 0u - (uint32_t)edges->step_x[r];
        right_down[i] = r == NO_EDGE ? 0 : (uint32_t)edges->step_y[r];
    }
    const uint32_t flat_down = spans->flat_edge == NO_EDGE ? 0 : (uint32_t)edges->step_y[spans->flat_edge];
    while (spans->y <= spans->y_last) {
        bool found = false;
        if ((int32_t)spans->flat >= 0) {
            spans->x_left = settle(spans->left, left_step, spans->x_left, 1, box->x_first, (int16_t)(box->x_last + 1));
            spans->x_right =
                settle(spans->right, right_step, spans->x_right, -1, box->x_last, (int16_t)(box->x_first - 1));
            *y = spans->y;
            *x_first = spans->x_left;
            *x_last = spans->x_right;
            found = spans->x_left <= spans->x_right;
        }
        for (int i = 0; i < 2; i++) {
            spans->left[i] += left_down[i];
            spans->right[i] += right_down[i];
        }
        spans->flat += flat_down;
        spans->y++;
        if (found) {
            return true;
        }
    }
    return false;
}
