/* SPDX-License-Identifier: MIT */
/*
 * The depth test, over spans. Inverse depth in 16 bits, greater is nearer, 0 is nothing; where depths are equal, what
 * was drawn first stays.
 */
#ifndef GLINT_RASTER_DEPTH_H
#define GLINT_RASTER_DEPTH_H

#include "raster/plane.h"

/*
 * Writes pixels of a depth row, from `at` to `end`, as long as the plane's values pass, which begin with depth_q30 at
 * `at`. Returns the first pixel that fails, or `end`.
 */
uint16_t *glint_depth_write(uint16_t *at, uint16_t *end, uint32_t depth_q30, uint32_t step);

/* The first pixel from `at` to `end` that passes, or `end`. Writes nothing. */
uint16_t *glint_depth_skip(uint16_t *at, uint16_t *end, uint32_t depth_q30, uint32_t step);

#endif
