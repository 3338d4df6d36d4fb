/* SPDX-License-Identifier: MIT */
/*
 * The float routines, in ulp and with the place of the worst: the reciprocal roots of all mantissas, the sines of all
 * angles, the powers of all exponents of a material; unit vectors densely and where rounding does most. Conversions and
 * floor, and powers beyond a material's, are in test_real.c.
 */
#include "tests/unit/numeric.h"

#include "number/real.h"

/* Budgets, as number/real.h states them. */
#define INVERSE_ROOT_ULP 1.22L
#define INVERSE_ROOT_LOG2 (-23.29L) /* relative */
#define CORRECTLY_ROUNDED_ULP 0.5L
#define UNIT_ULP 3.3L /* of a component, or of UNIT_LEAST for one below that */
#define UNIT_LEAST 0x1p-100L
#define UNIT_LENGTH 2.3e-7L
#define UNIT_GREATEST (1.0f + 0x1p-23f)
#define SINE_ULP 0.73L       /* of an angle up to an eighth of a turn from a zero */
#define COSINE_ULP 0.57L     /* of the others */
#define SQUARES_ERROR 1e-7L  /* sine^2 + cosine^2 - 1 */
#define POWER_ABSOLUTE 2e-7L /* and in ulp, for a result of 2^-t: */
#define POWER_ULP 4.5L       /* times 1 + t */

/* The worst that was met, and the arguments that gave it. */
typedef struct worst {
    long double error;
    float at[3];
} worst;

static const worst no_error;

static void take_worst(worst *w, long double error, float x, float y, float z)
{
    if (!(error <= w->error)) { /* NaN is the worst */
        const worst taken = {error, {x, y, z}};
        *w = taken;
    }
}

static void print_place(const worst *w, int arguments)
{
    print_message("        at");
    for (int k = 0; k < arguments; k++) {
        print_message(" %a (%.7g)", (double)w->at[k], (double)w->at[k]);
    }
    print_message("\n");
}

/* The spacing of floats at |exact|. */
static long double ulp_at(long double exact)
{
    int exponent;
    (void)frexpl(exact, &exponent); /* |exact| within 2^(exponent - 1)..2^exponent */
    return ldexpl(1, (exponent > -125 ? exponent : -125) - 24);
}

static bool same_bits(float a, float b)
{
    return bits_from_float(a) == bits_from_float(b);
}

/* The same number, so that -0 is 0. */
static bool equal(float a, float b)
{
    return a == b;
}

static uint32_t random_mantissa(void)
{
    return random_u32() >> 9;
}

static float random_finite(uint32_t least_exponent, uint32_t greatest_exponent)
{
    const uint32_t exponent = (uint32_t)random_between((int32_t)least_exponent, (int32_t)greatest_exponent);
    return float_from_bits((random_u32() & 0x80000000u) | exponent << 23 | random_mantissa());
}

static void a_reciprocal_is_correctly_rounded(void **state)
{
    worst w = no_error;
    (void)state;
    for (uint32_t mantissa = 0; mantissa < (uint32_t)1 << 23; mantissa++) {
        const float x = float_from_bits(bits_from_float(1.0f) | mantissa);
        const long double exact = 1 / (long double)x;
        take_worst(&w, fabsl((long double)(1.0f / x) - exact) / ulp_at(exact), x, 0, 0);
    }
    for (int round = 0; round < 2000000;
         round++) { /* 1/x is normal up to 2^126, denormal beyond; below 2^-128 infinite */
        const float x = random_finite(0, 254);
        const long double exact = 1 / (long double)x;
        if (fabsl(exact) < 0x1p128L - 0x1p103L) {
            take_worst(&w, fabsl((long double)(1.0f / x) - exact) / ulp_at(exact), x, 0, 0);
        } else {
            assert_true(isinf(1.0f / x));
        }
    }
    assert_true(isinf(1.0f / 0x1p-128f) && !isinf(1.0f / 0x1.00001p-128f));
    expect_bound("1.0f / x, ulp", w.error, CORRECTLY_ROUNDED_ULP);
    print_place(&w, 1);
}

