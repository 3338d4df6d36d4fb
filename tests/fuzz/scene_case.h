/* SPDX-License-Identifier: MIT */
/*
 * A fuzzer's bytes as a scene, a display and a piece of memory: valid ones, with extreme values among them, and invalid
 * ones. Also what is known of their validity from the headers alone.
 *
 * Arrays of a mesh are allocated to the byte, so that AddressSanitizer sees a read past them. Frames are small, since a
 * fuzzer lives of the number of its trials: 64 x 64 px at most, but now and then up to 2048 in one dimension.
 */
#ifndef GLINT_TESTS_FUZZ_SCENE_CASE_H
#define GLINT_TESTS_FUZZ_SCENE_CASE_H

#include <math.h>
#include <string.h>

#include <glint/glint.h>

#include "tests/fuzz/bytes.h"

enum { CASE_MESHES = 3, CASE_OBJECTS = 4, CASE_LIGHTS = 5, CASE_VERTICES = 24, CASE_TRIANGLES = 40 };

/* What the headers say of the arguments; EITHER within rounding of a limit on angles or determinants. */
typedef enum validity { INVALID, EITHER, VALID } validity;

typedef struct scene_case {
    glint_camera camera;
    glint_mesh meshes[CASE_MESHES];
    glint_material materials[CASE_MESHES];
    glint_object objects[CASE_OBJECTS];
    glint_light lights[CASE_LIGHTS];
    glint_texture textures[CASE_MESHES];
    glint_environment environment;
    glint_scene scene;
    glint_display display; /* flush and context are for the one who draws */
    glint_quality quality;
    uint8_t mesh_count;
    bool wild;
    /* pointers that are NULL in the call, as bits */
    enum { NULL_SCENE = 1, NULL_DISPLAY = 2, NULL_QUALITY = 4, NULL_MEMORY = 8, NULL_FLUSH = 16 } null;
    /* of each mesh three arrays; then those of scene_effects.h: of each texture two, texture coordinates of each mesh,
     * the environment */
    void *allocated[6 * CASE_MESHES + 1];
} scene_case;

static inline int16_t take_colour(bytes *b, int16_t most, bool wild)
{
    const int32_t value = take_any_size(b, most, wild);
    return (int16_t)(wild || value >= 0 ? value : -value);
}

static inline glint_colour take_rgb(bytes *b, int16_t most, bool wild)
{
    const int16_t r = take_colour(b, most, wild), g = take_colour(b, most, wild);
    const glint_colour colour = {r, g, take_colour(b, most, wild)};
    return colour;
}

static inline void *allocate(scene_case *c, int slot, size_t bytes_wanted)
{
    c->allocated[slot] = malloc(bytes_wanted);
    FUZZ_CHECK(c->allocated[slot] != NULL, "out of memory");
    return c->allocated[slot];
}

