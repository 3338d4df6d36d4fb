/* SPDX-License-Identifier: MIT */
/*
 * How much of a light's intensity reaches a point, in fixed point: attenuation with distance, and the cone of a spot
 * light. The formulas are those of glint_attenuation and glint_light in <glint/scene.h>.
 *
 * A distance may be anything from 2^-20 to 2^20 near distances, so it is kept as a mantissa and an exponent
 * (glint_far); no product is wider than 32 bits' upper half.
 *
 * Error of a factor: at most 8e-5 for the attenuation (rounding to Q16 of the window's u and u^2 makes 3e-5 and 1.5e-5,
 * the factors' rounding to Q15 and that of their product 1.5e-5 each) and 5e-5 for the cone (found by
 * tests/unit/test_reach.h); and what an uncertain direction of the light makes of a cone's edge.
 */
#ifndef GLINT_LIGHTING_REACH_FIXED_H
#define GLINT_LIGHTING_REACH_FIXED_H

#include <stddef.h>

#include "lighting/light_fixed.h"

/* m 2^-f with 2^31 <= m < 2^32, or m = 0. */
typedef struct glint_far {
    uint32_t m;
    int16_t f;
} glint_far;

typedef struct light_reach {
    glint_far per_unit, per_range; /* the near distance in those of the attenuation; m = 0: there is no such term */
    uint16_t k_q14[3];
    bool has_cone;
    real axis_q28[3];  /* of the cone, from the surface to the light */
    uint32_t edge_q30; /* 1 - cos outer */
    glint_far per_gap; /* 1 / (cos inner - cos outer) */
} light_reach;

static inline glint_far far_from(uint32_t value, int fraction)
{
    const int up = clz32(value) & 31; /* 0 stays 0 */
    GLINT_TRACE("distance's fraction", fraction + up);
    const glint_far far = {value << up, (int16_t)(fraction + up)};
    return far;
}

/* Relative error 2^-30 for a product, 2^-28.2 for an inverse. */
static inline glint_far far_times(glint_far a, glint_far b)
{
    return far_from(multiply_high_u32(a.m, b.m), a.f + b.f - 32);
}

static inline glint_far far_inverse(glint_far a)
{
    return far_from(glint_reciprocal_q31(a.m), 62 - a.f);
}

/* In Q`fraction`, rounded down; UINT32_MAX where it does not fit. */
static inline uint32_t far_fixed(glint_far a, int fraction)
{
    const int down = a.f - fraction;
    return down > 31 || a.m == 0 ? 0 : down < 0 ? UINT32_MAX : a.m >> down;
}

static inline void light_reach_set_up(light_reach *reach, const glint_frame *frame, const glint_view *view,
                                      const glint_light *light)
{
    const glint_attenuation *const from = &light->attenuation;
    const glint_far none = {0, 0};
    /* a surface's inverse distance is in units of GLINT_DEPTH_SPAN, not 2^30 */
    const glint_far near =
        far_times(far_from((uint32_t)view->near_units.m, view->near_units.f), far_from((uint32_t)GLINT_DEPTH_SPAN, 30));
    reach->per_unit = reach->per_range = none;
    for (int i = 0; i < 3; i++) {
        reach->k_q14[i] = from->k_q14[i];
    }
    if ((from->k_q14[0] | from->k_q14[1] | from->k_q14[2]) != 0) {
        const uint32_t unit_q16 = from->unit_q16 ? from->unit_q16 : (uint32_t)1 << 16;
        reach->per_unit = far_times(near, far_inverse(far_from(unit_q16, 16)));
    }
    if (from->range_q16 != 0) {
        reach->per_range = far_times(near, far_inverse(far_from(from->range_q16, 16)));
    }
    reach->has_cone = light->kind == GLINT_SPOT;
    if (reach->has_cone) {
        int32_t sine_q30, inner_q30, outer_q30;
        glint_light_direction(frame, light, reach->axis_q28);
        for (int k = 0; k < 3; k++) {
            reach->axis_q28[k] = (reach->axis_q28[k] + 2) >> 2;
        }
        glint_sine_cosine_q30(light->inner_turn16, &sine_q30, &inner_q30);
        glint_sine_cosine_q30(light->outer_turn16, &sine_q30, &outer_q30);
        reach->edge_q30 = (uint32_t)(((int32_t)1 << 30) - outer_q30);
        reach->per_gap = far_inverse(far_from((uint32_t)(inner_q30 - outer_q30), 30));
    }
}