/* All floats of [1, 4): with exact scaling by 4^n, all normal numbers. */
static void inverse_root_keeps_its_bound(void **state)
{
    worst in_ulp = no_error, relative = no_error, with_sum = no_error;
    (void)state;
    for (uint32_t bits = bits_from_float(1.0f); bits < bits_from_float(4.0f); bits++) {
        const float x = float_from_bits(bits);
        const long double exact = 1 / sqrtl((long double)x);
        const long double error = fabsl((long double)glint_inverse_root(x) - exact);
        take_worst(&in_ulp, error / ulp_at(exact), x, 0, 0);
        take_worst(&relative, error / exact, x, 0, 0);
        /* In units of 2^-24, relative: three squares rounded, 1 of their sum x; two additions, each half an ulp of x.
         * The root halves it. */
        const long double half_ulp = x < 2.0f ? 1 : 2;
        take_worst(&with_sum, error / exact * 0x1p24L + (1 + 2 * half_ulp / (long double)x) / 2, x, 0, 0);
    }
    expect_bound("glint_inverse_root, ulp", in_ulp.error, INVERSE_ROOT_ULP);
    print_place(&in_ulp, 1);
    expect_bound_log2("glint_inverse_root, relative", relative.error, INVERSE_ROOT_LOG2);
    print_place(&relative, 1);
    /* an ulp is at least 2^-24 of the component, the product's rounding at most half of one; of a length at most 2^-24
     */
    expect_at_most("glint_unit by its roundings, ulp", with_sum.error + 0.5L, UNIT_ULP);
    print_place(&with_sum, 1);
    expect_at_most("glint_unit by its roundings, length", (with_sum.error + 1) * 0x1p-24L, UNIT_LENGTH);
}

static void check_scaling(uint32_t bits)
{
    const float x = float_from_bits(bits), root = glint_inverse_root(x);
    for (int n = -63; n <= 63; n++) {
        const float scaled = ldexpf(x, 2 * n);
        assert_true(same_bits(glint_inverse_root(scaled), ldexpf(root, -n)));
    }
}

static void inverse_root_scales_exactly(void **state)
{
    const uint32_t one = bits_from_float(1.0f), four = bits_from_float(4.0f);
    (void)state;
    assert_true(equal(glint_inverse_root(1.0f), 1.0f));
    for (uint32_t i = 0; i < 1000; i++) { /* both octaves and their ends */
        check_scaling(one + i);
        check_scaling(bits_from_float(2.0f) - 500 + i);
        check_scaling(four - 1 - i);
    }
    check_scaling(bits_from_float(0x1.0026eap+0f)); /* the worst, in ulp and relative */
    check_scaling(bits_from_float(0x1.bdfdcap+1f));
    for (int round = 0; round < 20000; round++) {
        check_scaling(one + random_u32() % (four - one));
    }
}

/* Whether r is the float nearest to sqrt(x), both in [1, 4): of integers r 2^23 and x 2^46, with nothing rounded. */
static bool is_nearest_root(float x, float r)
{
    const uint64_t square = (uint64_t)ldexpf(x, 23) << 23, root = (uint64_t)ldexpf(r, 23);
    return (2 * root - 1) * (2 * root - 1) < 4 * square && 4 * square < (2 * root + 1) * (2 * root + 1);
}

static void square_root_is_correctly_rounded(void **state)
{
    worst w = no_error;
    (void)state;
    for (uint32_t bits = bits_from_float(1.0f); bits < bits_from_float(4.0f); bits++) {
        const float x = float_from_bits(bits), root = glint_square_root(x);
        if (!is_nearest_root(x, root)) {
            fail_msg("sqrt(%a) is not %a", (double)x, (double)root);
        }
        take_worst(&w, fabsl((long double)root - sqrtl((long double)x)) * 0x1p23L, x, 0, 0);
    }
    expect_bound("glint_square_root, ulp", w.error, CORRECTLY_ROUNDED_ULP);
    print_place(&w, 1);
}

static void check_square_root(uint32_t bits)
{
    /* 64 bits of root rounded to 24: twice rounded is once, from 50 bits up (S. Figueroa, "When is double rounding
     * innocuous?", 1995) */
    const float x = float_from_bits(bits), exact = (float)sqrtl((long double)x);
    if (!same_bits(glint_square_root(x), exact)) {
        fail_msg("sqrt(%a) is not %a", (double)x, (double)glint_square_root(x));
    }
}

static void square_root_takes_every_exponent(void **state)
{
    (void)state;
    for (uint32_t bits = 0; bits < 100000; bits++) {
        check_square_root(bits); /* 0 and denormal numbers */
        check_square_root(0x800000 - 50000 + bits);
        check_square_root(bits_from_float(INFINITY) - bits);
    }
    for (uint32_t exponent = 0; exponent < 255; exponent++) {
        for (int round = 0; round < 8000; round++) {
            check_square_root(exponent << 23 | random_mantissa() >> (exponent ? 0 : random_between(0, 22)));
        }
    }
    assert_true(same_bits(glint_square_root(-0.0f), -0.0f));
    assert_true(isnan(glint_square_root(NAN)) && isnan(glint_square_root(-NAN)));
    assert_true(isnan(glint_square_root(-INFINITY)) && isnan(glint_square_root(-1.0f)));
    assert_true(isnan(glint_square_root(-0x1p-149f)) && isnan(glint_square_root(-FLT_MAX)));
}

