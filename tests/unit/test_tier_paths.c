/* SPDX-License-Identifier: MIT */
/*
 * Ways through the tiers of a tolerance that common scenes do not take, each by a scene made for it.
 *
 * A scene is drawn by each backend with exact shading, and with a tolerance or the shading asked for, in RGB888 and in
 * RGB565. Of both the frame's report promises how far a pixel is from the true colour, so they lie within the sum of
 * the promises of each other. The latter is drawn again with the least memory and with memory for tables, in one piece
 * and in bands of few rows: always the same picture. The tier that the scene is made for has to have drawn some pixels.
 */
#include "tests/unit/stage.h"

#include <stdio.h>

typedef struct expectation {
    const char *name;
    uint8_t shading, tolerance;
    int tier[FRAME_BACKENDS]; /* that draws pixels; GLINT_TIERS: any */
} expectation;

/* More memory than all vertices take, for the tables of the object's material. */
enum { MEMORY_LEAST, MEMORY_VERTICES, MEMORY_TABLES, MEMORIES };

static size_t memory_of(const stage *s, const glint_display *display, int backend, int memory)
{
    const size_t full = backend == FRAME_FIXED ? glint_fixed_memory_bytes(&s->scene, display)
                                               : glint_float_memory_bytes(&s->scene, display);
    return memory == MEMORY_LEAST ? 1 : memory == MEMORY_VERTICES ? full : full + GLINT_RAMP_WORDS * sizeof(uint32_t);
}

static frame draw(const stage *s, int backend, uint8_t format, uint8_t shading, uint8_t tolerance, uint16_t band_px,
                  int memory)
{
    frame f = {.display = {.width_px = s->width_px, .height_px = s->height_px, .band_px = band_px, .format = format},
               .shading = shading,
               .tolerance = tolerance};
    f.memory_bytes = memory_of(s, &f.display, backend, memory);
    assert_int_equal(frame_draw(&f, &s->scene, backend), GLINT_OK);
    return f;
}

/* A pixel's channel in codes, and what its format rounds by more than half a code. */
static double code_at(const frame *f, size_t pixel, int channel, double *coarse)
{
    if (f->display.format == GLINT_RGB888) {
        *coarse = 0;
        return f->pixels[3 * pixel + (size_t)channel];
    }
    static const int shift[3] = {11, 5, 0}, greatest[3] = {31, 63, 31};
    uint16_t word;
    memcpy(&word, f->pixels + 2 * pixel, sizeof word);
    *coarse = 127.5 / greatest[channel] - 0.5;
    return 255.0 * (word >> shift[channel] & greatest[channel]) / greatest[channel];
}

static void expect_within_promises(const expectation *e, const frame *drawn, const frame *exact)
{
    const double most = (drawn->report.promise_q8 + exact->report.promise_q8) / 256.0;
    const size_t pixels = (size_t)exact->display.width_px * exact->display.height_px;
    assert_int_not_equal(drawn->report.promise_q8, UINT16_MAX);
    assert_int_not_equal(exact->report.promise_q8, UINT16_MAX);
    for (size_t i = 0; i < 3 * pixels; i++) {
        double coarse, fine;
        const double code = code_at(drawn, i / 3, (int)(i % 3), &coarse);
        const double off = code - code_at(exact, i / 3, (int)(i % 3), &fine);
        if (off > most + coarse || off < -most - coarse) {
            fail_msg("%s: pixel %u,%u is %.2f codes off the exact shading, %.2f promised", e->name,
                     (unsigned)(i / 3 % exact->display.width_px), (unsigned)(i / 3 / exact->display.width_px), off,
                     most + coarse);
        }
    }
}

static void expect_same_picture(const expectation *e, const frame *one, const frame *other)
{
    assert_int_equal(one->bytes, other->bytes);
    if (memcmp(one->pixels, other->pixels, one->bytes) != 0) {
        fail_msg("%s: the picture changes with the memory or the bands", e->name);
    }
    assert_int_equal(one->report.promise_q8, other->report.promise_q8);
    assert_int_equal(one->report.pixels_shaded, other->report.pixels_shaded);
}

