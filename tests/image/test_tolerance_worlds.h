/* SPDX-License-Identifier: MIT */
/*
 * Random scenes for the tolerance's test: what the bounds reason about is driven to its ends. One to eight lights of
 * any brightness, some that graze, some point lights near a surface; exponents from 1 to 512; triangles large and small
 * on the screen, with corner normals near together and far apart; placed mirrored and unequally stretched; eyes near
 * and far, fields of view from 20 to 120 degrees.
 *
 * Each scene has a generator of its own, seeded with the run's seed and its number, so that it can be drawn alone.
 */
#ifndef GLINT_TESTS_IMAGE_TEST_TOLERANCE_WORLDS_H
#define GLINT_TESTS_IMAGE_TEST_TOLERANCE_WORLDS_H

#include <math.h>
#include <string.h>

#include <glint/glint.h>

#include "examples/meshes/meshes.h"
#include "tests/unit/backends.h"

enum {
    WORLD_OBJECTS = 3,
    WORLD_LIGHTS = 8,
    SHARDS = 6,
    AROUND_TEXELS = 16 * 16,
    WORLD_TEXELS = 40 * 40,
    WORLD_VERTICES = 2048
};

#define Q16 65536.0

typedef struct world {
    glint_camera camera;
    glint_object objects[WORLD_OBJECTS];
    glint_material materials[WORLD_OBJECTS];
    glint_light lights[WORLD_LIGHTS];
    int16_t positions[3 * SHARDS][3], normals[3 * SHARDS][3];
    uint16_t triangles[2 * SHARDS][3], around[AROUND_TEXELS];
    glint_environment environment;
    glint_mesh shards;
    glint_mesh textured[WORLD_OBJECTS]; /* an object's mesh with texture coordinates */
    glint_texture textures[WORLD_OBJECTS];
    int16_t texcoords[WORLD_VERTICES][2];
    uint16_t texels[WORLD_TEXELS];
    glint_scene scene;
    uint16_t width_px, height_px;
    uint64_t random;
} world;

static int32_t between(world *w, int32_t low, int32_t high)
{
    return low + (int32_t)((uint64_t)random_u24(&w->random) * (uint32_t)(high - low + 1) >> 24);
}

static double uniform(world *w, double low, double high)
{
    return low + (high - low) * random_u24(&w->random) / 16777216.0;
}

/* Its logarithm is uniform. */
static double of_any_size(world *w, double low, double high)
{
    return low * pow(high / low, uniform(w, 0, 1));
}

static bool one_in(world *w, int count)
{
    return between(w, 1, count) == 1;
}

static void any_direction(world *w, double v[3])
{
    double square;
    do {
        square = 0;
        for (int k = 0; k < 3; k++) {
            v[k] = uniform(w, -1, 1);
            square += v[k] * v[k];
        }
    } while (square > 1 || square < 0.01);
    for (int k = 0; k < 3; k++) {
        v[k] /= sqrt(square);
    }
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    }
}

static void to_q16(const double v[3], int32_t out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = (int32_t)lrint(v[k] * Q16);
    }
}

static double magnitude_of(const int32_t v[3])
{
    return sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
}

static int16_t q14(double level)
{
    return (int16_t)lrint(16384 * fmin(level, 1.9999));
}

/* Grey, or each channel on its own. */
static glint_colour colour(world *w, double most, bool grey)
{
    const int16_t first = q14(uniform(w, 0, most));
    const glint_colour out = {first, grey ? first : q14(uniform(w, 0, most)), grey ? first : q14(uniform(w, 0, most))};
    return out;
}

static void make_material(world *w, glint_material *m)
{
    m->ambient = colour(w, one_in(w, 4) ? 0.9 : 0.2, one_in(w, 2));
    m->diffuse = colour(w, 1, one_in(w, 2));
    if (!one_in(w, 3)) {
        m->specular = colour(w, of_any_size(w, 0.01, 1), one_in(w, 2));
        if (one_in(w, 4)) { /* tinted as the diffuse light is */
            m->specular.r_q14 = m->diffuse.r_q14 / 2;
            m->specular.g_q14 = m->diffuse.g_q14 / 2;
            m->specular.b_q14 = m->diffuse.b_q14 / 2;
        }
    }
    m->exponent_q4 = (uint16_t)lrint(16 * of_any_size(w, 1, 512));
    m->specular_model = (uint8_t)between(w, GLINT_PHONG, GLINT_BLINN);
}

