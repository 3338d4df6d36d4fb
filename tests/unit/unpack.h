/* SPDX-License-Identifier: MIT */
/*
 * Reads single pixels out of a frame in any pixel format, from the words of <glint/display.h> alone, for the tests.
 */
#ifndef GLINT_TESTS_UNIT_UNPACK_H
#define GLINT_TESTS_UNIT_UNPACK_H

#include <stdint.h>
#include <string.h>

#include <glint/display.h>

enum { UNPACK_FORMATS = 6 };

/* Levels of a pixel: red, green, blue; or one of luma. */
typedef struct levels {
    uint8_t count; /* no padding: compared as bytes */
    uint8_t v[3];
} levels;

/* The greatest level, which is 1, of channel k. */
static inline int unpack_greatest(uint8_t format, int k)
{
    switch (format) {
    case GLINT_RGB888:
    case GLINT_GREY8:
        return 255;
    case GLINT_GREY4:
        return 15;
    case GLINT_MONO_PAGES:
        return 1;
    default:
        return k == 1 ? 63 : 31;
    }
}

static inline levels unpack(const uint8_t *pixels, uint32_t stride, uint8_t format, int x, int y)
{
    levels pixel = {1, {0, 0, 0}};
    const uint8_t *const row = pixels + stride * (uint32_t)y;
    switch (format) {
    case GLINT_RGB888:
        pixel.count = 3;
        for (int k = 0; k < 3; k++) {
            pixel.v[k] = row[3 * x + k];
        }
        break;
    case GLINT_RGB565:
    case GLINT_RGB565_SWAPPED: {
        /* which of the two bytes is the upper one, on this processor */
        const uint16_t probe = 0x0100;
        uint8_t first;
        memcpy(&first, &probe, 1);
        const int upper = (first == 1) == (format == GLINT_RGB565) ? 0 : 1;
        const unsigned high = row[2 * x + upper], low = row[2 * x + 1 - upper];
        pixel.count = 3;
        pixel.v[0] = (uint8_t)(high / 8);
        pixel.v[1] = (uint8_t)(high % 8 * 8 + low / 32);
        pixel.v[2] = (uint8_t)(low % 32);
        break;
    }
    case GLINT_GREY8:
        pixel.v[0] = row[x];
        break;
    case GLINT_GREY4:
        pixel.v[0] = (uint8_t)(x % 2 == 0 ? row[x / 2] / 16 : row[x / 2] % 16);
        break;
    default:
        pixel.v[0] = pixels[stride * (uint32_t)(y / 8) + (uint32_t)x] >> (y % 8) & 1;
        break;
    }
    return pixel;
}

#endif
