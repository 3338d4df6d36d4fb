/* SPDX-License-Identifier: MIT */
/*
 * The reference's integrals over extended light sources against plain sums over very many points, and against a closed
 * form: the mean of unit vectors towards a sphere. With f = |x|, whose Laplacian is 2 / |x| and whose second Laplacian
 * is 0 away from the origin, Pizzetti's formula for the mean over a sphere (P. Pizzetti, 1909) ends after two terms,
 * |x| + R^2 / (3 |x|); its gradient is the mean of x / |x|: s (1 - R^2 / (3 d^2)) at the distance d > R.
 */
#include "tests/unit/source_search.h"

#include <stdio.h>

/* Budgets, in parts of the light. The sums' own errors are in them: kinks and gates between their points. */
#define CLOSED_ERROR 5e-6 /* at d = R / 0.95 */
#define DIFFUSE_ERROR 2e-5
#define SPECULAR_ERROR 3e-4

#define ACROSS 500 /* points in a row of a sum over a panel; a ball has the square of it */
#define CASES 60

static void test_ball_above_the_horizon(void **state)
{
    (void)state;
    double worst = 0.0;
    long seen = 0;
    const search what = {.kind = GLINT_BALL, .size = 0.5};
    for (int round = 0; round < 3000; round++) {
        sight at;
        lamp l;
        sight_random(&at, &what);
        at.size = 0.95 * (double)random_unit();
        const glint_light light = light_of(&at, &what);
        lamp_load(&l, &light);
        const vector origin = {0.0, 0.0, 0.0};
        const double d = length(l.position), ratio = l.radius / d, cosine = dot(at.n, l.position) / d;
        const surface f = {.exponent = 1.0};
        if (cosine > ratio + 1e-3) {
            const double mean = area_light(&l, &f, origin, at.n, at.c).diffuse;
            worst = fmax(worst, fabs(mean - cosine * (1.0 - ratio * ratio / 3.0)));
            seen++;
        } else if (cosine < -ratio) {
            assert_true(area_light(&l, &f, origin, at.n, at.c).diffuse == 0.0);
        }
    }
    assert_true(seen > 500);
    expect_at_most("a ball above the horizon", (long double)worst, (long double)CLOSED_ERROR);
}

/* The sum over ACROSS^2 points with the whole model each. */
static area_mean plain_sum(const lamp *l, const surface *f, vector n, vector c)
{
    const double golden = 2.399963229728653;
    const vector origin = {0.0, 0.0, 0.0};
    area_mean sum = {0.0, 0.0};
    for (int i = 0; i < ACROSS * ACROSS; i++) {
        lamp one = *l;
        vector s;
        one.is_area = false;
        if (l->is_ball) {
            const double z = (2.0 * i + 1.0) / (ACROSS * ACROSS) - 1.0, r = sqrt(1.0 - z * z);
            one.position = plus(l->position, times(l->radius, vector_of(r * cos(golden * i), r * sin(golden * i), z)));
        } else {
            const double a = (2.0 * (i / ACROSS) + 1.0) / ACROSS - 1.0, b = (2.0 * (i % ACROSS) + 1.0) / ACROSS - 1.0;
            one.position = plus(l->position, plus(times(a, l->edge[0]), times(b, l->edge[1])));
        }
        if (lamp_toward(&one, origin, &s) && dot(n, s) > 0.0) {
            const double factor = lamp_factor(&one, origin, s) / (ACROSS * ACROSS);
            sum.diffuse += factor * dot(n, s);
            sum.specular += factor * shade_highlight(f, n, s, c);
        }
    }
    return sum;
}

static void test_plain_sums(void **state)
{
    (void)state;
    double diffuse = 0.0, specular = 0.0;
    for (int i = 0; i < CASES; i++) {
        const search what = {.kind = (uint8_t)(i & 1 ? GLINT_BALL : GLINT_PANEL),
                             .term = GATED,
                             .fades = (i & 4) != 0,
                             .blinn = (i & 8) != 0,
                             .spread = exp2(random_between(-2, 3))};
        const vector origin = {0.0, 0.0, 0.0};
        sight at;
        lamp l;
        sight_random(&at, &what);
        if (i & 2) { /* across the horizon */
            at.n = unit(plus(cross(at.toward, at.n), times(0.3 * at.size, at.c)));
        }
        const glint_light light = light_of(&at, &what);
        const surface f = {.exponent = exponent_of(&at, &what), .blinn = what.blinn};
        lamp_load(&l, &light);
        const area_mean exact = area_light(&l, &f, origin, at.n, at.c), sum = plain_sum(&l, &f, at.n, at.c);
        diffuse = fmax(diffuse, fabs(sum.diffuse - exact.diffuse));
        specular = fmax(specular, fabs(sum.specular - exact.specular));
    }
    expect_at_most("diffuse light against a sum", (long double)diffuse, (long double)DIFFUSE_ERROR);
    expect_at_most("specular light against a sum", (long double)specular, (long double)SPECULAR_ERROR);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(test_ball_above_the_horizon),
        numeric_test(test_plain_sums),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
