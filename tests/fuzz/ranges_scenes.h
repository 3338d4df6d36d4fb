/* SPDX-License-Identifier: MIT */
/*
 * Scenes that drive quantities to the ends of their ranges: every input at the ends of what validation lets pass, the
 * camera aimed so that something of the object is in view, or is cut, or all but fills the guard band.
 */
#ifndef GLINT_TESTS_FUZZ_RANGES_SCENES_H
#define GLINT_TESTS_FUZZ_RANGES_SCENES_H

#include "tests/fuzz/scene_case.h"

enum { EXTREME_VERTICES = 12, EXTREME_TRIANGLES = 10, EXTREME_LIGHTS = 4 };

static const uint16_t white_texels[8 * 8] = {0xffff, 0, 0xffff, 0, 0xffff, 0, 0xffff, 0, 0xffff};
static const glint_environment white_environment = {.texels = white_texels, .side = 8};

#define FARTHEST_Q16 ((int32_t)1 << 30)
#define LARGEST_Q16 ((int32_t)1 << 26)
#define NEAREST_Q16 64

typedef struct extreme_scene {
    int16_t positions[EXTREME_VERTICES][3], normals[EXTREME_VERTICES][3], texcoords[EXTREME_VERTICES][2];
    uint16_t triangles[EXTREME_TRIANGLES][3];
    glint_mesh mesh;
    glint_material material;
    glint_texture texture;
    glint_camera camera;
    glint_light lights[EXTREME_LIGHTS];
    glint_object object;
    glint_scene scene;
    glint_display display; /* flush and context are for the one who draws */
    uint8_t way;           /* of drawing, see extreme_ways */
} extreme_scene;

/* Ways of drawing: each shading by name, and the least tolerance, a common and a wide one. */
static const glint_quality extreme_ways[] = {
    {GLINT_SHADING_EXACT, 0},
    {GLINT_SHADING_GOURAUD, 0},
    {GLINT_SHADING_FLAT, 0},
    {GLINT_SHADING_Q1, 0},
    {GLINT_SHADING_Q2, 0},
    {GLINT_SHADING_EXACT, GLINT_LEAST_TOLERANCE},
    {GLINT_SHADING_EXACT, GLINT_CODES(1)},
    {GLINT_SHADING_EXACT, GLINT_CODES(4)},
};

enum { EXTREME_WAYS = sizeof extreme_ways / sizeof *extreme_ways };

#define ONE_OF(bytes, list) ((list)[take_between(bytes, 0, (int32_t)(sizeof(list) / sizeof *(list)) - 1)])

static inline int32_t clamp_q16(double value, int32_t least, int32_t greatest)
{
    return value < least ? least : value > greatest ? greatest : (int32_t)lrint(value);
}

static inline int32_t take_far(bytes *b)
{
    static const int32_t ends[] = {0, FARTHEST_Q16, -FARTHEST_Q16, FARTHEST_Q16 - 1, 1 - FARTHEST_Q16, 1, -1, 65536};
    return take_rarely(b, 3) ? take_any_size(b, FARTHEST_Q16, false) : ONE_OF(b, ends);
}

/* A number from 0 to 1. */
static inline double take_share(bytes *b)
{
    return take_u16(b) / 65535.0;
}

/* The camera, and the unit vector along its view. */
static inline void take_extreme_camera(bytes *b, extreme_scene *e, double forward[3])
{
    static const int32_t reaches[] = {1, 3, 65536, FARTHEST_Q16, INT32_MAX};
    static const uint16_t fields[] = {182, 183, 8192, 16384, 30946, 30947};
    const int32_t reach = ONE_OF(b, reaches);
    const uint8_t kind = take_u8(b);
    double length = 0;
    for (int k = 0; k < 3; k++) {
        const int32_t way = kind & 1 ? take_between(b, -1, 1) * 1024 : take_between(b, -1024, 1024);
        e->camera.eye_q16[k] = take_far(b);
        e->camera.target_q16[k] =
            clamp_q16(e->camera.eye_q16[k] + (double)reach * way / 1024, -FARTHEST_Q16, FARTHEST_Q16);
        e->camera.up[k] = (int16_t)(kind & 6 ? 0 : take_s16(b));
        forward[k] = (double)e->camera.target_q16[k] - e->camera.eye_q16[k];
        length += forward[k] * forward[k];
    }
    for (int k = 0; k < 3 && length > 0; k++) {
        forward[k] /= sqrt(length);
    }
    e->camera.field_of_view_turn16 = ONE_OF(b, fields);
}

