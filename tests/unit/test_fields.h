/* SPDX-License-Identifier: MIT */
/*
 * Fields over a triangle against long double: the normal, cosines, the length by a curve, rates, highlights. Set up as
 * the library does, and read at pixels that the triangle covers. Compiled once for each backend, whose test defines the
 * scale of each quantity (M_ONE, DOT_ONE, SQUARE_ONE, LENGTH_ONE, UNIT_ONE, GAP_ONE) and the budgets.
 */
#ifndef GLINT_TESTS_UNIT_TEST_FIELDS_H
#define GLINT_TESTS_UNIT_TEST_FIELDS_H

#include "tests/unit/directions.h"
#include "tests/unit/numeric.h"

#include "raster/edges.h"

#define ROUNDS 60000
#define ORDINARY_PX 320 /* a display as microcontrollers have it */

typedef struct field_triangle {
    glint_screen_vertex corner[3];
    glint_edges edges;
    glint_gradients gradients;
    real value[3][3]; /* component by corner, as the library stores it */
    attribute_plane m[3];
} field_triangle;

/* A number of the backend's in units of `one`. */
static inline long double scaled(real value, long double one)
{
    return (long double)value / one;
}

/* As the backend holds a unit vector. */
static inline void unit_of(const long double v[3], real out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = (real)(UNIT_ONE == 1 ? v[k] : rintl(v[k] * UNIT_ONE));
    }
}

/* Within a display of size_px, from a pixel to all of it and beyond; no slivers. Normals that differ by up to a right
 * angle, with weights from 1/2 to 1. */
static inline bool random_field(field_triangle *t, int size_px, long double bend)
{
    const long double most = fminl(2 * size_px, 2 * GLINT_GUARD_PX - 1); /* beyond the guard band it is clipped */
    const long double size = exp2l(random_unit() * log2l(most)) * GLINT_FINE;
    glint_point snapped[3];
    long double base[3];
    for (int i = 0; i < 3; i++) {
        glint_screen_vertex *v = &t->corner[i];
        v->x = (int32_t)(size_px * GLINT_FINE / 2 + (random_unit() - 0.5L) * size);
        v->y = (int32_t)(size_px * GLINT_FINE / 2 + (random_unit() - 0.5L) * size);
        v->depth_q30 = GLINT_DEPTH_BIAS + GLINT_DEPTH_SPAN / 2 + random_between(0, 1 << 20);
        snapped[i] = glint_snap(v);
    }
    const int64_t area = glint_signed_area(snapped);
    glint_box box;
    glint_bounding_box(&box, snapped, (uint16_t)size_px, (uint16_t)size_px);
    if (area == 0 || box.x_first > box.x_last || box.y_first > box.y_last) {
        return false;
    }
    const glint_screen_vertex *const corner[3] = {&t->corner[0], &t->corner[1], &t->corner[2]};
    glint_edges_set_up(&t->edges, snapped, area > 0, box);
    glint_gradients_set_up(&t->gradients, corner, t->edges.order);
    if (t->gradients.sliver) {
        return false;
    }
    random_direction(base);
    for (int i = 0; i < 3; i++) {
        long double aside[3], n[3], length = 0;
        const uint16_t weight = (uint16_t)(i == 0 ? 32768 : random_between(16384, 32768));
        real stored[3];
        random_direction(aside);
        for (int k = 0; k < 3; k++) {
            n[k] = base[k] + bend * aside[k];
            length += n[k] * n[k];
        }
        for (int k = 0; k < 3; k++) {
            n[k] /= sqrtl(length);
        }
        unit_of(n, stored);
        for (int k = 0; k < 3; k++) {
            t->value[k][i] = field_weigh(stored[k], weight);
        }
    }
    for (int k = 0; k < 3; k++) {
        attribute_plane_set_up(&t->m[k], &t->gradients, t->value[k]);
    }
    return true;
}

