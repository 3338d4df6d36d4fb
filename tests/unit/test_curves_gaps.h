/* SPDX-License-Identifier: MIT */
/*
 * Gaps of highlights at points of a triangle (lighting/gloss_*.h) against the same geometry in long double, from what
 * the library has rounded before; and cubics through them (raster/lattice_*.h) against the same polynomial at pixels.
 * See test_curves.h.
 */
#ifndef GLINT_TESTS_UNIT_TEST_CURVES_GAPS_H
#define GLINT_TESTS_UNIT_TEST_CURVES_GAPS_H

#include "tests/unit/test_curves.h"

/* The library's centroid is rounded to 1/4096 px, like vertices; a cubic is laid about it. From that to the true one:
 */
static inline void centroid_aside(const curve_triangle *t, int32_t aside[2])
{
    const int32_t x = t->centre.x * GLINT_FINE + GLINT_FINE / 2 - CENTRE_OFFSET(t->centre.offset_x),
                  y = t->centre.y * GLINT_FINE + GLINT_FINE / 2 - CENTRE_OFFSET(t->centre.offset_y);
    aside[0] = t->vertex[0].x + t->vertex[1].x + t->vertex[2].x - 3 * x;
    aside[1] = t->vertex[0].y + t->vertex[1].y + t->vertex[2].y - 3 * y;
    assert_true(abs(aside[0]) <= 3 && abs(aside[1]) <= 3);
}

/* The polynomial through values at the points of gloss_point, by Lagrange. */
static inline long double cubic_at(const gap_value value[LATTICE_POINTS], const long double b[3])
{
    long double sum = 0;
    for (int i = 0; i < LATTICE_POINTS; i++) {
        long double product = 1;
        for (int k = 0; k < 3; k++) {
            for (int m = 0; m < gloss_point[i][k]; m++) {
                product *= (3 * b[k] - m) / (m + 1);
            }
        }
        sum += product * (long double)value[i];
    }
    return sum;
}

/* ----------------------------------------------------------------------------------------------------- highlights */

/* Rays of a camera turned at random; the display's half is at most 1 from its middle, so that no ray is longer
 * than sqrt(3). */
static inline void random_rays(pixel_rays *rays, int size_px)
{
    long double forward[3], aside[3], right[3], down[3];
    const long double step = 2 * exp2l(-3 * random_unit()) / size_px;
    random_direction(forward);
    do {
        random_direction(aside);
    } while (fabsl(dot3(forward, aside)) > 0.9L);
    for (int k = 0; k < 3; k++) {
        right[k] = forward[(k + 1) % 3] * aside[(k + 2) % 3] - forward[(k + 2) % 3] * aside[(k + 1) % 3];
    }
    const long double length = sqrtl(dot3(right, right));
    for (int k = 0; k < 3; k++) {
        right[k] /= length;
    }
    for (int k = 0; k < 3; k++) {
        down[k] = forward[(k + 1) % 3] * right[(k + 2) % 3] - forward[(k + 2) % 3] * right[(k + 1) % 3];
    }
    for (int k = 0; k < 3; k++) {
        rays->v[1][k] = (real)(right[k] * step * RAY_ONE);
        rays->v[2][k] = (real)(down[k] * step * RAY_ONE);
        rays->v[0][k] = (real)((forward[k] - (right[k] + down[k]) * step * (size_px - 1) / 2) * RAY_ONE);
    }
    set_ray_fraction(rays);
}

/* What the library knows of a triangle with normals and rays at its corners. */
typedef struct gloss_case {
    curve_triangle t;
    gloss_corners corners;
    real towards[3];
    long double turn;
} gloss_case;

