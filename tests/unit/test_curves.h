/* SPDX-License-Identifier: MIT */
/*
 * Curves of cosines: quadratics through points of a triangle (raster/lattice_*.h, raster/field_*.h) against long
 * double, the same polynomial at pixels that the triangle covers. Cubics, and the gaps of highlights that they go
 * through, are in test_curves_gaps.h. Compiled once for each backend, whose test defines the scale of each quantity and
 * the budgets.
 */
#ifndef GLINT_TESTS_UNIT_TEST_CURVES_H
#define GLINT_TESTS_UNIT_TEST_CURVES_H

#include "tests/unit/directions.h"
#include "tests/unit/numeric.h"

#include "raster/edges.h"

#define ROUNDS 40000
#define PIXELS 6 /* of each triangle */
#define ORDINARY_PX 320

/* A triangle on the screen, as the library prepares it. */
typedef struct curve_triangle {
    glint_screen_vertex vertex[3];
    const glint_screen_vertex *screen[3];
    glint_edges edges;
    glint_gradients gradients;
    lattice_gradients lattice;
    lattice_centre centre;
} curve_triangle;

/* Of any size that fits size_px, every third one thin; false for slivers and for those that cover no pixel. */
static inline bool random_triangle(curve_triangle *t, int size_px)
{
    const long double size = exp2l(random_unit() * log2l(size_px - 1)) * GLINT_FINE;
    const long double room = size_px * GLINT_FINE - size, x = random_unit() * room, y = random_unit() * room;
    const long double thin = random_between(0, 2) ? 1 : exp2l(-6 * random_unit());
    glint_point snapped[3];
    for (int i = 0; i < 3; i++) {
        const long double along = random_unit(), aside = thin * (random_unit() - 0.5L);
        t->vertex[i].x = (int32_t)(x + size * (thin < 1 ? along : random_unit()));
        t->vertex[i].y = (int32_t)(y + size * (thin < 1 ? fminl(1, fmaxl(0, along + aside)) : random_unit()));
        t->vertex[i].depth_q30 = GLINT_DEPTH_BIAS + GLINT_DEPTH_SPAN / 2 + random_between(0, 1 << 20);
        t->screen[i] = &t->vertex[i];
        snapped[i] = glint_snap(&t->vertex[i]);
    }
    const int64_t area = glint_signed_area(snapped);
    glint_box box;
    glint_bounding_box(&box, snapped, (uint16_t)size_px, (uint16_t)size_px);
    if (area == 0 || box.x_first > box.x_last || box.y_first > box.y_last) {
        return false;
    }
    glint_edges_set_up(&t->edges, snapped, area > 0, box);
    glint_gradients_set_up(&t->gradients, t->screen, t->edges.order);
    if (t->gradients.sliver) {
        return false;
    }
    lattice_prepare(&t->lattice, &t->gradients);
    t->centre = lattice_centre_of(t->screen);
    return true;
}

/* Exact barycentric coordinates of a pixel's centre and `aside` thirds of 1/4096 px, in clockwise order. Is that in the
 * triangle? */
static inline bool coordinates_beside(const curve_triangle *t, int x, int y, const int32_t aside[2], long double b[3])
{
    const glint_gradients *g = &t->gradients;
    const int64_t px = 3 * ((int64_t)x * GLINT_FINE + GLINT_FINE / 2) + aside[0],
                  py = 3 * ((int64_t)y * GLINT_FINE + GLINT_FINE / 2) + aside[1];
    bool inside = true;
    for (int i = 0; i < 3; i++) {
        const glint_screen_vertex *from = g->corner[(i + 1) % 3], *to = g->corner[(i + 2) % 3];
        const int64_t e =
            ((int64_t)to->x - from->x) * (py - 3 * from->y) - ((int64_t)to->y - from->y) * (px - 3 * from->x);
        b[i] = (long double)e / (3 * (long double)g->area);
        inside = inside && e >= 0;
    }
    return inside;
}

static inline bool coordinates_at(const curve_triangle *t, int x, int y, long double b[3])
{
    const int32_t none[2] = {0, 0};
    return coordinates_beside(t, x, y, none, b);
}

/* A pixel of it at random; false: none was hit. */
static inline bool random_pixel(const curve_triangle *t, int16_t *x, int16_t *y, long double b[3])
{
    for (int i = 0; i < 4; i++) {
        const long double u = random_unit(), v = random_unit(), low = fminl(u, v), high = fmaxl(u, v);
        const long double part[3] = {low, high - low, 1 - high};
        long double at[2] = {0, 0};
        for (int k = 0; k < 3; k++) {
            at[0] += part[k] * t->gradients.corner[k]->x / GLINT_FINE;
            at[1] += part[k] * t->gradients.corner[k]->y / GLINT_FINE;
        }
        *x = (int16_t)floorl(at[0]);
        *y = (int16_t)floorl(at[1]);
        if (coordinates_at(t, *x, *y, b)) {
            return true;
        }
    }
    return false;
}

