/* SPDX-License-Identifier: MIT */
#include "number/real.h"

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
    const float t = exponent * (k + 2.88539008f * z * series); /* 2 / ln 2 */
    if (t >= 40.0f) {
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
