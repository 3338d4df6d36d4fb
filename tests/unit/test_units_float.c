/* SPDX-License-Identifier: MIT */
/*
 * Unit vectors along a row in float.
 */
#include <stddef.h>
#include <stdint.h>

#include <math.h>

#include "raster/units_float.h"

#define VECTOR_ONE 1.0L
#define VECTOR_SCALE UNIT_SCALE_OF_NORMALS
#define UNIT_ONE 1.0L
#define SHORTENED 1.0L
#define GAP_SHIFT 0.0L

/* Budgets: steps add up over a row. */
#define UNIT_ERROR 1.2e-6L
#define BEYOND_ERROR 2e-5L /* of 0.01 of the length that the steps have been rounded for */
#define GAP_ERROR 1e-4L    /* a gap is cut to Q28: of 2^-28 that is sqrt(2) 2^-14 of the angle */
#define FINE_ERROR 4e-5L   /* of the angle, which glint_bound_fine() has too */
#define FINE_ERROR_OF(gap, apart) (fabsl((gap) - (apart) * (apart) / 2) / worse(apart, ldexpl(1, -12)))

static inline int round_to_edge(void)
{
    return 0;
}

static inline void set_component(unit_row *row, int k, long double value, long double step)
{
    row->value[k] = (float)value;
    row->step[k] = (float)step;
}

static inline void get_component(const unit_row *row, int k, long double *value, long double *step)
{
    *value = (long double)row->value[k];
    *step = (long double)row->step[k];
}

#include "tests/unit/test_units.h"

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(units_along_a_row),
        numeric_test(gaps_of_units_are_of_the_angle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
