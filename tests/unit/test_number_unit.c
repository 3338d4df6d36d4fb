/* SPDX-License-Identifier: MIT */
/*
 * Unit vectors in fixed point: each bound that number/fixed.h states is measured again. Proofs: docs/proofs.md.
 */
#include "tests/unit/numeric.h"

#include "number/fixed.h"
#include "number/integer.h"
#include "number/tables.h"

/* Budgets, as number/fixed.h states them. */
#if GLINT_SMALL_TABLES
#define UNIT_Q15_ULP 1.22L        /* of Q15, a component */
#define UNIT_Q15_LENGTH_ULP 1.38L /* of Q15 */
#define AXIS_LEAST 32768          /* the component of a vector along an axis */
#define AXIS_MOST 32768
#define ROOT_CELLS_OF_1 8 /* cells of the reciprocal root's table over a range of 1 */
#else
#define UNIT_Q15_ULP 1.58L
#define UNIT_Q15_LENGTH_ULP 1.86L
#define AXIS_LEAST 32767
#define AXIS_MOST 32769
#define ROOT_CELLS_OF_1 64
#endif
#define UNIT_Q14_ULP 0.81L /* of Q14, a component: what was asked for, whatever the tables */
#define UNIT_Q28_ULP 2.65L /* of Q28, a component */
#define UNIT_Q30_ULP 6.0L  /* of Q30, a component */

typedef struct unit_worst {
    long double component_ulp, length_ulp;
} unit_worst;

static void check_unit_q15(const int32_t v[3], unit_worst *worst)
{
    int32_t unit[3], opposite[3], in_place[3];
    long double square = 0, unit_square = 0;
    for (int k = 0; k < 3; k++) {
        square += (long double)v[k] * v[k];
        in_place[k] = v[k];
        opposite[k] = v[k] == INT32_MIN ? INT32_MIN : -v[k];
    }
    if (!glint_unit_q15(v, unit) || !glint_unit_q15(in_place, in_place) || !glint_unit_q15(opposite, opposite)) {
        fail_msg("no unit vector along (%d, %d, %d)", v[0], v[1], v[2]);
    }
    const long double length = sqrtl(square);
    for (int k = 0; k < 3; k++) {
        worst->component_ulp = worse(worst->component_ulp, fabsl((long double)unit[k] - 32768 * (v[k] / length)));
        unit_square += (long double)unit[k] * unit[k];
        assert_int_equal(in_place[k], unit[k]);
        assert_true(v[k] != 0 || unit[k] == 0);
        assert_int_equal(opposite[k], v[k] == INT32_MIN ? unit[k] : -unit[k]);
    }
    worst->length_ulp = worse(worst->length_ulp, fabsl(sqrtl(unit_square) - 32768));
}

/* A vector whose 16-bit components give a sum of squares beside a border of the root's cells. */
static void vector_at_cell_border(int32_t v[3])
{
    const int cell = random_between(ROOT_CELLS_OF_1, 4 * ROOT_CELLS_OF_1), down = random_between(0, 1);
    const double border = 4294967296.0 * cell / ROOT_CELLS_OF_1 / (down ? 4 : 1); /* of |w|^2 */
    double rest = border;
    int32_t w[3];
    for (int k = 0; k < 2; k++) {
        const double greatest = sqrt(rest) < 65535.0 ? sqrt(rest) : 65535.0;
        w[k] = random_between(0, (int32_t)greatest);
        rest -= (double)w[k] * w[k];
    }
    w[2] = (int32_t)(sqrt(rest) < 65533.0 ? sqrt(rest) : 65533.0) + random_between(0, 2);
    const int first = random_between(0, 2), up = random_between(0, 14);
    for (int k = 0; k < 3; k++) {
        v[(k + first) % 3] = (random_u32() & 1 ? -1 : 1) * (int32_t)((uint32_t)w[k] << up);
    }
}