/* 1 and how far barycentric coordinates run from the anchor to a pixel, if nothing cancels. */
static inline long double way_of(const curve_triangle *t, long double away)
{
    long double steepest = 0;
    for (int i = 0; i < 2; i++) {
        steepest = worse(steepest, fabsl(t->gradients.x[i] / 1073741824.0L));
        steepest = worse(steepest, fabsl(t->gradients.y[i] / 1073741824.0L));
    }
    return 1 + away * steepest;
}

/* From where steps lead to a pixel: the first of its row in the triangle, at most 64 before. */
static inline int16_t row_start(const curve_triangle *t, int16_t x, int16_t y)
{
    long double b[3];
    int16_t from = x;
    while (x - from < 64 && coordinates_at(t, from - 1, y, b)) {
        from--;
    }
    return from;
}

/* The polynomial through values at the corners and the middles of the edges 01, 12, 20, by Lagrange. */
static inline long double quadratic_at(const real corner[3], const real middle[3], const long double b[3])
{
    long double sum = 0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        sum += b[i] * (2 * b[i] - 1) * (long double)corner[i] + 4 * b[i] * b[j] * (long double)middle[i];
    }
    return sum;
}

/* ------------------------------------------------------------------------------------------------------- quadratics */

/* Values that have nothing to do with each other but that they fit: coefficients are below 2^31 then. */
static inline void random_values(real value[], int count, long double most, long double apart)
{
    const long double base = (2 * random_unit() - 1) * (most - apart), part = apart * exp2l(-12 * random_unit());
    for (int i = 0; i < count; i++) {
        value[i] = (real)(base + (2 * random_unit() - 1) * part);
    }
}

static inline void check_quadratic_rows(const curve_triangle *t, const field_quadratic *field, int16_t x, int16_t y)
{
    const long double away = abs(x - t->gradients.anchor_x) + abs(y - t->gradients.anchor_y) + 64,
                      way = way_of(t, away);
    const int16_t from = row_start(t, x, y);
    const field_row there = field_quadratic_at(field, &t->gradients, x, y);
    field_row stepped = field_quadratic_at(field, &t->gradients, from, y), skipped = stepped;
    for (int16_t i = from; i < x; i++) {
        field_row_next(&stepped);
    }
    field_row_skip(&skipped, (uint16_t)(x - from));
    ASSERT_STEPPED(&stepped, &there, way * way);
    ASSERT_STEPPED(&skipped, &there, way * way);
}

/* What glint_bound_choose() counts for it, in units of the values of a cosine's curve: no end where it refuses. */
static inline long double counted_for(int up, long double away)
{
    const uint32_t bright = (uint32_t)1 << 22;
    const uint32_t counted = glint_bound_curve_reach(bright, away < 1 ? 1 : (uint32_t)away, up);
    return away > 3000 ? (long double)UINT32_MAX : COSINE_ONE * counted / bright;
}

static inline long double measure_quadratics(int size_px, long double *farthest, long double *over_counted)
{
    long double worst = 0;
    long pixels = 0;
    for (int round = 0; round < ROUNDS; round++) {
        curve_triangle t;
        field_quadratic field;
        real value[6];
        if (!random_triangle(&t, size_px)) {
            continue;
        }
        random_values(value, 6, QUADRATIC_MOST, QUADRATIC_APART);
        lattice_quadratic(&field, &t.lattice, value, value + 3);
        for (int i = 0; i < PIXELS; i++) {
            long double b[3];
            int16_t x, y;
            if (!random_pixel(&t, &x, &y, b)) {
                continue;
            }
            const long double away = abs(x - t.gradients.anchor_x) + abs(y - t.gradients.anchor_y);
            const field_row row = field_quadratic_at(&field, &t.gradients, x, y);
            const long double error = fabsl(FIELD_VALUE(row.value) - quadratic_at(value, value + 3, b)),
                              budget = QUADRATIC_ERROR(lattice_spare_bits(&t.lattice), away, way_of(&t, away));
            *over_counted = worse(*over_counted, error / counted_for(glint_gradients_spare_bits(&t.gradients), away));
            if (error > worst * budget) {
                worst = error / budget;
                *farthest = away;
            }
            pixels++;
            if (i == 0) {
                check_quadratic_rows(&t, &field, x, y);
            }
        }
    }
    assert_true(pixels > ROUNDS);
    return worst;
}

static inline void quadratics_keep_their_bound(void **state)
{
    long double away = 0, counted = 0;
    (void)state;
    const long double ordinary = measure_quadratics(ORDINARY_PX, &away, &counted);
    print_message("    worst %.0Lf pixels from the anchor\n", away);
    expect_at_most("a quadratic at a pixel, over its bound", ordinary, 1);
    assert_true(ordinary > BUDGET_BITES);
    const long double large = measure_quadratics(GLINT_MAX_SIZE_PX, &away, &counted);
    print_message("    worst %.0Lf pixels from the anchor\n", away);
    expect_at_most("the same on the largest display", large, 1);
    assert_true(large > BUDGET_BITES);
    expect_at_most("and over what the promise counts for it", counted, 1);
}

/* ------------------------------------------------------------------------------------------------ middles of edges */

/* A unit normal as the library has it. */
static inline void stored_normal(const long double v[3], real out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = (real)(UNIT_ONE == 1 ? v[k] : rintl(v[k] * UNIT_ONE));
    }
}

