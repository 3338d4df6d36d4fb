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

/* dx1 -dy0 + dx0 dy1 < 2^48. */
static int64_t area_of(const int32_t dx[2], const int32_t dy[2], uint32_t any)
{
    if (!GLINT_SHARE_CODE && any >> 20 == 0) {
        /* up to 256 px, dy in two parts of 10 bits: each sum of two products < 2^31 */
        const int32_t upper = dx[0] * (dy[1] >> 10) - dx[1] * (dy[0] >> 10);
        const int32_t lower = dx[0] * (dy[1] & 1023) - dx[1] * (dy[0] & 1023);
        return (int64_t)upper * 1024 + lower;
    }
    return multiply_wide_s32(dx[0], dy[1]) - multiply_wide_s32(dx[1], dy[0]);
}

/* d r / 2^31 2^-down, rounded, for |d| <= 2^30 and 2^30 <= r < 2^31 in halves. */
static GLINT_SHARED int32_t times(int32_t d, int32_t r_high, int32_t r_low, int down)
{
    const int32_t d_high = high_half(d), d_low = low_half(d);
    /* at most 2^14 2^15 + 2^15 2^15; the product of the low halves, left out, is at most 1/2 */
    const int32_t cross = d_high * r_low + d_low * r_high;
    const int32_t product = d_high * r_high * 2 + (cross >> 15); /* <= 2^30 */
    return (product + (((int32_t)1 << down) >> 1)) >> down;
}

void glint_gradients_set_up(glint_gradients *gradients, const glint_screen_vertex *const corner[3],
                            const uint8_t order[3])
{
    const glint_screen_vertex *const a = corner[order[0]], *const b = corner[order[1]], *const c = corner[order[2]];
    /* as opposite_from() and opposite_to() have them; < 2^24 */
    const int32_t dx[2] = {a->x - c->x, b->x - a->x}, dy[2] = {a->y - c->y, b->y - a->y};
    const uint32_t any = magnitude32(dx[0]) | magnitude32(dy[0]) | magnitude32(dx[1]) | magnitude32(dy[1]);
    GLINT_TRACE("gradient difference q12", dx[0]);
    GLINT_TRACE("gradient difference q12", dy[0]);
    GLINT_TRACE("gradient difference q12", dx[1]);
    GLINT_TRACE("gradient difference q12", dy[1]);
    gradients->corner[0] = a;
    gradients->corner[1] = b;
    gradients->corner[2] = c;
    gradients->area = area_of(dx, dy, any);
    GLINT_TRACE("gradient area q24", gradients->area);
    gradients->sliver = true;
    gradients->anchor_x = (int16_t)(a->x >> GLINT_FINE_BITS);
    gradients->anchor_y = (int16_t)(a->y >> GLINT_FINE_BITS);
    gradients->offset_x = gradients->offset_y = 0;
    if (gradients->area <= 0) {
        gradients->inverse_q31 = glint_reciprocal_q31((uint32_t)1 << 31);
        gradients->inverse_down = -31;
        return;
    }
    /* area = upper 2^(area_bits-32) with a leading one */
    int area_bits;
    const uint32_t upper = normalize64((uint64_t)gradients->area, &area_bits);
    gradients->inverse_q31 = glint_reciprocal_q31(upper);
    gradients->inverse_down = area_bits - 32;
    const int bits = 32 - clz32(any); /* of the longest side, <= 24 */
    /* |gradient| < 2^excess per pixel */
    const int excess = bits + GLINT_FINE_BITS - area_bits + 1;
    /*
     * The depth, at most 2 range 2^(excess - 8) beyond the corners' range, has to stay within the margin of
     * GLINT_DEPTH_BIAS (2^20), half of which is left for rounding: range < 2^(26 - excess). No range has 31 bits.
     */
    if (excess > 0 || (excess > -5 && depth_range(gradients) >> (26 - excess) != 0)) {
        return;
    }
    gradients->sliver = false;
    gradients->offset_x = (int16_t)(GLINT_FINE / 2 - (a->x & (GLINT_FINE - 1)));
    gradients->offset_y = (int16_t)(GLINT_FINE / 2 - (a->y & (GLINT_FINE - 1)));
    /* 1/area = r 2^(-30-area_bits), r < 2^31; the bits of the area that `upper` drops are a relative 2^-31 of it, half
     * a unit of a gradient at most */
    const int32_t r = (int32_t)gradients->inverse_q31, r_low = low_half(r);
    const int32_t r_high = (int32_t)(((uint32_t)r + 0x8000u) >> 16); /* 2^15 at most */
    /* a side, brought to 30 bits, times r: d r 2^(30 - bits - 31); d / area per 1/4096 px, in Q30 per px, is that times
     * 2^-down */
    const int up = 30 - bits, down = area_bits - bits - GLINT_FINE_BITS - 1; /* 0..12 by the limit on excess */
    for (int i = 0; i < 2; i++) {
        gradients->x[i] = times((int32_t)((uint32_t)-dy[i] << up), r_high, r_low, down);
        GLINT_TRACE("gradient", gradients->x[i]);
        gradients->y[i] = times((int32_t)((uint32_t)dx[i] << up), r_high, r_low, down);
        GLINT_TRACE("gradient", gradients->y[i]);
    }
}

void glint_gradients_weights(const glint_gradients *gradients, int16_t x, int16_t y, int32_t weight_q30[2])
{
    const int32_t centre_x = x * GLINT_FINE + GLINT_FINE / 2, centre_y = y * GLINT_FINE + GLINT_FINE / 2;
    const int64_t area = gradients->area > 0 ? gradients->area : 1;
    const int down = gradients->inverse_down;
    const uint32_t r = gradients->inverse_q31;
    int32_t rest = (int32_t)1 << 30;
    for (int i = 0; i < 2; i++) {
        const glint_screen_vertex *from = opposite_from(gradients, i), *to = opposite_to(gradients, i);
        const int64_t inside = multiply_wide_s32(to->x - from->x, centre_y - from->y) -
                               multiply_wide_s32(to->y - from->y, centre_x - from->x);
        int32_t weight = 0;
        if (inside >= area) {
            weight = rest;
        } else if (inside > 0) {
            /* inside / area = (inside 2^-down) r / 2^62 */
            const uint32_t part = (uint32_t)(down > 0 ? inside >> down : inside << -down);
            weight = (int32_t)multiply_high_u32(part, r);
            GLINT_TRACE("sliver weight q30", weight);
            weight = weight > rest ? rest : weight;
        }
        rest -= weight;
        weight_q30[i] = weight;
    }
}
