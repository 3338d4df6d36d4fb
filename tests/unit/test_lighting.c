/* SPDX-License-Identifier: MIT */
/*
 * The reflectance model of <glint/scene.h> where it has a closed form: at the centre of a board that faces the eye
 * (board.h), in both backends. test_lighting_shapes.c compares whole pictures with the reference.
 *
 * Budgets, in codes of 1/255, against the formula in double, before rounding:
 */
#define TERM 1.0     /* terms with a direction, an angle or a power in them */
#define PRODUCT 0.52 /* products of colours alone: the rounding to a code, and 255 times twice 2^-16 */

#include "tests/unit/backends.h"
#include "tests/unit/board.h"

#include <math.h>
#include <stdio.h>

#define PI 3.14159265358979323846
#define SHADINGS 3
#define CENTRE ((BOARD_PX / 2) * BOARD_PX + BOARD_PX / 2)

static frame draw(const board *b, int which, uint8_t shading)
{
    frame f = {.display = {.width_px = BOARD_PX, .height_px = BOARD_PX}, .shading = shading};
    assert_int_equal(frame_draw(&f, &b->scene, which), 0);
    assert_int_equal(f.report.pixels_shaded, BOARD_PX * BOARD_PX);
    return f;
}

/* A pixel's channel k is level l, in one shading and both backends. */
static void expect_at(const board *b, uint8_t shading, int pixel, const double l[3], double budget, const char *what)
{
    for (int which = 0; which < BACKENDS; which++) {
        frame f = draw(b, which, shading);
        for (int k = 0; k < 3; k++) {
            const double code = 255 * (l[k] < 0 ? 0 : l[k] > 1 ? 1 : l[k]);
            if (!(fabs(f.pixels[3 * pixel + k] - code) <= budget)) {
                fail_msg("%s, %s, shading %u, channel %d: code %u, expected %.4f", what, backends[which].name, shading,
                         k, f.pixels[3 * pixel + k], code);
            }
        }
        frame_free(&f);
    }
}

static void expect_centre(const board *b, uint8_t shading, double level, double budget, const char *what)
{
    const double l[3] = {level, level, level};
    expect_at(b, shading, CENTRE, l, budget, what);
}

/* All pixels, in all shadings: for light that is the same everywhere. */
static void expect_all(const board *b, double level, double budget, const char *what)
{
    for (int n = 0; n < BACKENDS * SHADINGS; n++) {
        frame f = draw(b, n % 2, (uint8_t)(n / 2));
        for (size_t i = 0; i < f.bytes; i++) {
            if (!(fabs(f.pixels[i] - 255 * level) <= budget)) {
                fail_msg("%s, %s, shading %d, byte %zu: code %u, expected %.4f", what, backends[n % 2].name, n / 2, i,
                         f.pixels[i], 255 * level);
            }
        }
        frame_free(&f);
    }
}

/* The same picture, byte for byte, in all shadings and both backends. */
static void expect_same(const board *a, const board *b)
{
    for (int n = 0; n < BACKENDS * SHADINGS; n++) {
        frame first = draw(a, n % 2, (uint8_t)(n / 2)), second = draw(b, n % 2, (uint8_t)(n / 2));
        assert_memory_equal(first.pixels, second.pixels, first.bytes);
        frame_free(&first);
        frame_free(&second);
    }
}

static double length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void test_ambient_alone(void **state)
{
    (void)state;
    board b;
    uint64_t seed = 2;
    board_set_up(&b);
    for (int n = 0; n < 500; n++) {
        int16_t r[3], i[3];
        double l[3];
        for (int k = 0; k < 3; k++) {
            r[k] = (int16_t)(n < 20 ? 16384 - n : (int)(random_u24(&seed) % 16385));
            i[k] = (int16_t)(n < 20 ? 16384 + n : (int)(random_u24(&seed) % 32768));
            l[k] = r[k] / 16384.0 * (i[k] / 16384.0);
        }
        b.material.ambient = (glint_colour){r[0], r[1], r[2]};
        b.scene.ambient = (glint_colour){i[0], i[1], i[2]};
        b.scene.light_count = n % 2 ? 1 : 0; /* the material is black to the light */
        expect_at(&b, (uint8_t)(n % 3), n % (BOARD_PX * BOARD_PX), l, PRODUCT, "ambient");
    }
}

