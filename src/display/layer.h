/* SPDX-License-Identifier: MIT */
/*
 * Pixels of a see-through surface: what it shows itself, and a share of what the band of pixels shows already.
 *
 * The pixel behind is read back from its format, exactly as it was packed: packing what was read gives the same pixel,
 * with any dither. The mixed colour is packed again, so each layer rounds once more: to half a code in RGB888 and GREY8,
 * to half a step in RGB565 and GREY4, to black or white in GLINT_MONO_PAGES.
 *
 * With dither the threshold of a layer is not that of the pixels behind: the 6 bits of its rank are taken in reverse.
 * Where the pixels behind are dithered by rank r, those of the layer are dithered by the reverse of r, and the 64 pairs
 * are spread evenly (a Hammersley set: J. M. Hammersley, "Monte Carlo methods for solving multivariable problems",
 * Annals of the New York Academy of Sciences 86(3), 1960), so that the mean over the pattern is that of the mixed
 * colours. With one bit a pixel that is a screen door: the share of pixels that show what is behind is about t.
 */
#ifndef GLINT_DISPLAY_LAYER_H
#define GLINT_DISPLAY_LAYER_H

#include "display/pack.h"

/* The colour that a pixel of the band shows. Error 1/2 ulp of Q15. */
glint_shade glint_unpack(const glint_target *target, int16_t x, int16_t y);

/* Packs min(1, shade + through behind) into `count` pixels from (x, y) to the right; `through` in Q15, 0..32768, one a
 * pixel. Error before packing 1 ulp of Q15. */
void glint_pack_layer(const glint_target *target, int16_t x, int16_t y, const glint_shade *shade,
                      const uint16_t *through_q15, uint16_t count);

#endif
