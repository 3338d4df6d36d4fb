/* SPDX-License-Identifier: MIT */
#include "number/real.h"

#include "number/integer.h"

/* The bits of 2^exponent, exponent within -126..127; 128 gives those of infinity. */
#define BITS_OF_TWO_TO(exponent) ((uint32_t)(127 + (exponent)) << 23)

#define BITS_OF_NAN 0x7fc00000u

float glint_inverse_root(float x)
{
    /* Seed from the halved exponent (the constant and its 3.4 % error: C. Lomont, "Fast inverse square root", 2003),
     * then Newton steps y (3 - x y^2) / 2, each of which squares the error times 3/2: 1.8e-3, 4.7e-6, rounding. */
    float y = float_from_bits(0x5f375a86u - (bits_from_float(x) >> 1));
    for (int step = 0; step < 3; step++) {
        y += 0.5f * y * (1.0f - x * y * y);
    }
    return y;
}

float glint_square_root(float x)
{
    const uint32_t bits = bits_from_float(x);
    if (bits >= BITS_OF_TWO_TO(128) || bits == 0) { /* negative, infinite, NaN, zero */
        return x < 0.0f ? float_from_bits(BITS_OF_NAN) : x;
    }
    /* x = m 2^(exponent - 23), 2^23 <= m < 2^24; then an even exponent and 2^23 <= m < 2^25 */
    const int up = bits >> 23 ? 0 : clz32(bits) - 8; /* of a denormal number */
    int exponent = (bits >> 23 ? (int)(bits >> 23) : 1 - up) - 127;
    uint32_t m = bits >> 23 ? (bits & 0x7fffff) | 0x800000 : bits << up;
    if (exponent & 1) {
        m <<= 1;
        exponent--;
    }
    /* Digit by digit to floor(sqrt(m 2^25)), in [2^24, 2^25): one digit more than the result holds. `twice` is twice
     * the root so far, `rest` what is left of m in the scale of the digit. */
    uint32_t twice = 0, rest = m << 1;
    for (uint32_t digit = (uint32_t)1 << 24; digit; digit >>= 1) {
        if (twice + digit <= rest) {
            rest -= twice + digit;
            twice += digit << 1;
        }
        rest <<= 1;
    }
    /* To nearest by the last digit alone: a root of just 25 digits has a square of 49 or 50, so no x is half way. This
     * does not carry into the exponent: m <= 2^25 - 2, so the root is at most 2^25 - 2. */
    return float_from_bits((((twice >> 1) + 1) >> 1) - ((uint32_t)1 << 23) + BITS_OF_TWO_TO(exponent / 2));
}

bool glint_unit(const float v[3], float unit[3])
{
    uint32_t greatest = 0; /* magnitudes are in the order of their bits, NaN above infinity */
    for (int k = 0; k < 3; k++) {
        const uint32_t magnitude = bits_from_float(v[k]) & 0x7fffffff;
        greatest = magnitude > greatest ? magnitude : greatest;
    }
    if (greatest >= BITS_OF_TWO_TO(128)) {
        return false;
    }
    /* The greatest component comes to [2^-49, 2^63), without rounding: the sum of squares stays below 3 2^126, and what
     * underflows in it is below 2^-50 of it. */
    float x = v[0], y = v[1], z = v[2];
    if (greatest < BITS_OF_TWO_TO(-40) || greatest >= BITS_OF_TWO_TO(63)) {
        const float scale = float_from_bits(greatest < BITS_OF_TWO_TO(0) ? BITS_OF_TWO_TO(100) : BITS_OF_TWO_TO(-65));
        x *= scale;
        y *= scale;
        z *= scale;
    }
    const float square = x * x + y * y + z * z;
    if (!(square > 0.0f)) {
        return false;
    }
    const float inverse = glint_inverse_root(square);
    unit[0] = x * inverse;
    unit[1] = y * inverse;
    unit[2] = z * inverse;
    return true;
}

