/* SPDX-License-Identifier: MIT */
/*
 * Unit vectors along a row of pixels, in fixed point: of vectors that are linear on the screen, which are the normal
 * over its depth, the ray through a pixel, and a point light's position over the depth less the ray.
 */
#ifndef GLINT_RASTER_UNITS_FIXED_H
#define GLINT_RASTER_UNITS_FIXED_H

#include "raster/field_fixed.h"

/* A vector at a pixel, and its change to the next one on the right, modulo 2^32. */
typedef struct unit_row {
    uint32_t value[3], step[3];
} unit_row;

/* By how many bits a vector is cut: at the pixels of the triangle its length is then at most 2^15 and mostly above
 * 2^14. What lies beside that takes longer. */
typedef int unit_scale;

#define UNIT_SCALE_OF_NORMALS 14 /* see normal_weigh() */

static inline unit_row unit_row_of_planes(const attribute_plane plane[3], const glint_gradients *gradients, int16_t x,
                                          int16_t y)
{
    unit_row row;
    for (int k = 0; k < 3; k++) {
        row.value[k] = (uint32_t)attribute_at(&plane[k], gradients, x, y);
        row.step[k] = plane[k].step_x;
    }
    return row;
}

static inline unit_row unit_row_of_rays(const pixel_rays *rays, int16_t x, int16_t y)
{
    unit_row row;
    for (int k = 0; k < 3; k++) {
        row.value[k] = (uint32_t)(rays->v[0][k] + x * rays->v[1][k] + y * rays->v[2][k]);
        row.step[k] = (uint32_t)rays->v[1][k];
    }
    return row;
}

static inline unit_scale unit_scale_of_rays(const pixel_rays *rays)
{
    return rays->down;
}

/* Of a vector that is linear on the triangle, by each component at its corners, below 2^29: the longest, which is one
 * of them, comes to 2^14..2^15. */
static inline unit_scale unit_scale_of_corners(real component[3][3])
{
    uint32_t any = 0, longest = 0;
    for (int i = 0; i < 3; i++) {
        any |= magnitude32(component[i][0]) | magnitude32(component[i][1]) | magnitude32(component[i][2]);
    }
    const int down = 32 - clz32(any) - 15 > 1 ? 32 - clz32(any) - 15 : 1;
    for (int i = 0; i < 3; i++) {
        uint32_t square = 0;
        for (int k = 0; k < 3; k++) {
            const int32_t c = component[k][i] >> down;
            square += (uint32_t)(c * c); /* <= 3 2^30 */
        }
        longest = square > longest ? square : longest;
    }
    return longest >= (uint32_t)1 << 30 ? down + 1 : down;
}

/* So short a vector is what rounding left: no direction. */
#define UNIT_LEAST ((uint32_t)1 << 12)

/* A vector of another length than units_along() counts on. */
static inline void unit_of_any(const unit_row *row, real out[3])
{
    const int32_t v[3] = {(int32_t)row->value[0], (int32_t)row->value[1], (int32_t)row->value[2]};
    if ((magnitude32(v[0]) | magnitude32(v[1]) | magnitude32(v[2])) < UNIT_LEAST || !glint_unit_q15(v, out)) {
        out[0] = out[1] = out[2] = 0;
    }
}

static inline void unit_row_next(unit_row *row)
{
    row->value[0] += row->step[0];
    row->value[1] += row->step[1];
    row->value[2] += row->step[2];
}

/*
 * `count` unit vectors, Q15. Those of rays are shorter than 1 by 2^-11, see mirrored_gap_q28().
 *
 * The vector from the true one is at most 8.5e-5 long, 2.8 units: sqrt(3) / 2 for what the components are cut by, over
 * a length of at least 1/2; sqrt(3) / 2 for rounding; and one for the root, which changes the length only. All of the
 * length's part along the vector, the parts across it are at most 7.9e-5. The worst found is 7.85e-5.
 */
