/* SPDX-License-Identifier: MIT */
/*
 * Fields over a triangle in fixed point: the linear ones that a light's cosine is made of, and the quadratic one of the
 * normal's length. All are made from the planes of the normal M, Q29 (|M| <= 1).
 *
 * Arithmetic is modulo 2^32 like that of raster/plane.h: coefficients of a steep triangle may wrap, the values at its
 * pixels do not.
 */
#ifndef GLINT_RASTER_FIELD_FIXED_H
#define GLINT_RASTER_FIELD_FIXED_H

#include "lighting/bound.h"
#include "raster/attribute_fixed.h"

/* The unit vector along (x, y, z), Q29 and of a length from 1/2 to 1, in Q15: glint_unit_q15() without its scaling.
 * Written out, like what follows: a loop of three costs small processors as much again. */
static inline void field_unit(int32_t x, int32_t y, int32_t z, real out[3])
{
    const int32_t half = 1 << 13;
    const int32_t u = (x + half) >> 14, v = (y + half) >> 14, w = (z + half) >> 14;
    const uint32_t beyond = (uint32_t)(u + 32768) | (uint32_t)(v + 32768) | (uint32_t)(w + 32768);
    const uint32_t square =
        beyond >> 16 ? 0 : (uint32_t)(u * u) + (uint32_t)(v * v) + (uint32_t)(w * w); /* <= 3 2^30 */
    if (square - ((uint32_t)1 << 28) >= ((uint32_t)1 << 30) - ((uint32_t)1 << 28)) {
        const int32_t any[3] = {x, y, z};
        (void)glint_unit_q15(any, out); /* beyond the triangle, or by rounding */
        return;
    }
    const int32_t inverse = (int32_t)glint_inverse_root_q16(square << 2), round = 1 << 14; /* 2^15 / |M| */
    out[0] = (u * inverse + round) >> 15;
    out[1] = (v * inverse + round) >> 15;
    out[2] = (w * inverse + round) >> 15;
}

/* The unit normal at a pixel. */
static inline void field_normal(const attribute_plane m[3], const glint_gradients *gradients, int16_t x, int16_t y,
                                real out[3])
{
    const uint32_t dx = (uint32_t)((int32_t)x - gradients->anchor_x), dy = (uint32_t)((int32_t)y - gradients->anchor_y);
    field_unit((int32_t)(m[0].value + dx * m[0].step_x + dy * m[0].step_y),
               (int32_t)(m[1].value + dx * m[1].step_x + dy * m[1].step_y),
               (int32_t)(m[2].value + dx * m[2].step_x + dy * m[2].step_y), out);
}

/* The unit vector along a pixel's ray. Rays are 1 to 2 long where the field of view is below 120 degrees. */
static inline void ray_unit(const pixel_rays *rays, int16_t x, int16_t y, real out[3])
{
    const int down = rays->fraction - 28;
    const int32_t ray[3] = {rays->v[0][0] + x * rays->v[1][0] + y * rays->v[2][0],
                            rays->v[0][1] + x * rays->v[1][1] + y * rays->v[2][1],
                            rays->v[0][2] + x * rays->v[1][2] + y * rays->v[2][2]};
    if (down < 0 || down > 4) {
        (void)unit(ray, out);
    } else {
        field_unit(ray[0] >> down, ray[1] >> down, ray[2] >> down, out);
    }
}

/* |r - c|^2 / 2 with r = 2 (n.s) n - s and c = -ray, Q28: of what a highlight is made. */
static inline wide_gap field_gap(const real n[3], const real s[3], const real ray[3])
{
    const int32_t twice = (n[0] * s[0] + n[1] * s[1] + n[2] * s[2] + (1 << 14)) >> 15, round = 1 << 13;
    const int32_t x = ((twice * n[0] + round) >> 14) - s[0] + ray[0];
    const int32_t y = ((twice * n[1] + round) >> 14) - s[1] + ray[1];
    const int32_t z = ((twice * n[2] + round) >> 14) - s[2] + ray[2];
    return (wide_gap)(wide_square(x) + wide_square(y) + wide_square(z));
}

