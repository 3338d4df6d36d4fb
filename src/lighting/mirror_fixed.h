/* SPDX-License-Identifier: MIT */
/*
 * A mirror in fixed point: the environment's colour in the direction in which the eye's ray leaves the surface.
 *
 * The direction needs no unit vector: with N along the normal and v along the ray from the eye, both of any length,
 * d = (N.N) v - 2 (N.v) N is along r, and the octahedral map divides by |x| + |y| + |z| itself: one reciprocal a pixel.
 *
 * Error of the direction from given N and v: at most 1.1e-7 radians (found by tests/unit/test_mirror.h); of the place
 * in the map, half of 2^-12 texel more in each coordinate; of a channel for that place 2^-16.
 */
#ifndef GLINT_LIGHTING_MIRROR_FIXED_H
#define GLINT_LIGHTING_MIRROR_FIXED_H

#include "lighting/light_fixed.h"
#include "lighting/mirror.h"

typedef struct light_mirror {
    const glint_environment *map;
    real to_world_q30[3][3]; /* rows: world components of a vector of the lighting frame */
    light_product reflectance;
    uint8_t down; /* from Q30 of the square's width to Q12 of a texel */
} light_mirror;

static inline void light_mirror_set_up(light_mirror *mirror, const glint_environment *map,
                                       const glint_colour *reflectance, const glint_frame *frame)
{
    static const glint_colour white = {16384, 16384, 16384};
    mirror->map = map;
    mirror->reflectance = light_multiply(reflectance, &white);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            mirror->to_world_q30[i][k] = frame->from_world_q30[k][i];
        }
    }
    mirror->down = 19;
    for (uint8_t side = map->side; side > 1; side >>= 1) {
        mirror->down--;
    }
}

/* Any vector with its greatest component brought to 2^29..2^30; the zero vector stays. */
static inline void mirror_scale(const real v[3], real out[3])
{
    const int up = clz32(magnitude32(v[0]) | magnitude32(v[1]) | magnitude32(v[2])) - 2;
    for (int k = 0; k < 3; k++) {
        out[k] = up >= 0 ? (real)((uint32_t)v[k] << (up & 31)) : v[k] >> -up;
    }
}

static inline int32_t mirror_dot(const real a[3], const real b[3])
{
    return multiply_high_s32(a[0], b[0]) + multiply_high_s32(a[1], b[1]) + multiply_high_s32(a[2], b[2]);
}

/* r in the world's axes, of any length; back along the ray where the normal is zero. */
static inline void mirror_direction(const light_mirror *mirror, const real normal[3], const real ray[3], real out[3])
{
    real n[3], v[3], d[3];
    mirror_scale(normal, n);
    mirror_scale(ray, v);
    const int32_t square = mirror_dot(n, n);    /* 2^26..3 2^28; 0 for no normal */
    const int32_t twice = 2 * mirror_dot(n, v); /* within 6 2^28 */
    const int up = clz32((uint32_t)square | magnitude32(twice) | 1) - 1;
    GLINT_TRACE("mirror's square", square);
    GLINT_TRACE("mirror's product", twice);
    for (int k = 0; k < 3; k++) {
        /* both within 2^29 */
        d[k] = square == 0 ? -v[k]
                           : multiply_high_s32(square * ((int32_t)1 << up), v[k]) -
                                 multiply_high_s32(twice * ((int32_t)1 << up), n[k]);
    }
    mirror_scale(d, d);
    for (int i = 0; i < 3; i++) {
        out[i] = mirror_dot(mirror->to_world_q30[i], d); /* within 2^29 */
        GLINT_TRACE("mirrored ray", out[i]);
    }
}

/* A coordinate of the square, Q30, to texels from the first centre, Q12. */
static inline int32_t mirror_place(const light_mirror *mirror, int32_t u_q30)
{
    /* 0..2^31, and half a step */
    const uint32_t from_edge = (uint32_t)u_q30 + ((uint32_t)1 << 30) + ((uint32_t)1 << (mirror->down - 1));
    return (int32_t)(from_edge >> mirror->down) - (1 << 11);
}

/* Bilinear in texels of 5 or 6 bits, Q24. */
static inline uint32_t mirror_mix(const uint16_t at[4], uint32_t x_q12, uint32_t y_q12)
{
    const uint32_t upper = at[0] * (4096 - x_q12) + at[1] * x_q12, lower = at[2] * (4096 - x_q12) + at[3] * x_q12;
    return upper * (4096 - y_q12) + lower * y_q12; /* at most 63 2^24 */
}

/* E in the direction d, Q15 a channel. */
static inline void mirror_colour(const light_mirror *mirror, const real d[3], uint32_t colour_q15[3])
{
    uint32_t size[3], sum = 0;
    for (int k = 0; k < 3; k++) {
        size[k] = magnitude32(d[k]);
        sum += size[k]; /* < 3 2^29 */
    }
    if (sum == 0) {
        colour_q15[0] = colour_q15[1] = colour_q15[2] = 0;
        return; /* a point in the eye itself */
    }
    const int up = clz32(sum);
    const uint32_t inverse = glint_reciprocal_q31(sum << up); /* 2^62 / (sum 2^up) */
    int32_t u = (int32_t)multiply_high_u32(size[0] << up, inverse);
    int32_t v = (int32_t)multiply_high_u32(size[2] << up, inverse);
    if (d[1] < 0) {
        const int32_t one = (int32_t)1 << 30, folded = one - v;
        v = one - u;
        u = folded;
    }
    const int32_t x = mirror_place(mirror, d[0] < 0 ? -u : u), y = mirror_place(mirror, d[2] < 0 ? -v : v);
    const int16_t i = (int16_t)(x >> 12), j = (int16_t)(y >> 12);
    uint16_t channel[3][4];
    for (int corner = 0; corner < 4; corner++) {
        uint16_t one[3];
        glint_environment_channels(
            glint_environment_texel(mirror->map, (int16_t)(i + (corner & 1)), (int16_t)(j + (corner >> 1))), one);
        for (int k = 0; k < 3; k++) {
            channel[k][corner] = one[k];
        }
    }
    for (int k = 0; k < 3; k++) {
        /* Q24 of 31 or 63, to Q18 of 1: 2^26 / 31 and 2^26 / 63 */
        const uint32_t part = multiply_high_u32(mirror_mix(channel[k], (uint32_t)x & 4095, (uint32_t)y & 4095),
                                                k == 1 ? 1065221u : 2164802u);
        colour_q15[k] = (part + 4) >> 3;
    }
}

static inline void light_mirror_add(light_sum *sum, const light_mirror *mirror, const real normal[3], const real ray[3])
{
    real d[3];
    uint32_t colour_q15[3];
    mirror_direction(mirror, normal, ray, d);
    mirror_colour(mirror, d, colour_q15);
    for (int k = 0; k < 3; k++) {
        GLINT_TRACE("environment q15", colour_q15[k]);
        sum->q16[k] += (mirror->reflectance.q15[k] * colour_q15[k] + (1 << 13)) >> 14; /* 2^30 at most */
    }
}

#endif
