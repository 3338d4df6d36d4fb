/* SPDX-License-Identifier: MIT */
/*
 * Float routines without libm: conversion, floor, square root and its reciprocal, unit vector, power, sine and cosine.
 *
 * float is IEEE 754 single, and an expression of floats is evaluated in float (FLT_EVAL_METHOD 0) and not contracted:
 * then each routine gives the same bits on every processor. Elsewhere (x87, s390x) the errors hold, and the bits of
 * glint_square_root alone. An ulp is the spacing of floats at the exact result. tests/unit/test_real.c and
 * test_number_real.c derive the errors again.
 *
 * There is no reciprocal here: 1.0f / x is it. The division of C is that of IEEE 754, correctly rounded (0.5 ulp for
 * any x; infinity for |x| <= 2^-128). It takes one instruction on an FPU, and without one at most a third of what a
 * seed and three Newton steps take, which do not round correctly either.
 */
#ifndef GLINT_NUMBER_REAL_H
#define GLINT_NUMBER_REAL_H

#include <stdbool.h>
#include <stdint.h>

#include <glint/config.h>

/* A float and its bits. What is read from a union is the stored bits, as the type of the member named (C99 6.5.2.3,
 * footnote 82). memcpy would be a call under -ffreestanding, where a compiler takes no function for granted. */
typedef union float_bits {
    float value;
    uint32_t bits;
} float_bits;

static inline float float_from_bits(uint32_t bits)
{
    const float_bits either = {.bits = bits};
    return either.value;
}

static inline uint32_t bits_from_float(float value)
{
    const float_bits either = {.value = value};
    return either.bits;
}

/*
 * m 2^-fraction for any m; fraction within -96..126.
 * Error: correctly rounded, so at most 0.5 ulp, at |m| = 2^24 + 1.
 * Overflow: none. The power of two is normal, and the result 0 or within 2^-126..2^127; so only the conversion rounds.
 */
static inline float float_from_scaled(int32_t m, int fraction)
{
    return (float)m * float_from_bits((uint32_t)(127 - fraction) << 23);
}

/*
 * The largest integer not above value, -2^31 <= value < 2^31.
 * Error: none. From 2^23 up value is whole, and below that `whole` is exact in float.
 * Overflow: none. Only where value is not whole is 1 subtracted, and then |value| < 2^23.
 */
static inline int32_t float_floor(float value)
{
    const int32_t whole = (int32_t)value;
    return (float)whole > value ? whole - 1 : whole;
}

/*
 * 1/sqrt(x) for a normal x > 0: 2^-126 <= x < 2^128. For another x it is meaningless, but traps nothing.
 * Error: at most 1.22 ulp, at x = 1.000594 4^n (bits 0x3f801375 for n = 0); relative 2^-23.29, at x = 3.4843 4^n.
 * Exact for x = 4^n. For 4^n x it is 2^-n times that for x, bit for bit.
 * Overflow: none. The result is within 2^-64..2^63, and x times it within 2^-63..2^64.
 */
float glint_inverse_root(float x);

/*
 * sqrt(x) for any x, as IEEE 754 has it: denormal x included; -0 for -0, infinity for infinity, NaN for NaN and x < 0.
 * Error: correctly rounded, so below 0.5 ulp, the nearest to it at x = (1 - 2^-24) 4^n. An FPU's instruction gives the
 * same number; this takes integers only, and the same time with and without an FPU.
 * Overflow: none. Intermediates stay below 2^27.
 */
float glint_square_root(float x);

/*
 * The unit vector along v: any finite components, denormal ones and those whose squares overflow included. `unit` may
 * be `v`. Returns false, with `unit` untouched, if all components are zero or any is infinite or NaN; also if all are
 * denormal where the processor takes those for zero.
 * Error of a component: at most 3.3 ulp (of 2^-100 for a component below that). This is 1.48 for the sum of squares and
 * 1.30 for its root, together greatest at a sum of 2.037 4^n, and 0.5 for the product; all for a component just below a
 * power of two, where an ulp is smallest. The worst found is 2.99, at v = (1.000808, 0.000244, 0.000242).
 * The length is within 2.3e-7 of 1; so no component is above 1 + 2^-23.
 * Overflow: none. Components from 2^63 up are first divided by 2^65, so the sum of squares is below 3 2^126.
 */
bool glint_unit(const float v[3], float unit[3]);

/*
 * Sine and cosine of an angle in 1/65536 turn, any. Exact at multiples of a quarter turn, where no zero is negative;
 * equal at an eighth; sine and cosine of angles mirrored at multiples of an eighth have the same bits but for the sign.
 * Error: at most 0.73 ulp, where it is the sine of up to an eighth of a turn, at angle 8139; at most 0.57 ulp where it
 * is the cosine, at 7901. The sum of the squares is within 1e-7 of 1.
 * Overflow: none. The integers stay below 2^24, the argument of the series is at most pi/4.
 */
void glint_sine_cosine(uint16_t angle_turn16, float *sine, float *cosine);

/*
 * (1 - gap)^exponent, in 0..1, for exponent >= 0, infinity included, and gap within 0..1 or beyond, which counts as the
 * nearer end. 0 for gap = 1 unless the exponent is 0: then 1 for any gap. 0 for what is below 2^-40. A NaN gap counts
 * as 1, a NaN exponent as infinity.
 * Error: at most 2e-7, 3.4 ulp of a result in [1/2, 1); the worst found is 1.51e-7, at gap 0.00669, exponent 92. A
 * smaller result 2^-t carries the error of t besides: at most 4.5 (1 + t) ulp, the sum of all roundings; the worst
 * found is 3.06 (1 + t), at gap 0.3151, exponent 71.5625.
 * Overflow: none. t may become infinite; it is below 40 where it is made an integer.
 */
float glint_power(float gap, float exponent);

#endif
