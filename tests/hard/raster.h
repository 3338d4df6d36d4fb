/* SPDX-License-Identifier: MIT */
/*
 * Triangles straight into the library's edge functions and spans, and counts of how often each pixel is covered. Both
 * backends share this code.
 */
#ifndef GLINT_TESTS_HARD_RASTER_H
#define GLINT_TESTS_HARD_RASTER_H

#include "tests/hard/hard.h"

#include "raster/edges.h"

#define RASTER_CANARY 64

typedef struct raster {
    int width, height;
    uint8_t *count; /* width x height, and a canary behind */
} raster;

static inline raster raster_make(int width, int height)
{
    raster r = {width, height, malloc((size_t)width * (size_t)height + RASTER_CANARY)};
    assert_non_null(r.count);
    memset(r.count, 0, (size_t)width * (size_t)height);
    memset(r.count + (size_t)width * (size_t)height, FRAME_CANARY_BYTE, RASTER_CANARY);
    return r;
}

static inline void raster_free(raster *r)
{
    for (int i = 0; i < RASTER_CANARY; i++) {
        assert_int_equal(r->count[(size_t)r->width * (size_t)r->height + (size_t)i], FRAME_CANARY_BYTE);
    }
    free(r->count);
    r->count = NULL;
}

/* Adds 1 at each covered pixel, of either winding; returns their number. */
static inline long raster_add(raster *r, const glint_point corner[3])
{
    const int64_t area = glint_signed_area(corner);
    glint_box box;
    glint_bounding_box(&box, corner, (uint16_t)r->width, (uint16_t)r->height);
    glint_edges edges;
    glint_spans spans;
    int16_t y, first, last;
    long pixels = 0;
    if (area == 0 || box.x_first > box.x_last || box.y_first > box.y_last) {
        return 0;
    }
    glint_edges_set_up(&edges, corner, area > 0, box);
    glint_spans_begin(&spans, &edges, box.y_first, box.y_last);
    while (glint_spans_next(&spans, &y, &first, &last)) {
        uint8_t *row = r->count + (size_t)y * (size_t)r->width;
        assert_true(y >= 0 && y < r->height && first >= 0 && last < r->width);
        for (int16_t x = first; x <= last; x++) {
            row[x]++;
            pixels++;
        }
    }
    return pixels;
}

static inline void raster_mark(void *context, int x, int y)
{
    raster *r = context;
    r->count[(size_t)y * (size_t)r->width + (size_t)x]++;
}

/* The same by the reference's exact coverage. */
static inline long raster_add_reference(raster *r, const glint_point corner[3])
{
    const int32_t corners[3][2] = {{corner[0].x, corner[0].y}, {corner[1].x, corner[1].y}, {corner[2].x, corner[2].y}};
    const long pixels = reference_cover(corners, r->width, r->height, raster_mark, r);
    assert_true(pixels >= 0);
    return pixels;
}

/* The edge function of a naive rasterizer at a pixel's centre, in int64 so that it does not overflow. */
static inline int64_t edge_at(const glint_point *from, const glint_point *to, int64_t x, int64_t y)
{
    return (int64_t)(to->x - from->x) * (y - from->y) - (int64_t)(to->y - from->y) * (x - from->x);
}

/* Naive coverage: inside where all three edge functions are above 0 (or at least 0), without a fill rule. `offset` is
 * from the pixel's corner to where it is sampled. */
static inline long raster_add_naive(raster *r, const glint_point corner[3], bool with_edges, int offset)
{
    const int turned = glint_signed_area(corner) < 0;
    const glint_point *p[3] = {&corner[0], &corner[turned ? 2 : 1], &corner[turned ? 1 : 2]};
    long pixels = 0;
    for (int y = 0; y < r->height; y++) {
        for (int x = 0; x < r->width; x++) {
            bool inside = true;
            for (int i = 0; i < 3; i++) {
                const int64_t e = edge_at(p[i], p[(i + 1) % 3], 256 * (int64_t)x + offset, 256 * (int64_t)y + offset);
                inside = inside && (with_edges ? e >= 0 : e > 0);
            }
            r->count[(size_t)y * (size_t)r->width + (size_t)x] += inside;
            pixels += inside;
        }
    }
    return pixels;
}

/* Pixels of the raster with a count other than 1. */
static inline long raster_not_once(const raster *r)
{
    long wrong = 0;
    for (int i = 0; i < r->width * r->height; i++) {
        wrong += r->count[i] != 1;
    }
    return wrong;
}

static inline bool raster_same(const raster *a, const raster *b)
{
    return memcmp(a->count, b->count, (size_t)a->width * (size_t)a->height) == 0;
}

static inline void raster_clear(raster *r)
{
    memset(r->count, 0, (size_t)r->width * (size_t)r->height);
}

#endif
