/* SPDX-License-Identifier: MIT */
/*
 * Small vectors in double precision, and their rounding to the formats of the scene.
 */
#include "tools/import/internal.h"

#ifdef GLINT_HAVE_ASSIMP

#include <math.h>

double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length3(const double a[3])
{
    /* hypot, since squares of what a file may hold overflow */
    return hypot(hypot(a[0], a[1]), a[2]);
}

void cross3(const double a[3], const double b[3], double result[3])
{
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}

bool normalise3(double a[3])
{
    double length = length3(a);
    if (!(length > 0)) {
        return false;
    }
    for (int k = 0; k < 3; k++) {
        a[k] /= length;
    }
    return true;
}

double to_fixed(double value, double one, double limit)
{
    double rounded = floor(value * one + 0.5);
    return fmax(-limit, fmin(limit, rounded));
}

void to_direction(const double direction[3], int16_t result[3])
{
    double greatest = fmax(fabs(direction[0]), fmax(fabs(direction[1]), fabs(direction[2])));
    for (int k = 0; k < 3; k++) {
        result[k] = (int16_t)to_fixed(direction[k] / greatest, INT16_MAX, INT16_MAX);
    }
}

#endif
