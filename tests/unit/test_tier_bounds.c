/* SPDX-License-Identifier: MIT */
/*
 * Bounds of lighting/bound.h where no scene drives them: cells of a table wider than its highlight, sums that 16 bits
 * do not hold, a tier that is forced within a tolerance; and turns of directions to lights from corners close by.
 */
#include "tests/unit/numeric.h"

#include "backend/fixed.c" /* for its static functions; it takes the place of the library's own copy */

#define PEAK 32640      /* 255 codes */
#define SQUARE_UNITS 48 /* of Q30: three products cut to Q26 */

/* What linear interpolation of (1 - gap)^exponent errs by at most in the first cell. */
static long double chord_error(long double cell, long double exponent)
{
    const long double last = powl(fmaxl(1 - cell, 0), exponent);
    long double worst = 0;
    for (int i = 0; i <= 1000; i++) {
        const long double part = i / 1000.0L, true_value = powl(fmaxl(1 - cell * part, 0), exponent);
        worst = worse(worst, 1 + (last - 1) * part - true_value);
    }
    return worst;
}

static void a_cell_errs_by_no_more_than_is_stated(void **state)
{
    static const uint16_t exponents[] = {32, 100, 512, 2000, 8192, GLINT_MAX_EXPONENT * 16};
    long double worst = 0;
    int saturated = 0;
    (void)state;
    for (size_t i = 0; i < sizeof exponents / sizeof *exponents; i++) {
        for (uint8_t bits = 0; bits <= 28; bits++) {
            const uint32_t stated = glint_bound_gloss_error(PEAK, exponents[i], bits);
            worst = worse(worst, PEAK * chord_error(exp2l(bits - 28), exponents[i] / 16.0L) / stated);
            saturated += stated == PEAK;
        }
    }
    expect_at_most("error of a cell, over what is stated", worst, 1);
    assert_true(saturated > 0);
}

static glint_choice chosen(glint_bound bound, uint8_t tolerance, uint8_t least, uint8_t greatest)
{
    static const int32_t alike[3] = {1 << 20, 1 << 20, 1 << 20};
    glint_choice choice;
    glint_bound_choose(&bound, alike, tolerance, least, greatest, &choice);
    return choice;
}

static void promises_do_not_wrap(void **state)
{
    const uint32_t huge = UINT16_MAX + 100;
    (void)state;
    for (uint32_t diffuse = 0; diffuse <= PEAK; diffuse += PEAK) {
        const glint_bound bound = {.diffuse = diffuse, .flat = huge, .fixed = huge, .left = huge, .exact = huge};
        const glint_choice choice = chosen(bound, GLINT_CODES(1), GLINT_TIER_UNLIT, GLINT_TIER_EXACT);
        assert_int_equal(choice.tier, GLINT_TIER_EXACT);
        assert_int_equal(choice.promise, UINT16_MAX);
        const glint_choice any = chosen(bound, 0, GLINT_TIER_UNLIT, GLINT_TIER_EXACT);
        assert_int_equal(any.tier, diffuse ? GLINT_TIER_Q1 : GLINT_TIER_EXACT);
        assert_int_equal(any.promise, UINT16_MAX);
    }
}

/* The tier asked for is taken although it errs by more. */
static void a_forced_tier_says_what_it_errs_by(void **state)
{
    (void)state;
    for (int i = GLINT_TIER_Q1; i <= GLINT_TIER_Q2; i++) {
        const uint8_t tier = (uint8_t)i;
        const glint_bound bound = {.diffuse = PEAK, .flat = 9999, .fixed = 1000, .exact = 200, .chord_q16 = 100};
        const glint_choice choice = chosen(bound, GLINT_CODES(1), tier, tier);
        assert_int_equal(choice.tier, tier);
        assert_in_range(choice.promise, 1000 + GLINT_CODE_UNITS / 2, 1100 + GLINT_CODE_UNITS / 2);
    }
}

/* The farther, the steeper and the coarser, the more; and none from where 32 bits would wrap. */
static void a_cubic_errs_the_more_the_longer_it_is(void **state)
{
    int bounded = 0;
    (void)state;
    for (int down = 0; down <= 4; down++) {
        for (int up = 0; up <= 8; up++) {
            uint32_t before = 0;
            for (uint32_t reach = 0; reach <= 4096; reach++) {
                const glint_cubic_size size = {.together = UINT32_MAX,
                                               .view_q16 = 3000,
                                               .reach = reach,
                                               .end_q28 = 1 << 20,
                                               .up = up,
                                               .down = down};
                const uint32_t error = glint_bound_cubic(&size, 1 << 20, PEAK, 20000);
                assert_true(error >= before);
                bounded += error != UINT32_MAX;
                before = error;
                glint_cubic_size other = size;
                other.down = down + 1;
                assert_true(glint_bound_cubic(&other, 1 << 20, PEAK, 20000) >= error);
                other.down = down;
                other.up = up + 1;
                assert_true(glint_bound_cubic(&other, 1 << 20, PEAK, 20000) <= error);
            }
            assert_int_equal(before, UINT32_MAX);
        }
    }
    assert_true(bounded > 1000);
}