static inline void near_direction(const long double base[3], long double bend, long double v[3])
{
    long double aside[3];
    random_direction(aside);
    for (int k = 0; k < 3; k++) {
        v[k] = base[k] + bend * aside[k];
    }
    const long double length = sqrtl(dot3(v, v));
    for (int k = 0; k < 3; k++) {
        v[k] /= length;
    }
}

static inline void middles_of_edges_are_unit(void **state)
{
    long double inverse = 0, middle = 0;
    (void)state;
    for (int round = 0; round < 400000; round++) {
        long double base[3], n[2][3], m[3], d[3];
        const long double bend = exp2l(-12 * random_unit()) * 0.4L;
        const uint16_t u_q15 = (uint16_t)(round % 3 ? 32768 : random_between(24000, 32768));
        const uint16_t v_q15 = (uint16_t)(round % 4 ? random_between(24000, 32768) : 32768);
        const long double u = u_q15 / 32768.0L, v = v_q15 / 32768.0L;
        random_direction(base);
        near_direction(base, bend, n[0]);
        near_direction(base, bend, n[1]);
        for (int k = 0; k < 3; k++) {
            d[k] = n[0][k] - n[1][k];
            m[k] = (u * n[0][k] + v * n[1][k]) / 2;
        }
        const uint32_t chord_q16 = (uint32_t)rintl(dot3(d, d) * 65536);
        if (dot3(m, m) <= 0.5L) {
            continue;
        }
        const real got = lattice_inverse_length(u_q15, v_q15, chord_q16);
        inverse = worse(inverse, fabsl((long double)got / INVERSE_ONE * sqrtl(dot3(m, m)) - 1));
        const real a = (real)((2 * random_unit() - 1) * MIDDLE_MOST), b = (real)((2 * random_unit() - 1) * MIDDLE_MOST);
        const long double mean = (u * (long double)a + v * (long double)b) / 2;
        const long double error =
            fabsl((long double)lattice_middle(a, u_q15, b, v_q15, got) - mean * (long double)got / INVERSE_ONE);
        middle = worse(middle, error / MIDDLE_UNIT);
    }
    expect_bound("1/|M| in the middle of an edge, relative", inverse, INVERSE_ERROR);
    expect_bound("a value in the middle of an edge, units", middle, MIDDLE_ERROR);
}

/* -------------------------------------------------------------------------------------------------- lights above 0 */

/* Lights that shine on all corners of a triangle whose normals turn by as much as the tier takes. */
static inline void curves_said_to_be_positive_are(void **state)
{
    long said = 0, close = 0;
    long double least_seen = 1e9L;
    (void)state;
    for (int round = 0; round < 200000; round++) {
        long double base[3], n[3][3], m[6][3], edge = 0, least = 1e9L, s[3];
        real value[6];
        const long double bend = 0.5L * random_unit();
        random_direction(base);
        for (int i = 0; i < 3; i++) {
            const long double weight = i == 0 ? 1 : 1 - 0.35L * random_unit();
            near_direction(base, bend, n[i]);
            for (int k = 0; k < 3; k++) {
                m[i][k] = weight * n[i][k];
            }
        }
        for (int i = 0; i < 3; i++) {
            long double d[3];
            for (int k = 0; k < 3; k++) {
                d[k] = m[i][k] - m[(i + 1) % 3][k];
                m[3 + i][k] = (m[i][k] + m[(i + 1) % 3][k]) / 2;
            }
            edge = worse(edge, sqrtl(dot3(d, d)));
            least = fminl(least, sqrtl(dot3(m[3 + i], m[3 + i])));
        }
        if (edge / least > GLINT_TURN_MOST_Q16 / 65536.0L) {
            continue;
        }
        do {
            random_direction(s);
        } while (dot3(s, base) < 0);
        for (int i = 0; i < 6; i++) {
            value[i] = (real)(STEPS_ONE * dot3(m[i], s) / sqrtl(dot3(m[i], m[i])));
        }
        if (!field_steps_positive(value)) {
            continue;
        }
        said++;
        enum { GRID = 10 };
        long double below = 1e9L;
        for (int i = 0; i <= GRID; i++) {
            for (int j = 0; j <= GRID - i; j++) {
                const long double b[3] = {(long double)i / GRID, (long double)j / GRID,
                                          (long double)(GRID - i - j) / GRID};
                below = fminl(below, quadratic_at(value, value + 3, b));
            }
        }
        close += below < 0.05L * STEPS_ONE;
        least_seen = fminl(least_seen, below / STEPS_ONE);
    }
    print_message("    %ld triangles, %ld with light below 0.05 on them; the least is %.4Lf\n", said, close,
                  least_seen);
    assert_true(said > 20000 && close > 100);
    assert_true(least_seen > 0.01L); /* and rounding, some 2^-15 */
}

#define CURVE_TESTS                                                                                                    \
    numeric_test(quadratics_keep_their_bound), numeric_test(middles_of_edges_are_unit),                                \
        numeric_test(curves_said_to_be_positive_are)

#endif
