/* SPDX-License-Identifier: MIT */
/*
 * The tolerance's tests: the built-in scenes still and turned, hard ones, random ones.
 *
 * GLINT_SEED=N takes other random scenes; the seed is printed. GLINT_SCENE=N draws only number N of them, and prints
 * its figures. GLINT_LONG=1 draws LONG_FACTOR times as many.
 */
#include "tests/image/test_tolerance.h"

#include "examples/scenes/scenes.h"
#include "tests/image/test_tolerance_worlds.h"

#define DEFAULT_SEED 20261122u
#define RANDOM_SCENES 150
#define LONG_FACTOR 20
#define MOST_OBJECTS 64

static unsigned long number_from(const char *name, unsigned long otherwise)
{
    const char *given = getenv(name);
    return given && *given ? strtoul(given, NULL, 0) : otherwise;
}

static void test_built_in_scenes(void **state)
{
    uint32_t breaches = 0;
    (void)state;
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        const demo_scene *demo = &demo_scenes[i];
        breaches += check_scene(demo->name, demo->scene, demo->width_px, demo->height_px, TOLERANCE_BACKEND, true);
    }
    assert_int_equal(breaches, 0);
}

static void test_turned_scenes(void **state)
{
    uint32_t breaches = 0;
    (void)state;
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        const demo_scene *demo = &demo_scenes[i];
        glint_object objects[MOST_OBJECTS];
        glint_scene scene;
        char name[64];
        const uint16_t angle = (uint16_t)(5000 + 13001 * i);
        assert_true(demo->scene->object_count <= MOST_OBJECTS);
        assert_int_equal(demo_scene_turn(demo->scene, angle, objects, &scene), 0);
        (void)snprintf(name, sizeof name, "%s+%u", demo->name, angle);
        breaches += check_scene(name, &scene, demo->width_px / 2, demo->height_px / 2, TOLERANCE_BACKEND, true);
    }
    assert_int_equal(breaches, 0);
    for (int i = 0; i < SETTINGS; i++) { /* of the built-in scenes each pixel has a promise */
        assert_int_equal(total[i].unpromised, 0);
    }
}

/* Two triangles fill the frame: normals from parallel to opposite, seen straight and aslant, highlights of any width in
 * the middle of them, terminators across them, lights behind the surface that face the eye. */
static uint32_t check_boards(int spread, double aslant, int model)
{
    static const int16_t directions[][3] = {{0, 0, -1000},      {-900, 200, -1000}, {1000, 0, -20},
                                            {-1000, 600, -350}, {0, 1000, 0},       {0, 0, 1000}};
    static const uint16_t exponents_q4[] = {0, 16, 16 * 12, 16 * 64, 16 * 512, 16 * 1024};
    uint32_t breaches = 0;
    for (size_t e = 0; e < sizeof exponents_q4 / sizeof *exponents_q4; e++) {
        for (size_t d = 0; d < sizeof directions / sizeof *directions; d++) {
            static world w;
            char name[80];
            make_board(&w, spread, aslant, model, exponents_q4[e], directions[d]);
            (void)snprintf(name, sizeof name, "board spread=%d aslant=%.0f model=%d exponent=%d light=%d", spread,
                           aslant, model, exponents_q4[e] / 16, (int)d);
            breaches += check_scene(name, &w.scene, w.width_px, w.height_px, TOLERANCE_BACKEND, false);
        }
    }
    return breaches;
}

static void test_hard_boards(void **state)
{
    static const int spreads[] = {0, 30, 1000, 5000, 12000, 17000, 30000, INT16_MAX};
    uint32_t breaches = 0;
    (void)state;
    for (size_t i = 0; i < sizeof spreads / sizeof *spreads; i++) {
        for (int model = GLINT_PHONG; model <= GLINT_BLINN; model++) {
            breaches += check_boards(spreads[i], 0, model);
            breaches += check_boards(spreads[i], 10, model);
            breaches += check_boards(spreads[i], 80, model);
        }
    }
    assert_int_equal(breaches, 0);
}

static void test_random_scenes(void **state)
{
    static world w;
    uint32_t breaches = 0, broken = 0;
    (void)state;
    const uint32_t seed = (uint32_t)number_from("GLINT_SEED", DEFAULT_SEED);
    const uint32_t only = (uint32_t)number_from("GLINT_SCENE", UINT32_MAX);
    const uint32_t count = RANDOM_SCENES * (number_from("GLINT_LONG", 0) == 1 ? LONG_FACTOR : 1);
    print_message("GLINT_SEED=%u, %u scenes\n", seed, count);
    for (uint32_t i = only == UINT32_MAX ? 0 : only; i < (only == UINT32_MAX ? count : only + 1); i++) {
        char name[64];
        (void)snprintf(name, sizeof name, "GLINT_SEED=%u GLINT_SCENE=%u", seed, i);
        make_world(&w, seed, i);
        const uint32_t of_scene =
            check_scene(name, &w.scene, w.width_px, w.height_px, TOLERANCE_BACKEND, only != UINT32_MAX);
        breaches += of_scene;
        broken += of_scene > 0;
    }
    print_message("%u random scenes with a broken promise\n", broken);
    assert_int_equal(breaches, 0);
}

static void test_promises_are_not_empty(void **state)
{
    (void)state;
    check_medians();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_built_in_scenes),
        cmocka_unit_test(test_turned_scenes),
        cmocka_unit_test(test_hard_boards),
        cmocka_unit_test(test_random_scenes),
        cmocka_unit_test(test_promises_are_not_empty), /* last: over all that came before */
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
