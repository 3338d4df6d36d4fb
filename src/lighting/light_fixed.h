/* SPDX-License-Identifier: MIT */
/*
 * The operations of the light terms in fixed point.
 *
 * Unit vectors are Q15 in int32_t (32768 is 1). A product of two components of unit vectors is at most 2^30 in
 * magnitude, and so is their dot product (Cauchy-Schwarz), partial sums included, but for rounding: that lengthens a
 * unit vector by at most 1.86 units, see number/fixed.h. So a dot product exceeds 2^30 by less than 2^18, and a cosine
 * 32768 by less than 8.
 *
 * The specular cosine enters as gap = 1 - cosine = |a - b|^2 / 2 of the two unit vectors: near the highlight's centre,
 * where a large exponent magnifies errors, rounding of a and b then enters the gap only to second order.
 */
#ifndef GLINT_LIGHTING_LIGHT_FIXED_H
#define GLINT_LIGHTING_LIGHT_FIXED_H

#include "display/pack.h"
#include "geometry/view.h"
#include "lighting/bound.h"
#include "lighting/ramp.h"
#include "lighting/source.h"

typedef int32_t real;

/* Intensity times reflectance of one channel each, Q15: 0..65536. */
typedef struct light_product {
    uint32_t q15[3];
} light_product;

/* Sum of light, Q16 a channel: with GLINT_MAX_LIGHTS lights of 2 (diffuse) + 2 (specular) at most 2^12 2^18 = 2^30, and
 * less than 2^18 more for the ambient light (2^17) and for cosines that rounding takes beyond 1. */
typedef struct light_sum {
    uint32_t q16[3];
} light_sum;

typedef char glint_assert_light_sum[(uint64_t)GLINT_MAX_LIGHTS * 4 * 65536 + 4 * 65536 < 0xffffffffu ? 1 : -1];

static GLINT_SHARED light_product light_multiply(const glint_colour *reflectance, const glint_colour *intensity)
{
    const light_product product = {{
        ((uint32_t)(int32_t)reflectance->r_q14 * (uint32_t)(int32_t)intensity->r_q14 + (1 << 12)) >> 13,
        ((uint32_t)(int32_t)reflectance->g_q14 * (uint32_t)(int32_t)intensity->g_q14 + (1 << 12)) >> 13,
        ((uint32_t)(int32_t)reflectance->b_q14 * (uint32_t)(int32_t)intensity->b_q14 + (1 << 12)) >> 13,
    }};
    return product;
}

/* One of `count` parts of a light, which add up to it. */
static inline void light_product_divide(light_product *product, uint8_t count, uint8_t number)
{
    for (int k = 0; k < 3; k++) {
        product->q15[k] = glint_source_part(product->q15[k], count, number);
    }
}

static inline bool light_product_is_zero(const light_product *product)
{
    return (product->q15[0] | product->q15[1] | product->q15[2]) == 0;
}

/* sum += product factor, factor Q15 0..32775: the product stays below 2^32 */
static inline void light_add(light_sum *sum, const light_product *product, real factor_q15)
{
    GLINT_TRACE("light factor q15", factor_q15);
    for (int k = 0; k < 3; k++) {
        sum->q16[k] += (product->q15[k] * (uint32_t)factor_q15 + (1 << 13)) >> 14;
        GLINT_TRACE("light product q15", product->q15[k]);
        GLINT_TRACE("light sum q16", sum->q16[k]);
    }
}

/* The same along a row of pixels, but rounded down: light_start_row() has made up for it. */
static inline void light_add_row(light_sum *sum, const light_product *product, const real *factor_q15, uint16_t count)
{
    const uint32_t r = product->q15[0], g = product->q15[1], b = product->q15[2];
    const real *const end = factor_q15 + count;
    for (; factor_q15 != end; factor_q15++, sum++) {
        const uint32_t factor = (uint32_t)*factor_q15;
        sum->q16[0] += r * factor >> 14;
        sum->q16[1] += g * factor >> 14;
        sum->q16[2] += b * factor >> 14;
    }
}

static inline void light_start(light_sum *sum, const light_product *ambient)
{
    for (int k = 0; k < 3; k++) {
        sum->q16[k] = ambient->q15[k] << 1;
    }
}

/* Adds what the surface itself sends out to a product of ambient light: at most 3 (98304). */
static inline void light_emit(light_product *ambient, const glint_colour *emission)
{
    ambient->q15[0] += (uint32_t)emission->r_q14 << 1;
    ambient->q15[1] += (uint32_t)emission->g_q14 << 1;
    ambient->q15[2] += (uint32_t)emission->b_q14 << 1;
}

