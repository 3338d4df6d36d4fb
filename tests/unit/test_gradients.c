/* SPDX-License-Identifier: MIT */
/*
 * Barycentric gradients and planes against exact rational interpolation from the corners before snapping, at pixels
 * that the snapped triangle covers.
 */
#include "tests/unit/numeric.h"

#include "raster/edges.h"
#include "raster/plane.h"

/* Budgets, as raster/gradients.h and raster/plane.h state them. */
#define GRADIENT_ULP 2.0L                /* of the last bit, and ... */
#define GRADIENT_RELATIVE_LOG2 (-28.3L)  /* of the gradient */
#define PLANE_PER_PIXEL 7.0L             /* units a pixel from the anchor, and ... */
#define PLANE_UNITS 12.0L                /* at the anchor, of which 4 for the reciprocal */
#define WEIGHT_LOG2 (-27.0L)             /* before clamping */
#define OUTSIDE_PER_GRADIENT 0.00390625L /* coordinates beyond 0..1, times the gradient a pixel: 2^-8 */

#define ONE_Q30 1073741824.0L
#define ROUNDS 400000

typedef struct triangle {
    glint_screen_vertex corner[3];
    glint_edges edges;
    glint_gradients gradients;
} triangle;

static int32_t into_guard(long double value, int size_px)
{
    const int32_t centre = size_px * (GLINT_FINE / 2), guard = GLINT_GUARD_PX * GLINT_FINE;
    return value < centre - guard ? centre - guard : value > centre + guard ? centre + guard : (int32_t)value;
}

/* Length from 1/16 px to the whole guard band, thickness from 1/4096 px to the length; any direction and winding. */
static bool random_triangle(triangle *t, int width, int height, bool steep)
{
    const long double length = exp2l(-4 + 15 * random_unit()) * GLINT_FINE;
    const long double thickness = length * exp2l(-random_unit() * 24), angle = random_unit() * 6.2831853L;
    const long double along = random_unit() * 3 - 1, dx = cosl(angle), dy = sinl(angle);
    const long double x = random_unit() * width * GLINT_FINE - length * dx * random_unit();
    const long double y = random_unit() * height * GLINT_FINE - length * dy * random_unit();
    const int first = random_between(0, 2);
    const long double at[3][2] = {{x, y},
                                  {x + length * dx, y + length * dy},
                                  {x + length * along * dx - thickness * dy, y + length * along * dy + thickness * dx}};
    glint_point snapped[3];
    for (int i = 0; i < 3; i++) {
        glint_screen_vertex *v = &t->corner[(i + first) % 3];
        v->x = into_guard(at[i][0], width);
        v->y = into_guard(at[i][1], height);
        v->depth_q30 = GLINT_DEPTH_BIAS + (!steep             ? random_between(0, GLINT_DEPTH_SPAN)
                                           : random_u32() & 1 ? GLINT_DEPTH_SPAN - (random_between(0, 2) ? 0 : 1)
                                                              : random_any_size(6) & 1);
        snapped[(i + first) % 3] = glint_snap(v);
    }
    if (random_u32() & 1) { /* depths of any range, at the ends of what there is */
        const int32_t range = (int32_t)magnitude32(random_any_size(30)) % GLINT_DEPTH_SPAN;
        const int32_t from = random_u32() & 1 ? GLINT_DEPTH_BIAS : GLINT_DEPTH_BIAS + GLINT_DEPTH_SPAN - range;
        for (int i = 0; i < 3; i++) {
            t->corner[i].depth_q30 = from + (steep ? (int32_t)(random_u32() & 1) * range : random_between(0, range));
        }
    }
    const int64_t area = glint_signed_area(snapped);
    glint_box box;
    glint_bounding_box(&box, snapped, (uint16_t)width, (uint16_t)height);
    if (area == 0 || box.x_first > box.x_last || box.y_first > box.y_last) {
        return false;
    }
    glint_edges_set_up(&t->edges, snapped, area > 0, box);
    const glint_screen_vertex *const corner[3] = {&t->corner[0], &t->corner[1], &t->corner[2]};
    glint_gradients_set_up(&t->gradients, corner, t->edges.order);
    return true;
}

