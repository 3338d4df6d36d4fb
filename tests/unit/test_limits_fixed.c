/* SPDX-License-Identifier: MIT */
/*
 * The fixed backend at its limits: see backend_limits.h; the direction to a point light, whatever the scales of light
 * and surface are; and projection near the eye and far from it.
 */
#include "backend/fixed.c" /* for its static functions; it takes the place of the library's own copy */

#include "tests/unit/backend_limits.h"
#include "tests/unit/geometry_world.h"

/* Budgets. */
#define UNIT_ULP 1.58L        /* of Q15, a component, as number/fixed.h states for glint_unit_q15 */
#define PLACE_UNITS 1.0L      /* of the coarser of the two scales: product and alignment are rounded down */
#define COORDINATE_UNITS 6.0L /* of the last bit, as geometry/vertex_fixed.h states */

typedef struct towards_tally {
    long told, refused, aligned[3]; /* by the alignment: the light's position finer, either, the ray finer */
    long double worst;
} towards_tally;

static void compare_towards(int finer, towards_tally *tally)
{
    surface at;
    light_place light;
    real v[3], out[3];
    long double exact[3], size = 0, ray_size = 0, light_size = 0;
    memset(&at, 0, sizeof at);
    memset(&light, 0, sizeof light);
    at.inverse = (int32_t)(random_u32() >> random_between(2, 20));
    at.inverse_fraction = (int16_t)random_between(30, 58);
    light.fraction = (int16_t)random_between(-10, 29);
    const int fraction = light.fraction + at.inverse_fraction - 32;
    at.ray_fraction = (int16_t)(fraction - finer);
    for (int k = 0; k < 3; k++) {
        light.v[k] = random_any_size(30);
        at.ray[k] = random_any_size(30);
        const long double product = ldexpl((long double)light.v[k] * at.inverse, -32 - fraction);
        const long double ray = ldexpl(at.ray[k], -at.ray_fraction);
        exact[k] = product - ray;
        ray_size = fmaxl(ray_size, fabsl(ray));
        light_size = fmaxl(light_size, fabsl(product));
    }
    size = sqrtl(dot(exact, exact));
    const long double unit_length = ldexpl(1, -(finer >= 0 ? at.ray_fraction : fraction));
    const bool told = light_towards(&light, &at, v, out);
    tally->aligned[finer >= 0 ? finer > 30 : 2] += told;
    if (!told) {
        /* as near as 2^-15 of the greater of the two, whose magnitude is taken to the next power of two */
        assert_true(size <= sqrtl(3) * (fmaxl(ray_size, light_size) * exp2l(-14) + 2 * PLACE_UNITS * unit_length));
        tally->refused++;
        return;
    }
    tally->told++;
    const long double rounding = sqrtl(3) * PLACE_UNITS * unit_length / size;
    for (int k = 0; k < 3 && rounding < 0.1L; k++) {
        const long double error = fabsl(out[k] - exact[k] / size * 32768);
        tally->worst = worse(tally->worst, error / (UNIT_ULP + 32768 * rounding * 1.1L));
    }
}

/* The light's position and the ray come with any number of fractional bits, from where the one is all to where it is
 * nothing beside the other. */
static void towards_a_light_in_any_scale(void **state)
{
    towards_tally tally;
    (void)state;
    memset(&tally, 0, sizeof tally);
    for (int finer = -70; finer <= 70; finer++) {
        for (int round = 0; round < 3000; round++) {
            compare_towards(finer, &tally);
        }
    }
    print_message("    %ld directions, %ld too near\n", tally.told, tally.refused);
    assert_true(tally.aligned[0] > 10000 && tally.aligned[1] > 10000 && tally.aligned[2] > 10000);
    assert_true(tally.refused > 100);
    expect_at_most("direction, of what is allowed", tally.worst, 1);
}

/* Where light and viewer are opposite, the half vector is taken again from finer vectors. There is none if one of these
 * is zero, and none if they are opposite too; then it is not written. */
static void half_vectors_of_opposite_directions(void **state)
{
    static const real n[3] = {0, 32768, 0}, s[3] = {0, 0, -32768}, c[3] = {0, 0, 32768};
    static const real nothing[3] = {0, 0, 0}, opposite[3] = {0, 0, -12345}, aside[3] = {0, 100, -12345};
    real half[3] = {7, 8, 9};
    (void)state;
    /* the ray leads away from the viewer */
    assert_false(half_vector(s, c, nothing, opposite, half));
    assert_false(half_vector(s, c, opposite, nothing, half));
    assert_false(half_vector(s, c, nothing, nothing, half));
    assert_false(half_vector(s, c, opposite, opposite, half));
    assert_true(half[0] == 7 && half[1] == 8 && half[2] == 9);
    /* s turned by 100 / 12345 to y, so that the half vector is half of that away from y; the gap is the square of the
     * distance over 2 */
    assert_true(half_vector(s, c, aside, opposite, half));
    const long double away = 32768 * atanl(100 / 12345.0L) / 2, distance = sqrtl(gap_between(n, half));
    assert_true(fabsl(distance - away) <= sqrtl(3) * UNIT_ULP);
}

/* A camera with the narrowest field of view at the origin, looking along -z, its near plane as near as can be. */
#define HEIGHT_PX 2048
static void narrow_view(glint_view *view)
{
    const glint_camera camera = {.target_q16 = {0, 0, -ONE_Q16}, .field_of_view_turn16 = 182, .near_q16 = 64};
    assert_int_equal(glint_camera_check(&camera), GLINT_OK);
    glint_view_set_up(view, &camera, HEIGHT_PX, HEIGHT_PX);
}

