/* SPDX-License-Identifier: MIT */
/*
 * What the tests of the importer share: paths, a sound scene, equal scenes. The tests run in the project's top folder;
 * what they write is under $GLINT_BUILD/test-import.
 */
#ifndef GLINT_TESTS_UNIT_IMPORT_CHECKS_H
#define GLINT_TESTS_UNIT_IMPORT_CHECKS_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "tools/import/import.h"

#define MODELS "tests/models/"

static char folder[512];

static inline const char *setting(const char *name, const char *missing)
{
    const char *value = getenv(name);
    return value && *value ? value : missing;
}

/* A path in the test's folder; four may be in use at once. */
static inline const char *scratch(const char *name)
{
    static char paths[4][1024];
    static unsigned turn;
    char *path = paths[turn++ % 4];
    snprintf(path, sizeof paths[0], "%s/%s", folder, name);
    return path;
}

static inline int make_folder(void **state)
{
    (void)state;
    snprintf(folder, sizeof folder, "%s/test-import", setting("GLINT_BUILD", "build"));
    mkdir(setting("GLINT_BUILD", "build"), 0777);
    mkdir(folder, 0777);
    struct stat status;
    return stat(folder, &status) == 0 && S_ISDIR(status.st_mode) ? 0 : -1;
}

static inline imported_scene *import_or_fail(const char *path)
{
    imported_scene *scene;
    char error[1024];
    if (import_scene(path, &scene, error, sizeof error)) {
        fail_msg("%s", error);
    }
    return scene;
}

static inline void world_point(const glint_object *object, unsigned vertex, double result[3])
{
    for (int i = 0; i < 3; i++) {
        result[i] = object->place.origin_q16[i] / 65536.0;
        for (int k = 0; k < 3; k++) {
            result[i] += object->place.linear_q16[i][k] / 65536.0 *
                         ldexp(object->mesh->positions[vertex][k], -object->mesh->fraction_bits);
        }
    }
}

static inline bool warned(const imported_scene *scene, const char *text)
{
    for (size_t i = 0; i < imported_scene_warning_count(scene); i++) {
        if (strstr(imported_scene_warning(scene, i), text)) {
            return true;
        }
    }
    return false;
}

static inline void assert_colour(const glint_colour *colour, int r, int g, int b)
{
    assert_int_equal(colour->r_q14, r);
    assert_int_equal(colour->g_q14, g);
    assert_int_equal(colour->b_q14, b);
}

static inline void assert_int32s(const int32_t value[3], int32_t x, int32_t y, int32_t z)
{
    assert_int_equal(value[0], x);
    assert_int_equal(value[1], y);
    assert_int_equal(value[2], z);
}

static inline void assert_direction(const int16_t value[3], int x, int y, int z)
{
    assert_int_equal(value[0], x);
    assert_int_equal(value[1], y);
    assert_int_equal(value[2], z);
}

/* What arrives of a light in a distance, in Q14, by the formula of <glint/scene.h>. */
static inline void assert_arrives(const glint_light *light, double distance, double r, double g, double b)
{
    const glint_attenuation *a = &light->attenuation;
    const double t = distance / (a->unit_q16 ? a->unit_q16 / 65536.0 : 1);
    const double quotient = 16384 / fmax(16384, a->k_q14[0] + a->k_q14[1] * t + a->k_q14[2] * t * t);
    assert_true(fabs(light->colour.r_q14 * quotient - r) <= 1);
    assert_true(fabs(light->colour.g_q14 * quotient - g) <= 1);
    assert_true(fabs(light->colour.b_q14 * quotient - b) <= 1);
}

/* What holds for every import: valid indices, normals of unit length, formats in range, the view in front of the near
 * plane when the camera was placed by the importer. */
static inline void assert_sound(const glint_scene *scene)
{
    assert_true(scene->object_count > 0);
    for (unsigned o = 0; o < scene->object_count; o++) {
        const glint_mesh *mesh = scene->objects[o].mesh;
        assert_in_range(mesh->fraction_bits, 0, GLINT_MAX_FRACTION_BITS);
        for (unsigned t = 0; t < mesh->triangle_count; t++) {
            for (int k = 0; k < 3; k++) {
                assert_true(mesh->triangles[t][k] < mesh->vertex_count);
            }
        }
        for (unsigned v = 0; v < mesh->vertex_count; v++) {
            const int16_t *n = mesh->normals_q14[v];
            double length = sqrt((double)n[0] * n[0] + (double)n[1] * n[1] + (double)n[2] * n[2]);
            assert_true(length <= 0 || fabs(length - 16384) <= 0.867); /* sqrt(3) / 2: rounding of three entries */
        }
        for (int i = 0; i < 3; i++) {
            assert_true(abs(scene->objects[o].place.origin_q16[i]) <= 1 << 30);
            for (int k = 0; k < 3; k++) {
                assert_true(abs(scene->objects[o].place.linear_q16[i][k]) <= 1 << 26);
            }
        }
    }
    assert_true(scene->camera->near_q16 >= 64);
    assert_in_range(scene->camera->field_of_view_turn16, 182, 30947);
}