/* A linear part of about this size, its singular values as far apart as validation allows. */
static inline void take_extreme_linear(bytes *b, double size_q16, int32_t linear_q16[3][3])
{
    static const int8_t even[3][3] = {{1, 1, 1}, {1, -1, 1}, {-1, 1, 1}}; /* |row| = sqrt(3) */
    const uint8_t kind = take_u8(b), turned = take_u8(b);
    double stretch[3] = {1, 1, 1};
    if (kind & 1) {
        stretch[turned % 3] = exp2(-take_between(b, 0, 23));
    } else if (kind & 2) {
        stretch[0] = stretch[1] = stretch[2] = exp2(-take_between(b, 0, 11));
        stretch[turned % 3] = 1;
    }
    const glint_place turn =
        turned & 64 ? glint_turn_x((uint16_t)(turned * 1021)) : glint_turn_y((uint16_t)(turned * 1021));
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            const double entry = (kind & 12) == 0   ? i == k
                                 : (kind & 12) == 4 ? even[i][k]
                                 : (kind & 12) == 8 ? turn.linear_q16[i][k] / 65536.0
                                                    : take_between(b, -128, 127) / 127.0;
            linear_q16[i][k] = clamp_q16(size_q16 * entry * stretch[kind & 16 ? i : k], -LARGEST_Q16, LARGEST_Q16);
        }
    }
}

static inline void take_extreme_mesh(bytes *b, extreme_scene *e)
{
    static const int16_t ends[] = {INT16_MIN, INT16_MAX, 0, 1, -1, INT16_MIN + 1, 16384, -16384};
    static const int16_t normals[] = {INT16_MIN, INT16_MAX, 0, 16384, 16387, -16387, 9459, 9460, -9460, 11585, 1};
    const uint8_t kind = take_u8(b);
    for (int v = 0; v < EXTREME_VERTICES; v++) {
        double length = 0;
        for (int k = 0; k < 3; k++) {
            e->positions[v][k] = kind & 1 ? ONE_OF(b, ends) : take_s16(b);
            e->normals[v][k] = kind & 2 ? ONE_OF(b, normals) : take_s16(b);
            length += (double)e->normals[v][k] * e->normals[v][k];
        }
        for (int k = 0; k < 3 && kind & 4 && length > 0; k++) {
            e->normals[v][k] = (int16_t)lrint(16384 / sqrt(length) * e->normals[v][k]);
        }
    }
    for (int t = 0; t < EXTREME_TRIANGLES; t++) {
        for (int k = 0; k < 3; k++) {
            e->triangles[t][k] = (uint16_t)take_between(b, 0, EXTREME_VERTICES - 1);
        }
    }
    e->mesh.positions = (const int16_t(*)[3])e->positions;
    e->mesh.normals_q14 = (const int16_t(*)[3])e->normals;
    e->mesh.triangles = (const uint16_t(*)[3])e->triangles;
    e->mesh.vertex_count = EXTREME_VERTICES;
    e->mesh.triangle_count = EXTREME_TRIANGLES;
    e->mesh.fraction_bits = (int8_t)(kind & 8 ? take_between(b, 0, 24) : kind & 16 ? 24 : 0);
}

/* In the eye, in a vertex, beside one, at the object's origin, or far away. */
static inline void take_extreme_light(bytes *b, const extreme_scene *e, glint_light *light)
{
    static const int16_t ends[] = {INT16_MIN, INT16_MAX, 1, -1, 0, 0};
    const uint8_t kind = take_u8(b);
    const int vertex = take_between(b, 0, EXTREME_VERTICES - 1);
    light->kind = kind & 1 ? GLINT_POINT : GLINT_DIRECTIONAL;
    for (int k = 0; k < 3; k++) {
        double at = e->object.place.origin_q16[k];
        for (int i = 0; i < 3 && kind & 6; i++) {
            at += exp2(-e->mesh.fraction_bits) * e->object.place.linear_q16[k][i] * e->positions[vertex][i];
        }
        at = (kind & 6) == 6 ? take_far(b) : (kind & 24) == 24 ? e->camera.eye_q16[k] : at;
        light->position_q16[k] =
            clamp_q16(at + (kind & 32 ? take_any_size(b, 65536, false) : 0), -FARTHEST_Q16, FARTHEST_Q16);
        light->direction[k] = (int16_t)(kind & 2 ? ONE_OF(b, ends) : take_s16(b));
    }
    if (light->direction[0] == 0 && light->direction[1] == 0 && light->direction[2] == 0) {
        light->direction[kind % 3] = INT16_MIN;
    }
    if (kind & 1 && kind & 128) { /* as far as it may reach, or a point nearly */
        int32_t room = FARTHEST_Q16;
        for (int k = 0; k < 3; k++) {
            const int32_t beside = FARTHEST_Q16 - abs(light->position_q16[k]);
            room = beside < room ? beside : room;
            light->edge_q16[0][k] = kind & 4 ? beside / 2 : -(beside % 3);
            light->edge_q16[1][k] = kind & 16 ? -(beside / 2) : beside % 5;
        }
        light->kind = kind & 8 ? GLINT_BALL : GLINT_PANEL;
        light->radius_q16 = kind & 4 ? room : room % 70000;
        light->samples = kind & 2 ? GLINT_MAX_SAMPLES : 0;
    }
    light->colour = kind & 64 ? take_rgb(b, INT16_MAX, false) : (glint_colour){INT16_MAX, INT16_MAX, INT16_MAX};
}