/* (1 + cosine) / 2, Q15, for a cosine within 8 units of -1..1. */
static inline real half_more(real cosine)
{
    const real half = (32769 + cosine) >> 1;
    return half < 0 ? 0 : half > 32768 ? 32768 : half;
}

/* A share of a factor, both Q15 and at most a little above 1. */
static inline real light_part(real factor, real share)
{
    return share == 32768 ? factor : (factor * share + (1 << 14)) >> 15;
}

/* Along a row, for `terms` of light_add_row(): each loses less than a unit, half of one on average. */
static inline void light_start_row(light_sum *sum, const light_product *ambient, uint32_t terms, uint16_t count)
{
    const uint32_t more = terms >> 1;
    const uint32_t r = (ambient->q15[0] << 1) + more, g = (ambient->q15[1] << 1) + more;
    const uint32_t b = (ambient->q15[2] << 1) + more;
    const light_sum *const end = sum + count;
    for (; sum != end; sum++) {
        sum->q16[0] = r;
        sum->q16[1] = g;
        sum->q16[2] = b;
    }
}

static GLINT_SHARED uint16_t light_clamp(uint32_t q16)
{
    return (uint16_t)(q16 >= 65536 ? 32768 : (q16 + 1) >> 1);
}

static inline glint_shade light_finish(const light_sum *sum)
{
    const glint_shade shade = {light_clamp(sum->q16[0]), light_clamp(sum->q16[1]), light_clamp(sum->q16[2])};
    return shade;
}

/* A share of the ramp, and a cosine in Q15, as the backend's numbers. */
static inline real light_share(uint32_t q15)
{
    return (int32_t)q15;
}

static inline int32_t cosine_q15(real cosine)
{
    return cosine;
}

/* |a - b|^2 in Q16 of two unit vectors, rounded up, at most 4. */
static inline uint32_t chord_q16(const real a[3], const real b[3])
{
    const int32_t x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    const uint32_t beyond = (uint32_t)(x + 32768) | (uint32_t)(y + 32768) | (uint32_t)(z + 32768);
    if (beyond >> 16 == 0) {
        const uint32_t square_q30 = (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z); /* <= 3 2^30 */
        return (square_q30 + 16383) >> 14;
    }
    const uint32_t u = magnitude32(x) >> 1, v = magnitude32(y) >> 1, w = magnitude32(z) >> 1; /* Q14 */
    /* < 2^30 each: the half that was dropped of d is within d */
    return (u * u + u + v * v + v + w * w + w + 4095) >> 12;
}

static inline bool unit(const real v[3], real out[3])
{
    return glint_unit_q15(v, out);
}

static inline real cosine_of(const real a[3], const real b[3])
{
    return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + (1 << 14)) >> 15;
}

/* Q31: |a - b|^2 / 2 of two vectors in Q15; anything of 1 (2^31) or above as 2^31. */
static inline uint32_t gap_between(const real a[3], const real b[3])
{
    const uint32_t one = (uint32_t)1 << 31;
    uint32_t sum = 0;
    for (int k = 0; k < 3; k++) {
        const uint32_t d = magnitude32(a[k] - b[k]);
        if (d > 46340) { /* d^2 > 2^31 */
            return one;
        }
        sum += d * d; /* < 2^31 + 2^31 */
        if (sum >= one) {
            return one;
        }
    }
    return sum;
}

/* r = 2 (n.s) n - s */
static inline void mirrored(const real n[3], const real s[3], real cosine_ns, real r[3])
{
    for (int k = 0; k < 3; k++) {
        r[k] = ((cosine_ns * n[k] + (1 << 13)) >> 14) - s[k];
        GLINT_TRACE("unit vector q15", n[k]);
        GLINT_TRACE("unit vector q15", s[k]);
        GLINT_TRACE("mirrored direction q15", r[k]);
    }
}

/*
 * h along s + c; false where s = -c within 2^-24. Rounding of s and c turns h by as much more as they cancel: where
 * their sum is short, it is taken again in Q28 from the vectors that they were made of, `towards` and -`ray`.
 */
static inline bool half_vector(const real s[3], const real c[3], const real towards[3], const real ray[3], real h[3])
{
    real sum[3] = {s[0] + c[0], s[1] + c[1], s[2] + c[2]};
    if ((magnitude32(sum[0]) | magnitude32(sum[1]) | magnitude32(sum[2])) < (uint32_t)1 << 14) {
        real fine_s[3], fine_ray[3];
        if (!glint_unit_q28(towards, fine_s) || !glint_unit_q28(ray, fine_ray)) {
            return false;
        }
        for (int k = 0; k < 3; k++) {
            sum[k] = fine_s[k] - fine_ray[k];
        }
        if ((magnitude32(sum[0]) | magnitude32(sum[1]) | magnitude32(sum[2])) < 16) {
            return false;
        }
    }
    return unit(sum, h); /* not zero */
}

