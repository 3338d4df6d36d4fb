/* SPDX-License-Identifier: MIT */
#include "raster/edges.h"

int64_t glint_signed_area_wide(const glint_point corner[3])
{
    const int32_t ax = corner[1].x - corner[0].x, ay = corner[1].y - corner[0].y;
    const int32_t bx = corner[2].x - corner[0].x, by = corner[2].y - corner[0].y;
    const int64_t area = multiply_wide_s32(ax, by) - multiply_wide_s32(bx, ay);
    GLINT_TRACE("signed area q16", area);
    return area;
}

static GLINT_SHARED int32_t least(int32_t a, int32_t b, int32_t c)
{
    const int32_t ab = a < b ? a : b;
    return ab < c ? ab : c;
}

static GLINT_SHARED int32_t greatest(int32_t a, int32_t b, int32_t c)
{
    const int32_t ab = a > b ? a : b;
    return ab > c ? ab : c;
}

/* First pixel whose centre is at or after a coordinate, and last pixel whose centre is at or before; floor division. */
static int32_t first_pixel(int32_t subpixels)
{
    return (subpixels + GLINT_SUBPIXEL / 2 - 1) >> GLINT_SUBPIXEL_BITS;
}

static GLINT_SHARED int16_t clamp_pixel(int32_t pixel, int32_t low, int32_t high)
{
    return (int16_t)(pixel < low ? low : pixel > high ? high : pixel);
}

int16_t glint_last_pixel(int32_t subpixels, uint16_t size_px)
{
    /* halved first: the least int32 is a coordinate too (of no corner at all) */
    return clamp_pixel(((subpixels >> 1) - GLINT_SUBPIXEL / 4) >> (GLINT_SUBPIXEL_BITS - 1), -1, (int32_t)size_px - 1);
}

void glint_bounding_box(glint_box *box, const glint_point corner[3], uint16_t width_px, uint16_t height_px)
{
    const glint_point *a = &corner[0], *b = &corner[1], *c = &corner[2];
    /* beyond the display: first = size or last = -1, which makes the box empty */
    box->x_first = clamp_pixel(first_pixel(least(a->x, b->x, c->x)), 0, width_px);
    box->x_last = glint_last_pixel(greatest(a->x, b->x, c->x), width_px);
    box->y_first = clamp_pixel(first_pixel(least(a->y, b->y, c->y)), 0, height_px);
    box->y_last = (int16_t)(clamp_pixel(first_pixel(greatest(a->y, b->y, c->y)), 0, height_px) - 1);
}

/* Upper and lower of a side's edges on the left, lower and upper on the right, by the set of them, 4 for edge 0, 2 for
 * edge 1, 1 for edge 2. Edge i ends where edge i + 1 (modulo 3) begins, and clockwise the left side is run through
 * upwards, the right side downwards. Two bits for each of the eight sets. */
#define LATER_EDGE_OF_SET (2u << 2 | 1u << 4 | 2u << 6 | 0u << 8 | 0u << 10 | 1u << 12)
#define EARLIER_EDGE_OF_SET (2u << 2 | 1u << 4 | 1u << 6 | 0u << 8 | 2u << 10 | 0u << 12)

static uint8_t edge_of_set(uint32_t table, uint32_t set)
{
    return (uint8_t)(table >> (2 * set) & 3);
}

/* Edge i from one corner to another, each told by the way from it to the centre of the box's first pixel. Returns 1 for
 * an edge on the left, 2^16 for one on the right. */
