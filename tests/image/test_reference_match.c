/* SPDX-License-Identifier: MIT */
/*
 * Every built-in scene, in both backends, against the double-precision reference.
 *
 * Budgets (tests/reference/reference.h says what is plain and what contested):
 */
#define PLAIN_CODES 1.0 /* greatest |code - 255 L| of a plain pixel, final rounding (0.5) included: exact shading */
#define FACE_CODES 1.0  /* the same for flat and Gouraud shading */
#define PLAIN_ABOVE 0   /* plain pixels more than 1 code from the reference's code */
#define CONTESTED_UNMATCHED 0 /* contested pixels that agree with no triangle that meets there */
#define CONTESTED_SHARE 0.005 /* of the frame, but for its texels and shadows */
#define TEXEL_SHARE 0.02      /* contested because of a texture: the edges of texels, steep or far reduced pictures */
#define SHADOW_SHARE 0.05     /* of the frame: within a pixel of a shadow's edge, of one light or another */

#include "tests/image/frame.h"

#include <math.h>
#include <stdio.h>

#include "examples/scenes/scenes.h"
#include "tests/reference/reference.h"
#include "tools/import/import.h"

static void match(const demo_scene *demo, int shading, double codes, double share)
{
    reference_image image;
    char error[200];
    if (reference_render(demo->scene, demo->width_px, demo->height_px, shading, &image, error, sizeof error) != 0) {
        fail_msg("%s: %s", demo->name, error);
    }
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame f = {.display = {.width_px = demo->width_px, .height_px = demo->height_px}, .shading = (uint8_t)shading};
        reference_verdict verdict;
        assert_int_equal(frame_draw(&f, demo->scene, backend), 0);
        reference_check(&image, f.pixels, 1, &verdict);
        const double texels = (double)verdict.contested_texel / verdict.pixels;
        printf("%-22s %s %d: max=%.3f mean=%.3f psnr=%.1f differing=%u of %u; contested=%.3f%% texel=%.3f%% "
               "shadow=%.3f%% unmatched=%u\n",
               demo->name, frame_backend_name[backend], shading, verdict.max_codes, verdict.mean_codes, verdict.psnr_db,
               (unsigned)verdict.differing, (unsigned)verdict.pixels, 100 * verdict.contested_share - 100 * texels,
               100 * texels, 100 * verdict.shadow_share, (unsigned)verdict.unmatched);
        assert_true(verdict.max_codes <= codes);
        assert_true(verdict.above <= PLAIN_ABOVE);
        assert_true(verdict.unmatched <= CONTESTED_UNMATCHED);
        assert_true(verdict.contested_share - texels < share);
        assert_true(texels <= (share < 1 ? TEXEL_SHARE : 1));
        assert_true(verdict.shadow_share < (share < 1 ? SHADOW_SHARE : 1));
        frame_free(&f);
    }
    reference_free(&image);
}

static void test_exact_within_one_code(void **state)
{
    (void)state;
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        match(&demo_scenes[i], GLINT_SHADING_EXACT, PLAIN_CODES, CONTESTED_SHARE);
    }
}

static void test_gouraud_within_one_code(void **state)
{
    (void)state;
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        match(&demo_scenes[i], GLINT_SHADING_GOURAUD, FACE_CODES, CONTESTED_SHARE);
    }
}

static void test_flat_within_one_code(void **state)
{
    (void)state;
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        match(&demo_scenes[i], GLINT_SHADING_FLAT, FACE_CODES, CONTESTED_SHARE);
    }
}

/* Turned scenes meet other slivers and silhouettes than the still ones. */
static void test_turned_scenes_within_one_code(void **state)
{
    (void)state;
    static const char *const names[] = {"sphere-32x16", "teapot", "room", "point-light"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const demo_scene *demo = demo_scene_named(names[i]);
        assert_non_null(demo);
        for (unsigned turn = 0; turn < 4; turn++) {
            glint_object objects[64];
            glint_scene scene;
            assert_true(demo->scene->object_count <= 64);
            assert_int_equal(demo_scene_turn(demo->scene, (uint16_t)(5000 + 13001 * turn), objects, &scene), 0);
            demo_scene turned = *demo;
            turned.scene = &scene;
            match(&turned, GLINT_SHADING_EXACT, PLAIN_CODES, CONTESTED_SHARE);
        }
    }
}

/* From the eye towards the target, into and through the objects: the near plane and the guard band cut triangles. The
 * frame is small and full of edges, so the share of contested pixels has no budget here. */
