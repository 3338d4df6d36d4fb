/* SPDX-License-Identifier: MIT */
/*
 * Fields over a triangle in float. See field_fixed.h for what each is.
 */
#ifndef GLINT_RASTER_FIELD_FLOAT_H
#define GLINT_RASTER_FIELD_FLOAT_H

#include "lighting/bound.h"
#include "raster/attribute_float.h"

static inline void field_normal(const attribute_plane m[3], const glint_gradients *gradients, int16_t x, int16_t y,
                                real out[3])
{
    const real v[3] = {attribute_at(&m[0], gradients, x, y), attribute_at(&m[1], gradients, x, y),
                       attribute_at(&m[2], gradients, x, y)};
    (void)unit(v, out);
}

static inline void ray_unit(const pixel_rays *rays, int16_t x, int16_t y, real out[3])
{
    surface at;
    surface_set_ray(&at, rays, x, y);
    (void)unit(at.ray, out);
}

static inline wide_gap field_gap(const real n[3], const real s[3], const real ray[3])
{
    const float twice = 2.0f * cosine_of(n, s);
    const float x = twice * n[0] - s[0] + ray[0], y = twice * n[1] - s[1] + ray[1], z = twice * n[2] - s[2] + ray[2];
    return 0.5f * (x * x + y * y + z * z);
}

static inline uint32_t field_rate_q20(const attribute_plane normal[3], uint32_t *along)
{
    const float x[3] = {normal[0].step_x, normal[1].step_x, normal[2].step_x};
    const float y[3] = {normal[0].step_y, normal[1].step_y, normal[2].step_y};
    const float rate_x = glint_square_root(cosine_of(x, x)), rate_y = glint_square_root(cosine_of(y, y));
    *along = rate_x < 2000.0f ? (uint32_t)(rate_x * 1048577.0f) + 1 : UINT32_MAX;
    return rate_y > rate_x ? rate_y < 2000.0f ? (uint32_t)(rate_y * 1048577.0f) + 1 : UINT32_MAX : *along;
}

static inline real field_weigh(real component, uint16_t weight_q15)
{
    return component * ((float)weight_q15 * (1.0f / 32768));
}

static inline void field_dot(attribute_plane *dot, const attribute_plane normal[3], const real v[3])
{
    dot->value = normal[0].value * v[0] + normal[1].value * v[1] + normal[2].value * v[2];
    dot->step_x = normal[0].step_x * v[0] + normal[1].step_x * v[1] + normal[2].step_x * v[2];
    dot->step_y = normal[0].step_y * v[0] + normal[1].step_y * v[1] + normal[2].step_y * v[2];
}

static inline void field_dot_channel(attribute_plane *dot, const attribute_plane normal[3], const real v[3])
{
    field_dot(dot, normal, v);
}

static inline void field_scale(attribute_plane *field, real share)
{
    field->value *= share;
    field->step_x *= share;
    field->step_y *= share;
}

/* Steps round, so a field's value at a pixel depends on where they began. */
#define FIELD_STEPS_EXACT false

typedef struct field_quadratic {
    float value, x, y, xx, xy, yy;
} field_quadratic;

typedef struct field_row {
    float value, step, bend;
} field_row;

static inline bool field_square_set_up(field_quadratic *field, const attribute_plane normal[3],
                                       const glint_curve *curve, uint8_t tier, uint32_t reach)
{
    (void)reach;
    const bool first_degree = tier == GLINT_TIER_Q1;
    const float c0 = first_degree ? (float)curve->c_q15[0] * (1.0f / 32768) : 0.0f;
    const float c1 = first_degree ? (float)curve->c_q15[1] * (1.0f / 32768) : 1.0f;
    const float m[3] = {normal[0].value, normal[1].value, normal[2].value};
    const float x[3] = {normal[0].step_x, normal[1].step_x, normal[2].step_x};
    const float y[3] = {normal[0].step_y, normal[1].step_y, normal[2].step_y};
    field->value = c0 + c1 * (1.0f - cosine_of(m, m));
    field->x = -2.0f * c1 * cosine_of(m, x);
    field->y = -2.0f * c1 * cosine_of(m, y);
    field->xx = -c1 * cosine_of(x, x);
    field->xy = -2.0f * c1 * cosine_of(x, y);
    field->yy = -c1 * cosine_of(y, y);
    return true;
}

