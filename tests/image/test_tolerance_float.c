/* SPDX-License-Identifier: MIT */
/*
 * The float backend holds its tolerance, see test_tolerance.h.
 */
#include <stdint.h>

struct shade_state;
static void observe_triangle(struct shade_state *shade, uint16_t promise_q8);
#define GLINT_OBSERVE(shade, promise) observe_triangle(shade, promise)

#include "backend/float.c" /* it takes the place of the library's own copy */

#define TOLERANCE_BACKEND FRAME_FLOAT
#include "tests/image/test_tolerance_main.h"