typedef uint32_t light_gap;
typedef uint16_t light_exponent;

#define WIDE_GAP_ONE ((wide_gap)1 << 28)
#define LIGHT_GAP_ONE ((light_gap)1 << 31)

/* A gap along a row of pixels: quadratic, Q28, for gaps up to 2 and the sums of them. */
typedef struct gap_row {
    int32_t value, step, bend;
} gap_row;

typedef int32_t wide_gap;

/* d^2 / 2 for a difference of unit vectors (Q15): Q28. */
static inline uint32_t wide_square(int32_t d)
{
    const uint32_t magnitude = magnitude32(d);
    return magnitude > 65535 ? (uint32_t)1 << 29 : (magnitude * magnitude) >> 3;
}

/* |a - b|^2 / 2 of two unit vectors, all of it: at most 2 and what rounding adds. */
static inline wide_gap wide_gap_between(const real a[3], const real b[3])
{
    return (wide_gap)(wide_square(a[0] - b[0]) + wide_square(a[1] - b[1]) + wide_square(a[2] - b[2]));
}

static inline uint32_t wide_gap_q31(wide_gap gap)
{
    return gap >= (int32_t)1 << 28 ? LIGHT_GAP_ONE : (uint32_t)gap << 3;
}

/* Through three gaps 2^log2 pixels apart: with a = first - 2 second + third, the value at pixel i is first + i (second
 * - first - a / 2) / 2^log2 + i^2 a / 2^(2 log2 + 1). */
static inline void gap_row_through(gap_row *row, wide_gap first, wide_gap second, wide_gap third, int log2)
{
    const int32_t a = first - 2 * second + third;
    row->value = first;
    row->bend = shift_round32(a, 2 * log2);
    row->step = shift_round32(2 * (second - first) - a, log2 + 1) + row->bend / 2;
}

static inline wide_gap gap_row_next(gap_row *row)
{
    const int32_t value = row->value;
    row->value += row->step;
    row->step += row->bend;
    return value;
}

static inline uint32_t wide_gap_q28(wide_gap gap)
{
    return gap > 0 ? (uint32_t)gap : 0;
}

static inline light_gap gap_from_q28(uint32_t gap_q28)
{
    return gap_q28 >= (uint32_t)1 << 28 ? LIGHT_GAP_ONE : gap_q28 << 3;
}

static inline uint16_t factor_q15(real factor)
{
    return (uint16_t)factor;
}

static inline light_exponent exponent_from(uint16_t exponent_q4)
{
    return exponent_q4;
}

static inline real light_power(light_gap gap, light_exponent exponent)
{
    GLINT_TRACE("specular gap q31", gap);
    return glint_power_q15(gap, exponent);
}

/* The lit point. The ray may have any length: only its direction counts, and its size against the inverse distance. */
typedef struct surface {
    real normal[3];
    real ray[3]; /* from the eye to the point, divided by its depth w (or by the near distance), ray_fraction bits */
    int32_t inverse; /* near / w (or 1) times 2^inverse_fraction, 0..2^30 */
    int16_t ray_fraction, inverse_fraction;
} surface;

/* A light's direction (Q15, and again in Q30) or position (in near distances, with `fraction` bits). */
typedef struct light_place {
    real v[3];
    real fine_q30[3]; /* a direction only */
    int16_t fraction;
} light_place;

static inline void light_place_direction(light_place *place, const glint_frame *frame, const glint_light *light)
{
    int32_t unit_q30[3];
    glint_light_direction(frame, light, unit_q30);
    for (int k = 0; k < 3; k++) {
        place->v[k] = (unit_q30[k] + (1 << 14)) >> 15;
        GLINT_TRACE("light direction q15", place->v[k]);
        place->fine_q30[k] = unit_q30[k];
    }
}

/* A direction with all the precision that there is, in any scale. */
static inline const real *light_fine(const light_place *place)
{
    return place->fine_q30;
}

static inline void light_place_position(light_place *place, const glint_frame *frame, const glint_view *view,
                                        const glint_light *light)
{
    glint_light_position(frame, view, light, place->v, &place->fraction);
    for (int k = 0; k < 3; k++) {
        /* a surface's inverse distance is in units of GLINT_DEPTH_SPAN, not 2^30: times 1 + (2^30 - SPAN) / SPAN */
        place->v[k] += multiply_high_s32(
            place->v[k], (int32_t)(((uint64_t)(((int32_t)1 << 30) - GLINT_DEPTH_SPAN) << 32) / GLINT_DEPTH_SPAN));
    }
}

/* How many bits the product of a light's position and a surface's inverse distance has, and the vector to it: the
 * coarser of the two that it is made of. */
