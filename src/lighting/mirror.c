/* SPDX-License-Identifier: MIT */
#include "lighting/mirror.h"

/* 2.4e-4 sqrt(5) / 2 for each texel of the side, and 2 2^-13; Q24 */
#define TEXELS_OF_SIDE_Q24 4502
#define TEXELS_OF_ROUNDING_Q24 4096

uint32_t glint_mirror_error_q8(const glint_environment *map, const glint_colour *reflectance)
{
    const uint32_t steepest = map->steepest ? map->steepest : 255;
    const int16_t r = reflectance->r_q14, g = reflectance->g_q14, b = reflectance->b_q14;
    const uint32_t strongest_q14 = (uint32_t)(r > g ? (r > b ? r : b) : (g > b ? g : b));
    const uint32_t texels_q24 = (uint32_t)map->side * TEXELS_OF_SIDE_Q24 + TEXELS_OF_ROUNDING_Q24; /* < 2^20 */
    const uint32_t codes_q24 = texels_q24 * steepest;                                              /* < 2^28 */
    return (((codes_q24 >> 14) + 1) * strongest_q14 >> 16) + 1;
}