/* The greater of |dM/dx| and |dM/dy|, and the former alone, a pixel; Q20, rounded up. */
static inline uint32_t field_rate_q20(const attribute_plane normal[3], uint32_t *along)
{
    uint32_t any = 1, x = 0, y = 0;
    for (int k = 0; k < 3; k++) {
        any |= magnitude32((int32_t)normal[k].step_x) | magnitude32((int32_t)normal[k].step_y);
    }
    const int down = 32 - clz32(any) - 15; /* to 15 bits */
    for (int k = 0; k < 3; k++) {
        const int32_t dx = (int32_t)normal[k].step_x, dy = (int32_t)normal[k].step_y;
        const int32_t fine_x = down >= 0 ? dx >> down : dx * ((int32_t)1 << -down);
        const int32_t fine_y = down >= 0 ? dy >> down : dy * ((int32_t)1 << -down);
        x += (uint32_t)(fine_x * fine_x);
        y += (uint32_t)(fine_y * fine_y);
    }
    /* Q(29 - down); 8 units: 2^-13.4 of 15 bits and 1 of the root, sqrt(3) of the cuts */
    const uint32_t root_x = glint_square_root_u32(x) + 8, root_y = glint_square_root_u32(y) + 8;
    const uint32_t most = root_x > root_y ? root_x : root_y;
    const int up = down - 9;
    *along = up >= 0 ? root_x << up : (root_x >> -up) + 1;
    return up >= 0 ? most << up : (most >> -up) + 1;
}

/* A component of a unit normal (Q15) by a weight (Q15): Q29. */
static inline real field_weigh(real component_q15, uint16_t weight_q15)
{
    return (component_q15 * (int32_t)weight_q15) >> 1;
}

/* M . v in Q28 for a unit vector v (Q15): a rounding of 3 units in the value and in a step. */
static inline void field_dot(attribute_plane *dot, const attribute_plane normal[3], const real v[3])
{
    int32_t value = 0, x = 0, y = 0;
    for (int k = 0; k < 3; k++) {
        value += multiply_q16((int32_t)normal[k].value, v[k]);
        x += multiply_q16((int32_t)normal[k].step_x, v[k]);
        y += multiply_q16((int32_t)normal[k].step_y, v[k]);
    }
    dot->value = (uint32_t)value + (1 << 12); /* half of what field_cosine() drops */
    dot->step_x = (uint32_t)x;
    dot->step_y = (uint32_t)y;
}

/* M . v in Q26 for the sum of folded lights in one channel, Q28: v is cut to 15 bits for the products. */
static inline void field_dot_channel(attribute_plane *dot, const attribute_plane normal[3], const real v_q28[3])
{
    const uint32_t any = magnitude32(v_q28[0]) | magnitude32(v_q28[1]) | magnitude32(v_q28[2]);
    const int down = 32 - clz32(any) > 15 ? 32 - clz32(any) - 15 : 0; /* at most 16: 4 in Q28 has 31 bits */
    const real v[3] = {shift_round32(v_q28[0], down), shift_round32(v_q28[1], down), shift_round32(v_q28[2], down)};
    field_dot(dot, normal, v);
    /* Q29 Q(28 - down) / 2^16 = Q(41 - down) */
    dot->value = (uint32_t)shift_round32((int32_t)(dot->value - (1 << 12)), 15 - down) + (1 << 11);
    dot->step_x = (uint32_t)shift_round32((int32_t)dot->step_x, 15 - down);
    dot->step_y = (uint32_t)shift_round32((int32_t)dot->step_y, 15 - down);
}

/* A cosine's field (Q28) times a share: Q28 again. */
static inline void field_scale(attribute_plane *field, real share_q15)
{
    field->value = (uint32_t)multiply_q16((int32_t)field->value, share_q15) << 1;
    field->step_x = (uint32_t)multiply_q16((int32_t)field->step_x, share_q15) << 1;
    field->step_y = (uint32_t)multiply_q16((int32_t)field->step_y, share_q15) << 1;
}

/* Half of what is dropped of a length from Q30 to Q14. */
#define HALF_LENGTH ((int32_t)1 << 15)

/* A field's value at a pixel is the same whichever pixel the steps began at. */
#define FIELD_STEPS_EXACT true

/* value + x dx + y dy + xx dx^2 + xy dx dy + yy dy^2 at dx, dy pixels from the anchor, Q30. */
typedef struct field_quadratic {
    uint32_t value, x, y, xx, xy, yy;
} field_quadratic;

/* One row of it from a pixel on: the value, its step, and the step's. */
typedef struct field_row {
    uint32_t value, step, bend;
} field_row;

/* a . b / 2^32 */
static inline int32_t field_product(const int32_t a[3], const int32_t b[3])
{
    return multiply_high_s32(a[0], b[0]) + multiply_high_s32(a[1], b[1]) + multiply_high_s32(a[2], b[2]);
}

/*
 * y = 1 - |M|^2 for a curve of degree 2; the curve itself, c0 + c1 y, for one of degree 1. False where the planes are
 * too steep for it within `reach` pixels of the anchor: errors are 2^-22 of the square of what M changes by, and 2^-31
 * of the square of the distance.
 */
