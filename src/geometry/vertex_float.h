/* SPDX-License-Identifier: MIT */
/*
 * The vertex stage in float: model position to view, and view to screen. Ends on the same grid as the fixed
 * one.
 */
#ifndef GLINT_GEOMETRY_VERTEX_FLOAT_H
#define GLINT_GEOMETRY_VERTEX_FLOAT_H

#include "number/real.h"
#include "raster/edges.h"

typedef struct transform_state {
    float x[4], y[4], z[4]; /* X and Y in px times world units, Z in world units */
    float near_z;
    float depth_near; /* near GLINT_DEPTH_SPAN */
} transform_state;

typedef struct view_vertex {
    float x, y, z;
} view_vertex;

static inline void transform_prepare_row(float out[4], const int32_t row[4], int fraction)
{
    for (int k = 0; k < 4; k++) {
        out[k] = float_from_scaled(row[k], k == 3 ? fraction : fraction + 16);
    }
}

static inline void transform_prepare(transform_state *state, const glint_transform *transform)
{
    transform_prepare_row(state->x, transform->x, transform->xy_fraction);
    transform_prepare_row(state->y, transform->y, transform->xy_fraction);
    transform_prepare_row(state->z, transform->z, transform->z_fraction);
    state->depth_near = float_from_scaled(transform->depth_near.m, transform->depth_near.f);
    state->near_z = state->depth_near / (float)GLINT_DEPTH_SPAN;
}

static inline float transform_row(const float row[4], const int16_t position[3])
{
    return row[0] * (float)position[0] + row[1] * (float)position[1] + row[2] * (float)position[2] + row[3];
}

static inline view_vertex vertex_to_view(const transform_state *state, const int16_t position[3])
{
    const view_vertex v = {transform_row(state->x, position), transform_row(state->y, position),
                           transform_row(state->z, position)};
    return v;
}

static inline bool vertex_is_near(const transform_state *state, const view_vertex *v)
{
    return v->z <= state->near_z; /* a vertex on the plane counts as cut away */
}

static inline bool project_coordinate(float coordinate, float inverse_z, int32_t centre, int32_t *screen)
{
    const float fine = coordinate * inverse_z * (float)GLINT_FINE;
    const float guard = (float)GLINT_GUARD_PX * (float)GLINT_FINE;
    if (!(fine >= -guard && fine <= guard)) {
        return false;
    }
    *screen = centre + float_floor(fine + 0.5f);
    return true;
}

static inline bool vertex_project(const transform_state *state, const view_vertex *v, const glint_view *view,
                                  glint_screen_vertex *screen)
{
    const float inverse_z = 1.0f / (v->z > state->near_z ? v->z : state->near_z);
    if (!project_coordinate(v->x, inverse_z, (int32_t)view->width_px * (GLINT_FINE / 2), &screen->x) ||
        !project_coordinate(v->y, inverse_z, (int32_t)view->height_px * (GLINT_FINE / 2), &screen->y)) {
        return false;
    }
    const float depth = state->depth_near * inverse_z;
    screen->depth_q30 = GLINT_DEPTH_BIAS + (depth < (float)GLINT_DEPTH_SPAN ? (int32_t)depth : GLINT_DEPTH_SPAN);
    return true;
}

typedef float plane_distance;

static inline plane_distance clip_distance(const transform_state *state, const view_vertex *v, int plane)
{
    if (plane == 0) {
        return v->z - state->near_z;
    }
    const float coordinate = plane <= 2 ? v->x : v->y;
    const float edge = v->z * (float)(GLINT_GUARD_PX - 4);
    return plane & 1 ? edge - coordinate : edge + coordinate;
}

typedef float clip_ratio;

static inline clip_ratio clip_crossing(plane_distance inside, plane_distance outside)
{
    return inside / (inside - outside);
}

static inline float clip_blend(float from, float to, clip_ratio t)
{
    return from + (to - from) * t;
}

static inline bool vertex_is_finite(const view_vertex *v)
{
    /* infinity - infinity and anything with NaN compare unequal */
    return v->x - v->x == 0.0f && v->y - v->y == 0.0f && v->z - v->z == 0.0f;
}

#endif
