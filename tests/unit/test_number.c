/* SPDX-License-Identifier: MIT */
/*
 * The integer and fixed-point routines: each bound that src/number states is measured again. Unit vectors have a file
 * of their own, test_number_unit.c.
 */
#include "tests/unit/numeric.h"

#include "number/fixed.h"
#include "number/integer.h"
#include "number/tables.h"

/* Budgets, as number/fixed.h states them. */
#define RECIPROCAL_LOG2 (-28.3L)     /* relative */
#define POWER_RISE_ULP 1             /* of Q15: a greater gap may give that much more */
#define SINE_ULP 2.0L                /* of Q30 */
#define SCALED_INVERSE_LOG2 (-28.3L) /* relative */
#define SCALED_FROM_LOG2 (-30.0L)    /* relative: 31 bits, rounded down */
#if GLINT_SMALL_TABLES
#define POWER_ERROR 0.00034L
#else
#define POWER_ERROR 0.00016L
#endif

/* The search in C stands in where the processor cannot count: it is tested everywhere. */
static void leading_zeros_and_bit_lengths_are_counted(void **state)
{
    (void)state;
    assert_int_equal(clz32(0), 32);
    assert_int_equal(clz32_search(0), 32);
    for (int place = 0; place < 32; place++) { /* every entry of its table, at every place */
        const uint32_t top = (uint32_t)1 << place, eighth = top >> 3;
        for (uint32_t below = 0; below < 8; below++) {
            const uint32_t least = top + eighth * below, greatest = eighth ? least + eighth - 1 : least;
            assert_int_equal(clz32(least), 31 - place);
            assert_int_equal(clz32_search(least), 31 - place);
            assert_int_equal(clz32_search(greatest), clz32(greatest));
        }
    }
    for (int round = 0; round < 1000000; round++) {
        const uint32_t value = round < EDGE_CASES ? edge_case_u32((unsigned)round) : random_u32() >> (round % 32);
        const uint64_t value64 = round < EDGE_CASES ? (uint64_t)value << 32 | value : random_u64() >> (round % 64);
        int zeros = 0, bits = 0;
        while (zeros < 32 && !(value >> (31 - zeros))) {
            zeros++;
        }
        while (bits < 64 && value64 >> bits) {
            bits++;
        }
        assert_int_equal(clz32(value), zeros);
        assert_int_equal(clz32_search(value), zeros);
        assert_int_equal(bit_length64(value64), bits);
    }
}

static void magnitudes_and_saturation_hold_at_the_limits(void **state)
{
    (void)state;
    assert_true(magnitude32(INT32_MIN) == 0x80000000u);
    assert_true(magnitude32(INT32_MAX) == 0x7fffffffu && magnitude32(-1) == 1 && magnitude32(0) == 0);
    assert_true(magnitude64(INT64_MIN) == (uint64_t)1 << 63);
    assert_true(magnitude64(INT64_MAX) == INT64_MAX && magnitude64(-5) == 5);
    assert_true(saturate_s32(INT64_MAX) == INT32_MAX && saturate_s32(INT64_MIN) == INT32_MIN);
    assert_true(saturate_s32((int64_t)INT32_MAX + 1) == INT32_MAX && saturate_s32(INT32_MAX) == INT32_MAX);
    assert_true(saturate_s32((int64_t)INT32_MIN - 1) == INT32_MIN && saturate_s32(INT32_MIN) == INT32_MIN);
    assert_true(saturate_s32(-17) == -17);
}

static void signs_are_taken_off_and_put_back(void **state)
{
    (void)state;
    assert_true(with_sign_of(INT32_MIN, 0x80000000u) == INT32_MIN && with_sign_of(INT32_MIN, 0) == 0);
    assert_true(with_sign_of(-1, INT32_MAX) == -INT32_MAX && with_sign_of(INT32_MAX, INT32_MAX) == INT32_MAX);
    assert_true(with_sign_of(0, 17) == 17 && with_sign_of(1, 17) == 17 && with_sign_of(-1, 17) == -17);
    for (int round = 0; round < 1000000; round++) {
        const int32_t value = round < EDGE_CASES ? (int32_t)edge_case_u32((unsigned)round) : random_any_size(31);
        const uint32_t magnitude = random_u32() >> random_between(1, 31);
        const int64_t wide_value = value, wide_magnitude = magnitude;
        assert_true(magnitude32(value) == (uint64_t)(wide_value < 0 ? -wide_value : wide_value));
        assert_true(with_sign_of(value, magnitude) == (wide_value < 0 ? -wide_magnitude : wide_magnitude));
        assert_true(with_sign_of(value, magnitude32(value)) == value);
    }
}