/* Triangles that share nothing: corners and normals of any kind, both sides shown. */
static void make_shards(world *w)
{
    for (int t = 0; t < SHARDS; t++) {
        double base[3];
        const double size = of_any_size(w, 0.05, 1), spread = of_any_size(w, 0.001, 1.5);
        any_direction(w, base);
        double centre[3];
        for (int k = 0; k < 3; k++) {
            centre[k] = uniform(w, -0.5, 0.5);
        }
        for (int i = 0; i < 3; i++) {
            double off[3], n[3], length = 0;
            any_direction(w, off);
            any_direction(w, n);
            for (int k = 0; k < 3; k++) {
                w->positions[3 * t + i][k] = (int16_t)lrint(16384 * (centre[k] + size * off[k]));
                n[k] = base[k] + spread * n[k];
                length += n[k] * n[k];
            }
            for (int k = 0; k < 3; k++) {
                w->normals[3 * t + i][k] = (int16_t)lrint(16384 * n[k] / sqrt(length));
            }
            w->triangles[2 * t][i] = (uint16_t)(3 * t + i);
            w->triangles[2 * t + 1][i] = (uint16_t)(3 * t + 2 - i);
        }
    }
    w->shards.positions = (const int16_t(*)[3])w->positions;
    w->shards.normals_q14 = (const int16_t(*)[3])w->normals;
    w->shards.triangles = (const uint16_t(*)[3])w->triangles;
    w->shards.vertex_count = 3 * SHARDS;
    w->shards.triangle_count = 2 * SHARDS;
    w->shards.fraction_bits = 14;
}

/* Turned, and every second one stretched or mirrored; about `size` from its middle to its farthest point. */
static glint_place place_at(world *w, const double centre[3], double size)
{
    int32_t scale[3], origin[3];
    const bool stretched = one_in(w, 3), mirrored = one_in(w, 4);
    for (int k = 0; k < 3; k++) {
        scale[k] = (int32_t)lrint(Q16 * size * (stretched ? of_any_size(w, 0.3, 1) : 1));
    }
    const glint_place scaled = glint_scale(mirrored ? -scale[0] : scale[0], scale[1], scale[2]);
    const glint_place x = glint_turn_x((uint16_t)between(w, 0, 65535));
    const glint_place y = glint_turn_y((uint16_t)between(w, 0, 65535));
    const glint_place z = glint_turn_z((uint16_t)between(w, 0, 65535));
    to_q16(centre, origin);
    const glint_place shift = glint_shift(origin[0], origin[1], origin[2]);
    glint_place place = glint_then(&scaled, &x);
    place = glint_then(&place, &y);
    place = glint_then(&place, &z);
    return glint_then(&place, &shift);
}

/* `towards`: from the scene to the eye. */
static void make_light(world *w, glint_light *light, const double towards[3], bool white, bool may_be_near)
{
    static const double levels[] = {0.05, 0.3, 0.8, 1.5};
    double way[3], side[3];
    any_direction(w, side);
    for (int k = 0; k < 3; k++) { /* mostly from before the scene; else from anywhere, so that it grazes */
        way[k] = one_in(w, 3) ? side[k] : side[k] + towards[k];
    }
    if (one_in(w, 6)) {
        cross(towards, side, way);
    }
    light->kind = GLINT_DIRECTIONAL;
    for (int k = 0; k < 3; k++) {
        light->direction[k] = (int16_t)lrint(-12000 * way[k]);
    }
    light->direction[0] = (int16_t)(light->direction[0] | 1); /* not zero */
    if (may_be_near && one_in(w, 2)) {
        light->kind = GLINT_POINT;
        const double distance = of_any_size(w, 1.05, 8);
        for (int k = 0; k < 3; k++) {
            light->position_q16[k] = (int32_t)lrint(Q16 * distance * way[k]);
        }
    }
    light->colour = colour(w, levels[between(w, 0, 3)], white);
    const int dark = between(w, 0, 15); /* now and then two channels, or all three */
    light->colour.r_q14 = dark == 1 || dark == 2 ? 0 : light->colour.r_q14;
    light->colour.g_q14 = dark == 2 || dark == 3 ? 0 : light->colour.g_q14;
    light->colour.b_q14 = dark == 3 || dark == 1 ? 0 : light->colour.b_q14;
    if (dark == 0) {
        light->colour.r_q14 = light->colour.g_q14 = light->colour.b_q14 = 0;
    }
}

