/* SPDX-License-Identifier: MIT */
/*
 * The depth test, over spans. Inverse depth in 16 bits, greater is nearer, 0 is nothing; where depths are equal, what
 * was drawn first stays.
 */
#ifndef GLINT_RASTER_DEPTH_H
#define GLINT_RASTER_DEPTH_H

#include "raster/plane.h"

/*
 * Writes the first pixels, of `count`, of a part of a depth row: as long as the plane's values pass, which begin with
 * depth_q30. Returns how many passed.
 */
uint32_t glint_depth_write(uint16_t *at, uint32_t count, uint32_t depth_q30, uint32_t step);

/* How many of the first pixels, of `count`, fail. Writes nothing. */
uint32_t glint_depth_skip(const uint16_t *at, uint32_t count, uint32_t depth_q30, uint32_t step);

#endif
