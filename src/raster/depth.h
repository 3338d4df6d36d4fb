/* SPDX-License-Identifier: MIT */
/*
 * The depth test, over spans. Inverse depth in 16 bits, greater is nearer, 0 is nothing; where depths are equal, what
 * was drawn first stays.
 */
#ifndef GLINT_RASTER_DEPTH_H
#define GLINT_RASTER_DEPTH_H

#include <stddef.h>

#include "raster/plane.h"

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
    while (pixel != end) {
        const uint32_t nearness = depth >> GLINT_DEPTH_SHIFT;
        if (nearness <= *pixel) {
            break;
        }
        GLINT_TRACE("interpolated depth q30", depth);
        *pixel++ = (uint16_t)nearness;
        depth += step;
    }
    *at = pixel;
    *depth_q30 = depth;
    return pixel == first ? NULL : first;
}

#endif