static inline field_row field_quadratic_from(const field_quadratic *field, int32_t right, int32_t below)
{
    const float dx = (float)right, dy = (float)below;
    const float along = field->x + dy * field->xy;
    const field_row row = {field->value + dy * (field->y + dy * field->yy) + dx * (along + dx * field->xx),
                           along + (2.0f * dx + 1.0f) * field->xx, 2.0f * field->xx};
    return row;
}

static inline field_row field_quadratic_at(const field_quadratic *field, const glint_gradients *gradients, int16_t x,
                                           int16_t y)
{
    return field_quadratic_from(field, (int32_t)x - gradients->anchor_x, (int32_t)y - gradients->anchor_y);
}

static inline void field_row_next(field_row *row)
{
    row->value += row->step;
    row->step += row->bend;
}

typedef struct field_curve {
    float c0, c1, c2;
} field_curve;

static inline void field_curve_from(field_curve *polynomial, const glint_curve *curve)
{
    polynomial->c0 = (float)curve->c_q15[0] * (1.0f / 32768);
    polynomial->c1 = (float)curve->c_q15[1] * (1.0f / 32768);
    polynomial->c2 = (float)curve->c_q15[2] * (1.0f / 32768);
}

static inline float field_length(float value, const field_curve *curve, bool second_degree)
{
    return second_degree ? curve->c0 + value * (curve->c1 + curve->c2 * value) : value;
}

static inline float field_cosine(float s, float length)
{
    return s * length;
}

static inline float field_share(float s, float length)
{
    const float t = s * length;
    return t > 0.0f ? t : 0.0f;
}

static inline uint16_t field_step(float t)
{
    return (uint16_t)(t * (float)GLINT_RAMP_ENTRIES);
}

typedef float field_value;

static inline float field_curve_step(float value)
{
    return value > 0.0f ? value : 0.0f;
}

static inline void field_row_skip(field_row *row, uint16_t count)
{
    const float n = (float)count;
    row->value += n * row->step + 0.5f * n * (n - 1.0f) * row->bend;
    row->step += n * row->bend;
}

/* Is a curve through these steps at the corners certainly above 0 all over the triangle? Between it stays above the
 * least of them, 1/32 here, less the greatest error of a curve, 0.0275 0.69^3. */
static inline bool field_steps_positive(const real step[3])
{
    return step[0] > 0.03125f && step[1] > 0.03125f && step[2] > 0.03125f;
}

static inline float field_curve_cosine(float value)
{
    return value;
}

static inline float field_from_cosine(float cosine)
{
    return cosine;
}

static inline float field_to_cosine(float cosine)
{
    return cosine;
}

static inline void light_add_curve(light_sum *sum, int channel, float value)
{
    sum->channel[channel] += value > 0.0f ? value : 0.0f;
}

static inline float field_gloss(float factor, float share)
{
    return factor * share;
}

static inline void light_add_channel(light_sum *sum, int channel, float s, float length)
{
    const float light = s * length;
    sum->channel[channel] += light > 0.0f ? light : 0.0f;
}

static inline void field_run_second(uint16_t *at, const uint16_t *end, const uint16_t *pixel, float s,
                                    const attribute_plane *share, field_row row, const field_curve *curve)
{
    do {
        *at++ = pixel[field_step(field_share(s, field_length(row.value, curve, true)))];
        s += share->step_x;
        row.value += row.step;
        row.step += row.bend;
    } while (at != end);
}

static inline void field_run_first(uint16_t *at, const uint16_t *end, const uint16_t *pixel, float s,
                                   const attribute_plane *share, field_row row)
{
    do {
        *at++ = pixel[field_step(field_share(s, row.value))];
        s += share->step_x;
        row.value += row.step;
        row.step += row.bend;
    } while (at != end);
}

static inline void field_run_curve(uint16_t *at, uint32_t count, const uint16_t *pixel, field_row row)
{
    const uint16_t *const end = at + count;
    do {
        *at++ = pixel[field_step(row.value)];
        row.value += row.step;
        row.step += row.bend;
    } while (at != end);
}

static inline field_row field_run_curve_and(uint16_t *at, const uint16_t *end, const uint16_t *pixel, field_row row,
                                            const field_value *more)
{
    while (at != end) {
        *at++ = pixel[field_step(row.value + *more++)];
        field_row_next(&row);
    }
    return row;
}

#endif
