/* SPDX-License-Identifier: MIT */
#include "lighting/bound.h"

#include "number/fixed.h"
#include "number/tables.h"

#define ONE_Q16 65536u
#define HALF_CODE (GLINT_CODE_UNITS / 2)

uint8_t glint_curve_class(uint32_t y_q16)
{
    uint8_t class = 0;
    while (class < GLINT_CURVE_CLASSES && y_q16 > flash_u16(&glint_curve_limit_q16[class])) {
        class ++;
    }
    return class;
}

void glint_curve_of(uint8_t class, uint8_t degree, glint_curve *curve)
{
    const uint16_t *entry = &glint_curves[(class * GLINT_CURVE_DEGREES + degree) * 4];
    for (int k = 0; k < 3; k++) {
        curve->c_q15[k] = flash_u16(&entry[k]);
    }
    curve->error_q16 = flash_u16(&entry[3]);
}

/* sqrt(exponent + 1.72) in Q4 of the root of sixteenths, rounded up: 0.607 of it is the greatest slope of cos^exponent
 * for exponents from 1 on, where it is sqrt(a) (1 - 1/a)^((a-1)/2). */
static uint32_t slope_root_q4(uint16_t exponent_q4)
{
    return glint_square_root_u32(((uint32_t)exponent_q4 + 28) << 8) + 1;
}

uint32_t glint_bound_gloss(uint32_t specular, uint16_t exponent_q4)
{
    /* 0.607 / 4 2.5e-4 = 2.49 / 2^16 */
    return ((specular * slope_root_q4(exponent_q4)) >> 4) * 5 / 131072 + 1;
}

uint32_t glint_bound_precise(uint32_t specular, uint16_t exponent_q4, uint8_t bits)
{
    if (specular == 0) {
        return 0;
    }
    const uint32_t gloss = glint_bound_gloss(specular, exponent_q4);
    return gloss + (gloss * 9 >> 5) + 1 + glint_bound_gloss_error(specular, exponent_q4, bits) +
           (multiply_high_u32(specular << 8, exponent_q4) >> 3);
}

uint32_t glint_bound_fine(uint32_t specular, uint16_t exponent_q4, uint8_t bits)
{
    return specular == 0
               ? 0
               : glint_bound_gloss(specular, exponent_q4) / 6 + (multiply_high_u32(specular << 8, exponent_q4) >> 3) +
                     2 + glint_bound_gloss_error(specular, exponent_q4, bits);
}

uint32_t glint_bound_turned(uint32_t specular, uint16_t exponent_q4)
{
    /* 2 0.607 / 4 = 0.3035; / 16: 1244 / 2^16 */
    return multiply_high_u32(specular << 8, (slope_root_q4(exponent_q4) * 1244) << 8) + 1;
}

uint32_t glint_bound_highlight_q15(uint32_t specular, uint16_t exponent_q4)
{
    if (specular <= GLINT_HIGHLIGHT_LEFT) {
        return 0;
    }
    if (exponent_q4 == 0) {
        return GLINT_FAR_Q15;
    }
    /* log2(1 + f) <= f + 0.0861 */
    const int zeros = clz32(specular);
    const uint32_t fraction_q16 = (specular << zeros << 1) >> 16;
    const uint32_t log2_q16 = ((uint32_t)(31 - zeros - 4) << 16) + fraction_q16 + 5643; /* of specular / 16 */
    /* a^2 = 2 ln 2 log2(.) / exponent; 2 ln 2 16 = 22.1808 */
    const int up = clz32(exponent_q4);
    const uint32_t r = glint_reciprocal_q31((uint32_t)exponent_q4 << up); /* 2^62 / (exponent 2^up) */
    const uint32_t quotient_q16 = (multiply_high_u32(log2_q16 << 8, r) >> (38 - up)) + 1;
    const uint32_t square_q16 = quotient_q16 * 22 + (quotient_q16 >> 2);
    return square_q16 >= (uint32_t)16 << 16 ? GLINT_FAR_Q15 : (glint_square_root_u32(square_q16 << 12) << 1) + 4;
}

uint32_t glint_bound_spread_q15(uint32_t chord_q16)
{
    if (chord_q16 > ONE_Q16) {
        return GLINT_FAR_Q15;
    }
    const uint32_t root_q15 = glint_square_root_u32(chord_q16 << 14) + 1;
    /* 1/20 = 3277 / 2^16: the divisions of small processors are calls */
    return ((root_q15 + (((root_q15 * (chord_q16 >> 6)) >> 10) * 3277 >> 16)) * 39322) >> 15; /* 1.2 */
}

