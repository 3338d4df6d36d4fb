/* SPDX-License-Identifier: MIT */
/*
 * A mirror's map of the environment: what both backends share. The map is that of glint_environment in <glint/scene.h>.
 */
#ifndef GLINT_LIGHTING_MIRROR_H
#define GLINT_LIGHTING_MIRROR_H

#include <glint/scene.h>

#include "number/integer.h"

/* The texel at column i of row j, -1..side each, beyond the edges as the octahedron folds. */
static inline uint16_t glint_environment_texel(const glint_environment *map, int16_t i, int16_t j)
{
    const int16_t side = map->side, last = (int16_t)(side - 1);
    if (i < 0 || i > last) {
        i = i < 0 ? 0 : last;
        j = (int16_t)(last - j);
    }
    if (j < 0 || j > last) {
        j = j < 0 ? 0 : last;
        i = (int16_t)(last - i);
    }
    return flash_u16(&map->texels[(uint16_t)j * (uint16_t)side + (uint16_t)i]);
}

/* The three channels of a texel: 5, 6 and 5 bits. */
static inline void glint_environment_channels(uint16_t texel, uint16_t channel[3])
{
    channel[0] = (uint16_t)(texel >> 11);
    channel[1] = (uint16_t)(texel >> 5) & 63;
    channel[2] = texel & 31;
}

/*
 * What a mirror may be off by, 1/256 code. Rounding of the stored and transformed normals turns them by at most 1.2e-4,
 * so that r turns by twice that. In the square, u and v then move by at most sqrt(5) as much in all (most at the
 * octahedron's corners, where r has one component), which is side / 2 texels to a unit; the place in a cell is rounded
 * to 2^-13 of a texel in each. Between centres E changes by at most the difference of neighbours a texel.
 */
uint32_t glint_mirror_error_q8(const glint_environment *map, const glint_colour *reflectance);

#endif
