/* SPDX-License-Identifier: MIT */
#include "number/fixed.h"

#include "number/tables.h"

/* Inlined into the routines of this file, which call them, the functions that share code would be three calls of
 * another three. */
#if defined __GNUC__
#define NOT_INLINE __attribute__((noinline))
#else
#define NOT_INLINE
#endif

NOT_INLINE int glint_clz32(uint32_t value)
{
    return clz32_search(value);
}

/* Bit by bit: `rest` is below b. */
NOT_INLINE uint32_t glint_divide_u32(uint32_t a, uint32_t b)
{
    uint32_t rest = 0;
    for (int i = 0; i < 32; i++) {
        const bool beyond = rest >> 31;
        rest = rest << 1 | a >> 31;
        a <<= 1;
        if (beyond || rest >= b) {
            rest -= b;
            a |= 1;
        }
    }
    return a;
}

NOT_INLINE uint32_t glint_multiply_high_u32(uint32_t a, uint32_t b)
{
    return multiply_high_narrow_u32(a, b);
}

NOT_INLINE int32_t glint_multiply_high_s32(int32_t a, int32_t b)
{
    return multiply_high_narrow_s32(a, b);
}

NOT_INLINE int64_t glint_multiply_wide_s32(int32_t a, int32_t b)
{
    return multiply_wide_narrow_s32(a, b);
}

NOT_INLINE int glint_bit_length64(uint64_t value)
{
    return bit_length64_inline(value);
}

/* Set-up calls it in any build: once in the code. */
NOT_INLINE int64_t glint_shift_round64(int64_t value, int shift)
{
    return shift_round64_inline(value, shift);
}

/* The middle of the cell's reciprocals, 1/x for x in 1 + cell/64 .. 1 + (cell + 1)/64. A short division is shorter than
 * the table. */
static uint32_t reciprocal_seed_q15(uint32_t cell)
{
#if GLINT_SHORT_DIVISION
    return glint_divide_u32(((uint32_t)1 << 22) + 64 + cell, 129 + 2 * cell);
#else
    return flash_u16(&glint_reciprocal_seed_q15[cell]);
#endif
}

uint32_t glint_reciprocal_q31(uint32_t x_q31)
{
    const uint32_t x_high = x_q31 >> 16, x_low = x_q31 & 0xffff;
    /* relative error below 2^-7 */
    const uint32_t seed_q15 = reciprocal_seed_q15((x_q31 >> 25) & 63);
    /* First step with the upper 16 bits of x, which stand for themselves and a half; |residual| < 2^23. The step
     * leaves the square of the seed's error and so too little, 0..2^-14: half of that is added. */
    const int32_t residual_q30 =
        (int32_t)(((uint32_t)1 << 30) + ((uint32_t)1 << 15) - x_high * seed_q15 - (seed_q15 >> 1));
    GLINT_TRACE("reciprocal residual q30", residual_q30);
    const uint32_t r_q16 =
        2 * seed_q15 + (uint32_t)(((int32_t)seed_q15 * (residual_q30 >> 8) + ((int32_t)1 << 20)) >> 21);
    /* second step with all of x; r < 2^16, and |residual| < 2^16.9. It is 5 units too great, because the step leaves
     * the square of the error again, and rounds down. */
    const int32_t residual_q31 = (int32_t)(((uint32_t)1 << 31) + 5 - x_high * r_q16 - ((x_low * r_q16) >> 16));
    GLINT_TRACE("reciprocal residual q31", residual_q31);
    const uint32_t r = (r_q16 << 15) + (uint32_t)(((int32_t)r_q16 * (residual_q31 >> 2)) >> 14);
    GLINT_TRACE("reciprocal q31", r);
    return r;
}

#if GLINT_SMALL_TABLES

/* 1/sqrt(s / 2^30) in Q16, 2^30 <= s < 2^32, from a table of 24 cells and two Newton steps. Relative error at most
 * 2^-15.98, of which 2^-16 is the rounding to Q16; greatest near s = 2^32, at 4294048712. The result is in [2^15,
 * 2^16), 65535 standing for 1. */
