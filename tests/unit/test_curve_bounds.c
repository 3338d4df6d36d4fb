/* SPDX-License-Identifier: MIT */
/*
 * The constants of the tier of curves, searched for: how far a polynomial through points of a triangle is from what it
 * stands for, over the power of the turns that lighting/bound.h says it goes with. Only glint_bound_curve() and
 * glint_bound_cubic() are the library's; the geometry is this file's, in long double.
 *
 * A search starts at random shapes and climbs by random changes. GLINT_LONG=1 searches ten times as long.
 */
#include "tests/unit/numeric.h"

#include "lighting/bound.h"

/* The worst that is known: of a unit vector at a small turn; of a highlight's gap where the turn of M is the greater,
 * where that of rays is, and where both are 0.1. A search that ends below TIGHT of it has not searched. */
#define CURVE_WORST 0.0353L
#define TURN_WORST 0.0103L
#define VIEW_WORST 0.0064L
#define BOTH_WORST 0.0302L
#define TIGHT 0.85L

#define ONE_Q16 65536.0L
#define GRID 12
#define FINE_GRID 60
#define LATTICE 10

static int searches(int few)
{
    const char *text = getenv("GLINT_LONG");
    return text && strcmp(text, "1") == 0 ? 10 * few : few;
}

static long double dot3(const long double a[3], const long double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalise(long double v[3])
{
    const long double length = sqrtl(dot3(v, v));
    for (int k = 0; k < 3; k++) {
        v[k] /= length;
    }
}

/* About normal: the sum of four. */
static long double random_step(void)
{
    return (random_unit() + random_unit() + random_unit() + random_unit() - 2) * sqrtl(3);
}

/* Three vectors; what lies between them is a triangle beside the origin. */
typedef struct space_triangle {
    long double at[3][3];
} space_triangle;

static void space_at(const space_triangle *t, const long double b[3], long double out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = b[0] * t->at[0][k] + b[1] * t->at[1][k] + b[2] * t->at[2][k];
    }
}

/* The square of the distance from the origin to an edge. */
static long double edge_nearest(const long double a[3], const long double b[3])
{
    long double d[3], p[3];
    for (int k = 0; k < 3; k++) {
        d[k] = b[k] - a[k];
    }
    const long double along = fminl(1, fmaxl(0, -dot3(a, d) / fmaxl(dot3(d, d), 1e-30L)));
    for (int k = 0; k < 3; k++) {
        p[k] = a[k] + along * d[k];
    }
    return dot3(p, p);
}

/* The same to the triangle: where the plane is nearest, if that is inside. */
static long double nearest_square(const space_triangle *t)
{
    long double e[3], f[3], inside[3];
    for (int k = 0; k < 3; k++) {
        e[k] = t->at[1][k] - t->at[0][k];
        f[k] = t->at[2][k] - t->at[0][k];
    }
    const long double ee = dot3(e, e), ef = dot3(e, f), ff = dot3(f, f), area = ee * ff - ef * ef;
    const long double ae = -dot3(t->at[0], e), af = -dot3(t->at[0], f);
    inside[1] = (ae * ff - af * ef) / area;
    inside[2] = (af * ee - ae * ef) / area;
    inside[0] = 1 - inside[1] - inside[2];
    if (area > 1e-24L && inside[0] >= 0 && inside[1] >= 0 && inside[2] >= 0) {
        long double p[3];
        space_at(t, inside, p);
        return dot3(p, p);
    }
    return fminl(edge_nearest(t->at[0], t->at[1]),
                 fminl(edge_nearest(t->at[1], t->at[2]), edge_nearest(t->at[2], t->at[0])));
}

/* The longest edge over the least distance. */
static long double turn_of(const space_triangle *t)
{
    long double edge = 0;
    for (int i = 0; i < 3; i++) {
        long double d[3];
        for (int k = 0; k < 3; k++) {
            d[k] = t->at[i][k] - t->at[(i + 1) % 3][k];
        }
        edge = worse(edge, dot3(d, d));
    }
    return sqrtl(edge / nearest_square(t));
}