static void narrow_products_equal_wide_ones_for(uint32_t a, uint32_t b)
{
    const uint32_t high = (uint32_t)(((uint64_t)a * b) >> 32);
    const int32_t signed_high = (int32_t)(((int64_t)(int32_t)a * (int32_t)b) >> 32);
    const int32_t sixteen = (int32_t)(int16_t)(b & 0xffff);
    if (multiply_high_narrow_u32(a, b) != high || multiply_high_u32(a, b) != high ||
        multiply_high_narrow_s32((int32_t)a, (int32_t)b) != signed_high ||
        multiply_high_s32((int32_t)a, (int32_t)b) != signed_high || glint_multiply_high_u32(a, b) != high ||
        glint_multiply_high_s32((int32_t)a, (int32_t)b) != signed_high ||
        multiply_wide_narrow_s32((int32_t)a, (int32_t)b) != (int64_t)(int32_t)a * (int32_t)b ||
        multiply_wide_s32((int32_t)a, (int32_t)b) != (int64_t)(int32_t)a * (int32_t)b ||
        multiply_q16((int32_t)a, sixteen) != (int32_t)(((int64_t)(int32_t)a * sixteen) >> 16)) {
        fail_msg("a product of %08x and %08x", a, b);
    }
    const uint32_t positive = b & 0x7fffffff;
    const int32_t mixed_high = (int32_t)(((int64_t)(int32_t)a * (int32_t)positive) >> 32);
    if (multiply_high_s32_u31((int32_t)a, positive) != mixed_high || glint_clz32(a) != clz32_search(a)) {
        fail_msg("a product of %08x and %08x", a, positive);
    }
}

static void narrow_products_equal_wide_ones(void **state)
{
    (void)state;
    for (unsigned i = 0; i < EDGE_CASES; i++) {
        for (unsigned k = 0; k < EDGE_CASES; k++) {
            narrow_products_equal_wide_ones_for(edge_case_u32(i), edge_case_u32(k));
        }
        for (uint32_t b = 0; b < 0x10000; b++) { /* every 16-bit factor */
            narrow_products_equal_wide_ones_for(edge_case_u32(i), b);
        }
    }
    for (long round = 0; round < 10000000; round++) {
        narrow_products_equal_wide_ones_for(random_u32(), random_u32());
    }
}

/* floor(value 2^shift + 1/2) in 128 bits. */
static int64_t shifted_exactly(int64_t value, int shift)
{
    return shift >= 0 ? (int64_t)((wide)value * ((wide)1 << shift))
                      : (int64_t)(((wide)value + ((wide)1 << (-shift - 1))) >> -shift);
}

static void shifts_round_to_nearest_halves_up(void **state)
{
    (void)state;
    assert_true(shift_round64(3, -1) == 2 && shift_round64(-3, -1) == -1 && shift_round64(1, -1) == 1);
    assert_true(shift_round64(-1, -1) == 0 && shift_round64(-5, 3) == -40 && shift_round64(7, 0) == 7);
    assert_true(shift_round64(INT64_MAX, -64) == 0 && shift_round64(INT64_MIN, -100) == 0);
    for (int shift = -90; shift <= 0; shift++) {
        for (int round = 0; round < 20000; round++) {
            /* halves and their neighbours; |value| <= 2^62 so that the rounding cannot overflow */
            int64_t value = (int64_t)(random_u64() >> random_between(2, 63));
            if (round & 1 && shift < 0 && shift >= -62) {
                const int64_t half = (int64_t)1 << (-shift - 1); /* <= 2^61 */
                value = (value >> 1) / (2 * half) * (2 * half) + half + random_between(-1, 1);
            }
            value = round & 2 ? -value : value;
            assert_true(shift_round64(value, shift) == shifted_exactly(value, shift));
        }
    }
    for (int shift = 0; shift <= 62; shift++) {
        const int64_t value = (int64_t)(random_u64() >> (shift + 1));
        assert_true(shift_round64(value, shift) == shifted_exactly(value, shift));
        assert_true(shift_round64(-value, shift) == shifted_exactly(-value, shift));
    }
}