/* Exact coordinates of corners 1 and 2 at a pixel's centre, and their change a pixel; the area must not be 0. */
static void exact_coordinates(const glint_gradients *g, int x, int y, long double b[2], long double slope[2][2])
{
    const int64_t px = (int64_t)x * GLINT_FINE + GLINT_FINE / 2, py = (int64_t)y * GLINT_FINE + GLINT_FINE / 2;
    for (int i = 0; i < 2; i++) {
        const glint_screen_vertex *from = g->corner[i ? 0 : 2], *to = g->corner[i ? 1 : 0];
        const int64_t dx = (int64_t)to->x - from->x, dy = (int64_t)to->y - from->y;
        b[i] = (long double)(dx * (py - from->y) - dy * (px - from->x)) / (long double)g->area;
        slope[i][0] = (long double)(-dy * GLINT_FINE) / (long double)g->area;
        slope[i][1] = (long double)(dx * GLINT_FINE) / (long double)g->area;
    }
}

typedef void (*pixel_check)(const triangle *t, int16_t x, int16_t y, void *context);

/* Some covered pixels of a triangle: up to eight rows, both ends of each and one between. */
static void at_covered_pixels(const triangle *t, pixel_check check, void *context)
{
    const int rows = t->edges.box.y_last - t->edges.box.y_first + 1;
    for (int k = 0; k < (rows < 8 ? rows : 8); k++) {
        const int16_t row = (int16_t)(t->edges.box.y_first + (rows <= 8 ? k
                                                              : k == 0  ? 0
                                                              : k == 1  ? rows - 1
                                                                        : random_between(0, rows - 1)));
        glint_spans spans;
        int16_t y, x_first, x_last;
        glint_spans_begin(&spans, &t->edges, row, row);
        while (glint_spans_next(&spans, &y, &x_first, &x_last)) {
            check(t, x_first, y, context);
            check(t, x_last, y, context);
            check(t, (int16_t)random_between(x_first, x_last), y, context);
        }
    }
}

typedef struct tally {
    long triangles, slivers, pixels;
    long double gradient, weight, outside, plane_units, plane;
    int32_t depth_least, depth_greatest;
    glint_plane attribute, depth;
    int32_t v[3];
} tally;

static void check_plane_at(const triangle *t, int16_t x, int16_t y, void *context)
{
    tally *all = context;
    const glint_gradients *g = &t->gradients;
    long double b[2], slope[2][2];
    exact_coordinates(g, x, y, b, slope);
    for (int i = 0; i < 2; i++) {
        const long double beyond = b[i] < 0 ? -b[i] : b[i] > 1 ? b[i] - 1 : 0;
        all->outside = worse(all->outside, beyond / hypotl(slope[i][0], slope[i][1]));
    }
    const int n = abs(x - g->anchor_x) + abs(y - g->anchor_y);
    const long double exact =
        all->v[0] + b[0] * ((long double)all->v[1] - all->v[0]) + b[1] * ((long double)all->v[2] - all->v[0]);
    const long double error = fabsl((long double)glint_plane_at(&all->attribute, g, x, y) - exact);
    all->plane = worse(all->plane, error / (PLANE_PER_PIXEL * n + PLANE_UNITS));
    all->plane_units = worse(all->plane_units, error);
    all->pixels++;
}

/* The greatest error of the gradients in half last bits that a relative 2^-28.3 does not explain. */
static void check_gradients(const triangle *t, tally *all)
{
    const glint_gradients *g = &t->gradients;
    long double b[2], slope[2][2];
    exact_coordinates(g, 0, 0, b, slope);
    assert_true(g->offset_x >= -2047 && g->offset_x <= 2048 && g->offset_y >= -2047 && g->offset_y <= 2048);
    assert_int_equal(g->anchor_x * GLINT_FINE + GLINT_FINE / 2 - g->corner[0]->x, g->offset_x);
    assert_int_equal(g->anchor_y * GLINT_FINE + GLINT_FINE / 2 - g->corner[0]->y, g->offset_y);
    for (int i = 0; i < 2; i++) {
        const int32_t stored[2] = {g->x[i], g->y[i]};
        for (int k = 0; k < 2; k++) {
            const long double exact = ldexpl(slope[i][k], 30);
            const long double error = fabsl((long double)stored[k] - exact);
            all->gradient = worse(all->gradient, error - fabsl(exact) * exp2l(GRADIENT_RELATIVE_LOG2));
        }
    }
}