uint32_t glint_bound_longer_q15(uint32_t chord_q16)
{
    if (chord_q16 > ONE_Q16) {
        return 32768;
    }
    /* (1 - x)^(-1/2) <= 1 + x / 2 + 0.55 x^2 for x <= 1/3 */
    const uint32_t third_q15 = (chord_q16 * 10923 >> 16) + 1; /* a sixth of Q16 */
    return third_q15 / 2 + ((third_q15 * third_q15 >> 15) * 9 >> 4) + 2;
}

void glint_bound_gloss_table(uint32_t angle_q15, uint8_t *bits, uint16_t *cells)
{
    /* 1 - cos a <= a^2 / 2; Q30 to Q28 */
    const uint32_t square = angle_q15 > 46340 ? (uint32_t)1 << 28 : (angle_q15 * angle_q15) >> 3;
    const uint32_t gap_q28 = square < (uint32_t)1 << 28 ? square : (uint32_t)1 << 28; /* a right angle's */
    *bits = 0;
    while (gap_q28 >> *bits >= GLINT_GLOSS_CELLS) {
        (*bits)++;
    }
    *cells = (uint16_t)((gap_q28 >> *bits) + 1);
}

uint32_t glint_bound_gloss_error(uint32_t specular, uint16_t exponent_q4, uint8_t bits)
{
    /* exponent 2^bits / 2^28, Q16 */
    const uint32_t product_q16 =
        bits >= 16 ? (uint32_t)exponent_q4 << (bits - 16) : (uint32_t)exponent_q4 >> (16 - bits);
    /* below 2 the second derivative has no bound beside a right angle; there a chord errs by less than 1/32 of a cell
     */
    const uint32_t shallow = exponent_q4 < 32 ? (bits > 1 ? specular >> (33 - bits) : 0) + 1 : 0;
    if (product_q16 > 65535) {
        return specular;
    }
    return multiply_high_u32(specular << 8, (product_q16 * product_q16) >> 11) + shallow + 2;
}

uint32_t glint_bound_shows_q15(uint32_t gap_q28, uint32_t error, uint32_t gloss)
{
    /* error / gloss in Q28: 2^62 / (gloss 2^up) */
    const int up = clz32(gloss);
    if (up > 26) {
        return GLINT_FAR_Q15;
    }
    const uint32_t r = glint_reciprocal_q31(gloss << up);
    const uint32_t off_q26 = error > 1023 ? (uint32_t)1 << 26 : multiply_high_u32(error << 22, r) >> (26 - up);
    const uint32_t gap = gap_q28 + (off_q26 < (uint32_t)1 << 26 ? off_q26 << 2 : (uint32_t)1 << 28) + 64;
    if (gap >= (uint32_t)1 << 28) {
        return GLINT_FAR_Q15;
    }
    const uint32_t root_q15 = glint_square_root_u32(gap << 3) + 3; /* sqrt(2 g) in Q15: sqrt(g 2^31) */
    return root_q15 + ((root_q15 * (gap >> 16)) >> 15) + 4;
}

uint32_t glint_bound_per_turn_q20(uint32_t turn_q20)
{
    /* 2^20 2^5 / turn, 2^62 / (turn 2^up) being the reciprocal; less than 2^10 of turn is taken for that */
    const uint32_t turn = turn_q20 < 1024 ? 1024 : turn_q20;
    if (turn > (uint32_t)1 << 25) {
        return 0;
    }
    const int up = clz32(turn) & 31;
    return glint_reciprocal_q31(turn << up) >> (37 - up);
}

int32_t glint_bound_clear(uint32_t gap_q31, uint32_t highlight_q15, uint32_t per_turn_q20)
{
    const uint32_t angle_q15 = glint_square_root_u32(gap_q31); /* sqrt(2 gap), < 2^16 */
    return angle_q15 <= highlight_q15 + 4
               ? 0
               : (int32_t)(((angle_q15 - highlight_q15 - 4) * (per_turn_q20 >> 1)) >> 19); /* < 2^16 2^14 */
}

