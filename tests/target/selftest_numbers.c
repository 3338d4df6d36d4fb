/* SPDX-License-Identifier: MIT */
/*
 * The number routines on reproducible inputs: first values at the ends of their ranges, then pseudo-random ones of
 * every magnitude (xorshift32: G. Marsaglia, "Xorshift RNGs", Journal of Statistical Software 8(14), 2003).
 *
 * Fixed-point results are hashed, for they are the same bits everywhere. Float results are printed, for check.c holds
 * them to their stated errors. Limits: INPUTS are few enough for an 8-bit processor; the exhaustive tests are those of
 * tests/unit, on the host.
 */
#include "tests/target/selftest.h"

#include "number/fixed.h"
#include "number/integer.h"
#include "number/real.h"

enum { INPUTS = 600, INPUTS_64 = 120, INPUTS_REAL = 48 };

static uint32_t state;

static uint32_t random32(void)
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}

/* The i-th input: first 0, 1, the powers of two with their neighbours and their negatives; then any magnitude. */
static uint32_t input32(uint16_t i)
{
    if (i < 32 * 4) {
        const uint32_t power = (uint32_t)1 << (i >> 2);
        const uint16_t which = i & 3;
        return which == 0 ? power : which == 1 ? power - 1 : which == 2 ? power + 1 : 0u - power;
    }
    const uint32_t value = random32();
    return value >> (random32() & 31);
}

static uint64_t input64(uint16_t i)
{
    if (i < 4) {
        return i < 2 ? i : i == 2 ? UINT64_MAX : (uint64_t)1 << 62;
    }
    const uint64_t high = random32();
    const uint64_t value = high << 32 | random32();
    return value >> (random32() & 63);
}

static void print(const char *routine, uint64_t hash)
{
    report_begin("kernel");
    report_word(routine);
    report_hex(hash, 16);
    report_end();
}

/* Each routine takes the i-th inputs and hashes its results. */
typedef uint64_t (*routine)(uint64_t hash, uint16_t i);

static uint64_t leading_zeros(uint64_t hash, uint16_t i)
{
    const uint64_t wide = input64(i);
    return hash_bytes(hash, (uint64_t)(clz32(input32(i)) + 64 * bit_length64(wide)), 2);
}

/* The search in C, which some of the targets take for clz32(): the same number of bits as above. */
static uint64_t leading_zeros_search(uint64_t hash, uint16_t i)
{
    const uint64_t wide = input64(i);
    return hash_bytes(hash, (uint64_t)(clz32_search(input32(i)) + 64 * bit_length64(wide)), 2);
}

static uint64_t signs(uint64_t hash, uint16_t i)
{
    const int32_t value = (int32_t)input32(i);
    hash = hash_bytes(hash, magnitude32(value), 4);
    return hash_bytes(hash, (uint32_t)with_sign_of(value, random32() >> 1), 4);
}

static uint64_t high_u32(uint64_t hash, uint16_t i)
{
    const uint32_t a = input32(i), b = random32();
    return hash_bytes(hash, multiply_high_u32(a, b), 4);
}

static uint64_t high_narrow_u32(uint64_t hash, uint16_t i)
{
    const uint32_t a = input32(i), b = random32();
    return hash_bytes(hash, multiply_high_narrow_u32(a, b), 4);
}

static uint64_t high_s32(uint64_t hash, uint16_t i)
{
    const int32_t a = (int32_t)input32(i), b = (int32_t)random32();
    return hash_bytes(hash, (uint32_t)multiply_high_s32(a, b), 4);
}

static uint64_t high_narrow_s32(uint64_t hash, uint16_t i)
{
    const int32_t a = (int32_t)input32(i), b = (int32_t)random32();
    return hash_bytes(hash, (uint32_t)multiply_high_narrow_s32(a, b), 4);
}

static uint64_t q16(uint64_t hash, uint16_t i)
{
    const int32_t a = (int32_t)input32(i), b = (int32_t)(random32() & 0xffff) - 32768;
    return hash_bytes(hash, (uint32_t)multiply_q16(a, b), 4);
}

static uint64_t shift(uint64_t hash, uint16_t i)
{
    const int64_t value = (int64_t)(input64(i) >> 1);
    const int down = -(int)(random32() & 63); /* value + half stays below 2^63 as long as down > -63 */
    const int64_t rounded = shift_round64(i & 1 ? value >> 1 : -(value >> 1), down);
    hash = hash_bytes(hash, (uint64_t)rounded, 8);
    return hash_bytes(hash, (uint32_t)saturate_s32(rounded), 4);
}

static uint64_t reciprocal(uint64_t hash, uint16_t i)
{
    return hash_bytes(hash, glint_reciprocal_q31(input32(i) | (uint32_t)1 << 31), 4);
}