static inline bool field_square_set_up(field_quadratic *field, const attribute_plane normal[3],
                                       const glint_curve *curve, uint8_t tier, uint32_t reach)
{
    int32_t value[3], x[3], y[3];
    uint32_t any = 1, farthest = 0;
    for (int k = 0; k < 3; k++) {
        value[k] = (int32_t)normal[k].value;
        any |= magnitude32((int32_t)normal[k].step_x) | magnitude32((int32_t)normal[k].step_y);
        farthest |= magnitude32(value[k]);
    }
    const int up = clz32(any) - 2;
    if (up < 0 || farthest >= (uint32_t)1 << 30 || (any >> 13) * reach > (uint32_t)GLINT_REACH_MOST << 16) {
        return false; /* steep, or so small that M at the anchor lies far outside */
    }
    for (int k = 0; k < 3; k++) {
        x[k] = (int32_t)(normal[k].step_x << up); /* Q(29 + up), 30 bits */
        y[k] = (int32_t)(normal[k].step_y << up);
    }
    /* each component below 2: 12 2^26 at most */
    const int32_t square_q26 = field_product(value, value);
    if (square_q26 >= (int32_t)1 << 29) {
        return false;
    }
    /* half the slope in Q(26 + up): 2^1 sqrt(3) 2^28 */
    int32_t slope_x = field_product(value, x), slope_y = field_product(value, y);
    /* Q(26 + 2 up): at most 3 2^28 */
    int32_t xx = field_product(x, x), xy = field_product(x, y), yy = field_product(y, y);
    uint32_t square_q30 = (uint32_t)square_q26 << 4;
    int lost = 0;
    if (tier == GLINT_TIER_Q1) {
        /* times c1, with 2 bits more of it: a coefficient has half the bits then */
        const int32_t c1_q30 = (int32_t)curve->c_q15[1] * 32768;
        slope_x = multiply_high_s32(slope_x, c1_q30);
        slope_y = multiply_high_s32(slope_y, c1_q30);
        xx = multiply_high_s32(xx, c1_q30);
        xy = multiply_high_s32(xy, c1_q30);
        yy = multiply_high_s32(yy, c1_q30);
        lost = 2;
        square_q30 = (uint32_t)multiply_high_s32(square_q26 * 4, c1_q30) << 4;
        field->value = ((uint32_t)(curve->c_q15[0] + (uint32_t)curve->c_q15[1]) << 15) - square_q30 + HALF_LENGTH;
    } else {
        field->value = ((uint32_t)1 << 30) - square_q30 + (1 << 14); /* half of what field_length() drops */
    }
    field->x = 0u - (uint32_t)shift_round32(slope_x, up - 5 - lost);
    field->y = 0u - (uint32_t)shift_round32(slope_y, up - 5 - lost);
    field->xx = 0u - (uint32_t)shift_round32(xx, 2 * up - 4 - lost);
    field->xy = 0u - (uint32_t)shift_round32(xy, 2 * up - 5 - lost);
    field->yy = 0u - (uint32_t)shift_round32(yy, 2 * up - 4 - lost);
    return true;
}