static void expect(const stage *s, const expectation *e)
{
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame exact = draw(s, backend, GLINT_RGB888, GLINT_SHADING_EXACT, 0, s->height_px, MEMORY_VERTICES);
        assert_true(exact.report.pixels_shaded > 0);
        for (int i = 0; i < 2; i++) {
            const uint8_t format = i == 0 ? GLINT_RGB888 : GLINT_RGB565;
            frame drawn = draw(s, backend, format, e->shading, e->tolerance, s->height_px, MEMORY_TABLES);
            expect_within_promises(e, &drawn, &exact);
            if (e->tier[backend] != GLINT_TIERS && drawn.report.tier_pixels[e->tier[backend]] == 0) {
                fail_msg("%s: no pixel of tier %d (%s)", e->name, e->tier[backend], frame_backend_name[backend]);
            }
            for (int memory = 0; memory < MEMORIES; memory++) {
                frame again =
                    draw(s, backend, format, e->shading, e->tolerance, memory == MEMORY_TABLES ? 3 : 7, memory);
                expect_same_picture(e, &drawn, &again);
                frame_free(&again);
            }
            frame_free(&drawn);
        }
        frame_free(&exact);
    }
}

#define BOTH(tier)                                                                                                     \
    {                                                                                                                  \
        tier, tier                                                                                                     \
    }

/* ------------------------------------------------------------------------------------------------------ sums of light
 */

/* A triangle over most of the picture whose normals lean apart by 2 `lean`. */
static void leaning_triangle(stage *s, double lean)
{
    stage_triangle(s, (const stage_corner[3]){{{4, 60, 0}, {-lean, -lean, 1}},
                                              {{60, 58, 0}, {lean, -lean, 1}},
                                              {{30, 5, 0}, {0, lean, 1}}});
}

static void two_crossing_lights(void **state)
{
    (void)state;
    for (int coloured = 0; coloured < 2; coloured++) {
        stage s;
        stage_set_up(&s, 64, 64, 45);
        leaning_triangle(&s, 0.25);
        stage_light(&s, -1, 0, 0.1, stage_grey(0.5));
        stage_light(&s, 1, 0, 0.1, coloured ? stage_colour(0.5, 0.1, 0.3) : stage_grey(0.5));
        expect(&s, &(expectation){"crossing, q1", GLINT_SHADING_Q1, 0, BOTH(GLINT_TIER_Q1)});
        expect(&s, &(expectation){"crossing, q2", GLINT_SHADING_Q2, 0, BOTH(GLINT_TIER_Q2)});
        expect(&s, &(expectation){"crossing, curved", GLINT_SHADING_EXACT, GLINT_CODES(2), BOTH(GLINT_TIER_CURVED)});
    }
}

/* Point lights that shine on all of the triangle or cross it, in colour and on a ramp. */
static void point_lights_that_cross(void **state)
{
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        stage s;
        stage_set_up(&s, 64, 64, 45);
        leaning_triangle(&s, 0.1);
        stage_point_light(&s, 2, 5, 6, stage_grey(0.5));
        stage_point_light(&s, -9, 1, kind & 2 ? 1 : 5, kind & 1 ? stage_colour(0.5, 0.2, 0.1) : stage_grey(0.5));
        expect(&s, &(expectation){"point lights", GLINT_SHADING_EXACT, GLINT_CODES(2), BOTH(GLINT_TIER_CURVED)});
    }
}

/* One point light alone is a curve, but not one that is known to stay above 0; nor are so dim steps of a direction. */
static void one_light_that_may_need_a_clamp(void **state)
{
    stage s;
    (void)state;
    stage_set_up(&s, 64, 64, 45);
    leaning_triangle(&s, 0.1);
    stage_point_light(&s, 2, 5, 6, stage_grey(1));
    expect(&s, &(expectation){"one point light", GLINT_SHADING_EXACT, GLINT_CODES(2), BOTH(GLINT_TIER_CURVED)});
    stage_set_up(&s, 64, 64, 45);
    leaning_triangle(&s, 0.1);
    stage_light(&s, 1, 0, 0.11, stage_grey(1));
    expect(&s, &(expectation){"grazing light", GLINT_SHADING_EXACT, GLINT_CODES(2), BOTH(GLINT_TIER_CURVED)});
}

