/* SPDX-License-Identifier: MIT */
/*
 * Fixed-point routines: reciprocal, unit vector, power; and the 64-bit ones that set-up uses once a frame or an object.
 *
 * The errors stated here are derived again by tests/unit/test_number.c and test_number_unit.c.
 */
#ifndef GLINT_NUMBER_FIXED_H
#define GLINT_NUMBER_FIXED_H

#include <stdbool.h>
#include <stdint.h>

#include "number/integer.h"

/*
 * Reciprocal: 2^62 / x for a normalised x, 2^31 <= x < 2^32; so 1/(x/2^31) in Q31.
 * Result in [2^30, 2^31 - 1]. Relative error at most 2^-28.3. Table of 64 cells and two Newton steps, r += r (1 - x r),
 * of six 16 x 16 bit products. It errs to either side.
 */
uint32_t glint_reciprocal_q31(uint32_t x_q31);

/* 1/sqrt(x) for x of 2^30..2^32 - 1 in Q30: 32768..65535 in Q16, 65535 standing for 1. See fixed.c for the error. */
uint32_t glint_inverse_root_q16(uint32_t x_q30);

/*
 * The unit vector along v, each component in Q15 (32768 is 1). v is any vector of int32 components, INT32_MIN included,
 * in any scale; `unit` may be `v`. Returns false, with `unit` untouched, for the zero vector. A zero component stays
 * zero. -v gives the negative, component by component, but for INT32_MIN, whose negative is no int32.
 *
 * Error of a component at most 1.58 ulp of Q15 (0.79 of Q14): 1/2 for rounding, and what the root's error and the bits
 * dropped add up to for a component of 0.8 to 0.95 beside two about equal ones, just where the length is worst for the
 * root. The worst found is 1.545, at v = (1922400256, 648904703, 650313727).
 * Error of a component with GLINT_SMALL_TABLES at most 1.22 ulp of Q15 (0.61 of Q14), greatest for a component of 0.41
 * beside one of 0.89 that is just above a power of two. The worst found is 1.205, at v = (493748223, 204537856,
 * 1074659328).
 * The length is within 1.86 ulp of 1, with GLINT_SMALL_TABLES within 1.38. A vector along an axis has one component of
 * 32767 to 32769, with GLINT_SMALL_TABLES of 32768 exactly.
 *
 * Overflow: none. The largest component is brought to 16 bits, so that w (w + 1) fits 32 bits, and a sum of three over
 * 4 as well: below 3 2^30. A component times the inverse root is at most (2^16 - 1)^2, and what is added to round it
 * below 2^16 + 2^15.
 */
bool glint_unit_q15(const int32_t v[3], int32_t unit[3]);

/*
 * As glint_unit_q15, in Q28 with an error of at most 2.65 ulp of Q28: for where two unit vectors nearly cancel. Some
 * three times the cost; of products of 32 x 32 bits it takes the upper half only. The worst found is 2.47, where the
 * largest component is just above a power of two and the others are small: there the bits that the sum of squares loses
 * weigh most. The bound holds for either table.
 * Overflow: none. Upper halves of squares over 4 add up to less than 3 2^30; the residual of the root is below 2^-14
 * and taken times 8 in Q28; the root ends below 2^31 (1 + 2^-27).
 */
bool glint_unit_q28(const int32_t v[3], int32_t unit[3]);

/*
 * (1 - gap)^exponent in Q15: gap_q31 = 2^31 (1 - x) for x in [0, 1], so that a cosine x near 1 keeps its precision;
 * gap_q31 <= 2^31. exponent_q4 is the exponent in sixteenths, any 16-bit value. 0 for x = 0, unless the exponent is 0:
 * then 1.
 *
 * Error at most 0.00016 (0.041 code of 1/255) for any exponent; with GLINT_SMALL_TABLES at most 0.00034 (0.087 code).
 * The worst found are 0.000138 and 0.000308, for exponents of some 4000 and results of 0.967 and 0.979: in the middle
 * of one of the first cells of the table of 2^-fraction, where its chord is farthest from the curve.
 *
 * Overflow: none. y P(y) is at most 1 in Q29, t at most 31 in Q26, a t below 2^17 in Q14; a step within a cell is at
 * most 1389 times a fraction below 2^11.
 *
 * x^a = 2^(-a t), t = -log2(x) = k - log2(2^k x) with 2^k x in [1/2, 1]: 2^k x = 1 - y gives t = k + y P(y), where
 * P(y) = -log2(1 - y) / y is smooth and comes from a table. So t keeps its relative precision as x nears 1, which a
 * large exponent needs. Then 2^-fraction from a second table.
 */
uint16_t glint_power_q15(uint32_t gap_q31, uint16_t exponent_q4);

/* floor(a b / 2^30), which must fit. For set-up: a 64-bit product, once in the code. */
int32_t glint_multiply_q30(int32_t a, int32_t b);

/* Sine and cosine of an angle in 1/65536 turn, Q30. Error at most 2 ulp of Q30. */
void glint_sine_cosine_q30(uint16_t angle_turn16, int32_t *sine_q30, int32_t *cosine_q30);

/* sqrt(x), too small by at most 2^-13.4 of it and 1, or too large by at most 2^-15 of it. One reciprocal root, for
 * where a bound is enough. */
uint32_t glint_square_root_u32(uint32_t x);

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

/* x times factor 2^-fraction, rounded down; factor > 0. */
glint_scaled glint_scaled_times(glint_scaled x, uint32_t factor, int fraction);

/* 1 / x. Relative error at most 2^-28.3. m is at most 2^31 - 4, so that 2^30 m / 2^31, rounded, is below 2^30. */
glint_scaled glint_scaled_inverse(glint_scaled x);

#endif
