/* SPDX-License-Identifier: MIT */
/*
 * The commonest tiers have loops over a triangle's rows that carry what they need from row to row. Where something else
 * stands in the place of their function, an observer as in tests/image/test_tolerance.h, that function starts afresh
 * with each run of pixels: the picture is the same.
 *
 * A test file defines GLINT_OBSERVE, includes the backend's source, defines RUNS_BACKEND, and then includes this.
 */
#ifndef GLINT_TESTS_UNIT_TEST_TIER_RUNS_H
#define GLINT_TESTS_UNIT_TEST_TIER_RUNS_H

#include "tests/unit/stage.h"

static bool observing;
static shade_function seen_run, wanted_run;
static unsigned seen_runs;

static void observe_run(shade_state *shade, int16_t x, int16_t y, uint16_t count)
{
    seen_runs += shade->tier == GLINT_TIER_CURVED && seen_run == wanted_run;
    if (FIELD_STEPS_EXACT && count > 1) { /* then it does not matter where they begin, either */
        const uint16_t part = (uint16_t)(count / 3 + 1);
        seen_run(shade, x, y, part);
        x = (int16_t)(x + (int16_t)part);
        count = (uint16_t)(count - part);
    }
    if (count > 0) {
        seen_run(shade, x, y, count);
    }
}

static void observe_triangle(shade_state *shade)
{
    if (observing) {
        seen_run = shade->run;
        shade->run = observe_run;
    }
}

static frame draw_observed(const stage *s, bool observed)
{
    frame f = {.display = {.width_px = s->width_px, .height_px = s->height_px, .format = GLINT_RGB565},
               .tolerance = GLINT_CODES(3)};
    f.memory_bytes = (RUNS_BACKEND == FRAME_FIXED ? glint_fixed_memory_bytes(&s->scene, &f.display)
                                                  : glint_float_memory_bytes(&s->scene, &f.display)) +
                     GLINT_RAMP_WORDS * sizeof(uint32_t);
    observing = observed;
    assert_int_equal(frame_draw(&f, &s->scene, RUNS_BACKEND), GLINT_OK);
    return f;
}

static void runs_of_pixels_do_not_depend_on_rows(void **state)
{
    (void)state;
    const shade_function runs[] = {run_curve, run_curve_glossy, run_curve_highlights};
    for (int highlight = 0; highlight < 3; highlight++) {
        stage s;
        stage_set_up(&s, 96, 72, 10);
        stage_triangle(&s, (const stage_corner[3]){{{2, 70, 0}, {-0.2, -0.2, 1}},
                                                   {{94, 66, 0}, {0.2, -0.2, 1}},
                                                   {{48, 2, 0}, {0, 0.2, 1}}});
        s.material.diffuse = stage_grey(0.4);
        s.material.specular = stage_grey(highlight ? 0.4 : 0);
        s.material.exponent_q4 = 10 * 16;
        stage_light(&s, 0.4, 0.1, 1, stage_grey(highlight > 1 ? 0.5 : 1));
        if (highlight > 1) {
            stage_light(&s, -0.1, 0.3, 1, stage_grey(0.5));
        }
        seen_runs = 0;
        wanted_run = runs[highlight];
        frame carried = draw_observed(&s, false), afresh = draw_observed(&s, true);
        assert_true(seen_runs > 50);
        assert_int_equal(carried.report.tier_pixels[GLINT_TIER_CURVED], carried.report.pixels_shaded);
        assert_int_equal(carried.report.pixels_specular, afresh.report.pixels_specular);
        assert_true(!highlight || carried.report.pixels_specular > 0);
        assert_memory_equal(carried.pixels, afresh.pixels, carried.bytes);
        frame_free(&carried);
        frame_free(&afresh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(runs_of_pixels_do_not_depend_on_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

#endif