static inline int light_product_fraction(const light_place *light, const surface *at)
{
    return light->fraction + at->inverse_fraction - 32;
}

static inline int light_vector_fraction(const light_place *light, const surface *at)
{
    const int fraction = light_product_fraction(light, at);
    return fraction < at->ray_fraction ? fraction : at->ray_fraction;
}

/*
 * Unit vector from the surface to a point light: along v = position inverse - ray. False where the difference is below
 * 2^-15 of the ray, about what rounding of the inverse distance leaves of it: light and surface are then the same
 * point.
 */
static inline bool light_towards(const light_place *light, const surface *at, real v[3], real out[3])
{
    const int finer = light_product_fraction(light, at) - at->ray_fraction;
    uint32_t whole = 0, difference = 0;
    for (int k = 0; k < 3; k++) {
        const real product = multiply_high_s32(light->v[k], at->inverse); /* < 2^28 + 2^20 */
        GLINT_TRACE("light times inverse", product);
        if (finer >= 0) {
            v[k] = (finer > 30 ? 0 : product >> finer) - at->ray[k];
        } else {
            v[k] = product - (finer < -30 ? 0 : at->ray[k] >> -finer);
        }
        GLINT_TRACE("towards a light", v[k]);
        difference |= magnitude32(v[k]);
        whole |= magnitude32(finer >= 0 ? at->ray[k] : product);
    }
    return difference > whole >> 15 && unit(v, out);
}

static inline real mean_of(real a, real b)
{
    return (a >> 1) + (b >> 1);
}

/* The longest edge of the triangle of three vectors over the least length on it, squared: Q16, rounded up; UINT32_MAX
 * above 1/2. A length falls below the corners' by at most a third of the edge, both squared. */
static inline uint32_t turn_square_q16(const real v0[3], const real v1[3], const real v2[3])
{
    const real *const v[3] = {v0, v1, v2};
    uint32_t any = 0, edge = 0, least = UINT32_MAX;
    for (int i = 0; i < 3; i++) {
        any |= magnitude32(v[i][0]) | magnitude32(v[i][1]) | magnitude32(v[i][2]);
    }
    const int down = 32 - clz32(any) - 14; /* to 14 bits */
    if (down < 0) {
        return UINT32_MAX;
    }
    for (int i = 0; i < 3; i++) {
        const real *const a = v[i], *const b = v[i == 2 ? 0 : i + 1];
        uint32_t apart = 0, length = 0;
        for (int k = 0; k < 3; k++) {
            const int32_t d = (b[k] >> down) - (a[k] >> down), c = a[k] >> down;
            apart += (uint32_t)(d * d); /* < 3 2^30 */
            length += (uint32_t)(c * c);
        }
        edge = apart > edge ? apart : edge;
        least = length < least ? length : least;
    }
    edge += (edge >> 6) + 192; /* for what the shift cuts: up to 3.46 units of an edge, of the square up to this */
    const uint32_t short_q16 = least > edge / 3 ? (least - edge / 3) >> 16 : 0;
    return short_q16 < 16 || edge >> 15 >= short_q16 ? UINT32_MAX : edge / short_q16 + 1;
}

/* Folding of lights at one corner: the light's cosine there (Q15) by its share of a ramp, to its steps in Q19 ... */
static inline void light_fold_step(real *step, real cosine, real share)
{
    *step += (cosine * share) >> 1;
    GLINT_TRACE("folded steps q29", *step);
}

/* ... or by each channel of its colour, Q26. */
static inline void light_fold_channel(real channel[3], real cosine, const light_product *product)
{
    for (int c = 0; c < 3; c++) {
        channel[c] += (cosine * (int32_t)(product->q15[c] >> 1)) >> 3; /* the product has 17 bits */
    }
}

/* Folding of lights into one vector: the sum of unit vectors by their shares of a ramp, Q15 (at most 1) ... */
static inline void light_fold(real sum[3], const real towards[3], real share)
{
    for (int k = 0; k < 3; k++) {
        sum[k] += (towards[k] * share + (1 << 14)) >> 15;
    }
}

/* ... or by each channel of their colour, Q28. Products of at most 4 in all (see lit_material.tiers) keep it within
 * 2^30.
 */
static inline void light_fold_channels(real sum[3][3], const real towards[3], const light_product *product)
{
    for (int c = 0; c < 3; c++) {
        /* the product has 17 bits: its last one apart */
        const int32_t half = (int32_t)(product->q15[c] >> 1), last = (int32_t)(product->q15[c] & 1);
        for (int k = 0; k < 3; k++) {
            sum[c][k] += ((towards[k] * half) >> 1) + ((towards[k] * last) >> 2);
        }
    }
}

#endif
