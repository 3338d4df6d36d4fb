/* SPDX-License-Identifier: MIT */
/*
 * Normals and places as the formulas of <glint/scene.h> and <glint/mesh.h> have them: normals of any length or none,
 * and objects turned, mirrored, scaled apart and sheared. Whole pictures are compared with the double-precision
 * reference (tests/reference/reference.h).
 *
 * Budgets:
 */
#define PLAIN_CODES 1.0 /* greatest |code - 255 L| of a plain pixel, the rounding to a code (0.5) included */
#define UNMATCHED 0     /* contested pixels that agree with none of their candidates */

#include "tests/unit/backends.h"
#include "tests/unit/board.h"

#include <stdio.h>

#include "examples/meshes/meshes.h"
#include "tests/reference/reference.h"

#define WIDTH 72
#define HEIGHT 64
#define SHADINGS 3

/* In all shadings and both backends. */
static void expect_reference(const glint_scene *scene, const char *name)
{
    for (int shading = 0; shading < SHADINGS; shading++) {
        reference_image image;
        char error[200] = "";
        if (reference_render(scene, WIDTH, HEIGHT, shading, &image, error, sizeof error) != 0) {
            fail_msg("%s: %s", name, error);
        }
        for (int which = 0; which < BACKENDS; which++) {
            reference_verdict v;
            frame f = {.display = {.width_px = WIDTH, .height_px = HEIGHT, .band_px = 9}, .shading = (uint8_t)shading};
            assert_int_equal(frame_draw(&f, scene, which), 0);
            assert_true(f.report.pixels_shaded > WIDTH * HEIGHT / 50);
            reference_check(&image, f.pixels, PLAIN_CODES, &v);
            if (v.max_codes > PLAIN_CODES || v.unmatched > UNMATCHED) {
                fail_msg("%s, %s, shading %d: %.3f codes at %d %d; %u unmatched, the first at %d %d", name,
                         backends[which].name, shading, v.max_codes, v.worst_x, v.worst_y, v.unmatched, v.unmatched_x,
                         v.unmatched_y);
            }
            frame_free(&f);
        }
        reference_free(&image);
    }
}

/* One directional and one point light, in two colours, all terms. */
static void set_lit_board(board *b)
{
    board_set_up(b);
    b->material.ambient = b->scene.ambient = board_grey(4000);
    b->material.diffuse = board_grey(8000);
    b->material.specular = board_grey(7000);
    b->material.exponent_q4 = 12 * 16;
    b->scene.background = board_grey(1500);
    b->scene.light_count = 2;
    board_light(b, 0, 4, -6, -9);
    b->light[0].colour.b_q14 = 9000;
    b->light[1].kind = GLINT_POINT;
    b->light[1].position_q16[0] = BOARD_Q16(-1.5);
    b->light[1].position_q16[1] = BOARD_Q16(1);
    b->light[1].position_q16[2] = BOARD_Q16(2.5);
    b->light[1].colour.r_q14 = 8000;
}

static void expect_same(const glint_scene *scene, const frame *expected, int which, uint8_t shading)
{
    frame f = {.display = expected->display, .shading = shading};
    assert_int_equal(frame_draw(&f, scene, which), 0);
    for (size_t i = 0; i < f.bytes; i++) {
        /* the direction is the same, but for the rounding of its unit vector */
        if (abs(f.pixels[i] - expected->pixels[i]) > 1) {
            fail_msg("%s, shading %u: byte %zu is %u, expected %u", backends[which].name, shading, i, f.pixels[i],
                     expected->pixels[i]);
        }
    }
    frame_free(&f);
}

/* Normals along the board's own, of every sort of length; a zero normal stands for the face's. */
static void test_normals_of_other_lengths(void **state)
{
    (void)state;
    static const int16_t z[] = {0, 1, 2, 100, 16383, 16385, INT16_MAX};
    for (int n = 0; n < BACKENDS * SHADINGS; n++) {
        board b;
        frame expected = {.display = {.width_px = BOARD_PX, .height_px = BOARD_PX}, .shading = (uint8_t)(n / 2)};
        set_lit_board(&b);
        assert_int_equal(frame_draw(&expected, &b.scene, n % 2), 0);
        for (size_t i = 0; i < sizeof z / sizeof *z; i++) {
            board_normals(&b, 0, 0, z[i]);
            expect_same(&b.scene, &expected, n % 2, (uint8_t)(n / 2));
            /* corners of different lengths: each is brought to unit length before they are mixed */
            b.normals[1][2] = 16384;
            expect_same(&b.scene, &expected, n % 2, (uint8_t)(n / 2));
        }
        frame_free(&expected);
    }
}