static uint32_t inverse_root_q16(uint32_t s_q30)
{
    uint32_t y = flash_u16(&glint_root_seed_q16[(s_q30 >> 27) - 8]);
    /* first Newton step, y (3 - x y^2) / 2, with 16-bit factors: relative error 2^-9.5 */
    const uint32_t x_q14 = s_q30 >> 16;
    const uint32_t xyy_q30 = ((y * y) >> 16) * x_q14;            /* 1 +- 0.06 */
    y = (y * ((3 * ((uint32_t)1 << 30) - xyy_q30) >> 16)) >> 15; /* < 2^16 * 2^15.1 */
    if (y > 65535) {
        y = 65535;
    }
    /* second step in residual form, y + y (1 - x y^2) / 2: the residual keeps 30 bits, |residual| < 2^-8 */
    const int32_t residual_q30 = ((int32_t)1 << 30) - (int32_t)multiply_high_u32(y * y, s_q30);
    y += (uint32_t)(((int32_t)y * (residual_q30 >> 8) + ((int32_t)1 << 22)) >> 23);
    return y > 65535 ? 65535 : y;
}

#else

/* 1/sqrt(s / 2^30) in Q16, 2^30 <= s < 2^32, linear within one of 192 cells. Relative error at most 2^-15.01; greatest
 * in the last cell, at s = 4294709248, where it is -2^-15.023. The table allows for the chord lying above the curve and
 * for the rounding. The result is in [2^15, 2^16), 65535 standing for 1. Overflow: a cell's entries differ by at most
 * 506, so the product is below 2^25. */
static uint32_t inverse_root_q16(uint32_t s_q30)
{
    const uint16_t *const cell = glint_root_q16 + ((s_q30 >> 24) - 64);
    const uint32_t left = flash_u16(cell), right = flash_u16(cell + 1); /* left - right <= 506 */
    return left - (((left - right) * (s_q30 >> 8 & 0xffff)) >> 16);
}

#endif

uint32_t glint_inverse_root_q16(uint32_t x_q30)
{
    return inverse_root_q16(x_q30);
}

bool glint_unit_q15(const int32_t v[3], int32_t unit[3])
{
    uint32_t x = magnitude32(v[0]), y = magnitude32(v[1]), z = magnitude32(v[2]);
    const uint32_t any = x | y | z;
    if (any == 0) {
        return false;
    }
    const int shift = clz32(any);
    /* The largest to [2^15, 2^16). Bits below are dropped, and every component stands for itself plus 1/2 from here on:
     * as near as rounding, with no carry to look after. (w + 1/2)^2 is w (w + 1), less than 2^32, plus 1/4. */
    x = (x << shift) >> 16;
    y = (y << shift) >> 16;
    z = (z << shift) >> 16;
    uint32_t sum = ((x * (x + 1)) >> 2) + ((y * (y + 1)) >> 2) + ((z * (z + 1)) >> 2); /* >= 2^28, < 2^31.6 */
    /* |w| = 2 sqrt(sum). With sum in [2^30, 2^32), w / |w| in Q15 is w y / 2^17; below, sum is multiplied by 4 and y
     * comes out half as large. */
    int down = 16;
    if (sum >> 30) {
        down = 17;
    } else {
        sum <<= 2;
    }
    const uint32_t inverse = inverse_root_q16(sum);
    /* (w + 1/2) y, and half of the last place to round: w, y <= 2^16 - 1 keep the sum below 2^32 */
    const uint32_t half = (((uint32_t)1 << down) + inverse) >> 1;
    unit[0] = with_sign_of(v[0], (x * inverse + half) >> down);
    unit[1] = with_sign_of(v[1], (y * inverse + half) >> down);
    unit[2] = with_sign_of(v[2], (z * inverse + half) >> down);
    return true;
}

bool glint_unit_q28(const int32_t v[3], int32_t unit[3])
{
    uint32_t w[3] = {magnitude32(v[0]), magnitude32(v[1]), magnitude32(v[2])};
    const int shift = clz32(w[0] | w[1] | w[2]);
    if (shift == 32) {
        return false;
    }
    uint32_t sum = 0;
    for (int k = 0; k < 3; k++) {
        w[k] <<= shift;                            /* the largest in [2^31, 2^32) */
        sum += multiply_high_u32(w[k], w[k]) >> 2; /* each < 2^30: the sum < 2^31.6, and >= 2^28 */
    }
    /* |w| = 2^17 sqrt(sum). With sum in [2^30, 2^32), w / |w| is w y 2^-32; below, sum is multiplied by 4 and y comes
     * out half as large. */
    int down = 3;
    if (sum < (uint32_t)1 << 30) {
        sum <<= 2;
        down = 2;
    }
    /* one more Newton step in residual form, 1 - s y^2 in Q28; |residual| < 2^-14 */
    uint32_t y_q31 = inverse_root_q16(sum) << 15;
    const int32_t residual_q28 = ((int32_t)1 << 28) - (int32_t)multiply_high_u32(multiply_high_u32(y_q31, y_q31), sum);
    y_q31 += (uint32_t)multiply_high_s32((int32_t)y_q31, residual_q28 * 8);
    for (int k = 0; k < 3; k++) {
        const uint32_t component = ((multiply_high_u32(w[k], y_q31) >> (down - 1)) + 1) >> 1;
        unit[k] = with_sign_of(v[k], component);
    }
    return true;
}

