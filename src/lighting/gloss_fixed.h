/* SPDX-License-Identifier: MIT */
/*
 * The gap of a highlight, 1 - its cosine, at points of a triangle: in fixed point.
 *
 * Where the gap is small, it is the small difference of large numbers, and its interpolation between points of the
 * triangle needs it to 2^-24. So it is made of exact products of what has been rounded before, of which rounding merely
 * moves the highlight: corner normals n_i (Q15), the light's direction s (Q15), and the rays R_i through the corners
 * (Q14). With M = sum b_i u_i n_i and R = sum b_i R_i, P = M.s and R.s are linear, |M|^2, M.R and |R|^2 quadratic in
 * barycentric coordinates b, of coefficients that are dot products of these; c = -R / |R|:
 *
 *     |M|^2 (1 - r.c) = |M|^2 ((|s|^2 + 1) / 2 + s.c) - 2 (M.s) (M.c),   r = 2 (n.s) n - s
 *
 * This is a polynomial of degree 2 but for |R|, so a cubic hardly errs. |s| is not quite 1; with (|s|^2 + 1) / 2 for 1
 * it is |M|^2 |r - c|^2 / 2, in which rounding is of second order.
 */
#ifndef GLINT_LIGHTING_GLOSS_FIXED_H
#define GLINT_LIGHTING_GLOSS_FIXED_H

#include "raster/lattice_fixed.h"

typedef int32_t gap_value;

/* What is common to a triangle's highlights: products with the corners' weights, of corners 00, 11, 22, 01, 12, 20;
 * those of different corners twice. */
typedef struct gloss_corners {
    real normal[3][3], ray[3][3]; /* Q15; Q14 */
    uint16_t weight_q15[3];
    int32_t square[6], facing[6]; /* |M|^2: Q27; M.R: Q26 */
    int32_t distance[6];          /* |R|^2: Q26, modulo 2^32 */
} gloss_corners;