/* The light turns from the board's normal to beyond its plane, about several axes. */
static void test_diffuse_is_the_cosine(void **state)
{
    (void)state;
    board b;
    board_set_up(&b);
    b.material.diffuse = board_grey(15000);
    b.material.ambient = b.scene.ambient = board_grey(4000);
    for (int degrees = 0; degrees <= 180; degrees++) {
        const double angle = degrees * PI / 180, around = degrees * 0.7;
        const double v[3] = {-8000 * sin(angle) * cos(around), -8000 * sin(angle) * sin(around), -8000 * cos(angle)};
        const int x = (int)lround(v[0]), y = (int)lround(v[1]), z = (int)lround(v[2]);
        const double towards[3] = {-x, -y, -z};
        const double cosine = towards[2] / length(towards);
        const double ambient = 4000.0 * 4000 / 16384 / 16384;
        char what[40];
        (void)snprintf(what, sizeof what, "%d degrees", degrees);
        board_light(&b, 0, x, y, z);
        expect_all(&b, ambient + 15000 / 16384.0 * (cosine > 0 ? cosine : 0), TERM, what);
    }
}

/* n.s is 0 or below: neither a diffuse nor a specular term, whatever the exponent. */
static void test_no_light_at_or_below_the_horizon(void **state)
{
    (void)state;
    static const int16_t directions[][3] = {{-1, 0, 0},     {1, 0, 0},     {0, -32767, 0}, {5, 7, 0},        {0, 0, 1},
                                            {-3000, 0, 10}, {0, 32767, 1}, {3, 4, 12},     {1, 1, INT16_MAX}};
    static const uint16_t exponents[] = {0, 1, 16, 320, 16384};
    for (size_t i = 0; i < sizeof directions / sizeof *directions; i++) {
        for (size_t e = 0; e < 2 * sizeof exponents / sizeof *exponents; e++) {
            board b;
            board_set_up(&b);
            b.material.ambient = b.scene.ambient = board_grey(8192);
            b.material.diffuse = b.material.specular = board_grey(16384);
            b.material.exponent_q4 = exponents[e / 2];
            b.material.specular_model = e % 2 ? GLINT_BLINN : GLINT_PHONG;
            board_light(&b, 0, directions[i][0], directions[i][1], directions[i][2]);
            expect_all(&b, 0.25, PRODUCT, "light from behind");
        }
    }
}

/* 0^0 is 1: with the exponent 0 the specular term is whole wherever n.s > 0, far from the mirror direction as well. */
static void test_exponent_0_is_1_wherever_lit(void **state)
{
    (void)state;
    static const int16_t directions[][3] = {{0, 0, -1}, {-1000, 0, -1000}, {1000, -3000, -700}, {-30000, 20000, -60}};
    for (size_t i = 0; i < 2 * sizeof directions / sizeof *directions; i++) {
        board b;
        board_set_up(&b);
        b.material.specular = board_grey(10000);
        b.material.specular_model = i % 2 ? GLINT_BLINN : GLINT_PHONG;
        board_light(&b, 0, directions[i / 2][0], directions[i / 2][1], directions[i / 2][2]);
        expect_all(&b, 10000 / 16384.0, PRODUCT, "exponent 0");
    }
}

static void test_specular_at_the_mirror_direction(void **state)
{
    (void)state;
    static const uint16_t exponents[] = {0, 1, 8, 16, 20, 33, 160, 1000, 16384};
    for (size_t e = 0; e < 2 * sizeof exponents / sizeof *exponents; e++) {
        board b;
        board_set_up(&b);
        b.material.specular = board_grey(16000);
        b.material.exponent_q4 = exponents[e / 2];
        b.material.specular_model = e % 2 ? GLINT_BLINN : GLINT_PHONG;
        expect_centre(&b, GLINT_SHADING_EXACT, 16000 / 16384.0, TERM, "head-on");
        /* eye at (3, 0, 4), light from (-3, 0, 4) */
        b.camera.field_of_view_turn16 = 2000; /* so that the board still fills the picture */
        b.camera.eye_q16[0] = BOARD_Q16(3);
        b.camera.eye_q16[2] = BOARD_Q16(4);
        board_light(&b, 0, 3000, 0, -4000);
        expect_centre(&b, GLINT_SHADING_EXACT, 16000 / 16384.0, TERM, "mirrored");
    }
}