/* |x r / 2^62 - 1| times 2^62. */
static uint64_t reciprocal_residual(uint32_t x_q31)
{
    const uint32_t r = glint_reciprocal_q31(x_q31);
    if (r < (uint32_t)1 << 30 || r > 0x7fffffffu) {
        fail_msg("reciprocal of %08x is %08x", x_q31, r);
    }
    return magnitude64((int64_t)((uint64_t)x_q31 * r - ((uint64_t)1 << 62)));
}

static long double worst_reciprocal(void)
{
    uint64_t worst = 0;
    for (uint64_t x = (uint64_t)1 << 31; x < (uint64_t)1 << 32; x += 7) {
        const uint64_t residual = reciprocal_residual((uint32_t)x);
        worst = residual > worst ? residual : worst;
    }
    for (uint32_t cell = 0; cell <= 64; cell++) {
        for (int64_t near = -3000; near <= 3000; near++) {
            const int64_t x = ((int64_t)1 << 31) + ((int64_t)cell << 25) + near;
            if (x >= (int64_t)1 << 31 && x < (int64_t)1 << 32) {
                const uint64_t residual = reciprocal_residual((uint32_t)x);
                worst = residual > worst ? residual : worst;
            }
        }
    }
    return (long double)worst / exp2l(62);
}

static void reciprocal_keeps_its_bound(void **state)
{
    (void)state;
    expect_bound_log2("glint_reciprocal_q31, relative", worst_reciprocal(), RECIPROCAL_LOG2);
}

static int compare_u32(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return x < y ? -1 : x > y;
}

#define MOST_GAPS 8192

/* Gaps in rising order: from 0 up closely and in geometric steps, beside the borders of the tables' cells in every
 * octave of 1 - gap, up to 2^31 closely, and at random. */
static int list_gaps(uint32_t *gap)
{
    const uint32_t one = (uint32_t)1 << 31;
    int count = 0;
    for (uint32_t i = 0; i < 400; i++) {
        gap[count++] = i;
        gap[count++] = one - i;
        gap[count++] = (uint32_t)(one * powl(2.0L, -(long double)i * 31 / 400));
    }
    for (int octave = 0; octave < 31; octave++) { /* of x; 32 or 16 cells over y = 1 - 2^k x in [0, 1/2] */
        for (uint32_t cell = 0; cell <= 32; cell++) {
            const uint32_t x = (one - (cell << 25)) >> octave;
            for (uint32_t near = 0; near < 3; near++) {
                gap[count++] = one - x + near <= one + 1 ? one - x + near - (x < one) : one;
            }
        }
    }
    while (count < MOST_GAPS) {
        gap[count++] = random_u32() >> random_between(1, 16);
    }
    qsort(gap, (size_t)count, sizeof *gap, compare_u32);
    assert_true(gap[count - 1] <= one);
    return count;
}

static void check_power(const uint32_t *gap, const long double *log_x, int count, uint16_t exponent_q4,
                        long double *worst)
{
    int least = 32768;
    assert_int_equal(glint_power_q15(0, exponent_q4), 32768);
    assert_int_equal(glint_power_q15((uint32_t)1 << 31, exponent_q4), exponent_q4 ? 0 : 32768);
    assert_int_equal(glint_power_q15(UINT32_MAX, exponent_q4), exponent_q4 ? 0 : 32768);
    for (int i = 0; i < count; i++) {
        const int power = glint_power_q15(gap[i], exponent_q4);
        const long double exact = exponent_q4 == 0 ? 1
                                  : gap[i] >> 31   ? 0
                                                   : (long double)exp((double)(log_x[i] * exponent_q4 / 16));
        const long double error = fabsl(power / 32768.0L - exact);
        if (power > least + POWER_RISE_ULP) {
            fail_msg("gap %08x, exponent %u/16: %d after %d", gap[i], exponent_q4, power, least);
        }
        least = power < least ? power : least;
        *worst = worse(*worst, error);
    }
}

static void power_keeps_its_bound(void **state)
{
    static uint32_t gap[MOST_GAPS];
    static long double log_x[MOST_GAPS];
    long double worst = 0;
    const int count = list_gaps(gap);
    (void)state;
    for (int i = 0; i < count; i++) {
        log_x[i] = log1pl(-(long double)gap[i] / 2147483648.0L);
    }
    for (uint32_t whole = 1; whole <= 1024; whole++) {
        check_power(gap, log_x, count, (uint16_t)(whole * 16), &worst);
    }
    for (uint32_t i = 0; i < 256; i++) {
        check_power(gap, log_x, count, (uint16_t)i, &worst);                 /* every sixteenth up to 16 */
        check_power(gap, log_x, count, (uint16_t)(65535 - 257 * i), &worst); /* and all over the range */
    }
    expect_bound("glint_power_q15", worst, POWER_ERROR);
}