/* Lights that do not arrive everywhere alike, and light that comes from no lamp: in one scene of three. */
static void add_effects(world *w, double distance)
{
    if (!one_in(w, 3)) {
        return;
    }
    for (uint16_t i = 0; i < w->scene.light_count; i++) {
        glint_light *light = &w->lights[i];
        const bool far = magnitude_of(light->position_q16) > 16000 * Q16;
        if (one_in(w, 3) && !far) {
            light->kind = light->kind == GLINT_POINT ? GLINT_SPOT : light->kind;
        }
        light->outer_turn16 = (uint16_t)between(w, 182, 16384);
        light->inner_turn16 = (uint16_t)between(w, 0, one_in(w, 2) ? light->outer_turn16 - 182 : 0);
        if (light->kind == GLINT_SPOT) { /* about towards the scene's middle */
            for (int k = 0; k < 3; k++) {
                light->direction[k] = (int16_t)fmax(
                    -32000, fmin(32000, -3000.0 * light->position_q16[k] / Q16 + between(w, -1500, 1500)));
            }
            light->direction[0] = (int16_t)(light->direction[0] | 1);
        }
        for (int k = 0; k < 3 && one_in(w, 2); k++) {
            light->attenuation.k_q14[k] = (uint16_t)of_any_size(w, 100, 65535);
        }
        if (one_in(w, 3)) {
            light->attenuation.unit_q16 = (uint32_t)(Q16 * of_any_size(w, 0.1, 10));
        }
        if (one_in(w, 3)) {
            light->attenuation.range_q16 = (uint32_t)(Q16 * of_any_size(w, 0.5, 4 * distance));
        }
    }
    if (one_in(w, 2)) {
        double up[3];
        any_direction(w, up);
        w->scene.sky = colour(w, 1, one_in(w, 2));
        w->scene.ground = colour(w, 0.5, one_in(w, 2));
        for (int k = 0; k < 3 && one_in(w, 2); k++) {
            w->scene.up[k] = (int16_t)lrint(30000 * up[k]);
        }
    }
    for (int i = 0; i < WORLD_OBJECTS; i++) {
        if (one_in(w, 4)) {
            w->materials[i].emission = colour(w, 0.5, false);
        }
        w->materials[i].sides = (uint8_t)(one_in(w, 2) ? GLINT_FRONT_SIDE : 1 + one_in(w, 2));
    }
    /* one object at most, of convex shape, so that there is one order only */
    const glint_mesh *const mesh = w->objects[0].mesh;
    if (one_in(w, 2) && mesh != &glint_mesh_torus_knot && mesh != &glint_mesh_teapot_small && mesh != &w->shards) {
        w->materials[0].transmission_q14 = (uint16_t)between(w, 1, 16384);
        w->materials[0].grazing = one_in(w, 2) ? colour(w, 0.9, one_in(w, 2)) : w->materials[0].grazing;
    }
    if (one_in(w, 2)) {
        glint_fog *fog = &w->scene.fog;
        fog->colour = colour(w, 0.999, one_in(w, 2));
        fog->begin_q16 = one_in(w, 4) ? 0 : (int32_t)(Q16 * of_any_size(w, 0.1, 2 * distance));
        fog->end_q16 = fog->begin_q16 + (int32_t)(Q16 * of_any_size(w, 0.01, 3 * distance));
    }
}

/* Point lights with an extent, in one scene of four; and a map of random colours, smooth or not, for some surfaces. */
static void add_extents(world *w, double distance)
{
    const bool extended = one_in(w, 4), mirrored = one_in(w, 4), smooth = one_in(w, 2);
    for (uint16_t i = 0; extended && i < w->scene.light_count; i++) {
        glint_light *light = &w->lights[i];
        if (light->kind != GLINT_POINT || magnitude_of(light->position_q16) > 12000 * Q16) {
            continue;
        }
        const double size = distance * of_any_size(w, 0.01, 0.5);
        light->kind = one_in(w, 2) ? GLINT_PANEL : GLINT_BALL;
        light->radius_q16 = (int32_t)(Q16 * fmin(size, 4000));
        light->samples = (uint8_t)(one_in(w, 2) ? GLINT_MAX_SAMPLES : between(w, 0, GLINT_MAX_SAMPLES));
        for (int k = 0; k < 6; k++) {
            light->edge_q16[k / 3][k % 3] = one_in(w, 4) ? 0 : (int32_t)(Q16 * fmin(size, 2000) * uniform(w, -1, 1));
        }
    }
    if (!mirrored) {
        return;
    }
    w->environment.side = (uint8_t)(8 << between(w, 0, 1));
    w->environment.texels = w->around;
    w->environment.steepest = (uint8_t)(smooth ? 66 : 255); /* 8 steps of 31 */
    for (int i = 0; i < AROUND_TEXELS; i++) {
        const uint16_t r = (uint16_t)between(w, 0, smooth ? 8 : 31), g = (uint16_t)between(w, 0, smooth ? 16 : 63),
                       b = (uint16_t)between(w, 0, smooth ? 8 : 31);
        w->around[i] = (uint16_t)(r << 11 | g << 5 | b);
    }
    w->scene.environment = &w->environment;
    for (int i = 0; i < WORLD_OBJECTS; i++) {
        if (one_in(w, 2)) {
            w->materials[i].mirror = colour(w, 1, one_in(w, 2));
        }
    }
}