/* Every vertex is in front of the near plane, and within a square picture. */
static inline void assert_framed(const glint_scene *scene)
{
    double forward[3], length = 0;
    for (int k = 0; k < 3; k++) {
        forward[k] = (scene->camera->target_q16[k] - (double)scene->camera->eye_q16[k]) / 65536;
        length += forward[k] * forward[k];
    }
    double limit = tan(scene->camera->field_of_view_turn16 * 3.14159265358979 / 65536);
    for (unsigned o = 0; o < scene->object_count; o++) {
        for (unsigned v = 0; v < scene->objects[o].mesh->vertex_count; v++) {
            double point[3], depth = 0, square = 0;
            world_point(&scene->objects[o], v, point);
            for (int k = 0; k < 3; k++) {
                double away = point[k] - scene->camera->eye_q16[k] / 65536.0;
                depth += away * forward[k] / sqrt(length);
                square += away * away;
            }
            assert_true(depth > scene->camera->near_q16 / 65536.0);
            assert_true(sqrt(fmax(0, square - depth * depth)) / depth <= limit);
        }
    }
}

static inline void assert_same_texture(const glint_texture *a, const glint_texture *b)
{
    assert_int_equal(a == NULL, b == NULL);
    if (a) {
        const size_t texels = (size_t)a->width_px * a->height_px;
        assert_int_equal(a->width_px, b->width_px);
        assert_int_equal(a->height_px, b->height_px);
        assert_int_equal(a->format, b->format);
        assert_int_equal(a->filter, b->filter);
        assert_int_equal(a->wrap_u, b->wrap_u);
        assert_int_equal(a->wrap_v, b->wrap_v);
        assert_int_equal(a->palette_count, b->palette_count);
        assert_memory_equal(a->texels, b->texels, texels * (a->format == GLINT_TEXTURE_RGB565 ? 2 : 1));
        if (a->palette_count > 0) {
            assert_memory_equal(a->palette, b->palette, a->palette_count * sizeof *a->palette);
        }
    }
}

/* All but pointers, by value. */
static inline void assert_same_scene(const glint_scene *a, const glint_scene *b)
{
    assert_int_equal(a->object_count, b->object_count);
    assert_int_equal(a->light_count, b->light_count);
    assert_memory_equal(&a->ambient, &b->ambient, sizeof a->ambient);
    assert_memory_equal(&a->background, &b->background, sizeof a->background);
    assert_memory_equal(a->camera->eye_q16, b->camera->eye_q16, sizeof a->camera->eye_q16);
    assert_memory_equal(a->camera->target_q16, b->camera->target_q16, sizeof a->camera->target_q16);
    assert_memory_equal(a->camera->up, b->camera->up, sizeof a->camera->up);
    assert_int_equal(a->camera->field_of_view_turn16, b->camera->field_of_view_turn16);
    assert_int_equal(a->camera->near_q16, b->camera->near_q16);
    for (unsigned i = 0; i < a->light_count; i++) {
        const glint_light *x = &a->lights[i], *y = &b->lights[i];
        assert_int_equal(x->kind, y->kind);
        assert_memory_equal(x->direction, y->direction, sizeof x->direction);
        assert_memory_equal(x->position_q16, y->position_q16, sizeof x->position_q16);
        assert_memory_equal(&x->colour, &y->colour, sizeof x->colour);
        assert_memory_equal(x->attenuation.k_q14, y->attenuation.k_q14, sizeof x->attenuation.k_q14);
        assert_int_equal(x->attenuation.unit_q16, y->attenuation.unit_q16);
        assert_int_equal(x->attenuation.range_q16, y->attenuation.range_q16);
        assert_int_equal(x->inner_turn16, y->inner_turn16);
        assert_int_equal(x->outer_turn16, y->outer_turn16);
    }
    for (unsigned i = 0; i < a->object_count; i++) {
        const glint_object *x = &a->objects[i], *y = &b->objects[i];
        assert_memory_equal(&x->place, &y->place, sizeof x->place);
        assert_int_equal(x->material->exponent_q4, y->material->exponent_q4);
        assert_int_equal(x->material->specular_model, y->material->specular_model);
        assert_int_equal(x->material->sides, y->material->sides);
        assert_int_equal(x->material->transmission_q14, y->material->transmission_q14);
        assert_memory_equal(&x->material->emission, &y->material->emission, sizeof x->material->emission);
        assert_memory_equal(&x->material->ambient, &y->material->ambient, 3 * sizeof x->material->ambient);
        assert_int_equal(x->mesh->vertex_count, y->mesh->vertex_count);
        assert_int_equal(x->mesh->triangle_count, y->mesh->triangle_count);
        assert_int_equal(x->mesh->fraction_bits, y->mesh->fraction_bits);
        assert_memory_equal(x->mesh->positions, y->mesh->positions, x->mesh->vertex_count * sizeof *x->mesh->positions);
        assert_memory_equal(x->mesh->normals_q14, y->mesh->normals_q14,
                            x->mesh->vertex_count * sizeof *x->mesh->normals_q14);
        assert_memory_equal(x->mesh->triangles, y->mesh->triangles,
                            x->mesh->triangle_count * sizeof *x->mesh->triangles);
        assert_same_texture(x->material->texture, y->material->texture);
        assert_int_equal(x->mesh->texcoords == NULL, y->mesh->texcoords == NULL);
        if (x->mesh->texcoords) {
            assert_int_equal(x->mesh->texcoord_bits, y->mesh->texcoord_bits);
            assert_memory_equal(x->mesh->texcoords, y->mesh->texcoords,
                                x->mesh->vertex_count * sizeof *x->mesh->texcoords);
        }
    }
}

static inline FILE *create(const char *path)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    return file;
}

#endif