/* Grows or shrinks the triangle about its centroid to a turn. False where it does not get there. */
static bool to_turn(space_triangle *t, long double turn)
{
    for (int round = 0; round < 12; round++) {
        const long double now = turn_of(t);
        if (!(now > 1e-6L && now < 1e6L)) {
            return false;
        }
        if (fabsl(now / turn - 1) < 1e-9L) {
            return true;
        }
        for (int k = 0; k < 3; k++) {
            const long double middle = (t->at[0][k] + t->at[1][k] + t->at[2][k]) / 3;
            for (int i = 0; i < 3; i++) {
                t->at[i][k] = middle + (t->at[i][k] - middle) * turn / now;
            }
        }
    }
    return fabsl(turn_of(t) / turn - 1) < 1e-4L;
}

/* Triangles of M, anywhere, and of rays R, in the plane z = 1 that the display is; and the direction of a light. */
typedef struct shape {
    space_triangle m, r;
    long double s[3];
} shape;

#define LONGEST_RAY 2 /* as gloss_ray() takes them */

/* Of M every other one turns about the origin only: its length changes little. */
static void shape_random(shape *now, long double turn)
{
    long double centre[3] = {random_step(), random_step(), random_step()};
    const bool about = random_u32() & 1;
    normalise(centre);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            now->m.at[i][k] = centre[k] + turn / 2 * random_step();
            now->r.at[i][k] = k == 2 ? 1 : random_step() * 0.6L;
        }
        if (about) {
            const long double along = dot3(now->m.at[i], centre) - 1;
            for (int k = 0; k < 3; k++) {
                now->m.at[i][k] -= along * centre[k];
            }
        }
        now->s[i] = random_step();
    }
    normalise(now->s);
}

/* Some of it, or all. */
static void shape_change(shape *now, long double size, long double turn, long double view)
{
    long double by[4]; /* M, R, all of R, s */
    for (int i = 0; i < 4; i++) {
        by[i] = random_u32() & 1 ? size : 0;
    }
    const long double aside[2] = {random_step() * by[2], random_step() * by[2]};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            now->m.at[i][k] += random_step() * by[0] * turn;
            now->r.at[i][k] += k == 2 ? 0 : random_step() * by[1] * view + aside[k];
        }
        now->s[i] += random_step() * by[3];
    }
    normalise(now->s);
}

/* What is interpolated: up to three components. */
typedef void (*quantity)(const shape *now, const long double b[3], long double value[3]);

static void unit_normal_at(const shape *now, const long double b[3], long double value[3])
{
    space_at(&now->m, b, value);
    normalise(value);
}

/* |M|^2 (1 - r.c) */
static void gap_times_square_at(const shape *now, const long double b[3], long double value[3])
{
    long double m[3], r[3], c[3];
    space_at(&now->m, b, m);
    space_at(&now->r, b, r);
    for (int k = 0; k < 3; k++) {
        c[k] = -r[k];
    }
    normalise(c);
    value[0] = dot3(m, m) * (1 + dot3(now->s, c)) - 2 * dot3(m, now->s) * dot3(m, c);
    value[1] = value[2] = 0;
}

/* Lagrange's polynomials for the points whose barycentric coordinates are whole `degree`ths. */
static long double lagrange(int degree, const int node[3], const long double b[3])
{
    long double product = 1;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < node[i]; k++) {
            product *= (degree * b[i] - k) / (k + 1);
        }
    }
    return product;
}

#define POINTS_OF(grid) (((grid) + 1) * ((grid) + 2) / 2)

/* Points to measure at, and the weights there of the values at the nodes. */
typedef struct measure {
    int degree, nodes, count;
    long double node[LATTICE][3], point[POINTS_OF(FINE_GRID)][3], weight[POINTS_OF(FINE_GRID)][LATTICE];
} measure;

static void measure_set_up(measure *to, int degree, int grid)
{
    int node[LATTICE][3];
    to->degree = degree;
    to->nodes = to->count = 0;
    for (int i = 0; i <= degree; i++) {
        for (int j = 0; j <= degree - i; j++) {
            const int at[3] = {i, j, degree - i - j};
            for (int k = 0; k < 3; k++) {
                node[to->nodes][k] = at[k];
                to->node[to->nodes][k] = (long double)at[k] / degree;
            }
            to->nodes++;
        }
    }
    for (int i = 0; i <= grid; i++) {
        for (int j = 0; j <= grid - i; j++) {
            long double *b = to->point[to->count];
            b[0] = (long double)i / grid, b[1] = (long double)j / grid, b[2] = (long double)(grid - i - j) / grid;
            for (int n = 0; n < to->nodes; n++) {
                to->weight[to->count][n] = lagrange(degree, node[n], b);
            }
            to->count++;
        }
    }
}