static void test_clipped_scenes_within_one_code(void **state)
{
    (void)state;
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        for (int step = 1; step <= 8; step++) {
            glint_scene scene = *demo_scenes[i].scene;
            glint_camera camera = *scene.camera;
            for (int k = 0; k < 3; k++) {
                camera.eye_q16[k] += (camera.target_q16[k] - camera.eye_q16[k]) / 9 * step + 77;
            }
            camera.near_q16 = (int32_t)1 << (10 + step);
            scene.camera = &camera;
            const demo_scene near = {demo_scenes[i].name, "", &scene, 120, 90};
            match(&near, GLINT_SHADING_EXACT, PLAIN_CODES, 1);
        }
    }
}

/* Textured surfaces that mirror, are seen from both sides, let light through, have a wire, stand in fog, in shadow; one
 * by one and all together. */
static void test_textures_among_effects_within_one_code(void **state)
{
    (void)state;
    enum { MIRROR = 1, SIDES = 2, THROUGH = 4, GRAZING = 8, WIRE = 16, FOG = 32, SKY = 64, SHADOWS = 128, ALL = 255 };
    static const int effects[] = {MIRROR,  SIDES,         THROUGH, THROUGH | SIDES, THROUGH | GRAZING, WIRE, FOG, SKY,
                                  SHADOWS, SHADOWS | FOG, ALL};
    static const char *const names[] = {"tiles", "planet"};
    static const int shadings[] = {GLINT_SHADING_EXACT, GLINT_SHADING_GOURAUD, GLINT_SHADING_FLAT};
    for (size_t n = 0; n < 2 * sizeof effects / sizeof *effects; n++) {
        const int with = effects[n / 2];
        const demo_scene *const demo = demo_scene_named(names[n % 2]);
        glint_scene scene = *demo->scene;
        glint_object objects[3];
        glint_material materials[3];
        glint_light lights[2];
        assert_true(scene.object_count <= 3 && scene.light_count <= 2);
        for (uint16_t i = 0; i < scene.light_count; i++) {
            lights[i] = scene.lights[i];
            lights[i].casts_shadows = (with & SHADOWS) != 0;
        }
        scene.lights = lights;
        for (uint16_t i = 0; i < scene.object_count; i++) {
            glint_material *const m = &materials[i];
            objects[i] = scene.objects[i];
            *m = *objects[i].material;
            objects[i].material = m;
            if (m->texture == NULL) {
                continue;
            }
            const bool through = (with & THROUGH) != 0 && (scene.object_count == 1 || i == 1); /* one, so one order */
            m->emission.g_q14 = 2000;
            m->mirror.b_q14 = with & MIRROR ? 6000 : 0;
            m->sides = with & SIDES ? GLINT_TWO_SIDED : GLINT_FRONT_SIDE;
            m->transmission_q14 = through ? 7000 : 0;
            m->grazing.r_q14 = through && (with & GRAZING) != 0 ? 9000 : 0;
            m->wire_width_q4 = with & WIRE ? 24 : 0;
            m->wire.r_q14 = 15000;
        }
        scene.objects = objects;
        scene.environment = demo_scene_named("chrome")->scene->environment;
        if (with & FOG) {
            scene.fog = (glint_fog){.begin_q16 = 3 << 16, .end_q16 = 9 << 15, .colour = {9000, 9000, 12000}};
        }
        scene.sky.b_q14 = with & SKY ? 5000 : 0;
        const demo_scene changed = {names[n % 2], "", &scene, 160, 120};
        for (int k = 0; k < 3; k++) {
            match(&changed, shadings[k], PLAIN_CODES, 1);
        }
    }
}

/* Model files, through the importer. */
static void test_imported_models_within_one_code(void **state)
{
    (void)state;
    static const char *const paths[] = {
        "tests/models/cube.obj", "tests/models/no-normals.obj", "tests/models/rough.obj",    "tests/models/corner.gltf",
        "tests/models/tile.dae", "tests/models/textured.obj",   "tests/models/textured.gltf"};
#ifndef GLINT_HAVE_ASSIMP
    skip();
#endif
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) {
        imported_scene *imported = NULL;
        char error[300];
        if (import_scene(paths[i], &imported, error, sizeof error) != 0) {
            fail_msg("%s: %s", paths[i], error);
        }
        const demo_scene model = {paths[i], "", imported_scene_view(imported), 200, 150};
        match(&model, GLINT_SHADING_EXACT, PLAIN_CODES, CONTESTED_SHARE);
        imported_scene_free(imported);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_exact_within_one_code),
        cmocka_unit_test(test_gouraud_within_one_code),
        cmocka_unit_test(test_flat_within_one_code),
        cmocka_unit_test(test_turned_scenes_within_one_code),
        cmocka_unit_test(test_clipped_scenes_within_one_code),
        cmocka_unit_test(test_imported_models_within_one_code),
        cmocka_unit_test(test_textures_among_effects_within_one_code),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
