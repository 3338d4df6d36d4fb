/* SPDX-License-Identifier: MIT */
#include "display/pack.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include <glint/display.h>

#include "number/integer.h"
#include "number/tables.h"

uint32_t glint_row_bytes(uint8_t format, uint16_t width_px)
{
    switch (format) {
    case GLINT_RGB888:
        return (uint32_t)width_px * 3;
    case GLINT_RGB565:
    case GLINT_RGB565_SWAPPED:
        return (uint32_t)width_px * 2;
    case GLINT_GREY8:
    case GLINT_MONO_PAGES:
        return width_px;
    case GLINT_GREY4:
        return ((uint32_t)width_px + 1) / 2;
    default:
        return 0;
    }
}

static uint32_t level(uint32_t value_q15, uint32_t greatest, uint32_t threshold_q15)
{
    GLINT_TRACE("level product", value_q15 * greatest + threshold_q15);
    return (value_q15 * greatest + threshold_q15) >> 15; /* <= 2^15 255 + 2^15 */
}

/* Luma in Q15 with weights that sum to 256, so that white is 1. */
static uint32_t luma_q15(const glint_shade *shade)
{
    const uint32_t luma =
        ((uint32_t)77 * shade->r_q15 + (uint32_t)150 * shade->g_q15 + (uint32_t)29 * shade->b_q15 + 128) >> 8;
    GLINT_TRACE("luma q15", luma);
    return luma;
}

static uint32_t threshold_q15(const glint_target *target, int16_t x, int16_t y)
{
    if (target->dither == GLINT_DITHER_NONE) {
        return 1 << 14;
    }
    return (uint32_t)flash_u8(&glint_bayer_rank[(y & 7) * 8 + (x & 7)]) * 512 + 256;
}

static uint16_t rgb565(const glint_shade *shade, uint32_t threshold)
{
    return (uint16_t)(level(shade->r_q15, 31, threshold) << 11 | level(shade->g_q15, 63, threshold) << 5 |
                      level(shade->b_q15, 31, threshold));
}

static void pack_pixel(const glint_target *target, uint8_t *row, int16_t x, int16_t y, const glint_shade *shade)
{
    const uint32_t threshold = threshold_q15(target, x, y);
    switch (target->format) {
    case GLINT_RGB888: {
        uint8_t *pixel = row + (size_t)x * 3;
        pixel[0] = (uint8_t)level(shade->r_q15, 255, threshold);
        pixel[1] = (uint8_t)level(shade->g_q15, 255, threshold);
        pixel[2] = (uint8_t)level(shade->b_q15, 255, threshold);
        break;
    }
    case GLINT_RGB565:
    case GLINT_RGB565_SWAPPED: {
        uint16_t pixel = rgb565(shade, threshold);
        if (target->format == GLINT_RGB565_SWAPPED) {
            pixel = (uint16_t)(pixel << 8 | pixel >> 8);
        }
        memcpy(row + (size_t)x * 2, &pixel, sizeof pixel);
        break;
    }
    case GLINT_GREY8:
        row[x] = (uint8_t)level(luma_q15(shade), 255, threshold);
        break;
    case GLINT_GREY4: {
        uint8_t *pair = row + (x >> 1);
        const uint8_t grey = (uint8_t)level(luma_q15(shade), 15, threshold);
        *pair = (uint8_t)(x & 1 ? (*pair & 0xf0) | grey : (*pair & 0x0f) | grey << 4);
        break;
    }
    default: { /* GLINT_MONO_PAGES */
        const uint8_t bit = (uint8_t)(1 << (y & 7));
        row[x] = (uint8_t)(level(luma_q15(shade), 1, threshold) ? row[x] | bit : row[x] & ~bit);
        break;
    }
    }
}

static uint8_t *row_of(const glint_target *target, int16_t y)
{
    uint32_t row = (uint32_t)(y - target->y_first);
    if (target->format == GLINT_MONO_PAGES) {
        row >>= 3; /* bands of this format begin on a page */
    }
    return target->pixels + (size_t)row * (size_t)target->stride_bytes;
}

void glint_pack(const glint_target *target, int16_t x, int16_t y, const glint_shade *shade, uint16_t count)
{
    uint8_t *row = row_of(target, y);
    for (uint16_t i = 0; i < count; i++) {
        pack_pixel(target, row, (int16_t)(x + (int16_t)i), y, &shade[i]);
    }
}

void glint_pack_clear(const glint_target *target, uint16_t width, uint16_t rows, const glint_shade *shade)
{
    const bool pages = target->format == GLINT_MONO_PAGES;
    const size_t bytes = (size_t)glint_row_bytes(target->format, width);
    /* the dither has a period of 8 rows and columns: 8 rows are packed, 8 columns each, and copied */
    const size_t period = (size_t)glint_row_bytes(target->format, 8);
    if (pages) {
        memset(target->pixels, 0,
               (size_t)((rows + 7u) / 8) * (size_t)target->stride_bytes); /* rows below the display's last stay 0 */
    }
    for (uint16_t y = 0; y < rows; y++) {
        const int16_t display_y = (int16_t)(target->y_first + (int16_t)y);
        uint8_t *row = row_of(target, display_y);
        if (y >= 8 && !pages) {
            memcpy(row, row - 8 * (size_t)target->stride_bytes, bytes);
            continue;
        }
        const uint16_t first = width < 8 ? width : 8;
        if (first < 8 && !pages) {
            memset(row, 0, bytes); /* the half byte that an odd number of 4-bit pixels leaves */
        }
        for (uint16_t x = 0; x < first; x++) {
            pack_pixel(target, row, (int16_t)x, display_y, shade);
        }
        if (pages && (display_y & 7) != 7 && y + 1 != rows) {
            continue; /* the page is copied when it is complete */
        }
        for (size_t done = period; done < bytes; done *= 2) {
            memcpy(row + done, row, done < bytes - done ? done : bytes - done);
        }
    }
}