/* Every second one with the light where its highlight shows. */
static inline bool random_gloss(gloss_case *c, int size_px)
{
    long double base[3], n[3], s[3], eye[3], square = 1;
    real normal[3][3];
    pixel_rays rays;
    uint16_t weight_q15[3];
    const real *const normals[3] = {normal[0], normal[1], normal[2]};
    const long double bend = exp2l(-8 * random_unit()) * 0.25L, drop = random_u32() & 1 ? 0 : 0.2L * random_unit();
    if (!random_triangle(&c->t, size_px)) {
        return false;
    }
    random_rays(&rays, size_px);
    random_direction(base);
    for (int i = 0; i < 3; i++) {
        near_direction(base, bend, n);
        stored_normal(n, normal[i]);
        weight_q15[i] = (uint16_t)(32768 - (i == 1 ? 0 : drop * 32768 * random_unit()));
    }
    if (!gloss_corners_set_up(&c->corners, &rays, c->t.screen, normals, c->t.edges.order, weight_q15)) {
        return false;
    }
    random_direction(s);
    for (int k = 0; k < 3; k++) {
        eye[k] = -(long double)corner_ray(&c->corners, 0, k);
    }
    if (random_u32() & 1) { /* mirrored: about twice (n.c) n - c */
        const long double length = sqrtl(dot3(eye, eye)), twice = 2 * dot3(base, eye) / length;
        for (int k = 0; k < 3; k++) {
            n[k] = twice * base[k] - eye[k] / length;
        }
        near_direction(n, 0.3L * random_unit(), s);
    }
    stored_normal(s, c->towards);
    for (int i = 0; i < LATTICE_POINTS; i++) {
        long double m[3];
        gloss_m(&c->corners, gloss_point[i], m);
        square = fminl(square, dot3(m, m));
    }
    return square > 0.55L; /* the tier serves no other */
}

/* |M|^2 and |M|^2 (1 - r.c), as gloss_fixed.h has it for an s that is not quite a unit vector. */
static inline long double exact_gap(const gloss_case *c, const uint8_t point[3], long double *square)
{
    long double m[3], ray[3], s[3];
    gloss_m(&c->corners, point, m);
    for (int k = 0; k < 3; k++) {
        ray[k] = 0;
        for (int i = 0; i < 3; i++) {
            ray[k] += point[i] / 3.0L * corner_ray(&c->corners, i, k);
        }
        s[k] = (long double)c->towards[k] / UNIT_ONE;
    }
    const long double length = sqrtl(dot3(ray, ray));
    *square = dot3(m, m);
    return *square * ((dot3(s, s) + 1) / 2 - dot3(s, ray) / length) + 2 * dot3(m, s) * dot3(m, ray) / length;
}

typedef struct gloss_worst {
    long double value, inverse, inverse_used, view_low, view_high;
    long cases;
} gloss_worst;

static inline void check_view(const gloss_case *c, gloss_worst *worst)
{
    long double edge = 0, least = 1e9L;
    for (int i = 0; i < 3; i++) {
        long double d[3];
        for (int k = 0; k < 3; k++) {
            d[k] = corner_ray(&c->corners, i, k) - corner_ray(&c->corners, (i + 1) % 3, k);
        }
        edge = worse(edge, sqrtl(dot3(d, d)));
    }
    enum { GRID = 12 };
    for (int i = 0; i <= GRID; i++) {
        for (int j = 0; j <= GRID - i; j++) {
            long double r[3];
            for (int k = 0; k < 3; k++) {
                r[k] = (i * corner_ray(&c->corners, 0, k) + j * corner_ray(&c->corners, 1, k) +
                        (GRID - i - j) * corner_ray(&c->corners, 2, k)) /
                       GRID;
            }
            least = fminl(least, sqrtl(dot3(r, r)));
        }
    }
    const uint32_t got = gloss_view_q16(&c->corners);
    if (got == UINT16_MAX) {
        assert_true(edge * edge > 0.24L);
        return;
    }
    worst->view_low = worse(worst->view_low, edge / least * 65536 - got);
    worst->view_high = worse(worst->view_high, (got - 8) / (edge / least * 65536 + 1));
}