/* Textures of any kind on some objects, in one scene of four: texture coordinates anywhere within a part of a texture
 * or over several tiles, so that texels come out large and small. */
static void add_textures(world *w)
{
    if (!one_in(w, 4)) {
        return;
    }
    const double spread = of_any_size(w, 0.004, 3);
    for (int v = 0; v < WORLD_VERTICES; v++) {
        for (int k = 0; k < 2; k++) {
            w->texcoords[v][k] = (int16_t)lrint(2048 * uniform(w, -spread, spread));
        }
    }
    const bool strong = one_in(w, 2);
    for (int i = 0; i < WORLD_TEXELS; i++) {
        const int grey = between(w, 0, 15);
        w->texels[i] =
            (uint16_t)(strong ? between(w, 0, 65535) : (grey + 12) << 11 | (2 * grey + 24) << 5 | (grey + 9));
    }
    for (uint16_t i = 0; i < w->scene.object_count; i++) {
        glint_texture *const texture = &w->textures[i];
        if (one_in(w, 3) || w->objects[i].mesh->vertex_count > WORLD_VERTICES) {
            continue;
        }
        texture->texels = w->texels;
        texture->palette = w->texels;
        texture->palette_count = (uint16_t)between(w, 1, 256);
        texture->width_px = (uint16_t)between(w, 1, 40);
        texture->height_px = (uint16_t)between(w, 1, 40);
        texture->format = (uint8_t)between(w, 0, 1);
        texture->filter = (uint8_t)between(w, 0, 1);
        texture->wrap_u = (uint8_t)between(w, 0, 1);
        texture->wrap_v = (uint8_t)between(w, 0, 1);
        w->textured[i] = *w->objects[i].mesh;
        w->textured[i].texcoords = (const int16_t(*)[2])w->texcoords;
        w->textured[i].texcoord_bits = 11;
        w->objects[i].mesh = &w->textured[i];
        w->materials[i].texture = texture;
    }
}

/* Lights that cast shadows, in one scene of four; wires on some surfaces, in one of six. */
static void add_shadows_and_wires(world *w)
{
    const bool shadows = one_in(w, 4), wires = one_in(w, 6);
    for (uint16_t i = 0; shadows && i < w->scene.light_count; i++) {
        w->lights[i].casts_shadows = w->lights[i].kind < GLINT_PANEL && !one_in(w, 4);
    }
    for (int i = 0; i < WORLD_OBJECTS; i++) {
        if (shadows && one_in(w, 4)) {
            w->materials[i].shadows = (uint8_t)between(w, 1, 3);
        }
        if (wires && one_in(w, 2)) {
            w->materials[i].wire = colour(w, 1, false);
            w->materials[i].wire_width_q4 = (uint16_t)between(w, 1, 64);
        }
    }
}

