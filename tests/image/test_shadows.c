/* SPDX-License-Identifier: MIT */
/*
 * Shadows against the reference, which casts rays: random scenes of up to eight lights and three objects that lie in
 * and through each other, both backends, exact and within a tolerance.
 *
 * Asserted of a frame: a plain pixel lies within what its frame promised, and a contested one within that of a
 * candidate. A light on the wrong side of a shadow's edge would be so only within a pixel of the edge
 * (REFERENCE_SHADOW), where both are candidates: so there is no acne, no gap between an object and its shadow, and no
 * light between the triangles of a shadow.
 *
 * GLINT_SEED=N takes other scenes; GLINT_SCENE=N draws only number N of them.
 */
#include "tests/image/frame.h"

#include <stdio.h>

#include "examples/scenes/scenes.h"
#include "tests/image/test_tolerance_worlds.h"
#include "tests/reference/reference.h"

#define DEFAULT_SEED 20261127u
#define RANDOM_SCENES 80

static unsigned long number_from(const char *name, unsigned long otherwise)
{
    const char *given = getenv(name);
    return given && *given ? strtoul(given, NULL, 0) : otherwise;
}

typedef struct tally {
    unsigned frames, unpromised;
    unsigned long pixels, contested, shadow_pixels, tests;
    double worst; /* of error over promise */
} tally;

static bool check_frame(tally *t, const char *name, const reference_image *image, const glint_scene *scene,
                        uint16_t width_px, uint16_t height_px, int backend, uint8_t tolerance)
{
    frame f = {.display = {.width_px = width_px, .height_px = height_px}, .tolerance = tolerance};
    reference_verdict v;
    assert_int_equal(frame_draw(&f, scene, backend), 0);
    t->frames++;
    t->tests += f.report.shadow_tests;
    if (f.report.promise_q8 == UINT16_MAX) {
        t->unpromised++;
        frame_free(&f);
        return true;
    }
    /* where no triangle is seen, the background is rounded to a code */
    const double promise = fmax(f.report.promise_q8 / 256.0, 0.5);
    reference_check(image, f.pixels, promise, &v);
    frame_free(&f);
    t->pixels += v.pixels;
    t->contested += v.contested;
    t->shadow_pixels += v.contested_shadow;
    t->worst = fmax(t->worst, v.max_codes / promise);
    if (v.max_codes <= promise && v.unmatched == 0) {
        return true;
    }
    printf("%s, %s, tolerance %d: %.3f codes at (%d, %d), promised %.3f; %u unmatched, first (%d, %d)\n", name,
           frame_backend_name[backend], tolerance, v.max_codes, v.worst_x, v.worst_y, promise, (unsigned)v.unmatched,
           v.unmatched_x, v.unmatched_y);
    return false;
}

static bool check_scene(tally *t, const char *name, const glint_scene *scene, uint16_t width_px, uint16_t height_px)
{
    reference_image image;
    char error[200];
    bool good = true;
    if (reference_render(scene, width_px, height_px, GLINT_SHADING_EXACT, &image, error, sizeof error) != 0) {
        fail_msg("%s: %s", name, error);
    }
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        good = check_frame(t, name, &image, scene, width_px, height_px, backend, 0) && good;
        good = check_frame(t, name, &image, scene, width_px, height_px, backend, GLINT_CODES(2)) && good;
    }
    reference_free(&image);
    return good;
}

static void report(const tally *t)
{
    print_message("%u frames (%u without a promise), %lu pixels, %lu contested, %lu of them at a shadow's edge; %lu "
                  "shadows of triangles; worst error %.3f of the promise\n",
                  t->frames, t->unpromised, t->pixels, t->contested, t->shadow_pixels, t->tests, t->worst);
}

static void test_random_scenes(void **state)
{
    static world w;
    tally t = {.frames = 0};
    unsigned bad = 0;
    (void)state;
    const uint32_t seed = (uint32_t)number_from("GLINT_SEED", DEFAULT_SEED);
    const uint32_t only = (uint32_t)number_from("GLINT_SCENE", UINT32_MAX);
    print_message("GLINT_SEED=%u, %d scenes\n", (unsigned)seed, RANDOM_SCENES);
    for (uint32_t i = only == UINT32_MAX ? 0 : only; i < (only == UINT32_MAX ? RANDOM_SCENES : only + 1); i++) {
        char name[64];
        (void)snprintf(name, sizeof name, "GLINT_SEED=%u GLINT_SCENE=%u", (unsigned)seed, (unsigned)i);
        make_world(&w, seed, i);
        for (uint16_t k = 0; k < w.scene.light_count; k++) {
            w.lights[k].casts_shadows = !one_in(&w, 4) && w.lights[k].kind < GLINT_PANEL;
        }
        for (uint16_t k = 0; k < w.scene.object_count; k++) {
            w.materials[k].shadows = (uint8_t)(one_in(&w, 6) ? between(&w, 1, 3) : 0);
        }
        w.width_px = (uint16_t)(w.width_px / 2);
        w.height_px = (uint16_t)(w.height_px / 2);
        bad += !check_scene(&t, name, &w.scene, w.width_px, w.height_px);
    }
    report(&t);
    assert_int_equal(bad, 0);
    assert_true(only != UINT32_MAX || t.tests > 10000);
}

/* The built-in scenes that have shadows from many sides, and from near. */
static void test_turned_and_near(void **state)
{
    static const char *const names[] = {"shadows-sun", "shadows-lamps"};
    tally t = {.frames = 0};
    unsigned bad = 0;
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const demo_scene *demo = demo_scene_named(names[i]);
        assert_non_null(demo);
        for (unsigned turn = 0; turn < 6; turn++) {
            glint_object objects[16];
            glint_scene scene;
            char name[64];
            glint_camera camera = *demo->scene->camera;
            (void)snprintf(name, sizeof name, "%s, turn %u", names[i], turn);
            assert_int_equal(demo_scene_turn(demo->scene, (uint16_t)(2000 + 10001 * turn), objects, &scene), 0);
            for (int k = 0; k < 3; k++) {
                camera.eye_q16[k] += (camera.target_q16[k] - camera.eye_q16[k]) / 8 * (int32_t)turn;
            }
            camera.near_q16 = (int32_t)1 << 14;
            scene.camera = &camera;
            bad += !check_scene(&t, name, &scene, 100, 75);
        }
    }
    report(&t);
    assert_int_equal(bad, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_scenes),
        cmocka_unit_test(test_turned_and_near),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
