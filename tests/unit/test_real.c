/* SPDX-License-Identifier: MIT */
/*
 * The float routines: each bound that number/real.h states is measured again.
 */
#include "tests/unit/numeric.h"

#include "number/real.h"

/* Budgets, as number/real.h states them. */
#define POWER_ERROR 2e-7L
#define LEAST_FRACTION (-96) /* of float_from_scaled() */
#define GREATEST_FRACTION 126

static float random_gap(int round)
{
    switch (round % 4) {
    case 0:
        return float_from_bits(bits_from_float(1.0f) - (random_u32() >> random_between(4, 31))); /* near 1 */
    case 1:
        return ldexpf((float)random_unit(), random_between(-40, 0)); /* near 0, every octave */
    case 2:
        return 0.5f + (float)random_between(-50, 50) * 0x1p-24f; /* where the range is folded */
    default:
        return (float)random_unit();
    }
}

static float random_exponent(int round)
{
    switch (round % 3) {
    case 0:
        return (float)random_between(0, 1024 * 16) / 16; /* what a scene may hold */
    case 1:
        return ldexpf((float)random_unit(), random_between(-20, 10));
    default:
        return ldexpf((float)random_unit(), random_between(10, 40)); /* far beyond */
    }
}

static void power_keeps_its_bound(void **state)
{
    long double worst = 0;
    (void)state;
    for (int round = 0; round < 6000000; round++) {
        const float gap = random_gap(round), exponent = random_exponent(round / 4);
        const float power = glint_power(gap, exponent);
        const long double exact =
            exponent > 0 ? (gap < 1.0f ? expl(log1pl(-(long double)gap) * (long double)exponent) : 0.0L) : 1.0L;
        if (!(power >= 0.0f && power <= 1.000001f)) {
            fail_msg("(1 - %a)^%a is %a", (double)gap, (double)exponent, (double)power);
        }
        worst = worse(worst, fabsl((long double)power - exact));
    }
    expect_bound("glint_power", worst, POWER_ERROR);
}

static void power_is_exact_at_the_ends(void **state)
{
    (void)state;
    for (int round = 0; round < 100000; round++) {
        const float exponent = random_exponent(round);
        assert_true(glint_power(0.0f, exponent) == 1.0f);
        assert_true(glint_power(random_gap(round), 0.0f) == 1.0f);
        assert_true(glint_power(1.0f, exponent) == (exponent > 0.0f ? 0.0f : 1.0f));
    }
    assert_true(glint_power(1.0f, 0.0f) == 1.0f);
    assert_true(glint_power(0.0f, 0.0f) == 1.0f);
}

static void floor_is_that_of_libm(void **state)
{
    static const float special[] = {0.0f,       -0.0f,       0.5f,      -0.5f,      1.0f,           -1.0f,
                                    8388607.5f, -8388607.5f, 0x1p-149f, -0x1p-149f, 0x1.fffffep30f, -0x1.fffffep30f};
    (void)state;
    for (size_t i = 0; i < sizeof special / sizeof *special; i++) {
        assert_true((double)float_floor(special[i]) == floor((double)special[i]));
    }
    for (int round = 0; round < 5000000; round++) {
        const float value = round & 1
                                ? float_from_bits((random_u32() & 0x807fffff) | (uint32_t)random_between(0, 157) << 23)
                                : (float)random_between(-70000, 70000) / 8;
        assert_true((double)float_floor(value) == floor((double)value));
    }
}

static void scaled_integers_are_rounded_once(void **state)
{
    (void)state;
    for (int fraction = LEAST_FRACTION; fraction <= GREATEST_FRACTION; fraction++) {
        for (int round = 0; round < 20000; round++) {
            const int32_t m = round < EDGE_CASES ? (int32_t)edge_case_u32((unsigned)round) : random_any_size(31);
            /* exact in long double; the one rounding is the conversion */
            assert_true(float_from_scaled(m, fraction) == (float)ldexpl((long double)m, -fraction));
        }
    }
}

static void bits_and_floats_are_taken_as_they_are(void **state)
{
    (void)state;
    assert_true(bits_from_float(1.0f) == 0x3f800000u && bits_from_float(-0.0f) == 0x80000000u);
    for (int round = 0; round < 1000000; round++) {
        const uint32_t bits = (random_u32() & 0x807fffff) | (uint32_t)random_between(0, 254) << 23; /* finite */
        assert_true(bits_from_float(float_from_bits(bits)) == bits);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(power_keeps_its_bound),
        numeric_test(power_is_exact_at_the_ends),
        numeric_test(floor_is_that_of_libm),
        numeric_test(scaled_integers_are_rounded_once),
        numeric_test(bits_and_floats_are_taken_as_they_are),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
