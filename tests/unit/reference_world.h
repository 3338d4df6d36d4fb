/* SPDX-License-Identifier: MIT */
/*
 * A small world for the tests of the reference: a square before a camera of 90 degrees, one light, a picture of 64 px.
 */
#ifndef GLINT_TESTS_UNIT_REFERENCE_WORLD_H
#define GLINT_TESTS_UNIT_REFERENCE_WORLD_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "tests/reference/reference.h"

/* Budget, in levels of 0..1: the closed forms and the reference are both in double, on values near 1. */
#define LEVEL_ERROR 1e-11
#define SIZE 64      /* px; with 90 degrees f is 32 px */
#define UNIT_BITS 10 /* model positions in 1/1024 */
#define UNIT (1 << UNIT_BITS)
#define Q16(x) ((int32_t)((x)*65536.0))

/* A square of +-4 in the plane z = 0, outside towards +z, and room for one triangle of a test's own. */
static const int16_t square_positions[4][3] = {
    {-4 * UNIT, -4 * UNIT, 0}, {4 * UNIT, -4 * UNIT, 0}, {4 * UNIT, 4 * UNIT, 0}, {-4 * UNIT, 4 * UNIT, 0}};
static const int16_t square_normals[4][3] = {{0, 0, 16384}, {0, 0, 16384}, {0, 0, 16384}, {0, 0, 16384}};
static const uint16_t square_triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
static const glint_mesh square = {square_positions, square_normals, square_triangles, 4, 2, UNIT_BITS, 0, NULL};
static const uint16_t one_triangle[1][3] = {{0, 1, 2}};

typedef struct world {
    glint_camera camera;
    glint_material material[2];
    glint_light light;
    glint_object object[2];
    glint_scene scene;
    reference_image image;
} world;

/* The eye at (0, 0, 5) looks at the origin; the square, half diffuse; one white light along -z. */
static inline void set_up(world *w)
{
    memset(w, 0, sizeof *w);
    w->camera.eye_q16[2] = Q16(5);
    w->camera.field_of_view_turn16 = 16384;
    w->camera.near_q16 = Q16(0.5);
    w->material[0].diffuse = (glint_colour){8192, 8192, 8192};
    w->material[1].diffuse = (glint_colour){16384, 0, 0};
    w->light.direction[2] = -1;
    w->light.colour = (glint_colour){16384, 16384, 16384};
    for (int i = 0; i < 2; i++) {
        w->object[i].mesh = &square;
        w->object[i].material = &w->material[i];
    }
    w->scene.camera = &w->camera;
    w->scene.objects = w->object;
    w->scene.lights = &w->light;
    w->scene.object_count = 1;
    w->scene.light_count = 1;
    w->scene.background = (glint_colour){0, 0, 4096};
}

static inline void draw(world *w, int shading)
{
    char error[200] = "";
    if (reference_render(&w->scene, SIZE, SIZE, shading, &w->image, error, sizeof error) || !w->image.triangle ||
        !w->image.mask) {
        fail_msg("%s", error);
        abort(); /* fail_msg() does not return, but the compiler is not told */
    }
}

static inline void set_direction(world *w, int x, int y, int z)
{
    w->light.direction[0] = (int16_t)x;
    w->light.direction[1] = (int16_t)y;
    w->light.direction[2] = (int16_t)z;
}

static inline const double *level_at(const world *w, int x, int y)
{
    return &w->image.rgb[(y * SIZE + x) * 3];
}

static inline void expect_level(double actual, double expected)
{
    if (!(fabs(actual - expected) <= LEVEL_ERROR)) {
        fail_msg("level %.15f, expected %.15f", actual, expected);
    }
}

#endif