/* Bits of the fraction within a cell, of an index of 15 bits into the logarithm's table and 14 into the exponential's.
 */
#define LOG_BITS (15 - GLINT_POWER_CELLS_LOG2)
#define EXP_BITS (14 - GLINT_POWER_CELLS_LOG2)

/* table[index / 2^bits], linear between entries. */
static uint32_t interpolate(const uint16_t *table, uint32_t index, int bits)
{
    const uint32_t cell = index >> bits;
    const int32_t left = (int32_t)flash_u16(&table[cell]);
    const int32_t right = (int32_t)flash_u16(&table[cell + 1]);
    const int32_t fraction = (int32_t)(index & (((uint32_t)1 << bits) - 1));
    return (uint32_t)(left + (((right - left) * fraction + ((int32_t)1 << (bits - 1))) >> bits));
}

uint16_t glint_power_q15(uint32_t gap_q31, uint16_t exponent_q4)
{
    const uint32_t one_q31 = (uint32_t)1 << 31;
    if (exponent_q4 == 0 || gap_q31 == 0) {
        return 32768;
    }
    if (gap_q31 >= one_q31) {
        return 0;
    }
    const uint32_t x_q31 = one_q31 - gap_q31;
    const int k = clz32(x_q31) - 1 > 0 ? clz32(x_q31) - 1 : 0; /* 2^k x in [1/2, 1]; k <= 30 */
    const uint32_t y_q31 = k ? one_q31 - (x_q31 << k) : gap_q31;
    if (y_q31 == (uint32_t)1 << 30) {
        /* the last entry has no right neighbour: 2^k x = 1/2 exactly, t = k + 1 */
        return (uint32_t)(k + 1) * exponent_q4 >= 16 * 17
                   ? 0
                   : (uint16_t)(interpolate(glint_exp_fraction_q15, ((uint32_t)(k + 1) * exponent_q4 & 15) << 10,
                                            EXP_BITS) >>
                                ((uint32_t)(k + 1) * exponent_q4 >> 4));
    }
    const uint32_t slope_q14 = interpolate(glint_log_slope_q14, y_q31 >> 15, LOG_BITS); /* the cells lie over y < 1/2 */
    /* y P(y) in Q29, below 1 but for rounding */
    const uint32_t log_q29 = (y_q31 >> 16) * slope_q14 + (((y_q31 & 0xffff) * slope_q14) >> 16);
    const uint32_t t_q26 = ((uint32_t)k << 26) + ((log_q29 + 4) >> 3); /* <= 31 2^26 < 2^31 */
    /* a t in Q14: (exponent_q4 / 16) (t_q26 / 2^26) = exponent_q4 t_q26 / 2^30; times 2^14 is / 2^16 */
    const uint32_t at_q14 = (t_q26 >> 16) * exponent_q4 + (((t_q26 & 0xffff) * exponent_q4) >> 16); /* < 2^31 */
    const uint32_t whole = at_q14 >> 14;
    GLINT_TRACE("power t q26", t_q26);
    GLINT_TRACE("power a t q14", at_q14);
    if (whole > 16) {
        return 0; /* below 2^-17: less than a quarter of an ulp */
    }
    return (uint16_t)(interpolate(glint_exp_fraction_q15, at_q14 & 0x3fff, EXP_BITS) >> whole);
}

int32_t glint_multiply_q30(int32_t a, int32_t b)
{
    return (int32_t)(multiply_wide_s32(a, b) >> 30);
}

