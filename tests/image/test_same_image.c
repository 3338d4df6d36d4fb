/* SPDX-License-Identifier: MIT */
/*
 * What must not change the image: the band height, the number of buffers, the memory. And what must never change by
 * accident: the fixed backend's bits, kept as a hash for each built-in scene and shading in golden_hashes.h.
 *
 * GLINT_GOLDEN=write prints the hashes instead of comparing them; `make golden` does so. Look at the pictures before
 * committing new ones.
 */
#include "tests/image/frame.h"

#include <stdio.h>

#include "examples/scenes/scenes.h"
#include "tests/image/golden_hashes.h"

/* Ways to draw a scene: each shading, and within a tolerance. */
#define WAYS 6
static const uint8_t way_shading[WAYS] = {GLINT_SHADING_EXACT, GLINT_SHADING_GOURAUD, GLINT_SHADING_FLAT,
                                          GLINT_SHADING_EXACT, GLINT_SHADING_EXACT,   GLINT_SHADING_Q2};
static const uint8_t way_tolerance[WAYS] = {0, 0, 0, GLINT_CODES(1), GLINT_CODES(4), 0};

static void expect_same(const demo_scene *demo, int backend, const frame *whole, glint_display display,
                        size_t memory_bytes)
{
    frame f = {
        .display = display, .shading = whole->shading, .tolerance = whole->tolerance, .memory_bytes = memory_bytes};
    assert_int_equal(frame_draw(&f, demo->scene, backend), 0);
    if (memcmp(f.pixels, whole->pixels, whole->bytes) != 0) {
        fail_msg("%s %s, tolerance %d: another image with band %u, buffers %u, memory %zu", demo->name,
                 frame_backend_name[backend], whole->tolerance, display.band_px, display.buffer_count, memory_bytes);
    }
    frame_free(&f);
}

static void check_scene(const demo_scene *demo, int backend, int way, uint8_t format)
{
    static const uint16_t bands[] = {1, 7, 16};
    /* the working memory of frame.h has room for what is fixed, lists and vertices; this much more for ramps, too */
    const size_t ramps = (size_t)demo->scene->object_count * 4096;
    frame whole = {.display = {.width_px = demo->width_px, .height_px = demo->height_px, .format = format},
                   .shading = way_shading[way],
                   .tolerance = way_tolerance[way]};
    assert_int_equal(frame_draw(&whole, demo->scene, backend), 0);
    for (size_t b = 0; b < sizeof bands / sizeof *bands; b++) {
        glint_display display = whole.display;
        display.band_px = bands[b];
        const size_t full = backend == FRAME_FIXED ? glint_fixed_memory_bytes(demo->scene, &display)
                                                   : glint_float_memory_bytes(demo->scene, &display);
        expect_same(demo, backend, &whole, display, b == 1 ? full + ramps : 0);
    }
    /* the least memory: vertices again for each band, no lists; and a size in between */
    glint_display banded = {
        .width_px = demo->width_px, .height_px = demo->height_px, .format = format, .band_px = 60, .buffer_count = 2};
    glint_display sized = banded;
    glint_transfers transfers = {0, 0};
    sized.transfers = &transfers;
    const size_t least = backend == FRAME_FIXED ? glint_fixed_memory_least_bytes(demo->scene, &sized)
                                                : glint_float_memory_least_bytes(demo->scene, &sized);
    expect_same(demo, backend, &whole, banded, 1);
    expect_same(demo, backend, &whole, banded, least + 9000);
    frame_free(&whole);
}

static void test_bands_buffers_and_memory(void **state)
{
    (void)state;
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            check_scene(&demo_scenes[i], backend, 0, GLINT_RGB888);
            for (int way = 3; way < WAYS; way++) {
                check_scene(&demo_scenes[i], backend, way, way == 3 ? GLINT_RGB565 : GLINT_RGB888);
            }
        }
    }
}

/* Every band height from 1 to that of a small display. */
static void test_every_band_height(void **state)
{
    (void)state;
    const demo_scene *demo = demo_scene_named("room");
    assert_non_null(demo);
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        for (int format = GLINT_RGB888; format <= GLINT_GREY4; format++) {
            frame whole = {
                .display = {.width_px = 61, .height_px = 43, .format = (uint8_t)format, .dither = GLINT_DITHER_BAYER}};
            assert_int_equal(frame_draw(&whole, demo->scene, backend), 0);
            for (uint16_t band = 1; band <= 43; band++) {
                const glint_display display = {.width_px = 61,
                                               .height_px = 43,
                                               .format = (uint8_t)format,
                                               .dither = GLINT_DITHER_BAYER,
                                               .band_px = band};
                expect_same(demo, backend, &whole, display, 0);
            }
            frame_free(&whole);
        }
        frame pages = {
            .display = {.width_px = 61, .height_px = 43, .format = GLINT_MONO_PAGES, .dither = GLINT_DITHER_BAYER}};
        assert_int_equal(frame_draw(&pages, demo->scene, backend), 0);
        for (uint16_t band = 8; band <= 48; band = (uint16_t)(band + 8)) {
            const glint_display display = {.width_px = 61,
                                           .height_px = 43,
                                           .format = GLINT_MONO_PAGES,
                                           .dither = GLINT_DITHER_BAYER,
                                           .band_px = band};
            expect_same(demo, backend, &pages, display, 0);
        }
        frame_free(&pages);
    }
}

static void test_fixed_bits(void **state)
{
    (void)state;
    const char *golden = getenv("GLINT_GOLDEN");
    const int write = golden != NULL && strcmp(golden, "write") == 0;
    assert_true(write || GOLDEN_COUNT == demo_scene_count);
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        const demo_scene *demo = &demo_scenes[i];
        uint64_t hash[WAYS];
        for (int way = 0; way < WAYS; way++) {
            frame f = {.display = {.width_px = demo->width_px, .height_px = demo->height_px},
                       .shading = way_shading[way],
                       .tolerance = way_tolerance[way]};
            assert_int_equal(frame_draw(&f, demo->scene, FRAME_FIXED), 0);
            hash[way] = frame_hash(&f);
            frame_free(&f);
        }
        if (write) {
            printf("GOLDEN    {\"%s\", {", demo->name);
            for (int way = 0; way < WAYS; way++) {
                printf("%s0x%016llx", way ? ", " : "", (unsigned long long)hash[way]);
            }
            printf("}},\n");
            continue;
        }
        assert_string_equal(golden_hashes[i].scene, demo->name);
        for (int way = 0; way < WAYS; way++) {
            if (golden_hashes[i].hash[way] != hash[way]) {
                fail_msg("%s, shading %d, tolerance %d: the fixed backend's bits have changed", demo->name,
                         way_shading[way], way_tolerance[way]);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bands_buffers_and_memory),
        cmocka_unit_test(test_every_band_height),
        cmocka_unit_test(test_fixed_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
