/* SPDX-License-Identifier: MIT */
/*
 * Reads the pixel formats of <glint/display.h> back to 8-bit RGB, so that a picture shows what the display shows. A
 * component of n bits shows round(v * 255 / (2^n - 1)): none is black, all ones are white.
 */
#include "panel.h"

#include <stddef.h>
#include <string.h>

static uint8_t expand(unsigned value, unsigned most)
{
    return (uint8_t)((value * 255 + most / 2) / most);
}

static void show_565(unsigned pixel, uint8_t *rgb)
{
    rgb[0] = expand(pixel >> 11 & 31, 31);
    rgb[1] = expand(pixel >> 5 & 63, 63);
    rgb[2] = expand(pixel & 31, 31);
}

/* Pixel x of a row, or pixel (x, y) of a page in GLINT_MONO_PAGES. */
static void show_pixel(uint8_t format, const uint8_t *row, unsigned x, unsigned y, uint8_t *rgb)
{
    uint16_t pixel = 0;
    switch (format) {
    case GLINT_RGB888:
        memcpy(rgb, row + (size_t)x * 3, 3);
        break;
    case GLINT_RGB565:
        memcpy(&pixel, row + (size_t)x * 2, 2);
        show_565(pixel, rgb);
        break;
    case GLINT_RGB565_SWAPPED:
        memcpy(&pixel, row + (size_t)x * 2, 2);
        show_565((uint16_t)(pixel << 8 | pixel >> 8), rgb);
        break;
    case GLINT_GREY8:
        memset(rgb, row[x], 3);
        break;
    case GLINT_GREY4:
        memset(rgb, expand((unsigned)row[x / 2] >> (x % 2 == 0 ? 4 : 0) & 15, 15), 3);
        break;
    default:
        memset(rgb, expand((unsigned)row[x] >> y % 8 & 1, 1), 3);
        break;
    }
}

static void show_band(panel *p, const glint_band *band)
{
    const unsigned rows_in_step = p->format == GLINT_MONO_PAGES ? 8 : 1;
    for (unsigned y = 0; y < band->height_px; y++) {
        const uint8_t *row = (const uint8_t *)band->pixels + (size_t)(y / rows_in_step) * band->stride_bytes;
        uint8_t *rgb = p->rgb + ((size_t)band->y_px + y) * p->width_px * 3;
        for (unsigned x = 0; x < band->width_px; x++) {
            show_pixel(p->format, row, x, y, rgb + (size_t)x * 3);
        }
    }
}

static int fits(const panel *p, const glint_band *band)
{
    return band->width_px == p->width_px && band->y_px + (uint32_t)band->height_px <= p->height_px;
}

static int take_at_once(void *context, const glint_band *band)
{
    panel *p = context;
    if (!fits(p, band)) {
        return PANEL_ERROR_BAND;
    }
    show_band(p, band);
    return 0;
}

static void take_oldest(void *context)
{
    panel *p = context;
    if (p->pending_count > 0) {
        show_band(p, &p->pending[0]);
        p->pending_count--;
        memmove(&p->pending[0], &p->pending[1], (size_t)p->pending_count * sizeof p->pending[0]);
        glint_flush_done(&p->transfers);
    }
}

static int take_later(void *context, const glint_band *band)
{
    panel *p = context;
    if (!fits(p, band) || p->pending_count == PANEL_MAX_PENDING) {
        return PANEL_ERROR_BAND;
    }
    p->pending[p->pending_count++] = *band;
    return 0;
}

glint_display panel_display(panel *p, uint16_t band_px, uint8_t dither, uint8_t buffer_count)
{
    return (glint_display){
        .width_px = p->width_px,
        .height_px = p->height_px,
        .band_px = band_px,
        .format = p->format,
        .dither = dither,
        .buffer_count = buffer_count,
        .flush = buffer_count == 2 ? take_later : take_at_once,
        .context = p,
        .transfers = buffer_count == 2 ? &p->transfers : NULL,
        .wait = buffer_count == 2 ? take_oldest : NULL,
    };
}

void panel_finish(panel *p)
{
    while (p->pending_count > 0) {
        take_oldest(p);
    }
}