/* Slanting normals, short and long, one or all of them zero, and two that cancel where they meet. */
static void test_normals_against_the_reference(void **state)
{
    (void)state;
    static const int16_t normals[][4][3] = {
        {{3, 0, 4}, {-300, 0, 400}, {0, 9000, 16000}, {0, -1, 2}},
        {{0, 0, 0}, {-300, 0, 400}, {0, 9000, 16000}, {0, -1, 2}},
        {{0, 0, 0}, {0, 0, 0}, {0, 9000, 16000}, {0, 0, 0}},
        {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
        {{INT16_MIN, INT16_MIN, INT16_MAX}, {1, 1, 1}, {-1, 1, 1}, {INT16_MAX, 1, 1}},
        {{5000, 0, 1000}, {-5000, 0, 1000}, {-4000, 100, 900}, {4100, 0, 1000}},
    };
    for (size_t i = 0; i < sizeof normals / sizeof *normals; i++) {
        board b;
        char name[40];
        set_lit_board(&b);
        memcpy(b.normals, normals[i], sizeof b.normals);
        (void)snprintf(name, sizeof name, "normals %zu", i);
        expect_reference(&b.scene, name);
        b.object.place = glint_turn_y(5000);
        expect_reference(&b.scene, name);
    }
}

static const glint_place sheared = {{{60000, 30000, 0}, {-9000, 70000, 12000}, {0, 25000, 55000}}, {0, 0, 0}};

/* Turned, scaled alike and apart, flattened, mirrored and sheared. */
static void test_places_against_the_reference(void **state)
{
    (void)state;
    const glint_place turned = glint_turn_y(7000), tilted = glint_turn_x(60000);
    const glint_place alike = glint_scale(100000, 100000, 100000), tall = glint_scale(40000, 120000, 65536);
    const glint_place flat = glint_scale(90000, 90000, 9000), mirror = glint_scale(-65536, 65536, 65536);
    const glint_place inverted = glint_scale(-70000, -70000, -70000), mirror_tall = glint_scale(70000, -110000, 50000);
    const glint_place places[] = {
        {{{0}}, {0}},
        glint_then(&alike, &turned),
        glint_then(&tall, &tilted),
        glint_then(&flat, &turned),
        mirror,
        glint_then(&mirror, &turned),
        inverted,
        mirror_tall,
        glint_then(&mirror_tall, &tilted),
        sheared,
        glint_then(&sheared, &mirror),
        {{{0, 65536, 0}, {65536, 0, 0}, {0, 0, 65536}}, {0, 0, 0}}, /* two axes exchanged: a mirror as well */
    };
    static const glint_mesh *const meshes[] = {&glint_mesh_sphere_10x6, &glint_mesh_sphere_32x16, &glint_mesh_box};
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        for (int m = 0; m < 3; m++) {
            board b;
            char name[40];
            set_lit_board(&b);
            b.light[1].position_q16[0] = BOARD_Q16(-2.5);
            b.object.mesh = meshes[m];
            b.material.specular_model = (uint8_t)(i % 2);
            b.object.place = places[i];
            b.object.place.origin_q16[2] += BOARD_Q16(1.2);
            (void)snprintf(name, sizeof name, "place %zu, mesh %d", i, m);
            expect_reference(&b.scene, name);
        }
    }
}

/* A mirror keeps the outside outside: the mirrored scene is the mirrored picture, within a code. */
static void test_mirrored_scene_is_the_mirrored_picture(void **state)
{
    (void)state;
    const glint_place turned = glint_turn_z(3000), mirror = glint_scale(-65536, 65536, 65536);
    for (int n = 0; n < BACKENDS * SHADINGS; n++) {
        board b;
        frame left = {.display = {.width_px = BOARD_PX, .height_px = BOARD_PX}, .shading = (uint8_t)(n / 2)};
        set_lit_board(&b);
        b.object.mesh = &glint_mesh_sphere_32x16;
        b.object.place = turned;
        b.object.place.origin_q16[0] = BOARD_Q16(0.13); /* no vertex on a pixel's centre, where the fill rule decides */
        b.object.place.origin_q16[1] = BOARD_Q16(0.071);
        b.object.place.origin_q16[2] = BOARD_Q16(2.9);
        frame right = left;
        assert_int_equal(frame_draw(&left, &b.scene, n % 2), 0);
        b.object.place = glint_then(&b.object.place, &mirror);
        b.light[0].direction[0] = (int16_t)-b.light[0].direction[0];
        b.light[1].position_q16[0] = -b.light[1].position_q16[0];
        assert_int_equal(frame_draw(&right, &b.scene, n % 2), 0);
        int different = 0;
        for (int i = 0; i < BOARD_PX * BOARD_PX; i++) {
            const int x = i % BOARD_PX, other = i - x + BOARD_PX - 1 - x;
            for (int k = 0; k < 3; k++) {
                different += abs(left.pixels[3 * i + k] - right.pixels[3 * other + k]) > 1;
            }
        }
        assert_int_equal(different, 0);
        assert_true(left.report.pixels_shaded > BOARD_PX * BOARD_PX / 10);
        frame_free(&left);
        frame_free(&right);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_normals_of_other_lengths),
        cmocka_unit_test(test_normals_against_the_reference),
        cmocka_unit_test(test_places_against_the_reference),
        cmocka_unit_test(test_mirrored_scene_is_the_mirrored_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