/* Off the mirror direction by a known angle: cos^alpha, whole exponents and others; Blinn's angle is half as great. */
static void test_specular_is_the_power_of_the_cosine(void **state)
{
    (void)state;
    static const uint16_t exponents[] = {1, 7, 16, 20, 33, 100, 160, 515, 3200, 16384};
    for (size_t e = 0; e < sizeof exponents / sizeof *exponents; e++) {
        for (int x = 0; x <= 9000; x += x < 600 ? 40 : 560) {
            const double towards[3] = {x, 0, 4000}, half[3] = {x, 0, 4000 + length(towards)};
            const double alpha = exponents[e] / 16.0;
            board b;
            char what[60];
            board_set_up(&b);
            b.material.specular = board_grey(16384);
            b.material.exponent_q4 = exponents[e];
            board_light(&b, 0, -x, 0, -4000);
            (void)snprintf(what, sizeof what, "exponent %g, light from (%d, 0, 4000)", alpha, x);
            expect_centre(&b, GLINT_SHADING_EXACT, pow(4000 / length(towards), alpha), TERM, what);
            b.material.specular_model = GLINT_BLINN;
            expect_centre(&b, GLINT_SHADING_EXACT, pow(half[2] / length(half), alpha), TERM, what);
        }
    }
}

/* r.c < 0 although the light is above the horizon: nothing but for the exponent 0, where Phong's term is 1. */
static void test_specular_away_from_the_mirror_direction(void **state)
{
    (void)state;
    board b;
    board_set_up(&b);
    b.material.specular = board_grey(16384);
    b.camera.field_of_view_turn16 = 2000; /* so that the board still fills the picture */
    b.camera.eye_q16[0] = BOARD_Q16(8);
    board_light(&b, 0, -8000, 0, -3000); /* light and eye on one side: r is on the other */
    for (uint16_t exponent = 1; exponent <= 64; exponent = (uint16_t)(exponent * 2)) {
        b.material.exponent_q4 = exponent;
        expect_centre(&b, GLINT_SHADING_EXACT, 0, TERM, "r.c below 0");
    }
    b.material.exponent_q4 = 0;
    expect_centre(&b, GLINT_SHADING_EXACT, 1, TERM, "r.c below 0, exponent 0");
}

static void test_greater_exponent_is_narrower(void **state)
{
    (void)state;
    for (int n = 0; n < BACKENDS * 2; n++) {
        int wider = BOARD_PX * BOARD_PX + 1;
        for (uint16_t alpha = 2; alpha <= 512; alpha = (uint16_t)(alpha * 4)) {
            board b;
            board_set_up(&b);
            b.material.specular = board_grey(16384);
            b.material.exponent_q4 = (uint16_t)(alpha * 16);
            b.material.specular_model = n / 2 ? GLINT_BLINN : GLINT_PHONG;
            frame f = draw(&b, n % 2, GLINT_SHADING_EXACT);
            int bright = 0;
            for (int i = 0; i < BOARD_PX * BOARD_PX; i++) {
                bright += f.pixels[3 * i] >= 128;
            }
            assert_in_range(bright, 1, wider - 1);
            wider = bright;
            frame_free(&f);
        }
    }
}

/* The normals point away from the eye and to the light behind the board: s = -c at the centre, where there is no h. */
static void test_half_vector_that_does_not_exist(void **state)
{
    (void)state;
    const double lit[3] = {0.25 + 0.5, 0.25 + 0.5, 0.25 + 0.5}, half_lit[3] = {0.25, 0.25, 0.25};
    board b;
    board_set_up(&b);
    board_normals(&b, 0, 0, -16384);
    board_light(&b, 0, 0, 0, 1);
    b.material.diffuse = board_grey(4096);
    b.material.specular = board_grey(8192);
    b.material.specular_model = GLINT_BLINN;
    /* exponent 0: the term is whole wherever there is an h, which is next to the centre */
    expect_at(&b, GLINT_SHADING_EXACT, CENTRE, half_lit, TERM, "no half vector, exponent 0");
    expect_at(&b, GLINT_SHADING_EXACT, CENTRE + 1, lit, TERM, "beside it");
    b.material.exponent_q4 = 16;
    expect_at(&b, GLINT_SHADING_EXACT, CENTRE, half_lit, TERM, "no half vector, exponent 1");
}

