/* SPDX-License-Identifier: MIT */
/*
 * Variants of the backends with fewer parts: what they draw is what the whole backend draws, bit for bit, in every
 * format, with bands of any height and with the least memory; what they have no part for is refused with
 * GLINT_ERROR_PART before anything is written, part by part, and what they have is checked as the whole backend does.
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
    /* a page has 8 rows */
    const uint32_t line = band->y_px / (band->stride_bytes * band->height_px > band->bytes ? 8u : 1u);
    memcpy((uint8_t *)context + (size_t)line * band->stride_bytes, band->pixels, band->bytes);
    return 0;
}

/* How a picture is drawn, beside the scene: by default RGB888, 24 rows at a time, with all the memory there is. */
typedef struct look {
    uint8_t format, dither;
    uint16_t band_px;
    bool least;
} look;

static int draw_as(const variant *v, draw_function render, const glint_scene *scene, const glint_quality *quality,
                   const look *as, uint8_t *to)
{
    const glint_display display = {.width_px = WIDTH,
                                   .height_px = HEIGHT,
                                   .band_px = as->band_px,
                                   .format = as->format,
                                   .dither = as->dither,
                                   .flush = keep,
                                   .context = to};
    const bytes_function least = render == v->whole ? v->whole_least : v->least;
    return render(scene, &display, quality, memory_words, as->least ? least(scene, &display) : sizeof memory_words,
                  NULL);
}

static int draw(draw_function render, const glint_scene *scene, const glint_quality *quality, uint8_t *to)
{
    static const look plain = {.band_px = 24};
    return draw_as(&variants[0], render, scene, quality, &plain, to);
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
            assert_in_range(v->bytes(scene, &display), v->least(scene, &display), v->whole_bytes(scene, &display));
            assert_in_range(v->least(scene, &display), 1, v->whole_least(scene, &display));
            drawn++;
        }
        printf("%-14s draws %u built-in scenes, refuses %u\n", v->name, drawn, refused);
        assert_true(drawn >= 2);
    }
}

/* The scenes that a variant draws, in other formats, other bands and the least memory. */
static void test_the_same_pixels_in_every_format(void **state)
{
    static const look looks[] = {
        {GLINT_RGB565, GLINT_DITHER_NONE, 16, false},    {GLINT_RGB565_SWAPPED, GLINT_DITHER_BAYER, 7, false},
        {GLINT_GREY8, GLINT_DITHER_NONE, 1, true},       {GLINT_GREY4, GLINT_DITHER_BAYER, 0, false},
        {GLINT_MONO_PAGES, GLINT_DITHER_BAYER, 8, true}, {GLINT_RGB888, GLINT_DITHER_NONE, 71, true}};
    const glint_quality exact = {.shading = GLINT_SHADING_EXACT};
    (void)state;
    for (size_t k = 0; k < VARIANTS; k++) {
        const variant *v = &variants[k];
        for (uint16_t i = 0; i < demo_scene_count; i++) {
            for (size_t n = 0; n < sizeof looks / sizeof *looks && has(v, demo_scenes[i].scene); n++) {
                memset(pictures, FRAME_CANARY_BYTE, sizeof pictures);
                assert_int_equal(draw_as(v, v->render, demo_scenes[i].scene, &exact, &looks[n], pictures[0]), GLINT_OK);
                assert_int_equal(draw_as(v, v->whole, demo_scenes[i].scene, &exact, &looks[n], pictures[1]), GLINT_OK);
                assert_memory_equal(pictures[0], pictures[1], sizeof pictures[0]);
            }
        }
    }
}

/* Triangles of any shape, thin ones and ones that are cut at the near plane and the guard band included; with normals
 * of zero here and there, and triangles of no area. */
