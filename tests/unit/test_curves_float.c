/* SPDX-License-Identifier: MIT */
/*
 * Polynomials through points of a triangle in float.
 */
#include "tests/unit/numeric.h"

#include "lighting/gloss_float.h"

#define UNIT_ONE 1.0L
#define INVERSE_ONE 1.0L
#define RAY_ONE 1.0L
#define STEPS_ONE 1.0L
#define COSINE_ONE 1.0L
#define FIELD_VALUE(value) ((long double)(value))

/* Steps round: 64 of them, the first differences by 2^-24 of what their terms come to. */
#define ASSERT_STEPPED(a, b, way)                                                                                      \
    assert_true(fabsl((long double)(a)->value - (long double)(b)->value) <= ldexpl(1, -18) * (way))

/* Budgets are reached by this part of them at least. */
#define BUDGET_BITES 0.1L

/* Over a way of 1 and what barycentric coordinates run from the anchor, a quadratic's terms are at most its square, of
 * values up to 1, and each is rounded a few times. */
#define QUADRATIC_MOST 1.0L
#define QUADRATIC_APART 0.125L
#define QUADRATIC_ERROR(up, away, way) (ldexpl(1, -22) * (way) * (way) + 0 * (up) * (away))

#define INVERSE_ERROR                                                                                                  \
    1.4e-6L /* half a unit of the chord, 2^-17 of |2 M|^2, which is 2 at least; a fourth of that at most */
#define MIDDLE_MOST 2.0L
#define MIDDLE_UNIT ldexpl(1, -24)
#define MIDDLE_ERROR 5 /* of values up to 2: three roundings */

#define CUBIC_UP 1
#define CENTRE_OFFSET(offset) ((int32_t)((offset)*4096))
#define CUBIC_REACH 1000
#define CUBIC_APART 0.1L
#define GAP_VALUE_MOST 8
#define GAP_VALUE_ONE(down) (1.0L + 0 * (down))
#define CUBIC_UNIT(down) (0.0L * (down))
#define GAP_CUT(down) (0 * (down))
#define GAP_VALUE_ERROR 1e-6L /* some ten roundings of numbers up to 4 */
#define OVER_M_ONE 1
#define PART_ONE 1
#define PART_OF(x) ((float)(x) + 1e-7f)
#define GAP_VALUE_SCALE 0
#define INVERSE_SQUARE_ERROR 6e-7L                    /* twice the root's 1e-7, and the sum before it */
#define GAP_END_ERROR(part) (exp2l(-17) + 0 * (part)) /* half a place in 256 cells */
#define GAP_ERROR 4e-7L                               /* roundings, and the value's and the inverse's own */
#define GAP_WITHIN(value, scale) gap_within(value, scale)
#define GAP_PLACE(value, inverse, scale) gap_place_of(gap_part_of(value, scale), (float)(inverse), scale)
#define GAP_INVERSE(g, inverse) ((long double)gap_inverse((float)(g), &(inverse)->rest))

#define ROW_UNIT ldexpl(1, -26)
#define ROW_SLACK 1e-5L
#define ROW_SET(to, number) ((to) = (float)(number))

enum { CUBIC_CLASSES = 1 };
static const char *const cubic_class_name[] = {"any gradients"};

static inline int cubic_class(int up)
{
    return up < 0 ? -1 : 0;
}

/* Like a quadratic's, by the cube of the way. */
static inline long double cubic_budget(int class, long double n, long double way, const gap_value value[LATTICE_POINTS])
{
    long double most = 0;
    (void)class;
    (void)n;
    for (int i = 0; i < LATTICE_POINTS; i++) {
        most = worse(most, fabsl((long double)value[i]));
    }
    /* third differences are sums of up to 216 of the values, and a twelfth of them goes into the value at the centre:
     * 18 2^-24, at gradients of 1 a pixel, beside 2^-21 for the rest */
    return ldexpl(1, -20) * way * way * way * most;
}

static inline void set_ray_fraction(pixel_rays *rays)
{
    (void)rays;
}

static inline long double corner_ray(const gloss_corners *corners, int i, int k)
{
    return (long double)corners->ray[i][k];
}

static inline long double corner_m(const gloss_corners *corners, int i, int k)
{
    return (long double)corners->normal[i][k];
}

/* M at a point that is so many thirds of each corner. */
static inline void gloss_m(const gloss_corners *corners, const uint8_t point[3], long double m[3])
{
    for (int k = 0; k < 3; k++) {
        m[k] = 0;
        for (int i = 0; i < 3; i++) {
            m[k] += point[i] / 3.0L * (long double)corners->normal[i][k];
        }
    }
}

static inline int random_down(long double gap)
{
    (void)gap;
    return 0;
}

static inline bool bend_is_counted(const cubic_row *row, uint16_t count)
{
    (void)row;
    return count > 0;
}

#include "tests/unit/test_curves_gaps.h"

int main(void)
{
    const struct CMUnitTest tests[] = {CURVE_TESTS, GAP_TESTS};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
