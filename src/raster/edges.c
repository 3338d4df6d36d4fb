/* SPDX-License-Identifier: MIT */
#include "raster/edges.h"

#define NO_EDGE 3

int64_t glint_signed_area(const glint_screen_vertex *a, const glint_screen_vertex *b, const glint_screen_vertex *c)
{
    return (int64_t)(b->x - a->x) * (c->y - a->y) - (int64_t)(c->x - a->x) * (b->y - a->y);
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

glint_box glint_bounding_box(const glint_screen_vertex *a, const glint_screen_vertex *b, const glint_screen_vertex *c,
                             uint16_t width_px, uint16_t height_px)
{
    /* beyond the display: first = size or last = -1, which makes the box empty */
    const glint_box box = {
        .x_first = clamp_pixel(first_pixel(least(a->x, b->x, c->x)), 0, width_px),
        .x_last = glint_last_pixel(greatest(a->x, b->x, c->x), width_px),
        .y_first = clamp_pixel(first_pixel(least(a->y, b->y, c->y)), 0, height_px),
        .y_last = glint_last_pixel(greatest(a->y, b->y, c->y), height_px),
    };
    return box;
}

/* Barycentric gradients: (-dy, dx) 256 / area of the edge opposite to the corner. */
static void gradients_set_up(glint_edges *edges)
{
    uint32_t any = 0;
    for (int i = 1; i < 3; i++) {
        any |= magnitude32(edges->step_x[i]) | magnitude32(edges->step_y[i]);
    }
    const int area_bits = bit_length64((uint64_t)edges->area);
    /* |gradient| < 2^excess per pixel */
    const int excess = 32 - clz32(any) + GLINT_SUBPIXEL_BITS - area_bits + 1;
    const int bits = 30 - (excess > 0 ? excess : 0);
    edges->sliver = bits < 26;
    if (edges->sliver) {
        return;
    }
    edges->gradient_bits = (int8_t)bits;
    /* area = x 2^(area_bits-32) with x normalised; 1/area = r 2^(-30-area_bits) */
    const uint32_t x = (uint32_t)(area_bits > 32 ? edges->area >> (area_bits - 32) : edges->area << (32 - area_bits));
    const uint32_t r = glint_reciprocal_q31(x);
    const int shift = bits + GLINT_SUBPIXEL_BITS - 30 - area_bits; /* < 0: area_bits >= bit length + 5, see excess */
    for (int i = 0; i < 2; i++) {
        edges->gradient_x[i] = (int32_t)shift_round64((int64_t)edges->step_x[i + 1] * r, shift);
        edges->gradient_y[i] = (int32_t)shift_round64((int64_t)edges->step_y[i + 1] * r, shift);
    }
}

void glint_edges_set_up(glint_edges *edges, const glint_screen_vertex corner[3], int64_t signed_area, glint_box box)
{
    const bool clockwise = signed_area > 0;
    edges->area = clockwise ? signed_area : -signed_area;
    edges->box = box;
    edges->order[0] = 0;
    edges->order[1] = clockwise ? 1 : 2;
    edges->order[2] = clockwise ? 2 : 1;
    for (int i = 0; i < 3; i++) {
        edges->corner[i] = corner[edges->order[i]];
    }
    for (int i = 0; i < 3; i++) {
        /* the edge opposite corner i, from j to k */
        const glint_screen_vertex *from = &edges->corner[(i + 1) % 3], *to = &edges->corner[(i + 2) % 3];
        const int32_t dx = to->x - from->x, dy = to->y - from->y; /* < 2^20 */
        const bool left_or_top = dy < 0 || (dy == 0 && dx > 0);
        const int32_t pixel_x = from->x >> GLINT_SUBPIXEL_BITS, pixel_y = from->y >> GLINT_SUBPIXEL_BITS;
        const int32_t offset_x = GLINT_SUBPIXEL / 2 - (from->x & (GLINT_SUBPIXEL - 1)); /* |.| <= 128 */
        const int32_t offset_y = GLINT_SUBPIXEL / 2 - (from->y & (GLINT_SUBPIXEL - 1));
        const int32_t part =
            (dx * offset_y - dy * offset_x - (left_or_top ? 0 : 1)) >> GLINT_SUBPIXEL_BITS; /* < 2^28 */
        edges->step_x[i] = -dy;
        edges->step_y[i] = dx;
        edges->value[i] = (uint32_t)dx * (uint32_t)(box.y_first - pixel_y) -
                          (uint32_t)dy * (uint32_t)(box.x_first - pixel_x) + (uint32_t)part;
    }
    edges->anchor_x = (int16_t)(edges->corner[0].x >> GLINT_SUBPIXEL_BITS);
    edges->anchor_y = (int16_t)(edges->corner[0].y >> GLINT_SUBPIXEL_BITS);
    edges->offset_x = (int16_t)(GLINT_SUBPIXEL / 2 - (edges->corner[0].x & (GLINT_SUBPIXEL - 1)));
    edges->offset_y = (int16_t)(GLINT_SUBPIXEL / 2 - (edges->corner[0].y & (GLINT_SUBPIXEL - 1)));
    gradients_set_up(edges);
}

void glint_edges_weights(const glint_edges *edges, int16_t x, int16_t y, int32_t weight_q30[2])
{
    const int32_t centre_x = (int32_t)x * GLINT_SUBPIXEL + GLINT_SUBPIXEL / 2;
    const int32_t centre_y = (int32_t)y * GLINT_SUBPIXEL + GLINT_SUBPIXEL / 2;
    const int area_bits = bit_length64((uint64_t)edges->area); /* <= 28 for a sliver: area < 2^(8+20+1-4+..) */
    const uint32_t r = glint_reciprocal_q31((uint32_t)edges->area << (32 - area_bits));
    int64_t rest = (int64_t)1 << 30;
    for (int i = 0; i < 2; i++) {
        const glint_screen_vertex *from = &edges->corner[(i + 2) % 3];
        /* E itself, 0..area inside */
        const int64_t inside =
            (int64_t)edges->step_y[i + 1] * (centre_y - from->y) + (int64_t)edges->step_x[i + 1] * (centre_x - from->x);
        int64_t weight =
            (int64_t)(((uint64_t)inside * r) >> area_bits); /* inside 2^30 / area; r / 2^(30+bits) = 1/area */
        weight = weight > rest ? rest : weight;
        rest -= weight;
        weight_q30[i] = (int32_t)weight;
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
