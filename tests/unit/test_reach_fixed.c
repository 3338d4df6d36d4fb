/* SPDX-License-Identifier: MIT */
/*
 * Attenuation and cones in fixed point, see test_reach.h.
 */
#include "lighting/reach_fixed.h"

#include "tests/unit/numeric.h"

#define ATTENUATION_ERROR 8e-5L
#define CONE_ERROR 5e-5L
#define POSITION_ERROR 2e-8L /* of a position, relative: of two products and their sum, 2^-27 each */
#define FACTOR_ONE 32768

static void surface_at(surface *at, long double point[3])
{
    const long double depth = exp2l(6 * random_unit());
    memset(at, 0, sizeof *at);
    at->ray_fraction = 27;
    /* as surface_set_inverse() has it: brought to 30 bits */
    at->inverse = (int32_t)(GLINT_DEPTH_SPAN / depth);
    const int up = clz32((uint32_t)at->inverse) - 2;
    const long double inverse = (long double)at->inverse / GLINT_DEPTH_SPAN;
    at->inverse <<= up;
    at->inverse_fraction = (int16_t)(30 + up);
    for (int k = 0; k < 3; k++) {
        at->ray[k] = k == 2 ? (int32_t)1 << 27 : random_any_size(28); /* a ray is at least 1 long */
        point[k] = ldexpl(at->ray[k], -27) / inverse;
    }
}

#include "tests/unit/test_reach.h"
