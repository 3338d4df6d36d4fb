/* SPDX-License-Identifier: MIT */
/*
 * The float vertex stage against a projection in long double.
 */
#include "tests/unit/numeric.h"

#include "geometry/vertex_float.h"

/* Budgets. A row of four products: each factor and each of the sums rounded to 24 bits, over terms as large as the
 * extent times sqrt(3); and the four units of 2^-29 of the fixed-point set-up. */
#define BACKEND_ROUNDING (6 * 1.7320508L / 16777216 + 4 / 536870912.0L)
#define DEPTH_RELATIVE (6 / 16777216.0L) /* depth_near, 1/Z, their product */
#define ORDINARY_STEPS 8.0L              /* half a sub-pixel: a vertex snaps to the neighbouring grid point at most */

#include "tests/unit/geometry_vertices.h"

int main(void)
{
    const struct CMUnitTest tests[] = {numeric_test(vertices_are_where_the_camera_sees_them)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
