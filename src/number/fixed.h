/* SPDX-License-Identifier: MIT */
/*
 * Fixed-point routines: reciprocal, unit vector, power; and the 64-bit ones that set-up uses once a frame or an object.
 *
 * The errors stated here are derived again by tests/unit/test_number.c.
 */
#ifndef GLINT_NUMBER_FIXED_H
#define GLINT_NUMBER_FIXED_H

#include <stdbool.h>
#include <stdint.h>

#include "number/integer.h"

/*
 * Reciprocal: 2^62 / x for a normalised x, 2^31 <= x < 2^32; so 1/(x/2^31) in Q31.
 * Result in [2^30, 2^31 - 1]. Relative error at most 2^-27.8. Table of 64 cells and two Newton steps, r += r (1 - x r).
 */
uint32_t glint_reciprocal_q31(uint32_t x_q31);

/*
 * The unit vector along v, each component in Q15 (32768 is 1). v is any vector of int32 components, INT32_MIN included,
 * in any scale; `unit` may be `v`. Returns false, with `unit` untouched, for the zero vector. Error of a component at
 * most 1.22 ulp of Q15 (0.61 ulp of Q14). The largest component is brought to 16 bits, so a sum of three squares over 4
 * fits 32 bits; 1/sqrt by a table of 24 cells and two Newton steps; every product fits 32 bits.
 */
bool glint_unit_q15(const int32_t v[3], int32_t unit[3]);

/*
 * As glint_unit_q15, in Q28 with an error of at most 4 ulp of Q28: for where two unit vectors nearly cancel. Some three
 * times the cost; of products of 32 x 32 bits it takes the upper half only.
 */
bool glint_unit_q28(const int32_t v[3], int32_t unit[3]);

/*
 * (1 - gap)^exponent in Q15: gap_q31 = 2^31 (1 - x) for x in [0, 1], so that a cosine x near 1 keeps its precision;
 * gap_q31 <= 2^31. exponent_q4 is the exponent in sixteenths, any 16-bit value.
 * Error at most 0.0002 (0.05 code of 1/255) for any exponent. 0 for x = 0, unless the exponent is 0: then 1.
 *
 * x^a = 2^(-a t), t = -log2(x) = k - log2(2^k x) with 2^k x in [1/2, 1]: 2^k x = 1 - y gives t = k + y P(y), where
 * P(y) = -log2(1 - y) / y is smooth and comes from a table. So t keeps its relative precision as x nears 1, which a
 * large exponent needs. Then 2^-fraction from a second table.
 */
uint16_t glint_power_q15(uint32_t gap_q31, uint16_t exponent_q4);

/* Sine and cosine of an angle in 1/65536 turn, Q30. Error at most 2 ulp of Q30. */
void glint_sine_cosine_q30(uint16_t angle_turn16, int32_t *sine_q30, int32_t *cosine_q30);

/* floor(sqrt(x)), exact. */
uint32_t glint_square_root_u64(uint64_t x);

/*
 * The unit vector along v in Q30, |v[k]| <= 2^62; the zero vector stays as it is and gives false. Error at most 6 ulp
 * of Q30. For set-up: uses 64-bit products.
 */
bool glint_unit_q30(const int64_t v[3], int32_t unit_q30[3]);

/*
 * A positive number m 2^-f with a mantissa of 31 bits, 2^30 <= m < 2^31. For quantities whose range is not known before
 * set-up, such as the focal length.
 */
typedef struct glint_scaled {
    int32_t m;
    int16_t f;
} glint_scaled;

/* value 2^-fraction as a glint_scaled, rounded down; value > 0. */
glint_scaled glint_scaled_from(uint64_t value, int fraction);

/* 1 / x. Relative error at most 2^-27.8. */
glint_scaled glint_scaled_inverse(glint_scaled x);

#endif
