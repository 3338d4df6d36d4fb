/* SPDX-License-Identifier: MIT */
/*
 * Shadows where they are hard: in closed form, at the ends of the formats' ranges, and whatever the bands.
 */
#include "tests/unit/backends.h"
#include "tests/unit/board.h"

#include <stdio.h>

#include "examples/meshes/meshes.h"
#include "tests/reference/reference.h"

#define PX 33

/* The board, and before it something that casts: by default a box of +-1 from the board (its back in the board's plane)
 * to 2 before it. The light comes from the upper left behind the eye, at 45 degrees: the shadow falls to the right. */
typedef struct stage {
    board b;
    glint_material other;
    glint_object objects[2];
} stage;

static void stage_set_up(stage *s)
{
    board_set_up(&s->b);
    memset(&s->other, 0, sizeof s->other);
    s->b.material.diffuse = board_grey(16384);
    s->other.diffuse = board_grey(8000);
    board_light(&s->b, 0, 1000, 0, -1000);
    s->b.light[0].casts_shadows = true;
    s->objects[0] = s->b.object;
    s->objects[1] = s->b.object;
    s->objects[1].mesh = &glint_mesh_box;
    s->objects[1].material = &s->other;
    s->objects[1].place = glint_shift(0, 0, BOARD_Q16(1));
    s->b.scene.objects = s->objects;
    s->b.scene.object_count = 2;
}

static frame stage_draw(const stage *s, int which, uint16_t band_px)
{
    frame f = {.display = {.width_px = PX, .height_px = PX, .band_px = band_px}};
    assert_int_equal(frame_draw(&f, &s->b.scene, which), 0);
    return f;
}

/* Against rays, in both backends and for several heights of a band. */
static void expect_rays(const stage *s, const char *name)
{
    reference_image image;
    char error[200];
    if (reference_render(&s->b.scene, PX, PX, GLINT_SHADING_EXACT, &image, error, sizeof error) != 0) {
        fail_msg("%s", error);
    }
    for (int which = 0; which < BACKENDS; which++) {
        frame whole = stage_draw(s, which, 0);
        reference_verdict v;
        reference_check(&image, whole.pixels, 1, &v);
        if (v.max_codes > 1 || v.unmatched > 0) {
            fail_msg("%s, %s: %.3f codes at (%d, %d), %u unmatched", name, backends[which].name, v.max_codes, v.worst_x,
                     v.worst_y, (unsigned)v.unmatched);
        }
        for (uint16_t band_px = 1; band_px < PX; band_px = (uint16_t)(2 * band_px + 1)) {
            frame f = stage_draw(s, which, band_px);
            assert_memory_equal(f.pixels, whole.pixels, whole.bytes);
            frame_free(&f);
        }
        frame_free(&whole);
    }
    reference_free(&image);
}

/* The pixel that sees (x, y, 0): the eye is 5 before the board, and 90 degrees are PX pixels. */
static uint8_t code_at(const frame *f, double x, double y)
{
    const int column = (int)((x / 5 + 1) * PX / 2), row = (int)((1 - y / 5) * PX / 2);
    return f->pixels[(row * PX + column) * 3];
}

static void test_a_box_on_the_board(void **state)
{
    (void)state;
    stage s;
    stage_set_up(&s);
    for (int which = 0; which < BACKENDS; which++) {
        frame f = stage_draw(&s, which, 0);
        /* the box hides its place and, seen from the eye, up to 5/3 of it; its shadow reaches 2 farther to the right */
        assert_int_equal(code_at(&f, 2.3, 0), 0);
        assert_int_equal(code_at(&f, 2.8, 0.7), 0);
        assert_true(code_at(&f, 3.4, 0) > 150);
        assert_true(code_at(&f, -2.3, 0) > 150);
        assert_true(code_at(&f, 2.3, 1.4) > 150);
        assert_int_equal(f.report.shadow_triangles > 0, 1);
        assert_true(f.report.pixels_shadowed > 10);
        frame_free(&f);
    }
    expect_rays(&s, "a box on the board");
}

static void test_who_casts_and_who_takes(void **state)
{
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        stage s;
        stage_set_up(&s);
        s.b.light[0].casts_shadows = false;
        frame none = stage_draw(&s, which, 0);
        assert_int_equal(none.report.shadow_tests + none.report.shadow_triangles + none.report.pixels_shadowed, 0);
        s.b.light[0].casts_shadows = true;
        s.other.shadows = GLINT_CASTS_NO_SHADOW;
        s.b.material.shadows = GLINT_CASTS_NO_SHADOW;
        frame cast = stage_draw(&s, which, 0);
        assert_memory_equal(cast.pixels, none.pixels, none.bytes);
        s.other.shadows = 0;
        s.b.material.shadows = GLINT_TAKES_NO_SHADOW;
        frame taken = stage_draw(&s, which, 0);
        assert_memory_equal(taken.pixels, none.pixels, none.bytes);
        frame_free(&none);
        frame_free(&cast);
        frame_free(&taken);
    }
}