/* Attributes within +-2^29: random, or at the ends, where steps are greatest. */
static int32_t random_attribute(int round)
{
    const int32_t most = (int32_t)1 << 29;
    return round & 1 ? random_between(-most, most) : random_u32() & 1 ? most : -most;
}

static int random_size(int round)
{
    return round % 5 == 0 ? GLINT_MAX_SIZE_PX : random_between(1, GLINT_MAX_SIZE_PX);
}

static void planes_keep_their_bound(void **state)
{
    tally all;
    (void)state;
    memset(&all, 0, sizeof all);
    for (int round = 0; round < ROUNDS; round++) {
        triangle t;
        if (!random_triangle(&t, random_size(round), random_size(round / 5), false)) {
            continue;
        }
        all.triangles++;
        if (t.gradients.sliver) {
            all.slivers++;
            continue;
        }
        check_gradients(&t, &all);
        for (int i = 0; i < 3; i++) {
            all.v[i] = random_attribute(round);
        }
        glint_plane_set_up(&all.attribute, &t.gradients, all.v[0], all.v[1], all.v[2]);
        at_covered_pixels(&t, check_plane_at, &all);
    }
    print_message("    %ld triangles, %ld slivers, %ld pixels\n", all.triangles, all.slivers, all.pixels);
    assert_true(all.pixels > ROUNDS && all.slivers > 100);
    expect_at_most("coordinate beyond 0..1 by its gradient a pixel", all.outside, OUTSIDE_PER_GRADIENT);
    expect_at_most("gradient, last bits, less 2^-28.3 of it", all.gradient, GRADIENT_ULP);
    print_message("    plane, greatest error: %.0Lf units\n", all.plane_units);
    expect_at_most("plane, of its allowed units", all.plane, 1);
}

static void check_weights_at(const triangle *t, int16_t x, int16_t y, void *context)
{
    tally *all = context;
    int32_t weight[2];
    long double b[2] = {0, 0}, slope[2][2];
    glint_gradients_weights(&t->gradients, x, y, weight);
    all->pixels++;
    /* the third is what is left to 2^30, so the sum is exact when none of the three is negative */
    assert_true(weight[0] >= 0 && weight[1] >= 0 && (int64_t)weight[0] + weight[1] <= (int64_t)1 << 30);
    if (t->gradients.area > 0) {
        exact_coordinates(&t->gradients, x, y, b, slope);
        const long double first = fminl(fmaxl(b[0], 0), 1), second = fminl(fmaxl(b[1], 0), 1 - first);
        all->weight = worse(all->weight, fabsl(weight[0] / ONE_Q30 - first));
        all->weight = worse(all->weight, fabsl(weight[1] / ONE_Q30 - second));
    }
}

/* A value held at a pixel lies within its corners' range. */
static void check_weighed_at(const triangle *t, int16_t x, int16_t y, void *context)
{
    const tally *all = context;
    int32_t weight[2], least = all->v[0], greatest = all->v[0];
    glint_gradients_weights(&t->gradients, x, y, weight);
    const int32_t value = glint_plane_weigh(weight, all->v[0], all->v[1], all->v[2]);
    for (int i = 1; i < 3; i++) {
        least = all->v[i] < least ? all->v[i] : least;
        greatest = all->v[i] > greatest ? all->v[i] : greatest;
    }
    assert_true(value >= least && value <= greatest);
}

