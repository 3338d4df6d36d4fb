/* SPDX-License-Identifier: MIT */
/*
 * Polynomials through points of a triangle in fixed point.
 */
#include "tests/unit/numeric.h"

#include "lighting/gloss_fixed.h"

#define UNIT_ONE 32768.0L
#define INVERSE_ONE 32768.0L
#define RAY_ONE 268435456.0L
#define STEPS_ONE 536870912.0L /* Q19 of 1024 steps */
#define COSINE_ONE 268435456.0L
#define FIELD_VALUE(value) ((long double)(int32_t)(value))

/* Rows come to the very same value whichever pixel they began at. */
#define ASSERT_STEPPED(a, b, way) assert_true((way) >= 1 && memcmp(a, b, sizeof *(a)) == 0)

/* Budgets are reached by this part of them at least. */
#define BUDGET_BITES 0.1L

/* Quadratics, `away` pixels from the anchor, units: n^2 / 2 + 3 n + 4, and what three products of the second order and
 * two of the first are cut by, before the spare bits of the gradients are taken off. */
#define QUADRATIC_MOST 1073741824.0L
#define QUADRATIC_APART (0.99L * (1 << 27)) /* differences of three of them, times 4, are below 2^31 */
#define QUADRATIC_ERROR(up, away, way)                                                                                 \
    (((away) + 1) * ((away) + 1) * (0.5L + 3 * exp2l(2 - 2 * (up))) + ((away) + 1) * (3 + 2 * exp2l(2 - (up))) +       \
     0 * (way))

#define INVERSE_ERROR 3.6e-5L /* the root's 2^-15.01, and half a unit of the chord */
#define MIDDLE_MOST 536870912.0L
#define MIDDLE_UNIT 1
#define MIDDLE_ERROR 9 /* units: 2 of each product in weights, twice as many by the last, and what is rounded down */

/* Cubics: values, and what the header and lighting/bound.h state. */
#define CUBIC_UP 16
#define CENTRE_OFFSET(offset) (offset)
#define CUBIC_REACH 255
#define CUBIC_APART (1 << 15) /* a sixth is rounded to 16 bits, so third differences do not come to more than 2^18 */
#define GAP_VALUE_MOST 67108864.0L
#define GAP_VALUE_ONE(down) exp2l(28 - (down))
#define CUBIC_UNIT(down) (1 / (GAP_VALUE_ONE(down) * CUBIC_UP))
#define GAP_CUT(down) ((down) > 0 ? 0.5L / GAP_VALUE_ONE(down) : 0) /* what the bits that are dropped cost */
#define GAP_VALUE_ERROR exp2l(-23)
#define OVER_M_ONE 16384
#define PART_ONE 32768
#define over_m over_m_q14 /* the member of gloss_inverse, and the next */
#define part part_q15
#define PART_OF(x) ((uint32_t)((x)*32768) + 1)
#define GAP_VALUE_SCALE 4e-5L
#define INVERSE_SQUARE_ERROR 1e-4L
/* Half of the 15 to 16 bits of a limit, over the least x/m, and half a place in 256 cells. */
#define GAP_END_ERROR(part) ((0.8L + 1.6L * (part)) * exp2l(-15))
#define GAP_ERROR 7e-5L /* 15 bits of m/x, and of g, from 3/4 on */
#define GAP_WITHIN(value, scale) gap_within((uint32_t)(value), scale)
#define GAP_PLACE(value, inverse, scale)                                                                               \
    gap_place_of(gap_part_of((uint32_t)(value), scale), (gap_factor)rintl((inverse)*32768), scale)
#define GAP_INVERSE(g, inverse) (gap_inverse((uint32_t)rintl(g), &(inverse)->rest) / 32768.0L)

#define ROW_UNIT 1
#define ROW_SLACK 0
#define ROW_SET(to, number) ((to) = (uint32_t)(int32_t)(number))

enum { UP_2, UP_3, UP_4, CUBIC_CLASSES };
static const char *const cubic_class_name[] = {"gradients from 1/16 a pixel", "from 1/32", "smaller ones"};

static inline int cubic_class(int up)
{
    return up < 2 ? -1 : up == 2 ? UP_2 : up == 3 ? UP_3 : UP_4;
}

/* Units as glint_bound_cubic() counts them. */
static inline long double cubic_budget(int class, long double n, long double way, const gap_value value[LATTICE_POINTS])
{
    const long double cube = (n + 3) * n * n / 6, square = n * n / 2 + 1;
    (void)value;
    (void)way;
    return 16 + (class == UP_2   ? 13 * cube + 13 * square + 17 * n
                 : class == UP_3 ? 2 * cube + 4 * square + 9 * n
                                 : cube * 3 / 4 + 2 * square + 5 * n);
}

static inline void set_ray_fraction(pixel_rays *rays)
{
    rays->fraction = 28;
}

static inline long double corner_ray(const gloss_corners *corners, int i, int k)
{
    return corners->ray[i][k] / 16384.0L;
}

static inline long double corner_m(const gloss_corners *corners, int i, int k)
{
    return (long double)corners->normal[i][k] * corners->weight_q15[i] / 32768 / UNIT_ONE;
}

/* M at a point that is so many thirds of each corner. */
static inline void gloss_m(const gloss_corners *corners, const uint8_t point[3], long double m[3])
{
    for (int k = 0; k < 3; k++) {
        m[k] = 0;
        for (int i = 0; i < 3; i++) {
            m[k] += point[i] / 3.0L * corner_m(corners, i, k);
        }
    }
}

/* What gloss_values() may have dropped of values up to 4/3 gap. */
static inline int random_down(long double gap)
{
    int down = 0;
    while (4 / 3.0L * gap * GAP_VALUE_ONE(down) >= GAP_VALUE_MOST) {
        down++;
    }
    return down < 4 ? random_between(down, 4) : 4;
}

/* Has a row's second difference few enough bits to be counted? */
static inline bool bend_is_counted(const cubic_row *row, uint16_t count)
{
    const uint32_t first = magnitude32((int32_t)row->bend),
                   last = magnitude32((int32_t)(row->bend + (count - 1u) * 3 * row->third));
    return (first | last) >> (count <= 16 ? 23 : 19) == 0;
}

#include "tests/unit/test_curves_gaps.h"

int main(void)
{
    const struct CMUnitTest tests[] = {CURVE_TESTS, GAP_TESTS};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