/* Of the three corners, thrice the barycentric coordinates of the points of a cubic. */
static const uint8_t gloss_point[LATTICE_POINTS][3] = {{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {2, 1, 0}, {1, 2, 0},
                                                       {0, 2, 1}, {0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {1, 1, 1}};

/* A quadratic's value at a point, times 9, from its coefficients; and a linear one's, times 3. */
static inline uint32_t gloss_quadratic(const int32_t of[6], int point)
{
    const uint32_t a = gloss_point[point][0], b = gloss_point[point][1], c = gloss_point[point][2];
    return a * (a * (uint32_t)of[0] + b * (uint32_t)of[3]) + b * (b * (uint32_t)of[1] + c * (uint32_t)of[4]) +
           c * (c * (uint32_t)of[2] + a * (uint32_t)of[5]);
}

static inline int32_t gloss_linear(const int32_t of[3], int point)
{
    return gloss_point[point][0] * of[0] + gloss_point[point][1] * of[1] + gloss_point[point][2] * of[2];
}

static inline int32_t gloss_dot(const real a[3], const real b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The ray through a corner; false where rays are too long (a field of view above 120 degrees) or short for Q14. */
static inline bool gloss_ray(const pixel_rays *rays, const glint_screen_vertex *corner, real ray[3])
{
    const int down = rays->fraction - 26;
    const int32_t x = (corner->x - GLINT_FINE / 2) * 256,
                  y = (corner->y - GLINT_FINE / 2) * 256; /* < 2^31: guard band */
    if (down < 2 || down > 8) {
        return false;
    }
    for (int k = 0; k < 3; k++) {
        const int32_t fine =
            (rays->v[0][k] >> 12) + multiply_high_s32(rays->v[1][k], x) + multiply_high_s32(rays->v[2][k], y);
        ray[k] = shift_round32(fine, down);
        if (magnitude32(ray[k]) > 32767) {
            return false;
        }
    }
    const uint32_t square = (uint32_t)(ray[0] * ray[0]) + (uint32_t)(ray[1] * ray[1]) + (uint32_t)(ray[2] * ray[2]);
    return square > ((uint32_t)1 << 28) - ((uint32_t)1 << 20) && square < (uint32_t)1 << 30;
}

static inline bool gloss_corners_set_up(gloss_corners *corners, const pixel_rays *rays,
                                        const glint_screen_vertex *const screen[3], const real *const normal[3],
                                        const uint8_t order[3], const uint16_t weight_q15[3])
{
    for (int i = 0; i < 3; i++) {
        const int from = order[i];
        /* cppcheck-suppress uninitvar ; set here */
        if (!gloss_ray(rays, screen[from], corners->ray[i])) {
            return false;
        }
        for (int k = 0; k < 3; k++) {
            corners->normal[i][k] = normal[from][k];
        }
        corners->weight_q15[i] = weight_q15[from];
    }
    for (int i = 0; i < 3; i++) {
        const int j = i == 2 ? 0 : i + 1;
        const real *const n = corners->normal[i], *const r = corners->ray[i];
        const real *const n_next = corners->normal[j], *const r_next = corners->ray[j];
        const uint16_t weight = corners->weight_q15[i], next = corners->weight_q15[j];
        corners->square[i] = lattice_weigh(lattice_weigh(gloss_dot(n, n), weight), weight) >> 3;
        corners->square[3 + i] = lattice_weigh(lattice_weigh(gloss_dot(n, n_next), weight), next) >> 2;
        corners->facing[i] = lattice_weigh(gloss_dot(n, r), weight) >> 3;
        corners->facing[3 + i] =
            (lattice_weigh(gloss_dot(n, r_next), weight) >> 3) + (lattice_weigh(gloss_dot(n_next, r), next) >> 3);
        corners->distance[i] = gloss_dot(r, r) >> 2;
        corners->distance[3 + i] = gloss_dot(r, r_next) >> 1;
    }
    return true;
}

/* The longest edge of the triangle of rays, over the least |R| on it: |R|^2 falls below the corners' by at most a third
 * of the edge's square, which is below 1/4 here (else UINT16_MAX). */
static inline uint32_t gloss_view_q16(const gloss_corners *corners)
{
    const int32_t *const distance = corners->distance;
    int32_t edge = 0, least = distance[0];
    for (int i = 0; i < 3; i++) {
        const int32_t square = distance[i] + distance[i == 2 ? 0 : i + 1] - distance[3 + i];
        edge = square > edge ? square : edge;
        least = distance[i] < least ? distance[i] : least;
    }
    if (edge >= (int32_t)1 << 24) {
        return UINT16_MAX;
    }
    const int32_t bottom_q26 = least - edge / 3; /* at least 0.9 */
    const int twice = bottom_q26 < (int32_t)1 << 26;
    const uint32_t root_q16 = glint_inverse_root_q16((uint32_t)bottom_q26 << (4 + 2 * twice));
    return (glint_square_root_u32((uint32_t)edge << 6) * root_q16 >> (16 - twice)) + 4;
}

/* 8/9 of 1/|M|^2 at the points of a cubic, Q25: below 2^26, |M|^2 being above 1/2. */
static inline void gloss_inverse_squares(const gloss_corners *corners, gap_value value[LATTICE_POINTS])
{
    for (int i = 0; i < LATTICE_POINTS; i++) {
        const uint32_t square = gloss_quadratic(corners->square, i); /* 9 |M|^2, Q27: 4.5 to 9 and what rounding adds */
        const int twice = square < (uint32_t)1 << 30 ? 2 : 0;
        const uint32_t y = glint_inverse_root_q16(square << twice); /* 2^15 / |M| 2^(5/2) / 3 */
        value[i] = (int32_t)((y * y >> 7) << twice);
        GLINT_TRACE("inverse square at a lattice point", value[i]);
    }
}

/* 9 |M|^2 times the gap of one light at the points: Q25 less the `down` bits that it returns, all below 2^26. An error
 * of at most 2^-23. */
static inline int gloss_values(const gloss_corners *corners, const real towards[3], gap_value value[LATTICE_POINTS])
{
    int32_t light[3], towards_ray[3];
    uint32_t greatest = 0;
    for (int i = 0; i < 3; i++) {
        light[i] = lattice_weigh(gloss_dot(corners->normal[i], towards), corners->weight_q15[i]) >> 3; /* Q27 */
        towards_ray[i] = gloss_dot(towards, corners->ray[i]) >> 2;                                     /* Q27 */
    }
    const int32_t mean_q28 = (gloss_dot(towards, towards) >> 3) + ((int32_t)1 << 27); /* (|s|^2 + 1) / 2 */
    for (int i = 0; i < LATTICE_POINTS; i++) {
        const uint32_t square = gloss_quadratic(corners->square, i);
        const int32_t facing = (int32_t)gloss_quadratic(corners->facing, i);
        const uint32_t distance = gloss_quadratic(corners->distance, i);                      /* 9 |R|^2 < 2^31.2 */
        const int32_t along = gloss_linear(light, i), against = gloss_linear(towards_ray, i); /* 3 M.s, 3 s.R */
        /* 1 / (3 |R|) = root 2^(half - 2), refined to 30 bits */
        const int half = distance < (uint32_t)1 << 30;
        const uint32_t x = distance << (2 * half), y = glint_inverse_root_q16(x);
        const int32_t residual_q30 = ((int32_t)1 << 30) - (int32_t)multiply_high_u32(y * y, x); /* < 2^16 */
        const int32_t root_q30 = (int32_t)(y << 14) + (((residual_q30 >> 2) * (int32_t)(y >> 1)) >> 14);
        const int32_t away_q28 = multiply_high_s32(against, root_q30) * (2 << half); /* -s.c */
        const int32_t back_q27 = multiply_high_s32(facing, root_q30) * (2 << half);  /* -3 M.c */
        const uint32_t sum_q30 = (uint32_t)positive_part(mean_q28 - away_q28) << 2;
        value[i] = (int32_t)multiply_high_u32(square, sum_q30) + multiply_high_s32(along * 4, back_q27 * 4);
        greatest |= magnitude32(value[i]);
    }
    int down = 0;
    while (greatest >> down >= (uint32_t)1 << 26) {
        down++;
    }
    for (int i = 0; i < LATTICE_POINTS; i++) {
        value[i] = shift_round32(value[i], down);
        GLINT_TRACE("gap at a lattice point", value[i]);
    }
    return down;
}

/* How the values of a cubic, Q(29 - down), become gaps: those at or above `limit` are beyond the table, |M| being at
 * most 1; a 32nd more is for rounding. */
typedef struct gap_scale {
    int32_t limit, half;
    uint8_t cut, down;
} gap_scale;

static inline gap_scale gap_scale_of(uint32_t end_q28, int down)
{
    /* 9 times the end, with 4 bits in front */
    const uint32_t nine_q24 = (end_q28 + (end_q28 >> 5) + 16) / 16 * 9; /* < 2^28 */
    gap_scale scale;
    const int up = 5 - down; /* to Q(29 - down): at least 1 */
    const uint32_t limit = nine_q24 >> (31 - up) != 0 ? INT32_MAX : nine_q24 << up;
    int cut = 0;
    while (limit >> cut >= 65536) {
        cut++;
    }
    scale.limit = (int32_t)limit;
    scale.half = ((int32_t)1 << cut) >> 1;
    scale.cut = (uint8_t)cut;
    scale.down = (uint8_t)(19 - down - cut);
    return scale;
}

/* A cubic's value below the limit, rounded to 15 bits of that and more, which costs up to 2^-16 of it; GAP_BEYOND
 * above. */
typedef uint32_t gap_part;

#define GAP_BEYOND UINT32_MAX

static inline gap_part gap_part_of(uint32_t value, const gap_scale *scale)
{
    return (int32_t)value >= scale->limit ? GAP_BEYOND
                                          : (uint32_t)positive_part((int32_t)value + scale->half) >> scale->cut;
}

/* The gap, Q28, from that and the inverse of |M|^2 (Q29). */
static inline uint32_t gap_q28_of(gap_part part, uint32_t inverse_square, const gap_scale *scale)
{
    return part == GAP_BEYOND ? UINT32_MAX : (part * (inverse_square >> 14)) >> scale->down; /* 8 gap < 2^16 2^15.84 */
}

#endif
