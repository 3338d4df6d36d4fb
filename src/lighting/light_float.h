/* SPDX-License-Identifier: MIT */
/*
 * The operations of the light terms in float. See light_fixed.h for what each does.
 */
#ifndef GLINT_LIGHTING_LIGHT_FLOAT_H
#define GLINT_LIGHTING_LIGHT_FLOAT_H

#include "display/pack.h"
#include "geometry/view.h"
#include "number/real.h"

typedef float real;

typedef struct light_product {
    float channel[3];
} light_product;

typedef struct light_sum {
    float channel[3];
} light_sum;

static inline light_product light_multiply(const glint_colour *reflectance, const glint_colour *intensity)
{
    const float scale = 1.0f / ((float)16384 * (float)16384);
    const light_product product = {{
        (float)reflectance->r_q14 * (float)intensity->r_q14 * scale,
        (float)reflectance->g_q14 * (float)intensity->g_q14 * scale,
        (float)reflectance->b_q14 * (float)intensity->b_q14 * scale,
    }};
    return product;
}

static inline bool light_product_is_zero(const light_product *product)
{
    return product->channel[0] == 0.0f && product->channel[1] == 0.0f && product->channel[2] == 0.0f;
}

static inline void light_add(light_sum *sum, const light_product *product, real factor)
{
    for (int k = 0; k < 3; k++) {
        sum->channel[k] += product->channel[k] * factor;
    }
}

static inline void light_start(light_sum *sum, const light_product *ambient)
{
    for (int k = 0; k < 3; k++) {
        sum->channel[k] = ambient->channel[k];
    }
}

static inline uint16_t light_clamp(float value)
{
    /* written so that NaN becomes black */
    return value >= 1.0f ? 32768 : value > 0.0f ? (uint16_t)(value * 32768.0f + 0.5f) : 0;
}

static inline glint_shade light_finish(const light_sum *sum)
{
    const glint_shade shade = {light_clamp(sum->channel[0]), light_clamp(sum->channel[1]),
                               light_clamp(sum->channel[2])};
    return shade;
}

static inline bool unit(const real v[3], real out[3])
{
    return glint_unit(v, out);
}

static inline real cosine_of(const real a[3], const real b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline float gap_between(const real a[3], const real b[3])
{
    const float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return 0.5f * (x * x + y * y + z * z);
}

static inline float gap_mirror(const real n[3], const real s[3], const real c[3], real cosine_ns)
{
    const float twice = 2.0f * cosine_ns;
    const real r[3] = {twice * n[0] - s[0], twice * n[1] - s[1], twice * n[2] - s[2]};
    return gap_between(r, c);
}

static inline bool gap_half(const real n[3], const real s[3], const real c[3], const real towards[3], const real ray[3],
                            float *gap)
{
    (void)towards; /* s and c are as precise */
    (void)ray;
    const real sum[3] = {s[0] + c[0], s[1] + c[1], s[2] + c[2]};
    real h[3];
    if (cosine_of(sum, sum) < 1e-12f || !unit(sum, h)) {
        return false;
    }
    *gap = gap_between(n, h);
    return true;
}

typedef float light_gap;
typedef float light_exponent;

static inline light_exponent exponent_from(uint16_t exponent_q4)
{
    return (float)exponent_q4 * (1.0f / 16);
}

static inline real light_power(light_gap gap, light_exponent exponent)
{
    return glint_power(gap, exponent);
}

typedef struct surface {
    real normal[3];
    real ray[3];
    real inverse;
} surface;

typedef struct light_place {
    real v[3];
} light_place;

static inline void light_place_direction(light_place *place, const glint_frame *frame, const glint_light *light)
{
    int32_t unit_q30[3];
    glint_light_direction(frame, light, unit_q30);
    for (int k = 0; k < 3; k++) {
        place->v[k] = float_from_scaled(unit_q30[k], 30);
    }
}

static inline const real *light_fine(const light_place *place)
{
    return place->v;
}

static inline void light_place_position(light_place *place, const glint_frame *frame, const glint_view *view,
                                        const glint_light *light)
{
    int32_t position[3];
    int16_t fraction;
    glint_light_position(frame, view, light, position, &fraction);
    for (int k = 0; k < 3; k++) {
        place->v[k] = float_from_scaled(position[k], fraction);
    }
}

static inline bool light_towards(const light_place *light, const surface *at, real v[3], real out[3])
{
    for (int k = 0; k < 3; k++) {
        v[k] = light->v[k] * at->inverse - at->ray[k];
    }
    const float limit = 1.0f / 32768;
    return cosine_of(v, v) > cosine_of(at->ray, at->ray) * (limit * limit) && unit(v, out);
}

#endif