static void sines_keep_their_bound(void **state)
{
    const long double step = 2 * acosl(-1.0L) / 65536, eighth = sqrtl(0.5L);
    worst sines = no_error, cosines = no_error, squares = no_error;
    (void)state;
    for (uint32_t angle = 0; angle < 65536; angle++) {
        float got[2];
        const long double exact[2] = {sinl(angle * step), cosl(angle * step)};
        glint_sine_cosine((uint16_t)angle, &got[0], &got[1]);
        for (int k = 0; k < 2 && angle % 0x4000; k++) { /* multiples of a quarter turn: below, exactly */
            const long double error = fabsl((long double)got[k] - exact[k]) / ulp_at(exact[k]);
            take_worst(fabsl(exact[k]) < eighth ? &sines : &cosines, error, (float)angle, 0, 0);
        }
        const long double s = (long double)got[0], c = (long double)got[1];
        take_worst(&squares, fabsl(s * s + c * c - 1), (float)angle, 0, 0);
    }
    expect_bound("glint_sine_cosine, ulp, up to an eighth of a turn", sines.error, SINE_ULP);
    print_place(&sines, 1);
    expect_bound("glint_sine_cosine, ulp, beyond it", cosines.error, COSINE_ULP);
    print_place(&cosines, 1);
    expect_bound("sine^2 + cosine^2 - 1", squares.error, SQUARES_ERROR);
    print_place(&squares, 1);
}

static void sines_are_exact_at_quarters_and_symmetric(void **state)
{
    static const float sine_of_quarter[4] = {0.0f, 1.0f, 0.0f, -1.0f};
    (void)state;
    for (uint32_t angle = 0; angle < 65536; angle++) {
        float sine, cosine, s, c;
        glint_sine_cosine((uint16_t)angle, &sine, &cosine);
        assert_true(bits_from_float(sine) != 0x80000000u && bits_from_float(cosine) != 0x80000000u);
        if (angle % 0x4000 == 0) {
            assert_true(same_bits(sine, sine_of_quarter[angle >> 14]));
            assert_true(same_bits(cosine, sine_of_quarter[((angle >> 14) + 1) & 3]));
        }
        if (angle % 0x4000 == 0x2000) {
            assert_true(equal(sine * sine, cosine * cosine));
        }
        glint_sine_cosine((uint16_t)(0u - angle), &s, &c); /* the other way round */
        assert_true(equal(s, -sine) && equal(c, cosine));
        glint_sine_cosine((uint16_t)(0x4000u - angle), &s, &c); /* the complement */
        assert_true(equal(s, cosine) && equal(c, sine));
        glint_sine_cosine((uint16_t)(0x4000u + angle), &s, &c); /* a quarter turn on */
        assert_true(equal(s, cosine) && equal(c, -sine));
    }
}

typedef struct unit_errors {
    worst component, length;
} unit_errors;

static void measure_unit(unit_errors *errors, const float v[3])
{
    long double sum = 0, length = 0;
    float unit[3], same[3] = {v[0], v[1], v[2]};
    for (int k = 0; k < 3; k++) {
        sum += (long double)v[k] * (long double)v[k]; /* within the exponents of long double for any float */
    }
    assert_int_equal(glint_unit(v, unit), sum > 0);
    assert_int_equal(glint_unit(same, same), sum > 0);
    if (!(sum > 0)) {
        return;
    }
    for (int k = 0; k < 3; k++) {
        const long double exact = (long double)v[k] / sqrtl(sum);
        const long double ulp = ulp_at(fabsl(exact) > UNIT_LEAST ? exact : UNIT_LEAST);
        take_worst(&errors->component, fabsl((long double)unit[k] - exact) / ulp, v[0], v[1], v[2]);
        length += (long double)unit[k] * (long double)unit[k];
        assert_true(same_bits(same[k], unit[k]));
        assert_true(fabsf(unit[k]) <= UNIT_GREATEST);
    }
    take_worst(&errors->length, fabsl(sqrtl(length) - 1), v[0], v[1], v[2]);
}

/* Vectors of every kind: of like size, flat, close to an axis, with their sums where the roundings add up, of any size.
 */