/* m/x by the polynomial through what the library has at the corners and in the middles of the edges, at points all over
 * the triangle: within what it says, and what is counted for rounding. */
static inline void check_inverse(const gloss_case *c, const gloss_inverse *inverse, gloss_worst *worst)
{
    enum { GRID = 12 };
    const long double over_m = (long double)inverse->over_m / OVER_M_ONE, part = (long double)inverse->part / PART_ONE;
    long double most = 0;
    for (int i = 0; i <= GRID; i++) {
        for (int j = 0; j <= GRID - i; j++) {
            const long double b[3] = {(long double)i / GRID, (long double)j / GRID, (long double)(GRID - i - j) / GRID};
            long double m[3];
            for (int k = 0; k < 3; k++) {
                m[k] = 0;
                for (int n = 0; n < 3; n++) {
                    m[k] += b[n] * corner_m(&c->corners, n, k);
                }
            }
            const long double square = dot3(m, m) * over_m;
            assert_true(fabsl(1 - square) <= part + 1e-4L);
            const long double g = quadratic_at(inverse->corner, inverse->middle, b);
            most = worse(most, fabsl(GAP_INVERSE(g, inverse) * square - 1));
        }
    }
    worst->inverse = worse(worst->inverse, most - inverse->error_q22 / 4194304.0L);
    worst->inverse_used = worse(worst->inverse_used, (most - INVERSE_SQUARE_ERROR) / (inverse->error_q22 / 4194304.0L));
}

static inline void gaps_at_points_are_of_the_geometry(void **state)
{
    gloss_worst worst;
    (void)state;
    memset(&worst, 0, sizeof worst);
    worst.view_low = -65536;
    for (int round = 0; round < ROUNDS; round++) {
        gloss_case c;
        gap_value value[LATTICE_POINTS];
        gloss_inverse inverse;
        gloss_points points;
        if (!random_gloss(&c, ORDINARY_PX) || !gloss_inverse_square(&inverse, &c.corners)) {
            continue;
        }
        gloss_points_of(&points, &c.corners);
        const int down = gloss_values(&c.corners, &points, &inverse, c.towards, value);
        const long double over_m = (long double)inverse.over_m / OVER_M_ONE;
        worst.cases++;
        for (int i = 0; i < LATTICE_POINTS; i++) {
            long double square;
            const long double gap = exact_gap(&c, gloss_point[i], &square) * over_m;
            assert_true(fabsl((long double)value[i]) < GAP_VALUE_MOST);
            const long double error = fabsl((long double)value[i] / GAP_VALUE_ONE(down) - gap);
            worst.value = worse(worst.value, error - GAP_CUT(down) - fabsl(gap) * GAP_VALUE_SCALE);
        }
        check_inverse(&c, &inverse, &worst);
        check_view(&c, &worst);
    }
    assert_true(worst.cases > ROUNDS / 4);
    expect_at_most("|M|^2 times a gap at a point", worst.value, GAP_VALUE_ERROR);
    expect_at_most("1/|M|^2, relative, beyond what its curve is off", worst.inverse, INVERSE_SQUARE_ERROR);
    expect_at_most("without rounding, over what it is off", worst.inverse_used, 1);
    assert_true(worst.inverse_used > 0.5L);
    expect_at_most("turn of the rays beyond its bound, units of Q16", worst.view_low, 0);
    expect_at_most("the bound less 8 units over that turn", worst.view_high, 1.15L);
}

/* ---------------------------------------------------------------------------------------------------------- cubics */

typedef struct cubic_worst {
    long double over[CUBIC_CLASSES]; /* by how the bound counts them */
    long pixels[CUBIC_CLASSES];
} cubic_worst;