/* Neighbouring gaps, not only those of the list: the power falls but for one ulp. */
static void power_falls_with_the_gap(void **state)
{
    (void)state;
    for (int round = 0; round < 2000; round++) {
        const uint16_t exponent_q4 = (uint16_t)(1 + magnitude32(random_any_size(16)) % 65535);
        const uint32_t from = random_u32() >> random_between(1, 24);
        int least = 32768;
        for (uint32_t gap = from; gap < from + 2000 && gap <= (uint32_t)1 << 31; gap++) {
            const int power = glint_power_q15(gap, exponent_q4);
            assert_true(power <= least + POWER_RISE_ULP);
            least = power < least ? power : least;
        }
    }
}

static void sine_and_cosine_keep_their_bound(void **state)
{
    const long double step = 2 * acosl(-1.0L) / 65536;
    long double worst = 0;
    (void)state;
    for (uint32_t angle = 0; angle < 65536; angle++) {
        int32_t sine, cosine;
        glint_sine_cosine_q30((uint16_t)angle, &sine, &cosine);
        worst = worse(worst, fabsl((long double)sine - sinl(angle * step) * 1073741824.0L));
        worst = worse(worst, fabsl((long double)cosine - cosl(angle * step) * 1073741824.0L));
    }
    expect_bound("glint_sine_cosine_q30, ulp of Q30", worst, SINE_ULP);
}

static void check_root(uint64_t x)
{
    const uint64_t root = glint_square_root_u64(x);
    if ((wide)root * root > (wide)x || (wide)(root + 1) * (root + 1) <= (wide)x) {
        fail_msg("root of %llu is %llu", (unsigned long long)x, (unsigned long long)root);
    }
}

static void divisions_are_exact(void **state)
{
    static const uint32_t at_the_ends[] = {0, 1, 2, 3, 0x7fffffff, 0x80000000, 0x80000001, 0xfffffffe, 0xffffffff};
    enum { ENDS = sizeof at_the_ends / sizeof *at_the_ends };
    (void)state;
    for (int i = 0; i < ENDS; i++) {
        for (int k = 1; k < ENDS; k++) {
            assert_int_equal(glint_divide_u32(at_the_ends[i], at_the_ends[k]), at_the_ends[i] / at_the_ends[k]);
        }
    }
    for (int round = 0; round < 1000000; round++) {
        const uint32_t a = random_u32() >> random_between(0, 31), b = (random_u32() >> random_between(0, 31)) | 1;
        assert_int_equal(glint_divide_u32(a, b), a / b);
    }
}

static void square_root_is_exact(void **state)
{
    (void)state;
    for (uint64_t x = 0; x < 100000; x++) {
        check_root(x);
        check_root(UINT64_MAX - x);
    }
    for (int round = 0; round < 1000000; round++) {
        const uint64_t root = random_u32() >> random_between(0, 31);
        check_root(root * root);
        check_root(root * root + 1);
        check_root(root * root - 1); /* 2^64 - 1 for 0 */
        check_root(random_u64() >> random_between(0, 63));
    }
}

static void scaled_numbers_keep_their_bounds(void **state)
{
    long double worst_from = 0, worst_inverse = 0;
    (void)state;
    for (long round = 0; round < 3000000; round++) {
        const uint64_t value = round < 64 ? (uint64_t)1 << round : (random_u64() >> random_between(0, 63)) | 1;
        const int fraction = random_between(-80, 120);
        const glint_scaled x = glint_scaled_from(value, fraction), inverse = glint_scaled_inverse(x);
        const long double exact = ldexpl((long double)value, -fraction), of_x = ldexpl((long double)x.m, -x.f);
        assert_true(x.m >= 1 << 30 && inverse.m >= 1 << 30);
        assert_true(inverse.m <= INT32_MAX - 3);
        assert_true(of_x <= exact);
        worst_from = worse(worst_from, 1 - of_x / exact);
        worst_inverse = worse(worst_inverse, fabsl(ldexpl((long double)inverse.m, -inverse.f) * of_x - 1));
    }
    expect_bound_log2("glint_scaled_from, relative", worst_from, SCALED_FROM_LOG2);
    expect_bound_log2("glint_scaled_inverse, relative", worst_inverse, SCALED_INVERSE_LOG2);
}