/* M at a pixel's centre from the stored values, and its change a pixel to the right and down. */
static inline void exact_m(const field_triangle *t, int x, int y, long double m[3], long double right[3],
                           long double down[3])
{
    const glint_gradients *g = &t->gradients;
    const int64_t px = (int64_t)x * GLINT_FINE + GLINT_FINE / 2, py = (int64_t)y * GLINT_FINE + GLINT_FINE / 2;
    long double b[2], slope[2][2];
    for (int i = 0; i < 2; i++) {
        const glint_screen_vertex *from = g->corner[i ? 0 : 2], *to = g->corner[i ? 1 : 0];
        const int64_t dx = (int64_t)to->x - from->x, dy = (int64_t)to->y - from->y;
        b[i] = (long double)(dx * (py - from->y) - dy * (px - from->x)) / (long double)g->area;
        slope[i][0] = (long double)(-dy * GLINT_FINE) / (long double)g->area;
        slope[i][1] = (long double)(dx * GLINT_FINE) / (long double)g->area;
    }
    for (int k = 0; k < 3; k++) {
        const long double v0 = scaled(t->value[k][0], M_ONE), v1 = scaled(t->value[k][1], M_ONE) - v0,
                          v2 = scaled(t->value[k][2], M_ONE) - v0;
        m[k] = v0 + b[0] * v1 + b[1] * v2;
        right[k] = slope[0][0] * v1 + slope[1][0] * v2;
        down[k] = slope[0][1] * v1 + slope[1][1] * v2;
    }
}

typedef struct field_worst {
    long double cosine, first, second, normal; /* errors over what is stated */
    long double rate_right, rate, rate_loose;
    long pixels;
} field_worst;

static inline long double curve_real(const glint_curve *curve, int degree, long double y)
{
    return (curve->c_q15[0] + (degree >= 1 ? y * (curve->c_q15[1] + (degree == 2 ? y * curve->c_q15[2] : 0)) : 0)) /
           32768.0L;
}

/* What a triangle is drawn by: the fields of a light, and of the length by a curve of each degree. */
typedef struct triangle_fields {
    long double light[3];
    attribute_plane dot;
    field_quadratic square[GLINT_CURVE_DEGREES];
    field_curve polynomial[GLINT_CURVE_DEGREES];
    glint_curve curve[GLINT_CURVE_DEGREES];
    bool usable;
} triangle_fields;

/* The greatest |dx| + |dy| from the anchor to a pixel of the triangle's box. */
static inline uint32_t reach_of(const field_triangle *t)
{
    const glint_box *box = &t->edges.box;
    const int ends[2][2] = {{box->x_first - t->gradients.anchor_x, box->x_last - t->gradients.anchor_x},
                            {box->y_first - t->gradients.anchor_y, box->y_last - t->gradients.anchor_y}};
    uint32_t reach = 0;
    for (int i = 0; i < 2; i++) {
        const int one = abs(ends[i][0]), other = abs(ends[i][1]);
        reach += (uint32_t)(one > other ? one : other);
    }
    return reach;
}

static inline void fields_set_up(const field_triangle *t, triangle_fields *f, uint8_t class)
{
    real light[3];
    random_direction(f->light);
    unit_of(f->light, light);
    for (int k = 0; k < 3; k++) {
        f->light[k] = scaled(light[k], UNIT_ONE);
    }
    field_dot(&f->dot, t->m, light);
    f->usable = true;
    for (uint8_t degree = 1; degree < GLINT_CURVE_DEGREES; degree++) {
        glint_curve_of(class, degree, &f->curve[degree]);
        field_curve_from(&f->polynomial[degree], &f->curve[degree]);
        f->usable = field_square_set_up(&f->square[degree], t->m, &f->curve[degree],
                                        (uint8_t)(GLINT_TIER_Q1 + degree - 1), reach_of(t)) &&
                    f->usable;
    }
}

