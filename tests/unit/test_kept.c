/* SPDX-License-Identifier: MIT */
/*
 * What is set up of a triangle may be kept from one band to the next, see src/kept.inc. However much room there is for
 * it, the picture and the report's counts are those of the whole frame drawn at once; memory_used_bytes is as much as
 * makes the most of it, and with less nothing else changes.
 */
#include <stdio.h>

#include "examples/scenes/scenes.h"
#include "tests/image/frame.h"

/* More than any of these frames keeps. */
#define PLENTY ((size_t)1 << 20)

/* Room is given in so many steps from none to all that is made use of. */
#define STEPS 9

typedef struct way {
    uint8_t shading, tolerance;
} way;

static const way ways[] = {
    {GLINT_SHADING_EXACT, 0},
    {GLINT_SHADING_GOURAUD, 0},
    {GLINT_SHADING_FLAT, 0},
    {GLINT_SHADING_Q1, 0},
    {GLINT_SHADING_Q2, 0},
    {GLINT_SHADING_EXACT, GLINT_CODES(1)},
    {GLINT_SHADING_EXACT, GLINT_CODES(4)},
};

static const char *const names[] = {"sphere-32x16", "blinn", "torus-knot", "room", "point-light"};

static frame draw(const demo_scene *demo, int backend, const way *w, uint8_t format, uint16_t band_px, size_t bytes)
{
    frame f = {
        .display = {.width_px = demo->width_px, .height_px = demo->height_px, .band_px = band_px, .format = format},
        .shading = w->shading,
        .tolerance = w->tolerance,
        .memory_bytes = bytes};
    assert_int_equal(frame_draw(&f, demo->scene, backend), GLINT_OK);
    return f;
}

/* All that the report counts but bands and bytes. */
static void expect_same(const frame *f, const frame *whole)
{
    glint_report of_bands = f->report, of_whole = whole->report;
    assert_memory_equal(f->pixels, whole->pixels, whole->bytes);
    of_bands.bands = of_whole.bands = 0;
    of_bands.memory_used_bytes = of_whole.memory_used_bytes = 0;
    assert_memory_equal(&of_bands, &of_whole, sizeof of_whole);
}

static size_t check(const demo_scene *demo, int backend, const way *w, uint8_t format, uint16_t band_px)
{
    frame whole = draw(demo, backend, w, format, 0, 0), none = draw(demo, backend, w, format, band_px, 0);
    const size_t base = none.memory_given;
    expect_same(&none, &whole);
    frame all = draw(demo, backend, w, format, band_px, base + PLENTY);
    expect_same(&all, &whole);
    const size_t used = all.report.memory_used_bytes;
    /* where tables are not made, triangles are kept in the room for them */
    assert_in_range(used, none.report.memory_used_bytes, base + PLENTY - 1);
    for (size_t step = 1; step <= STEPS; step++) {
        const size_t bytes = base + (used > base ? used - base : 0) * step / STEPS;
        frame some = draw(demo, backend, w, format, band_px, bytes);
        expect_same(&some, &whole);
        assert_true(some.report.memory_used_bytes <= bytes);
        assert_true(step < STEPS || some.report.memory_used_bytes == used || used < base);
        frame_free(&some);
    }
    frame_free(&all);
    frame_free(&none);
    frame_free(&whole);
    return used - none.report.memory_used_bytes;
}

static void the_picture_does_not_depend_on_what_is_kept(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const demo_scene *const demo = demo_scene_named(names[i]);
        assert_non_null(demo);
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            size_t most = 0;
            for (size_t w = 0; w < sizeof ways / sizeof *ways; w++) {
                const size_t kept =
                    check(demo, backend, &ways[w], w % 2 ? GLINT_RGB565 : GLINT_RGB888, (uint16_t)(w % 3 ? 16 : 37));
                most = kept > most ? kept : most;
            }
            assert_true(most > 0);
            printf("%-16s %-6s keeps %zu bytes at most\n", demo->name, frame_backend_name[backend], most);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_picture_does_not_depend_on_what_is_kept),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
