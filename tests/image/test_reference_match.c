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
#define CONTESTED_SHARE 0.005 /* of the frame */
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
        printf("%-22s %s %d: max=%.3f mean=%.3f psnr=%.1f differing=%u of %u; contested=%.3f%% shadow=%.3f%% "
               "unmatched=%u\n",
               demo->name, frame_backend_name[backend], shading, verdict.max_codes, verdict.mean_codes, verdict.psnr_db,
               (unsigned)verdict.differing, (unsigned)verdict.pixels, 100 * verdict.contested_share,
               100 * verdict.shadow_share, (unsigned)verdict.unmatched);
        assert_true(verdict.max_codes <= codes);
        assert_true(verdict.above <= PLAIN_ABOVE);
        assert_true(verdict.unmatched <= CONTESTED_UNMATCHED);
        assert_true(verdict.contested_share < share);
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

/* Model files, through the importer. */
static void test_imported_models_within_one_code(void **state)
{
    (void)state;
    static const char *const paths[] = {"tests/models/cube.obj", "tests/models/no-normals.obj",
                                        "tests/models/rough.obj", "tests/models/corner.gltf", "tests/models/tile.dae"};
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
        cmocka_unit_test(test_exact_within_one_code),          cmocka_unit_test(test_gouraud_within_one_code),
        cmocka_unit_test(test_flat_within_one_code),           cmocka_unit_test(test_turned_scenes_within_one_code),
        cmocka_unit_test(test_clipped_scenes_within_one_code), cmocka_unit_test(test_imported_models_within_one_code),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