static inline void take_mesh(bytes *b, scene_case *c, int number)
{
    static const int16_t ends[] = {INT16_MIN, INT16_MAX, 0, 1, -1, INT16_MIN + 1, 256, -256};
    glint_mesh *mesh = &c->meshes[number];
    const int32_t vertices = take_between(b, 3, CASE_VERTICES),
                  triangles = take_between(b, 1, take_rarely(b, 4) ? CASE_TRIANGLES : 12);
    const uint8_t kind = take_u8(b);
    int16_t(*positions)[3] = allocate(c, 3 * number, (size_t)vertices * sizeof *positions);
    int16_t(*normals)[3] = allocate(c, 3 * number + 1, (size_t)vertices * sizeof *normals);
    uint16_t(*indices)[3] = allocate(c, 3 * number + 2, (size_t)triangles * sizeof *indices);
    for (int32_t v = 0; v < vertices; v++) {
        for (int k = 0; k < 3; k++) {
            const int16_t small = (int16_t)take_between(b, -128, 127);
            positions[v][k] = (kind & 3) == 0   ? (int16_t)(small * 256)
                              : (kind & 3) == 1 ? (int16_t)(small * 256 + take_between(b, 0, 255))
                              : (kind & 3) == 2 ? small
                                                : ends[small & 7];
            const int16_t n = (int16_t)take_between(b, -128, 127);
            normals[v][k] = (kind & 12) == 0 ? (int16_t)(n * 128) : (kind & 12) == 4 ? 0 : (int16_t)(n * 256 + small);
        }
        if ((kind & 12) == 8) { /* of unit length, as importers write them */
            const double x = normals[v][0], y = normals[v][1], z = normals[v][2], length = sqrt(x * x + y * y + z * z);
            for (int k = 0; k < 3 && length > 0; k++) {
                normals[v][k] = (int16_t)lrint(16384 * normals[v][k] / length);
            }
        }
    }
    for (int32_t t = 0; t < triangles; t++) {
        for (int k = 0; k < 3; k++) {
            indices[t][k] = (uint16_t)take_between(b, 0, vertices - 1);
        }
    }
    if (c->wild && take_rarely(b, 16)) {
        indices[take_between(b, 0, triangles - 1)][take_between(b, 0, 2)] =
            (uint16_t)(take_rarely(b, 2) ? vertices : 65535);
    }
    mesh->positions = (const int16_t(*)[3])positions;
    mesh->normals_q14 = (const int16_t(*)[3])normals;
    mesh->triangles = (const uint16_t(*)[3])indices;
    mesh->vertex_count = (uint16_t)vertices;
    mesh->triangle_count = (uint16_t)triangles;
    mesh->fraction_bits = (int8_t)(kind & 16 ? take_between(b, 0, 24) : take_between(b, 12, 16));
}

static inline void take_material(bytes *b, scene_case *c, glint_material *material)
{
    material->ambient = take_rgb(b, 16384, c->wild);
    material->diffuse = take_rgb(b, 16384, c->wild);
    material->specular = take_rgb(b, 16384, c->wild);
    material->exponent_q4 = (uint16_t)take_between(b, 0, c->wild ? 16385 : 16384);
    material->specular_model = (uint8_t)take_between(b, 0, c->wild ? 2 : 1);
}

static inline glint_place take_place(bytes *b, bool wild)
{
    glint_place place = {{{0}}, {0}};
    const uint8_t kind = take_u8(b);
    const uint16_t turn = take_u16(b);
    if ((kind & 7) > 1) { /* 0 and 1: the identity */
        place = kind & 8 ? glint_turn_y(turn) : glint_turn_x(turn);
    }
    if ((kind & 7) == 3 || (kind & 7) == 4) { /* scaled, mirrored, flattened */
        const int32_t x = take_any_size(b, (int32_t)1 << 26, false), y = take_any_size(b, (int32_t)1 << 26, false);
        const glint_place scale = glint_scale(x, kind & 16 ? x : y, take_any_size(b, (int32_t)1 << 26, false));
        place = glint_then(&scale, &place);
    }
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3 && (kind & 7) >= 5; k++) {
            place.linear_q16[i][k] = (kind & 7) == 5   ? take_between(b, -32768, 32767) * 4
                                     : (kind & 7) == 6 ? take_any_size(b, (int32_t)1 << 26, wild)
                                                       : place.linear_q16[i][k] >> (i * 5);
        }
        place.origin_q16[i] =
            (kind & 0xe0) == 0xe0 ? take_any_size(b, (int32_t)1 << 30, wild) : take_between(b, -128, 127) * 512;
    }
    return place;
}

static inline void take_camera(bytes *b, scene_case *c)
{
    const uint8_t kind = take_u8(b), distance = take_u8(b);
    for (int k = 0; k < 3; k++) {
        c->camera.eye_q16[k] = kind & 3 ? take_between(b, -128, 127) * 4096 : take_any_size(b, 1 << 30, c->wild);
        c->camera.target_q16[k] = kind & 12 ? take_between(b, -128, 127) * 512 : take_any_size(b, 1 << 30, c->wild);
        c->camera.up[k] = kind & 48 ? 0 : take_s16(b);
    }
    c->camera.field_of_view_turn16 =
        (uint16_t)(kind & 64 ? take_between(b, c->wild ? 181 : 182, c->wild ? 30948 : 30947) : 8192);
    if ((distance & 7) == 0) {
        const int32_t near_q16 = take_any_size(b, 1 << 30, c->wild);
        c->camera.near_q16 = c->wild || near_q16 >= 64 ? near_q16 : 64 + (near_q16 & 0xffff);
    } else { /* in front of most of what there is */
        c->camera.near_q16 = 64 << (distance >> 3 & 7);
    }
}