/* A light that stands on a corner has no direction there. */
static void a_point_light_on_a_corner(void **state)
{
    stage s;
    (void)state;
    stage_set_up(&s, 64, 64, 45);
    leaning_triangle(&s, 0.1);
    stage_point_light_on(&s, 0);
    expect(&s, &(expectation){"light on a corner", GLINT_SHADING_EXACT, GLINT_CODES(1), BOTH(GLINT_TIER_EXACT)});
}

/* ---------------------------------------------------------------------------------------------------------- highlights
 */

/* A ramp has one colour, so a white highlight on tinted ground leaves it where it shows. */
static void highlights_beside_the_ramp(void **state)
{
    stage s;
    (void)state;
    stage_set_up(&s, 64, 64, 15);
    leaning_triangle(&s, 0.05);
    s.material.diffuse = stage_colour(0.6, 0.2, 0.1);
    s.material.specular = stage_grey(0.4);
    s.material.exponent_q4 = 20 * 16;
    stage_light(&s, 0, 0, 1, stage_grey(1));
    expect(&s, &(expectation){"white on tinted", GLINT_SHADING_EXACT, GLINT_CODES(2), BOTH(GLINT_TIER_CURVED)});
    expect(&s, &(expectation){"white on tinted, q2", GLINT_SHADING_Q2, 0, BOTH(GLINT_TIER_Q2)});
}

static void several_highlights_on_a_ramp(void **state)
{
    (void)state;
    for (int model = GLINT_PHONG; model <= GLINT_BLINN; model++) {
        stage s;
        stage_set_up(&s, 160, 120, 15);
        stage_triangle(&s, (const stage_corner[3]){{{2, 117, 0}, {-0.1, -0.1, 1}},
                                                   {{157, 112, 0}, {0.1, -0.1, 1}},
                                                   {{80, 2, 0}, {0, 0.1, 1}}});
        s.material.diffuse = s.material.specular = stage_grey(0.3);
        s.material.exponent_q4 = 20 * 16;
        s.material.specular_model = (uint8_t)model;
        const int tier = model == GLINT_PHONG ? GLINT_TIER_CURVED : GLINT_TIER_Q1;
        stage_light(&s, 0.1, 0.1, 1, stage_grey(1));
        expect(&s, &(expectation){"a highlight", GLINT_SHADING_EXACT, GLINT_CODES(4), {tier, tier}});
        stage_light(&s, -0.1, -0.05, 1, stage_grey(0.9));
        expect(&s, &(expectation){"two highlights", GLINT_SHADING_EXACT, GLINT_CODES(4), {tier, tier}});
        expect(&s, &(expectation){"two highlights, q1", GLINT_SHADING_Q1, 0, BOTH(GLINT_TIER_Q1)});
    }
}

/* A table of no size: the term is less than what may be left out, but nothing says that it misses the triangle. */
static void a_faint_broad_highlight(void **state)
{
    stage s;
    (void)state;
    stage_set_up(&s, 64, 64, 15);
    leaning_triangle(&s, 0.1);
    s.material.specular = stage_grey(2 / 16384.0);
    s.material.exponent_q4 = 16;
    stage_light(&s, 0, 0, 1, stage_grey(1));
    expect(&s, &(expectation){"faint", GLINT_SHADING_EXACT, GLINT_CODES(1), BOTH(GLINT_TIER_CURVED)});
}

static void the_narrowest_highlight(void **state)
{
    stage s;
    (void)state;
    stage_set_up(&s, 64, 64, 15);
    leaning_triangle(&s, 0.02);
    s.material.diffuse = stage_grey(0.5);
    s.material.specular = stage_grey(1);
    s.material.exponent_q4 = GLINT_MAX_EXPONENT * 16;
    stage_light(&s, 0, 0, 1, stage_grey(1));
    expect(&s, &(expectation){"narrow", GLINT_SHADING_EXACT, GLINT_CODES(15.9), BOTH(GLINT_TIERS)});
}

