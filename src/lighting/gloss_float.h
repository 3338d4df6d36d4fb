/* SPDX-License-Identifier: MIT */
/*
 * The gap of a highlight, 1 - its cosine, at points of a triangle: in float. See gloss_fixed.h for what each is.
 */
#ifndef GLINT_LIGHTING_GLOSS_FLOAT_H
#define GLINT_LIGHTING_GLOSS_FLOAT_H

#include "raster/lattice_float.h"

typedef float gap_value;

typedef struct gloss_corners {
    real normal[3][3], ray[3][3];
} gloss_corners;

static const uint8_t gloss_point[LATTICE_POINTS][3] = {{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {2, 1, 0}, {1, 2, 0},
                                                       {0, 2, 1}, {0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {1, 1, 1}};

static inline bool gloss_corners_set_up(gloss_corners *corners, const pixel_rays *rays,
                                        const glint_screen_vertex *const screen[3], const real *const normal[3],
                                        const uint8_t order[3], const uint16_t weight_q15[3])
{
    for (int i = 0; i < 3; i++) {
        const int from = order[i];
        const float x = (float)(screen[from]->x - (GLINT_FINE >> 1)) * (1.0f / GLINT_FINE);
        const float y = (float)(screen[from]->y - (GLINT_FINE >> 1)) * (1.0f / GLINT_FINE);
        for (int k = 0; k < 3; k++) {
            corners->ray[i][k] = rays->v[0][k] + x * rays->v[1][k] + y * rays->v[2][k];
            corners->normal[i][k] = lattice_weigh(normal[from][k], weight_q15[from]);
        }
    }
    return true;
}

static inline uint32_t gloss_view_q16(const gloss_corners *corners)
{
    float edge = 0.0f, least = cosine_of(corners->ray[0], corners->ray[0]);
    for (int i = 0; i < 3; i++) {
        const real *const a = corners->ray[i], *const b = corners->ray[i == 2 ? 0 : i + 1];
        const real d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
        const float square = cosine_of(d, d), distance = cosine_of(a, a);
        edge = square > edge ? square : edge;
        least = distance < least ? distance : least;
    }
    const float view = glint_square_root(edge) * glint_inverse_root(least - edge * (1.0f / 3));
    return edge < 0.25f ? (uint32_t)(view * 65536.0f) + 2 : UINT16_MAX;
}

typedef float gloss_inverse_rest;

typedef struct gloss_inverse {
    float corner[3], middle[3];
    gloss_inverse_rest rest;
    float over_m, part;
    uint32_t error_q22;
} gloss_inverse;

static inline uint32_t gloss_part_q15(const gloss_inverse *inverse)
{
    return (uint32_t)(inverse->part * 32768.0f) + 1;
}

static inline bool gloss_inverse_square(gloss_inverse *inverse, const gloss_corners *corners)
{
    float corner[3], middle[3], most = 0.0f, least = 4.0f, edge = 0.0f;
    for (int i = 0; i < 3; i++) {
        const real *const a = corners->normal[i], *const b = corners->normal[i == 2 ? 0 : i + 1];
        const real d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]}, sum[3] = {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
        const float chord = cosine_of(d, d);
        corner[i] = cosine_of(a, a);
        middle[i] = 0.25f * cosine_of(sum, sum);
        edge = chord > edge ? chord : edge;
        least = corner[i] < least ? corner[i] : least;
        most = corner[i] > most ? corner[i] : most;
    }
    least -= edge * (1.0f / 3);
    if (least < 0.5f) {
        return false;
    }
    const float root = glint_inverse_root(0.5f * (least + most)), over_m = root * root;
    const float part = 0.5f * (most - least) * over_m, second = part * part, c = 1.0f + 0.75f * second;
    for (int i = 0; i < 3; i++) {
        inverse->corner[i] = 1.0f + 0.5f * c - corner[i] * over_m;
        inverse->middle[i] = 1.0f + 0.5f * c - middle[i] * over_m;
    }
    inverse->rest = 1.0f - 0.25f * c * c;
    inverse->over_m = over_m;
    inverse->part = part;
    inverse->error_q22 = (uint32_t)(second * (part + 3.0f * second) * 1048576.0f) + 2;
    return true;
}

/* What all lights have in common at the points of a cubic: M, R, |M|^2 and 1/|R|. */
typedef struct gloss_points {
    float m[LATTICE_POINTS][3], ray[LATTICE_POINTS][3], square[LATTICE_POINTS], root[LATTICE_POINTS];
} gloss_points;

static inline void gloss_points_of(gloss_points *points, const gloss_corners *corners)
{
    for (int i = 0; i < LATTICE_POINTS; i++) {
        float m[3], ray[3];
        for (int k = 0; k < 3; k++) {
            m[k] = ray[k] = 0.0f;
            for (int j = 0; j < 3; j++) {
                const float share = (float)gloss_point[i][j] * (1.0f / 3);
                m[k] += share * corners->normal[j][k];
                ray[k] += share * corners->ray[j][k];
            }
            points->m[i][k] = m[k];
            points->ray[i][k] = ray[k];
        }
        points->square[i] = cosine_of(m, m);
        points->root[i] = glint_inverse_root(cosine_of(ray, ray));
    }
}

static inline int gloss_values(const gloss_corners *corners, const gloss_points *points, const gloss_inverse *inverse,
                               const real towards[3], float value[LATTICE_POINTS])
{
    const float mean = 0.5f + 0.5f * cosine_of(towards, towards);
    (void)corners;
    for (int i = 0; i < LATTICE_POINTS; i++) {
        const float *const m = points->m[i], *const ray = points->ray[i], root = points->root[i];
        value[i] = inverse->over_m * (points->square[i] * (mean - cosine_of(towards, ray) * root) +
                                      2.0f * cosine_of(m, towards) * (cosine_of(m, ray) * root));
    }
    return 0;
}

typedef struct gap_scale {
    float half, limit, places;
    uint32_t end;
} gap_scale;

#define GAP_BITS 8

static inline gap_scale gap_scale_of(uint16_t cells, uint8_t bits, int down, const gloss_inverse *inverse)
{
    const float end_q28 = (float)((uint32_t)cells << bits);
    const uint32_t end = (uint32_t)cells << GAP_BITS;
    const gap_scale scale = {0.0f, end_q28 * (1.0f + inverse->part) * (1.05f / 268435456),
                             268435456.0f / end_q28 * (float)end, end};
    (void)down;
    return scale;
}

typedef float gap_factor;

static inline gap_factor gap_inverse(float g, const gloss_inverse_rest *rest)
{
    return g * g + *rest;
}

static inline bool gap_beyond(float value, const gap_scale *scale)
{
    return value >= scale->limit;
}

static inline bool gap_within(float value, const gap_scale *scale)
{
    return value >= 0.0f && value < scale->limit;
}

typedef float gap_part;

static inline gap_part gap_part_of(float value, const gap_scale *scale)
{
    (void)scale;
    return value;
}

/* Rounded to the nearest. */
static inline uint32_t gap_place_of(gap_part part, gap_factor inverse, const gap_scale *scale)
{
    return (uint32_t)(part * inverse * scale->places + 0.5f); /* below 2^19 */
}

#endif
