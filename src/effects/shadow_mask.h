/* SPDX-License-Identifier: MIT */
/*
 * Bits of the pixels that lie in a light's shadow: what four lines enclose is filled row by row. A row takes a step or
 * two for each line, in 32 bits.
 */
#ifndef GLINT_EFFECTS_SHADOW_MASK_H
#define GLINT_EFFECTS_SHADOW_MASK_H

#include "effects/shadow.h"

/* Pixels of a box on the inner side of a line: value + x step_x + y step_y >= 0 at (x, y) from the box's first one;
 * below 2^30 over the box. */
typedef struct glint_shadow_line {
    int32_t value, step_x, step_y;
} glint_shadow_line;

/* Fills what four lines enclose in the band's rows of the box. */
void glint_shadow_fill(const glint_shadows *shadows, uint32_t *mask, const glint_box *box,
                       const glint_shadow_line l[4]);

/* Clears the band's rows of the box, and what shares words with it: no other triangle's bits are needed any more. */
void glint_shadow_clear(const glint_shadows *shadows, uint32_t *mask, const glint_box *box);

#endif