/* Long and thin: rounding of a cubic's third differences would add up to more than the gap itself; or it is too long
 * for a cubic. */
static void a_highlight_on_a_strip(void **state)
{
    static const uint16_t width_px[] = {364, 600};
    (void)state;
    for (int i = 0; i < 2; i++) {
        stage s;
        const double end = width_px[i] - 5;
        stage_set_up(&s, width_px[i], 24, 1.2);
        stage_triangle(&s, (const stage_corner[3]){{{2, 15, 0}, {0, 1, 0.2}},
                                                   {{end, 15, 0}, {0, 1, 0.2}},
                                                   {{end - 5, 9, 0}, {0, 1, 0.21}}});
        s.material.diffuse = stage_grey(0.9);
        s.material.specular = stage_grey(0.5);
        s.material.exponent_q4 = 16;
        stage_light(&s, 0, 0, 1, stage_grey(1));
        stage_light(&s, 0, 1, 0, stage_grey(0.2));
        expect(&s, &(expectation){"strip", GLINT_SHADING_EXACT, GLINT_CODES(2), BOTH(GLINT_TIERS)});
    }
}

/* Rows longer than what is looked at in one piece, clear of the highlight; and pixels that are hidden already. */
static void a_highlight_across_the_picture(void **state)
{
    stage s;
    (void)state;
    stage_set_up(&s, 160, 120, 8);
    for (int i = 0; i < 2; i++) {
        stage_triangle(&s, (const stage_corner[3]){{{2, 117, 0}, {-0.1, -0.1, 1}},
                                                   {{157, 112, 0}, {0.1, -0.1, 1}},
                                                   {{80, 2, 0}, {0, 0.1, 1}}});
    }
    s.material.diffuse = stage_grey(0.5);
    s.material.specular = stage_grey(0.2);
    s.material.exponent_q4 = 200 * 16;
    stage_light(&s, 0.1, 0.1, 1, stage_grey(1));
    expect(&s, &(expectation){"across", GLINT_SHADING_EXACT, GLINT_CODES(8), BOTH(GLINT_TIERS)});
    expect(&s, &(expectation){"across", GLINT_SHADING_EXACT, GLINT_CODES(4), BOTH(GLINT_TIERS)});
}

/* The mirrored ray and the direction to the camera are opposite along an axis. */
static void a_highlight_behind(void **state)
{
    stage s;
    (void)state;
    stage_set_up(&s, 33, 33, 45);
    stage_triangle(&s, (const stage_corner[3]){{{2, 30, 0}, {1, 0, 1 / 16384.0}},
                                               {{30, 30, 0}, {1, 0, 1 / 16384.0}},
                                               {{16, 2, 0}, {1, 0, 1 / 16384.0}}});
    s.material.diffuse = stage_grey(0.5);
    s.material.specular = stage_grey(0.5);
    s.material.exponent_q4 = 16;
    stage_light(&s, 0, 0, 1, stage_grey(1));
    expect(&s, &(expectation){"behind", GLINT_SHADING_Q1, 0, {GLINT_TIER_Q1, GLINT_TIER_Q1}});
}

/* Off the triangle, but on a pixel that its highlight is looked at, the light shines straight at the camera. */
static void a_light_straight_ahead(void **state)
{
    stage s;
    (void)state;
    stage_set_up(&s, 9, 9, 170);
    stage_triangle(&s, (const stage_corner[3]){
                           {{1.6, 5.9, 0}, {0, 0, -1}}, {{3.4, 5.9, 0}, {0, 0, -1}}, {{2.5, 3.0, 0}, {0, 0, -1}}});
    s.material.diffuse = stage_grey(0.5);
    s.material.specular = stage_grey(0.5);
    s.material.exponent_q4 = 16;
    s.material.specular_model = GLINT_BLINN;
    stage_light(&s, 0, 0, -1, stage_grey(1));
    expect(&s, &(expectation){"ahead", GLINT_SHADING_Q1, 0, {GLINT_TIER_Q1, GLINT_TIER_Q1}});
}