static inline void check_cubic_rows(const curve_triangle *t, const field_cubic *field, int16_t x, int16_t y)
{
    const long double away = abs(x - t->centre.x) + abs(y - t->centre.y) + 64, way = way_of(t, away);
    const int16_t from = row_start(t, x, y), top = t->edges.box.y_first;
    cubic_column column = cubic_column_at(field, &t->centre, top);
    for (int16_t row = top; row < y; row++) {
        cubic_column_next(&column);
    }
    const cubic_row there = field_cubic_at(field, &t->centre, x, y);
    const cubic_row by_column = cubic_column_row(&column, x - t->centre.x);
    cubic_row stepped = cubic_column_row(&column, from - t->centre.x), skipped = stepped;
    for (int16_t i = from; i < x; i++) {
        cubic_row_next(&stepped);
    }
    cubic_row_skip(&skipped, (uint16_t)(x - from));
    assert_memory_equal(&by_column, &there, sizeof there);
    ASSERT_STEPPED(&stepped, &there, way * way * way);
    ASSERT_STEPPED(&skipped, &there, way * way * way);
}

static inline void check_cubic(const curve_triangle *t, const gap_value value[LATTICE_POINTS], cubic_worst *worst)
{
    const int up = lattice_spare_bits(&t->lattice), class = cubic_class(up);
    field_cubic field;
    int32_t aside[2];
    if (class < 0) {
        return;
    }
    centroid_aside(t, aside);
    lattice_cubic(&field, &t->lattice, &t->centre, value);
    for (int i = 0; i < PIXELS; i++) {
        long double b[3];
        int16_t x, y;
        if (!random_pixel(t, &x, &y, b)) {
            continue;
        }
        const long double away = abs(x - t->centre.x) + abs(y - t->centre.y);
        if (away > CUBIC_REACH) {
            continue;
        }
        const cubic_row row = field_cubic_at(&field, &t->centre, x, y);
        (void)coordinates_beside(t, x, y, aside, b);
        const long double exact = cubic_at(value, b) * CUBIC_UP, error = fabsl(FIELD_VALUE(row.value) - exact);
        worst->over[class] = worse(worst->over[class], error / cubic_budget(class, away, way_of(t, away), value));
        worst->pixels[class]++;
        if (i == 0) {
            check_cubic_rows(t, &field, x, y);
        }
    }
}

static inline void expect_cubics(const cubic_worst *worst)
{
    for (int class = 0; class < CUBIC_CLASSES; class ++) {
        print_message("    %s: %ld pixels\n", cubic_class_name[class], worst->pixels[class]);
        expect_at_most("a cubic at a pixel, over its bound", worst->over[class], 1);
        assert_true(worst->pixels[class] > 10000 && worst->over[class] > BUDGET_BITES);
    }
}

/* Of a light's gap, as the tier of curves has it. */
static inline void cubics_of_highlights_keep_their_bound(void **state)
{
    cubic_worst gap;
    (void)state;
    memset(&gap, 0, sizeof gap);
    for (int round = 0; round < 2 * ROUNDS; round++) {
        gloss_case c;
        gap_value value[LATTICE_POINTS];
        gloss_inverse inverse;
        gloss_points points;
        if (random_gloss(&c, ORDINARY_PX) && gloss_inverse_square(&inverse, &c.corners)) {
            gloss_points_of(&points, &c.corners);
            (void)gloss_values(&c.corners, &points, &inverse, c.towards, value);
            check_cubic(&c.t, value, &gap);
        }
    }
    expect_cubics(&gap);
}

/* Of any values: what their coefficients leave room for. */
static inline void cubics_of_any_values_keep_it(void **state)
{
    cubic_worst worst;
    (void)state;
    memset(&worst, 0, sizeof worst);
    for (int round = 0; round < 2 * ROUNDS; round++) {
        curve_triangle t;
        gap_value value[LATTICE_POINTS];
        if (random_triangle(&t, ORDINARY_PX)) {
            random_values(value, LATTICE_POINTS, GAP_VALUE_MOST, CUBIC_APART);
            check_cubic(&t, value, &worst);
        }
    }
    expect_cubics(&worst);
}