static void test_the_same_pixels_of_any_triangle(void **state)
{
    enum { WORLDS = 400, CORNERS = 30 };
    const glint_quality exact = {.shading = GLINT_SHADING_EXACT};
    uint32_t random = 12345, drawn = 0, clipped = 0;
    (void)state;
    for (int world = 0; world < WORLDS; world++) {
        static int16_t positions[CORNERS][3], normals[CORNERS][3];
        static uint16_t triangles[CORNERS / 3][3];
        board b;
        board_set_up(&b);
        for (int i = 0; i < CORNERS; i++) {
            triangles[i / 3][i % 3] = (uint16_t)i;
            for (int c = 0; c < 3; c++) {
                random = random * 1664525u + 1013904223u;
                positions[i][c] = (int16_t)((int32_t)(int16_t)(random >> 16) >> (world % 4));
                random = random * 1664525u + 1013904223u;
                normals[i][c] = (int16_t)(world % 5 == 0 ? 0 : (int32_t)(int16_t)(random >> 16) >> 1);
            }
            if (i % 3 == 2 && world % 2) { /* nearly in a line with the others */
                for (int c = 0; c < 3; c++) {
                    positions[i][c] = (int16_t)((positions[i - 1][c] + positions[i - 2][c]) / 2 + (world % 3 - 1) * c);
                }
            }
        }
        b.mesh.positions = (const int16_t(*)[3])positions;
        b.mesh.normals_q14 = (const int16_t(*)[3])normals;
        b.mesh.triangles = (const uint16_t(*)[3])triangles;
        b.mesh.vertex_count = CORNERS;
        b.mesh.triangle_count = CORNERS / 3;
        b.mesh.fraction_bits = (int8_t)(world % 3 == 0 ? 11 : 13);
        b.material.diffuse = b.material.ambient = board_grey(9000);
        b.scene.ambient = board_grey(3000);
        b.scene.light_count = 1;
        board_light(&b, 0, 3, -2, -7);
        for (size_t k = 0; k < VARIANTS; k++) {
            static const look plain = {.band_px = 24};
            glint_report report;
            const glint_display display = {
                .width_px = WIDTH, .height_px = HEIGHT, .band_px = 24, .flush = keep, .context = pictures[1]};
            assert_int_equal(draw_as(&variants[k], variants[k].render, &b.scene, &exact, &plain, pictures[0]),
                             GLINT_OK);
            assert_int_equal(variants[k].whole(&b.scene, &display, &exact, memory_words, sizeof memory_words, &report),
                             GLINT_OK);
            assert_memory_equal(pictures[0], pictures[1], sizeof pictures[0]);
            drawn += report.triangles_drawn;
            clipped += report.triangles_clipped;
        }
    }
    printf("any triangle: %u drawn, %u of them clipped\n", drawn, clipped);
    assert_true(drawn > 2000 && clipped > 500);
}

/* What asks for one part each. */
#define REFUSED(X)                                                                                                     \
    X(spot, (b->light[0].kind = GLINT_SPOT, b->light[0].outer_turn16 = 4096))                                          \
    X(attenuation, (b->light[0].kind = GLINT_POINT, b->light[0].attenuation.k_q14[1] = 1))                             \
    X(range, (b->light[0].kind = GLINT_POINT, b->light[0].attenuation.range_q16 = 1 << 20))                            \
    X(panel, (b->light[0].kind = GLINT_PANEL, b->light[0].edge_q16[0][0] = b->light[0].edge_q16[1][1] = 1 << 16))      \
    X(ball, (b->light[0].kind = GLINT_BALL, b->light[0].radius_q16 = 1 << 16))                                         \
    X(shadows, b->light[0].casts_shadows = true)                                                                       \
    X(sky, b->scene.sky = board_grey(1))                                                                               \
    X(ground, b->scene.ground = board_grey(1))                                                                         \
    X(fog, b->scene.fog.end_q16 = 1 << 20)                                                                             \
    X(mirror, (b->scene.environment = &environment, b->material.mirror = board_grey(1)))                               \
    X(each_side, b->material.sides = GLINT_EACH_SIDE)                                                                  \
    X(two_sided, b->material.sides = GLINT_TWO_SIDED)                                                                  \
    X(transmission, b->material.transmission_q14 = 1)                                                                  \
    X(wire, b->material.wire_width_q4 = 1)                                                                             \
    X(texture, (b->material.texture = &dot, b->mesh.texcoords = texcoords, b->mesh.texcoord_bits = 9))                 \
    X(tolerance, quality->tolerance = GLINT_CODES(1))                                                                  \
    X(gouraud, quality->shading = GLINT_SHADING_GOURAUD)                                                               \
    X(flat, quality->shading = GLINT_SHADING_FLAT)                                                                     \
    X(q1, quality->shading = GLINT_SHADING_Q1)                                                                         \
    X(q2, quality->shading = GLINT_SHADING_Q2)

static const uint16_t texels[64];
static const glint_environment environment = {.texels = texels, .side = 8};
static const int16_t texcoords[4][2];
static const glint_texture dot = {.texels = texels, .width_px = 1, .height_px = 1};

#define ASK(name, change)                                                                                              \
    static void ask_##name(board *b, glint_quality *quality)                                                           \
    {                                                                                                                  \
        (void)quality;                                                                                                 \
        (void)b;                                                                                                       \
        change;                                                                                                        \
    }
REFUSED(ASK)

static const struct {
    const char *name;
    void (*ask)(board *b, glint_quality *quality);
} refused[] = {
#define ROW(name, change) {#name, ask_##name},
    REFUSED(ROW)};

