/* SPDX-License-Identifier: MIT */
/*
 * Exact coverage of triangles on the sub-pixel grid, in whole evaluations of the edge functions. It knows nothing of
 * the rest of the reference: it judges the library's own snapped corners.
 *
 * Range: coordinates within 2^29, so differences within 2^30, products within 2^60 and sums within 2^61.
 */
#include "internal.h"

#define SUB_PX 256

/* Twice the signed area of a, b, (x, y); with y down it is positive when they turn clockwise to the eye. */
static int64_t edge_function(const int32_t a[2], const int32_t b[2], int64_t x, int64_t y)
{
    return ((int64_t)b[0] - a[0]) * (y - a[1]) - ((int64_t)b[1] - a[1]) * (x - a[0]);
}

/* Edge a-b of a triangle whose edge functions are positive inside. One step right changes the function by -(b_y - a_y),
 * one step down by b_x - a_x: so the inside is on the right of an edge that runs up, and below one that runs right. */
static bool owns_its_points(const int32_t a[2], const int32_t b[2])
{
    return b[1] < a[1] || (b[1] == a[1] && b[0] > a[0]);
}

static int32_t least(int32_t a, int32_t b, int32_t c)
{
    int32_t m = a < b ? a : b;
    return m < c ? m : c;
}

static int32_t greatest(int32_t a, int32_t b, int32_t c)
{
    return -least(-a, -b, -c);
}

/* The pixel that holds a coordinate, cut to -1..size. */
static int pixel_of(int32_t coordinate, int size)
{
    int32_t pixel = coordinate >= 0 ? coordinate / SUB_PX : -1;
    return pixel > size ? size : pixel;
}

long reference_cover(const int32_t corners[3][2], int width, int height, reference_covered covered, void *context)
{
    const int32_t *p[3] = {corners[0], corners[1], corners[2]};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 2; k++) {
            if (p[i][k] < -REFERENCE_MAX_COORDINATE || p[i][k] > REFERENCE_MAX_COORDINATE) {
                return -1;
            }
        }
    }
    int64_t area = edge_function(p[0], p[1], p[2][0], p[2][1]);
    if (area == 0) {
        return 0;
    }
    if (area < 0) {
        p[1] = corners[2];
        p[2] = corners[1];
    }
    int x0 = pixel_of(least(p[0][0], p[1][0], p[2][0]), width),
        x1 = pixel_of(greatest(p[0][0], p[1][0], p[2][0]), width);
    int y0 = pixel_of(least(p[0][1], p[1][1], p[2][1]), height);
    int y1 = pixel_of(greatest(p[0][1], p[1][1], p[2][1]), height);
    long count = 0;
    for (int y = y0 < 0 ? 0 : y0; y <= y1 && y < height; y++) {
        for (int x = x0 < 0 ? 0 : x0; x <= x1 && x < width; x++) {
            bool inside = true;
            for (int i = 0; i < 3; i++) {
                const int32_t *a = p[i], *b = p[(i + 1) % 3];
                int64_t e = edge_function(a, b, (int64_t)x * SUB_PX + SUB_PX / 2, (int64_t)y * SUB_PX + SUB_PX / 2);
                inside = inside && (e > 0 || (e == 0 && owns_its_points(a, b)));
            }
            if (inside) {
                count++;
                if (covered) {
                    covered(context, x, y);
                }
            }
        }
    }
    return count;
}
