/* SPDX-License-Identifier: MIT */
#include <glint/place.h>

#include "geometry/place.h"
#include "number/fixed.h"

#define ONE_Q16 ((int32_t)1 << 16)

void glint_linear_of(const glint_place *place, int32_t linear_q16[3][3])
{
    bool zero = true;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            linear_q16[i][k] = place->linear_q16[i][k];
            zero = zero && linear_q16[i][k] == 0;
        }
    }
    for (int i = 0; zero && i < 3; i++) {
        linear_q16[i][i] = ONE_Q16;
    }
}

static glint_place turn(uint16_t angle_turn16, int from, int to)
{
    glint_place place = {{{0}}, {0}};
    int32_t sine_q30, cosine_q30;
    glint_sine_cosine_q30(angle_turn16, &sine_q30, &cosine_q30);
    const int32_t sine_q16 = (sine_q30 + (1 << 13)) >> 14, cosine_q16 = (cosine_q30 + (1 << 13)) >> 14;
    const int axis = 3 - from - to;
    place.linear_q16[axis][axis] = ONE_Q16;
    place.linear_q16[from][from] = cosine_q16;
    place.linear_q16[to][to] = cosine_q16;
    place.linear_q16[to][from] = sine_q16;
    place.linear_q16[from][to] = -sine_q16;
    return place;
}

glint_place glint_turn_x(uint16_t angle_turn16)
{
    return turn(angle_turn16, 1, 2);
}

glint_place glint_turn_y(uint16_t angle_turn16)
{
    return turn(angle_turn16, 2, 0);
}

glint_place glint_turn_z(uint16_t angle_turn16)
{
    return turn(angle_turn16, 0, 1);
}

glint_place glint_scale(int32_t x_q16, int32_t y_q16, int32_t z_q16)
{
    const glint_place place = {{{x_q16, 0, 0}, {0, y_q16, 0}, {0, 0, z_q16}}, {0, 0, 0}};
    return place;
}

glint_place glint_shift(int32_t x_q16, int32_t y_q16, int32_t z_q16)
{
    const glint_place place = {{{ONE_Q16, 0, 0}, {0, ONE_Q16, 0}, {0, 0, ONE_Q16}}, {x_q16, y_q16, z_q16}};
    return place;
}

/* row . column in Q16 of two Q16 vectors, plus an addend in Q16. Each product is below 2^62 in magnitude, so it is cut
 * by two bits before the sum: this adds less than 3 2^-14 ulp. */
static int32_t row_times(const int32_t row[3], const int32_t column[3], int32_t plus)
{
    int64_t sum = 0;
    for (int j = 0; j < 3; j++) {
        sum += ((int64_t)row[j] * column[j]) >> 2;
    }
    GLINT_TRACE("place sum", sum);
    return saturate_s32(((sum + (1 << 13)) >> 14) + plus);
}

glint_place glint_then(const glint_place *first, const glint_place *second)
{
    int32_t a[3][3], b[3][3];
    glint_place place = {.origin_q16 = {0}};
    glint_linear_of(first, a);
    glint_linear_of(second, b);
    for (int k = 0; k < 4; k++) { /* three columns and the origin */
        int32_t column[3];
        for (int j = 0; j < 3; j++) {
            column[j] = k < 3 ? a[j][k] : first->origin_q16[j];
        }
        for (int i = 0; i < 3; i++) {
            const int32_t entry = row_times(b[i], column, k < 3 ? 0 : second->origin_q16[i]);
            *(k < 3 ? &place.linear_q16[i][k] : &place.origin_q16[i]) = entry;
        }
    }
    return place;
}
