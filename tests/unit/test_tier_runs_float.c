/* SPDX-License-Identifier: MIT */
/*
 * Runs of pixels of the float backend, see test_tier_runs.h.
 */
#include <stdint.h>

struct shade_state;
static void observe_triangle(struct shade_state *shade);
#define GLINT_OBSERVE(shade, promise) observe_triangle(shade)

#include "backend/float.c" /* it takes the place of the library's own copy */

#define RUNS_BACKEND FRAME_FLOAT
#include "tests/unit/test_tier_runs.h"
