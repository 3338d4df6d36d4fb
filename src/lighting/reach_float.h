/* SPDX-License-Identifier: MIT */
/*
 * How much of a light's intensity reaches a point, in float. See reach_fixed.h for what each does.
 *
 * Error of a factor: at most 5e-7 for the attenuation and 1e-5 for the cone, one of a degree having the most (found by
 * tests/unit/test_reach.h); and what the rounding of positions makes of them.
 */
#ifndef GLINT_LIGHTING_REACH_FLOAT_H
#define GLINT_LIGHTING_REACH_FLOAT_H

#include <stddef.h>

#include "lighting/light_float.h"

typedef struct light_reach {
    float per_unit, per_range; /* the near distance in those of the attenuation; 0: there is no such term */
    float k[3];
    bool has_cone;
    float axis[3];
    float edge, per_gap;
} light_reach;

static inline void light_reach_set_up(light_reach *reach, const glint_frame *frame, const glint_view *view,
                                      const glint_light *light)
{
    const glint_attenuation *const from = &light->attenuation;
    const float near = float_from_scaled(view->near_units.m, view->near_units.f);
    for (int i = 0; i < 3; i++) {
        reach->k[i] = (float)from->k_q14[i] * (1.0f / 16384);
    }
    const bool quotient = (from->k_q14[0] | from->k_q14[1] | from->k_q14[2]) != 0;
    reach->per_unit = quotient ? near * 65536.0f / (from->unit_q16 ? (float)from->unit_q16 : 65536.0f) : 0.0f;
    reach->per_range = from->range_q16 ? near * 65536.0f / (float)from->range_q16 : 0.0f;
    reach->has_cone = light->kind == GLINT_SPOT;
    if (reach->has_cone) {
        int32_t axis_q30[3], sine_q30, inner_q30, outer_q30;
        glint_light_direction(frame, light, axis_q30);
        glint_sine_cosine_q30(light->inner_turn16, &sine_q30, &inner_q30);
        glint_sine_cosine_q30(light->outer_turn16, &sine_q30, &outer_q30);
        for (int k = 0; k < 3; k++) {
            reach->axis[k] = float_from_scaled(axis_q30[k], 30);
        }
        reach->edge = float_from_scaled(((int32_t)1 << 30) - outer_q30, 30);
        reach->per_gap = 1.0f / float_from_scaled(inner_q30 - outer_q30, 30);
    }
}

static inline real light_reach_factor(const light_reach *reach, const surface *at, const real v[3], int fraction,
                                      const real towards[3])
{
    float factor = 1.0f;
    (void)fraction;
    if (reach->per_range > 0.0f || reach->per_unit > 0.0f) {
        const float distance = cosine_of(v, towards) / (at->inverse > 1e-30f ? at->inverse : 1e-30f);
        if (reach->per_range > 0.0f) {
            const float u = distance * reach->per_range, square = u * u;
            factor = square < 1.0f ? 1.0f - square * square : 0.0f;
        }
        if (reach->per_unit > 0.0f) {
            const float t = distance * reach->per_unit;
            const float divisor = reach->k[0] + t * (reach->k[1] + t * reach->k[2]);
            factor = divisor > 1.0f ? factor / divisor : factor;
        }
    }
    if (reach->has_cone) {
        const float share = (reach->edge - gap_between(towards, reach->axis)) * reach->per_gap;
        const float clamped = share >= 1.0f ? 1.0f : share > 0.0f ? share : 0.0f;
        factor *= clamped * clamped;
    }
    return factor;
}

/* What a factor's error can change of a light of `peak`, both in 1/256 code; see reach_fixed.h. */
static inline uint32_t light_reach_error_q8(const light_reach *reach, uint32_t peak_q8)
{
    if (reach == NULL) {
        return 0;
    }
    const float edge = reach->has_cone ? 2e-5f * reach->per_gap : 0.0f;
    return (uint32_t)((float)peak_q8 * (edge + 2e-5f)) + 1;
}

#endif