/* A row that is said to be above a limit is, at every pixel; and rows that are far above it are said to be. */
static inline void rows_above_a_limit_are(void **state)
{
    long above = 0, missed = 0, near = 0;
    (void)state;
    for (int round = 0; round < 400000; round++) {
        const long double size = exp2l(26 * random_unit()) * ROW_UNIT;
        const uint16_t count = (uint16_t)random_between(1, 64);
        const long double n = count;
        cubic_row row;
        ROW_SET(row.value, 8 * size * (random_unit() - 0.3L));
        ROW_SET(row.step, 16 * size * (random_unit() - 0.5L) / n);
        ROW_SET(row.bend, 32 * size * (random_unit() - 0.5L) / (n * n));
        ROW_SET(row.third, 64 / 3.0L * size * (random_unit() - 0.5L) / (n * n * n));
        const gap_value limit = (gap_value)(size * (random_unit() - 0.5L));
        long double least = FIELD_VALUE(row.value), most = least;
        cubic_row at = row;
        for (int i = 0; i < count; i++) {
            least = fminl(least, FIELD_VALUE(at.value));
            most = fmaxl(most, FIELD_VALUE(at.value));
            cubic_row_next(&at);
        }
        const bool said = cubic_row_above(&row, count, limit);
        assert_true(!said || least > (long double)limit - ROW_SLACK * size);
        above += said;
        near += said && least < (long double)limit + 2 * size;
        missed += !said && least > (long double)limit + (most - least) + 8 * size && bend_is_counted(&row, count);
    }
    print_message("    %ld rows above, %ld of them just so\n", above, near);
    assert_true(above > 20000 && near > 1000);
    assert_int_equal(missed, 0);
}

/* The place in the table from values of the two polynomials. */
static inline void places_are_products_of_the_polynomials(void **state)
{
    long double worst = 0;
    long beyond = 0, within = 0;
    (void)state;
    for (int round = 0; round < 1000000; round++) {
        const uint8_t bits = (uint8_t)random_between(0, 19);
        const uint16_t cells = (uint16_t)random_between(bits == 0 ? 1 : GLINT_GLOSS_CELLS / 2, GLINT_GLOSS_CELLS);
        const long double part = random_unit() / 3, square = 1 + part * (2 * random_unit() - 1);
        const long double end = ldexpl(cells, bits - 28), gap = end * 1.5L * powl(random_unit(), round & 1 ? 1 : 4);
        const int down = random_down(gap);
        const gloss_inverse inverse = {.part = PART_OF(part)};
        const gap_scale scale = gap_scale_of(cells, bits, down, &inverse);
        const long double value = square * gap * GAP_VALUE_ONE(down) * CUBIC_UP + (long double)scale.half;
        const gap_value at = (gap_value)value;
        assert_true(value < 1073741824.0L + 536870912.0L);
        if (!GAP_WITHIN(at, &scale)) {
            beyond++;
            assert_true(gap > end); /* where the factor is 0 */
            continue;
        }
        within++;
        const long double got = ldexpl(GAP_PLACE(at, 1 / square, &scale), bits - GAP_BITS - 28);
        const long double error = fabsl(got - gap) - CUBIC_UNIT(down) / square;
        worst = worse(worst, error / (end * GAP_END_ERROR(part) + gap * GAP_ERROR + exp2l(-28)));
    }
    assert_true(beyond > 10000 && within > 100000);
    expect_bound("a place in the table from values of the polynomials, over its bound", worst, 1);
}

#define GAP_TESTS                                                                                                      \
    numeric_test(gaps_at_points_are_of_the_geometry), numeric_test(cubics_of_highlights_keep_their_bound),             \
        numeric_test(cubics_of_any_values_keep_it), numeric_test(rows_above_a_limit_are),                              \
        numeric_test(places_are_products_of_the_polynomials)

#endif
