/* SPDX-License-Identifier: MIT */
/*
 * The depth test, over spans. Inverse depth in 16 bits, greater is nearer, 0 is nothing; where depths are equal, what
 * was drawn first stays.
 */
#ifndef GLINT_RASTER_DEPTH_H
#define GLINT_RASTER_DEPTH_H

#include <stddef.h>

#include "raster/plane.h"

/* Tests one pixel; writes it and steps on if it passes. */
static inline bool glint_depth_pass(uint16_t *pixel, uint32_t *depth_q30, uint32_t step)
{
    const uint32_t nearness = *depth_q30 >> GLINT_DEPTH_SHIFT;
    if (nearness <= *pixel) {
        return false;
    }
    GLINT_TRACE("interpolated depth q30", *depth_q30);
    *pixel = (uint16_t)nearness;
    *depth_q30 += step;
    return true;
}

/*
 * Finds the next run of pixels of a depth row, from *at to `end`, that the plane's values pass, and writes them.
 * *depth_q30 is the value at *at, and both move along to behind the run. Returns the run's first pixel, NULL when none
 * is left.
 */
static inline uint16_t *glint_depth_run(uint16_t **at, const uint16_t *end, uint32_t *depth_q30, uint32_t step)
{
    uint16_t *pixel = *at, *first;
    uint32_t depth = *depth_q30;
    while (pixel != end && depth >> GLINT_DEPTH_SHIFT <= *pixel) {
        GLINT_TRACE("interpolated depth q30", depth);
        depth += step;
        pixel++;
    }
    first = pixel;
    /* four at a time: most pixels pass, and small processors spend more on the loop than on the test */
    while (end - pixel >= 4) {
        if (!glint_depth_pass(&pixel[0], &depth, step)) {
            break;
        }
        if (!glint_depth_pass(&pixel[1], &depth, step)) {
            pixel += 1;
            break;
        }
        if (!glint_depth_pass(&pixel[2], &depth, step)) {
            pixel += 2;
            break;
        }
        if (!glint_depth_pass(&pixel[3], &depth, step)) {
            pixel += 3;
            break;
        }
        pixel += 4;
    }
    while (pixel != end && glint_depth_pass(pixel, &depth, step)) {
        pixel++;
    }
    *at = pixel;
    *depth_q30 = depth;
    return pixel == first ? NULL : first;
}

#endif
