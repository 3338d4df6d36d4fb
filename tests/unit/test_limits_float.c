/* SPDX-License-Identifier: MIT */
/*
 * The float backend at its limits: see backend_limits.h; and directions that are not finite.
 */
#include "backend/float.c" /* for its static functions; it takes the place of the library's own copy */

#include <math.h>

#include "tests/unit/backend_limits.h"

/* No direction to a light and no half vector come of numbers that are not finite, so no term of the light does. */
static void test_directions_that_are_not_finite(void **state)
{
    static const float bad[3] = {INFINITY, -INFINITY, NAN};
    static const real camera[3] = {0, 0, 1}, ray[3] = {0, 0, -1};
    (void)state;
    for (int n = 0; n < 9; n++) {
        light_place light = {{3, 4, 12}};
        surface at = {{0, 0, 1}, {0, 0, -1}, 0.5f};
        real v[3], out[3] = {7, 7, 7}, half[3], s[3] = {0.6f, 0, 0.8f};
        assert_true(light_towards(&light, &at, v, out));
        assert_true(half_vector(s, camera, s, ray, half));
        out[0] = half[0] = 7;
        s[n / 3] = light.v[n / 3] = bad[n % 3];
        assert_false(light_towards(&light, &at, v, out));
        assert_false(half_vector(s, camera, s, ray, half));
        assert_true(out[0] == 7 && half[0] == 7);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {LIMITS_TESTS, cmocka_unit_test(test_directions_that_are_not_finite)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
