/* SPDX-License-Identifier: MIT */
/*
 * Variants of the backends with fewer parts: what they draw is what the whole backend draws, bit for bit; what they
 * have no part for is refused with GLINT_ERROR_PART before anything is written.
 */
#include <stdio.h>
#include <stdlib.h>

#include <glint/glint.h>

#include "examples/scenes/scenes.h"
#include "tests/unit/board.h"

enum { MEMORY_BYTES = 2 << 20, WIDTH = 96, HEIGHT = 72 };

typedef int (*draw_function)(const glint_scene *, const glint_display *, const glint_quality *, void *, size_t,
                             glint_report *);
typedef size_t (*bytes_function)(const glint_scene *, const glint_display *);

typedef struct variant {
    const char *name;
    draw_function render, whole;
    bytes_function bytes, whole_bytes, least, whole_least;
    bool specular, points;
} variant;

#define VARIANT(backend, kind, specular, points)                                                                       \
    {                                                                                                                  \
#backend " " #kind, glint_##backend##_##kind##_render, glint_##backend##_render,                               \
            glint_##backend##_##kind##_memory_bytes, glint_##backend##_memory_bytes,                                   \
            glint_##backend##_##kind##_memory_least_bytes, glint_##backend##_memory_least_bytes, specular, points      \
    }
static const variant variants[] = {VARIANT(fixed, phong, true, true), VARIANT(fixed, diffuse, false, false),
                                   VARIANT(float, phong, true, true), VARIANT(float, diffuse, false, false)};
#define VARIANTS (sizeof variants / sizeof *variants)

static uint32_t memory_words[MEMORY_BYTES / 4];
static uint8_t pictures[2][WIDTH * HEIGHT * 3];

static int keep(void *context, const glint_band *band)
{
    memcpy((uint8_t *)context + (size_t)band->y_px * WIDTH * 3, band->pixels, band->bytes);
    return 0;
}

static int draw(draw_function render, const glint_scene *scene, const glint_quality *quality, uint8_t *to)
{
    const glint_display display = {.width_px = WIDTH, .height_px = HEIGHT, .band_px = 24, .flush = keep, .context = to};
    return render(scene, &display, quality, memory_words, sizeof memory_words, NULL);
}

static bool black(const glint_colour *colour)
{
    return colour->r_q14 == 0 && colour->g_q14 == 0 && colour->b_q14 == 0;
}

static bool has(const variant *v, const glint_scene *scene)
{
    bool all = black(&scene->sky) && black(&scene->ground) && scene->fog.end_q16 == 0;
    for (uint16_t i = 0; i < scene->light_count; i++) {
        const glint_light *light = &scene->lights[i];
        const glint_attenuation *a = &light->attenuation;
        const bool attenuated = a->range_q16 != 0 || a->k_q14[0] != 0 || a->k_q14[1] != 0 || a->k_q14[2] != 0;
        all = all && !light->casts_shadows &&
              (light->kind == GLINT_DIRECTIONAL || (v->points && light->kind == GLINT_POINT && !attenuated));
    }
    for (uint16_t i = 0; i < scene->object_count; i++) {
        const glint_material *m = scene->objects[i].material;
        all = all && (v->specular || black(&m->specular)) && black(&m->mirror) && m->sides == GLINT_FRONT_SIDE &&
              m->transmission_q14 == 0 && m->wire_width_q4 == 0 && m->texture == NULL;
    }
    return all;
}

static void test_the_same_pixels_or_refused(void **state)
{
    (void)state;
    const glint_quality exact = {.shading = GLINT_SHADING_EXACT};
    const glint_display display = {.width_px = WIDTH, .height_px = HEIGHT, .band_px = 24, .flush = keep};
    for (size_t k = 0; k < VARIANTS; k++) {
        const variant *v = &variants[k];
        unsigned drawn = 0, refused = 0;
        for (uint16_t i = 0; i < demo_scene_count; i++) {
            const glint_scene *scene = demo_scenes[i].scene;
            memset(pictures, FRAME_CANARY_BYTE, sizeof pictures);
            const int result = draw(v->render, scene, &exact, pictures[0]);
            if (!has(v, scene)) {
                assert_int_equal(result, GLINT_ERROR_PART);
                assert_int_equal(pictures[0][0], FRAME_CANARY_BYTE);
                refused++;
                continue;
            }
            assert_int_equal(result, GLINT_OK);
            assert_int_equal(draw(v->whole, scene, &exact, pictures[1]), GLINT_OK);
            assert_memory_equal(pictures[0], pictures[1], sizeof pictures[0]);
            assert_int_equal(v->bytes(scene, &display), v->whole_bytes(scene, &display));
            assert_int_equal(v->least(scene, &display), v->whole_least(scene, &display));
            drawn++;
        }
        printf("%-14s draws %u built-in scenes, refuses %u\n", v->name, drawn, refused);
        assert_true(drawn >= 2);
    }
}

