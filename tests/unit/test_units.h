/* SPDX-License-Identifier: MIT */
/*
 * Unit vectors along a row, and the gap of a highlight that is made of them, against long double. Compiled once for
 * each backend, whose test defines the scale of each quantity and the budgets.
 */
#ifndef GLINT_TESTS_UNIT_TEST_UNITS_H
#define GLINT_TESTS_UNIT_TEST_UNITS_H

#include "tests/unit/directions.h"
#include "tests/unit/numeric.h"

#define ROUNDS 1000000
#define ROW_PX 16

/* A vector of a length as units_along() is given it, by `one` of the backend's units; and what it stands for. */
static inline void random_row(unit_row *row, long double one, long double way, long double exact[3],
                              long double exact_step[3])
{
    const long double length = round_to_edge() ? 0.5L + 0.01L * random_unit() : 0.5L + 0.5L * random_unit();
    long double v[3], aside[3];
    random_direction(v);
    random_direction(aside);
    for (int k = 0; k < 3; k++) {
        set_component(row, k, v[k] * length * one, aside[k] * way * one);
        get_component(row, k, &exact[k], &exact_step[k]);
    }
}

static inline long double off_unit(const real got[3], const long double v[3], long double one)
{
    const long double length = sqrtl(dot3(v, v));
    long double off = 0;
    for (int k = 0; k < 3; k++) {
        const long double d = (long double)got[k] / UNIT_ONE - one * v[k] / length;
        off += d * d;
    }
    return sqrtl(off);
}

/* Along a row, vectors of half to all of the greatest length, and what rows lead to beyond that. */
static void units_along_a_row(void **state)
{
    long double worst = 0, shortened = 0, beyond = 0;
    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        unit_row row;
        long double v[3], step[3];
        real out[ROW_PX][3], out_short[ROW_PX][3];
        random_row(&row, VECTOR_ONE, exp2l(-4 - 10 * random_unit()), v, step);
        units_along(row, VECTOR_SCALE, false, ROW_PX, out);
        units_along(row, VECTOR_SCALE, true, ROW_PX, out_short);
        for (int i = 0; i < ROW_PX; i++) {
            const long double length = sqrtl(dot3(v, v)) / VECTOR_ONE;
            if (length > 0.5L && length < 1) {
                worst = worse(worst, off_unit(out[i], v, 1));
                shortened = worse(shortened, off_unit(out_short[i], v, SHORTENED));
            } else if (length > 0.01L) {
                beyond = worse(beyond, off_unit(out[i], v, 1));
            }
            for (int k = 0; k < 3; k++) {
                v[k] += step[k];
            }
        }
    }
    expect_bound("a unit vector along a row", worst, UNIT_ERROR);
    expect_bound("one of a ray", shortened, UNIT_ERROR);
    expect_at_most("one of another length", beyond, BEYOND_ERROR);
}

/* r and c of three vectors, for the gap, at most 4: |r - c|. */
static inline long double exact_apart(const long double n[3], const long double s[3], const long double ray[3])
{
    const long double nn = dot3(n, n), ns = dot3(n, s), ss = sqrtl(dot3(s, s)), rr = sqrtl(dot3(ray, ray));
    long double apart = 0;
    for (int k = 0; k < 3; k++) {
        const long double d = (2 * ns / nn * n[k] - s[k]) / ss + ray[k] / rr;
        apart += d * d;
    }
    return sqrtl(apart);
}

/* A ray towards which light from s is mirrored at n, but for some angle. */
static inline void ray_near_mirrored(const long double n[3], const long double s[3], unit_row *row, long double ray[3])
{
    const long double nn = dot3(n, n), away = random_u32() & 1 ? exp2l(-16 * random_unit()) : 2,
                      length = 0.5L + 0.5L * random_unit();
    long double aside[3], c[3], step;
    random_direction(aside);
    for (int k = 0; k < 3; k++) {
        c[k] = (2 * dot3(n, s) / nn * n[k] - s[k]) / sqrtl(dot3(s, s)) + away * aside[k];
    }
    const long double whole = sqrtl(dot3(c, c));
    for (int k = 0; k < 3; k++) {
        set_component(row, k, -c[k] / whole * length * VECTOR_ONE, 0);
        get_component(row, k, &ray[k], &step);
    }
}

static void gaps_of_units_are_of_the_angle(void **state)
{
    long double worst = 0, fine = 0;
    (void)state;
    for (int round = 0; round < 2 * ROUNDS; round++) {
        unit_row n_row, s_row, ray_row;
        long double n[3], s[3], ray[3], step[3];
        real n_unit[1][3], s_unit[1][3], ray_unit_of[1][3];
        random_row(&n_row, VECTOR_ONE, 0, n, step);
        random_row(&s_row, VECTOR_ONE, 0, s, step);
        ray_near_mirrored(n, s, &ray_row, ray);
        units_along(n_row, VECTOR_SCALE, false, 1, n_unit);
        units_along(s_row, VECTOR_SCALE, false, 1, s_unit);
        units_along(ray_row, VECTOR_SCALE, true, 1, ray_unit_of);
        const real cosine = cosine_of(n_unit[0], s_unit[0]);
        if (cosine <= 0) {
            continue;
        }
        const long double apart = exact_apart(n, s, ray);
        const long double gap = mirrored_gap_q28(n_unit[0], s_unit[0], cosine, ray_unit_of[0]) / 268435456.0L;
        worst = worse(worst, fabsl(sqrtl(2 * gap) - sqrtl(apart * apart + GAP_SHIFT)));
        unit_fine_at(&n_row, n_unit[0]);
        unit_fine_at(&s_row, s_unit[0]);
        unit_fine_at(&ray_row, ray_unit_of[0]);
        const long double fine_gap = fine_gap_q28(n_unit[0], s_unit[0], ray_unit_of[0]) / 268435456.0L;
        if (apart < 1.9L) {
            fine = worse(fine, FINE_ERROR_OF(fine_gap, apart));
        }
    }
    expect_at_most("|r - c| by the gap", worst, GAP_ERROR);
    expect_at_most("the gap with finer vectors", fine, FINE_ERROR);
}

#endif
