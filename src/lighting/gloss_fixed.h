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

/* A quadratic's values at the points, times 9, from its coefficients, modulo 2^32; and a linear one's, times 3. */
static inline void gloss_quadratic(const int32_t of[6], int32_t at[LATTICE_POINTS])
{
    uint32_t sum = 0;
    for (int i = 0; i < 3; i++) {
        const uint32_t a = (uint32_t)of[i], b = (uint32_t)of[i == 2 ? 0 : i + 1], ab = (uint32_t)of[3 + i];
        const uint32_t both = a + b + 2 * ab;
        at[i] = (int32_t)(9 * a);
        at[3 + 2 * i] = (int32_t)(both + 3 * a);
        at[4 + 2 * i] = (int32_t)(both + 3 * b);
        sum += a + ab;
    }
    at[9] = (int32_t)sum;
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

typedef uint32_t gloss_inverse_rest;

/* 1/|M|^2 on a triangle: |M|^2 = x is a polynomial of degree 2 there, of which another makes the inverse. */
typedef struct gloss_inverse {
    real corner[3], middle[3]; /* g at the corners and in the middles of the edges, Q30 */
    gloss_inverse_rest rest;   /* m/x is g^2 and this, 3/4 to 3/2: Q30 */
    int32_t over_m_q14;
    uint32_t part_q15;  /* x lies within 1 - part..1 + part times m; at most 1/3 */
    uint32_t error_q22; /* of 1/x, relative, at most; rounding adds 1e-4 */
} gloss_inverse;

static inline uint32_t gloss_part_q15(const gloss_inverse *inverse)
{
    return inverse->part_q15;
}

/*
 * With h = 1 - x/m, m/x is 1 + h + h^2 + h^3 / (1 - h), and where |h| <= p a third power is best stood for by 3/4 p^2
 * h: 1 + c h + h^2, c = 1 + 3/4 p^2, is off by a relative p^3 / 4 + 3/4 p^4. That is g^2 + 1 - c^2 / 4, g = h + c/2.
 * False where x may be below 1/2.
 */
static inline bool gloss_inverse_square(gloss_inverse *inverse, const gloss_corners *corners)
{
    const int32_t *const square = corners->square;
    int32_t least = square[0], most = square[0], edge = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t chord = square[i] + square[i == 2 ? 0 : i + 1] - square[3 + i];
        edge = chord > edge ? chord : edge;
        least = square[i] < least ? square[i] : least;
        most = square[i] > most ? square[i] : most;
    }
    least -= edge / 3 + 8; /* x is at least that, see bound.h, and at most what it is at a corner */
    if (least < (int32_t)1 << 26) {
        return false;
    }
    const uint32_t twice_m = (uint32_t)(least + most); /* Q27: 1 to 2 and what normals are too long by */
    const int up = clz32(twice_m) & 31;                /* 3 or 4 */
    /* 2^62 / (2 m 2^(27 + up)) */
    inverse->over_m_q14 = (int32_t)((glint_reciprocal_q31(twice_m << up) - 1) >> (20 - up)); /* < 2^15 */
    const uint32_t d_q15 = (uint32_t)(most - least) >> 13;
    const uint32_t part_q15 = ((d_q15 * (uint32_t)inverse->over_m_q14) >> 14) + 5; /* 4 for that of 1/m */
    const uint32_t second_q15 = (part_q15 * part_q15 >> 15) + 1, third_q15 = (second_q15 * part_q15 >> 15) + 1;
    const uint32_t c_q15 = 32768 + second_q15 * 3 / 4; /* < 1.1 */
    /* 1 + c/2, and half of what gap_inverse() drops */
    const int32_t one_q30 = (int32_t)(((uint32_t)1 << 30) + (c_q15 << 14) + (1 << 14));
    for (int i = 0; i < 3; i++) {
        const int32_t halfway = (square[i] + square[i == 2 ? 0 : i + 1] + square[3 + i]) >> 2;
        inverse->corner[i] = one_q30 - multiply_q16(square[i] * 8, inverse->over_m_q14) * 4;
        inverse->middle[i] = one_q30 - multiply_q16(halfway * 8, inverse->over_m_q14) * 4;
        GLINT_TRACE("part of a square at a lattice point", inverse->corner[i]);
        GLINT_TRACE("part of a square at a lattice point", inverse->middle[i]);
    }
    inverse->rest = ((uint32_t)1 << 30) - c_q15 * c_q15 / 4;
    inverse->part_q15 = part_q15;
    inverse->error_q22 = ((third_q15 * (32768 + 3 * part_q15)) >> 10) + 1;
    return true;
}

/* What all lights have in common at the points of a cubic: 9 |M|^2 (Q27), 9 M.R (Q26) and 1 / (3 |R|), which is root
 * 2^(half - 2) with root in Q31. */
typedef struct gloss_points {
    int32_t square[LATTICE_POINTS], facing[LATTICE_POINTS], root_q31[LATTICE_POINTS];
    uint8_t half[LATTICE_POINTS];
} gloss_points;

