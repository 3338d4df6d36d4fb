/* SPDX-License-Identifier: MIT */
#include "raster/plane.h"

/* (g1 d1 + g2 d2) / 2^30 for d brought up by `up` bits to 30. */
static int32_t step(const int32_t gradient_q30[2], int32_t d1, int32_t d2, int up)
{
    /* |g| < 2^30, |d| <= 2^30: a product's upper half is within 2^28, and 2^2 2^-up times the sum within 2^31 */
    return shift_round32(multiply_high_s32(gradient_q30[0], d1) + multiply_high_s32(gradient_q30[1], d2), up - 2);
}

/* floor(step offset / 2^12) for |offset| <= 2^11 */
static int32_t part_of(int32_t step, int16_t offset)
{
    return (step >> GLINT_FINE_BITS) * offset + (((step & (GLINT_FINE - 1)) * (int32_t)offset) >> GLINT_FINE_BITS);
}

void glint_plane_set_up(glint_plane *plane, const glint_gradients *gradients, int32_t v0, int32_t v1, int32_t v2)
{
    int32_t d1 = v1 - v0, d2 = v2 - v0; /* <= 2^30 */
    GLINT_TRACE("plane difference", d1);
    GLINT_TRACE("plane difference", d2);
    const uint32_t any = magnitude32(d1) | magnitude32(d2);
    const int up = any > (uint32_t)1 << 29 ? 0 : clz32(any | 1) - 2;
    d1 *= (int32_t)1 << up;
    d2 *= (int32_t)1 << up;
    const int32_t x = step(gradients->x, d1, d2, up), y = step(gradients->y, d1, d2, up);
    GLINT_TRACE("plane step", x);
    GLINT_TRACE("plane step", y);
    plane->step_x = (uint32_t)x;
    plane->step_y = (uint32_t)y;
    /* from corner 0 to the anchor's centre, at most half a pixel either way */
    plane->value = (uint32_t)v0 + (uint32_t)(part_of(x, gradients->offset_x) + part_of(y, gradients->offset_y));
}

int32_t glint_plane_weigh(const int32_t weight_q30[2], int32_t v0, int32_t v1, int32_t v2)
{
    const int64_t way = ((int64_t)weight_q30[0] * (v1 - v0) + (int64_t)weight_q30[1] * (v2 - v0)) >> 30;
    GLINT_TRACE("sliver way", way);
    return v0 + (int32_t)way;
}
