/* SPDX-License-Identifier: MIT */
/*
 * A quantity that is linear on the screen, in integers: value + step_x dx + step_y dy.
 *
 * Scaling and overflow: corner values lie within +-2^29 (depth: 0..2^30). A step may be large for a thin triangle, and
 * products of steps and distances may pass 2^32, but arithmetic is modulo 2^32 and the value at any pixel inside lies
 * within the corners' range (a sixteenth beyond, see gradients.h), so the result is right. Rounding: gradients of the
 * barycentric coordinates err by at most 2 units of their last bit, and all of them by one relative 2^-28.3, the
 * reciprocal's. So steps of two of them err by 4 units; products without their low halves (plane.c) by 2, rounding down
 * by 1; and at n pixels (in x plus y) from the anchor the value errs by at most 7 n + 8 units of 2^-30, and 4 for the
 * reciprocal: 2^-15.1 of the range across the largest display, however small the corners' differences. Since a value
 * depends on the pixel alone, not on the path to it, bands and spans may start anywhere.
 */
#ifndef GLINT_RASTER_PLANE_H
#define GLINT_RASTER_PLANE_H

#include "raster/gradients.h"

typedef struct glint_plane {
    uint32_t value;  /* at the anchor pixel of the gradients, modulo 2^32 */
    uint32_t step_x; /* to the right, modulo 2^32 */
    uint32_t step_y; /* down */
} glint_plane;

/* The plane through three corner values, |v| <= 2^30; corners in the order of `gradients`. Not for slivers. */
void glint_plane_set_up(glint_plane *plane, const glint_gradients *gradients, int32_t v0, int32_t v1, int32_t v2);

/* For slivers: the value at one pixel, of weights from glint_gradients_weights(), held constant. */
int32_t glint_plane_weigh(const int32_t weight_q30[2], int32_t v0, int32_t v1, int32_t v2);

static inline int32_t glint_plane_at(const glint_plane *plane, const glint_gradients *gradients, int16_t x, int16_t y)
{
    return (int32_t)(plane->value + plane->step_x * (uint32_t)((int32_t)x - gradients->anchor_x) +
                     plane->step_y * (uint32_t)((int32_t)y - gradients->anchor_y));
}

#endif
