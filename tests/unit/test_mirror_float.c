/* SPDX-License-Identifier: MIT */
/*
 * Mirrors in float, see test_mirror.h.
 */
#include "lighting/mirror_float.h"

#include "tests/unit/geometry_world.h"

#define DIRECTION_ERROR 6e-7L
#define PLACE_ERROR(side) ((side)*9e-8L) /* texels, in both coordinates */
#define CHANNEL_ERROR 2e-7L

static void random_real(long double v[3], real out[3])
{
    const long double size = exp2l(random_between(-4, 8));
    for (int k = 0; k < 3; k++) {
        out[k] = (float)(v[k] * size);
        v[k] = (long double)out[k];
    }
}

static void colour_of(const light_mirror *mirror, const real d[3], long double rgb[3])
{
    float colour[3];
    mirror_colour(mirror, d, colour);
    for (int k = 0; k < 3; k++) {
        rgb[k] = (long double)colour[k];
    }
}

#include "tests/unit/test_mirror.h"