static inline void take_extreme_display(bytes *b, extreme_scene *e)
{
    static const uint16_t sizes[] = {1, 2, 7, 24, 33, 40};
    const uint8_t kind = take_u8(b);
    e->display.width_px = ONE_OF(b, sizes);
    e->display.height_px = ONE_OF(b, sizes);
    if (kind >= 240) {
        *(kind & 1 ? &e->display.width_px : &e->display.height_px) = GLINT_MAX_SIZE_PX;
        *(kind & 1 ? &e->display.height_px : &e->display.width_px) = (uint16_t)(1 + (kind & 3));
    }
    e->display.format = (uint8_t)take_between(b, GLINT_RGB888, GLINT_MONO_PAGES);
    e->display.dither = kind & 4 ? GLINT_DITHER_BAYER : GLINT_DITHER_NONE;
    e->display.band_px = kind & 8 ? 8 : 0;
}

/* Points into itself, so it is not copied. Returns how far the object is. */
static inline double take_extreme_scene(bytes *b, extreme_scene *e)
{
    static const uint16_t exponents[] = {0, 1, 15, 16, 160, 16383, 16384};
    double forward[3];
    memset(e, 0, sizeof *e);
    take_extreme_camera(b, e, forward);
    take_extreme_mesh(b, e);
    take_extreme_display(b, e);
    /* the object's extent as a share of its distance, from more than all to less than a pixel */
    const double distance_q16 = fabs((double)take_any_size(b, FARTHEST_Q16, false)) * 2 * take_share(b),
                 extent_q16 =
                     distance_q16 * exp2(take_rarely(b, 4) ? take_between(b, -40, -8) : take_between(b, -8, 4));
    const uint8_t kind = take_u8(b);
    for (int k = 0; k < 3; k++) {
        const double beside = kind & 3 ? 0 : (take_share(b) - 0.5) * distance_q16;
        e->object.place.origin_q16[k] =
            clamp_q16(e->camera.eye_q16[k] + forward[k] * distance_q16 + beside, -FARTHEST_Q16, FARTHEST_Q16);
    }
    take_extreme_linear(b, extent_q16 * exp2(e->mesh.fraction_bits - 15), e->object.place.linear_q16);
    const double near_q16 = kind & 4    ? NEAREST_Q16
                            : kind & 8  ? distance_q16 + take_between(b, -2, 2)
                            : kind & 16 ? distance_q16 * take_share(b)
                                        : FARTHEST_Q16;
    e->camera.near_q16 = clamp_q16(near_q16, NEAREST_Q16, FARTHEST_Q16);
    e->material.ambient = e->material.diffuse = e->material.specular = (glint_colour){16384, 16384, 16384};
    e->material.exponent_q4 = ONE_OF(b, exponents);
    e->material.mirror = e->material.exponent_q4 & 16 ? e->material.ambient : (glint_colour){0, 0, 0};
    e->scene.environment = &white_environment;
    e->material.specular_model = (uint8_t)take_between(b, GLINT_PHONG, GLINT_BLINN);
    for (int i = 0; i < EXTREME_LIGHTS; i++) {
        take_extreme_light(b, e, &e->lights[i]);
    }
    e->object.mesh = &e->mesh;
    e->object.material = &e->material;
    e->scene.camera = &e->camera;
    e->scene.objects = &e->object;
    e->scene.object_count = 1;
    e->scene.lights = e->lights;
    e->scene.light_count = EXTREME_LIGHTS;
    e->scene.ambient = (glint_colour){INT16_MAX, 0, 16384};
    e->scene.background = (glint_colour){16384, 0, 8192};
    e->way = (uint8_t)take_between(b, 0, EXTREME_WAYS - 1);
    return distance_q16;
}

#endif
