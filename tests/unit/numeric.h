/* SPDX-License-Identifier: MIT */
/*
 * What the tests of the library's internals share: exact types to judge by, random numbers, stated bounds.
 *
 * The oracles are long double (64 bits of mantissa where these tests run) and 128-bit integers.
 */
#ifndef GLINT_TESTS_UNIT_NUMERIC_H
#define GLINT_TESTS_UNIT_NUMERIC_H

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

__extension__ typedef __int128 wide;

typedef char glint_assert_oracle_precision[LDBL_MANT_DIG >= 64 ? 1 : -1];

#define RANDOM_SEED 20240607u

/* xorshift64* (S. Vigna, "An experimental exploration of Marsaglia's xorshift generators, scrambled", 2016). */
static uint64_t random_state = RANDOM_SEED;

static inline uint64_t random_u64(void)
{
    random_state ^= random_state >> 12;
    random_state ^= random_state << 25;
    random_state ^= random_state >> 27;
    return random_state * 2685821657736338717u;
}

static inline uint32_t random_u32(void)
{
    return (uint32_t)(random_u64() >> 32);
}

/* low..high, both included; a bias below 2^-32 does no harm here. */
static inline int32_t random_between(int32_t low, int32_t high)
{
    const uint64_t count = (uint64_t)((int64_t)high - low) + 1;
    return (int32_t)(low + (int64_t)((random_u32() * count) >> 32));
}

/* Any sign, and any number of bits with equal chance, 0 included: small numbers are as frequent as large ones. */
static inline int32_t random_any_size(int most_bits)
{
    const int bits = random_between(0, most_bits);
    const int32_t value = (int32_t)(random_u64() & (((uint64_t)1 << bits) - 1));
    return random_u32() & 1 ? -value : value;
}

static inline long double random_unit(void)
{
    return (long double)random_u64() / 18446744073709551616.0L;
}

/* 32-bit values at which integer routines tend to break. */
static inline uint32_t edge_case_u32(unsigned index)
{
    static const uint32_t offset[6] = {0, 1, 2, 0u - 1, 0u - 2, 0x5555};
    return ((uint32_t)1 << (index / 6 % 32)) + offset[index % 6];
}
#define EDGE_CASES (32 * 6)

static inline long double worse(long double a, long double b)
{
    return b > a ? b : a;
}

/* The seed of each test is its own, so that a test alone gives what it gives in the group. */
static inline int seed_test(void **state)
{
    (void)state;
    random_state = RANDOM_SEED;
    return 0;
}

/* Prints what was measured beside what is stated; fails if it is worse. */
static inline void expect_at_most(const char *what, long double measured, long double stated)
{
    print_message("    %-56s measured %.5Lg, stated %.5Lg\n", what, measured, stated);
    if (!(measured <= stated)) {
        fail_msg("%s: measured %.6Lg, stated at most %.6Lg (seed %u)", what, measured, stated, RANDOM_SEED);
    }
}

/* The same, and fails if the statement is more than twice as loose as the worst that was found. */
static inline void expect_bound(const char *what, long double measured, long double stated)
{
    expect_at_most(what, measured, stated);
    if (!(stated <= 2 * measured)) {
        fail_msg("%s: stated %.6Lg is more than twice the measured %.6Lg: tighten it", what, stated, measured);
    }
}

/* For bounds that are stated as powers of two. */
static inline void expect_bound_log2(const char *what, long double measured, long double stated_log2)
{
    print_message("    %-56s measured 2^%.2Lf, stated 2^%.2Lf\n", what, log2l(measured), stated_log2);
    if (!(measured <= exp2l(stated_log2))) {
        fail_msg("%s: measured 2^%.3Lf, stated at most 2^%.3Lf", what, log2l(measured), stated_log2);
    }
    if (!(exp2l(stated_log2) <= 2 * measured)) {
        fail_msg("%s: stated 2^%.3Lf, measured 2^%.3Lf: tighten it", what, stated_log2, log2l(measured));
    }
}

#define numeric_test(function) cmocka_unit_test_setup(function, seed_test)

#endif
