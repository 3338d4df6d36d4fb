/* SPDX-License-Identifier: MIT */
/*
 * Fields over a triangle in fixed point.
 */
#include <stddef.h>
#include <stdint.h>

#include "raster/field_fixed.h"

#define M_ONE 536870912.0L /* Q29 */
#define DOT_ONE 268435456.0L
#define DOT_HALF 4096.0L        /* half of what a cosine's cut drops, which its field has */
#define CHANNEL_ONE 67108864.0L /* Q26 */
#define CHANNEL_HALF 2048.0L
#define LENGTH_ONE 16384.0L
#define UNIT_ONE 32768.0L
#define GAP_ONE 268435456.0L

/* Budgets, `away` pixels from the anchor (|dx| + |dy|), over a way of 1 and |M'| times that. */
#define COSINE_ERROR(away, way) ((8 * (away) + 8) / DOT_ONE)
#define LENGTH_ERROR(away, way) (7.5e-5L + (way) * (way)*ldexpl(1, -27) + ((away) + 64) * (away)*ldexpl(1, -31))
#define CHANNEL_ERROR(length, away) ((length)*0.87L * ldexpl(1, -14) + (2 * (away) + 4) / CHANNEL_ONE)
#define NORMAL_ERROR(away) (6e-5L + (away)*1e-7L)
#define RAY_ERROR 7e-5L
#define GAP_ERROR 2.5e-4L /* as lighting/bound.h states */
#define GAP_ROW_ERROR (80 / GAP_ONE)

/* A ray as a camera's: 1 forward, and anything up to that to either side. */
static void random_ray(pixel_rays *rays, long double exact[3], int16_t x, int16_t y);

#include "tests/unit/test_fields.h"

static void random_ray(pixel_rays *rays, long double exact[3], int16_t x, int16_t y)
{
    /* a forward component of 1: 20 to 29 bits, and what lies beside it, below 2^30 */
    const int bits = random_between(20, 29), forward = random_between(0, 2);
    const int32_t beside = (int32_t)exp2l(bits - 9 + 9 * random_unit());
    rays->fraction = (int8_t)bits;
    for (int k = 0; k < 3; k++) {
        const bool along = k == forward;
        rays->v[0][k] = along ? (int32_t)1 << bits : random_between(-beside, beside) / 2;
        rays->v[1][k] = along ? 0 : random_between(-beside, beside) / 1024;
        rays->v[2][k] = along ? 0 : random_between(-beside, beside) / 1024;
        exact[k] = (long double)rays->v[0][k] + (long double)x * rays->v[1][k] + (long double)y * rays->v[2][k];
    }
}

/* The folded lights' sum, up to 4 long in Q28, is cut to 15 bits: at corner 0's pixel and up to 60 beyond. */
static void folded_lights_keep_their_bound(void **state)
{
    long double worst = 0;
    (void)state;
    for (int round = 0; round < 200000; round++) {
        field_triangle t;
        attribute_plane dot;
        long double v[3], m[3], right[3], down[3];
        real v_q28[3];
        if (!random_field(&t, 60, random_unit())) {
            continue;
        }
        const long double length = exp2l(2 - 12 * random_unit());
        random_direction(v);
        for (int k = 0; k < 3; k++) {
            v_q28[k] = (real)(v[k] * length * DOT_ONE);
            v[k] = scaled(v_q28[k], DOT_ONE);
        }
        field_dot_channel(&dot, t.m, v_q28);
        const int16_t x = (int16_t)random_between(t.edges.box.x_first, t.edges.box.x_last),
                      y = (int16_t)random_between(t.edges.box.y_first, t.edges.box.y_last);
        glint_spans spans;
        int16_t row, x_first, x_last;
        glint_spans_begin(&spans, &t.edges, y, y);
        if (!glint_spans_next(&spans, &row, &x_first, &x_last)) {
            continue;
        }
        const int16_t covered = x < x_first ? x_first : x > x_last ? x_last : x;
        exact_m(&t, covered, row, m, right, down);
        const long double away = abs(covered - t.gradients.anchor_x) + abs(row - t.gradients.anchor_y);
        const long double got =
            ((long double)attribute_at(&dot, &t.gradients, covered, row) - CHANNEL_HALF) / CHANNEL_ONE;
        worst = worse(worst, fabsl(got - dot3(m, v)) / CHANNEL_ERROR(length, away));
    }
    expect_bound("M.v of folded lights, over its bound", worst, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(fields_keep_their_bound),
        numeric_test(fields_keep_it_on_large_displays),
        numeric_test(rays_are_unit),
        numeric_test(gaps_are_of_the_angle),
        numeric_test(rows_of_gaps_are_quadratic),
        numeric_test(folded_lights_keep_their_bound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
