/* SPDX-License-Identifier: MIT */
/*
 * The display: its size, its pixel format, and how finished bands of pixels reach it.
 */
#ifndef GLINT_DISPLAY_H
#define GLINT_DISPLAY_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Pixel formats. Rows are packed left to right, top to bottom. */
enum {
    GLINT_RGB888 = 0,         /* 3 bytes: red, green, blue */
    GLINT_RGB565 = 1,         /* uint16 in the processor's byte order: red in bits 15..11, green 10..5, blue 4..0 */
    GLINT_RGB565_SWAPPED = 2, /* the same with the bytes of each pixel swapped against the processor's order: on a
                               * little-endian processor the high byte first, as SPI panels want it */
    GLINT_GREY8 = 3,          /* 1 byte of luma */
    GLINT_GREY4 = 4,          /* 2 pixels a byte of luma, the left one in bits 7..4; a row starts on a byte */
    GLINT_MONO_PAGES = 5      /* 1 bit a pixel: a byte holds 8 pixels of one column, the topmost in bit 0; bytes left to
                               * right, then the next page of 8 rows (the order of the SSD1306) */
};
/* Luma: Y = (77 R + 150 G + 29 B) / 256, ITU-R BT.601 weights rounded to a sum of exactly 256, on display codes. */

enum {
    GLINT_DITHER_NONE = 0, /* nearest level */
    GLINT_DITHER_BAYER = 1 /* 8x8 ordered dither keyed to the display's x and y; 0 and 1 stay pure */
};

/* Counts transfers under way. Zero it before its first use, then leave it to the library and glint_flush_done(). */
typedef struct glint_transfers {
    volatile uint8_t started;  /* written by the library only */
    volatile uint8_t finished; /* written by glint_flush_done() only */
} glint_transfers;

/* A band of finished pixels: rows y_px .. y_px + height_px - 1 of the display, over its whole width. */
typedef struct glint_band {
    const void *pixels;
    uint32_t bytes;        /* of the band: rows (pages) x stride_bytes */
    uint32_t stride_bytes; /* from one row (page) to the next */
    uint16_t y_px, width_px, height_px;
    bool last; /* the frame's, or the area's, last band */
} glint_band;

/*
 * Sends a band to the display; returns 0, or an error of your own that ends the rendering and is returned unchanged
 * (the transfer then counts as not started: do not tell its end). With `transfers` NULL in the display, the pixels may
 * be overwritten when it returns. Otherwise it may only start the transfer: the pixels stay as they are until
 * glint_flush_done() has been called once for this band. They are counted, not named: transfers must end in the order
 * in which they began.
 */
typedef int (*glint_flush)(void *context, const glint_band *band);

typedef struct glint_display {
    uint16_t width_px, height_px; /* 1..GLINT_MAX_SIZE_PX */
    uint16_t band_px;             /* rows in a band; 0 or more than the height: the whole frame in one band */
    uint8_t format;               /* GLINT_RGB888 ... */
    uint8_t dither;               /* GLINT_DITHER_NONE ... */
    uint8_t buffer_count;         /* 1 (0 means 1), or 2: one is drawn while the other is sent; needs `transfers` */
    uint32_t stride_bytes;        /* from a row (page) to the next in memory; 0: rows without gap; at most
                                   * 0xfffff; even for 16-bit pixels */
    glint_flush flush;
    void *context;                      /* handed to `flush` and `wait` */
    glint_transfers *transfers;         /* NULL: `flush` returns when the pixels have been taken */
    uint16_t area_y_px, area_height_px; /* a partial update: only these rows of the picture are drawn and flushed, in
                                         * bands that begin with the first of them; their bits are those of the whole
                                         * picture. Height 0: all of it. For GLINT_MONO_PAGES whole pages, or up to the
                                         * display's last row */
    void (*wait)(void *context); /* called over and over while a buffer is awaited (sleep, yield ...); may be NULL */
} glint_display;

/* Tells that a transfer has ended. May be called from an interrupt, or from within `flush`. */
void glint_flush_done(glint_transfers *transfers);

/* Bytes of one row of pixels (of one page of 8 rows for GLINT_MONO_PAGES) without gap; 0 for an unknown format. */
uint32_t glint_row_bytes(uint8_t format, uint16_t width_px);

#ifdef __cplusplus
}
#endif

#endif
