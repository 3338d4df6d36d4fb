/* SPDX-License-Identifier: MIT */
/*
 * Attenuation and cones in float, see test_reach.h.
 */
#include "lighting/reach_float.h"

#include "tests/unit/numeric.h"

#define ATTENUATION_ERROR 5e-7L
#define CONE_ERROR 1e-5L
#define POSITION_ERROR 2e-7L
#define FACTOR_ONE 1

static void surface_at(surface *at, long double point[3])
{
    const float depth = (float)exp2l(6 * random_unit());
    memset(at, 0, sizeof *at);
    at->inverse = 1.0f / depth;
    for (int k = 0; k < 3; k++) {
        at->ray[k] = k == 2 ? 1.0f : (float)ldexpl(random_any_size(24), -23); /* a ray is at least 1 long */
        point[k] = (long double)at->ray[k] / (long double)at->inverse;
    }
}

#include "tests/unit/test_reach.h"