#if GLINT_SMALL_TABLES

/* Each seed as far from either end of its cell. */
static void check_root_table(void)
{
    for (int i = 0; i < 24; i++) {
        const long double least = 65536 / sqrtl(1 + (i + 1) / 8.0L), greatest = 65536 / sqrtl(1 + i / 8.0L);
        assert_true(glint_root_seed_q16[i] > least && glint_root_seed_q16[i] < greatest);
        assert_true(fabsl((long double)glint_root_seed_q16[i] - (least + greatest) / 2) < (greatest - least) / 8);
    }
}

#else

/* Each entry below the curve by half of what the chord to the next one is above it, and then rounded down. In the last
 * cells that half differs by less than 1/16 from one cell to the next; in the first by less than that too. */
static void check_root_table(void)
{
    for (int i = 0; i <= 192; i++) {
        const long double x = 1 + i / 64.0L, next = x + 1 / 64.0L, middle = x + 1 / 128.0L;
        const long double chord = 65536 * ((1 / sqrtl(x) + 1 / sqrtl(next)) / 2 - 1 / sqrtl(middle));
        const long double lost = 65536 / sqrtl(x) - chord / 2 - glint_root_q16[i];
        assert_true(lost > -1 / 16.0L && lost < 1 + 1 / 16.0L);
    }
}

#endif

static void tables_hold_what_their_names_say(void **state)
{
    bool seen[64] = {false};
    (void)state;
    for (int i = 0; i < 64; i++) { /* the middle of the reciprocal's range or of x's: nearer than 2^-13 of each other */
        const long double middle = 32768 / (1 + (i + 0.5L) / 64);
        assert_true(fabsl((long double)glint_reciprocal_seed_q15[i] - middle) <= 4);
        /* by which number/fixed.c computes it where code is to be small */
        assert_int_equal(glint_reciprocal_seed_q15[i],
                         glint_divide_u32(((uint32_t)1 << 22) + 64 + (uint32_t)i, 129 + 2 * (uint32_t)i));
    }
    check_root_table();
    for (int i = 0; i <= 1 << GLINT_POWER_CELLS_LOG2; i++) {
        const long double part = (long double)i / (1 << GLINT_POWER_CELLS_LOG2), y = part / 2;
        const long double slope = i ? -log2l(1 - y) / y : 1 / logl(2);
        assert_int_equal(glint_log_slope_q14[i], (int)roundl(slope * 16384));
        assert_int_equal(glint_exp_fraction_q15[i], (int)roundl(exp2l(-part) * 32768));
    }
    for (int i = 0; i < 16; i++) {
        int zeros = 0;
        while (zeros < 4 && !(i >> (3 - zeros))) {
            zeros++;
        }
        assert_int_equal(glint_clz_u4[i], zeros);
    }
    for (int i = 0; i < 64; i++) { /* B. E. Bayer, ICC 1973: bits of x ^ y and of y, interleaved and reversed */
        const int x = i % 8, y = i / 8, d = x ^ y;
        const int rank = (d & 1) << 5 | (y & 1) << 4 | (d & 2) << 2 | (y & 2) << 1 | (d & 4) >> 1 | (y & 4) >> 2;
        assert_int_equal(glint_bayer_rank[i], rank);
        assert_false(seen[glint_bayer_rank[i]]);
        seen[glint_bayer_rank[i]] = true;
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(leading_zeros_and_bit_lengths_are_counted),
        numeric_test(magnitudes_and_saturation_hold_at_the_limits),
        numeric_test(signs_are_taken_off_and_put_back),
        numeric_test(narrow_products_equal_wide_ones),
        numeric_test(shifts_round_to_nearest_halves_up),
        numeric_test(reciprocal_keeps_its_bound),
        numeric_test(power_keeps_its_bound),
        numeric_test(power_falls_with_the_gap),
        numeric_test(sine_and_cosine_keep_their_bound),
        numeric_test(divisions_are_exact),
        numeric_test(square_root_is_exact),
        numeric_test(scaled_numbers_keep_their_bounds),
        numeric_test(tables_hold_what_their_names_say),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
