/* SPDX-License-Identifier: MIT */
/*
 * Pixels of a see-through surface: what it shows itself, and a share of what the band of pixels shows already.
 *
 * The pixel behind is read back from its format, exactly as it was packed: packing what was read gives the same pixel,
 * with any dither. The mixed colour is packed again, so each layer rounds once more: to half a code in RGB888 and
 * GREY8, to half a step in RGB565 and GREY4, to black or white in GLINT_MONO_PAGES.
 *
 * With dither the threshold of a layer is not that of the pixels behind: of the 6 bits of its rank, the upper two and
 * the middle two are exchanged. Where the pixels behind are dithered by rank r and those of the layer by this, each of
 * the 16 pairs of their quarters comes 4 times, so that over the pattern the mean is about that of the mixed colours;
 * with the same threshold twice, what the dither had set would stay set. With one bit a pixel that is a screen door:
 * the share of pixels that show what is behind is about t. The mean errs by at most 1/7 of a step
 * (tests/unit/test_layers.c), for one layer.
 */
#ifndef GLINT_DISPLAY_LAYER_H
#define GLINT_DISPLAY_LAYER_H

#include "display/pack.h"

/* The colour that a pixel of the band shows. Error at most 0.503 ulp of Q15. */
glint_shade glint_unpack(const glint_target *target, int16_t x, int16_t y);

/* Packs min(1, shade + through behind) into `count` pixels from (x, y) to the right; `through` in Q15, 0..32768, one a
 * pixel. Error before packing 1 ulp of Q15. */
void glint_pack_layer(const glint_target *target, int16_t x, int16_t y, const glint_shade *shade,
                      const uint16_t *through_q15, uint16_t count);

#endif
