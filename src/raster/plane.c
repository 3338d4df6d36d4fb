/* SPDX-License-Identifier: MIT */
#include "raster/plane.h"

/*
 * (g1 d1 + g2 d2) / 2^30 for |g| < 2^30, Q30, and |d| <= 2^30, by six 16 x 16 bit products. With g = high 2^16 + low
 * and so d, the products of two low halves are left out: 2^30 each at most, so 2 units of the step; rounding down takes
 * less than another.
 */
static uint32_t step(const int32_t gradient_q30[2], const int32_t high[2], const int32_t low[2])
{
    int32_t upper = 0, cross = 0;
    for (int i = 0; i < 2; i++) {
        const int32_t g_low = low_half(gradient_q30[i]), g_high = high_half(gradient_q30[i]);
        upper += g_high * high[i]; /* |.| <= 2^28, the sum 2^29 */
        /* |high| <= 2^14, |low| <= 2^15: 2^29 each. A high half is 2^14 only with a low one of 0 or less, so that +2^31
         * is not reached by the sum of four */
        cross += g_high * low[i] + g_low * high[i];
    }
    return ((uint32_t)upper << 2) + (uint32_t)(cross >> 14);
}

void glint_plane_set_up(glint_plane *plane, const glint_gradients *gradients, int32_t v0, int32_t v1, int32_t v2)
{
    const int32_t d1 = v1 - v0, d2 = v2 - v0; /* <= 2^30 */
    GLINT_TRACE("plane difference", d1);
    GLINT_TRACE("plane difference", d2);
    const int32_t high[2] = {high_half(d1), high_half(d2)}, low[2] = {low_half(d1), low_half(d2)};
    const int32_t x = (int32_t)step(gradients->x, high, low), y = (int32_t)step(gradients->y, high, low);
    GLINT_TRACE("plane step", x);
    GLINT_TRACE("plane step", y);
    plane->step_x = (uint32_t)x;
    plane->step_y = (uint32_t)y;
    /* from corner 0 to the anchor's centre, at most half a pixel either way: |offset| <= 2^11, so the whole parts of
     * the steps give 2^30 each, the fractions 2^23 */
    const int32_t whole = (x >> GLINT_FINE_BITS) * gradients->offset_x + (y >> GLINT_FINE_BITS) * gradients->offset_y;
    const int32_t fraction =
        (x & (GLINT_FINE - 1)) * gradients->offset_x + (y & (GLINT_FINE - 1)) * gradients->offset_y;
    plane->value = (uint32_t)v0 + (uint32_t)whole + (uint32_t)(fraction >> GLINT_FINE_BITS);
}

int32_t glint_plane_weigh(const int32_t weight_q30[2], int32_t v0, int32_t v1, int32_t v2)
{
    const int64_t way = (multiply_wide_s32(weight_q30[0], v1 - v0) + multiply_wide_s32(weight_q30[1], v2 - v0)) >> 30;
    GLINT_TRACE("sliver way", way);
    return v0 + (int32_t)way;
}
