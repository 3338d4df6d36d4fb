/* SPDX-License-Identifier: MIT */
/*
 * The edges of a mesh: lines against distances in double, and frames whose lines have a closed form, clipped ones too.
 */
#include "tests/unit/geometry_world.h"

#include <stdio.h>

#include "effects/wire.h"
#include "tests/unit/board.h"

#define ROUNDS 40000

static glint_point any_point(int32_t spread_px)
{
    const glint_point point = {random_between(-spread_px * 256, spread_px * 256),
                               random_between(-spread_px * 256, spread_px * 256)};
    return point;
}

/* The border of a line is where it should be but for 1 / |d|, and what is held in 32 bits does not show. */
static void test_lines(void **state)
{
    long double worst = 0;
    (void)state;
    for (int i = 0; i < ROUNDS; i++) {
        const int32_t spread_px = random_u32() & 1 ? 4 : 700;
        const glint_point from = any_point(spread_px), to = any_point(spread_px);
        const uint16_t width_q4 = (uint16_t)random_between(1, random_u32() & 1 ? 40 : GLINT_MAX_WIRE_Q4);
        const long double dx = to.x - from.x, dy = to.y - from.y, length = sqrtl(dx * dx + dy * dy);
        glint_wire_line line;
        if (!glint_wire_line_set_up(&line, &from, &to, width_q4)) {
            assert_true(length * width_q4 < 17);
            continue;
        }
        const int16_t x = (int16_t)random_between(-spread_px, spread_px);
        const int16_t y = (int16_t)random_between(-spread_px, spread_px);
        const uint16_t count = (uint16_t)random_between(1, 16), on = glint_wire_row(&line, x, y, count);
        assert_int_equal(on >> count, 0);
        for (int k = 0; k < count; k++) {
            const long double px = (x + k) * 256 + 128 - from.x, py = y * 256 + 128 - from.y;
            /* sub-pixels */
            const long double distance = fabsl(dx * py - dy * px) / length, half = 8 * width_q4;
            if ((on >> k & 1) != (distance < half)) {
                worst = fmaxl(worst, fabsl(distance - half) * length / 256);
            }
        }
    }
    printf("border of a line: off by at most %.3Lf / |d|\n", worst);
    assert_true(worst <= 1.1L && worst > 0.5L);
}

static void draw(frame *f, const board *b, int backend, uint8_t shading, uint8_t tolerance, uint16_t band_px)
{
    memset(f, 0, sizeof *f);
    f->display.width_px = f->display.height_px = BOARD_PX;
    f->display.band_px = band_px;
    f->shading = shading;
    f->tolerance = tolerance;
    assert_int_equal(frame_draw(f, &b->scene, backend), 0);
}

/* The board's corners are far outside of the picture: what shows is its diagonal, from the lower left to the upper
 * right, of which each triangle draws half. */
static void check_diagonal(const frame *f, double half_px, int shown, int drawn)
{
    for (int y = 0; y < BOARD_PX; y++) {
        for (int x = 0; x < BOARD_PX; x++) {
            const double distance = abs(x + y + 1 - BOARD_PX) / sqrt(2);
            const int level = f->pixels[3 * (y * BOARD_PX + x)];
            if (fabs(distance - half_px) > 0.01) {
                assert_int_equal(level, distance < half_px ? drawn : shown);
            }
        }
    }
}

static void test_diagonal_of_a_board(void **state)
{
    static const uint8_t shadings[] = {GLINT_SHADING_EXACT, GLINT_SHADING_GOURAUD, GLINT_SHADING_FLAT,
                                       GLINT_SHADING_Q1};
    (void)state;
    for (int n = 0; n < FRAME_BACKENDS * 5 * 3; n++) {
        static const uint16_t widths_q4[] = {16, 33, 120};
        const int backend = n % 2, how = n / 2 % 5;
        board b;
        frame f;
        board_set_up(&b);
        b.scene.light_count = 0;
        b.material.emission = board_grey(4819); /* 75 */
        b.material.wire = board_grey(12850);    /* 200 */
        b.material.wire_width_q4 = widths_q4[n / 10];
        draw(&f, &b, backend, how < 4 ? shadings[how] : GLINT_SHADING_EXACT, how < 4 ? 0 : 16, n & 4 ? 0 : 7);
        check_diagonal(&f, widths_q4[n / 10] / 32.0, 75, 200);
        frame_free(&f);
    }
}

/* Cut at the near plane, and by the guard band: neither leaves a line of its own. */
static void test_clipping_draws_no_line(void **state)
{
    (void)state;
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        board b;
        frame f;
        board_set_up(&b);
        b.scene.light_count = 0;
        b.material.emission = board_grey(4819);
        b.material.wire = board_grey(12850);
        b.material.wire_width_q4 = 64;
        /* a floor, of which the eye sees the middle: no edge but the diagonal, which runs to the right, away */
        b.object.place.linear_q16[0][0] = BOARD_Q16(40);
        b.object.place.linear_q16[1][2] = BOARD_Q16(1);
        b.object.place.linear_q16[2][1] = BOARD_Q16(-40);
        b.object.place.origin_q16[1] = BOARD_Q16(-1);
        draw(&f, &b, backend, GLINT_SHADING_EXACT, 0, 0);
        int lines = 0;
        for (int x = 0; x < BOARD_PX; x++) {
            lines += f.pixels[3 * ((BOARD_PX - 1) * BOARD_PX + x)] == 200;
        }
        assert_true(f.report.triangles_clipped > 0);
        assert_true(lines <= 8); /* of 33: the diagonal crosses the last row, at 45 degrees */
        frame_free(&f);
    }
}

/* A layer's wire hides what is behind it; fog covers it. */
static void test_wire_with_other_effects(void **state)
{
    (void)state;
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        board b;
        frame f;
        board_set_up(&b);
        b.scene.light_count = 0;
        b.scene.background = board_grey(16384);
        b.material.wire = board_grey(12850);
        b.material.wire_width_q4 = 48;
        b.material.transmission_q14 = 8192;
        draw(&f, &b, backend, GLINT_SHADING_EXACT, 0, 0);
        check_diagonal(&f, 1.5, 128, 200);
        frame_free(&f);
        b.material.transmission_q14 = 0;
        b.scene.fog.colour = board_grey(0);
        b.scene.fog.begin_q16 = BOARD_Q16(0);
        b.scene.fog.end_q16 = BOARD_Q16(10); /* half way at the board */
        draw(&f, &b, backend, GLINT_SHADING_EXACT, 0, 0);
        check_diagonal(&f, 1.5, 0, 100);
        frame_free(&f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lines),
        cmocka_unit_test(test_diagonal_of_a_board),
        cmocka_unit_test(test_clipping_draws_no_line),
        cmocka_unit_test(test_wire_with_other_effects),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
