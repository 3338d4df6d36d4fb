/* SPDX-License-Identifier: MIT */
/*
 * Quantities interpolated over a triangle, in fixed point: planes of raster/plane.h.
 *
 * Normals are interpolated as N / w, whose direction is that of the perspective-correct normal. The weight near / w of
 * a corner is brought to 30 bits by a shift common to the triangle, so that it keeps its precision however far away.
 */
#ifndef GLINT_RASTER_ATTRIBUTE_FIXED_H
#define GLINT_RASTER_ATTRIBUTE_FIXED_H

#include "backend/parts.h"
#include "lighting/light_fixed.h"
#include "raster/plane.h"

typedef glint_plane attribute_plane;

typedef struct attribute_weights {
    int32_t q30[2];
} attribute_weights;

/* The shift that brings the triangle's greatest inverse depth to 30 bits. */
typedef int inverse_scale;

static inline inverse_scale inverse_prepare(const glint_screen_vertex *const corner[3])
{
    uint32_t any = 1;
    for (int i = 0; i < 3; i++) {
        any |= (uint32_t)(corner[i]->depth_q30 - GLINT_DEPTH_BIAS);
    }
    return clz32(any) - 2;
}

static inline int32_t inverse_of(int32_t depth_q30, inverse_scale shift)
{
    return (depth_q30 - GLINT_DEPTH_BIAS) << shift;
}

/* A point's inverse distance for light_towards(). Clamped first: on a far surface the shift would magnify by how little
 * interpolation passes the corners' range. */
static inline void surface_set_inverse(surface *at, int32_t depth_q30, inverse_scale shift)
{
    if (!HAS(GLINT_PART_POINTS)) {
        return;
    }
    const int32_t inverse = depth_q30 - GLINT_DEPTH_BIAS, most = ((int32_t)1 << 30) >> shift;
    at->inverse = (inverse < 0 ? 0 : inverse > most ? most : inverse) << shift;
    at->inverse_fraction = (int16_t)(30 + shift);
    GLINT_TRACE("inverse distance", at->inverse);
}

/* Component of a unit normal (Q15) times the corner's weight: within 2^29. Rounding may have made it 32769, which the
 * product would not bear. */
static inline real normal_weigh(real component_q15, int32_t depth_q30, inverse_scale shift)
{
    const int32_t one = 32768, component = component_q15 > one ? one : component_q15 < -one ? -one : component_q15;
    const int32_t weight_q30 = inverse_of(depth_q30, shift);
    GLINT_TRACE("corner weight q30", weight_q30);
    return multiply_q16(weight_q30 > 0 ? weight_q30 : 1, component);
}

/* So little is left of an interpolated normal that rounding (2^14, see plane.h) decides its direction. */
static inline bool normal_vanishes(const real normal[3], int32_t depth_q30)
{
    (void)depth_q30; /* the weights of the corners reach 2^29, whatever the distance */
    GLINT_TRACE("weighted normal", normal[0]);
    GLINT_TRACE("weighted normal", normal[1]);
    GLINT_TRACE("weighted normal", normal[2]);
    return (magnitude32(normal[0]) | magnitude32(normal[1]) | magnitude32(normal[2])) < (uint32_t)1 << 14;
}

/* A colour channel (Q15) as an attribute and back. Rounding may pass the corners' range by a unit, hence the clamp. */
static inline real colour_to_attribute(uint16_t q15)
{
    return (real)q15 << 14;
}

static inline uint16_t attribute_to_colour(real attribute)
{
    GLINT_TRACE("colour attribute", attribute);
    const real q15 = (attribute + (1 << 13)) >> 14;
    return (uint16_t)(q15 < 0 ? 0 : q15 > 32768 ? 32768 : q15);
}

static inline void attribute_plane_set_up(attribute_plane *plane, const glint_gradients *gradients, const real v[3])
{
    glint_plane_set_up(plane, gradients, v[0], v[1], v[2]);
}

static inline void attribute_weights_from(attribute_weights *weights, const int32_t weight_q30[2])
{
    weights->q30[0] = weight_q30[0];
    weights->q30[1] = weight_q30[1];
}

/* A constant plane: the value at one pixel of a sliver. */
static inline void attribute_plane_hold(attribute_plane *plane, const attribute_weights *weights, const real v[3])
{
    plane->value = (uint32_t)glint_plane_weigh(weights->q30, v[0], v[1], v[2]);
    plane->step_x = plane->step_y = 0;
}

static inline real attribute_at(const attribute_plane *plane, const glint_gradients *gradients, int16_t x, int16_t y)
{
    return glint_plane_at(plane, gradients, x, y);
}

static inline real attribute_next(real value, const attribute_plane *plane)
{
    return (real)((uint32_t)value + plane->step_x);
}

/* Rays through pixel centres, see glint_frame. */
typedef struct pixel_rays {
    real v[3][3];
    int8_t fraction;   /* at most 30 */
    uint8_t down;      /* by how many bits the longest one over the display comes to 2^14..2^15 */
    uint16_t reach_px; /* |x| + |y| of the farthest vertex whose ray surface_set_vertex_ray() can take */
} pixel_rays;

/* Components are below 2^30 over the display, so the squares of 15 bits add up to 3 2^30 at most. The longest ray is
 * one through a corner. */