uint32_t glint_bound_quadratic(uint32_t gloss, uint32_t normal_q20, uint32_t view_q20, int log2)
{
    /* Q12, rounded up; an eighth more for what lies beside the triangle */
    const uint32_t k = (normal_q20 + normal_q20 / 8 + 255) >> 8, v = (view_q20 + 255) >> 8;
    if (k > 300 || v > 300) {
        return UINT32_MAX;
    }
    const uint32_t third_q36 = k * k * (12 * k + 12 * v) + v * v * (10 * k + 20 * v); /* <= 54 300^3 < 2^31 */
    if (third_q36 >> (31 - 3 * log2) != 0) {
        return UINT32_MAX;
    }
    /* 0.0642 / 2^4 = 263 / 2^16 */
    const uint32_t error = multiply_high_u32(gloss, third_q36 << (3 * log2));
    return error > (uint32_t)1 << 20 ? UINT32_MAX : ((error * 263) >> 16) + 1;
}

uint32_t glint_bound_curve(uint32_t diffuse, uint32_t turn_q16)
{
    const uint32_t square_q16 = (turn_q16 * turn_q16 >> 16) + 1; /* turn < 2^16 */
    const uint32_t cube_q16 = (square_q16 * turn_q16 >> 16) + 1; /* < 0.33 up to the greatest turn served */
    /* 0.0262 = 1717 / 2^16, 1.2e-5 = 13 / 2^20; the product below 2^16 2^15.4 */
    return (((((diffuse + 15) >> 4) * cube_q16 >> 12) + 1) * 1717 >> 16) + (diffuse * 13 >> 20) + 1;
}

uint32_t glint_bound_cubic(const glint_cubic_size *size, uint32_t gloss, uint32_t specular, uint32_t turn_q16)
{
    const uint32_t n = size->reach, view_q16 = size->view_q16;
    const uint32_t way = size->anchor_reach + 5;
    if (n > 255 || way > 4095 || size->up < 2 || view_q16 > 32768 || gloss >> 24 != 0 || size->part_q15 > 10924 ||
        size->inverse_q22 >> 20 != 0) {
        return UINT32_MAX;
    }
    const uint32_t square_q16 = (turn_q16 * turn_q16 >> 16) + 1;
    /* the polynomial's error: view^2 0.011 (turn^2 + 4/3 turn view + 5/8 view^2) */
    const uint32_t across_q16 = (view_q16 * ((4 * turn_q16 / 3) + (5 * view_q16 >> 3)) >> 16) + 1; /* < 0.7 */
    const uint32_t bent_q28 =
        (((view_q16 * view_q16 >> 16) + 1) * ((square_q16 + across_q16) >> 2) >> 2) * 23 / 2048 + 1;
    /* units of each term: 1/2 + 3 2^(8 - 3 up), 1/2 + 3 2^(6 - 2 up), 1/2 + 2 2^(5 - up) */
    const uint32_t cube = (n + 3) * n * n / 6, square = n * n / 2 + 1;
    const uint32_t rounding = size->up == 2   ? 13 * cube + 13 * square + 17 * n
                              : size->up == 3 ? 2 * cube + 4 * square + 9 * n
                                              : cube * 3 / 4 + 2 * square + 5 * n;
    if (rounding >> (28 - size->down) != 0) {
        return UINT32_MAX;
    }
    /* a unit is 2^(down - 32) of x/m; m/x is at most 1 + 3/2 part */
    const uint32_t unscaled_q28 = (rounding << size->down) >> 4;
    const uint32_t rounding_q28 =
        unscaled_q28 + multiply_high_u32(unscaled_q28 << 3, (size->part_q15 * 3 / 2) << 14) + 1;
    /* 2^-15 (0.8 + 1.6 part) of the end */
    const uint32_t place_q28 = multiply_high_u32(size->end_q28 << 2, 26215 + size->part_q15 * 8 / 5) + 1;
    const uint32_t gap_q28 = bent_q28 + rounding_q28 + place_q28 + 32;
    const uint32_t times = size->together < gloss && gap_q28 <= GLINT_GAP_OFF_Q28 ? size->together : gloss;
    const uint32_t of_gap = multiply_high_u32(times << 4, gap_q28) + 1;
    /* 1e-4 is 420 / 2^22 */
    const uint32_t relative_q22 = size->inverse_q22 + ((way * way * 3) >> 9) + 1 + 420;
    return of_gap + (multiply_high_u32(specular << 8, relative_q22 << 2)) + 1;
}

