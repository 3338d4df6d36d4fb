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

static void expect_same(const demo_scene *demo, int backend, const frame *whole, glint_display display,
                        size_t memory_bytes)
{
    frame f = {.display = display, .shading = whole->shading, .memory_bytes = memory_bytes};
    assert_int_equal(frame_draw(&f, demo->scene, backend), 0);
    if (memcmp(f.pixels, whole->pixels, whole->bytes) != 0) {
        fail_msg("%s %s: another image with band %u, buffers %u, memory %zu", demo->name, frame_backend_name[backend],
                 display.band_px, display.buffer_count, memory_bytes);
    }
    frame_free(&f);
}

static void test_bands_buffers_and_memory(void **state)
{
    (void)state;
    static const uint16_t bands[] = {1, 7, 16};
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        const demo_scene *demo = &demo_scenes[i];
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame whole = {.display = {.width_px = demo->width_px, .height_px = demo->height_px}};
            assert_int_equal(frame_draw(&whole, demo->scene, backend), 0);
            for (size_t b = 0; b < sizeof bands / sizeof *bands; b++) {
                const glint_display display = {
                    .width_px = demo->width_px, .height_px = demo->height_px, .band_px = bands[b]};
                expect_same(demo, backend, &whole, display, 0);
            }
            /* the least memory: vertices again for each band, no lists; and a size in between */
            const glint_display banded = {
                .width_px = demo->width_px, .height_px = demo->height_px, .band_px = 60, .buffer_count = 2};
            glint_display sized = banded;
            glint_transfers transfers = {0, 0};
            sized.transfers = &transfers;
            const size_t least = backend == FRAME_FIXED ? glint_fixed_memory_least_bytes(demo->scene, &sized)
                                                        : glint_float_memory_least_bytes(demo->scene, &sized);
            expect_same(demo, backend, &whole, banded, 1);
            expect_same(demo, backend, &whole, banded, least + 9000);
            frame_free(&whole);
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
        uint64_t hash[3];
        for (int shading = GLINT_SHADING_EXACT; shading <= GLINT_SHADING_FLAT; shading++) {
            frame f = {.display = {.width_px = demo->width_px, .height_px = demo->height_px},
                       .shading = (uint8_t)shading};
            assert_int_equal(frame_draw(&f, demo->scene, FRAME_FIXED), 0);
            hash[shading] = frame_hash(&f);
            frame_free(&f);
        }
        if (write) {
            printf("GOLDEN    {\"%s\", {0x%016llx, 0x%016llx, 0x%016llx}},\n", demo->name, (unsigned long long)hash[0],
                   (unsigned long long)hash[1], (unsigned long long)hash[2]);
            continue;
        }
        assert_string_equal(golden_hashes[i].scene, demo->name);
        for (int shading = 0; shading < 3; shading++) {
            if (golden_hashes[i].hash[shading] != hash[shading]) {
                fail_msg("%s, shading %d: the fixed backend's bits have changed", demo->name, shading);
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