static inline void gloss_points_of(gloss_points *points, const gloss_corners *corners)
{
    int32_t distance[LATTICE_POINTS];
    gloss_quadratic(corners->square, points->square);
    gloss_quadratic(corners->facing, points->facing);
    gloss_quadratic(corners->distance, distance); /* 9 |R|^2 < 2^31.2 */
    for (int i = 0; i < LATTICE_POINTS; i++) {
        const int half = (uint32_t)distance[i] < (uint32_t)1 << 30;
        const uint32_t x = (uint32_t)distance[i] << (2 * half), y = glint_inverse_root_q16(x);
        /* refined to 30 bits: at most 2^30 */
        const int32_t residual_q30 = ((int32_t)1 << 30) - (int32_t)multiply_high_u32(y * y, x); /* < 2^16 */
        const int32_t root_q30 = (int32_t)(y << 14) + (((residual_q30 >> 2) * (int32_t)(y >> 1)) >> 14);
        points->root_q31[i] = (int32_t)((uint32_t)root_q30 * 2 - 2);
        points->half[i] = (uint8_t)half;
    }
}

/* |M|^2 / m times the gap of one light at the points: Q28 less the `down` bits that it returns, all below 2^26. An
 * error of at most 2^-23, and of a relative 4e-5 that is one for all of them. */
static inline int gloss_values(const gloss_corners *corners, const gloss_points *points, const gloss_inverse *inverse,
                               const real towards[3], gap_value value[LATTICE_POINTS])
{
    int32_t light[3], towards_ray[3];
    uint32_t greatest = 0;
    for (int i = 0; i < 3; i++) {
        light[i] = lattice_weigh(gloss_dot(corners->normal[i], towards), corners->weight_q15[i]) >> 3; /* Q27 */
        towards_ray[i] = gloss_dot(towards, corners->ray[i]) >> 2;                                     /* Q27 */
    }
    const int32_t scale_q14 = (int32_t)(((uint32_t)inverse->over_m_q14 * 58254 + 32768u) >> 16); /* 8/9 of 1/m */
    /* (|s|^2 + 1) / 2 is 1 and this: < 2^14, by the rounding of s */
    const int32_t more_q28 = (gloss_dot(towards, towards) >> 3) - ((int32_t)1 << 27);
    for (int i = 0; i < LATTICE_POINTS; i++) {
        const int32_t square = points->square[i];
        const int32_t along = gloss_linear(light, i), against = gloss_linear(towards_ray, i); /* 3 M.s, 3 s.R */
        /* 27 (2 (M.s) (M.R) - |M|^2 (s.R)): 27 6 2^23 */
        const int32_t both_q23 =
            multiply_high_s32(along * 4, points->facing[i]) * 2 - multiply_high_s32(square, against * 2);
        const int32_t nine_q25 = (square >> 2) + (((square >> 16) * more_q28) >> 14) +
                                 multiply_high_s32(both_q23, points->root_q31[i]) * (2 << points->half[i]);
        value[i] = multiply_q16(nine_q25, scale_q14) * 4; /* |9 gap| <= 18, and 1.78 of it */
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

/* How the values of a cubic, Q(32 - down), become places in the table of the specular term, in 2^-GAP_BITS of a cell.
 * To them `half` is added, for rounding; those from `limit` on are beyond the table then, all over the triangle. */
typedef struct gap_scale {
    uint32_t half, end;
    int32_t limit;
    uint8_t cut, down;
} gap_scale;

#define GAP_BITS 8

/* For a table of `cells` times 2^bits in Q28. */
static inline gap_scale gap_scale_of(uint16_t cells, uint8_t bits, int down, const gloss_inverse *inverse)
{
    /* x/m is at most 1 + part; a 32nd more is for rounding */
    const uint32_t end_q28 = (uint32_t)cells << bits; /* <= 1 and a cell */
    const uint32_t most_q28 = end_q28 + multiply_high_u32(end_q28 << 3, inverse->part_q15 << 14) + (end_q28 >> 5) + 2;
    const uint32_t farthest = (uint32_t)1 << 30; /* no value is beyond that */
    const int up = 4 - down;
    const uint32_t limit = up <= 0 ? most_q28 >> -up : most_q28 >> (30 - up) != 0 ? farthest : most_q28 << up;
    gap_scale scale;
    int cut = 0;
    while (limit >> cut >= 65535) {
        cut++;
    }
    /* of what is cut, and of a place */
    scale.half = (((uint32_t)1 << cut) >> 1) + (limit >> 18);
    scale.limit = (int32_t)(limit + scale.half);
    scale.end = (uint32_t)cells << GAP_BITS;
    scale.cut = (uint8_t)cut;
    scale.down = (uint8_t)(19 - GAP_BITS - down + bits - cut); /* 14 or so: cut is bits - down - 3; at least 6 */
    return scale;
}

/* m/x, Q15, where the row has come to g: at most 3/2. */
typedef uint16_t gap_factor;

static inline gap_factor gap_inverse(uint32_t g_q30, const gloss_inverse_rest *rest)
{
    const uint32_t g_q15 = g_q30 >> 15;
    return (gap_factor)((g_q15 * g_q15 + *rest) >> 15);
}

static inline bool gap_beyond(uint32_t value, const gap_scale *scale)
{
    return (int32_t)value >= scale->limit;
}

/* Is it from 0 to the limit? */
static inline bool gap_within(uint32_t value, const gap_scale *scale)
{
    return value < (uint32_t)scale->limit;
}

/* A cubic's value within these, rounded to 15 bits of the limit and more, which costs up to 2^-16 of it. */
typedef uint16_t gap_part;

static inline gap_part gap_part_of(uint32_t value, const gap_scale *scale)
{
    return (gap_part)(value >> scale->cut);
}

/* The place in the table, from that and m/x: at or after scale->end beyond it. */
static inline uint32_t gap_place_of(gap_part part, gap_factor inverse_q15, const gap_scale *scale)
{
    return ((uint32_t)part * inverse_q15) >> scale->down; /* < 2^16 2^15.6 */
}

#endif
