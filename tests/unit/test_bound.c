/* SPDX-License-Identifier: MIT */
/*
 * The choice of a tier: tables of curves, and what glint_bound_choose() promises, against long double at points of
 * random triangles. The tier of curves is in test_bound_curved.c, the bounds on highlights in test_bound_highlight.c.
 */
#include "tests/unit/bound_triangle.h"

#include "number/tables.h"

/* Budgets, as lighting/bound.h and number/tables.h state them. */
#define CURVE_LOW (-1 / 2048.0L) /* least y */
#define CURVE_TIGHT 1.5L         /* the stated error is at most this times the true one, and a unit of Q16 */
#define WEIGHT_ULP 0.51L         /* of Q15: rounding to nearest, and the reciprocal */

static long double curve_at(const glint_curve *curve, long double y)
{
    return (curve->c_q15[0] + y * (curve->c_q15[1] + y * curve->c_q15[2])) / 32768;
}

static void curves_err_by_what_their_table_says(void **state)
{
    enum { GRID = 300000 }; /* not the generator's, nor a multiple of it */
    (void)state;
    for (uint8_t degree = 0; degree < GLINT_CURVE_DEGREES; degree++) {
        long double fullest = 0, loosest = 0;
        for (uint8_t class = 0; class < GLINT_CURVE_CLASSES; class ++) {
            const long double high = glint_curve_limit_q16[class] / ONE_Q16;
            glint_curve curve;
            long double worst = 0;
            glint_curve_of(class, degree, &curve);
            assert_true(degree == 2 || curve.c_q15[2] == 0);
            assert_true(degree >= 1 || curve.c_q15[1] == 0);
            for (int i = 0; i <= GRID; i++) {
                const long double y = CURVE_LOW + (high - CURVE_LOW) * i / GRID;
                worst = worse(worst, fabsl(sqrtl(1 - y) * curve_at(&curve, y) - 1));
            }
            fullest = worse(fullest, worst * ONE_Q16 / curve.error_q16);
            loosest = worse(loosest, (curve.error_q16 - 1) / (worst * ONE_Q16));
        }
        print_message("    degree %d\n", degree);
        expect_at_most("error of a curve, over its table's", fullest, 1);
        expect_at_most("error in the table less a unit, over the curve's", loosest, CURVE_TIGHT);
    }
}

static void the_class_is_the_first_that_reaches(void **state)
{
    (void)state;
    for (uint32_t y_q16 = 0; y_q16 <= 70000; y_q16++) {
        const uint8_t class = glint_curve_class(y_q16);
        assert_true(class <= GLINT_CURVE_CLASSES);
        assert_true(class == GLINT_CURVE_CLASSES || y_q16 <= glint_curve_limit_q16[class]);
        assert_true(class == 0 || y_q16 > glint_curve_limit_q16[class - 1]);
    }
}

/* The class of a choice, by its curve. */
static uint8_t class_of(const glint_choice *choice)
{
    for (uint8_t class = 0; class < GLINT_CURVE_CLASSES; class ++) {
        glint_curve curve;
        glint_curve_of(class, (uint8_t)(choice->tier - GLINT_TIER_Q1 + 1), &curve);
        if (memcmp(&curve, &choice->curve, sizeof curve) == 0) {
            return class;
        }
    }
    fail_msg("a curve that is not in the table");
    return GLINT_CURVE_CLASSES;
}

typedef struct choice_worst {
    long double weight_ulp, below, above, shorter, promised, affine;
    long chosen, affine_chosen;
} choice_worst;

static void check_point(const case_triangle *t, const glint_choice *choice, uint8_t class, bool affine,
                        const long double b[3], choice_worst *worst)
{
    const glint_bound *bound = &t->bound;
    long double used[3], real[3], m[3], n[3], moved[3], one = 0;
    for (int i = 0; i < 3; i++) {
        used[i] = choice->weight_q15[i] / 32768.0L;
        real[i] = t->inverse_depth[i];
        one += b[i] * real[i];
    }
    for (int i = 0; i < 3; i++) {
        real[i] /= one;
    }
    weighted(t->normal, b, used, m);
    weighted(t->normal, b, real, n);
    const long double square = dot3(m, m), y = 1 - square;
    const long double off = fabsl(sqrtl(square) * curve_at(&choice->curve, y) - 1);
    for (int k = 0; k < 3; k++) {
        moved[k] = n[k] / sqrtl(dot3(n, n)) - m[k] / sqrtl(square);
    }
    const long double moved_units = affine ? bound->turned * sqrtl(dot3(moved, moved)) : 0;
    const uint32_t highlights = bound->left > bound->gloss ? bound->left : bound->gloss;
    const long double promised = choice->promise - HALF_CODE - (long double)bound->fixed - bound->reach - highlights;
    worst->below = worse(worst->below, y / CURVE_LOW);
    worst->above = worse(worst->above, y * ONE_Q16 - glint_curve_limit_q16[class]);
    worst->shorter = worse(worst->shorter, 32768 / sqrtl(square) / choice->longest_q15);
    worst->affine = worse(worst->affine, moved_units);
    worst->promised = worse(worst->promised, (bound->diffuse * off + moved_units) / promised);
}

