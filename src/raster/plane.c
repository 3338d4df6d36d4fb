/* SPDX-License-Identifier: MIT */
#include "raster/plane.h"

void glint_plane_set_up(glint_plane *plane, const glint_gradients *gradients, int32_t v0, int32_t v1, int32_t v2)
{
    const int32_t d1 = v1 - v0, d2 = v2 - v0; /* <= 2^30 */
    const int bits = -gradients->bits;
    /* <= 2^61 */
    const int64_t x = shift_round64((int64_t)gradients->x[0] * d1 + (int64_t)gradients->x[1] * d2, bits);
    const int64_t y = shift_round64((int64_t)gradients->y[0] * d1 + (int64_t)gradients->y[1] * d2, bits);
    GLINT_TRACE("plane difference", d1);
    GLINT_TRACE("plane difference", d2);
    GLINT_TRACE("plane step", x);
    GLINT_TRACE("plane step", y);
    plane->step_x = (uint32_t)x;
    plane->step_y = (uint32_t)y;
    /* from corner 0 to the anchor's centre, at most half a pixel either way; |x| < 2^35 */
    plane->value = (uint32_t)v0 +
                   (uint32_t)((x * gradients->offset_x + y * gradients->offset_y + GLINT_FINE / 2) >> GLINT_FINE_BITS);
}

int32_t glint_plane_weigh(const int32_t weight_q30[2], int32_t v0, int32_t v1, int32_t v2)
{
    const int64_t way = ((int64_t)weight_q30[0] * (v1 - v0) + (int64_t)weight_q30[1] * (v2 - v0)) >> 30;
    GLINT_TRACE("sliver way", way);
    return v0 + (int32_t)way;
}
