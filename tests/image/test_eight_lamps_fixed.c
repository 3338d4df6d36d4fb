/* SPDX-License-Identifier: MIT */
/*
 * Lamps out of reach cost nothing, in the fixed backend: see test_eight_lamps.h.
 */
#include "tests/image/counted_terms.h"

struct shade_state;
static void own_triangle(struct shade_state *shade);
#define GLINT_OBSERVE(shade, promise) own_triangle(shade)

#include "backend/fixed.c" /* it takes the place of the library's own copy */

#define EIGHT_LAMPS_BACKEND FRAME_FIXED
#include "tests/image/test_eight_lamps.h"