static inline void check_pixel(const field_triangle *t, const triangle_fields *f, int16_t x, int16_t y,
                               field_worst *worst)
{
    long double m[3], right[3], down[3], n[3];
    real unit_normal[3];
    exact_m(t, x, y, m, right, down);
    const long double square = dot3(m, m), length = sqrtl(square);
    const long double away = labs((long)x - t->gradients.anchor_x) + labs((long)y - t->gradients.anchor_y),
                      way = 1 + away * sqrtl(worse(dot3(right, right), dot3(down, down)));
    if (1 - square > 0.5L) {
        return; /* no tier serves it */
    }
    worst->pixels++;
    worst->cosine =
        worse(worst->cosine, fabsl(((long double)attribute_at(&f->dot, &t->gradients, x, y) - DOT_HALF) / DOT_ONE -
                                   dot3(m, f->light)) /
                                 COSINE_ERROR(away, way));
    for (int degree = 1; degree < GLINT_CURVE_DEGREES; degree++) {
        const field_row row = field_quadratic_at(&f->square[degree], &t->gradients, x, y);
        const long double at = scaled(field_length(row.value, &f->polynomial[degree], degree == 2), LENGTH_ONE);
        const long double error = fabsl(at - curve_real(&f->curve[degree], degree, 1 - square));
        long double *of_degree = degree == 1 ? &worst->first : &worst->second;
        *of_degree = worse(*of_degree, error / LENGTH_ERROR(away, way));
    }
    field_normal(t->m, &t->gradients, x, y, unit_normal);
    long double off = 0;
    for (int k = 0; k < 3; k++) {
        n[k] = scaled(unit_normal[k], UNIT_ONE) - m[k] / length;
        off += n[k] * n[k];
    }
    worst->normal = worse(worst->normal, sqrtl(off) / NORMAL_ERROR(away));
}

/* Pixels of some rows: both ends, and one between; in the fixed backend a row's steps lead to the very same value. */
static inline void check_rows(const field_triangle *t, const triangle_fields *f, field_worst *worst)
{
    const glint_box *box = &t->edges.box;
    for (int i = 0; i < 4; i++) {
        const int16_t row = (int16_t)(i == 0   ? box->y_first
                                      : i == 1 ? box->y_last
                                               : random_between(box->y_first, box->y_last));
        glint_spans spans;
        int16_t y, x_first, x_last;
        glint_spans_begin(&spans, &t->edges, row, row);
        while (glint_spans_next(&spans, &y, &x_first, &x_last)) {
            const int16_t between = (int16_t)random_between(x_first, x_last);
            check_pixel(t, f, x_first, y, worst);
            check_pixel(t, f, between, y, worst);
            check_pixel(t, f, x_last, y, worst);
            if (FIELD_STEPS_EXACT) {
                field_row at = field_quadratic_at(&f->square[2], &t->gradients, x_first, y);
                const field_row there = field_quadratic_at(&f->square[2], &t->gradients, between, y);
                for (int16_t x = x_first; x < between; x++) {
                    at.value += at.step;
                    at.step += at.bend;
                }
                assert_true(memcmp(&at, &there, sizeof at) == 0);
            }
        }
    }
}

static inline void check_rates(const field_triangle *t, field_worst *worst)
{
    long double m[3], right[3], down[3];
    uint32_t along;
    const uint32_t most = field_rate_q20(t->m, &along);
    exact_m(t, t->gradients.anchor_x, t->gradients.anchor_y, m, right, down);
    const long double x = sqrtl(dot3(right, right)) * 1048576, y = sqrtl(dot3(down, down)) * 1048576;
    worst->rate_right = worse(worst->rate_right, x - along);
    worst->rate = worse(worst->rate, worse(x, y) - most);
    worst->rate_loose = worse(worst->rate_loose, (most - worse(x, y)) / (worse(x, y) / 2048 + 4));
}

static inline void measure_fields(int size_px, field_worst *worst)
{
    long usable = 0, all = 0;
    memset(worst, 0, sizeof *worst);
    worst->rate_right = worst->rate = -1e9L;
    for (int round = 0; round < ROUNDS; round++) {
        field_triangle t;
        triangle_fields f;
        const long double bend = exp2l(-10 * random_unit()) * 0.7L;
        if (!random_field(&t, size_px, bend)) {
            continue;
        }
        fields_set_up(&t, &f, (uint8_t)random_between(0, GLINT_CURVE_CLASSES - 1));
        all++;
        usable += f.usable;
        if (f.usable) {
            check_rows(&t, &f, worst);
        }
        check_rates(&t, worst);
    }
    print_message("    display of %d px: %ld triangles, %ld refused, %ld pixels\n", size_px, all, all - usable,
                  worst->pixels);
    assert_true(usable > all / 2 && worst->pixels > 100000);
}

