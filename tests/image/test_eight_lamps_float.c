/* SPDX-License-Identifier: MIT */
/*
 * Lamps out of reach cost nothing, in the float backend: see test_eight_lamps.h.
 */
#include "tests/image/counted_terms.h"

struct shade_state;
static void own_triangle(struct shade_state *shade);
#define GLINT_OBSERVE(shade, promise) own_triangle(shade)

#include "backend/float.c" /* it takes the place of the library's own copy */

#define EIGHT_LAMPS_BACKEND FRAME_FLOAT
#include "tests/image/test_eight_lamps.h"
