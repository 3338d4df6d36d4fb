/* SPDX-License-Identifier: MIT */
#include "raster/edges.h"

int64_t glint_signed_area(const glint_point corner[3])
{
    const int32_t ax = corner[1].x - corner[0].x, ay = corner[1].y - corner[0].y;
    const int32_t bx = corner[2].x - corner[0].x, by = corner[2].y - corner[0].y;
    if (((magnitude32(ax) | magnitude32(ay) | magnitude32(bx) | magnitude32(by)) >> 15) == 0) {
        return ax * by - bx * ay; /* up to 128 px: 32 bits hold it, and small processors are spared wide products */
    }
    const int64_t area = (int64_t)ax * by - (int64_t)bx * ay;
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
        .y_last = (int16_t)(clamp_pixel(first_pixel(greatest(a->y, b->y, c->y)), 0, height_px) - 1),
    };
    return box;
}

void glint_edges_set_up(glint_edges *edges, const glint_point corner[3], bool clockwise, glint_box box)
{
    uint8_t lefts = 0, rights = 0;
    edges->box = box;
    edges->order[0] = 0;
    edges->order[1] = clockwise ? 1 : 2;
    edges->order[2] = clockwise ? 2 : 1;
    edges->left[0] = edges->left[1] = edges->right[0] = edges->right[1] = 0;
    for (uint8_t i = 0; i < 3; i++) {
        /* the edge opposite corner i, from j to k */
        const glint_point *from = &corner[edges->order[i == 2 ? 0 : i + 1]];
        const glint_point *to = &corner[edges->order[i == 0 ? 2 : i - 1]];
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
        if (dy < 0) {
            edges->left[lefts++] = i;
        } else if (dy > 0) {
            edges->right[rights++] = i;
        }
    }
    edges->row_of_bend = INT16_MAX;
    edges->bend_left = lefts == 2;
    if (lefts == 2 || rights == 2) {
        /* two edges of one side meet in the corner that neither of them is opposite to */
        uint8_t *pair = lefts == 2 ? edges->left : edges->right;
        const uint8_t bend = (uint8_t)(3 - pair[0] - pair[1]);
        /* clockwise, the left side is run through upwards and the right side downwards */
        const bool first_begins_there = bend == (pair[0] == 2 ? 0 : pair[0] + 1);
        if (first_begins_there != (lefts == 2)) {
            const uint8_t lower = pair[0];
            pair[0] = pair[1];
            pair[1] = lower;
        }
        edges->row_of_bend = clamp_pixel(first_pixel(corner[edges->order[bend]].y), 0, INT16_MAX);
    }
}

static void take_edge(glint_side *side, const glint_edges *edges, uint8_t edge, int16_t x, int16_t y)
{
    side->value = edges->value[edge] + (uint32_t)(x - edges->box.x_first) * (uint32_t)edges->step_x[edge] +
                  (uint32_t)(y - edges->box.y_first) * (uint32_t)edges->step_y[edge];
    GLINT_TRACE("edge function", (int32_t)edges->value[edge] + (int64_t)(x - edges->box.x_first) * edges->step_x[edge] +
                                     (int64_t)(y - edges->box.y_first) * edges->step_y[edge]);
    side->inwards = magnitude32(edges->step_x[edge]);
    side->down = (uint32_t)edges->step_y[edge];
}

void glint_spans_bend(glint_spans *spans)
{
    const glint_edges *edges = spans->edges;
    if (edges->bend_left) {
        take_edge(&spans->left, edges, edges->left[1], spans->x_left, spans->y);
    } else {
        take_edge(&spans->right, edges, edges->right[1], spans->x_right, spans->y);
    }
    spans->row_of_bend = INT16_MAX;
}

void glint_spans_begin(glint_spans *spans, const glint_edges *edges, int16_t y_first, int16_t y_last)
{
    spans->edges = edges;
    spans->x_left = spans->x_first = edges->box.x_first;
    spans->x_right = spans->x_last = edges->box.x_last;
    spans->y = y_first;
    spans->y_last = y_last;
    spans->row_of_bend = edges->row_of_bend;
    take_edge(&spans->left, edges, edges->left[0], spans->x_left, y_first);
    take_edge(&spans->right, edges, edges->right[0], spans->x_right, y_first);
    if (edges->row_of_bend <= y_first) {
        glint_spans_bend(spans);
    }
}