static inline void expect_fields(int size_px)
{
    field_worst worst;
    measure_fields(size_px, &worst);
    expect_at_most("M.v at a pixel, over its bound", worst.cosine, 1);
    expect_at_most("the length by a curve of first degree, over its bound", worst.first, 1);
    expect_at_most("the length by a curve of second degree, over its bound", worst.second, 1);
    expect_at_most("the unit normal, over its bound", worst.normal, 1);
    expect_at_most("rate to the right, below the true one, Q20", worst.rate_right, 0);
    expect_at_most("rate below the true one, Q20", worst.rate, 0);
    expect_at_most("rate above the true one, over 2^-11 of it and 4 units", worst.rate_loose, 1);
}

static inline void fields_keep_their_bound(void **state)
{
    (void)state;
    expect_fields(ORDINARY_PX);
}

/* On the largest display roundings of steps add up over more pixels. */
static inline void fields_keep_it_on_large_displays(void **state)
{
    (void)state;
    expect_fields(GLINT_MAX_SIZE_PX);
}

static inline void rays_are_unit(void **state)
{
    long double worst = 0;
    (void)state;
    for (int round = 0; round < 300000; round++) {
        pixel_rays rays;
        long double exact[3], off = 0;
        real got[3];
        const int16_t x = (int16_t)random_between(0, 319), y = (int16_t)random_between(0, 239);
        random_ray(&rays, exact, x, y);
        ray_unit(&rays, x, y, got);
        const long double length = sqrtl(dot3(exact, exact));
        for (int k = 0; k < 3; k++) {
            const long double d = scaled(got[k], UNIT_ONE) - exact[k] / length;
            off += d * d;
        }
        worst = worse(worst, sqrtl(off));
    }
    expect_bound("the unit vector along a ray", worst, RAY_ERROR);
}

/* The angle between r and c as the gap has it, for directions rounded as they are stored. */
static inline void gaps_are_of_the_angle(void **state)
{
    long double worst = 0;
    (void)state;
    for (int round = 0; round < 2000000; round++) {
        long double n[3], s[3], r[3], c[3], aside[3], length = 0, apart = 0;
        real n_stored[3], s_stored[3], ray[3];
        random_direction(n);
        random_direction(s);
        random_direction(aside);
        const long double twice = 2 * dot3(n, s), away = round & 1 ? exp2l(-16 * random_unit()) : 4;
        for (int k = 0; k < 3; k++) {
            r[k] = twice * n[k] - s[k];
            c[k] = r[k] + away * aside[k];
            length += c[k] * c[k];
        }
        for (int k = 0; k < 3; k++) {
            c[k] /= -sqrtl(length); /* the ray */
            apart += (r[k] + c[k]) * (r[k] + c[k]);
        }
        unit_of(n, n_stored);
        unit_of(s, s_stored);
        unit_of(c, ray);
        const long double gap = scaled(field_gap(n_stored, s_stored, ray), GAP_ONE);
        worst = worse(worst, fabsl(sqrtl(2 * fmaxl(gap, 0)) - sqrtl(apart)));
    }
    expect_bound("|r - c| by the gap", worst, GAP_ERROR);
}

static inline void rows_of_gaps_are_quadratic(void **state)
{
    long double worst[4] = {0, 0, 0, 0};
    (void)state;
    for (int round = 0; round < 1000000; round++) {
        const int log2 = random_between(1, 3), apart = 1 << log2;
        const long double size = exp2l(-20 * random_unit());
        wide_gap f[3];
        gap_row row;
        for (int i = 0; i < 3; i++) {
            f[i] = (wide_gap)(random_unit() * size * 2 * GAP_ONE);
        }
        gap_row_through(&row, f[0], f[1], f[2], log2);
        const long double first = scaled(f[0], 1), second = scaled(f[1], 1), third = scaled(f[2], 1);
        const long double bend = first - 2 * second + third, slope = second - first - bend / 2;
        for (int i = 0; i < 2 * apart; i++) {
            const long double t = (long double)i / apart;
            const long double exact = first + t * slope + t * t * bend / 2;
            worst[log2] = worse(worst[log2], fabsl((long double)gap_row_next(&row) - exact) / GAP_ONE);
        }
    }
    expect_at_most("gaps between pixels 2 apart", worst[1], GAP_ROW_ERROR);
    expect_at_most("gaps between pixels 4 apart", worst[2], GAP_ROW_ERROR);
    expect_bound("gaps between pixels 8 apart", worst[3], GAP_ROW_ERROR);
}

#endif