static void check_choice(const case_triangle *t, const glint_choice *choice, choice_worst *worst)
{
    const int32_t *depth = t->inverse_depth;
    const uint8_t class = class_of(choice);
    int32_t high = depth[0], low = depth[0];
    for (int i = 1; i < 3; i++) {
        high = depth[i] > high ? depth[i] : high;
        low = depth[i] < low ? depth[i] : low;
    }
    const bool affine = choice->weight_q15[0] == 32768 && choice->weight_q15[1] == 32768 &&
                        choice->weight_q15[2] == 32768 && low < high;
    worst->chosen++;
    worst->affine_chosen += affine;
    for (int i = 0; i < 3 && !affine; i++) {
        worst->weight_ulp =
            worse(worst->weight_ulp, fabsl(choice->weight_q15[i] - 32768 * ((long double)depth[i] / high)));
    }
    for (int round = 0; round < 12; round++) {
        long double b[3];
        random_point(b, round);
        check_point(t, choice, class, affine, b, worst);
    }
}

static void a_tier_keeps_its_promise(void **state)
{
    choice_worst worst;
    (void)state;
    memset(&worst, 0, sizeof worst);
    worst.above = -ONE_Q16;
    for (int round = 0; round < 400000; round++) {
        case_triangle t;
        glint_choice choice;
        const uint8_t tier = (uint8_t)random_between(GLINT_TIER_Q1, GLINT_TIER_Q2);
        random_triangle(&t);
        glint_bound_choose(&t.bound, t.inverse_depth, 0, tier, tier, &choice);
        if (choice.tier != GLINT_TIER_EXACT && choice.promise < UINT16_MAX) {
            assert_true(choice.tier >= tier); /* above it where its curve errs by more than any may */
            check_choice(&t, &choice, &worst);
        }
    }
    print_message("    %ld triangles, %ld of them without perspective correction\n", worst.chosen, worst.affine_chosen);
    assert_true(worst.chosen > 100000 && worst.affine_chosen > 10000);
    expect_at_most("weights, ulp of Q15", worst.weight_ulp, WEIGHT_ULP);
    expect_at_most("1 - |M|^2 below 0, over the least of the curves' range", worst.below, 1);
    expect_at_most("1 - |M|^2 beyond the class, units of Q16", worst.above, 0);
    expect_at_most("1/|M|, over the longest", worst.shorter, 1);
    expect_bound("without perspective correction, 1/256 code", worst.affine, AFFINE_UNITS);
    expect_bound("error of the curve and of weights left out, over the promise", worst.promised, 1);
}

/* Each tier's promise, asked for by name: the choice is the first that fits. */
static void the_tier_is_the_cheapest_that_fits(void **state)
{
    long chosen[GLINT_TIERS] = {0};
    (void)state;
    for (int round = 0; round < 200000; round++) {
        case_triangle t;
        glint_choice choice, forced;
        const uint8_t tolerance = (uint8_t)random_between(GLINT_LEAST_TOLERANCE, 255);
        const uint32_t most = tolerance * (GLINT_CODE_UNITS / 16u);
        random_triangle(&t);
        t.bound.diffuse = round % 50 ? t.bound.diffuse : 0;
        uint8_t expected = GLINT_TIER_EXACT;
        for (uint8_t tier = GLINT_TIER_Q2; tier >= GLINT_TIER_CURVED; tier--) {
            glint_bound_choose(&t.bound, t.inverse_depth, 0, tier, tier, &forced);
            expected = forced.tier == tier && forced.promise <= most ? tier : expected;
        }
        expected = t.bound.flat <= most ? GLINT_TIER_FLAT : expected;
        if (t.bound.diffuse == 0) { /* one colour, the ambient term, whose rounding is all that counts but highlights */
            const uint32_t unlit = HALF_CODE + glint_bound_rounding(0, 1) + t.bound.left;
            expected = unlit <= most ? GLINT_TIER_UNLIT : GLINT_TIER_EXACT;
        }
        glint_bound_choose(&t.bound, t.inverse_depth, tolerance, GLINT_TIER_UNLIT, GLINT_TIER_EXACT, &choice);
        assert_int_equal(choice.tier, expected);
        assert_true(choice.tier == GLINT_TIER_EXACT || choice.promise <= most);
        assert_true(choice.tier != GLINT_TIER_FLAT || choice.promise == t.bound.flat);
        assert_true(choice.tier != GLINT_TIER_EXACT || choice.promise == t.bound.exact);
        chosen[choice.tier]++;
    }
    for (int tier = 0; tier < GLINT_TIERS; tier++) {
        assert_true(tier == GLINT_TIER_GOURAUD || chosen[tier] > 100); /* the cases reach every tier that is chosen */
    }
}

/* Depths that no triangle on the screen has: nothing is divided by 0, and only the exact tier or one colour is left. */
static void depths_of_0_are_exact(void **state)
{
    static const int32_t depths[4][3] = {{0, 0, 0}, {0, 1, 2}, {1, 0, 1 << 30}, {-5, 7, 7}};
    (void)state;
    for (int i = 0; i < 4; i++) {
        const glint_bound bound = {.diffuse = 30000, .turned = 30000, .exact = 140, .flat = 60000, .chord_q16 = 9999};
        glint_choice choice;
        glint_bound_choose(&bound, depths[i], 0, GLINT_TIER_GOURAUD, GLINT_TIER_GOURAUD, &choice);
        assert_int_equal(choice.tier, GLINT_TIER_EXACT);
        assert_int_equal(choice.promise, 140);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(curves_err_by_what_their_table_says),
        numeric_test(the_class_is_the_first_that_reaches),
        numeric_test(a_tier_keeps_its_promise),
        numeric_test(the_tier_is_the_cheapest_that_fits),
        numeric_test(depths_of_0_are_exact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
