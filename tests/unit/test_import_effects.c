/* SPDX-License-Identifier: MIT */
/*
 * The model importer: what files say of light that passes a surface, of insides, and of lamps. Expected numbers are
 * worked out by hand from the files in tests/models and from the table in tools/import/README.md.
 */
#include "tests/unit/import_checks.h"

#include "tests/unit/backends.h"

#ifndef GLINT_HAVE_ASSIMP

static void test_needs_assimp(void **state)
{
    (void)state;
    skip();
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_needs_assimp)};
    return cmocka_run_group_tests(tests, make_folder, NULL);
}

#else

static int ignore_band(void *context, const glint_band *band)
{
    (void)context;
    (void)band;
    return 0;
}

/* Both backends take it. */
static void assert_drawn(const glint_scene *scene)
{
    static const glint_quality quality = {.tolerance = GLINT_CODES(1)};
    const glint_display display = {.width_px = 32, .height_px = 24, .flush = ignore_band};
    for (int i = 0; i < BACKENDS; i++) {
        const size_t bytes = backends[i].memory_bytes(scene, &display);
        void *memory = malloc(bytes);
        assert_non_null(memory);
        assert_int_equal(backends[i].render(scene, &display, &quality, memory, bytes, NULL), GLINT_OK);
        free(memory);
    }
}

static void test_opacity_of_obj(void **state)
{
    (void)state;
    imported_scene *imported = import_or_fail(MODELS "panes.obj");
    const glint_scene *scene = imported_scene_view(imported);
    static const int transmissions[4] = {12288, 4096, 0, 16384}; /* d 0.25, Tr 0.25, d 1.5, d 0 */
    assert_sound(scene);
    assert_int_equal(scene->object_count, 4);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(scene->objects[i].material->transmission_q14, transmissions[i]);
        assert_int_equal(scene->objects[i].material->sides, GLINT_FRONT_SIDE);
    }
    /* (1 - t) is the renderer's for all but the highlight, which is 0.25 (1, 0.5, 0.25) */
    assert_colour(&scene->objects[0].material->diffuse, 8192, 4096, 2048);
    assert_colour(&scene->objects[0].material->specular, 4096, 2048, 1024);
    assert_true(warned(imported, "'overdone': the opacity 1.5 is limited to 0 to 1"));
    assert_true(warned(imported, "'gone': its opacity is 0"));
    assert_false(warned(imported, "'clear'"));
    assert_drawn(scene);
    imported_scene_free(imported);
}

static void test_opacity_and_sides_of_gltf(void **state)
{
    (void)state;
    imported_scene *imported = import_or_fail(MODELS "panes.gltf");
    const glint_scene *scene = imported_scene_view(imported);
    assert_sound(scene);
    assert_int_equal(scene->object_count, 4);
    /* BLEND; OPAQUE and MASK, of which alpha does not count; KHR_materials_transmission */
    static const int transmissions[4] = {12288, 0, 0, 12288}, sides[4] = {GLINT_TWO_SIDED, 0, 0, 0};
    for (int i = 0; i < 4; i++) {
        assert_int_equal(scene->objects[i].material->transmission_q14, transmissions[i]);
        assert_int_equal(scene->objects[i].material->sides, sides[i]);
    }
    /* r_s = 0.04 (30 + 8) / 8 = 0.19, of the first a quarter */
    assert_colour(&scene->objects[0].material->specular, 778, 778, 778);
    assert_colour(&scene->objects[3].material->specular, 3113, 3113, 3113);
    assert_true(warned(imported, "'leaf': its alpha mask is ignored"));
    assert_int_equal(imported_scene_warning_count(imported), 1);
    assert_drawn(scene);
    imported_scene_free(imported);
}

/* The panes' centre is (4.5, 0, 0), their radius sqrt(31.25): the lamp brings 16 / 4^2 there, the torch 4 / 2^2, by
 * which its red is as bright; neither is scaled. */
static void test_lights_of_gltf(void **state)
{
    (void)state;
    imported_scene *imported = import_or_fail(MODELS "panes.gltf");
    const glint_scene *scene = imported_scene_view(imported);
    const glint_light *lamp = &scene->lights[0], *torch = &scene->lights[1];
    assert_int_equal(scene->light_count, 2);
    assert_int_equal(lamp->kind, GLINT_POINT);
    assert_int32s(lamp->position_q16, 294912, 0, 4 << 16);
    assert_int_equal(lamp->attenuation.range_q16, 8 << 16);
    assert_arrives(lamp, 4, 16384, 16384, 16384);
    assert_arrives(lamp, 8, 4096, 4096, 4096); /* but for the window */
    assert_int_equal(torch->kind, GLINT_SPOT);
    assert_direction(torch->direction, 0, 0, -32767);
    assert_int_equal(torch->attenuation.range_q16, 20 << 16);
    assert_int_equal(torch->inner_turn16, 1043); /* 0.1 and 0.5 radians */
    assert_int_equal(torch->outer_turn16, 5215);
    assert_arrives(torch, 4, 4096, 2048, 1024);
    imported_scene_free(imported);
}

