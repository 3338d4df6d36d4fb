/* SPDX-License-Identifier: MIT */
/*
 * Mirrors in fixed point, see test_mirror.h.
 */
#include "lighting/mirror_fixed.h"

#include "tests/unit/geometry_world.h"

#define DIRECTION_ERROR 1.1e-7L
#define PLACE_ERROR(side) (2 / 8192.0L) /* texels: half of 2^-12 in each coordinate */
#define CHANNEL_ERROR (1 / 65536.0L)

/* A vector of 16 to 30 bits, as normals and rays come; `v` becomes what it is. */
static void random_real(long double v[3], real out[3])
{
    const int bits = random_between(28, 30);
    for (int k = 0; k < 3; k++) {
        out[k] = (real)lrintl(ldexpl(v[k], bits));
        v[k] = out[k];
    }
}

static void colour_of(const light_mirror *mirror, const real d[3], long double rgb[3])
{
    uint32_t q15[3];
    mirror_colour(mirror, d, q15);
    for (int k = 0; k < 3; k++) {
        assert_true(q15[k] <= 32768);
        rgb[k] = q15[k] / 32768.0L;
    }
}

#include "tests/unit/test_mirror.h"
