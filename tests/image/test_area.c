/* SPDX-License-Identifier: MIT */
/*
 * Partial updates: an area's rows are drawn and flushed and no others, with the bits of the whole picture, whatever the
 * area, the bands and the memory; and its triangles are counted once.
 */
#include <stdio.h>

#include "examples/scenes/scenes.h"
#include "tests/image/frame.h"

enum { WIDTH_PX = 61, HEIGHT_PX = 43, PAGE_ROWS = 8 };

static const demo_scene *scene_named(const char *name)
{
    const demo_scene *found = NULL;
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        found = strcmp(demo_scenes[i].name, name) == 0 ? &demo_scenes[i] : found;
    }
    assert_non_null(found);
    return found;
}

/* The area has the whole picture's bits, the rest none. */
static void expect_area(const demo_scene *demo, int backend, const frame *whole, uint16_t y_px, uint16_t rows,
                        uint16_t band_px, size_t memory_bytes)
{
    frame area = *whole;
    const unsigned unit = whole->display.format == GLINT_MONO_PAGES ? PAGE_ROWS : 1;
    const size_t from = y_px / unit * whole->row_bytes;
    const size_t to = (y_px + rows + unit - 1) / unit * whole->row_bytes;
    area.display.area_y_px = y_px;
    area.display.area_height_px = rows;
    area.display.band_px = band_px;
    area.memory_bytes = memory_bytes;
    assert_int_equal(frame_draw(&area, demo->scene, backend), GLINT_OK);
    assert_int_equal(area.next_row, y_px + rows);
    if (memcmp(area.pixels + from, whole->pixels + from, to - from) != 0) {
        fail_msg("%s, %s, format %d, rows %u and %u more in bands of %u: another picture", demo->name,
                 frame_backend_name[backend], whole->display.format, y_px, rows - 1, band_px);
    }
    for (size_t i = 0; i < area.bytes; i++) {
        assert_true((i >= from && i < to) || area.pixels[i] == FRAME_CANARY_BYTE);
    }
    for (int tier = 0; tier < GLINT_TIERS; tier++) { /* those that begin above it are counted too */
        assert_true(area.report.tier_pixels[tier] == 0 || area.report.tier_triangles[tier] > 0);
    }
    /* with all rows in one band each triangle is set up once; more bands count the same */
    if (band_px != 0) {
        frame once = area;
        once.display.band_px = 0;
        once.memory_bytes = 0;
        assert_int_equal(frame_draw(&once, demo->scene, backend), GLINT_OK);
        assert_memory_equal(once.report.tier_triangles, area.report.tier_triangles, sizeof once.report.tier_triangles);
        assert_memory_equal(once.report.tier_pixels, area.report.tier_pixels, sizeof once.report.tier_pixels);
        assert_int_equal(once.report.pixels_shaded, area.report.pixels_shaded);
        frame_free(&once);
    }
    frame_free(&area);
}

static void try_areas(const char *name, uint8_t format, uint8_t tolerance, uint16_t step)
{
    const demo_scene *demo = scene_named(name);
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame whole = {
            .display = {.width_px = WIDTH_PX, .height_px = HEIGHT_PX, .format = format, .dither = GLINT_DITHER_BAYER},
            .tolerance = tolerance};
        assert_int_equal(frame_draw(&whole, demo->scene, backend), GLINT_OK);
        for (int y = 0; y < HEIGHT_PX; y += step) {
            for (int rows = step; rows < HEIGHT_PX + step; rows += step) {
                const uint16_t within = (uint16_t)(y + rows > HEIGHT_PX ? HEIGHT_PX - y : rows), from = (uint16_t)y;
                expect_area(demo, backend, &whole, from, within, 0, 0);
                expect_area(demo, backend, &whole, from, within, format == GLINT_MONO_PAGES ? PAGE_ROWS : 5,
                            (size_t)y % 2);
            }
        }
        frame_free(&whole);
    }
}

static void test_any_rows(void **state)
{
    (void)state;
    try_areas("sphere-10x6", GLINT_RGB888, 0, 1);
}

static void test_formats(void **state)
{
    (void)state;
    try_areas("teapot", GLINT_RGB565, GLINT_CODES(1), 7);
    try_areas("room", GLINT_GREY4, 0, 7);
    try_areas("teapot", GLINT_MONO_PAGES, GLINT_CODES(4), PAGE_ROWS);
}

static void test_effects(void **state)
{
    (void)state;
    try_areas("shadows-sun", GLINT_RGB888, GLINT_CODES(1), 11);
    try_areas("glass", GLINT_RGB565, 0, 11);
    try_areas("tiles", GLINT_RGB888, GLINT_CODES(1), 11);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_any_rows),
        cmocka_unit_test(test_formats),
        cmocka_unit_test(test_effects),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
