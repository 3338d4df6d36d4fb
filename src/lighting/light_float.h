/* SPDX-License-Identifier: MIT */
/*
 * The operations of the light terms in float. See light_fixed.h for what each does.
 */
#ifndef GLINT_LIGHTING_LIGHT_FLOAT_H
#define GLINT_LIGHTING_LIGHT_FLOAT_H

#include "display/pack.h"
#include "geometry/view.h"
#include "lighting/bound.h"
#include "lighting/ramp.h"
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

static inline void light_add_row(light_sum *sum, const light_product *product, const real *factor, uint16_t count)
{
    for (uint16_t i = 0; i < count; i++) {
        light_add(&sum[i], product, factor[i]);
    }
}

static inline void light_start(light_sum *sum, const light_product *ambient)
{
    for (int k = 0; k < 3; k++) {
        sum->channel[k] = ambient->channel[k];
    }
}

static inline void light_emit(light_product *ambient, const glint_colour *emission)
{
    ambient->channel[0] += (float)emission->r_q14 * (1.0f / 16384);
    ambient->channel[1] += (float)emission->g_q14 * (1.0f / 16384);
    ambient->channel[2] += (float)emission->b_q14 * (1.0f / 16384);
}

static inline real half_more(real cosine)
{
    const float half = 0.5f + 0.5f * cosine;
    return half < 0.0f ? 0.0f : half;
}

static inline real light_part(real factor, real share)
{
    return factor * share;
}

static inline void light_start_row(light_sum *sum, const light_product *ambient, uint32_t terms, uint16_t count)
{
    (void)terms;
    for (uint16_t i = 0; i < count; i++) {
        light_start(&sum[i], ambient);
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

static inline real light_share(uint32_t q15)
{
    return (float)q15 * (1.0f / 32768);
}

static inline int32_t cosine_q15(real cosine)
{
    return (int32_t)(cosine * 32768.0f);
}

static inline uint32_t chord_q16(const real a[3], const real b[3])
{
    const float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return (uint32_t)((x * x + y * y + z * z) * 65536.0f + 0.999f);
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

static inline void mirrored(const real n[3], const real s[3], real cosine_ns, real r[3])
{
    const float twice = 2.0f * cosine_ns;
    for (int k = 0; k < 3; k++) {
        r[k] = twice * n[k] - s[k];
    }
}

static inline bool half_vector(const real s[3], const real c[3], const real towards[3], const real ray[3], real h[3])
{
    (void)towards; /* s and c are as precise */
    (void)ray;
    const real sum[3] = {s[0] + c[0], s[1] + c[1], s[2] + c[2]};
    return cosine_of(sum, sum) >= 1e-12f && unit(sum, h);
}

typedef float light_gap;
typedef float light_exponent;

#define WIDE_GAP_ONE 1.0f
#define LIGHT_GAP_ONE 1.0f

typedef float wide_gap;

static inline wide_gap wide_gap_between(const real a[3], const real b[3])
{
    return gap_between(a, b);
}

static inline uint32_t wide_gap_q31(wide_gap gap)
{
    return gap >= 1.0f ? (uint32_t)1 << 31 : (uint32_t)(gap * 2147483648.0f);
}

typedef struct gap_row {
    float value, step, bend;
} gap_row;

static inline void gap_row_through(gap_row *row, wide_gap first, wide_gap second, wide_gap third, int log2)
{
    const float a = first - 2.0f * second + third, part = 1.0f / (float)(1 << log2);
    row->value = first;
    row->bend = a * part * part;
    row->step = (second - first - 0.5f * a) * part + 0.5f * row->bend;
}

static inline wide_gap gap_row_next(gap_row *row)
{
    const float value = row->value;
    row->value += row->step;
    row->step += row->bend;
    return value;
}

static inline uint32_t wide_gap_q28(wide_gap gap)
{
    return gap > 0.0f ? (uint32_t)(gap * 268435456.0f) : 0;
}

static inline light_gap gap_from_q28(uint32_t gap_q28)
{
    return gap_q28 >= (uint32_t)1 << 28 ? 1.0f : (float)gap_q28 * (1.0f / 268435456);
}

static inline uint16_t factor_q15(float factor)
{
    return (uint16_t)(factor * 32768.0f + 0.5f);
}

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

static inline int light_vector_fraction(const light_place *light, const surface *at)
{
    (void)light;
    (void)at;
    return 0;
}

static inline bool light_towards(const light_place *light, const surface *at, real v[3], real out[3])
{
    for (int k = 0; k < 3; k++) {
        v[k] = light->v[k] * at->inverse - at->ray[k];
    }
    const float limit = 1.0f / 32768;
    return cosine_of(v, v) > cosine_of(at->ray, at->ray) * (limit * limit) && unit(v, out);
}

static inline real mean_of(real a, real b)
{
    return 0.5f * (a + b);
}

static inline uint32_t turn_square_q16(const real v0[3], const real v1[3], const real v2[3])
{
    const real *const v[3] = {v0, v1, v2};
    float edge = 0.0f, least = cosine_of(v[0], v[0]);
    for (int i = 0; i < 3; i++) {
        const real *const a = v[i], *const b = v[i == 2 ? 0 : i + 1];
        const real d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const float apart = cosine_of(d, d), length = cosine_of(a, a);
        edge = apart > edge ? apart : edge;
        least = length < least ? length : least;
    }
    const float short_square = least - edge * (1.0f / 3);
    const float inverse = short_square > 0.0f ? glint_inverse_root(short_square) : 0.0f;
    return edge < 0.5f * short_square ? (uint32_t)(edge * inverse * inverse * 65536.0f) + 2 : UINT32_MAX;
}

static inline void light_fold_step(real *step, real cosine, real share)
{
    *step += cosine * share;
}

static inline void light_fold_channel(real channel[3], real cosine, const light_product *product)
{
    for (int c = 0; c < 3; c++) {
        channel[c] += cosine * product->channel[c];
    }
}

static inline void light_fold(real sum[3], const real towards[3], real share)
{
    for (int k = 0; k < 3; k++) {
        sum[k] += towards[k] * share;
    }
}

static inline void light_fold_channels(real sum[3][3], const real towards[3], const light_product *product)
{
    for (int c = 0; c < 3; c++) {
        light_fold(sum[c], towards, product->channel[c]);
    }
}

#endif