static uint64_t unit_of(bool (*make_unit)(const int32_t v[3], int32_t unit[3]), uint64_t hash, uint16_t i)
{
    int32_t v[3], unit[3] = {0, 0, 0};
    const uint32_t scale = random32() & 31;
    v[0] = (int32_t)input32(i);
    v[1] = (int32_t)random32() >> scale;
    v[2] = i & 2 ? (int32_t)random32() >> scale : (i & 1 ? INT32_MIN : 0);
    hash = hash_bytes(hash, make_unit(v, unit), 1);
    for (int k = 0; k < 3; k++) {
        hash = hash_bytes(hash, (uint32_t)unit[k], 4);
    }
    return hash;
}

static uint64_t unit_q15(uint64_t hash, uint16_t i)
{
    return unit_of(glint_unit_q15, hash, i);
}

static uint64_t unit_q28(uint64_t hash, uint16_t i)
{
    return unit_of(glint_unit_q28, hash, i);
}

static uint64_t power(uint64_t hash, uint16_t i)
{
    const uint32_t gap = input32(i);
    const uint32_t value = random32() >> 16;
    const uint16_t exponent = (uint16_t)(value >> (random32() & 15));
    return hash_bytes(hash, glint_power_q15(gap > (uint32_t)1 << 31 ? gap >> 1 : gap, exponent), 2);
}

static uint64_t sine_cosine(uint64_t hash, uint16_t i)
{
    int32_t sine, cosine;
    glint_sine_cosine_q30((uint16_t)input32(i), &sine, &cosine);
    hash = hash_bytes(hash, (uint32_t)sine, 4);
    return hash_bytes(hash, (uint32_t)cosine, 4);
}

static uint64_t square_root(uint64_t hash, uint16_t i)
{
    return hash_bytes(hash, glint_square_root_u64(input64(i)), 4);
}

static uint64_t unit_q30(uint64_t hash, uint16_t i)
{
    int64_t v[3];
    int32_t unit[3] = {0, 0, 0};
    for (int k = 0; k < 3; k++) {
        v[k] = (int64_t)(input64(i) >> 2);
        if (random32() & 1) {
            v[k] = -v[k];
        }
    }
    hash = hash_bytes(hash, glint_unit_q30(v, unit), 1);
    for (int k = 0; k < 3; k++) {
        hash = hash_bytes(hash, (uint32_t)unit[k], 4);
    }
    return hash;
}

static uint64_t scaled(uint64_t hash, uint16_t i)
{
    const glint_scaled x = glint_scaled_from(input64(i) | 1, i & 63), inverse = glint_scaled_inverse(x);
    hash = hash_bytes(hash, (uint32_t)x.m, 4);
    hash = hash_bytes(hash, (uint16_t)x.f, 2);
    hash = hash_bytes(hash, (uint32_t)inverse.m, 4);
    return hash_bytes(hash, (uint16_t)inverse.f, 2);
}

static void run(const char *name, routine results, uint16_t inputs)
{
    uint64_t hash = HASH_START;
    state = 2463534242; /* Marsaglia's; the same inputs for each routine */
    for (uint16_t i = 0; i < inputs; i++) {
        hash = results(hash, i);
    }
    print(name, hash);
}

/* Arguments of every magnitude that the two float routines take. */
static void real_numbers(void)
{
    state = 2463534242;
    for (uint16_t i = 0; i < INPUTS_REAL; i++) {
        uint32_t x = (1 + random32() % 254) << 23; /* normal, positive */
        x |= random32() >> 9;
        report_begin("real inverse-root");
        report_hex(x, 8);
        report_hex(bits_from_float(glint_inverse_root(float_from_bits(x))), 8);
        report_end();
    }
    for (uint16_t i = 0; i < INPUTS_REAL; i++) {
        const float gap = (float)(random32() >> 8) / 16777216.0f * (i & 1 ? 1.0f : 1.0f / 256);
        const float exponent = (float)(random32() & 0x3fff) / (i & 2 ? 16.0f : 256.0f);
        report_begin("real power");
        report_hex(bits_from_float(gap), 8);
        report_hex(bits_from_float(exponent), 8);
        report_hex(bits_from_float(glint_power(gap, exponent)), 8);
        report_end();
    }
}

void selftest_numbers(void)
{
    run("leading-zeros", leading_zeros, INPUTS);
    run("leading-zeros-search", leading_zeros_search, INPUTS);
    run("signs", signs, INPUTS);
    run("multiply-high-u32", high_u32, INPUTS);
    run("multiply-high-narrow-u32", high_narrow_u32, INPUTS);
    run("multiply-high-s32", high_s32, INPUTS);
    run("multiply-high-narrow-s32", high_narrow_s32, INPUTS);
    run("multiply-q16", q16, INPUTS);
    run("shift-round-64", shift, INPUTS_64);
    run("reciprocal-q31", reciprocal, INPUTS);
    run("unit-q15", unit_q15, INPUTS);
    run("unit-q28", unit_q28, INPUTS);
    run("power-q15", power, INPUTS);
    run("sine-cosine-q30", sine_cosine, INPUTS);
    run("square-root-u64", square_root, INPUTS_64);
    run("unit-q30", unit_q30, INPUTS_64);
    run("scaled", scaled, INPUTS_64);
    real_numbers();
}