static void weights_of_slivers_are_clamped_and_exact(void **state)
{
    tally all;
    (void)state;
    memset(&all, 0, sizeof all);
    for (int round = 0; round < ROUNDS; round++) {
        triangle t; /* of all triangles: a bound that holds for any area holds for slivers */
        if (random_triangle(&t, random_size(round), random_size(round / 5), round & 1)) {
            all.slivers += t.gradients.sliver;
            for (int i = 0; i < 3; i++) {
                all.v[i] = random_attribute(round);
            }
            at_covered_pixels(&t, check_weights_at, &all);
            at_covered_pixels(&t, check_weighed_at, &all);
        }
    }
    print_message("    %ld slivers, %ld pixels\n", all.slivers, all.pixels);
    expect_at_most("glint_gradients_weights", all.weight, exp2l(WEIGHT_LOG2));
}

static void check_depth_at(const triangle *t, int16_t x, int16_t y, void *context)
{
    tally *all = context;
    const glint_gradients *g = &t->gradients;
    int32_t depth, weight[2];
    if (g->sliver) {
        glint_gradients_weights(g, x, y, weight);
        depth = glint_plane_weigh(weight, g->corner[0]->depth_q30, g->corner[1]->depth_q30, g->corner[2]->depth_q30);
    } else {
        depth = glint_plane_at(&all->depth, g, x, y);
    }
    all->depth_least = depth < all->depth_least ? depth : all->depth_least;
    all->depth_greatest = depth > all->depth_greatest ? depth : all->depth_greatest;
    all->pixels++;
    if (depth >> GLINT_DEPTH_SHIFT < 1 || depth >> GLINT_DEPTH_SHIFT > 65535) {
        fail_msg("depth %d at (%d, %d) of (%d, %d, %d) (%d, %d, %d) (%d, %d, %d), sliver %d", depth, x, y,
                 t->corner[0].x, t->corner[0].y, t->corner[0].depth_q30, t->corner[1].x, t->corner[1].y,
                 t->corner[1].depth_q30, t->corner[2].x, t->corner[2].y, t->corner[2].depth_q30, g->sliver);
    }
}

static void depths_stay_within_their_margins(void **state)
{
    tally all;
    (void)state;
    memset(&all, 0, sizeof all);
    all.depth_least = INT32_MAX;
    for (int round = 0; round < 2 * ROUNDS; round++) {
        triangle t;
        if (!random_triangle(&t, random_size(round), random_size(round / 5), round % 4 != 0)) {
            continue;
        }
        if (!t.gradients.sliver) {
            glint_plane_set_up(&all.depth, &t.gradients, t.gradients.corner[0]->depth_q30,
                               t.gradients.corner[1]->depth_q30, t.gradients.corner[2]->depth_q30);
        }
        at_covered_pixels(&t, check_depth_at, &all);
    }
    print_message("    %ld pixels: %.3f..%.3f of 65536 (corners 64..65472)\n", all.pixels, all.depth_least / 16384.0,
                  all.depth_greatest / 16384.0);
    /* some pixel does go beyond the corners, or this test shows nothing */
    assert_true(all.depth_least < GLINT_DEPTH_BIAS && all.depth_greatest > GLINT_DEPTH_BIAS + GLINT_DEPTH_SPAN);
}

/* A triangle of a whole display, one value at all corners: the plane is level, to the unit, at every pixel. */
static void level_planes_are_level(void **state)
{
    static const int32_t values[5] = {0, 1, -1, (int32_t)1 << 29, -((int32_t)1 << 29)};
    (void)state;
    for (int round = 0; round < 20000; round++) {
        triangle t;
        if (random_triangle(&t, 2048, 2048, false) && !t.gradients.sliver) {
            glint_plane plane;
            const int32_t v = values[round % 5];
            glint_plane_set_up(&plane, &t.gradients, v, v, v);
            assert_true(plane.step_x == 0 && plane.step_y == 0 && plane.value == (uint32_t)v);
            assert_int_equal(glint_plane_at(&plane, &t.gradients, 2047, 0), v);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(planes_keep_their_bound),
        numeric_test(weights_of_slivers_are_clamped_and_exact),
        numeric_test(depths_stay_within_their_margins),
        numeric_test(level_planes_are_level),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