/*
 * Without weights, interpolation is affine instead of perspective-correct, which moves barycentric coordinates by at
 * most (sqrt(r) - 1) / (sqrt(r) + 1) <= (r - 1) / 4 for a ratio of depths r, and the normal by that times sqrt(D) /
 * sqrt(1 - D/3). Does the cosine's error, times `turned`, stay within 1/16 code?
 */
static bool affine_serves(uint32_t turned, uint32_t chord_q16, uint32_t rise_q16)
{
    if (rise_q16 == 0 || chord_q16 == 0) {
        return true;
    }
    if (rise_q16 > ONE_Q16 / 2 || chord_q16 > ONE_Q16 || turned >> 20 != 0) {
        return false;
    }
    /* (turned (r - 1) / 4)^2 D <= 16^2 (1 - D/3), and D <= 1: 2/3 for the last factor; rounded up, 2^16 2^15 */
    const uint32_t moved = (((turned >> 4) + 1) * rise_q16 >> 14) + 1;
    return moved < 1024 && ((moved * moved + 15) >> 4) * ((chord_q16 + 15) >> 4) <= 170u << 8;
}

/*
 * The weights of the corners: by their depths, or all 1 where that errs by no more than *affine, 1/256 code. Returns
 * the least weight, Q16.
 *
 * r - 1 = (1 - u) / u, u the least weight; below 3/2 of 1 - u up to 1/3.
 */
static uint32_t weigh_corners(const glint_bound *bound, const int32_t inverse_depth[3], glint_choice *choice,
                              uint32_t *affine)
{
    int32_t low = inverse_depth[0], high = low;
    for (int i = 1; i < 3; i++) {
        low = inverse_depth[i] < low ? inverse_depth[i] : low;
        high = inverse_depth[i] > high ? inverse_depth[i] : high;
    }
    choice->weight_q15[0] = choice->weight_q15[1] = choice->weight_q15[2] = 32768;
    *affine = 0;
    if ((low == high && low > 0) || bound->chord_q16 == 0) {
        return ONE_Q16;
    }
    /* 1/high = r 2^(zeros - 62) */
    const uint32_t divisor = high > 0 ? (uint32_t)high : 1;
    const int zeros = clz32(divisor) & 31;
    const uint32_t r = glint_reciprocal_q31(divisor << zeros);
    const uint32_t least_q30 = multiply_high_u32((uint32_t)positive_part(low) << zeros, r), least_q16 = least_q30 >> 14;
    const uint32_t drop_q16 = ONE_Q16 - least_q16;
    if (affine_serves(bound->turned, bound->chord_q16, drop_q16 + drop_q16 / 2)) {
        *affine = 16; /* 1/16 code */
        return ONE_Q16;
    }
    for (int i = 0; i < 3; i++) { /* the nearest corner's stays 1 */
        if (inverse_depth[i] != high) {
            const uint32_t u_q30 = inverse_depth[i] == low
                                       ? least_q30
                                       : multiply_high_u32((uint32_t)positive_part(inverse_depth[i]) << zeros, r);
            choice->weight_q15[i] = (uint16_t)((u_q30 + (1 << 14)) >> 15);
        }
    }
    return least_q16;
}