static void test_lights_and_opacity_of_collada(void **state)
{
    (void)state;
    imported_scene *imported = import_or_fail(MODELS "lamps.dae");
    const glint_scene *scene = imported_scene_view(imported);
    assert_sound(scene);
    assert_int_equal(scene->light_count, 2);
    const glint_light *lamp = &scene->lights[0], *torch = &scene->lights[1];
    assert_int_equal(lamp->kind, GLINT_POINT);
    assert_int_equal(lamp->attenuation.range_q16, 0);
    for (int d = 0; d <= 6; d += 2) { /* 1 / (1 + d^2 / 4) */
        const double arrives = 16384 / (1 + d * d / 4.0);
        assert_arrives(lamp, d, arrives / 2, arrives / 4, arrives);
    }
    assert_int_equal(torch->kind, GLINT_SPOT);
    assert_direction(torch->direction, 0, -32767, 0);
    for (int d = 2; d <= 8; d += 2) { /* 1 / (1/2 + d / 4) */
        const double arrives = 16384 / (0.5 + d / 4.0);
        assert_arrives(torch, d, arrives, arrives, arrives / 2);
    }
    assert_int_equal(torch->outer_turn16, 5461); /* 30 degrees, where the cone ends: no exponent softens it */
    assert_int_equal(torch->inner_turn16, 5461 - GLINT_LEAST_CONE_TURN16);
    assert_int_equal(scene->objects[0].material->transmission_q14, 12288);
    assert_colour(&scene->objects[0].material->specular, 4096, 2048, 1024);
    assert_int_equal(scene->objects[0].material->sides, GLINT_FRONT_SIDE);
    assert_int_equal(scene->objects[1].material->transmission_q14, 0);
    assert_int_equal(scene->objects[1].material->sides, GLINT_TWO_SIDED);
    assert_int_equal(imported_scene_warning_count(imported), 0);
    assert_drawn(scene);
    imported_scene_free(imported);
}

/* A model with one text put in the place of another; the error, or NULL where it was imported. */
static const char *import_changed(const char *model, const char *from, const char *to, bool *was_warned,
                                  const char *warning)
{
    static char text[65536], error[1024];
    char path[1024];
    FILE *file = fopen(model, "r");
    assert_non_null(file);
    const size_t size = fread(text, 1, sizeof text - 1, file);
    assert_int_equal(fclose(file), 0);
    text[size] = '\0';
    const char *at = strstr(text, from);
    assert_non_null(at);
    snprintf(path, sizeof path, "%s", scratch("changed"));
    snprintf(path + strlen(path), sizeof path - strlen(path), "%s", strrchr(model, '.'));
    file = create(path);
    assert_true(fprintf(file, "%.*s%s%s", (int)(at - text), text, to, at + strlen(from)) > 0);
    assert_int_equal(fclose(file), 0);
    imported_scene *imported;
    if (import_scene(path, &imported, error, sizeof error)) {
        return error;
    }
    *was_warned = warned(imported, warning);
    assert_drawn(imported_scene_view(imported));
    imported_scene_free(imported);
    return NULL;
}

static void test_bad_values(void **state)
{
    (void)state;
    bool was_warned = false;
    const char *error = import_changed(MODELS "panes.gltf", "0.125,\n     0.25", "0.125, 1e39", &was_warned, "");
    assert_non_null(error);
    assert_non_null(strstr(error, "material 'glass': the opacity is not finite; 0 to 1 expected"));
    assert_null(import_changed(MODELS "panes.gltf", "0.125,\n     0.25", "0.125, -0.5", &was_warned,
                               "'glass': the opacity -0.5 is limited to 0 to 1"));
    assert_true(was_warned);
    assert_null(import_changed(MODELS "panes.gltf", "\"transmissionFactor\": 0.75", "\"transmissionFactor\": 3",
                               &was_warned, "'pure': the transmission 3 is limited to 0 to 1"));
    assert_true(was_warned);
    assert_null(import_changed(MODELS "panes.gltf", "\"alphaCutoff\": 0.5", "\"alphaCutoff\": 0.8", &was_warned,
                               "below the cutoff"));
    assert_true(was_warned);
    /* cones turned round, and a cone of more than a half space */
    error = import_changed(MODELS "panes.gltf", "\"outerConeAngle\": 0.5", "\"outerConeAngle\": 0.01", &was_warned, "");
    assert_non_null(error);
    assert_non_null(strstr(error, "InnerCone is larger than"));
    assert_null(import_changed(MODELS "lamps.dae", "<falloff_angle>30", "<falloff_angle>180", &was_warned,
                               "its cone of more than 180 degrees is left out"));
    assert_true(was_warned);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_opacity_of_obj), cmocka_unit_test(test_opacity_and_sides_of_gltf),
        cmocka_unit_test(test_lights_of_gltf), cmocka_unit_test(test_lights_and_opacity_of_collada),
        cmocka_unit_test(test_bad_values),
    };
    return cmocka_run_group_tests(tests, make_folder, NULL);
}

#endif
