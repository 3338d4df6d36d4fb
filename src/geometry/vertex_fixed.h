/* SPDX-License-Identifier: MIT */
/*
 * The vertex stage in fixed point: model position to view, and view to screen.
 *
 * A position is transformed by 16 x 32 bit products; a coordinate errs by at most 6 units of its last bit, which is at
 * most 2^-27 (X, Y) or 2^-28 (Z) of the object's extent (the distance from the eye of the farthest point that a
 * position could name). The projection adds a relative 2^-27.8.
 */
#ifndef GLINT_GEOMETRY_VERTEX_FIXED_H
#define GLINT_GEOMETRY_VERTEX_FIXED_H

#include "raster/edges.h"

typedef glint_transform transform_state;

/* X and Y with xy_fraction, Z with z_fraction fractional bits; below 2^30. */
typedef struct view_vertex {
    int32_t x, y, z;
} view_vertex;

static inline void transform_prepare(transform_state *state, const glint_transform *transform)
{
    *state = *transform;
}

static inline int32_t transform_row(const int32_t row[4], const int16_t position[3])
{
    return multiply_q16(row[0], position[0]) + multiply_q16(row[1], position[1]) + multiply_q16(row[2], position[2]) +
           row[3];
}

static inline view_vertex vertex_to_view(const transform_state *state, const int16_t position[3])
{
    const view_vertex v = {transform_row(state->x, position), transform_row(state->y, position),
                           transform_row(state->z, position)};
    GLINT_TRACE("view x y", v.x);
    GLINT_TRACE("view x y", v.y);
    GLINT_TRACE("view z", v.z);
    return v;
}

static inline bool vertex_is_near(const transform_state *state, const view_vertex *v)
{
    return v->z <= state->near_z; /* a vertex on the plane counts as cut away */
}

/* coordinate 2^up, below 2^27 in magnitude; false if it would be larger. */
static inline bool project_raise(int32_t *coordinate, int up)
{
    if (up > 27 || magnitude32(*coordinate) >> (27 - up)) {
        return *coordinate == 0;
    }
    *coordinate = (int32_t)((uint32_t)*coordinate << up);
    return true;
}

/* coordinate r / 2^(33 + down), which is (coordinate / Z) in 1/4096 px from the display's centre, rounded to nearest;
 * false beyond the guard band. r < 2^31, down within 0..31. */
static inline bool project_coordinate(int32_t coordinate, uint32_t r, int down, int32_t centre, int32_t *screen)
{
    GLINT_TRACE("projection product", (int64_t)coordinate * r); /* < 2^61, so the upper half < 2^29 */
    const int32_t fine = ((multiply_high_s32_u31(coordinate, r) >> down) + 1) >> 1;
    const int32_t guard = (int32_t)GLINT_GUARD_PX * GLINT_FINE;
    if (fine < -guard || fine > guard) {
        return false;
    }
    GLINT_TRACE("screen from centre q12", fine);
    *screen = centre + fine;
    return true;
}

/* Z >= near_z, but for the rounding of a clipped vertex. False beyond the guard band. */
static GLINT_SHARED bool vertex_project(const transform_state *state, const view_vertex *v, const glint_view *view,
                                        glint_screen_vertex *screen)
{
    const uint32_t z = v->z > 0 ? (uint32_t)v->z : 1;
    const int zeros = clz32(z);
    const uint32_t r = glint_reciprocal_q31(z << zeros); /* in [2^30, 2^31) */
    /* 1/Z = r 2^(z_fraction + zeros - 62); with X 2^-xy_fraction and 2^12 steps in a px, the position is
     * X r / 2^(33 + down): for down >= 0 the upper half of the product and the bit that rounds suffice. */
    const int shift = zeros + state->z_fraction;
    int down = 62 - GLINT_FINE_BITS - 33 - shift + state->xy_fraction;
    int32_t x = v->x, y = v->y;
    if (down < 0) {
        /* X in finer units; one that would reach 2^27 is 2^24 steps or more from the centre, beyond the guard band */
        if (!project_raise(&x, -down) || !project_raise(&y, -down)) {
            return false;
        }
        down = 0;
    }
    down = down > 31 ? 31 : down;
    if (!project_coordinate(x, r, down, (int32_t)view->width_px * (GLINT_FINE / 2), &screen->x) ||
        !project_coordinate(y, r, down, (int32_t)view->height_px * (GLINT_FINE / 2), &screen->y)) {
        return false;
    }
    /* near SPAN / Z = near.m r >> (31 + depth_down); the product is at least 2^60 and SPAN below 2^30 */
    const int depth_down = 31 - shift + state->depth_near.f;
    uint32_t depth = (uint32_t)GLINT_DEPTH_SPAN;
    if (depth_down >= 0) {
        const uint32_t exact = multiply_high_u32((uint32_t)state->depth_near.m << 1, r) /* < 2^31 */
                               >> (depth_down > 31 ? 31 : depth_down);
        depth = exact < depth ? exact : depth;
    }
    screen->depth_q30 = GLINT_DEPTH_BIAS + (int32_t)depth;
    GLINT_TRACE("inverse depth q30", screen->depth_q30);
    return true;
}

/*
 * Clipping. Signed distance to a plane, positive inside: 0 is the near plane, 1..4 the sides of the guard band, a
 * little within the band so that rounding does not leave it.
 */
typedef int64_t plane_distance;

static GLINT_SHARED plane_distance clip_distance(const transform_state *state, const view_vertex *v, int plane)
{
    if (plane == 0) {
        return (int64_t)v->z - state->near_z;
    }
    const int32_t coordinate = plane <= 2 ? v->x : v->y;
    /* px x units of X; from a shift of 20 on, the band's edge is beyond every coordinate, and beyond 22 it overflows */
    const int shift = state->xy_fraction - state->z_fraction;
    const int64_t edge = shift_round64(multiply_wide_s32(v->z, GLINT_GUARD_PX - 4), shift < 22 ? shift : 22);
    return plane & 1 ? edge - coordinate : edge + coordinate;
}

/* inside / (inside - outside) in Q30, inside > 0 >= outside. Relative error 2^-27. */
typedef int32_t clip_ratio;

static inline clip_ratio clip_crossing(plane_distance inside, plane_distance outside)
{
    const uint64_t whole = (uint64_t)inside + magnitude64(outside);
    int bits;
    const uint32_t divisor = normalize64(whole, &bits);
    const uint32_t dividend = (uint32_t)((uint64_t)inside << (64 - bits) >> 32);
    /* dividend / divisor = dividend r / 2^62 */
    const uint32_t quotient_q30 = multiply_high_u32(dividend, glint_reciprocal_q31(divisor)); /* may be 2 above 1 */
    const int32_t ratio_q30 = quotient_q30 < (uint32_t)1 << 30 ? (int32_t)quotient_q30 : (int32_t)1 << 30;
    GLINT_TRACE("clip ratio q30", ratio_q30);
    return ratio_q30;
}

static GLINT_SHARED int32_t clip_blend(int32_t from, int32_t to, clip_ratio t_q30)
{
    const int64_t way = (((int64_t)to - from) * t_q30) >> 30;
    GLINT_TRACE("clip way", way);
    return from + (int32_t)way;
}

static inline bool vertex_is_finite(const view_vertex *v)
{
    (void)v;
    return true;
}

#endif