static inline void take_light(bytes *b, scene_case *c, glint_light *light)
{
    const uint8_t kind = take_u8(b);
    light->kind = (uint8_t)(c->wild && kind == 255 ? GLINT_BALL + 1 : kind & 1);
    for (int k = 0; k < 3; k++) {
        light->direction[k] = (int16_t)(kind & 2 ? take_s16(b) : take_between(b, -2, 2));
        light->position_q16[k] = kind & 4 ? take_any_size(b, 1 << 30, c->wild) : take_between(b, -128, 127) * 2048;
    }
    if (!c->wild && light->direction[0] == 0 && light->direction[1] == 0) {
        light->direction[2] = (int16_t)(light->direction[2] | 1);
    }
    light->colour = take_rgb(b, INT16_MAX, c->wild);
}

static inline void take_display(bytes *b, scene_case *c, int32_t triangles)
{
    glint_display *d = &c->display;
    const uint8_t kind = take_u8(b);
    /* pixels times triangles are what a trial costs */
    const int32_t most = triangles > 12 ? 24 : triangles > 4 ? 40 : 64;
    d->width_px = (uint16_t)take_between(b, 1, most);
    d->height_px = (uint16_t)take_between(b, 1, most);
    if (kind >= 248) {
        uint16_t *side = kind & 1 ? &d->width_px : &d->height_px, *other = kind & 1 ? &d->height_px : &d->width_px;
        *side = (uint16_t)take_between(b, c->wild ? 0 : 1, c->wild ? 2049 : 2048);
        *other = (uint16_t)(*other % 4 + 1);
    }
    d->format = (uint8_t)take_between(b, 0, c->wild ? 6 : 5);
    d->dither = (uint8_t)take_between(b, 0, c->wild ? 2 : 1);
    d->buffer_count = (uint8_t)take_between(b, 0, c->wild ? 3 : 2);
    d->band_px = (uint16_t)(kind & 2 ? take_between(b, 0, d->height_px) : take_between(b, 0, 65535));
    if (d->format == GLINT_MONO_PAGES && !c->wild) {
        d->band_px = (uint16_t)(d->band_px & ~7);
    }
    d->stride_bytes = 0;
    if (kind & 4) {
        const int32_t row = (int32_t)glint_row_bytes(d->format, d->width_px);
        d->stride_bytes = (uint32_t)(row + take_between(b, c->wild && row > 1 ? -1 : 0, 9));
    }
}

static inline void scene_case_take(bytes *b, scene_case *c)
{
    memset(c, 0, sizeof *c);
    c->wild = take_rarely(b, 8);
    int32_t triangles = 0;
    c->mesh_count = (uint8_t)take_between(b, 1, CASE_MESHES);
    for (int i = 0; i < c->mesh_count; i++) {
        take_mesh(b, c, i);
        take_material(b, c, &c->materials[i]);
    }
    c->scene.object_count = (uint16_t)(take_rarely(b, 16) ? 0 : take_between(b, 1, CASE_OBJECTS));
    for (uint16_t i = 0; i < c->scene.object_count; i++) {
        const glint_mesh *mesh = &c->meshes[take_between(b, 0, c->mesh_count - 1)];
        if (triangles + mesh->triangle_count > CASE_TRIANGLES) {
            c->scene.object_count = i;
            break;
        }
        triangles += mesh->triangle_count;
        c->objects[i].mesh = mesh;
        c->objects[i].material = &c->materials[take_between(b, 0, c->mesh_count - 1)];
        c->objects[i].place = take_place(b, c->wild);
    }
    c->scene.light_count = (uint16_t)take_between(b, 0, CASE_LIGHTS);
    for (uint16_t i = 0; i < c->scene.light_count; i++) {
        take_light(b, c, &c->lights[i]);
    }
    take_camera(b, c);
    take_display(b, c, triangles);
    c->quality.shading = (uint8_t)take_between(b, 0, c->wild ? 3 : 2);
    c->scene.ambient = take_rgb(b, INT16_MAX, c->wild);
    c->scene.background = take_rgb(b, 16384, c->wild);
    c->scene.camera = &c->camera;
    c->scene.objects = c->objects;
    c->scene.lights = c->lights;
}