/* Rays to corners far off the screen are too long for 16 bits. */
static void a_highlight_with_corners_off_the_screen(void **state)
{
    static const double far_px[] = {150, 190, 400};
    (void)state;
    for (int i = 0; i < 3; i++) {
        stage s;
        const double far = far_px[i];
        stage_set_up(&s, 64, 64, 45);
        stage_triangle(&s, (const stage_corner[3]){{{-20, 90, 0}, {0, 0, 1}},
                                                   {{far, far * 0.7, 0}, {0, 0.01, 1}},
                                                   {{10, -30, 0}, {0, 0, 1}}});
        s.material.diffuse = s.material.specular = stage_grey(0.4);
        s.material.exponent_q4 = 10 * 16;
        stage_light(&s, 0, 0, 1, stage_grey(1));
        expect(&s, &(expectation){"off the screen", GLINT_SHADING_EXACT, GLINT_CODES(4), BOTH(GLINT_TIERS)});
    }
}

/* -------------------------------------------------------------------------------------------------------------- shapes
 */

/* Near corners are a millionth as far as the far one. */
static void a_floor_to_the_horizon(void **state)
{
    stage s;
    (void)state;
    stage_set_up(&s, 64, 64, 90);
    stage_floor(&s);
    stage_light(&s, 0, 1, 0.3, stage_grey(1));
    for (int codes = 1; codes <= 4; codes *= 2) {
        expect(&s, &(expectation){"floor", GLINT_SHADING_EXACT, (uint8_t)(16 * codes), BOTH(GLINT_TIERS)});
    }
}

/* Rays to a point light from corners so far off the display that they do not fit. */
static void a_point_light_over_far_corners(void **state)
{
    stage s;
    (void)state;
    stage_set_up(&s, 9, 9, 170);
    stage_triangle(
        &s, (const stage_corner[3]){{{-20, 40, 0}, {0, 0, 1}}, {{30, 20, 0}, {0, 0, 1}}, {{5, -30, 0}, {0, 0, 1}}});
    for (int k = 0; k < 3; k++) {
        s.object.place.linear_q16[k][k] *= 4; /* from the middle of the display */
    }
    stage_point_light(&s, 10, 10, 500, stage_grey(1));
    expect(&s, &(expectation){"far corners", GLINT_SHADING_EXACT, GLINT_CODES(4), BOTH(GLINT_TIERS)});
}

static double between(uint64_t *random, double low, double high)
{
    return low + (high - low) * random_u24(random) / 16777216.0;
}

/* Triangles of about a pixel with normals up to `apart` from the mean: planes of them are steep. */
static void steep_triangles(void **state)
{
    static const double apart[] = {0.3, 0.6, 0.9};
    uint64_t random = 1;
    (void)state;
    for (int round = 0; round < 60; round++) {
        stage s;
        stage_set_up(&s, 24, 24, 45);
        for (int i = 0; i < STAGE_TRIANGLES; i++) {
            const int column = i % 8, row = i / 8;
            const double x = 1.5 + 3 * column, y = 2.5 + 5 * row;
            stage_corner corner[3];
            for (int k = 0; k < 3; k++) {
                corner[k].at[0] = x + between(&random, -1.2, 1.2);
                corner[k].at[1] = y + between(&random, -1.2, 1.2);
                corner[k].at[2] = 0;
                corner[k].normal[2] = 1;
                for (int c = 0; c < 2; c++) {
                    corner[k].normal[c] = between(&random, -apart[round % 3], apart[round % 3]);
                }
            }
            stage_triangle(&s, corner);
        }
        s.material.diffuse = stage_grey(0.5);
        s.material.specular = stage_grey(round % 2 ? 0.3 : 0);
        s.material.exponent_q4 = 16;
        s.material.specular_model = round & 2 ? GLINT_BLINN : GLINT_PHONG;
        stage_light(&s, 0.2, 0.3, 1, stage_grey(1));
        expect(&s, &(expectation){"steep, q1", GLINT_SHADING_Q1, 0, BOTH(GLINT_TIERS)});
        expect(&s, &(expectation){"steep, q2", GLINT_SHADING_Q2, 0, BOTH(GLINT_TIERS)});
        expect(&s, &(expectation){"steep", GLINT_SHADING_EXACT, GLINT_CODES(15.9), BOTH(GLINT_TIERS)});
    }
}