static void test_point_light(void **state)
{
    (void)state;
    for (int n = 0; n < 60; n++) {
        const double at[3] = {(n % 5 - 2) * 1.7, (n % 7 - 3) * 0.9, n < 50 ? 0.2 + n * 0.11 : 100.0 * (n - 49)};
        board b;
        char what[60];
        board_set_up(&b);
        b.material.diffuse = board_grey(12000);
        b.material.specular = board_grey(4000);
        b.material.exponent_q4 = 5 * 16;
        b.light[0].kind = GLINT_POINT;
        for (int k = 0; k < 3; k++) {
            b.light[0].position_q16[k] = BOARD_Q16(at[k]);
        }
        const double cosine = at[2] / length(at);
        (void)snprintf(what, sizeof what, "light at (%g, %g, %g)", at[0], at[1], at[2]);
        expect_centre(&b, GLINT_SHADING_EXACT, 12000 / 16384.0 * cosine + 4000 / 16384.0 * pow(cosine, 5), TERM, what);
        /* the pixel 8 to the right sees (x, 0, 0) with x / 5 = 8 / 16.5 */
        const double x = 40 / 16.5, s[3] = {at[0] - x, at[1], at[2]}, c[3] = {-x, 0, 5};
        const double r_c = (s[2] * c[2] - s[0] * c[0]) / length(s) / length(c); /* r = (-s_x, -s_y, s_z) */
        const double level = 12000 / 16384.0 * s[2] / length(s) + 4000 / 16384.0 * pow(r_c > 0 ? r_c : 0, 5);
        const double l[3] = {level, level, level};
        expect_at(&b, GLINT_SHADING_EXACT, CENTRE + 8, l, TERM, what);
        /* behind the board it gives nothing */
        b.light[0].position_q16[2] = -b.light[0].position_q16[2];
        expect_all(&b, 0, PRODUCT, what);
    }
}

/* A light on the very point that is seen: there is no direction to it, and it gives nothing there. The eye's distance
 * varies, so that the point is found with many different roundings. */
static void test_point_light_on_the_surface(void **state)
{
    (void)state;
    unsigned wrong = 0;
    for (int n = 0; n < 40 * BACKENDS; n++) {
        board b;
        board_set_up(&b);
        b.camera.eye_q16[2] += n / 2 * 12345;
        b.camera.near_q16 += n / 2 * 777;
        b.material.ambient = b.scene.ambient = board_grey(8192);
        b.material.diffuse = board_grey(16384);
        b.light[0].kind = GLINT_POINT;
        frame f = draw(&b, n % 2, GLINT_SHADING_EXACT);
        if (fabs(f.pixels[3 * CENTRE] - 0.25 * 255) > TERM) {
            printf("%s, eye at %.5f: code %u, expected %.2f\n", backends[n % 2].name, b.camera.eye_q16[2] / 65536.0,
                   f.pixels[3 * CENTRE], 0.25 * 255);
            wrong++;
        }
        frame_free(&f);
    }
    assert_int_equal(wrong, 0);
}

/* A light in the board's own plane: n.s is 0 at all other points, and r.c below 0. */
static void test_point_light_in_the_plane(void **state)
{
    (void)state;
    board b;
    board_set_up(&b);
    b.material.ambient = b.scene.ambient = board_grey(8192);
    b.material.diffuse = b.material.specular = board_grey(16384);
    b.material.exponent_q4 = 16;
    b.light[0].kind = GLINT_POINT;
    b.light[0].position_q16[0] = BOARD_Q16(0.7);
    b.light[0].position_q16[1] = BOARD_Q16(15);
    expect_all(&b, 0.25, TERM, "light in the surface's plane");
}

/* Each of many lights gives its share; the sum is clamped once, at its end. */
static void test_sum_of_many_lights(void **state)
{
    (void)state;
    static glint_light lights[GLINT_MAX_LIGHTS];
    board b;
    board_set_up(&b);
    b.scene.lights = lights;
    for (int i = 0; i < GLINT_MAX_LIGHTS; i++) {
        lights[i] = b.light[0];
    }
    b.material.diffuse = b.material.specular = board_grey(16384);
    for (int n = 0; n < 9; n++) {
        static const uint16_t counts[] = {1, 2, 3, 10, 63, 64, 65, 500, 4096};
        b.scene.light_count = counts[n];
        for (int i = 0; i < counts[n]; i++) {
            lights[i].colour = board_grey(32767);
        }
        b.material.ambient = b.scene.ambient = board_grey(16384);
        expect_all(&b, 1, 0, "saturated");
        /* thirds of 1 in diffuse, specular (exponent 0) and ambient light, as near as Q14 comes */
        const int share = 16384 / 3 / counts[n];
        for (int i = 0; i < counts[n]; i++) {
            lights[i].colour = board_grey(share);
        }
        b.material.ambient = board_grey(5461);
        expect_all(&b, 2.0 * share * counts[n] / 16384 + 5461 / 16384.0, TERM, "shares");
    }
    /* an intensity of 2 at 60 degrees is 1, not 1/2: it is not clamped by itself */
    b.scene.light_count = 1;
    b.scene.ambient = b.material.specular = board_grey(0);
    b.material.diffuse = board_grey(12000);
    lights[0].colour = board_grey(32767);
    lights[0].direction[0] = 1732;
    lights[0].direction[2] = -1000;
    const double cosine = 1000 / sqrt(1732.0 * 1732 + 1e6);
    expect_all(&b, 32767 / 16384.0 * 12000 / 16384 * cosine, TERM, "intensity of 2 aslant");
}

