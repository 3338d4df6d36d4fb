/* SPDX-License-Identifier: MIT */
/*
 * From shaded colours to the display's pixel format, with ordered dither.
 *
 * A colour of 0..1 becomes level floor(colour levels + threshold): threshold 1/2 rounds to nearest; with dither it is
 * (2 rank + 1) / 128, rank 0..63 by the pixel's place in an 8x8 pattern fixed to the display (B. E. Bayer, "An optimum
 * method for two-level rendition of continuous-tone pictures", ICC 1973). As 0 < threshold < 1, colours 0 and 1 stay
 * pure.
 */
#ifndef GLINT_DISPLAY_PACK_H
#define GLINT_DISPLAY_PACK_H

#include <stdbool.h>
#include <stdint.h>

/* A shaded colour: each channel Q15, 0..32768. */
typedef struct glint_shade {
    uint16_t r_q15, g_q15, b_q15;
} glint_shade;

/* A band of pixels being drawn. */
typedef struct glint_target {
    uint8_t *pixels;
    uint32_t stride_bytes;
    int16_t y_first; /* display row of the band's first row */
    uint8_t format, dither;
} glint_target;

/* Writes `count` pixels from (x, y) to the right; y is a display row within the band. */
void glint_pack(const glint_target *target, int16_t x, int16_t y, const glint_shade *shade, uint16_t count);

/* The same with one colour. */
void glint_pack_fill(const glint_target *target, int16_t x, int16_t y, const glint_shade *shade, uint16_t count);

/*
 * Where a colour gives the same 16 bits at every pixel (RGB565 without dither), spans may write them themselves.
 */
bool glint_pack_solid(const glint_target *target);
uint16_t glint_pack_pixel(const glint_target *target, const glint_shade *shade);
/* The same of `count` colours in equal steps, Q27: channels are rounded to Q15, and 1 at most. */
void glint_pack_steps(const glint_target *target, const uint32_t colour_q27[3], const uint32_t step_q27[3],
                      uint16_t *pixel, uint16_t count);
uint16_t *glint_pack_at(const glint_target *target, int16_t x, int16_t y);

/* Fills `rows` whole rows of `width` pixels with one colour. */
void glint_pack_clear(const glint_target *target, uint16_t width, uint16_t rows, const glint_shade *shade);

/* Sets `count` words. */
void glint_fill_words(uint32_t *to, uint32_t word, uint32_t count);

#endif