void glint_bound_choose(const glint_bound *bound, const int32_t inverse_depth[3], uint8_t tolerance, uint8_t least,
                        uint8_t greatest, glint_choice *choice)
{
    const uint32_t most = tolerance == 0 ? UINT32_MAX : (uint32_t)tolerance * (GLINT_CODE_UNITS / 16);
    choice->tier = GLINT_TIER_EXACT;
    choice->promise = bound->exact > UINT16_MAX ? UINT16_MAX : (uint16_t)bound->exact;
    if (bound->diffuse == 0) {
        const uint32_t unlit = HALF_CODE + glint_bound_rounding(0, 1) + bound->left;
        if (unlit <= most && unlit <= UINT16_MAX) {
            choice->tier = GLINT_TIER_UNLIT;
            choice->promise = (uint16_t)unlit;
        }
        return;
    }
    if (tolerance != 0 && bound->flat <= most) {
        choice->tier = GLINT_TIER_FLAT;
        choice->promise = (uint16_t)bound->flat;
        return;
    }
    uint32_t affine;
    const uint32_t weight_q16 = weigh_corners(bound, inverse_depth, choice, &affine);
    choice->turn_q16 = ONE_Q16;
    /* y up to 1 - u^2 (1 - D/3), and 16 units for stored normals that are shorter than 1; D/3 rounded up */
    const uint32_t third = bound->chord_q16 < 2 * ONE_Q16 ? ((bound->chord_q16 * 21846) >> 16) + 1 : ONE_Q16;
    const uint32_t rest = third < ONE_Q16 ? ONE_Q16 - third : 0;
    /* u^2 (1 - D/3), rounded down: below 2^31 / 2^15 times 2^15 */
    const uint32_t square = weight_q16 == ONE_Q16 ? rest : (weight_q16 * (weight_q16 >> 1) >> 15) * (rest >> 1) >> 15;
    const uint32_t y_q16 = ONE_Q16 - square + 16;
    if (least <= GLINT_TIER_CURVED && greatest >= GLINT_TIER_CURVED) {
        /* edges of M up to sqrt(D + (1 - u)^2) */
        const uint32_t part_q16 = weight_q16 == ONE_Q16 ? 0 : ONE_Q16 - weight_q16 + 1;
        const uint32_t edge_q16 = bound->chord_q16 + (part_q16 < ONE_Q16 ? (part_q16 * part_q16 >> 16) + 1 : ONE_Q16);
        if (y_q16 <= ONE_Q16 / 2 && edge_q16 < ONE_Q16 / 2) {
            /* 1 / (1 - y) <= 1 + y + 2 y^2 for y <= 1/2 */
            const uint32_t inverse_q12 = ((ONE_Q16 + y_q16 + (y_q16 * y_q16 >> 15)) >> 4) + 1;
            const uint32_t square_q16 = (edge_q16 * inverse_q12 >> 12) + 1;
            choice->turn_q16 = square_q16 < ONE_Q16 / 2 ? glint_square_root_u32(square_q16 << 16) + 1 : ONE_Q16;
        }
        if (choice->turn_q16 + bound->point_turn_q16 <= GLINT_TURN_MOST_Q16) {
            uint32_t error = HALF_CODE + bound->fixed + bound->curve_reach + affine +
                             (bound->left > bound->gloss ? bound->left : bound->gloss) +
                             glint_bound_curve(bound->diffuse - bound->point_diffuse, choice->turn_q16);
            if (bound->point_diffuse > 0) {
                error += glint_bound_curve(bound->point_diffuse, choice->turn_q16 + bound->point_turn_q16);
            }
            if (error <= most && error <= UINT16_MAX) {
                choice->tier = GLINT_TIER_CURVED;
                choice->promise = (uint16_t)error;
                return;
            }
        }
    }
    if (bound->point_diffuse > 0) {
        return;
    }
    const uint8_t class = glint_curve_class(y_q16);
    if (class == GLINT_CURVE_CLASSES) {
        return;
    }
    glint_curve_of(class, 0, &choice->curve);
    /* c0 sqrt(1 - y) = 1 - e at the range's end: c0 / (1 - e) <= c0 (1 + e + 5/4 e^2) for e <= 0.18 */
    const uint32_t e_q16 = choice->curve.error_q16;
    choice->longest_q15 =
        choice->curve.c_q15[0] + ((choice->curve.c_q15[0] * (e_q16 + ((e_q16 * e_q16 >> 16) * 5 >> 2) + 1)) >> 16) + 1;
    for (uint8_t degree = 1; degree < GLINT_CURVE_DEGREES; degree++) {
        const uint8_t tier = (uint8_t)(GLINT_TIER_Q1 + degree - 1);
        glint_curve_of(class, degree, &choice->curve);
        if (choice->curve.error_q16 > GLINT_CURVE_MOST_Q16) {
            continue;
        }
        const uint32_t error = HALF_CODE + bound->fixed + bound->reach + affine +
                               (bound->left > bound->gloss ? bound->left : bound->gloss) +
                               (multiply_high_u32(bound->diffuse << 8, (uint32_t)choice->curve.error_q16 << 8) + 1);
        if (tier >= least &&
            (tolerance == 0 || error <= (uint32_t)tolerance * (GLINT_CODE_UNITS / 16) || tier == greatest)) {
            choice->tier = tier;
            choice->promise = error > UINT16_MAX ? UINT16_MAX : (uint16_t)error;
            return;
        }
    }
}
