/* SPDX-License-Identifier: MIT */
/*
 * Vectors of the tests in long double.
 */
#ifndef GLINT_TESTS_UNIT_DIRECTIONS_H
#define GLINT_TESTS_UNIT_DIRECTIONS_H

#include "tests/unit/numeric.h"

static inline long double dot3(const long double a[3], const long double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* A unit vector, each direction as likely. */
static inline void random_direction(long double v[3])
{
    long double square;
    do {
        for (int k = 0; k < 3; k++) {
            v[k] = 2 * random_unit() - 1;
        }
        square = dot3(v, v);
    } while (square > 1 || square < 0.01L);
    for (int k = 0; k < 3; k++) {
        v[k] /= sqrtl(square);
    }
}

#endif