/*
 * The distance from a surface to a light, in near distances: |v| over the inverse distance of the surface; `towards` is
 * the unit vector along v, of which v has `fraction` bits. Rounding makes that too long or too short by some ulp, which
 * its square tells; what is left is of second order. Relative error 2^-26.
 */
static inline glint_far reach_distance(const surface *at, const real v[3], int fraction, const real towards[3])
{
    const int up = clz32(magnitude32(v[0]) | magnitude32(v[1]) | magnitude32(v[2])) - 2; /* below 2^30: -1..29 */
    int32_t along = 0;
    for (int k = 0; k < 3; k++) {
        const int32_t fine = up >= 0 ? (int32_t)((uint32_t)v[k] << up) : v[k] >> 1;
        along += multiply_high_s32(fine, towards[k] * ((int32_t)1 << 15)); /* |.| <= sqrt(3) 2^28 in all */
        GLINT_TRACE("distance along its direction", along);
    }
    /* (|s|^2 - 1) / 2, below 2^-13 */
    const uint32_t square_q30 =
        (uint32_t)(towards[0] * towards[0]) + (uint32_t)(towards[1] * towards[1]) + (uint32_t)(towards[2] * towards[2]);
    const int32_t longer_q30 = (int32_t)(square_q30 - ((uint32_t)1 << 30)) >> 1;
    along -= multiply_high_s32(along, longer_q30) * 4;
    const uint32_t inverse = at->inverse > 0 ? (uint32_t)at->inverse : 1;
    const glint_far length = far_from((uint32_t)positive_part(along), fraction + up - 2);
    return far_times(length, far_inverse(far_from(inverse, at->inverse_fraction)));
}

/* k0 + k1 t + k2 t^2 in Q`fraction`, at most 18; UINT32_MAX from 2^30 on. */
static inline uint32_t reach_divisor(const light_reach *reach, glint_far t, glint_far square, int fraction)
{
    const glint_far power[3] = {{(uint32_t)1 << 31, 31}, t, square};
    uint32_t sum = 0;
    for (int i = 0; i < 3; i++) {
        const uint32_t term = far_fixed(far_times(power[i], far_from(reach->k_q14[i], 14)), fraction);
        if (term >> 30 != 0) {
            return UINT32_MAX;
        }
        sum += term;
    }
    GLINT_TRACE("attenuation's divisor", sum);
    return sum;
}

/* min(1, 1 / (k0 + k1 t + k2 t^2)), Q15. */
static inline uint32_t reach_quotient_q15(const light_reach *reach, glint_far distance)
{
    const glint_far t = far_times(distance, reach->per_unit), square = far_times(t, t);
    uint32_t divisor = reach_divisor(reach, t, square, 18);
    int fraction = 18;
    if (divisor <= (uint32_t)1 << 18) {
        return 32768;
    }
    if (divisor == UINT32_MAX) { /* above 2^12 */
        fraction = 10;
        divisor = reach_divisor(reach, t, square, fraction);
    }
    /* 2^(15 + fraction) / divisor = r 2^-(down + 1), fraction + up at most 31 */
    const int up = clz32(divisor), down = 46 - fraction - up;
    return down > 31 ? 0 : ((glint_reciprocal_q31(divisor << up) >> down) + 1) >> 1;
}