/* What an error counts over: nothing, |M|^2. */
enum { ALONE, OVER_SQUARE };

/* A search: which quantity, by a polynomial of which degree, at which turns. */
typedef struct search {
    quantity of;
    int degree, over;
    long double turn, view;
} search;

static long double greatest_error(const search *what, const measure *at, const shape *now)
{
    long double value[LATTICE][3] = {{0}}, greatest = 0;
    for (int n = 0; n < at->nodes; n++) {
        what->of(now, at->node[n], value[n]);
    }
    for (int i = 0; i < at->count; i++) {
        long double error[3], m[3];
        what->of(now, at->point[i], error);
        space_at(&now->m, at->point[i], m);
        const long double square = dot3(m, m), over = what->over == OVER_SQUARE ? square * square : 1;
        for (int k = 0; k < 3; k++) {
            for (int n = 0; n < at->nodes; n++) {
                error[k] -= at->weight[i][n] * value[n][k];
            }
        }
        greatest = fmaxl(greatest, dot3(error, error) / over);
    }
    return sqrtl(greatest);
}

static long double score(const search *what, const measure *at, shape *now)
{
    if (!to_turn(&now->m, what->turn) || (what->view > 0 && !to_turn(&now->r, what->view))) {
        return 0;
    }
    for (int i = 0; i < 3; i++) {
        if (dot3(now->r.at[i], now->r.at[i]) > LONGEST_RAY * LONGEST_RAY) {
            return 0;
        }
    }
    return greatest_error(what, at, now);
}

static long double climb(const search *what, int starts, int steps)
{
    static measure coarse, fine;
    long double found = 0;
    measure_set_up(&coarse, what->degree, GRID);
    measure_set_up(&fine, what->degree, FINE_GRID);
    for (int start = 0; start < searches(starts); start++) {
        shape best, now;
        long double size = 0.3L;
        shape_random(&best, what->turn);
        long double most = score(what, &coarse, &best);
        for (int step = 0; step < steps; step++) {
            now = best;
            shape_change(&now, size, what->turn, what->view);
            const long double there = score(what, &coarse, &now);
            if (there > most) {
                most = there;
                best = now;
            } else {
                size *= 0.99L;
            }
        }
        found = worse(found, score(what, &fine, &best));
    }
    return found;
}

/* The bounds as real numbers: of light so bright that its last unit hardly counts. */
#define BRIGHT (((uint32_t)1 << 24) - 1)

static long double curve_bound(long double turn)
{
    const uint32_t bright = BRIGHT >> 4;
    return (long double)glint_bound_curve(bright, (uint32_t)ceill(turn * ONE_Q16)) / bright;
}

/* Without what is added for rounding: 33 of 2^28, and a unit of each sum. */
static long double cubic_bound(long double turn, long double view)
{
    const glint_cubic_size size = {
        .view_q16 = (uint32_t)ceill(view * ONE_Q16), .reach = 0, .together = UINT32_MAX, .up = 20};
    const uint32_t bound = glint_bound_cubic(&size, BRIGHT, 0, (uint32_t)ceill(turn * ONE_Q16));
    assert_true(bound != UINT32_MAX);
    return (bound - 2.0L) / BRIGHT - 33 * exp2l(-28);
}

static void cosines_err_by_the_cube_of_the_turn(void **state)
{
    static const long double turns[] = {0.02L, 0.05L, 0.1L, 0.15L, 0.2L, 0.3L, 0.45L, 0.6L, 0.68L};
    long double most = 0, of_bound = 0;
    (void)state;
    for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
        const search what = {unit_normal_at, 2, ALONE, turns[i], 0};
        const long double found = climb(&what, 30, 400), ratio = found / powl(turns[i], 3);
        print_message("    turn %.2Lf: %.5Lf of its cube, %.3Lf of the bound\n", turns[i], ratio,
                      found / curve_bound(turns[i]));
        most = worse(most, ratio);
        of_bound = worse(of_bound, found / curve_bound(turns[i]));
    }
    assert_true(most >= TIGHT * CURVE_WORST);
    assert_true(turns[sizeof turns / sizeof *turns - 1] <= GLINT_TURN_MOST_Q16 / ONE_Q16);
    expect_bound("the error of a unit vector, over glint_bound_curve()", of_bound, 1);
}