void glint_sine_cosine(uint16_t angle_turn16, float *sine, float *cosine)
{
    const unsigned quadrant = angle_turn16 >> 14;
    const int32_t within = angle_turn16 & 0x3fff;
    const bool folded = within > 0x2000; /* beyond an eighth of a turn: the series of the complement is shorter */
    const int32_t part = folded ? 0x4000 - within : within;
    /* radians in Q24: 512 pi = 1608 + 0.495438638 a part; the product with 1608 is below 2^24, so `high` is exact */
    const int32_t high_q24 = part * 1608;
    const float high = (float)high_q24 * 0x1p-24f, low = (float)part * (0.495438638f * 0x1p-24f);
    const float x = high + low, xx = x * x;
    /* Taylor, x <= pi/4: the first terms left out are below x^11/11! < 2^-29 and x^12/12! < 2^-33 */
    const float s =
        high + (low - x * (xx * (1.0f / 6 - xx * (1.0f / 120 - xx * (1.0f / 5040 - xx * (1.0f / 362880))))));
    /* x = a + b, a of 11 bits: so 1 - a^2 / 2 is exact, and before the end only what is small is rounded */
    const float a = (float)(high_q24 >> 13) * 0x1p-11f, b = (float)(high_q24 & 0x1fff) * 0x1p-24f + low;
    const float rest = xx * xx * (1.0f / 24 - xx * (1.0f / 720 - xx * (1.0f / 40320 - xx * (1.0f / 3628800))));
    const float c = (1.0f - 0.5f * a * a) + (rest - b * (a + 0.5f * b));
    const float to_sine = folded ? c : s, to_cosine = folded ? s : c;
    /* 0 - s, not -s: so that no zero is negative */
    *sine = quadrant == 0 ? to_sine : quadrant == 1 ? to_cosine : quadrant == 2 ? 0.0f - to_sine : 0.0f - to_cosine;
    *cosine = quadrant == 0 ? to_cosine : quadrant == 1 ? 0.0f - to_sine : quadrant == 2 ? 0.0f - to_cosine : to_sine;
}

float glint_power(float gap, float exponent)
{
    if (exponent == 0.0f || gap <= 0.0f) {
        return 1.0f;
    }
    if (gap >= 1.0f) {
        return 0.0f;
    }
    /* As glint_power_q15: x = 2^-k (1 - y) with y in [0, 1/2]. k is the number of halvings that take 1 to x. */
    float y = gap, k = 0.0f;
    if (gap > 0.5f) {
        const uint32_t bits = bits_from_float(1.0f - gap); /* exact: gap in [1/2, 1] */
        k = (float)(126 - (int32_t)(bits >> 23));
        y = 1.0f - float_from_bits((bits & 0x7fffff) | (uint32_t)126 << 23);
    }
    /* -log2(1 - y) = 2 atanh(z) / ln 2 with z = y / (2 - y) <= 1/3: odd series to z^13, first left out 2 z^15 / 15 ln 2
     */
    const float z = y / (2.0f - y), zz = z * z;
    const float series =
        1.0f +
        zz * (1.0f / 3 + zz * (1.0f / 5 + zz * (1.0f / 7 + zz * (1.0f / 9 + zz * (1.0f / 11 + zz * (1.0f / 13))))));
    const float t = exponent * (k + 2.88539008f * z * series); /* 2 / ln 2; t may be infinite or NaN */
    if (!(t < 40.0f)) {
        return 0.0f;
    }
    /* 2^-t = 2^-whole e^(-u), u = ln 2 fraction <= 0.6931: Taylor to u^9, first left out below 1e-8 */
    const int32_t whole = (int32_t)t;
    const float u = 0.693147181f * (t - (float)whole);
    const float e =
        1.0f -
        u * (1.0f -
             u * (1.0f / 2 -
                  u * (1.0f / 6 -
                       u * (1.0f / 24 -
                            u * (1.0f / 120 -
                                 u * (1.0f / 720 - u * (1.0f / 5040 - u * (1.0f / 40320 - u * (1.0f / 362880)))))))));
    return e * float_from_bits((uint32_t)(127 - whole) << 23);
}