static void random_vector(float v[3], long round)
{
    const int along = random_between(0, 2);
    for (int k = 0; k < 3; k++) {
        switch (round % 6) {
        case 0:
            v[k] = random_finite(127, 127);
            break;
        case 1:
            v[k] = random_u32() & 1 ? random_finite(120, 127) : 0.0f;
            break;
        case 2:
            v[k] = k == along ? random_finite(127, 127) : random_finite(110, 120);
            break;
        case 3: /* x^2 just above 1, 2 or 4: rounding it and adding to it loses most */
            v[k] = k == along ? (random_u32() & 1 ? 1.0f : 1.41421354f) * (1 + (float)random_unit() * 0x1p-6f)
                              : random_finite(110, 117);
            break;
        case 4:
            v[k] = random_finite(0, 254);
            break;
        default:
            v[k] = random_finite(0, 254);
            v[k] = k == along ? v[k] : ldexpf(v[along], random_between(-20, 20)) * (float)random_unit();
            v[k] = isfinite(v[k]) ? v[k] : 1.0f;
        }
    }
}

static void unit_keeps_its_bound(void **state)
{
    static const float known[] = {-0x1.0034fap+0f, -0x1.ffd1a4p-13f, 0x1.fc9e4p-13f};
    unit_errors errors = {no_error, no_error};
    float v[3];
    (void)state;
    measure_unit(&errors, known);
    for (long round = 0; round < 3000000; round++) {
        random_vector(v, round);
        measure_unit(&errors, v);
    }
    expect_bound("glint_unit, ulp of a component", errors.component.error, UNIT_ULP);
    print_place(&errors.component, 3);
    expect_bound("glint_unit, length - 1", errors.length.error, UNIT_LENGTH);
    print_place(&errors.length, 3);
}

/* Where scaling starts and stops, and at both ends of the floats: in all combinations. */
static void unit_takes_any_finite_vector(void **state)
{
    static const float size[] = {0.0f,        0x1p-149f, 0x1.8p-148f,     0x1p-126f, 0x1p-100f,       0x1.fffffep-41f,
                                 0x1p-40f,    1.0f,      0x1.fffffep62f,  0x1p63f,   0x1.fffffep63f,  0x1p100f,
                                 0x1.8p-127f, 0x1p127f,  0x1.fffffep127f, 3.0f,      0x1.fffffp-127f, 0x1p-64f};
    enum { SIZES = sizeof size / sizeof *size };
    unit_errors errors = {no_error, no_error};
    (void)state;
    for (int i = 0; i < SIZES * SIZES * SIZES; i++) {
        const float v[3] = {size[i % SIZES], -size[i / SIZES % SIZES], size[i / SIZES / SIZES]};
        measure_unit(&errors, v);
    }
    expect_at_most("glint_unit, ulp of a component, extremes", errors.component.error, UNIT_ULP);
    print_place(&errors.component, 3);
}

/* No bit changes with the power of two, as long as no component or square becomes denormal. */
static void unit_does_not_depend_on_the_scale(void **state)
{
    (void)state;
    for (int round = 0; round < 200000; round++) {
        float v[3], scaled[3], unit[3], other[3];
        const int n = random_between(-116, 117);
        for (int k = 0; k < 3; k++) {
            v[k] = random_finite(117, 137);
            scaled[k] = ldexpf(v[k], n);
        }
        assert_true(glint_unit(v, unit) && glint_unit(scaled, other));
        assert_memory_equal(unit, other, sizeof unit);
    }
}

static void unit_refuses_what_has_no_direction(void **state)
{
    static const float without[] = {INFINITY, -INFINITY, NAN, -NAN};
    const float zero[3] = {0.0f, -0.0f, 0.0f}, untouched[3] = {5, 6, 7};
    float unit[3] = {5, 6, 7};
    (void)state;
    assert_false(glint_unit(zero, unit));
    for (int i = 0; i < 12 * 4; i++) {
        float v[3];
        random_vector(v, i);
        v[i % 3] = without[i / 3 % 4];
        assert_false(glint_unit(v, unit));
    }
    assert_memory_equal(unit, untouched, sizeof unit);
}

typedef struct power_errors {
    worst absolute, in_ulp; /* in_ulp: divided by 1 + t */
} power_errors;