static void highlights_err_by_both_turns(void **state)
{
    static const long double turns[][2] = {{0.6L, 0.03L}, {0.03L, 0.3L}, {0.1L, 0.1L},  {0.65L, 0.3L}, {0.3L, 0.3L},
                                           {0.6L, 0.05L}, {0.3L, 0.1L},  {0.2L, 0.45L}, {0.1L, 0.2L},  {0.4L, 0.4L}};
    long double found[sizeof turns / sizeof *turns] = {0}, of_bound = 0;
    (void)state;
    for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
        const long double turn = turns[i][0], view = turns[i][1];
        const search what = {gap_times_square_at, 3, OVER_SQUARE, turn, view};
        found[i] = climb(&what, 40, 700);
        print_message("    turn %.2Lf, view %.2Lf: %.5Lf of (turn view)^2, %.5Lf of view^4, %.3Lf of the bound\n", turn,
                      view, found[i] / powl(turn * view, 2), found[i] / powl(view, 4),
                      found[i] / cubic_bound(turn, view));
        of_bound = worse(of_bound, found[i] / cubic_bound(turn, view));
    }
    assert_true(found[0] >= TIGHT * TURN_WORST * powl(turns[0][0] * turns[0][1], 2));
    assert_true(found[1] >= TIGHT * VIEW_WORST * powl(turns[1][1], 4));
    assert_true(found[2] >= TIGHT * BOTH_WORST * powl(turns[2][0], 4));
    expect_bound("the error of a gap, over glint_bound_cubic()", of_bound, 1);
}

/* What glint_bound_cubic() adds for rounding, in real numbers. */
static long double cubic_rounding(const glint_cubic_size *size)
{
    const long double n = size->reach;
    const long double third = n * n * (n + 3) / 6, second = n * n / 2; /* C(n, 3) and C(n, 2), at -n too */
    /* half a unit each, and what the products before were cut by */
    const long double units = third * (0.5L + 3 * exp2l(8 - 3 * size->up)) +
                              second * (0.5L + 3 * exp2l(6 - 2 * size->up)) + n * (0.5L + 2 * exp2l(5 - size->up));
    const long double part = size->part_q15 / 32768.0L;
    return units * exp2l(size->down - 32) / (1 - part) + (0.78L + 1.56L * part) * size->end_q28 / exp2l(28 + 15);
}

static void rounding_of_cubics_is_its_formula(void **state)
{
    long double below = 0, above = 0;
    long served = 0;
    (void)state;
    for (int round = 0; round < 400000; round++) {
        const glint_cubic_size size = {.together = UINT32_MAX,
                                       .view_q16 = 0,
                                       .reach = (uint32_t)random_between(1, 255),
                                       .end_q28 = (uint32_t)exp2l(28 * random_unit()),
                                       .up = random_between(2, 12),
                                       .part_q15 = (uint32_t)random_between(0, 10922),
                                       .down = random_between(0, 6)};
        const uint32_t gloss = (uint32_t)exp2l(8 + 16 * random_unit()) - 1;
        const uint32_t bound = glint_bound_cubic(&size, gloss, 0, 0);
        const long double real = cubic_rounding(&size);
        if (bound == UINT32_MAX) {
            assert_true(real > exp2l(-6)); /* there is no use in it then */
            continue;
        }
        served++;
        below = worse(below, gloss * real / bound);
        if (gloss * real > 100) {
            above = worse(above, (bound - 2 - gloss * exp2l(-22)) / (gloss * real));
        }
    }
    assert_true(served > 100000);
    expect_at_most("rounding in real numbers, over what is counted", below, 1);
    expect_at_most("what is counted, over it", above, 2.5L);
}