/* max(0, 1 - u^4), Q15. */
static inline uint32_t reach_window_q15(const light_reach *reach, glint_far distance)
{
    const uint32_t u_q17 = far_fixed(far_times(distance, reach->per_range), 17), u_q16 = (u_q17 >> 1) + (u_q17 & 1);
    if (u_q16 >= 65536) {
        return 0;
    }
    const uint32_t square_q16 = (u_q16 * u_q16 + ((uint32_t)1 << 15)) >> 16; /* 65535 at most */
    const uint32_t rest_q32 = 0u - square_q16 * square_q16; /* modulo 2^32: for a square of 0 it is 0 */
    return square_q16 < 64 ? 32768 : ((rest_q32 >> 16) + 1) >> 1;
}

/*
 * The cone's factor, Q15. 1 - cosine is |s - axis|^2 / 2 of the unit vectors in Q28, so that a narrow cone far from the
 * right angle keeps its precision.
 */
static inline uint32_t reach_cone_q15(const light_reach *reach, const real v[3])
{
    real s[3];
    uint32_t any = 0, gap_q30 = 0;
    if (!glint_unit_q28(v, s)) {
        return 0; /* light_towards() has found a direction, so this does not happen */
    }
    for (int k = 0; k < 3; k++) {
        s[k] -= reach->axis_q28[k]; /* at most 2^29 */
        any |= magnitude32(s[k]);
    }
    /* the greatest difference to 30 bits; a square, halved, in Q(56 + 2 up - 32 + 1) */
    const int up = clz32(any | 1) - 2;
    for (int k = 0; k < 3; k++) {
        const uint32_t d = magnitude32(s[k]) << up;
        gap_q30 += multiply_high_u32(d, d); /* below 3 2^28 */
        GLINT_TRACE("difference from a cone's axis q28", s[k]);
    }
    GLINT_TRACE("half a cone's square", gap_q30);
    gap_q30 = far_fixed(far_from(gap_q30, 25 + 2 * up), 30);
    if (gap_q30 >= reach->edge_q30) {
        return 0;
    }
    const uint32_t share_q16 = far_fixed(far_times(far_from(reach->edge_q30 - gap_q30, 30), reach->per_gap), 16);
    return share_q16 >= 65536 ? 32768 : ((share_q16 * share_q16 >> 16) + 1) >> 1;
}

/* How much of the light arrives: Q15, 0..32768. `v`, of `fraction` bits, and `towards` are from light_towards(). */
static inline real light_reach_factor(const light_reach *reach, const surface *at, const real v[3], int fraction,
                                      const real towards[3])
{
    uint32_t factor_q15 = 32768;
    if (reach->per_range.m != 0 || reach->per_unit.m != 0) {
        const glint_far distance = reach_distance(at, v, fraction, towards);
        if (reach->per_range.m != 0) {
            factor_q15 = reach_window_q15(reach, distance);
        }
        if (reach->per_unit.m != 0 && factor_q15 != 0) {
            factor_q15 = (factor_q15 * reach_quotient_q15(reach, distance) + (1 << 14)) >> 15;
        }
    }
    if (reach->has_cone && factor_q15 != 0) {
        factor_q15 = (factor_q15 * reach_cone_q15(reach, v) + (1 << 14)) >> 15;
    }
    GLINT_TRACE("reach factor q15", factor_q15);
    return (real)factor_q15;
}

/*
 * What a factor's error can change of a light of `peak` (1/256 code), in 1/256 code: 1.3e-4 of it; and at a cone's
 * edge, of which the square's slope is at most 2 sin(outer) / (cos inner - cos outer), what an error of the direction
 * of 2e-6 makes: positions err by a relative 2^-27, which counts for more by as much as the surface is nearer to the
 * light than to the eye, up to 64 times here.
 */
static inline uint32_t light_reach_error_q8(const light_reach *reach, uint32_t peak_q8)
{
    if (reach == NULL) {
        return 0;
    }
    /* 4e-6 / (cos inner - cos outer), Q16: 2^-18 of it */
    const uint32_t edge_q16 = reach->has_cone ? far_fixed(reach->per_gap, 0) / 4 + 1 : 0;
    return ((peak_q8 * 9) >> 16) + multiply_high_u32(peak_q8 << 8, edge_q16 << 8) + 1;
}

#endif