static GLINT_SPECIALISED void units_along(unit_row row, unit_scale down, bool shortened, uint16_t count, real (*out)[3])
{
    const int32_t half = ((int32_t)1 << down) >> 1;
    const real *const end = out[count];
    for (real *unit = out[0]; unit != end; unit += 3) {
        const int32_t x = ((int32_t)row.value[0] + half) >> down, y = ((int32_t)row.value[1] + half) >> down,
                      z = ((int32_t)row.value[2] + half) >> down;
        /* within a sixteenth of the triangle no component is above 2^15.1 */
        const uint32_t square = (uint32_t)x * (uint32_t)x + (uint32_t)y * (uint32_t)y + (uint32_t)z * (uint32_t)z;
        if (square - ((uint32_t)1 << 28) < ((uint32_t)1 << 30) - ((uint32_t)1 << 28)) {
            int32_t inverse = (int32_t)glint_inverse_root_q16(square << 2); /* 2^30 / length */
            const int32_t round = 1 << 14;
            if (shortened) {
                inverse -= inverse >> 11;
            }
            unit[0] = (x * inverse + round) >> 15;
            unit[1] = (y * inverse + round) >> 15;
            unit[2] = (z * inverse + round) >> 15;
        } else {
            unit_of_any(&row, unit);
            for (int k = 0; shortened && k < 3; k++) {
                unit[k] -= unit[k] >> 11;
            }
        }
        unit_row_next(&row);
    }
}

/*
 * |r - c|^2 / 2 in Q28, r = 2 (n.s) n - s and c = -ray: as field_gap(), where the ray is shorter than 1 by e = 2^-11.
 * That makes the gap (1 - e) gap + e^2 / 2, which is undone but for 2^-22 of it and the 2^-23 that e^2 / 2 is, and
 * keeps |r - c|^2 below 4 in spite of the 10 units of rounding in r and c: its sum of squares needs no check.
 */
static inline uint32_t mirrored_gap_q28(const real n[3], const real s[3], real cosine, const real ray[3])
{
    const int32_t round = 1 << 13;
    const uint32_t x = (uint32_t)(((cosine * n[0] + round) >> 14) - s[0] + ray[0]);
    const uint32_t y = (uint32_t)(((cosine * n[1] + round) >> 14) - s[1] + ray[1]);
    const uint32_t z = (uint32_t)(((cosine * n[2] + round) >> 14) - s[2] + ray[2]);
    const uint32_t gap_q28 = (x * x + y * y + z * z) >> 3;
    return gap_q28 + (gap_q28 >> 11);
}

/* A directional light's direction in Q28. */
static inline void direction_fine(const light_place *place, real out_q28[3])
{
    for (int k = 0; k < 3; k++) {
        out_q28[k] = (place->fine_q30[k] + 2) >> 2;
    }
}

/* The unit vector at the row's first pixel in Q28, see glint_unit_q28(); zero where there is no direction. */
static inline void unit_fine_at(const unit_row *row, real out_q28[3])
{
    const int32_t v[3] = {(int32_t)row->value[0], (int32_t)row->value[1], (int32_t)row->value[2]};
    if ((magnitude32(v[0]) | magnitude32(v[1]) | magnitude32(v[2])) < UNIT_LEAST || !glint_unit_q28(v, out_q28)) {
        out_q28[0] = out_q28[1] = out_q28[2] = 0;
    }
}

/* a . b of unit vectors in Q28, to 3 units below. */
static inline int32_t fine_dot_q28(const real a[3], const real b[3])
{
    int32_t dot = 0;
    for (int k = 0; k < 3; k++) {
        dot += multiply_high_s32(a[k] * 4, b[k] * 4); /* < 2^28 + 2^4 */
    }
    return dot;
}

/* Their cosine as cosine_of() gives it. */
static inline real fine_cosine(const real n[3], const real s[3])
{
    return (fine_dot_q28(n, s) + (1 << 12)) >> 13;
}

/* 1 - r.c with c = -ray, at least 0, from vectors in Q28: to 2^-23 with their errors. */
static inline uint32_t fine_gap_q28(const real n[3], const real s[3], const real ray[3])
{
    const int32_t facing = fine_dot_q28(n, ray), towards = fine_dot_q28(s, ray), cosine = fine_dot_q28(n, s);
    const int32_t product = multiply_high_s32(cosine * 4, facing * 4); /* (n.s) (n.ray) */
    return (uint32_t)positive_part(((int32_t)1 << 28) + 2 * product - towards);
}

/* The corner's weight by a component of its normal with all the bits that there are, Q28: as normal_weigh(). */
static inline real normal_weigh_fine(real component_q28, int32_t depth_q30, inverse_scale shift)
{
    const int32_t weight_q30 = inverse_of(depth_q30, shift);
    return multiply_high_s32(weight_q30 > 0 ? weight_q30 : 1, component_q28) * 8;
}

/* The unit vector in that format. */
static inline bool unit_fine(const real v[3], real out_q28[3])
{
    return glint_unit_q28(v, out_q28);
}

#endif
