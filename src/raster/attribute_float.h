/* SPDX-License-Identifier: MIT */
/*
 * Quantities interpolated over a triangle, in float. See attribute_fixed.h for what each operation does.
 */
#ifndef GLINT_RASTER_ATTRIBUTE_FLOAT_H
#define GLINT_RASTER_ATTRIBUTE_FLOAT_H

#include "lighting/light_float.h"
#include "raster/plane.h"

/* value + step_x dx + step_y dy from the anchor pixel. */
typedef struct attribute_plane {
    float value, step_x, step_y;
} attribute_plane;

typedef struct attribute_weights {
    float v[2];
} attribute_weights;

typedef char inverse_scale; /* floats keep their precision by themselves */

static inline inverse_scale inverse_prepare(const glint_screen_vertex *const corner[3])
{
    (void)corner;
    return 0;
}

static inline float inverse_of(int32_t depth_q30)
{
    return (float)(depth_q30 - GLINT_DEPTH_BIAS) * (1.0f / (float)GLINT_DEPTH_SPAN);
}

static inline void surface_set_inverse(surface *at, int32_t depth_q30, inverse_scale scale)
{
    (void)scale;
    at->inverse = inverse_of(depth_q30);
}

static inline real normal_weigh(real component, int32_t depth_q30, inverse_scale scale)
{
    (void)scale;
    return component * inverse_of(depth_q30 > GLINT_DEPTH_BIAS ? depth_q30 : GLINT_DEPTH_BIAS + 1);
}

/* Against the weight 1/w; rounding leaves some 2^-20 of it. */
static inline bool normal_vanishes(const real normal[3], int32_t depth_q30)
{
    const float limit = inverse_of(depth_q30) * (1.0f / 131072);
    return cosine_of(normal, normal) < limit * limit;
}

static inline real colour_to_attribute(uint16_t q15)
{
    return (float)q15;
}

static inline uint16_t attribute_to_colour(real attribute)
{
    return attribute >= 32767.5f ? 32768 : attribute > 0.0f ? (uint16_t)(attribute + 0.5f) : 0;
}

static inline void attribute_plane_set_up(attribute_plane *plane, const glint_gradients *gradients, const real v[3])
{
    const float d1 = v[1] - v[0], d2 = v[2] - v[0];
    plane->step_x = float_from_scaled(gradients->x[0], 30) * d1 + float_from_scaled(gradients->x[1], 30) * d2;
    plane->step_y = float_from_scaled(gradients->y[0], 30) * d1 + float_from_scaled(gradients->y[1], 30) * d2;
    plane->value = v[0] + (plane->step_x * (float)gradients->offset_x + plane->step_y * (float)gradients->offset_y) *
                              (1.0f / (float)GLINT_FINE);
}

static inline void attribute_weights_from(attribute_weights *weights, const int32_t weight_q30[2])
{
    weights->v[0] = float_from_scaled(weight_q30[0], 30);
    weights->v[1] = float_from_scaled(weight_q30[1], 30);
}

static inline void attribute_plane_hold(attribute_plane *plane, const attribute_weights *weights, const real v[3])
{
    plane->value = v[0] + weights->v[0] * (v[1] - v[0]) + weights->v[1] * (v[2] - v[0]);
    plane->step_x = plane->step_y = 0.0f;
}

static inline real attribute_at(const attribute_plane *plane, const glint_gradients *gradients, int16_t x, int16_t y)
{
    return plane->value + plane->step_x * (float)(x - gradients->anchor_x) +
           plane->step_y * (float)(y - gradients->anchor_y);
}

static inline real attribute_next(real value, const attribute_plane *plane)
{
    return value + plane->step_x;
}

typedef struct pixel_rays {
    real v[3][3];
} pixel_rays;

static inline void rays_prepare(pixel_rays *rays, const glint_frame *frame, const glint_view *view)
{
    (void)view;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            rays->v[i][k] = float_from_scaled(frame->ray[i][k], frame->ray_fraction);
        }
    }
}

static inline void surface_set_ray(surface *at, const pixel_rays *rays, int16_t x, int16_t y)
{
    for (int k = 0; k < 3; k++) {
        at->ray[k] = rays->v[0][k] + (float)x * rays->v[1][k] + (float)y * rays->v[2][k];
    }
}

static inline bool surface_set_vertex_ray(surface *at, const pixel_rays *rays, const glint_screen_vertex *vertex)
{
    const float x = (float)(vertex->x - (GLINT_FINE >> 1)) * (1.0f / GLINT_FINE);
    const float y = (float)(vertex->y - (GLINT_FINE >> 1)) * (1.0f / GLINT_FINE);
    for (int k = 0; k < 3; k++) {
        at->ray[k] = rays->v[0][k] + x * rays->v[1][k] + y * rays->v[2][k];
    }
    return true;
}

static inline void surface_next_ray(surface *at, const pixel_rays *rays)
{
    for (int k = 0; k < 3; k++) {
        at->ray[k] += rays->v[1][k];
    }
}

typedef struct placement_state {
    real rows[3][4];
} placement_state;

static inline void placement_prepare(placement_state *state, const glint_placement *placement)
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 4; k++) {
            state->rows[i][k] =
                float_from_scaled(placement->rows[i][k], k == 3 ? placement->fraction : placement->fraction + 16);
        }
    }
}

static inline void placement_of(const placement_state *state, const int16_t position[3], real out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = state->rows[i][0] * (float)position[0] + state->rows[i][1] * (float)position[1] +
                 state->rows[i][2] * (float)position[2] + state->rows[i][3];
    }
}

static inline void surface_set_point(surface *at, const placement_state *state, const real point[3])
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        at->ray[k] = point[k];
    }
    at->inverse = 1.0f;
}

static inline real third_of(real a, real b, real c)
{
    return (a + b + c) * (1.0f / 3);
}

static inline real normal_component(int16_t q14)
{
    return (float)q14 * (1.0f / 16384);
}

typedef float normal_row[3];

static inline void normal_rows_prepare(normal_row rows[3], const glint_frame *frame)
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            rows[i][k] = (float)frame->normal_rows[i][k];
        }
    }
}

static inline real normal_row_times(const normal_row row, const int16_t normal[3])
{
    return row[0] * (float)normal[0] + row[1] * (float)normal[1] + row[2] * (float)normal[2];
}

#endif
