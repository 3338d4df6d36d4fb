/* SPDX-License-Identifier: MIT */
#include "raster/gradients.h"

static int32_t depth_range(const glint_gradients *gradients)
{
    int32_t least = gradients->corner[0]->depth_q30, greatest = least;
    for (int i = 1; i < 3; i++) {
        const int32_t depth = gradients->corner[i]->depth_q30;
        least = depth < least ? depth : least;
        greatest = depth > greatest ? depth : greatest;
    }
    return greatest - least;
}

/* The edge opposite corner 1 runs from 2 to 0, that opposite corner 2 from 0 to 1. */
static const glint_screen_vertex *opposite_from(const glint_gradients *gradients, int i)
{
    return gradients->corner[i == 0 ? 2 : 0];
}

static const glint_screen_vertex *opposite_to(const glint_gradients *gradients, int i)
{
    return gradients->corner[i == 0 ? 0 : 1];
}

void glint_gradients_set_up(glint_gradients *gradients, const glint_screen_vertex *const corner[3],
                            const uint8_t order[3])
{
    int32_t dx[2], dy[2];
    uint32_t any = 0;
    for (int i = 0; i < 3; i++) {
        gradients->corner[i] = corner[order[i]];
    }
    for (int i = 0; i < 2; i++) {
        const glint_screen_vertex *from = opposite_from(gradients, i), *to = opposite_to(gradients, i);
        dx[i] = to->x - from->x; /* < 2^24 */
        dy[i] = to->y - from->y;
        GLINT_TRACE("gradient difference q12", dx[i]);
        GLINT_TRACE("gradient difference q12", dy[i]);
        any |= magnitude32(dx[i]) | magnitude32(dy[i]);
    }
    gradients->area = (int64_t)dx[1] * -dy[0] + (int64_t)dx[0] * dy[1]; /* < 2^48 */
    GLINT_TRACE("gradient area q24", gradients->area);
    const int area_bits = gradients->area > 0 ? bit_length64((uint64_t)gradients->area) : 0;
    const int bits = 32 - clz32(any); /* of the longest side, <= 24 */
    /* |gradient| < 2^excess per pixel */
    const int excess = bits + GLINT_FINE_BITS - area_bits + 1;
    /*
     * The depth, at most 2 range 2^(excess - 8) beyond the corners' range, has to stay within the margin of
     * GLINT_DEPTH_BIAS (2^20), half of which is left for rounding.
     */
    const int range_bits = 32 - clz32((uint32_t)depth_range(gradients));
    gradients->sliver = area_bits == 0 || excess > 0 || range_bits + excess - 7 > 19;
    if (gradients->sliver) {
        return;
    }
    gradients->anchor_x = (int16_t)(gradients->corner[0]->x >> GLINT_FINE_BITS);
    gradients->anchor_y = (int16_t)(gradients->corner[0]->y >> GLINT_FINE_BITS);
    gradients->offset_x = (int16_t)(GLINT_FINE / 2 - (gradients->corner[0]->x & (GLINT_FINE - 1)));
    gradients->offset_y = (int16_t)(GLINT_FINE / 2 - (gradients->corner[0]->y & (GLINT_FINE - 1)));
    /* area = a 2^(area_bits-32) with a normalised; 1/area = r 2^(-30-area_bits), r < 2^31 */
    const uint32_t a =
        (uint32_t)(area_bits > 32 ? gradients->area >> (area_bits - 32) : gradients->area << (32 - area_bits));
    const int32_t r = (int32_t)glint_reciprocal_q31(a);
    /* a side, brought to 30 bits, times r: d r 2^(30 - bits - 32); d / area per 1/4096 px, in Q30 per px, is that times
     * 2^-down */
    const int down = area_bits - bits - GLINT_FINE_BITS - 2; /* >= -1 by the limit on excess */
    for (int i = 0; i < 2; i++) {
        const int32_t x = shift_round32(multiply_high_s32(-dy[i] * ((int32_t)1 << (30 - bits)), r), down);
        GLINT_TRACE("gradient", x);
        gradients->x[i] = x;
        const int32_t y = shift_round32(multiply_high_s32(dx[i] * ((int32_t)1 << (30 - bits)), r), down);
        GLINT_TRACE("gradient", y);
        gradients->y[i] = y;
    }
}

void glint_gradients_weights(const glint_gradients *gradients, int16_t x, int16_t y, int32_t weight_q30[2])
{
    const int32_t centre_x = x * GLINT_FINE + GLINT_FINE / 2, centre_y = y * GLINT_FINE + GLINT_FINE / 2;
    const int64_t area = gradients->area > 0 ? gradients->area : 1;
    const int down = bit_length64((uint64_t)area) - 32;
    const uint32_t r = glint_reciprocal_q31((uint32_t)(down > 0 ? area >> down : area << -down));
    int32_t rest = (int32_t)1 << 30;
    for (int i = 0; i < 2; i++) {
        const glint_screen_vertex *from = opposite_from(gradients, i), *to = opposite_to(gradients, i);
        const int64_t inside =
            (int64_t)(to->x - from->x) * (centre_y - from->y) - (int64_t)(to->y - from->y) * (centre_x - from->x);
        int32_t weight = 0;
        if (inside >= area) {
            weight = rest;
        } else if (inside > 0) {
            /* inside / area = (inside 2^-down) r / 2^62 */
            const uint32_t part = (uint32_t)(down > 0 ? inside >> down : inside << -down);
            weight = (int32_t)(((uint64_t)part * r) >> 32);
            GLINT_TRACE("sliver weight q30", weight);
            weight = weight > rest ? rest : weight;
        }
        rest -= weight;
        weight_q30[i] = weight;
    }
}