/* Likewise of a curve: so much for one too long to tell that no tolerance has room for it. */
static void a_curve_errs_the_more_the_longer_it_is(void **state)
{
    (void)state;
    for (int up = 0; up <= 8; up++) {
        uint32_t before = 0;
        for (uint32_t reach = 0; reach <= 2 * 4096; reach++) {
            const uint32_t error = glint_bound_curve_reach(PEAK, reach, up);
            assert_true(error >= before && error >= glint_bound_reach(PEAK, reach));
            assert_true(glint_bound_curve_reach(PEAK, reach, up + 1) <= error);
            before = error;
        }
        assert_true(before > UINT8_MAX * GLINT_CODE_UNITS / 16);
    }
}

/* Never less than the longest edge over the least length at the corners, squared; and nothing for
 * vectors so short that their shape is lost. */
static void turns_are_not_underrated(void **state)
{
    long double worst = 0;
    int bounded = 0;
    (void)state;
    for (int i = 0; i < 200000; i++) {
        const long double scale = exp2l(30 * random_unit()), apart = exp2l(-8 * random_unit());
        int32_t v[3][3], base[3];
        uint32_t any = 0;
        long double edge = 0, least = 1e30L;
        for (int k = 0; k < 3; k++) {
            base[k] = (int32_t)(scale * (2 * random_unit() - 1) / 2);
        }
        for (int c = 0; c < 3; c++) {
            long double square = 0;
            for (int k = 0; k < 3; k++) {
                v[c][k] = base[k] + (int32_t)(scale * apart * (random_unit() - 0.5L));
                any |= magnitude32(v[c][k]);
                square += (long double)v[c][k] * v[c][k];
            }
            least = fminl(least, square);
        }
        for (int c = 0; c < 3; c++) {
            long double square = 0;
            for (int k = 0; k < 3; k++) {
                const long double d = (long double)v[c][k] - v[(c + 1) % 3][k];
                square += d * d;
            }
            edge = fmaxl(edge, square);
        }
        const uint32_t stated = turn_square_q16(v[0], v[1], v[2]);
        if (any < 1 << 13) {
            assert_int_equal(stated, UINT32_MAX);
        } else if (stated != UINT32_MAX) {
            bounded++;
            worst = worse(worst, edge / least * 65536 / stated);
        }
    }
    assert_true(bounded > 10000);
    expect_at_most("a turn's square, over what is stated", worst, 1);
}

/* clang-tidy, which does not know what clz32() returns, would see shifts by negative numbers in it. */
static bool (*set_up)(field_quadratic *, const attribute_plane *, const glint_curve *, uint8_t,
                      uint32_t) = field_square_set_up;

/* Anchors beside a small triangle may lie where |M|^2 has no room; where it has, the field has its value. */
static void squares_that_do_not_fit_are_refused(void **state)
{
    static const glint_curve curve = {{32768, 16384, 12288}, 1};
    int served = 0, refused = 0;
    (void)state;
    for (int i = 0; i < 100000; i++) {
        attribute_plane plane[3] = {{0}};
        field_quadratic field;
        long double square = 0;
        bool fits = true;
        for (int k = 0; k < 3; k++) {
            const int32_t value = random_between(-1500000000, 1500000000);
            plane[k].value = (uint32_t)value;
            square += ldexpl((long double)value * value, -58);
            fits = fits && magnitude32(value) < (uint32_t)1 << 30; /* 2 in Q29 */
        }
        if (set_up(&field, plane, &curve, GLINT_TIER_Q2, 1)) {
            served++;
            assert_true(fits && square < 8 + 1e-6L);
            /* Q30, which holds squares up to 2; half of what field_length() drops is added */
            const uint32_t at_one = ((uint32_t)1 << 30) + (1 << 14);
            assert_true(square > 2 - 1e-6L ||
                        fabsl((int32_t)(field.value - at_one) + ldexpl(square, 30)) <= SQUARE_UNITS);
        } else {
            refused++;
            assert_true(!fits || square > 8 - 1e-6L);
        }
    }
    assert_true(served > 1000 && refused > 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cell_errs_by_no_more_than_is_stated),
        cmocka_unit_test(promises_do_not_wrap),
        cmocka_unit_test(a_forced_tier_says_what_it_errs_by),
        cmocka_unit_test(a_cubic_errs_the_more_the_longer_it_is),
        cmocka_unit_test(a_curve_errs_the_more_the_longer_it_is),
        cmocka_unit_test(squares_that_do_not_fit_are_refused),
        cmocka_unit_test(turns_are_not_underrated),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
