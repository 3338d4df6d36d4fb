/* SPDX-License-Identifier: MIT */
/*
 * Fog by depth: how much of its colour is mixed in at a pixel. The formula is that of glint_fog in <glint/scene.h>.
 *
 * With d a pixel's inverse depth, near SPAN / Z (see GLINT_DEPTH_SPAN), which is linear on the screen,
 *
 *     f = (Z - begin) / (end - begin) = A / d - B,    A = near SPAN / (end - begin),    B = begin / (end - begin):
 *
 * one reciprocal a pixel. Both backends keep d in integers, so this is integer arithmetic, compiled once.
 *
 * Scaling: T = end / (end - begin) is at least 1 and below 2^23. A / d is at most T where f is at most 1, and kept with
 * `fraction` bits so that it stays below 2^28. No product is wider than the upper half of 32 x 32 bits.
 *
 * Error of f for the exact d: at most T 2^-26 + 2^-16, and 1.5 units of the last of those `fraction` bits. An error of
 * d counts T / d times. tests/unit/test_fog.c derives both again.
 */
#ifndef GLINT_EFFECTS_FOG_H
#define GLINT_EFFECTS_FOG_H

#include <glint/scene.h>

#include "display/pack.h"
#include "geometry/view.h"

typedef struct glint_fog_state {
    glint_shade colour;
    bool present;                  /* the scene has fog; else nothing else is set */
    uint32_t clear_q30, whole_q30; /* d: from the first on there is no fog, up to the second nothing else */
    glint_scaled a;
    uint32_t b;           /* `fraction` bits */
    uint32_t steepest_q4; /* T, rounded up */
    int8_t fraction;      /* 5..27 */
} glint_fog_state;

void glint_fog_set_up(glint_fog_state *fog, const glint_fog *from, const glint_view *view);

/* f in Q15, 0..32768, at the inverse depth d. */
uint32_t glint_fog_q15(const glint_fog_state *fog, uint32_t d_q30);

/* colour + (fog - colour) f; f Q15, 0..32768. Error 2^-16. */
void glint_fog_mix(glint_shade *shade, const glint_shade *colour, uint32_t f_q15);

/*
 * What fog adds to the error of a pixel's colour, 1/256 code, where d is `least_q30` at least and errs by `error` units
 * of Q30 (below 2^15) and a relative 2^-20, which is what the vertices' places may be off. UINT16_MAX: at least that.
 */
uint16_t glint_fog_error_q8(const glint_fog_state *fog, uint32_t least_q30, uint32_t error);

#endif
