/* SPDX-License-Identifier: MIT */
/*
 * What a plan leaves out changes no pixel: every built-in scene and 1,000 random ones, drawn by a backend that follows
 * the plan and by a copy of it for which every term is needed (attenuation and cones where the light has them), bit for
 * bit. The exact shading at every pixel, and Gouraud and flat shading too.
 *
 * A test file defines PRUNING_RENDER, the library's backend, and PRUNING_FULL, the copy's; and includes the copy's
 * source before this, with glint_plan_object and glint_plan_light replaced by those below.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "examples/scenes/scenes.h"
#include "tests/image/test_tolerance_worlds.h"

enum { RANDOM_SCENES = 1000, MEMORY_BYTES = 4 << 20 };

typedef struct picture {
    uint32_t *memory;
    uint8_t *pixels;
    size_t bytes, used;
} picture;

static int keep_band(void *context, const glint_band *band)
{
    picture *p = context;
    assert_true(p->used + band->bytes <= p->bytes);
    memcpy(p->pixels + p->used, band->pixels, band->bytes);
    p->used += band->bytes;
    return 0;
}

typedef int (*draw_function)(const glint_scene *, const glint_display *, const glint_quality *, void *, size_t,
                             glint_report *);

static void draw_with(draw_function draw, const glint_scene *scene, uint16_t width_px, uint16_t height_px,
                      uint8_t shading, picture *out)
{
    const glint_display display = {.width_px = width_px, .height_px = height_px, .flush = keep_band, .context = out};
    const glint_quality quality = {.shading = shading};
    glint_report report;
    out->used = 0;
    assert_int_equal(draw(scene, &display, &quality, out->memory, MEMORY_BYTES, &report), GLINT_OK);
}

typedef struct tally {
    picture planned, full;
    unsigned frames, different;
    unsigned long terms_left_out;
} tally;

static void compare(tally *t, const char *name, const glint_scene *scene, uint16_t width_px, uint16_t height_px)
{
    for (int shading = GLINT_SHADING_EXACT; shading <= GLINT_SHADING_FLAT; shading++) {
        draw_with(PRUNING_RENDER, scene, width_px, height_px, (uint8_t)shading, &t->planned);
        draw_with(PRUNING_FULL, scene, width_px, height_px, (uint8_t)shading, &t->full);
        t->frames++;
        if (t->planned.used != t->full.used || memcmp(t->planned.pixels, t->full.pixels, t->full.used) != 0) {
            printf("%s, shading %d: pictures differ\n", name, shading);
            t->different++;
        }
    }
    for (uint16_t i = 0; i < scene->object_count; i++) {
        glint_object_plan of_object;
        (glint_plan_object)(scene, i, &of_object);
        for (uint16_t k = 0; k < scene->light_count; k++) {
            glint_light_plan plan = {.diffuse = GLINT_NEEDED, .specular = GLINT_NEEDED};
            (glint_plan_light)(scene, i, &of_object, k, &plan);
            /* cppcheck-suppress uninitvar ; set here */
            t->terms_left_out += plan.diffuse != GLINT_NEEDED;
            t->terms_left_out += plan.specular != GLINT_NEEDED;
        }
    }
}

static void test_plans_change_no_pixel(void **state)
{
    tally t;
    world *w = malloc(sizeof *w);
    (void)state;
    assert_non_null(w);
    memset(&t, 0, sizeof t);
    picture *const both[2] = {&t.planned, &t.full};
    for (int i = 0; i < 2; i++) {
        both[i]->bytes = (size_t)320 * 240 * 3;
        both[i]->memory = malloc(MEMORY_BYTES);
        both[i]->pixels = malloc(both[i]->bytes);
        assert_non_null(both[i]->memory);
        assert_non_null(both[i]->pixels);
    }
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        compare(&t, demo_scenes[i].name, demo_scenes[i].scene, demo_scenes[i].width_px, demo_scenes[i].height_px);
    }
    for (uint32_t i = 0; i < RANDOM_SCENES; i++) {
        char name[32];
        (void)snprintf(name, sizeof name, "random scene %u", (unsigned)i);
        make_world(w, 20261127, i);
        compare(&t, name, &w->scene, w->width_px, w->height_px);
    }
    printf("%u frames, %u different, %lu terms left out of their objects\n", t.frames, t.different, t.terms_left_out);
    assert_int_equal(t.different, 0);
    assert_true(t.terms_left_out > 1000);
    for (int i = 0; i < 2; i++) {
        free(both[i]->memory);
        free(both[i]->pixels);
    }
    free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_plans_change_no_pixel)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
