/* SPDX-License-Identifier: MIT */
/*
 * The vertex stage of either backend against a projection in long double. Included after one of geometry/vertex_fixed.h
 * and geometry/vertex_float.h, which define the same names, and after BACKEND_ROUNDING: the error of a view coordinate
 * by the backend's own arithmetic, as a part of the object's extent (its farthest point from the eye, where a position
 * could be).
 */
#include "tests/unit/geometry_world.h"

/* What set-up may add: an axis of the camera errs by 6 ulp of Q30, three deep where up is involved. */
#define AXIS_ULP 6.0L
#define ULP_Q30 (1 / 1073741824.0L)
#define RECIPROCAL_RELATIVE exp2l(-27.8L)

typedef struct vertex_tally {
    long compared, behind, beyond;
    long double x, y, depth;           /* greatest errors as parts of what is allowed */
    long double steps, steps_ordinary; /* on the screen, 1/4096 px: of all, and of ordinary scenes */
} vertex_tally;

typedef struct vertex_scene {
    glint_camera camera;
    glint_mesh mesh;
    glint_object object;
    int16_t position[1][3];
    uint16_t width, height;
    bool ordinary; /* 15..90 degrees, the object no farther away than 8 times its extent */
} vertex_scene;

/* An object of a random size before the camera: its middle within the picture or nearby, at a random distance. */
static void random_scene(vertex_scene *s, int round)
{
    memset(s, 0, sizeof *s);
    s->camera = random_camera();
    s->width = (uint16_t)random_between(1, 2048);
    s->height = (uint16_t)random_between(1, 2048);
    s->mesh.positions = (const int16_t(*)[3])s->position;
    s->mesh.fraction_bits = (int8_t)(round % 25);
    s->ordinary = round & 1;
    if (s->ordinary) {
        s->camera.field_of_view_turn16 = (uint16_t)random_between(2731, 16384);
    }
    s->object.mesh = &s->mesh;
    s->object.place = random_place(round & 2);
    const exact_view e = exact_view_of(&s->camera, s->height);
    long double linear[3][3], size = 0;
    exact_linear_of(&s->object.place, linear);
    for (int i = 0; i < 9; i++) {
        size = fmaxl(size, fabsl(linear[i / 3][i % 3]) * ldexpl(1, 15 - s->mesh.fraction_bits));
    }
    const long double most = 12000, far = s->ordinary ? size * (1 + 7 * random_unit()) : exp2l(14 * random_unit());
    const long double distance = fminl(fmaxl(far, e.near), most);
    for (int k = 0; k < 3; k++) {
        const long double aside =
            (e.basis[0][k] * (random_unit() - 0.5L) * s->width + e.basis[1][k] * (random_unit() - 0.5L) * s->height) /
            e.focal;
        const long double at = e.eye[k] + distance * e.basis[2][k] + fminl(fmaxl(aside * distance, -4000), 4000);
        s->object.place.origin_q16[k] = Q16(fminl(fmaxl(at, -16384), 16384));
    }
}

/* Exact view coordinates of a position, and the object's extent. */
static void exact_view_vertex(const vertex_scene *s, const exact_view *e, const int16_t position[3], long double v[3],
                              long double *extent)
{
    long double linear[3][3], world[3];
    exact_linear_of(&s->object.place, linear);
    *extent = 0;
    for (int corner = 0; corner <= 8; corner++) {
        long double p[3];
        for (int k = 0; k < 3; k++) {
            p[k] = ldexpl(corner == 8 ? position[k] : corner >> k & 1 ? 32768 : -32768, -s->mesh.fraction_bits);
        }
        for (int i = 0; i < 3; i++) {
            world[i] = dot(linear[i], p) + s->object.place.origin_q16[i] / 65536.0L - e->eye[i];
        }
        *extent = fmaxl(*extent, sqrtl(dot(world, world)));
    }
    for (int i = 0; i < 3; i++) {
        v[i] = dot(e->basis[i], world);
    }
}