static void unit_q15_keeps_its_bound(void **state)
{
    static const int32_t special[12] = {0,     1,     -1,     2,         3,         32767,
                                        32768, 65535, -65536, INT32_MAX, INT32_MIN, INT32_MIN + 1};
    const int32_t zero[3] = {0, 0, 0};
    int32_t untouched[3] = {7, 8, 9};
    unit_worst worst = {0, 0};
    (void)state;
    assert_false(glint_unit_q15(zero, untouched));
    assert_true(untouched[0] == 7 && untouched[1] == 8 && untouched[2] == 9);
    for (int i = 1; i < 12 * 12 * 12; i++) {
        const int32_t v[3] = {special[i % 12], special[i / 12 % 12], special[i / 144]};
        check_unit_q15(v, &worst);
    }
    for (long round = 0; round < 10000000; round++) {
        int32_t v[3];
        switch (round % 4) {
        case 0: /* all sizes */
            v[0] = random_any_size(31), v[1] = random_any_size(31), v[2] = random_any_size(31);
            break;
        case 1: /* like sizes */
            v[0] = (int32_t)random_u32(), v[1] = (int32_t)random_u32(), v[2] = (int32_t)random_u32();
            break;
        case 2: /* equal components */
            v[0] = random_any_size(31), v[1] = random_u32() & 1 ? v[0] : -v[0];
            v[2] = round & 4 ? v[0] : random_any_size(31);
            break;
        default:
            vector_at_cell_border(v);
        }
        if (v[0] || v[1] || v[2]) {
            check_unit_q15(v, &worst);
        }
    }
    expect_bound("glint_unit_q15, ulp of Q15", worst.component_ulp, UNIT_Q15_ULP);
    expect_at_most("glint_unit_q15, length, ulp of Q15", worst.length_ulp, UNIT_Q15_LENGTH_ULP);
}

/* Axes: every leading 16 bits, and the least and the greatest of what is dropped. */
static void unit_q15_along_an_axis_stays_on_it(void **state)
{
    long double worst = 0;
    int least = 32768, most = 0;
    (void)state;
    for (uint32_t w = 1; w < 1 << 16; w++) {
        const uint32_t part[4] = {w, w << 15, (w << 15) + 0x3fff, (w << 15) + 0x7fff};
        for (int i = 0; i < 4; i++) {
            for (int k = 0; k < 3; k++) {
                int32_t v[3] = {0, 0, 0}, unit[3] = {7, 8, 9};
                v[k] = (w + (uint32_t)k) & 1 ? (int32_t)part[i] : -(int32_t)part[i];
                assert_true(glint_unit_q15(v, unit));
                assert_true(unit[(k + 1) % 3] == 0 && unit[(k + 2) % 3] == 0);
                assert_true((unit[k] < 0) == (v[k] < 0));
                const int component = unit[k] < 0 ? -unit[k] : unit[k];
                worst = worse(worst, fabsl(component - 32768.0L));
                least = component < least ? component : least;
                most = component > most ? component : most;
            }
        }
    }
    for (int k = 0; k < 3; k++) {
        int32_t v[3] = {0, 0, 0}, unit[3] = {7, 8, 9};
        v[k] = INT32_MIN;
        assert_true(glint_unit_q15(v, unit));
        assert_true(unit[k] == -32768 && unit[(k + 1) % 3] == 0 && unit[(k + 2) % 3] == 0);
    }
    expect_at_most("glint_unit_q15 along an axis, ulp of Q15", worst, worse(AXIS_MOST - 32768, 32768 - AXIS_LEAST));
    assert_int_equal(least, AXIS_LEAST);
    assert_int_equal(most, AXIS_MOST);
}

/*
 * Components of 16 bits that lie half a unit off what stands for them, in the directions that add up: the first one
 * way, the others the other way.
 */
static void half_off(const double w[3], bool first_above, int32_t v[3])
{
    const int first = random_between(0, 2), down = random_between(1, 4);
    for (int k = 0; k < 3; k++) {
        const uint32_t whole = w[k] < 65535 ? (uint32_t)w[k] : 65535;
        const int32_t magnitude = (int32_t)((whole << 16 | ((k == 0) == first_above ? 0 : 0xffff)) >> down);
        v[(k + first) % 3] = random_u32() & 1 ? -magnitude : magnitude;
    }
}

/* Where docs/proofs.md has the greatest errors: the length where the root is worst beside a large component (the
 * default tables), and the largest component just above a power of two beside another one (the small ones). */