/* Coloured light on a coloured surface: red has nothing to do with green and blue. */
static void test_channels_are_independent(void **state)
{
    (void)state;
    uint64_t seed = 3;
    for (int n = 0; n < 200; n++) {
        int16_t v[6][3];
        double l[3];
        board b;
        board_set_up(&b);
        board_light(&b, 0, 0, -600, -800);
        for (int i = 0; i < 18; i++) {
            const uint32_t random = random_u24(&seed);
            v[i / 3][i % 3] = (int16_t)(random % 4 == 0 ? 0 : random % 16385);
        }
        for (int k = 0; k < 3; k++) {
            const double ambient = (double)v[0][k] * v[1][k], diffuse = (double)v[2][k] * v[4][k] * 0.8;
            const double specular = (double)v[3][k] * v[4][k] * 0.8 * 0.8; /* r.c is 0.8, the exponent 2 */
            const double second = (double)v[2][k] * v[5][k] + (double)v[3][k] * v[5][k];
            l[k] = (ambient + diffuse + specular + second) / 16384 / 16384;
        }
        b.scene.ambient = (glint_colour){v[0][0], v[0][1], v[0][2]};
        b.material.ambient = (glint_colour){v[1][0], v[1][1], v[1][2]};
        b.material.diffuse = (glint_colour){v[2][0], v[2][1], v[2][2]};
        b.material.specular = (glint_colour){v[3][0], v[3][1], v[3][2]};
        b.light[0].colour = (glint_colour){v[4][0], v[4][1], v[4][2]};
        b.light[1].colour = (glint_colour){v[5][0], v[5][1], v[5][2]};
        b.material.exponent_q4 = 2 * 16;
        b.scene.light_count = 2;
        expect_at(&b, GLINT_SHADING_EXACT, CENTRE, l, TERM, "colours");
    }
}

static void test_black_light_and_light_from_behind_change_nothing(void **state)
{
    (void)state;
    for (int n = 0; n < 12; n++) {
        board one, more;
        board_set_up(&one);
        one.material.ambient = one.scene.ambient = board_grey(3000);
        one.material.diffuse = board_grey(6000);
        one.material.specular = board_grey(5000);
        one.material.exponent_q4 = (uint16_t)(n * 20);
        one.material.specular_model = (uint8_t)(n % 2);
        board_light(&one, 0, -3 + n, 2, -7);
        more = one;
        more.object.material = &more.material;
        more.object.mesh = &one.mesh;
        more.scene.camera = &one.camera;
        more.scene.objects = &more.object;
        more.scene.lights = more.light;
        more.scene.light_count = 4;
        more.light[1].colour = board_grey(0);
        board_light(&more, 2, n, 3, 1); /* n.s < 0: must not take from the first */
        board_light(&more, 3, 0, 0, 1);
        more.light[3].kind = GLINT_POINT;
        more.light[3].position_q16[2] = -BOARD_Q16(2);
        expect_same(&one, &more);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ambient_alone),
        cmocka_unit_test(test_diffuse_is_the_cosine),
        cmocka_unit_test(test_no_light_at_or_below_the_horizon),
        cmocka_unit_test(test_exponent_0_is_1_wherever_lit),
        cmocka_unit_test(test_specular_at_the_mirror_direction),
        cmocka_unit_test(test_specular_is_the_power_of_the_cosine),
        cmocka_unit_test(test_specular_away_from_the_mirror_direction),
        cmocka_unit_test(test_greater_exponent_is_narrower),
        cmocka_unit_test(test_half_vector_that_does_not_exist),
        cmocka_unit_test(test_point_light),
        cmocka_unit_test(test_point_light_on_the_surface),
        cmocka_unit_test(test_point_light_in_the_plane),
        cmocka_unit_test(test_sum_of_many_lights),
        cmocka_unit_test(test_channels_are_independent),
        cmocka_unit_test(test_black_light_and_light_from_behind_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
