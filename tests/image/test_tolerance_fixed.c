/* SPDX-License-Identifier: MIT */
/*
 * The fixed backend holds its tolerance, see test_tolerance.h.
 */
#include <stdint.h>

struct shade_state;
static void observe_triangle(struct shade_state *shade, uint16_t promise_q8);
#define GLINT_OBSERVE(shade, promise) observe_triangle(shade, promise)

#include "backend/fixed.c" /* it takes the place of the library's own copy */

#define TOLERANCE_BACKEND FRAME_FIXED
#include "tests/image/test_tolerance_main.h"
