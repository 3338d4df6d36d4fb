/* SPDX-License-Identifier: MIT */
/*
 * Barycentric coordinates on the screen: their change from pixel to pixel, for everything that is interpolated over a
 * triangle.
 *
 * They belong to the vertices before snapping. A pixel that the snapped triangle covers may thus lie outside of the
 * unsnapped one, by at most 0.71 / 256 px, and a barycentric coordinate outside of 0..1 by at most 2^-8 of its gradient
 * per pixel. Where the gradient is so steep that this could matter, or may pass 1 a pixel, coordinates are computed at
 * each pixel instead and clamped: that is a sliver, of which few pixels are covered.
 */
#ifndef GLINT_RASTER_GRADIENTS_H
#define GLINT_RASTER_GRADIENTS_H

#include "raster/edges.h"

typedef struct glint_gradients {
    const glint_screen_vertex *corner[3]; /* clockwise on the display */
    bool sliver;                          /* the gradients are not set: use glint_gradients_weights() at each pixel */
    int32_t x[2], y[2];         /* change of the coordinates of corners 1 and 2, per pixel right and down, Q30 */
    int16_t anchor_x, anchor_y; /* the pixel that holds corner 0 */
    int16_t offset_x, offset_y; /* from corner 0 to that pixel's centre, 1/4096 px: -2047..2048 */
    int64_t area;               /* twice the area in (1/4096 px)^2; may be 0 or less for a sliver */
    uint32_t inverse_q31;       /* 1/area is inverse_q31 2^-(62 + inverse_down); that of 1 where there is no area */
    int inverse_down;
} glint_gradients;

/* `order` is the clockwise order of its three vertices, see glint_edges. */
void glint_gradients_set_up(glint_gradients *gradients, const glint_screen_vertex *const corner[3],
                            const uint8_t order[3]);

/* How many bits the steepest gradient is below 1/2 a pixel: 0 where it is above. Not for slivers. */
static inline int glint_gradients_spare_bits(const glint_gradients *gradients)
{
    const int zeros = clz32(magnitude32(gradients->x[0]) | magnitude32(gradients->x[1]) | magnitude32(gradients->y[0]) |
                            magnitude32(gradients->y[1]) | 1);
    return zeros < 2 ? 0 : zeros - 2;
}

/* Are there 3 of them at least? False for slivers. */
static inline bool glint_gradients_gentle(const glint_gradients *gradients)
{
    if (gradients->sliver) {
        return false;
    }
    const uint32_t any = magnitude32(gradients->x[0]) | magnitude32(gradients->x[1]) | magnitude32(gradients->y[0]) |
                         magnitude32(gradients->y[1]);
    return any >> 27 == 0;
}

/*
 * For slivers: barycentric coordinates of corners 1 and 2 at a pixel's centre, Q30, clamped so that all three are
 * 0..2^30 and their sum is 2^30. Error before clamping at most 2^-27.
 */
void glint_gradients_weights(const glint_gradients *gradients, int16_t x, int16_t y, int32_t weight_q30[2]);

#endif
