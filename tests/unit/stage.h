/* SPDX-License-Identifier: MIT */
/*
 * A stage: single triangles, placed by pixel coordinates in the plane z = 0 that the eye at (0, 0, STAGE_EYE) looks at
 * straight on, each corner with a normal of its own.
 */
#ifndef GLINT_TESTS_UNIT_STAGE_H
#define GLINT_TESTS_UNIT_STAGE_H

#include "tests/image/frame.h"

#include <math.h>

#include "tests/unit/backends.h"

enum { STAGE_TRIANGLES = 32, STAGE_LIGHTS = 4 };

#define STAGE_EYE 2.0
#define STAGE_PI 3.14159265358979323846

typedef struct stage {
    int16_t positions[3 * STAGE_TRIANGLES][3], normals[3 * STAGE_TRIANGLES][3];
    uint16_t triangles[STAGE_TRIANGLES][3];
    glint_mesh mesh;
    glint_camera camera;
    glint_material material;
    glint_light lights[STAGE_LIGHTS];
    glint_object object;
    glint_scene scene;
    uint16_t width_px, height_px;
    double world_per_px; /* in the plane z = 0 */
    double unit;         /* of positions, in the world */
} stage;

/* Pixel coordinates in the plane z = 0, and a normal of any length. */
typedef struct stage_corner {
    double at[3], normal[3];
} stage_corner;

static inline int16_t stage_q14(double value)
{
    return (int16_t)lrint(16384 * value);
}

static inline glint_colour stage_colour(double r, double g, double b)
{
    const glint_colour colour = {stage_q14(r), stage_q14(g), stage_q14(b)};
    return colour;
}

static inline glint_colour stage_grey(double level)
{
    return stage_colour(level, level, level);
}

/* Grey and dull, without lights or triangles; points into itself, so it is not copied. */
static inline void stage_set_up(stage *s, uint16_t width_px, uint16_t height_px, double field_of_view_degrees)
{
    memset(s, 0, sizeof *s);
    s->width_px = width_px;
    s->height_px = height_px;
    const double half = tan(field_of_view_degrees * STAGE_PI / 360);
    s->world_per_px = 2 * half * STAGE_EYE / height_px;
    /* positions reach eight times as far as the display does */
    s->unit = exp2(ceil(log2(8 * s->world_per_px * (width_px > height_px ? width_px : height_px) / 32767)));
    s->mesh.positions = (const int16_t(*)[3])s->positions;
    s->mesh.normals_q14 = (const int16_t(*)[3])s->normals;
    s->mesh.triangles = (const uint16_t(*)[3])s->triangles;
    s->camera.eye_q16[2] = (int32_t)(STAGE_EYE * 65536);
    s->camera.field_of_view_turn16 = (uint16_t)(field_of_view_degrees * 65536 / 360);
    s->camera.near_q16 = 65536;
    s->material.diffuse = stage_grey(0.9);
    s->object.mesh = &s->mesh;
    s->object.material = &s->material;
    for (int k = 0; k < 3; k++) {
        s->object.place.linear_q16[k][k] = (int32_t)lrint(s->unit * 65536 * 16384);
    }
    s->mesh.fraction_bits = 14;
    s->scene.camera = &s->camera;
    s->scene.objects = &s->object;
    s->scene.lights = s->lights;
    s->scene.object_count = 1;
}

static inline void stage_normal(double x, double y, double z, int16_t out_q14[3])
{
    const double length = sqrt(x * x + y * y + z * z);
    out_q14[0] = stage_q14(x / length);
    out_q14[1] = stage_q14(y / length);
    out_q14[2] = stage_q14(z / length);
}

/* Corners in either order: the triangle faces the eye. */
static inline void stage_triangle(stage *s, const stage_corner at[3])
{
    const int number = s->mesh.triangle_count++;
    assert_true(number < STAGE_TRIANGLES);
    const double area = (at[1].at[0] - at[0].at[0]) * (at[2].at[1] - at[0].at[1]) -
                        (at[2].at[0] - at[0].at[0]) * (at[1].at[1] - at[0].at[1]);
    for (int i = 0; i < 3; i++) {
        const double *const n = at[i].normal;
        const int vertex = 3 * number + i;
        s->positions[vertex][0] = (int16_t)lrint((at[i].at[0] - 0.5 * s->width_px) * s->world_per_px / s->unit);
        s->positions[vertex][1] = (int16_t)lrint((0.5 * s->height_px - at[i].at[1]) * s->world_per_px / s->unit);
        s->positions[vertex][2] = (int16_t)lrint(at[i].at[2] / s->unit);
        stage_normal(n[0], n[1], n[2], s->normals[vertex]);
        s->triangles[number][area < 0 ? i : 2 - i] = (uint16_t)vertex;
    }
    s->mesh.vertex_count = (uint16_t)(3 * s->mesh.triangle_count);
}

static inline glint_light *stage_any_light(stage *s, glint_colour colour)
{
    assert_true(s->scene.light_count < STAGE_LIGHTS);
    glint_light *light = &s->lights[s->scene.light_count++];
    light->colour = colour;
    return light;
}

/* Parallel light from this direction. */
static inline void stage_light(stage *s, double x, double y, double z, glint_colour colour)
{
    glint_light *light = stage_any_light(s, colour);
    light->kind = GLINT_DIRECTIONAL;
    stage_normal(-x, -y, -z, light->direction);
}

static inline void stage_point_light(stage *s, double x, double y, double z, glint_colour colour)
{
    glint_light *light = stage_any_light(s, colour);
    light->kind = GLINT_POINT;
    light->position_q16[0] = (int32_t)lrint(x * 65536);
    light->position_q16[1] = (int32_t)lrint(y * 65536);
    light->position_q16[2] = (int32_t)lrint(z * 65536);
}

/* White, in the very place of a vertex. */
static inline void stage_point_light_on(stage *s, int vertex)
{
    const int16_t *const at = s->positions[vertex];
    stage_point_light(s, at[0] * s->unit, at[1] * s->unit, at[2] * s->unit, stage_grey(1));
}

/* A floor below the eye, from 1/500 in front of it to a quarter of a million times as far. */
static inline void stage_floor(stage *s)
{
    static const int16_t place[3][3] = {{-2, -1, 0}, {2, -1, 0}, {0, -1, -32767}};
    memset(s->object.place.linear_q16, 0, sizeof s->object.place.linear_q16);
    s->object.place.linear_q16[0][0] = 64;   /* 1/1024 */
    s->object.place.linear_q16[1][1] = 64;   /* 1/1024 */
    s->object.place.linear_q16[2][2] = 1024; /* 1/64 */
    s->object.place.origin_q16[2] = (int32_t)(STAGE_EYE * 65536) - 128;
    s->camera.near_q16 = 64;
    s->mesh.fraction_bits = 0;
    for (int i = 0; i < 3; i++) {
        memcpy(s->positions[i], place[i], sizeof place[i]);
        stage_normal(0.1 * i, 1, 0.1, s->normals[i]);
        s->triangles[0][i] = (uint16_t)i;
    }
    s->mesh.triangle_count = 1;
    s->mesh.vertex_count = 3;
}

#endif