static void unit_q15_keeps_its_bound_at_its_worst(void **state)
{
    static const int32_t found[2][3] = {{1922400256, 648904703, 650313727}, {493748223, 204537856, 1074659328}};
    const double right_angle = acos(-1) / 2;
    unit_worst worst = {0, 0};
    (void)state;
    check_unit_q15(found[0], &worst);
    check_unit_q15(found[1], &worst);
    for (long round = 0; round < 10000000; round++) {
        double w[3];
        int32_t v[3];
        if (round % 4 == 0) {
            w[0] = 13000 + 6000 * (double)random_unit();
            w[1] = 6000 + 8000 * (double)random_unit();
            w[2] = 32768 + 200 * (double)random_unit();
        } else {
            const bool near = round % 4 < 3;
            const double length =
                32768 * sqrt(near ? 3.93 + 0.07 * (double)random_unit() : 1 + 11 * (double)random_unit());
            const double part = near ? 0.8 + 0.15 * (double)random_unit() : (double)random_unit();
            const double rest = sqrt(1 - part * part) * length;
            const double angle = right_angle * (near ? 0.4 + 0.2 * (double)random_unit() : (double)random_unit());
            w[0] = part * length;
            w[1] = rest * cos(angle);
            w[2] = rest * sin(angle);
        }
        half_off(w, random_u32() & 1, v);
        if (v[0] || v[1] || v[2]) {
            check_unit_q15(v, &worst);
        }
    }
    expect_bound("glint_unit_q15, adversarial, ulp of Q15", worst.component_ulp, UNIT_Q15_ULP);
    expect_at_most("glint_unit_q15, adversarial, ulp of Q14", worst.component_ulp / 2, UNIT_Q14_ULP);
    expect_bound("glint_unit_q15, adversarial, length, ulp of Q15", worst.length_ulp, UNIT_Q15_LENGTH_ULP);
}

static void unit_q28_keeps_its_bound(void **state)
{
    const int32_t zero[3] = {0, 0, 0};
    int32_t unit[3] = {7, 8, 9};
    long double worst = 0;
    (void)state;
    assert_false(glint_unit_q28(zero, unit));
    assert_true(unit[0] == 7 && unit[1] == 8 && unit[2] == 9);
    for (long round = 0; round < 3000000; round++) {
        int32_t v[3];
        if (round % 4 == 1) {
            v[0] = random_any_size(31), v[1] = random_any_size(31), v[2] = random_any_size(31);
        } else if (round % 4 == 3) { /* just above a power of two, where what the sum of squares loses weighs most */
            v[0] = (1 << 30) + random_between(0, 1 << 20), v[1] = random_any_size(29), v[2] = random_any_size(29);
        } else {
            v[0] = (int32_t)random_u32(), v[1] = (int32_t)random_u32(), v[2] = round % 64 ? INT32_MAX : INT32_MIN;
        }
        if (!glint_unit_q28(v, unit)) {
            continue;
        }
        const long double x = v[0], y = v[1], z = v[2], length = sqrtl(x * x + y * y + z * z);
        for (int k = 0; k < 3; k++) {
            worst = worse(worst, fabsl(unit[k] - 268435456.0L * v[k] / length));
        }
    }
    expect_bound("glint_unit_q28, ulp of Q28", worst, UNIT_Q28_ULP);
}

static void unit_q30_keeps_its_bound(void **state)
{
    const int64_t zero[3] = {0, 0, 0};
    int32_t unit[3];
    long double worst = 0;
    (void)state;
    assert_false(glint_unit_q30(zero, unit));
    for (long round = 0; round < 3000000; round++) {
        int64_t v[3];
        long double square = 0;
        const int common = random_between(2, 63);
        for (int k = 0; k < 3; k++) {
            const uint64_t m = round % 5 == 0   ? (uint64_t)1 << random_between(0, 62)
                               : round % 5 == 1 ? random_u64() >> common
                                                : random_u64() >> random_between(2, 64 - 1);
            v[k] = round % 7 == k ? 0 : random_u32() & 1 ? -(int64_t)m : (int64_t)m;
            square += (long double)v[k] * v[k];
        }
        if (square == 0) {
            continue;
        }
        assert_true(glint_unit_q30(v, unit));
        for (int k = 0; k < 3; k++) {
            worst = worse(worst, fabsl((long double)unit[k] - 1073741824 * (v[k] / sqrtl(square))));
        }
    }
    expect_bound("glint_unit_q30, ulp of Q30", worst, UNIT_Q30_ULP);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(unit_q15_keeps_its_bound),
        numeric_test(unit_q15_along_an_axis_stays_on_it),
        numeric_test(unit_q15_keeps_its_bound_at_its_worst),
        numeric_test(unit_q28_keeps_its_bound),
        numeric_test(unit_q30_keeps_its_bound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