static GLINT_SHARED uint32_t set_up_edge(glint_edges *edges, int i, int32_t x, int32_t y, int32_t x_to, int32_t y_to)
{
    const int32_t dx = x - x_to, dy = y - y_to; /* < 2^20 */
    /* 0 on a left or top edge, dy < 0, or dy = 0 and dx > 0; else -1 */
    const int32_t turned = -(int32_t)((uint32_t)(dx - 1) >> 31) - dy, bias = -(int32_t)((uint32_t)turned >> 31);
    /* whole pixels aside: below 2^20 times below 2^8, so < 2^29 before the shift */
    const int32_t part = (dx * (uint8_t)y - dy * (uint8_t)x + bias) >> GLINT_SUBPIXEL_BITS;
    const int32_t columns = x >> GLINT_SUBPIXEL_BITS, rows = y >> GLINT_SUBPIXEL_BITS;
    GLINT_TRACE("edge step", dx);
    GLINT_TRACE("edge step", dy);
    GLINT_TRACE("edge part", part);
    GLINT_TRACE("edge function", (int64_t)dx * rows - (int64_t)dy * columns + part);
    edges->step_x[i] = -dy;
    edges->step_y[i] = dx;
    edges->value[i] = (uint32_t)dx * (uint32_t)rows - (uint32_t)dy * (uint32_t)columns + (uint32_t)part;
    return ((uint32_t)dy >> 31) + ((uint32_t)-dy >> 31 << 16);
}

void glint_edges_set_up(glint_edges *edges, const glint_point corner[3], bool clockwise, glint_box box)
{
    const int32_t centre_x = box.x_first * GLINT_SUBPIXEL + GLINT_SUBPIXEL / 2;
    const int32_t centre_y = box.y_first * GLINT_SUBPIXEL + GLINT_SUBPIXEL / 2;
    edges->box = box;
    edges->order[0] = 0;
    edges->order[1] = clockwise ? 1 : 2;
    edges->order[2] = clockwise ? 2 : 1;
    const glint_point *const second = &corner[clockwise ? 1 : 2], *const third = &corner[clockwise ? 2 : 1];
    const int32_t x0 = centre_x - corner->x, y0 = centre_y - corner->y;
    const int32_t x1 = centre_x - second->x, y1 = centre_y - second->y;
    const int32_t x2 = centre_x - third->x, y2 = centre_y - third->y;
    const uint32_t sets = 4 * set_up_edge(edges, 0, x1, y1, x2, y2) + 2 * set_up_edge(edges, 1, x2, y2, x0, y0) +
                          set_up_edge(edges, 2, x0, y0, x1, y1);
    const uint32_t lefts = sets & 7, rights = sets >> 16;
    edges->left[0] = edge_of_set(LATER_EDGE_OF_SET, lefts);
    edges->left[1] = edge_of_set(EARLIER_EDGE_OF_SET, lefts);
    edges->right[0] = edge_of_set(EARLIER_EDGE_OF_SET, rights);
    edges->right[1] = edge_of_set(LATER_EDGE_OF_SET, rights);
    edges->bend_left = edges->left[0] != edges->left[1];
    edges->row_of_bend = INT16_MAX;
    const uint8_t *pair = edges->bend_left ? edges->left : edges->right;
    if (pair[0] != pair[1]) {
        /* two edges of one side meet in the corner that neither of them is opposite to */
        const uint8_t bend = (uint8_t)(3 - pair[0] - pair[1]);
        edges->row_of_bend = (int16_t)first_pixel(corner[edges->order[bend]].y);
    }
}

void glint_edges_set_up_values(glint_edges *edges, const glint_point corner[3], bool clockwise, glint_box box)
{
    const int32_t centre_x = box.x_first * GLINT_SUBPIXEL + GLINT_SUBPIXEL / 2;
    const int32_t centre_y = box.y_first * GLINT_SUBPIXEL + GLINT_SUBPIXEL / 2;
    edges->box = box;
    edges->order[0] = 0;
    edges->order[1] = clockwise ? 1 : 2;
    edges->order[2] = clockwise ? 2 : 1;
    for (int i = 0; i < 3; i++) { /* the edge opposite corner i: from the next corner to the one after it */
        const glint_point *const a = &corner[edges->order[i < 2 ? i + 1 : 0]];
        const glint_point *const b = &corner[edges->order[i > 0 ? i - 1 : 2]];
        (void)set_up_edge(edges, i, centre_x - a->x, centre_y - a->y, centre_x - b->x, centre_y - b->y);
    }
}