/* Scene `number` of the run. Pointers go into *w, so it must stay where it is. */
static void make_world(world *w, uint32_t seed, uint32_t number)
{
    static const glint_mesh *const meshes[] = {
        &glint_mesh_sphere_10x6, &glint_mesh_sphere_24x12, &glint_mesh_sphere_32x16, &glint_mesh_box,
        &glint_mesh_torus_knot,  &glint_mesh_teapot_small, &glint_mesh_plane};
    static const double extents[] = {1, 1, 1, 1.74, 2, 4, 1.42};
    double towards[3], up[3], eye[3], target[3];
    memset(w, 0, sizeof *w);
    w->random = ((uint64_t)seed << 32) + number;
    (void)random_u24(&w->random);
    w->width_px = (uint16_t)between(w, 64, 160);
    w->height_px = (uint16_t)between(w, 48, 120);
    make_shards(w);

    w->scene.object_count = (uint16_t)between(w, 1, WORLD_OBJECTS);
    for (uint16_t i = 0; i < w->scene.object_count; i++) {
        double centre[3];
        const int kind = between(w, 0, 9);
        glint_object *object = &w->objects[i];
        for (int k = 0; k < 3; k++) {
            centre[k] = i == 0 ? 0 : uniform(w, -1, 1);
        }
        object->mesh = kind < 7 ? meshes[kind] : kind == 7 ? meshes[1] : &w->shards;
        object->material = &w->materials[i];
        object->place = place_at(w, centre, kind < 7 ? 1 / extents[kind] : 1);
        make_material(w, &w->materials[i]);
    }

    /* the first object fills the frame, or stands in it, or is a spot */
    const double field = uniform(w, 20, 120), half = tan(field * acos(-1) / 360);
    const double distance = one_in(w, 3) ? uniform(w, 1.1, 2) : fmax(1.1, of_any_size(w, 0.7, 8) / half);
    any_direction(w, towards);
    do {
        any_direction(w, up);
    } while (fabs(up[0] * towards[0] + up[1] * towards[1] + up[2] * towards[2]) > 0.95);
    for (int k = 0; k < 3; k++) {
        eye[k] = distance * towards[k];
        target[k] = uniform(w, -0.4, 0.4);
        w->camera.up[k] = (int16_t)lrint(32000 * up[k]);
    }
    to_q16(eye, w->camera.eye_q16);
    to_q16(target, w->camera.target_q16);
    w->camera.field_of_view_turn16 = (uint16_t)lrint(field / 360 * 65536);
    w->camera.near_q16 = (int32_t)lrint(Q16 * fmax(0.05, (distance - 1) * 0.5));

    const bool white = one_in(w, 2), points = one_in(w, 5);
    w->scene.light_count = (uint16_t)(one_in(w, 2) ? between(w, 1, 3) : between(w, 1, WORLD_LIGHTS));
    for (uint16_t i = 0; i < w->scene.light_count; i++) {
        make_light(w, &w->lights[i], towards, white, points);
    }
    w->scene.camera = &w->camera;
    w->scene.objects = w->objects;
    w->scene.lights = w->lights;
    w->scene.ambient = colour(w, 1, one_in(w, 2));
    w->scene.background = colour(w, 1, false);
    add_effects(w, distance);
    add_extents(w, distance);
    add_textures(w);
    add_shadows_and_wires(w);
}

/*
 * A square that fills the frame with two triangles, seen by an eye at (0, 0, 5), turned by `aslant` degrees. Normals
 * lean away from the middle by `spread` to 16384, at INT16_MAX in the square's plane. One light along -direction, a
 * weak one beside it.
 */
static inline void make_board(world *w, int spread, double aslant, int model, uint16_t exponent_q4,
                              const int16_t direction[3])
{
    static const int16_t corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    static const uint16_t triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
    static const int16_t beside[3] = {300, -200, -1000};
    const glint_material material = {.ambient = GLINT_RGB(20, 10, 30),
                                     .diffuse = GLINT_RGB(120, 180, 90),
                                     .specular = GLINT_RGB(100, 100, 60),
                                     .exponent_q4 = exponent_q4,
                                     .specular_model = (uint8_t)model};
    const glint_light weak = {.colour = GLINT_RGB(30, 60, 90)}, strong = {.colour = GLINT_WHITE};
    const glint_colour white = GLINT_WHITE;
    memset(w, 0, sizeof *w);
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 2; k++) {
            w->positions[i][k] = (int16_t)(corners[i][k] * 20000);
            w->normals[i][k] = (int16_t)(corners[i][k] * spread);
        }
        w->normals[i][2] = spread == INT16_MAX ? 0 : 16384;
    }
    memcpy(w->triangles, triangles, sizeof triangles);
    w->shards.positions = (const int16_t(*)[3])w->positions;
    w->shards.normals_q14 = (const int16_t(*)[3])w->normals;
    w->shards.triangles = (const uint16_t(*)[3])w->triangles;
    w->shards.vertex_count = 4;
    w->shards.triangle_count = 2;
    w->shards.fraction_bits = 10;
    w->materials[0] = material;
    w->objects[0].mesh = &w->shards;
    w->objects[0].material = &w->materials[0];
    w->objects[0].place = glint_turn_x((uint16_t)(aslant / 360 * 65536));
    w->lights[0] = strong;
    w->lights[1] = weak;
    memcpy(w->lights[0].direction, direction, sizeof w->lights[0].direction);
    memcpy(w->lights[1].direction, beside, sizeof w->lights[1].direction);
    w->camera.eye_q16[2] = (int32_t)(5 * Q16);
    w->camera.field_of_view_turn16 = 16384;
    w->camera.near_q16 = (int32_t)Q16 / 4;
    w->scene.camera = &w->camera;
    w->scene.objects = w->objects;
    w->scene.object_count = 1;
    w->scene.lights = w->lights;
    w->scene.light_count = 2;
    w->scene.ambient = white;
    w->width_px = w->height_px = 33;
}

#endif