static void test_what_has_no_part_is_refused(void **state)
{
    (void)state;
    for (size_t k = 0; k < VARIANTS; k++) {
        const glint_quality asked[] = {{.tolerance = GLINT_CODES(1)},
                                       {.shading = GLINT_SHADING_GOURAUD},
                                       {.shading = GLINT_SHADING_FLAT},
                                       {.shading = GLINT_SHADING_Q1},
                                       {.shading = GLINT_SHADING_Q2}};
        board b;
        board_set_up(&b);
        for (size_t i = 0; i < sizeof asked / sizeof *asked; i++) {
            memset(memory_words, FRAME_CANARY_BYTE, sizeof memory_words);
            assert_int_equal(draw(variants[k].render, &b.scene, &asked[i], pictures[0]), GLINT_ERROR_PART);
            for (size_t n = 0; n < sizeof memory_words / 4; n++) {
                assert_true(((const uint8_t *)&memory_words[n])[0] == FRAME_CANARY_BYTE);
            }
            assert_int_equal(draw(variants[k].whole, &b.scene, &asked[i], pictures[0]), GLINT_OK);
        }
        const glint_quality exact = {.shading = GLINT_SHADING_EXACT};
        b.material.specular = board_grey(0);
        assert_int_equal(draw(variants[k].render, &b.scene, &exact, pictures[0]), GLINT_OK);
        b.light[0].casts_shadows = true;
        assert_int_equal(draw(variants[k].render, &b.scene, &exact, pictures[0]), GLINT_ERROR_PART);
        assert_int_equal(draw(variants[k].whole, &b.scene, &exact, pictures[0]), GLINT_OK);
    }
}

/* X(name, change): each effect by itself, the smallest that asks for its part. */
#define EFFECTS(X)                                                                                                     \
    X(spot, (point(b), b->light[0].kind = GLINT_SPOT, b->light[0].outer_turn16 = 8192))                                \
    X(attenuation, (point(b), b->light[0].attenuation.k_q14[2] = 1))                                                   \
    X(range, (point(b), b->light[0].attenuation.range_q16 = 1 << 20))                                                  \
    X(panel, (point(b), b->light[0].kind = GLINT_PANEL))                                                               \
    X(ball, (point(b), b->light[0].kind = GLINT_BALL))                                                                 \
    X(shadows, b->light[0].casts_shadows = true)                                                                       \
    X(sky, b->scene.sky.r_q14 = 1)                                                                                     \
    X(ground, b->scene.ground.b_q14 = 1)                                                                               \
    X(mirror, (b->material.mirror.g_q14 = 1, b->scene.environment = &around))                                          \
    X(both_sides, b->material.sides = GLINT_EACH_SIDE)                                                                 \
    X(two_sides, b->material.sides = GLINT_TWO_SIDED)                                                                  \
    X(fog, b->scene.fog.end_q16 = 1 << 16)                                                                             \
    X(transmission, b->material.transmission_q14 = 1)                                                                  \
    X(wire, b->material.wire_width_q4 = 1)                                                                             \
    X(texture, (b->material.texture = &dot, b->mesh.texcoords = corner_texcoords, b->mesh.texcoord_bits = 9))

static const uint16_t no_texels[64];
static const int16_t corner_texcoords[4][2];
static const glint_environment around = {.texels = no_texels, .side = 8};
static const glint_texture dot = {.texels = no_texels, .width_px = 1, .height_px = 1};

static void point(board *b)
{
    b->light[0].kind = GLINT_POINT;
    b->light[0].position_q16[2] = 1 << 18;
}

#define DEFINE(what, change)                                                                                           \
    static void with_##what(board *b)                                                                                  \
    {                                                                                                                  \
        change;                                                                                                        \
    }
EFFECTS(DEFINE)

#define ROW(what, change) {#what, with_##what},
static const struct effect {
    const char *name;
    void (*add)(board *);
} effects[] = {EFFECTS(ROW)};

static void test_each_effect_is_refused(void **state)
{
    (void)state;
    const glint_quality exact = {.shading = GLINT_SHADING_EXACT};
    for (size_t k = 0; k < VARIANTS; k++) {
        for (size_t i = 0; i < sizeof effects / sizeof *effects; i++) {
            board b;
            board_set_up(&b);
            assert_int_equal(draw(variants[k].render, &b.scene, &exact, pictures[0]), GLINT_OK);
            effects[i].add(&b);
            memset(memory_words, FRAME_CANARY_BYTE, sizeof memory_words);
            const int result = draw(variants[k].render, &b.scene, &exact, pictures[0]);
            if (result != GLINT_ERROR_PART) {
                fail_msg("%s, %s: %d", variants[k].name, effects[i].name, result);
            }
            for (size_t n = 0; n < sizeof memory_words; n++) {
                assert_true(((const uint8_t *)memory_words)[n] == FRAME_CANARY_BYTE);
            }
            assert_int_equal(draw(variants[k].whole, &b.scene, &exact, pictures[0]), GLINT_OK);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_same_pixels_or_refused),
        cmocka_unit_test(test_what_has_no_part_is_refused),
        cmocka_unit_test(test_each_effect_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