static inline uint8_t rays_down(const pixel_rays *rays, int16_t x_last, int16_t y_last)
{
    uint32_t longest = 0;
    uint8_t down = 15;
    for (int corner = 0; corner < 4; corner++) {
        const int16_t x = corner & 1 ? x_last : 0, y = corner & 2 ? y_last : 0;
        uint32_t square = 0;
        for (int k = 0; k < 3; k++) {
            const int32_t c = (rays->v[0][k] + x * rays->v[1][k] + y * rays->v[2][k]) >> 15;
            square += (uint32_t)(c * c);
        }
        longest = square > longest ? square : longest;
    }
    if (longest >= (uint32_t)1 << 30) {
        return 16;
    }
    for (; down > 1 && longest < ((uint32_t)1 << 28) - ((uint32_t)1 << 16); longest <<= 2) {
        down--;
    }
    return down;
}

static inline void rays_prepare(pixel_rays *rays, const glint_frame *frame, const glint_view *view)
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            rays->v[i][k] = frame->ray[i][k];
        }
    }
    rays->fraction = (int8_t)frame->ray_fraction;
    if (!HAS(GLINT_PART_TIERS)) {
        return;
    }
    rays->down = rays_down(rays, (int16_t)(view->width_px - 1), (int16_t)(view->height_px - 1));
    /* an eighth of v[0], below 2^28, and |x| + |y| eighths of a step stay below 2^30 */
    uint32_t step = 0;
    for (int k = 0; k < 3; k++) {
        step |= magnitude32(rays->v[1][k]) | magnitude32(rays->v[2][k]);
    }
    const uint32_t reach = ((uint32_t)3 << 28) / ((step >> 3) + 1);
    rays->reach_px = (uint16_t)(reach > 4096 ? 4096 : reach);
}

static inline void surface_set_ray(surface *at, const pixel_rays *rays, int16_t x, int16_t y)
{
    for (int k = 0; k < 3; k++) {
        at->ray[k] = rays->v[0][k] + x * rays->v[1][k] + y * rays->v[2][k];
        GLINT_TRACE("ray", at->ray[k]);
    }
    at->ray_fraction = rays->fraction;
}

/* The ray through a vertex, which may lie outside of the display: an eighth of it, so that it fits. Through a pixel's
 * centre and the rest of the way in 1/4096 px. False where it does not fit. */
static inline bool surface_set_vertex_ray(surface *at, const pixel_rays *rays, const glint_screen_vertex *vertex)
{
    const int32_t x = vertex->x - GLINT_FINE / 2, y = vertex->y - GLINT_FINE / 2;
    const int32_t px = x >> GLINT_FINE_BITS, py = y >> GLINT_FINE_BITS;
    const int32_t part_x = x & (GLINT_FINE - 1), part_y = y & (GLINT_FINE - 1);
    if (magnitude32(px) + magnitude32(py) + 2 > rays->reach_px) {
        return false;
    }
    for (int k = 0; k < 3; k++) {
        const int32_t right = rays->v[1][k], down = rays->v[2][k];
        /* what the eighths of the steps drop: 7 (|px| + |py|) / 8 < 2^12; and steps are below 2^30 */
        at->ray[k] =
            (rays->v[0][k] >> 3) + px * (right >> 3) + py * (down >> 3) + ((px * (right & 7) + py * (down & 7)) >> 3) +
            (right >> (GLINT_FINE_BITS + 3)) * part_x + (down >> (GLINT_FINE_BITS + 3)) * part_y +
            (((right >> 3 & (GLINT_FINE - 1)) * part_x + (down >> 3 & (GLINT_FINE - 1)) * part_y) >> GLINT_FINE_BITS);
        GLINT_TRACE("ray through a vertex", at->ray[k]);
    }
    at->ray_fraction = (int16_t)(rays->fraction - 3);
    return true;
}

static inline void surface_next_ray(surface *at, const pixel_rays *rays)
{
    for (int k = 0; k < 3; k++) {
        at->ray[k] += rays->v[1][k];
        GLINT_TRACE("ray", at->ray[k]);
    }
}

/* Placement of corners in the lighting frame, see glint_placement. */
typedef glint_placement placement_state;

static inline void placement_prepare(placement_state *state, const glint_placement *placement)
{
    *state = *placement;
}

static inline void placement_of(const placement_state *state, const int16_t position[3], real out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = multiply_q16(state->rows[i][0], position[0]) + multiply_q16(state->rows[i][1], position[1]) +
                 multiply_q16(state->rows[i][2], position[2]) + state->rows[i][3];
        GLINT_TRACE("placement", out[i]);
    }
}

/* The point itself takes the place of the ray: its inverse distance is then 1. */
static inline void surface_set_point(surface *at, const placement_state *state, const real point[3])
{
    for (int k = 0; k < 3; k++) {
        at->ray[k] = point[k];
    }
    at->ray_fraction = state->fraction;
    at->inverse = GLINT_DEPTH_SPAN;
    at->inverse_fraction = 30;
}

/* value / 3, without a division. */
static inline int32_t third_part(int32_t value)
{
    return multiply_high_s32(value, 0x55555556) + (value < 0);
}

/* Mean of three points, each below 2^30. */
static inline real third_of(real a, real b, real c)
{
    return third_part((a >> 2) + (b >> 2) + (c >> 2)) * 4;
}

/* Stored normals: Q14 to the unit vectors' Q15; rows of the inverse transpose. */
static inline real normal_component(int16_t q14)
{
    return (real)q14 * 2;
}

typedef int32_t normal_row[3];

static inline void normal_rows_prepare(normal_row rows[3], const glint_frame *frame)
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            rows[i][k] = frame->normal_rows[i][k];
        }
    }
}

static inline real normal_row_times(const normal_row row, const int16_t normal[3])
{
    return multiply_q16(row[0], normal[0]) + multiply_q16(row[1], normal[1]) + multiply_q16(row[2], normal[2]);
}

#endif
