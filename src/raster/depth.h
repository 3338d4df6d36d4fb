/* SPDX-License-Identifier: MIT */
/*
 * The depth test, over spans. Inverse depth in 16 bits, greater is nearer, 0 is nothing; where depths are equal, what
 * was drawn first stays.
 */
#ifndef GLINT_RASTER_DEPTH_H
#define GLINT_RASTER_DEPTH_H

#include "raster/plane.h"

/*
 * Finds the next run of pixels in x..x_last of a depth row that the plane's values pass, and writes them. `*depth_q30`
 * is the value at x and moves along. Returns the run's length and sets *x_run to its first pixel; 0 when none is left.
 * *x ends behind the run.
 */
static inline uint16_t glint_depth_run(uint16_t *row, uint32_t *depth_q30, uint32_t step, int16_t *x, int16_t x_last,
                                       int16_t *x_run)
{
    uint32_t value = *depth_q30;
    int16_t i = *x;
    while (i <= x_last && (uint16_t)(value >> GLINT_DEPTH_SHIFT) <= row[i]) {
        GLINT_TRACE("interpolated depth q30", value);
        value += step;
        i++;
    }
    *x_run = i;
    while (i <= x_last && (uint16_t)(value >> GLINT_DEPTH_SHIFT) > row[i]) {
        GLINT_TRACE("interpolated depth q30", value);
        row[i] = (uint16_t)(value >> GLINT_DEPTH_SHIFT);
        value += step;
        i++;
    }
    *depth_q30 = value;
    *x = i;
    return (uint16_t)(i - *x_run);
}

#endif