/* dx, dy pixels from the anchor. */
static inline field_row field_quadratic_from(const field_quadratic *field, int32_t right, int32_t below)
{
    const uint32_t dx = (uint32_t)right, dy = (uint32_t)below, along = field->x + dy * field->xy, bend = dx * field->xx;
    const field_row row = {field->value + dy * (field->y + dy * field->yy) + dx * (along + bend),
                           along + 2 * bend + field->xx, 2 * field->xx};
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

/* The polynomial that is left to evaluate at each pixel: of degree 2 in the field; for lower ones the field is the
 * curve itself. */
typedef struct field_curve {
    int32_t c0_q30, c1_q15, c2_q15;
} field_curve;

static inline void field_curve_from(field_curve *polynomial, const glint_curve *curve)
{
    polynomial->c0_q30 = (int32_t)curve->c_q15[0] * 32768 + HALF_LENGTH;
    polynomial->c1_q15 = curve->c_q15[1];
    polynomial->c2_q15 = curve->c_q15[2];
}

/* x^(-1/2) in Q14, where the row has come to `value`. */
static inline int32_t field_length(uint32_t value, const field_curve *curve, bool second_degree)
{
    if (!second_degree) {
        return (int32_t)(value >> 16);
    }
    const int32_t y_q15 = (int32_t)value >> 15; /* -2^-11..1/2 */
    return (curve->c0_q30 + y_q15 * (curve->c1_q15 + ((curve->c2_q15 * y_q15) >> 15))) >> 16;
}

/* s |M|^-1, from Q28 and Q14: a cosine in Q15, signed. */
static inline int32_t field_cosine(int32_t s, int32_t length_q14)
{
    return ((s >> 13) * length_q14) >> 14; /* <= 2^15 2^15.2 */
}

/* The same of a share, clamped to 0: steps of the ramp, Q19. */
static inline int32_t field_share(int32_t s, int32_t length_q14)
{
    const int32_t t = (s >> 13) * length_q14;
    return positive_part(t);
}

static inline uint16_t field_step(int32_t t)
{
    return (uint16_t)(t >> 19);
}

typedef int32_t field_value;

/* What a curve of degree 2 over the triangle has come to, as steps of the ramp (Q19), and as a cosine. */
static inline int32_t field_curve_step(uint32_t value)
{
    return positive_part((int32_t)value);
}

static inline void field_row_skip(field_row *row, uint16_t count)
{
    const uint32_t n = count;
    row->value += n * row->step + (n * (n - 1) >> 1) * row->bend;
    row->step += n * row->bend;
}

/* Is a curve through these steps at the corners certainly above 0 all over the triangle? Between it stays above the
 * least of them, 1/32 here, less the greatest error of a curve, 0.0262 0.69^3. */
static inline bool field_steps_positive(const real step[3])
{
    const int32_t least = (int32_t)1 << 24;
    return step[0] > least && step[1] > least && step[2] > least;
}

static inline int32_t field_curve_cosine(uint32_t value_q28)
{
    return (int32_t)value_q28 >> 13;
}

/* A cosine (Q15) at a corner, for a curve. */
static inline int32_t field_from_cosine(int32_t cosine)
{
    return cosine * (1 << 13);
}

static inline int32_t field_to_cosine(int32_t cosine_q28)
{
    return (cosine_q28 + (1 << 12)) >> 13;
}

/* A specular term's factor (Q15) by its share (Q15), to steps of the ramp. */
static inline int32_t field_gloss(int32_t factor, int32_t share)
{
    return (factor * share) >> 1;
}

/* Adds a channel of the folded lights (Q26) to a sum (Q16). */
static inline void light_add_channel(light_sum *sum, int channel, int32_t s, int32_t length_q14)
{
    const int32_t light = ((s >> 12) * length_q14) >> 12; /* |s| <= 4, the length at most sqrt(2): 2^16 2^14.5 */
    sum->q16[channel] += (uint32_t)positive_part(light);
}

/* The same of a curve's value (Q26). */
static inline void light_add_curve(light_sum *sum, int channel, uint32_t value_q26)
{
    sum->q16[channel] += (uint32_t)positive_part((int32_t)value_q26) >> 10;
}

/*
 * A row of pixels out of the ramp. The loops carry nothing that they need not: the first has the curve as its field.
 */
static inline void field_run_first(uint16_t *at, const uint16_t *end, const uint16_t *pixel, int32_t s,
                                   const attribute_plane *share, field_row row)
{
    const uint32_t step = share->step_x, bend = row.bend;
    uint32_t value = row.value, slope = row.step;
    do {
        const int32_t t = (s >> 13) * (int32_t)(value >> 16);
        *at++ = pixel[positive_part(t) >> 19];
        s = (int32_t)((uint32_t)s + step);
        value += slope;
        slope += bend;
    } while (at != end);
}

static inline void field_run_second(uint16_t *at, const uint16_t *end, const uint16_t *pixel, int32_t s,
                                    const attribute_plane *share, field_row row, const field_curve *curve)
{
    do {
        *at++ = pixel[field_step(field_share(s, field_length(row.value, curve, true)))];
        s = (int32_t)((uint32_t)s + share->step_x);
        row.value += row.step;
        row.step += row.bend;
    } while (at != end);
}

/* Along a curve of degree 2, which is not negative on the row. First what makes the rest a number of fours: nothing is
 * left to be carried on behind the loop then. */
static inline void field_run_curve(uint16_t *at, uint32_t count, const uint16_t *pixel, field_row row)
{
    const uint16_t *const end = at + count;
    const uint32_t bend = row.bend;
    uint32_t value = row.value, slope = row.step;
    if (count & 1) {
        *at++ = pixel[value >> 19];
        value += slope;
        slope += bend;
    }
    if (count & 2) {
        at[0] = pixel[value >> 19];
        value += slope;
        slope += bend;
        at[1] = pixel[value >> 19];
        value += slope;
        slope += bend;
        at += 2;
    }
    while (at != end) {
        at[0] = pixel[value >> 19];
        value += slope;
        slope += bend;
        at[1] = pixel[value >> 19];
        value += slope;
        slope += bend;
        at[2] = pixel[value >> 19];
        value += slope;
        slope += bend;
        at[3] = pixel[value >> 19];
        value += slope;
        slope += bend;
        at += 4;
    }
}

/* The same with something added at each pixel; returns where the curve has come to. */
static inline field_row field_run_curve_and(uint16_t *at, const uint16_t *end, const uint16_t *pixel, field_row row,
                                            const field_value *more)
{
    while (at != end) {
        *at++ = pixel[(row.value + (uint32_t)*more++) >> 19];
        field_row_next(&row);
    }
    return row;
}

#endif