static void expect_refused(const variant *v, const board *b, const glint_quality *quality, const char *name)
{
    memset(memory_words, FRAME_CANARY_BYTE, sizeof memory_words);
    pictures[0][0] = FRAME_CANARY_BYTE;
    const int result = draw(v->render, &b->scene, quality, pictures[0]);
    if (result != GLINT_ERROR_PART) {
        fail_msg("%s, %s: %d", v->name, name, result);
    }
    for (size_t n = 0; n < sizeof memory_words / 4; n++) {
        assert_true(((const uint8_t *)&memory_words[n])[0] == FRAME_CANARY_BYTE);
    }
    assert_int_equal(pictures[0][0], FRAME_CANARY_BYTE);
    assert_int_equal(draw(v->whole, &b->scene, quality, pictures[0]), GLINT_OK);
}

static void test_what_has_no_part_is_refused(void **state)
{
    (void)state;
    for (size_t k = 0; k < VARIANTS; k++) {
        const variant *v = &variants[k];
        glint_quality exact = {.shading = GLINT_SHADING_EXACT};
        board b;
        for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
            glint_quality quality = exact;
            board_set_up(&b);
            b.scene.light_count = 1;
            refused[i].ask(&b, &quality);
            expect_refused(v, &b, &quality, refused[i].name);
        }
        board_set_up(&b);
        b.scene.light_count = 1;
        b.material.specular = board_grey(1);
        if (v->specular) {
            assert_int_equal(draw(v->render, &b.scene, &exact, pictures[0]), GLINT_OK);
        } else {
            expect_refused(v, &b, &exact, "specular");
        }
        b.material.specular = board_grey(0);
        b.light[0].kind = GLINT_POINT;
        if (v->points) {
            assert_int_equal(draw(v->render, &b.scene, &exact, pictures[0]), GLINT_OK);
        } else {
            expect_refused(v, &b, &exact, "point light");
        }
    }
}

static void test_a_report_is_refused(void **state)
{
    const glint_quality exact = {.shading = GLINT_SHADING_EXACT};
    const glint_display display = {
        .width_px = WIDTH, .height_px = HEIGHT, .band_px = 24, .flush = keep, .context = pictures[0]};
    board b;
    (void)state;
    board_set_up(&b);
    for (size_t k = 0; k < VARIANTS; k++) {
        glint_report report = {.bands = 7};
        assert_int_equal(variants[k].render(&b.scene, &display, &exact, memory_words, sizeof memory_words, &report),
                         GLINT_ERROR_PART);
        assert_int_equal(report.bands, 7);
    }
}

/* What belongs to parts that a variant has gets the whole backend's code. */
#define BAD(X)                                                                                                         \
    X(b->scene.camera = NULL)                                                                                          \
    X(b->camera.field_of_view_turn16 = 0)                                                                              \
    X(b->camera.near_q16 = 0)                                                                                          \
    X(b->camera.eye_q16[2] = 0)                                                                                        \
    X(b->camera.eye_q16[0] = INT32_MIN)                                                                                \
    X(b->scene.ambient.g_q14 = -1)                                                                                     \
    X(b->scene.background.r_q14 = 16385)                                                                               \
    X(b->light[0].colour.b_q14 = -1)                                                                                   \
    X(b->light[0].direction[2] = 0)                                                                                    \
    X(b->object.material = NULL)                                                                                       \
    X(b->material.ambient.r_q14 = -1)                                                                                  \
    X(b->material.diffuse.r_q14 = 16385)                                                                               \
    X(b->material.emission.b_q14 = -1)                                                                                 \
    X(b->object.mesh = NULL)                                                                                           \
    X(b->mesh.triangle_count = 0)                                                                                      \
    X(b->mesh.fraction_bits = 25)                                                                                      \
    X(b->triangles[1][2] = 4)                                                                                          \
    X(b->object.place.linear_q16[0][0] = INT32_MIN)                                                                    \
    X(b->object.place.linear_q16[1][1] = 1 << 16)                                                                      \
    X(b->object.place.origin_q16[2] = INT32_MIN)

static void test_what_has_a_part_is_checked(void **state)
{
    const glint_quality exact = {.shading = GLINT_SHADING_EXACT};
    (void)state;
    for (size_t k = 0; k < VARIANTS; k++) {
#define EXPECT_BAD(change)                                                                                             \
    {                                                                                                                  \
        board board_of_this, *const b = &board_of_this;                                                                \
        board_set_up(b);                                                                                               \
        b->scene.light_count = 1;                                                                                      \
        change;                                                                                                        \
        const int wanted = draw(variants[k].whole, &b->scene, &exact, pictures[1]);                                    \
        assert_true(wanted < 0);                                                                                       \
        assert_int_equal(draw(variants[k].render, &b->scene, &exact, pictures[0]), wanted);                            \
    }
        BAD(EXPECT_BAD)
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_same_pixels_or_refused),
        cmocka_unit_test(test_the_same_pixels_in_every_format),
        cmocka_unit_test(test_the_same_pixels_of_any_triangle),
        cmocka_unit_test(test_what_has_no_part_is_refused),
        cmocka_unit_test(test_a_report_is_refused),
        cmocka_unit_test(test_what_has_a_part_is_checked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