/*
 * The quality of a second drawing of the same scene: within a tolerance, or by a tier asked for by name; one in sixteen
 * is any two bytes, which are seldom valid. Taken after all else, so that what inputs from before it mean stays.
 */
static inline glint_quality take_quality(bytes *b)
{
    glint_quality quality = {.shading = GLINT_SHADING_EXACT};
    const uint8_t kind = take_u8(b);
    if (kind < 160) {
        quality.tolerance = (uint8_t)take_between(b, GLINT_LEAST_TOLERANCE, kind < 80 ? 64 : 255);
    } else if (kind < 240) {
        quality.shading = kind & 1 ? GLINT_SHADING_Q1 : GLINT_SHADING_Q2;
    } else {
        quality.shading = (uint8_t)(kind & 2 ? take_u8(b) : take_between(b, 0, 5));
        quality.tolerance = (uint8_t)(kind & 1 ? take_u8(b) : take_between(b, 0, 2 * GLINT_LEAST_TOLERANCE));
    }
    return quality;
}

/*
 * What makes a scene one that cheap shading serves, which random ones hardly are: lights that are directional and not
 * bright, of one colour or not; normals of a mesh that are of unit length and differ little, by 2^-spread.
 */
typedef struct taming {
    bool lights, grey, normals;
    uint8_t spread;
    int16_t middle[3];
} taming;

static inline taming take_taming(bytes *b)
{
    const uint8_t kind = take_u8(b);
    taming t = {.lights = (kind & 7) != 0, .grey = kind & 8, .normals = (kind & 48) != 0, .spread = kind >> 6};
    for (int k = 0; k < 3; k++) {
        t.middle[k] = (int16_t)take_between(b, -128, 127);
    }
    t.spread = (uint8_t)(2 + 2 * t.spread);
    return t;
}

static inline void scene_case_tame(scene_case *c, const taming *t)
{
    for (int i = 0; t->lights && i < CASE_LIGHTS; i++) {
        glint_light *light = &c->lights[i];
        light->kind = light->kind == GLINT_POINT ? GLINT_DIRECTIONAL : light->kind;
        light->direction[2] = (int16_t)(light->direction[2] | 1);
        light->colour.r_q14 /= 4;
        light->colour.g_q14 = t->grey ? light->colour.r_q14 : (int16_t)(light->colour.g_q14 / 4);
        light->colour.b_q14 = t->grey ? light->colour.r_q14 : (int16_t)(light->colour.b_q14 / 4);
    }
    for (int i = 0; t->normals && i < c->mesh_count; i++) {
        int16_t(*normals)[3] = c->allocated[3 * i + 1];
        for (uint16_t v = 0; v < c->meshes[i].vertex_count; v++) {
            double n[3], square = 0;
            for (int k = 0; k < 3; k++) {
                n[k] = 128.0 * t->middle[k] + ldexp(normals[v][k], -t->spread);
                square += n[k] * n[k];
            }
            for (int k = 0; k < 3 && square > 0; k++) {
                normals[v][k] = (int16_t)lrint(16384 * n[k] / sqrt(square));
            }
        }
    }
}

static inline void scene_case_free(scene_case *c)
{
    for (size_t i = 0; i < sizeof c->allocated / sizeof *c->allocated; i++) {
        free(c->allocated[i]);
    }
}

#endif