static void compare_vertex(const vertex_scene *s, const exact_view *e, const glint_view *view,
                           const transform_state *transform, vertex_tally *tally)
{
    long double v[3], extent;
    glint_screen_vertex screen;
    const view_vertex actual = vertex_to_view(transform, s->position[0]);
    exact_view_vertex(s, e, s->position[0], v, &extent);
    assert_true(vertex_is_finite(&actual));
    /* what a view coordinate may err by, and the focal length relatively */
    const long double half_angle = s->camera.field_of_view_turn16 * PI / 65536;
    const long double axis = AXIS_ULP * (2 + 1 / e->up_sine) * ULP_Q30;
    const long double coordinate = (BACKEND_ROUNDING + axis) * extent;
    const long double focal = 3 * ULP_Q30 / (sinl(half_angle) * cosl(half_angle)) + 3 * RECIPROCAL_RELATIVE;
    if (vertex_is_near(transform, &actual)) {
        assert_true(v[2] < e->near + coordinate + e->near * ULP_Q30);
        tally->behind++;
        return;
    }
    assert_true(v[2] >= e->near - coordinate - e->near * ULP_Q30);
    const long double z_relative = coordinate / v[2];
    if (z_relative > 0.01L) {
        return; /* the near plane is within rounding of the eye, for an object of this extent */
    }
    const long double exact[2] = {e->focal * v[0] / v[2], e->focal * v[1] / v[2]};
    long double allowed[2];
    bool inside = true, outside = false;
    for (int i = 0; i < 2; i++) {
        const long double px = e->focal * z_relative * 1.02L + fabsl(exact[i]) * (z_relative * 1.02L + focal);
        allowed[i] = px * GLINT_FINE + 0.5L;
        inside = inside && fabsl(exact[i]) + px < GLINT_GUARD_PX;
        outside = outside || fabsl(exact[i]) - px > GLINT_GUARD_PX;
    }
    if (!vertex_project(transform, &actual, view, &screen)) {
        assert_false(inside);
        tally->beyond++;
        return;
    }
    assert_false(outside);
    const long double x = fabsl(screen.x - (exact[0] + s->width / 2.0L) * GLINT_FINE);
    const long double y = fabsl(screen.y - (exact[1] + s->height / 2.0L) * GLINT_FINE);
    const long double share = fminl(e->near / v[2], 1) * GLINT_DEPTH_SPAN;
    const long double depth = fabsl(screen.depth_q30 - GLINT_DEPTH_BIAS - share);
    tally->compared++;
    tally->x = worse(tally->x, x / allowed[0]);
    tally->y = worse(tally->y, y / allowed[1]);
    tally->depth = worse(tally->depth, depth / (share * (z_relative * 1.02L + DEPTH_RELATIVE) + 1));
    tally->steps = worse(tally->steps, worse(x, y));
    if (s->ordinary && v[2] > extent / 16) {
        tally->steps_ordinary = worse(tally->steps_ordinary, worse(x, y));
    }
    assert_true(screen.depth_q30 >= GLINT_DEPTH_BIAS && screen.depth_q30 <= GLINT_DEPTH_BIAS + GLINT_DEPTH_SPAN);
}

static void vertices_are_where_the_camera_sees_them(void **state)
{
    vertex_tally tally;
    (void)state;
    memset(&tally, 0, sizeof tally);
    for (int round = 0; round < 30000; round++) {
        vertex_scene s;
        glint_view view;
        glint_transform transform;
        transform_state prepared;
        random_scene(&s, round);
        assert_int_equal(glint_camera_check(&s.camera), GLINT_OK);
        assert_int_equal(glint_place_check(&s.object.place), GLINT_OK);
        const exact_view e = exact_view_of(&s.camera, s.height);
        glint_view_set_up(&view, &s.camera, s.width, s.height);
        glint_transform_set_up(&transform, &view, &s.object);
        transform_prepare(&prepared, &transform);
        for (int i = 0; i < 20; i++) {
            for (int k = 0; k < 3; k++) {
                s.position[0][k] = (int16_t)(i & 1 ? random_between(-32768, 32767) : random_any_size(15));
            }
            compare_vertex(&s, &e, &view, &prepared, &tally);
        }
    }
    print_message("    %ld vertices, %ld before the near plane, %ld beyond the guard band\n", tally.compared,
                  tally.behind, tally.beyond);
    print_message("    error on the screen, 1/4096 px: at most %.2Lf; in ordinary scenes %.2Lf\n", tally.steps,
                  tally.steps_ordinary);
    assert_true(tally.compared > 50000 && tally.behind > 1000 && tally.beyond > 1000);
    expect_at_most("x, of what is allowed", tally.x, 1);
    expect_at_most("y, of what is allowed", tally.y, 1);
    expect_at_most("depth_q30, of what is allowed", tally.depth, 1);
    expect_at_most("ordinary scenes, 1/4096 px", tally.steps_ordinary, ORDINARY_STEPS);
}