typedef struct projected {
    glint_screen_vertex screen;
    long double x, y, z; /* exact view coordinates */
    bool near, inside;
} projected;

static projected project_at(const glint_view *view, const glint_place *place, const int16_t position[3])
{
    projected p;
    transform_state t;
    glint_transform transform;
    const glint_mesh mesh = {.fraction_bits = 0};
    const glint_object object = {.mesh = &mesh, .place = *place};
    memset(&p, 0, sizeof p);
    assert_int_equal(glint_place_check(place), GLINT_OK);
    glint_transform_set_up(&transform, view, &object);
    transform_prepare(&t, &transform);
    const view_vertex v = vertex_to_view(&t, position);
    p.x = ldexpl((long double)place->linear_q16[0][0] * position[0] + place->origin_q16[0], -16);
    p.y = -ldexpl((long double)place->linear_q16[1][1] * position[1] + place->origin_q16[1], -16);
    p.z = -ldexpl((long double)place->linear_q16[2][2] * position[2] + place->origin_q16[2], -16);
    p.near = vertex_is_near(&t, &v);
    p.inside = !p.near && vertex_project(&t, &v, view, &p.screen);
    return p;
}

/* A flat object just before the eye, up to 2^25 units wide: what is not in the middle is beyond every number of pixels;
 * what is in the middle is seen there. */
static void next_to_the_eye(void **state)
{
    const glint_place place = {{{(int32_t)1 << 26, 0, 0}, {0, (int32_t)1 << 26, 0}, {0, 0, 16}}, {0, 0, -80}};
    glint_view view;
    int middle = 0, beyond = 0, near = 0;
    (void)state;
    narrow_view(&view);
    for (int n = 0; n < 7 * 7 * 12; n++) {
        static const int16_t sideways[7] = {-32768, -300, -1, 0, 1, 300, 32767};
        const int16_t position[3] = {sideways[n % 7], sideways[n / 7 % 7], (int16_t)(6 - n / 49)};
        const projected p = project_at(&view, &place, position);
        assert_int_equal(p.near, p.z <= 64 / 65536.0L);
        near += p.near;
        if (position[0] == 0 && position[1] == 0 && !p.near) {
            assert_true(p.inside);
            assert_int_equal(p.screen.x, HEIGHT_PX / 2 * GLINT_FINE);
            assert_int_equal(p.screen.y, HEIGHT_PX / 2 * GLINT_FINE);
            middle++;
        } else if (!p.near) {
            assert_false(p.inside);
            beyond++;
        }
    }
    assert_true(middle >= 3 && beyond >= 48 * 3 && near >= 49);
}

/* Away from the eye, up to 2^25 units, which is 2^35 near distances: the inverse depth goes down to its least, and what
 * is beside the view direction to the middle of the screen. */
static void far_from_the_eye(void **state)
{
    glint_view view;
    int least = 0, compared = 0;
    (void)state;
    narrow_view(&view);
    const long double focal = ldexpl(view.focal_px.m, -view.focal_px.f);
    for (int bits = 12; bits <= 26; bits++) {
        const glint_place place = {{{1 << 14, 0, 0}, {0, 1 << 14, 0}, {0, 0, (int32_t)1 << bits}}, {0, 0, 0}};
        /* units of the last bit of Z and of X and Y: 2^-29 of what a position could name, at least */
        const long double unit_z = exp2l(bits - 29), unit_xy = exp2l(14 - 29);
        for (int n = 0; n < 3 * 16; n++) {
            const int16_t position[3] = {(int16_t)(n % 3 * 64 - 64), (int16_t)(n % 3 * 33),
                                         (int16_t)(-((int32_t)1 << n / 3))};
            const projected p = project_at(&view, &place, position);
            const long double relative = COORDINATE_UNITS * unit_z / p.z + exp2l(-27);
            const long double depth = GLINT_DEPTH_SPAN * (64 / 65536.0L) / p.z;
            const long double x = focal * p.x / p.z, y = focal * p.y / p.z; /* px from the middle */
            const long double across = focal * COORDINATE_UNITS * unit_xy / p.z + 1.0L / GLINT_FINE;
            assert_false(p.near);
            const long double aside = fmaxl(fabsl(x), fabsl(y)), error = across + aside * relative;
            assert_true(p.inside ? aside <= GLINT_GUARD_PX + error : aside >= GLINT_GUARD_PX - error);
            if (!p.inside) {
                continue;
            }
            assert_true(fabsl(p.screen.depth_q30 - GLINT_DEPTH_BIAS - depth) <= 1 + depth * relative);
            assert_true(fabsl(ldexpl(p.screen.x, -GLINT_FINE_BITS) - HEIGHT_PX / 2 - x) <=
                        across + fabsl(x) * relative);
            assert_true(fabsl(ldexpl(p.screen.y, -GLINT_FINE_BITS) - HEIGHT_PX / 2 - y) <=
                        across + fabsl(y) * relative);
            least += p.screen.depth_q30 == GLINT_DEPTH_BIAS;
            compared++;
        }
    }
    assert_true(least >= 3 && compared > 300);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        LIMITS_TESTS,
        numeric_test(towards_a_light_in_any_scale),
        cmocka_unit_test(half_vectors_of_opposite_directions),
        cmocka_unit_test(next_to_the_eye),
        cmocka_unit_test(far_from_the_eye),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