static void test_hard_places(void **state)
{
    (void)state;
    stage s;
    stage_set_up(&s);
    board_light(&s.b, 0, 1000, 0, -1);
    s.b.light[0].casts_shadows = true;
    expect_rays(&s, "light that grazes");
    board_light(&s.b, 0, 1000, 0, 0);
    expect_rays(&s, "light in the board's plane");
    board_light(&s.b, 0, 0, 0, -1000);
    expect_rays(&s, "light in the planes of the box's sides");
    board_light(&s.b, 0, 700, 200, -1000);
    s.objects[1].place = glint_shift(BOARD_Q16(3), 0, BOARD_Q16(5));
    expect_rays(&s, "a box across the eye's plane");
    s.objects[1].place = glint_shift(BOARD_Q16(-6), BOARD_Q16(-2), BOARD_Q16(8));
    expect_rays(&s, "a box behind the eye");
    s.objects[1].place = glint_shift(0, 0, BOARD_Q16(0.25));
    expect_rays(&s, "a box through the board");
    s.b.light[0].kind = GLINT_POINT;
    s.b.light[0].position_q16[2] = BOARD_Q16(0.5);
    expect_rays(&s, "a point light inside the box");
    s.b.light[0].position_q16[0] = BOARD_Q16(-2);
    s.b.light[0].position_q16[2] = BOARD_Q16(0.75);
    expect_rays(&s, "a point light beside the box");
    s.b.light[0].position_q16[0] = BOARD_Q16(-1);
    expect_rays(&s, "a point light on the box's side");
    s.objects[1].mesh = &glint_mesh_plane;
    s.objects[1].place = glint_shift(BOARD_Q16(1), 0, BOARD_Q16(0.5));
    expect_rays(&s, "a sheet seen from its edge");
    const glint_place upright = glint_turn_x(16384), away = glint_shift(0, 0, BOARD_Q16(1));
    s.objects[1].place = glint_then(&upright, &away);
    s.b.light[0].position_q16[2] = BOARD_Q16(3);
    expect_rays(&s, "a sheet before the board, its outside to the light");
    const glint_place over = glint_turn_x(49152);
    s.objects[1].place = glint_then(&over, &away);
    expect_rays(&s, "a sheet before the board, its inside to the light");
    s.objects[1].mesh = &s.b.mesh;
    s.objects[1].place = s.objects[0].place;
    expect_rays(&s, "two boards in one place");
}

/* Scenes from a millimetre to the ends of the ranges: nothing overflows (the sanitizers' build looks), and bands and
 * memory change nothing. */
static void test_any_size(void **state)
{
    (void)state;
    uint64_t random = 5;
    unsigned long tests = 0;
    for (int round = 0; round < 300; round++) {
        stage s;
        stage_set_up(&s);
        const int size = 8 + (int)(random_u24(&random) % 19);
        for (int i = 0; i < 2; i++) {
            glint_place *p = &s.objects[i].place;
            const glint_place turn = glint_turn_y((uint16_t)random_u24(&random));
            *p = turn;
            for (int k = 0; k < 9; k++) {
                p->linear_q16[k / 3][k % 3] =
                    (int32_t)((int64_t)p->linear_q16[k / 3][k % 3] * ((int64_t)1 << size) >> 16);
            }
            for (int k = 0; k < 3; k++) {
                p->origin_q16[k] =
                    (int32_t)(random_u24(&random) % 4096 - 2048) * ((int32_t)1 << (size < 18 ? size : 18));
            }
        }
        for (int i = 0; i < 3; i++) {
            s.b.light[i].casts_shadows = true;
            s.b.light[i].kind = (uint8_t)(i == 2 ? GLINT_DIRECTIONAL : GLINT_POINT);
            for (int k = 0; k < 3; k++) {
                const int far = (int)(random_u24(&random) % 30);
                s.b.light[i].position_q16[k] = (int32_t)(random_u24(&random) % 3 - 1) * ((int32_t)1 << far);
                s.b.light[i].direction[k] = (int16_t)random_u24(&random);
            }
            s.b.light[i].direction[0] = (int16_t)(s.b.light[i].direction[0] | 1);
        }
        s.b.scene.light_count = 3;
        s.b.camera.eye_q16[2] = (int32_t)1 << (size + 3 < 30 ? size + 3 : 30);
        s.b.camera.near_q16 = size < 10 ? 64 : (int32_t)1 << (size - 4);
        for (int which = 0; which < BACKENDS; which++) {
            frame whole = stage_draw(&s, which, 0);
            frame f = {.display = {.width_px = PX, .height_px = PX, .band_px = 5}, .memory_bytes = 1};
            tests += whole.report.shadow_tests;
            assert_int_equal(frame_draw(&f, &s.b.scene, which), 0);
            assert_memory_equal(f.pixels, whole.pixels, whole.bytes);
            frame_free(&f);
            frame_free(&whole);
        }
    }
    printf("%lu shadows of triangles\n", tests);
    assert_true(tests > 300);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_box_on_the_board),
        cmocka_unit_test(test_who_casts_and_who_takes),
        cmocka_unit_test(test_hard_places),
        cmocka_unit_test(test_any_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
