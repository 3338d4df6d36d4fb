/* SPDX-License-Identifier: MIT */
/*
 * Fields over a triangle in float.
 */
#include <stddef.h>
#include <stdint.h>

#include "raster/field_float.h"

#define M_ONE 1.0L
#define DOT_ONE 1.0L
#define DOT_HALF 0.0L
#define LENGTH_ONE 1.0L
#define UNIT_ONE 1.0L
#define GAP_ONE 1.0L

/* Budgets, `away` pixels from the anchor (|dx| + |dy|), over a way of 1 and |M'| times that. */
#define COSINE_ERROR(away, way) (ldexpl(1, -21) * (way))
#define LENGTH_ERROR(away, way) (ldexpl(1, -21) * (way) * (way))
#define NORMAL_ERROR(away) (4e-6L + (away)*2e-8L)
#define RAY_ERROR 2e-6L
#define GAP_ERROR 6e-7L
#define GAP_ROW_ERROR 2e-6L

/* Rays of any length. */
static void random_ray(pixel_rays *rays, long double exact[3], int16_t x, int16_t y);

#include "tests/unit/test_fields.h"

static void random_ray(pixel_rays *rays, long double exact[3], int16_t x, int16_t y)
{
    const long double size = exp2l(20 * random_unit() - 10);
    for (int k = 0; k < 3; k++) {
        rays->v[0][k] = (float)((random_unit() - 0.5L) * size);
        rays->v[1][k] = (float)((random_unit() - 0.5L) * size / 256);
        rays->v[2][k] = (float)((random_unit() - 0.5L) * size / 256);
        exact[k] = scaled(rays->v[0][k], 1) + x * scaled(rays->v[1][k], 1) + y * scaled(rays->v[2][k], 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(fields_keep_their_bound),
        numeric_test(fields_keep_it_on_large_displays),
        numeric_test(rays_are_unit),
        numeric_test(gaps_are_of_the_angle),
        numeric_test(rows_of_gaps_are_quadratic),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