/* Brings a side to an edge: its place in row y, and how it moves on from there. */
static void take_edge(glint_side *side, const glint_edges *edges, uint8_t edge, bool right, int y)
{
    const glint_box *const box = &edges->box;
    /* a right end is one pixel behind the last of its span */
    const int outermost = right ? box->x_last + 1 : box->x_first, innermost = right ? box->x_first : box->x_last + 1;
    const int inwards = right ? -1 : 1, columns = right ? side->x - 1 - box->x_first : side->x - box->x_first;
    const int rows = y - box->y_first;
    const int32_t step_x = edges->step_x[edge], down = edges->step_y[edge];
    const uint32_t rise = magnitude32(step_x);
    uint32_t value = edges->value[edge] + (uint32_t)columns * (uint32_t)step_x + (uint32_t)rows * (uint32_t)down;
    int x = side->x;
    GLINT_TRACE("edge function", (int32_t)edges->value[edge] + (int64_t)columns * step_x + (int64_t)rows * down);
    while ((int32_t)value < 0 && x != innermost) {
        x += inwards;
        value += rise;
    }
    while ((int32_t)(value - rise) >= 0 && x != outermost) {
        x -= inwards;
        value -= rise;
    }
    side->x = x;
    side->rise = rise;
    side->fall = magnitude32(down);
    if (down < 0) {
        side->margin = value;
        side->move = inwards;
        side->stop = innermost;
    } else {
        side->margin = rise - 1 - value; /* -1 - E' one pixel further out */
        side->move = -inwards;
        side->stop = outermost;
    }
    side->margin += side->fall; /* as it was in the row above */
}

/* The ends of rows along one edge, to every other place of `end`. */
static void take_rows(glint_side *side, uint16_t *end, int count)
{
    const uint32_t fall = side->fall, rise = side->rise;
    const int move = side->move, stop = side->stop;
    uint16_t *const behind = end + 2 * count;
    uint32_t margin = side->margin;
    int x = side->x;
    while (end != behind) {
        margin -= fall;
        while ((int32_t)margin < 0 && x != stop) {
            x += move;
            margin += rise;
        }
        *end = (uint16_t)x;
        end += 2;
    }
    side->margin = margin;
    side->x = x;
}

int glint_spans_take(glint_spans *spans)
{
    const glint_edges *const edges = spans->edges;
    const int left = spans->y_end - spans->y, count = left < GLINT_SPAN_ROWS ? left : GLINT_SPAN_ROWS;
    spans->count = count;
    if (count > 0) {
        const bool bend_left = edges->bend_left;
        glint_side *const bending = bend_left ? &spans->left : &spans->right;
        uint16_t *end = bend_left ? &spans->row[0].first : &spans->row[0].end;
        int lower = count;
        if (spans->y_bend - spans->y < count) {
            const int upper = spans->y_bend - spans->y;
            take_rows(bending, end, upper);
            take_edge(bending, edges, bend_left ? edges->left[1] : edges->right[1], !bend_left, spans->y_bend);
            spans->y_bend = INT16_MAX;
            end += 2 * upper;
            lower -= upper;
        }
        take_rows(bending, end, lower);
        take_rows(bend_left ? &spans->right : &spans->left, bend_left ? &spans->row[0].end : &spans->row[0].first,
                  count);
        spans->y += count;
    }
    return count;
}

void glint_spans_begin(glint_spans *spans, const glint_edges *edges, int16_t y_first, int16_t y_last)
{
    const int lower = edges->row_of_bend <= y_first; /* the bend is behind */
    spans->edges = edges;
    spans->y = y_first;
    spans->y_bend = lower ? INT16_MAX : edges->row_of_bend;
    spans->y_end = y_last + 1;
    spans->taken = spans->count = 0;
    spans->left.x = edges->box.x_first;
    spans->right.x = edges->box.x_last + 1;
    take_edge(&spans->left, edges, edges->left[lower], false, y_first);
    take_edge(&spans->right, edges, edges->right[lower], true, y_first);
}
