/* SPDX-License-Identifier: MIT */
#include "effects/fog.h"

#define ONE_Q15 32768u

/* x as an integer, rounded down; UINT32_MAX where it does not fit. */
static uint32_t whole_of(glint_scaled x)
{
    return x.f > 30 ? 0 : x.f < 0 ? UINT32_MAX : (uint32_t)x.m >> x.f;
}

static glint_shade shade_of(const glint_colour *colour)
{
    const glint_shade shade = {(uint16_t)((uint16_t)colour->r_q14 << 1), (uint16_t)((uint16_t)colour->g_q14 << 1),
                               (uint16_t)((uint16_t)colour->b_q14 << 1)};
    return shade;
}

void glint_fog_set_up(glint_fog_state *fog, const glint_fog *from, const glint_view *view)
{
    fog->present = from->begin_q16 != 0 || from->end_q16 != 0;
    if (!fog->present) {
        return;
    }
    const uint32_t begin_q16 = (uint32_t)from->begin_q16, end_q16 = (uint32_t)from->end_q16;
    const uint32_t deep_q16 = end_q16 - begin_q16;
    const glint_scaled near_span = glint_scaled_times(view->near_units, (uint32_t)GLINT_DEPTH_SPAN, 0);
    const glint_scaled per_depth = glint_scaled_inverse(glint_scaled_from(deep_q16, 16));
    /* end < 2^i and deep >= 2^(k - 1) of i and k bits: T < 2^(i - k + 1), 1..23 */
    const int steep_bits = clz32(deep_q16) - clz32(end_q16) + 1;
    fog->fraction = (int8_t)(28 - steep_bits);
    fog->colour = shade_of(&from->colour);
    fog->a = glint_scaled_times(near_span, (uint32_t)per_depth.m, per_depth.f);
    fog->b = 0;
    fog->clear_q30 = UINT32_MAX;
    if (begin_q16 != 0) {
        const glint_scaled b = glint_scaled_times(per_depth, begin_q16, 16);
        const int down = b.f - fog->fraction; /* above 0: b < T < 2^(28 - fraction) */
        fog->b = down > 31 ? 0 : ((uint32_t)b.m + ((uint32_t)1 << (down - 1))) >> down;
        const glint_scaled inverse = glint_scaled_inverse(glint_scaled_from(begin_q16, 16));
        const uint32_t clear = whole_of(glint_scaled_times(near_span, (uint32_t)inverse.m, inverse.f));
        fog->clear_q30 = clear == UINT32_MAX ? clear : clear + 1;
    }
    const glint_scaled inverse = glint_scaled_inverse(glint_scaled_from(end_q16, 16));
    const uint32_t whole = whole_of(glint_scaled_times(near_span, (uint32_t)inverse.m, inverse.f));
    fog->whole_q30 = whole >> 31 != 0 ? INT32_MAX : whole; /* d is below 2^31 */
    /* a fog so shallow that rounding closes it */
    fog->clear_q30 = fog->clear_q30 > fog->whole_q30 ? fog->clear_q30 : fog->whole_q30 + 1;
    const glint_scaled steepest = glint_scaled_times(per_depth, end_q16, 12);
    fog->steepest_q4 = whole_of(steepest) + 1; /* at most 2^27 */
    GLINT_TRACE("fog's steepness q4", fog->steepest_q4);
    GLINT_TRACE("fog's fraction", fog->fraction);
    GLINT_TRACE("fog's begin", fog->b);
}

uint32_t glint_fog_q15(const glint_fog_state *fog, uint32_t d_q30)
{
    if (d_q30 >= fog->clear_q30) {
        return 0;
    }
    if (d_q30 <= fog->whole_q30 || d_q30 == 0) {
        return ONE_Q15;
    }
    const int up = clz32(d_q30), fraction = fog->fraction;
    const uint32_t r = glint_reciprocal_q31(d_q30 << up);
    /* a.m 2^-a.f r 2^(up - 62), of which the product's upper half is a.m r 2^-31; at least 2^29, and A / d < 2^28 */
    const uint32_t product = multiply_high_u32((uint32_t)fog->a.m << 1, r);
    const int down = 31 + fog->a.f - fraction - up;
    GLINT_TRACE("fog shift", down); /* A / d is at least near / deep, 2^-24 */
    const uint32_t t = down > 31 ? 0 : down < 1 ? UINT32_MAX : ((product >> (down - 1)) + 1) >> 1;
    if (t <= fog->b) {
        return 0;
    }
    const uint32_t share = t - fog->b; /* below 2^28, but for rounding at f = 1 */
    GLINT_TRACE("fog's share", share);
    if (share >> fraction != 0) {
        return ONE_Q15;
    }
    return fraction > 15 ? ((share >> (fraction - 16)) + 1) >> 1 : share << (15 - fraction);
}

static uint16_t mix(uint16_t from, uint16_t to, uint32_t f_q15)
{
    /* |to - from| <= 2^15 and f <= 2^15 */
    const int32_t way = (int32_t)to - from;
    const int32_t mixed = from + ((way * (int32_t)f_q15 + (1 << 14)) >> 15);
    GLINT_TRACE("mixed colour q15", mixed);
    return (uint16_t)mixed;
}

void glint_fog_mix(glint_shade *shade, const glint_shade *colour, uint32_t f_q15)
{
    shade->r_q15 = mix(shade->r_q15, colour->r_q15, f_q15);
    shade->g_q15 = mix(shade->g_q15, colour->g_q15, f_q15);
    shade->b_q15 = mix(shade->b_q15, colour->b_q15, f_q15);
}

uint16_t glint_fog_error_q8(const glint_fog_state *fog, uint32_t least_q30, uint32_t error)
{
    /* nearer than the fog, and beyond its end, f does not change */
    const uint32_t d = least_q30 > fog->whole_q30 ? least_q30 : fog->whole_q30;
    const int up = clz32(d | 1);
    /* error / d = error r 2^(up - 62): the upper half of error 2^16 r is that in Q(46 - up) */
    const uint32_t part = multiply_high_u32(error << 16, glint_reciprocal_q31((d | 1) << up)) + 1; /* below 2^30 */
    /* a code is 1/255: 1/256 of it counts 2^-16 of f; T has 4 bits of its own */
    const uint64_t from_depth = ((uint64_t)part * fog->steepest_q4 >> (34 - up)) + 1;
    /* T 2^-20 for the vertices, and T 2^-26; the last bit of A / d and of B; the rounding of f and of the colour */
    const uint64_t sum = from_depth + (fog->steepest_q4 >> 8) + (fog->steepest_q4 >> 14) + 2 +
                         (fog->fraction >= 16 ? 2 : (uint32_t)2 << (16 - fog->fraction)) + 2;
    return sum < UINT16_MAX ? (uint16_t)sum : UINT16_MAX;
}
