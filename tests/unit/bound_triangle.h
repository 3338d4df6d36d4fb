/* SPDX-License-Identifier: MIT */
/*
 * Triangles as glint_bound_choose() sees them, and their normals in long double.
 */
#ifndef GLINT_TESTS_UNIT_BOUND_TRIANGLE_H
#define GLINT_TESTS_UNIT_BOUND_TRIANGLE_H

#include "tests/unit/directions.h"
#include "tests/unit/numeric.h"

#include "lighting/bound.h"

#define ONE_Q16 65536.0L
#define HALF_CODE (GLINT_CODE_UNITS >> 1)
#define AFFINE_UNITS 16.0L /* what leaving perspective out may cost: 1/16 code */

/* A triangle as the tiers see it: unit normals in Q15, of the length that rounding left them. */
typedef struct case_triangle {
    long double normal[3][3];
    int32_t inverse_depth[3];
    glint_bound bound;
} case_triangle;

/* Normals that lie apart by anything from a unit of Q15 to beyond a right angle; depths from alike to 1 : 64. */
static inline void random_triangle(case_triangle *t)
{
    long double base[3], chord = 0;
    const long double bend = exp2l(-13 * random_unit()), ratio = exp2l(6 * random_unit() * random_unit());
    random_direction(base);
    for (int i = 0; i < 3; i++) {
        long double aside[3], square = 0;
        random_direction(aside);
        for (int k = 0; k < 3; k++) {
            t->normal[i][k] = base[k] + bend * aside[k];
            square += t->normal[i][k] * t->normal[i][k];
        }
        for (int k = 0; k < 3; k++) {
            t->normal[i][k] = rintl(32768 * t->normal[i][k] / sqrtl(square)) / 32768;
        }
    }
    for (int i = 0; i < 3; i++) {
        long double d[3];
        for (int k = 0; k < 3; k++) {
            d[k] = t->normal[i][k] - t->normal[(i + 1) % 3][k];
        }
        chord = worse(chord, dot3(d, d));
    }
    const long double greatest = exp2l(6 + 24 * random_unit());
    for (int i = 0; i < 3; i++) {
        const long double part = random_unit() < 0.3L ? 1 : random_unit();
        t->inverse_depth[i] = 1 + (int32_t)(greatest / (1 + (ratio - 1) * part));
    }
    t->bound = (glint_bound){.diffuse = (uint32_t)random_between(1, 4 * 32640 - 1),
                             .left = (uint32_t)random_between(0, 3) * GLINT_HIGHLIGHT_LEFT,
                             .gloss = (uint32_t)random_between(0, 99),
                             .fixed = (uint32_t)random_between(3, 60),
                             .reach = (uint32_t)random_between(0, 60),
                             .curve_reach = (uint32_t)random_between(0, 90),
                             .exact = (uint32_t)random_between(HALF_CODE, 400),
                             .flat = (uint32_t)random_between(HALF_CODE, 70000),
                             .chord_q16 = (uint32_t)ceill(chord * ONE_Q16)};
    t->bound.turned = t->bound.diffuse + (uint32_t)random_any_size(17) % 60000;
}

/* A point of it in barycentric coordinates on the screen: inside, on an edge, at a corner, in the middle. */
static inline void random_point(long double b[3], int round)
{
    const int k = random_between(0, 2);
    const long double u = random_unit(), v = random_unit();
    b[0] = b[1] = b[2] = 1 / 3.0L;
    switch (round % 4) {
    case 0:
        b[k] = 1, b[(k + 1) % 3] = b[(k + 2) % 3] = 0;
        break;
    case 1:
        b[k] = 0, b[(k + 1) % 3] = u, b[(k + 2) % 3] = 1 - u;
        break;
    case 2:
        b[0] = fminl(u, v), b[1] = fmaxl(u, v) - b[0], b[2] = 1 - b[0] - b[1];
        break;
    default:
        break;
    }
}

static inline void weighted(const long double normal[3][3], const long double b[3], const long double weight[3],
                            long double m[3])
{
    for (int k = 0; k < 3; k++) {
        m[k] = 0;
        for (int i = 0; i < 3; i++) {
            m[k] += b[i] * weight[i] * normal[i][k];
        }
    }
}

#endif
