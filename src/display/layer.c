/* SPDX-License-Identifier: MIT */
#include "display/layer.h"

#include <stddef.h>

#include <glint/display.h>

#include "number/integer.h"
#include "number/tables.h"

/* level / greatest in Q15, rounded to nearest, for greatest = 15, 31, 63, 255: 2^15 / greatest as a multiple of
 * 2^-down. Error at most 0.503 ulp. */
static uint16_t level_q15(uint32_t level, uint32_t factor, int down)
{
    return (uint16_t)((level * factor + ((uint32_t)1 << (down - 1))) >> down);
}

static uint16_t from_u8(uint8_t level)
{
    return level_q15(level, 65793, 9); /* 128.502 */
}

static uint16_t from_u6(uint32_t level)
{
    return level_q15(level, 1065220, 11); /* 520.127 */
}

static uint16_t from_u5(uint32_t level)
{
    return level_q15(level, 4329604, 12); /* 1057.032 */
}

static glint_shade grey(uint16_t q15)
{
    const glint_shade shade = {q15, q15, q15};
    return shade;
}

glint_shade glint_unpack(const glint_target *target, int16_t x, int16_t y)
{
    const uint8_t *const row = glint_pack_row(target, y);
    switch (target->format) {
    case GLINT_RGB888: {
        const uint8_t *pixel = row + (size_t)x * 3;
        const glint_shade shade = {from_u8(pixel[0]), from_u8(pixel[1]), from_u8(pixel[2])};
        return shade;
    }
    case GLINT_RGB565:
    case GLINT_RGB565_SWAPPED: {
        const uint16_t stored = ((const uint16_t *)(const void *)row)[x];
        const uint32_t pixel = target->format == GLINT_RGB565 ? stored : ((uint32_t)stored << 8 | stored >> 8) & 0xffff;
        const glint_shade shade = {from_u5(pixel >> 11), from_u6(pixel >> 5 & 63), from_u5(pixel & 31)};
        return shade;
    }
    case GLINT_GREY8:
        return grey(from_u8(row[x]));
    case GLINT_GREY4:
        return grey(level_q15(x & 1 ? row[x >> 1] & 15u : row[x >> 1] >> 4, 8947849, 12)); /* 2184.533 */
    default:                                                                               /* GLINT_MONO_PAGES */
        return grey((uint16_t)(row[x] >> (y & 7) & 1 ? 32768 : 0));
    }
}

static uint32_t layer_threshold_q15(const glint_target *target, int16_t x, int16_t y)
{
    if (target->dither == GLINT_DITHER_NONE) {
        return 1 << 14;
    }
    const uint32_t rank = flash_u8(&glint_bayer_rank[(y & 7) * 8 + (x & 7)]);
    const uint32_t exchanged = (rank & 12) << 2 | rank >> 4 << 2 | (rank & 3);
    return exchanged * 512 + 256;
}

static uint16_t over(uint16_t own, uint16_t behind, uint32_t through_q15)
{
    const uint32_t sum = own + ((behind * through_q15 + (1 << 14)) >> 15); /* <= 2^16 */
    return (uint16_t)(sum < 32768 ? sum : 32768);
}

void glint_pack_layer(const glint_target *target, int16_t x, int16_t y, const glint_shade *shade,
                      const uint16_t *through_q15, uint16_t count)
{
    for (uint16_t i = 0; i < count; i++) {
        const int16_t at = (int16_t)(x + (int16_t)i);
        const glint_shade behind = glint_unpack(target, at, y);
        const glint_shade mixed = {over(shade[i].r_q15, behind.r_q15, through_q15[i]),
                                   over(shade[i].g_q15, behind.g_q15, through_q15[i]),
                                   over(shade[i].b_q15, behind.b_q15, through_q15[i])};
        glint_pack_thresholded(target, at, y, &mixed, layer_threshold_q15(target, at, y));
    }
}