void glint_sine_cosine_q30(uint16_t angle_turn16, int32_t *sine_q30, int32_t *cosine_q30)
{
    static const int32_t one = (int32_t)1 << 30;
    const unsigned quadrant = angle_turn16 >> 14;
    const int32_t within = angle_turn16 & 0x3fff;
    const bool folded = within > 0x2000; /* beyond an eighth of a turn: the series of the complement is shorter */
    const int32_t part = folded ? 0x4000 - within : within;
    /* radians in Q30: part / 2^14 quarter turns, pi/2 = 1686629713 / 2^30 */
    const int32_t x = (int32_t)((multiply_wide_s32(part, 1686629713) + (1 << 13)) >> 14);
    const int32_t xx = glint_multiply_q30(x, x);
    /* Taylor: x <= pi/4, so the first terms left out are below x^13/13! < 2^-36 and x^14/14! < 2^-41 */
    int32_t sine = one, cosine = one;
    for (int n = 10; n >= 2; n -= 2) {
        sine = one - (int32_t)divide_u32((uint32_t)glint_multiply_q30(xx, sine), (uint32_t)(n * (n + 1)));
    }
    for (int n = 12; n >= 2; n -= 2) {
        cosine = one - (int32_t)divide_u32((uint32_t)glint_multiply_q30(xx, cosine), (uint32_t)(n * (n - 1)));
    }
    sine = glint_multiply_q30(x, sine);
    GLINT_TRACE("sine q30", sine);
    GLINT_TRACE("cosine q30", cosine);
    const int32_t s = folded ? cosine : sine, c = folded ? sine : cosine;
    *sine_q30 = quadrant == 0 ? s : quadrant == 1 ? c : quadrant == 2 ? -s : -c;
    *cosine_q30 = quadrant == 0 ? c : quadrant == 1 ? -s : quadrant == 2 ? -c : s;
}

uint32_t glint_square_root_u32(uint32_t x)
{
    if (x == 0) {
        return 0;
    }
    /* s = x 2^up in [2^30, 2^32): sqrt(s / 2^30) = (s / 2^30) / sqrt(s / 2^30) */
    const int up = clz32(x) & ~1;
    const uint32_t s = x << up;
    return ((s >> 16) * inverse_root_q16(s)) >> (15 + up / 2);
}

uint32_t glint_square_root_u64(uint64_t x)
{
    /* bit by bit, from the highest */
    const uint32_t high = (uint32_t)(x >> 32), low = (uint32_t)x;
    uint32_t root = 0;
    for (uint32_t bit = (uint32_t)1 << 31; bit; bit >>= 1) {
        const uint32_t more = root | bit, square_high = multiply_high_u32(more, more);
        if (square_high < high || (square_high == high && more * more <= low)) {
            root = more;
        }
    }
    return root;
}

bool glint_unit_q30(const int64_t v[3], int32_t unit_q30[3])
{
    uint64_t any = 0;
    for (int k = 0; k < 3; k++) {
        any |= magnitude64(v[k]);
    }
    if (any == 0) {
        return false;
    }
    /* the largest component to 30 bits: squares below 2^60, their sum below 2^62 */
    const int shift = 30 - bit_length64(any);
    uint64_t sum = 0;
    for (int k = 0; k < 3; k++) {
        const int32_t w = (int32_t)glint_shift_round64(v[k], shift);
        sum += (uint64_t)multiply_wide_s32(w, w);
        unit_q30[k] = w;
    }
    GLINT_TRACE("unit q30 sum of squares", sum);
    /* four times the square doubles the root, which then has 31 bits */
    const glint_scaled inverse = glint_scaled_inverse(glint_scaled_from(glint_square_root_u64(sum << 2), 1));
    const int down = inverse.f - 30 - 1; /* 28..30: |w| is between 2^29 and 2^30 sqrt(3) */
    for (int k = 0; k < 3; k++) {
        const int64_t component = ((multiply_wide_s32(unit_q30[k], inverse.m) >> down) + 1) >> 1;
        GLINT_TRACE("unit vector q30", component);
        unit_q30[k] = (int32_t)component;
    }
    return true;
}

glint_scaled glint_scaled_from(uint64_t value, int fraction)
{
    const int up = 31 - bit_length64(value);
    const glint_scaled scaled = {(int32_t)(up >= 0 ? value << up : value >> -up), (int16_t)(fraction + up)};
    GLINT_TRACE("scaled mantissa", scaled.m);
    GLINT_TRACE("scaled exponent", fraction + up);
    return scaled;
}

glint_scaled glint_scaled_inverse(glint_scaled x)
{
    /* x = 2m 2^-(f+1); 1/x = 2^62/(2m) 2^(f+1-62) */
    const uint32_t r = glint_reciprocal_q31((uint32_t)x.m << 1), most = ((uint32_t)1 << 31) - 4;
    return glint_scaled_from(r < most ? r : most, 61 - x.f);
}

glint_scaled glint_scaled_times(glint_scaled x, uint32_t factor, int fraction)
{
    return glint_scaled_from((uint64_t)(uint32_t)x.m * factor, x.f + fraction);
}
