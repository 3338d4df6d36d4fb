/* SPDX-License-Identifier: MIT */
/*
 * Unit vectors along a row in fixed point.
 */
#include <stddef.h>
#include <stdint.h>

#include <math.h>

#include "raster/units_fixed.h"

#define VECTOR_ONE 536870912.0L /* Q29: the greatest length */
#define VECTOR_SCALE UNIT_SCALE_OF_NORMALS
#define UNIT_ONE 32768.0L
#define SHORTENED (1 - 1 / 2048.0L)
#define GAP_SHIFT ldexpl(1, -22) /* (2^-11)^2 */

/* Budgets. */
#define UNIT_ERROR 8.5e-5L /* as raster/units_fixed.h states */
#define BEYOND_ERROR UNIT_ERROR
#define GAP_ERROR 3.2e-4L /* as lighting/bound.h states */
#define FINE_ERROR ldexpl(1, -23)
#define FINE_ERROR_OF(gap, apart) fabsl((gap) - (apart) * (apart) / 2)

static inline int round_to_edge(void);
static inline void set_component(unit_row *row, int k, long double value, long double step)
{
    row->value[k] = (uint32_t)(int32_t)rintl(value);
    row->step[k] = (uint32_t)(int32_t)rintl(step);
}

static inline void get_component(const unit_row *row, int k, long double *value, long double *step)
{
    *value = (long double)(int32_t)row->value[k];
    *step = (long double)(int32_t)row->step[k];
}

#include "tests/unit/test_units.h"

/* Lengths just above a half err most. */
static inline int round_to_edge(void)
{
    return (int)(random_u32() & 1);
}

/* The longest corner comes to 2^14..2^15, whatever the vectors' size. */
static void scales_suit_the_corners(void **state)
{
    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        real corner[3][3];
        long double longest = 0;
        const int bits = random_between(17, 29);
        for (int k = 0; k < 3; k++) {
            for (int i = 0; i < 3; i++) {
                corner[k][i] = random_between(-(1 << bits) + 1, (1 << bits) - 1);
            }
        }
        const unit_scale down = unit_scale_of_corners(corner);
        for (int i = 0; i < 3; i++) {
            const long double v[3] = {corner[0][i], corner[1][i], corner[2][i]};
            longest = worse(longest, sqrtl(dot3(v, v)));
        }
        assert_true(ldexpl(longest, -down) < 32768 + 2 && ldexpl(longest, -down) > 16384 - 2);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(units_along_a_row),
        numeric_test(gaps_of_units_are_of_the_angle),
        numeric_test(scales_suit_the_corners),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