/* Triangles as thin as have planes at all, half a pixel across, along which the normal turns by 70 degrees: by more
 * than two a pixel, and a plane's value where it begins lies far outside the unit sphere. */
static void thin_triangles(void **state)
{
    uint64_t random = 2;
    (void)state;
    for (int round = 0; round < 400; round++) {
        stage s;
        stage_set_up(&s, 40, 24, 45);
        for (int i = 0; i < STAGE_TRIANGLES; i++) {
            stage_corner corner[3];
            const int column = i % 8, row = i / 8;
            const double x = 2.5 + 5 * column + between(&random, -0.5, 0.5);
            const double y = 3.5 + 5.5 * row + between(&random, -0.5, 0.5);
            /* any; towards a pixel's corner with one component of the normal, or with all three alike */
            const int kind = i % 3, quarter = (int)between(&random, 0, 4);
            const double angle = kind == 0 ? between(&random, 0, 2 * STAGE_PI)
                                           : STAGE_PI / 4 + STAGE_PI / 2 * quarter + between(&random, -0.1, 0.1);
            const double across = kind == 0 ? between(&random, 0.35, 0.6) : between(&random, 0.36, 0.48);
            const double along = 2 / fmax(fabs(sin(angle)), fabs(cos(angle))) * between(&random, 0.97, 1);
            double turn[3], aside[3], length = 0, dot = 0;
            for (int k = 0; k < 3; k++) {
                turn[k] = kind == 0 ? between(&random, -1, 1) : kind == 1 ? between(&random, -0.2, 0.2) + (k == 1) : 1;
                length += turn[k] * turn[k];
            }
            for (int k = 0; k < 3; k++) {
                turn[k] /= sqrt(length);
                aside[k] = between(&random, -1, 1);
                dot += aside[k] * turn[k];
            }
            length = 0;
            for (int k = 0; k < 3; k++) {
                aside[k] -= dot * turn[k];
                length += aside[k] * aside[k];
            }
            for (int c = 0; c < 3; c++) {
                const double side = c == 0 ? 0 : c == 1 ? along : -along, away = c == 0 ? 0 : across;
                corner[c].at[0] = x + away * cos(angle) - side * sin(angle);
                corner[c].at[1] = y + away * sin(angle) + side * cos(angle);
                corner[c].at[2] = 0;
                for (int k = 0; k < 3; k++) {
                    corner[c].normal[k] = 0.8 * aside[k] / sqrt(length) + (c == 0 ? -0.6 : 0.6) * turn[k];
                }
            }
            stage_triangle(&s, corner);
        }
        s.material.diffuse = stage_grey(0.5);
        stage_light(&s, 0.2, 0.3, 1, stage_grey(1));
        expect(&s, &(expectation){"thin, q1", GLINT_SHADING_Q1, 0, BOTH(GLINT_TIERS)});
        expect(&s, &(expectation){"thin, q2", GLINT_SHADING_Q2, 0, BOTH(GLINT_TIERS)});
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_crossing_lights),
        cmocka_unit_test(point_lights_that_cross),
        cmocka_unit_test(one_light_that_may_need_a_clamp),
        cmocka_unit_test(a_point_light_on_a_corner),
        cmocka_unit_test(highlights_beside_the_ramp),
        cmocka_unit_test(several_highlights_on_a_ramp),
        cmocka_unit_test(a_faint_broad_highlight),
        cmocka_unit_test(the_narrowest_highlight),
        cmocka_unit_test(a_highlight_on_a_strip),
        cmocka_unit_test(a_highlight_across_the_picture),
        cmocka_unit_test(a_highlight_behind),
        cmocka_unit_test(a_light_straight_ahead),
        cmocka_unit_test(a_highlight_with_corners_off_the_screen),
        cmocka_unit_test(a_floor_to_the_horizon),
        cmocka_unit_test(steep_triangles),
        cmocka_unit_test(thin_triangles),
        cmocka_unit_test(a_point_light_over_far_corners),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