/* And of the specular peak: what 1/|M|^2 is off, 1e-4, and the rounding of what it is made of far from the anchor. */
static void relative_errors_count_by_the_peak(void **state)
{
    long double below = 0, above = 0;
    (void)state;
    for (int round = 0; round < 400000; round++) {
        const glint_cubic_size size = {.together = UINT32_MAX,
                                       .inverse_q22 = (uint32_t)exp2l(20 * random_unit()) - 1,
                                       .anchor_reach = (uint32_t)exp2l(11 * random_unit()),

                                       .up = 20};
        const uint32_t specular = (uint32_t)exp2l(8 + 16 * random_unit()) - 1;
        const long double n = size.anchor_reach;
        /* (1/2 + 3/4) (n + 1)^2 + 5 (n + 1) units of Q30 of g; a relative 2 g / (g^2 + 0.706) of that, which is 1.19 at
         * most */
        const long double real =
            size.inverse_q22 / exp2l(22) + 1e-4L + 1.19L * (1.25L * (n + 1) * (n + 1) + 5 * (n + 1)) / exp2l(30);
        const uint32_t bound = glint_bound_cubic(&size, 0, specular, 0);
        assert_true(bound != UINT32_MAX);
        below = worse(below, specular * real / bound);
        if (specular * real > 100) {
            above = worse(above, (bound - 2) / (specular * real));
        }
    }
    expect_at_most("relative errors, over what is counted", below, 1);
    expect_at_most("what is counted, over them", above, 1.5L);
}

/* `together` counts instead of `gloss` where it is less, and where gaps are off by no more than it allows for. */
static void highlights_together_cost_no_more(void **state)
{
    const uint32_t gloss = (uint32_t)1 << 20;
    (void)state;
    for (uint32_t reach = 1; reach <= 255; reach++) {
        glint_cubic_size size = {.together = gloss / 4, .view_q16 = 9000, .reach = reach, .up = 2, .down = 4};
        const uint32_t together = glint_bound_cubic(&size, gloss, 0, 20000);
        const uint32_t alone = glint_bound_cubic(&size, gloss / 4, 0, 20000);
        size.together = UINT32_MAX;
        const uint32_t all = glint_bound_cubic(&size, gloss, 0, 20000);
        const long double gap_q28 = (long double)all / gloss * 268435456;
        assert_int_equal(together, gap_q28 < 0.99L * GLINT_GAP_OFF_Q28   ? alone
                                   : gap_q28 > 1.01L * GLINT_GAP_OFF_Q28 ? all
                                                                         : together);
    }
}

static void cubics_that_have_no_bound_are_refused(void **state)
{
    const glint_cubic_size served = {
        .together = UINT32_MAX, .view_q16 = 3000, .reach = 20, .end_q28 = 1 << 24, .up = 4, .down = 1};
    glint_cubic_size refused = served;
    (void)state;
    assert_true(glint_bound_cubic(&served, 1000, 1000, 9000) < 1000);
    refused.up = 1;
    assert_int_equal(glint_bound_cubic(&refused, 1000, 1000, 9000), UINT32_MAX);
    refused = served, refused.reach = 256;
    assert_int_equal(glint_bound_cubic(&refused, 1000, 1000, 9000), UINT32_MAX);
    refused = served, refused.anchor_reach = 4091;
    assert_int_equal(glint_bound_cubic(&refused, 1000, 1000, 9000), UINT32_MAX);
    refused = served, refused.part_q15 = 10925;
    assert_int_equal(glint_bound_cubic(&refused, 1000, 1000, 9000), UINT32_MAX);
    refused = served, refused.inverse_q22 = 1 << 20;
    assert_int_equal(glint_bound_cubic(&refused, 1000, 1000, 9000), UINT32_MAX);
    refused = served, refused.view_q16 = 32769;
    assert_int_equal(glint_bound_cubic(&refused, 1000, 1000, 9000), UINT32_MAX);
    assert_int_equal(glint_bound_cubic(&served, (uint32_t)1 << 24, 1000, 9000), UINT32_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(cosines_err_by_the_cube_of_the_turn), numeric_test(highlights_err_by_both_turns),
        numeric_test(rounding_of_cubics_is_its_formula),   numeric_test(relative_errors_count_by_the_peak),
        numeric_test(highlights_together_cost_no_more),    numeric_test(cubics_that_have_no_bound_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