static void measure_power(power_errors *errors, float gap, float exponent)
{
    const float power = glint_power(gap, exponent);
    const long double t = -log1pl(-(long double)gap) / logl(2) * (long double)exponent, exact = exp2l(-t);
    const long double error = fabsl((long double)power - exact);
    assert_true(power >= 0.0f && power <= 1.0f);
    take_worst(&errors->absolute, error, gap, exponent, 0);
    if (t < 39.999L) { /* from 40 on it is 0, and so may be what rounding brings there */
        take_worst(&errors->in_ulp, error / ulp_at(exact) / (1 + t), gap, exponent, 0);
    } else {
        assert_true(power <= 0x1.001p-40f);
        assert_true(t < 40.001L || power == 0.0f);
    }
}

/* All 16-bit exponents, in sixteenths; gaps that give results of every size, and those where its steps change. */
static void power_takes_every_exponent_of_a_material(void **state)
{
    static const float result[] = {0.001f, 0.1f, 0.3f, 0.6f, 0.9f, 1.0f, 1.44f, 2.0f, 3.5f, 7, 12, 20, 30, 39, 41};
    enum { RESULTS = sizeof result / sizeof *result };
    power_errors errors = {no_error, no_error};
    (void)state;
    for (uint32_t exponent_q4 = 0; exponent_q4 < 65536; exponent_q4++) {
        const float exponent = (float)exponent_q4 / 16;
        assert_true(same_bits(glint_power(0.0f, exponent), 1.0f));
        assert_true(same_bits(glint_power(1.0f, exponent), exponent_q4 ? 0.0f : 1.0f));
        for (int i = 0; i < RESULTS && exponent_q4; i++) { /* gap = 1 - 2^(-t / exponent), t near result[i] */
            const double t = (double)result[i] * (1 + (double)random_unit() / 64);
            measure_power(&errors, (float)-expm1(-t * log(2) / (double)exponent), exponent);
        }
        for (int k = 1; k <= 24 && exponent_q4; k += 1 + (int)(exponent_q4 % 7)) { /* folded at gap = 1 - 2^-k */
            const float ulps = (float)random_between(-3, 3) * 0x1p-24f;
            measure_power(&errors, k < 22 ? 1 - ldexpf(1.0f, -k) + ulps : 0.5f + ulps, exponent);
        }
    }
    measure_power(&errors, 0x1.b641p-8f, 0x1.7p+6f); /* the worst found: absolute, in ulp */
    measure_power(&errors, 0x1.42a344p-2f, 0x1.1e4p+6f);
    expect_bound("glint_power, absolute", errors.absolute.error, POWER_ABSOLUTE);
    print_place(&errors.absolute, 2);
    expect_bound("glint_power, ulp / (1 + t)", errors.in_ulp.error, POWER_ULP);
    print_place(&errors.in_ulp, 2);
}

static void power_takes_what_is_no_number(void **state)
{
    static const float positive[] = {0x1p-149f, 1.0f, 1024.0f, FLT_MAX, INFINITY, NAN};
    (void)state;
    for (int i = 0; i < 6; i++) {
        assert_true(same_bits(glint_power(NAN, positive[i]), 0.0f));
        assert_true(same_bits(glint_power(INFINITY, positive[i]), 0.0f));
        assert_true(same_bits(glint_power(1.5f, positive[i]), 0.0f));
        assert_true(same_bits(glint_power(-1.5f, positive[i]), 1.0f));
        assert_true(same_bits(glint_power(-INFINITY, positive[i]), 1.0f));
        assert_true(same_bits(glint_power(0.0f, positive[i]), 1.0f));
    }
    for (int i = 4; i < 6; i++) {
        assert_true(same_bits(glint_power(0x1p-149f, positive[i]), 0.0f));
        assert_true(same_bits(glint_power(0.5f, positive[i]), 0.0f));
        assert_true(same_bits(glint_power(1 - 0x1p-24f, positive[i]), 0.0f));
    }
    assert_true(same_bits(glint_power(NAN, 0.0f), 1.0f) && same_bits(glint_power(INFINITY, 0.0f), 1.0f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(a_reciprocal_is_correctly_rounded),
        numeric_test(inverse_root_keeps_its_bound),
        numeric_test(inverse_root_scales_exactly),
        numeric_test(square_root_is_correctly_rounded),
        numeric_test(square_root_takes_every_exponent),
        numeric_test(sines_keep_their_bound),
        numeric_test(sines_are_exact_at_quarters_and_symmetric),
        numeric_test(unit_keeps_its_bound),
        numeric_test(unit_takes_any_finite_vector),
        numeric_test(unit_does_not_depend_on_the_scale),
        numeric_test(unit_refuses_what_has_no_direction),
        numeric_test(power_takes_every_exponent_of_a_material),
        numeric_test(power_takes_what_is_no_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
