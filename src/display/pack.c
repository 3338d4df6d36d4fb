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

static uint16_t rgb565(uint8_t format, const glint_shade *shade, uint32_t threshold)
{
    const uint32_t pixel = level(shade->r_q15, 31, threshold) << 11 | level(shade->g_q15, 63, threshold) << 5 |
                           level(shade->b_q15, 31, threshold);
    return (uint16_t)(format == GLINT_RGB565 ? pixel : pixel << 8 | pixel >> 8);
}

static bool is_rgb565(const glint_target *target)
{
    return target->format == GLINT_RGB565 || target->format == GLINT_RGB565_SWAPPED;
}

static glint_shade *shades_at(const glint_target *target, int16_t x)
{
    return (glint_shade *)(void *)target->pixels + (x - target->x_first);
}

static void pack_at(const glint_target *target, uint8_t *row, int16_t x, int16_t y, const glint_shade *shade,
                    uint32_t threshold)
{
    switch (target->format) {
    case GLINT_RGB888: {
        uint8_t *pixel = row + (size_t)x * 3;
        pixel[0] = (uint8_t)level(shade->r_q15, 255, threshold);
        pixel[1] = (uint8_t)level(shade->g_q15, 255, threshold);
        pixel[2] = (uint8_t)level(shade->b_q15, 255, threshold);
        break;
    }
    case GLINT_RGB565:
    case GLINT_RGB565_SWAPPED:
        ((uint16_t *)(void *)row)[x] = rgb565(target->format, shade, threshold);
        break;
    case GLINT_GREY8:
        row[x] = (uint8_t)level(luma_q15(shade), 255, threshold);
        break;
    case GLINT_GREY4: {
        uint8_t *pair = row + (x >> 1);
        const uint8_t grey = (uint8_t)level(luma_q15(shade), 15, threshold);
        *pair = (uint8_t)(x & 1 ? (*pair & 0xf0) | grey : (*pair & 0x0f) | grey << 4);
        break;
    }
    case GLINT_SHADES:
        *shades_at(target, x) = *shade;
        break;
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

uint8_t *glint_pack_row(const glint_target *target, int16_t y)
{
    return row_of(target, y);
}

void glint_pack_thresholded(const glint_target *target, int16_t x, int16_t y, const glint_shade *shade,
                            uint32_t threshold_q15)
{
    pack_at(target, row_of(target, y), x, y, shade, threshold_q15);
}

/* `step` to the next pixel's colour: 1, or 0 for one colour. */
static GLINT_SHARED void pack_run(const glint_target *target, int16_t x, int16_t y, const glint_shade *shade, int step,
                                  uint16_t count)
{
    uint8_t *const row = row_of(target, y);
    for (; count > 0; count--) {
        pack_at(target, row, x, y, shade, threshold_q15(target, x, y));
        shade += step;
        x++;
    }
}

void glint_pack(const glint_target *target, int16_t x, int16_t y, const glint_shade *shade, uint16_t count)
{
    if (!GLINT_SHARE_CODE && is_rgb565(target) && target->dither == GLINT_DITHER_NONE) {
        uint16_t *pixel = (uint16_t *)(void *)row_of(target, y) + x;
        for (uint16_t i = 0; i < count; i++) {
            pixel[i] = rgb565(target->format, &shade[i], 1 << 14);
        }
        return;
    }
    if (!GLINT_SHARE_CODE && target->format == GLINT_SHADES) {
        memcpy(shades_at(target, x), shade, count * sizeof *shade);
        return;
    }
    pack_run(target, x, y, shade, 1, count);
}

bool glint_pack_solid(const glint_target *target)
{
    return is_rgb565(target) && target->dither == GLINT_DITHER_NONE;
}

uint16_t glint_pack_pixel(const glint_target *target, const glint_shade *shade)
{
    return rgb565(target->format, shade, 1 << 14);
}

/* Adds one channel of colours in equal steps: level floor(colour greatest + 1/2) 2^shift. */
static void add_channel(uint16_t *pixel, uint16_t count, uint32_t colour_q27, uint32_t step_q27, uint32_t greatest,
                        int shift)
{
    const uint16_t *const end = pixel + count;
    colour_q27 += 1 << 11; /* rounds to Q15 */
    while (pixel != end) {
        const uint32_t q15 = colour_q27 >> 12;
        const uint32_t at_most_1 = q15 > 32768 ? 32768 : q15;
        *pixel = (uint16_t)(*pixel + ((at_most_1 * greatest + (1 << 14)) >> 15 << shift));
        pixel++;
        colour_q27 += step_q27;
    }
}

void glint_pack_steps(const glint_target *target, const uint32_t colour_q27[3], const uint32_t step_q27[3],
                      uint16_t *pixel, uint16_t count)
{
    memset(pixel, 0, count * sizeof *pixel);
    add_channel(pixel, count, colour_q27[0], step_q27[0], 31, 11);
    add_channel(pixel, count, colour_q27[1], step_q27[1], 63, 5);
    add_channel(pixel, count, colour_q27[2], step_q27[2], 31, 0);
    if (target->format == GLINT_RGB565_SWAPPED) {
        for (uint16_t i = 0; i < count; i++) {
            pixel[i] = (uint16_t)((uint16_t)(pixel[i] << 8) | pixel[i] >> 8);
        }
    }
}

uint16_t *glint_pack_at(const glint_target *target, int16_t x, int16_t y)
{
    return (uint16_t *)(void *)row_of(target, y) + x;
}

void glint_pack_fill(const glint_target *target, int16_t x, int16_t y, const glint_shade *shade, uint16_t count)
{
    pack_run(target, x, y, shade, 0, count);
}

void glint_fill_words(uint32_t *to, uint32_t word, uint32_t count)
{
    const uint32_t *const end = to + count;
    for (; GLINT_SHARE_CODE ? to != end : count & 15; count--) {
        *to++ = word;
    }
    while (to != end) {
        to[0] = to[1] = to[2] = to[3] = word;
        to[4] = to[5] = to[6] = to[7] = word;
        to[8] = to[9] = to[10] = to[11] = word;
        to[12] = to[13] = to[14] = to[15] = word;
        to += 16;
    }
}

/* The dither has a period of 8 rows and columns: 8 columns of each row are packed, the rest is copied. */
void glint_pack_clear(const glint_target *target, uint16_t width, uint16_t rows, const glint_shade *shade)
{
    const bool pages = target->format == GLINT_MONO_PAGES;
    const size_t bytes = (size_t)glint_row_bytes(target->format, width);
    const size_t period = (size_t)glint_row_bytes(target->format, 8);
    const uint16_t first = width < 8 ? width : 8;
    if (!GLINT_SHARE_CODE && glint_pack_solid(target) && (target->stride_bytes & 3) == 0) {
        const uint32_t pixel = glint_pack_pixel(target, shade);
        if (target->stride_bytes == bytes) { /* nothing between rows */
            glint_fill_words((uint32_t *)(void *)target->pixels, pixel << 16 | pixel, (uint32_t)bytes / 4 * rows);
            return;
        }
        for (uint16_t y = 0; y < rows; y++) {
            uint8_t *row = target->pixels + (size_t)y * (size_t)target->stride_bytes;
            glint_fill_words((uint32_t *)(void *)row, pixel << 16 | pixel, (uint32_t)width / 2);
            ((uint16_t *)(void *)row)[width - 1] = (uint16_t)pixel;
        }
        return;
    }
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
        if (first < 8 && !pages) {
            memset(row, 0, bytes); /* the half byte that an odd number of 4-bit pixels leaves */
        }
        glint_pack_fill(target, 0, display_y, shade, first);
        if (pages && (display_y & 7) != 7 && y + 1 != rows) {
            continue; /* the page is copied when it is complete */
        }
        for (size_t done = period; done < bytes; done *= 2) {
            memcpy(row + done, row, done < bytes - done ? done : bytes - done);
        }
    }
}
