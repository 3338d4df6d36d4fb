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

static inline int gloss_values(const gloss_corners *corners, const real towards[3], float value[LATTICE_POINTS])
{
    const float mean = 0.5f + 0.5f * cosine_of(towards, towards);
    for (int i = 0; i < LATTICE_POINTS; i++) {
        float m[3], ray[3];
        for (int k = 0; k < 3; k++) {
            m[k] = ray[k] = 0.0f;
            for (int j = 0; j < 3; j++) {
                const float share = (float)gloss_point[i][j] * (1.0f / 3);
                m[k] += share * corners->normal[j][k];
                ray[k] += share * corners->ray[j][k];
            }
        }
        const float inverse = glint_inverse_root(cosine_of(ray, ray));
        value[i] = cosine_of(m, m) * (mean - cosine_of(towards, ray) * inverse) +
                   2.0f * cosine_of(m, towards) * (cosine_of(m, ray) * inverse);
    }
    return 0;
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

static inline void gloss_inverse_squares(const gloss_corners *corners, float value[LATTICE_POINTS])
{
    for (int i = 0; i < LATTICE_POINTS; i++) {
        float m[3];
        for (int k = 0; k < 3; k++) {
            m[k] = 0.0f;
            for (int j = 0; j < 3; j++) {
                m[k] += (float)gloss_point[i][j] * (1.0f / 3) * corners->normal[j][k];
            }
        }
        const float inverse = glint_inverse_root(cosine_of(m, m));
        value[i] = inverse * inverse;
    }
}

typedef struct gap_scale {
    float limit;
} gap_scale;

static inline gap_scale gap_scale_of(uint32_t end_q28, int down)
{
    const gap_scale scale = {(float)end_q28 * (1.05f / 268435456)};
    (void)down;
    return scale;
}

typedef float gap_part;

#define GAP_BEYOND 16.0f

static inline gap_part gap_part_of(float value, const gap_scale *scale)
{
    return value < scale->limit ? value : GAP_BEYOND;
}

static inline uint32_t gap_q28_of(gap_part part, float inverse_square, const gap_scale *scale)
{
    (void)scale;
    return part < 4.0f ? wide_gap_q28(part * inverse_square) : UINT32_MAX; /* below 1.05 times 4 */
}

#endif
