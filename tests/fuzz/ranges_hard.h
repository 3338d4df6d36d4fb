/* SPDX-License-Identifier: MIT */
/*
 * Scenes made for one quantity each, which scenes at random do not drive to its end: light summed over as many lights
 * as there may be, the last number of a triangle, normals as long as still pass for unit length, a needle far away,
 * triangles as large as the guard band on the largest display, depths that fall from 1 to nothing within a few pixels,
 * smooth surfaces that the cheap tiers of shading serve.
 *
 * The eye is at the origin and looks along z. Triangles are given by where they are to appear on the screen.
 */
#ifndef GLINT_TESTS_FUZZ_RANGES_HARD_H
#define GLINT_TESTS_FUZZ_RANGES_HARD_H

#include "tests/fuzz/ranges_effects.h"

#define MOST_TRIANGLES 65534 /* of a scene whose triangles are sorted into bands */
#define HARD_OBJECTS 2
#define HARD_KINDS 10

static const glint_colour brightest = {INT16_MAX, INT16_MAX, INT16_MAX}, all_of_it = {16384, 16384, 16384};

static inline void hard_begin(extreme_scene *e, uint16_t width_px, uint16_t height_px, uint16_t field_turn16)
{
    memset(e, 0, sizeof *e);
    e->camera.target_q16[2] = 65536;
    e->camera.field_of_view_turn16 = field_turn16;
    e->camera.near_q16 = 65536;
    e->mesh.positions = (const int16_t(*)[3])e->positions;
    e->mesh.normals_q14 = (const int16_t(*)[3])e->normals;
    e->mesh.triangles = (const uint16_t(*)[3])e->triangles;
    e->mesh.vertex_count = EXTREME_VERTICES;
    e->mesh.triangle_count = EXTREME_TRIANGLES;
    e->material.ambient = e->material.diffuse = e->material.specular = all_of_it;
    e->material.exponent_q4 = 16;
    e->lights[0].kind = GLINT_DIRECTIONAL;
    e->lights[0].direction[2] = 1;
    e->lights[0].colour = brightest;
    e->object.mesh = &e->mesh;
    e->object.material = &e->material;
    e->scene.camera = &e->camera;
    e->scene.objects = &e->object;
    e->scene.object_count = 1;
    e->scene.lights = e->lights;
    e->scene.light_count = 1;
    e->scene.ambient = brightest;
    e->display.width_px = width_px;
    e->display.height_px = height_px;
    e->display.format = GLINT_RGB565;
    for (int v = 0; v < EXTREME_VERTICES; v++) {
        e->normals[v][2] = -16384;
    }
    /* each three vertices from both sides */
    for (int t = 0; t < EXTREME_TRIANGLES; t++) {
        const int first = t / 2 * 3 % EXTREME_VERTICES;
        e->triangles[t][0] = (uint16_t)first;
        e->triangles[t][1] = (uint16_t)(first + 1 + t % 2);
        e->triangles[t][2] = (uint16_t)(first + 2 - t % 2);
    }
}

/* Puts a vertex at a depth (in units of the mesh) so that it appears this far from the display's centre. */
static inline void hard_vertex(extreme_scene *e, int vertex, double x_px, double y_px, double depth)
{
    const double focal_px = e->display.height_px / 2.0 / tan(e->camera.field_of_view_turn16 * 3.14159265 / 65536);
    const double v[3] = {x_px * depth / focal_px, y_px * depth / focal_px, depth};
    for (int k = 0; k < 3; k++) {
        e->positions[vertex][k] = (int16_t)clamp_q16(v[k], INT16_MIN, INT16_MAX);
    }
}

/* A triangle that fills the display, at this depth; all others lie in one point. */
static inline void hard_fill(extreme_scene *e, double depth)
{
    const double size = e->display.width_px + e->display.height_px;
    for (int v = 0; v < EXTREME_VERTICES; v++) {
        hard_vertex(e, v, 0, 0, depth);
    }
    hard_vertex(e, 0, -size, -size, depth);
    hard_vertex(e, 1, 3 * size, -size, depth);
    hard_vertex(e, 2, -size, 3 * size, depth);
}

/* Every light that there may be, as bright as may be, along a normal that rounding makes too long. */
static inline void hard_lights(extreme_scene *e)
{
    static glint_light lights[GLINT_MAX_LIGHTS];
    hard_begin(e, 2, 2, 8192);
    hard_fill(e, 64);
    for (int v = 0; v < EXTREME_VERTICES; v++) {
        for (int k = 0; k < 3; k++) {
            e->normals[v][k] = -9459;
        }
    }
    for (int i = 0; i < GLINT_MAX_LIGHTS; i++) {
        lights[i].kind = GLINT_DIRECTIONAL;
        for (int k = 0; k < 3; k++) {
            lights[i].direction[k] = 1;
        }
        lights[i].colour = brightest;
    }
    e->material.exponent_q4 = 0;
    e->scene.lights = lights;
    e->scene.light_count = GLINT_MAX_LIGHTS;
}

/* The last triangle that a list can hold, drawn. */
static inline void hard_triangles(extreme_scene *e, int which)
{
    static uint16_t triangles[MOST_TRIANGLES / HARD_OBJECTS][3];
    static glint_object objects[HARD_OBJECTS];
    hard_begin(e, 4, 4, 8192);
    hard_fill(e, 64);
    e->display.band_px = 2; /* without bands there is no list */
    for (int t = 0; t < MOST_TRIANGLES / HARD_OBJECTS; t++) {
        memcpy(triangles[t], e->triangles[which], sizeof triangles[t]); /* of one side and the other, one faces away */
    }
    e->mesh.triangles = (const uint16_t(*)[3])triangles;
    e->mesh.triangle_count = MOST_TRIANGLES / HARD_OBJECTS;
    for (int i = 0; i < HARD_OBJECTS; i++) {
        objects[i] = e->object;
    }
    e->scene.objects = objects;
    e->scene.object_count = HARD_OBJECTS;
    e->scene.light_count = 0;
}

/* Normals of more than length 1 by as much as might pass for rounding, at any depth. */
static inline void hard_normals(bytes *b, extreme_scene *e)
{
    hard_begin(e, 8, 8, 8192);
    for (int v = 0; v < EXTREME_VERTICES; v++) {
        const int16_t length = (int16_t)(16384 + take_between(b, -3, 3));
        hard_vertex(e, v, (take_share(b) - 0.5) * 16, (take_share(b) - 0.5) * 16, take_between(b, 2, 9999));
        e->normals[v][v % 3] = take_rarely(b, 2) ? length : (int16_t)-length;
        e->normals[v][2] = (int16_t)(v % 3 == 2 ? e->normals[v][2] : 0);
    }
}

/* A needle that the near plane cuts, so far away that its width is nothing beside the distance. */
static inline void hard_needle(extreme_scene *e, int which)
{
    hard_begin(e, 1, 1, 30947);
    e->object.place.origin_q16[2] = e->camera.near_q16 = FARTHEST_Q16;
    for (int k = 0; k < 3; k++) {
        e->object.place.linear_q16[k][k] = k < 2 ? (int32_t)2 << which / 2 : (int32_t)1 << 13;
    }
    if (which & 1) {
        e->object.place.linear_q16[0][0] = e->object.place.linear_q16[1][1] = (int32_t)1 << 13;
    }
    e->mesh.fraction_bits = 24;
    for (int v = 0; v < EXTREME_VERTICES; v++) {
        for (int k = 0; k < 3; k++) {
            e->positions[v][k] = (v * 5 + k * 3 + v * k) & 2 ? INT16_MAX : -INT16_MAX;
        }
    }
}

/* A point light as far as its position may be, over a surface whose inverse depth is just below a power of two. */
static inline void hard_far_light(extreme_scene *e, int which)
{
    hard_begin(e, 4, 4, 8192);
    hard_fill(e, 4080 + which % 16);
    e->camera.near_q16 = ((int32_t)1 << (23 + which / 16)) + 1; /* its inverse has the greatest mantissa */
    e->lights[0].kind = GLINT_POINT;
    e->lights[0].position_q16[which & 1] = which & 2 ? -FARTHEST_Q16 : FARTHEST_Q16 - 1;
    e->lights[0].position_q16[2] = which & 4 ? -FARTHEST_Q16 : 0;
}

/* Thin triangles through the guard band, from end to end. */
static inline void hard_guard(bytes *b, extreme_scene *e, uint16_t width_px, uint16_t height_px)
{
    hard_begin(e, width_px, height_px, 16384);
    e->mesh.fraction_bits = 4;
    e->way = GLINT_SHADING_FLAT;
    for (int v = 0; v < EXTREME_VERTICES; v++) {
        const double end = 1439.5, x = take_u8(b) & 1 ? end : -end, y = take_u8(b) & 1 ? end : -end;
        if (v % 3 == 1) { /* beside the first */
            memcpy(e->positions[v], e->positions[v - 1], sizeof e->positions[v]);
            e->positions[v][0] = (int16_t)(e->positions[v][0] + take_between(b, -9, 9));
        } else {
            hard_vertex(e, v, x, y, 4096 + take_u16(b) % 4096);
        }
    }
}

/* Small triangles whose depth falls steeply. */
static inline void hard_steep(bytes *b, extreme_scene *e)
{
    static const uint16_t sizes[] = {3, 8, 40};
    const uint8_t kind = take_u8(b);
    const uint16_t size = ONE_OF(b, sizes);
    hard_begin(e, size, size, kind & 1 ? 8192 : 30947);
    e->camera.near_q16 = kind & 2 ? 65536 : 65536 * 16;
    e->mesh.fraction_bits = (int8_t)(kind & 4 ? 0 : 2);
    e->way = (uint8_t)(kind % EXTREME_WAYS);
    const double near = e->camera.near_q16 / 65536.0 * exp2(e->mesh.fraction_bits);
    const double most = exp2(take_share(b) * 14);
    for (int v = 0; v < EXTREME_VERTICES; v++) {
        hard_vertex(e, v, (take_share(b) - 0.5) * size, (take_share(b) - 0.5) * size,
                    kind & 8 && v % 3 == 0 ? near + 1 : near * (1 + most * take_share(b)));
        for (int k = 0; k < 3; k++) {
            e->normals[v][k] = take_s16(b);
        }
    }
}

static inline void hard_colour(bytes *b, glint_colour *colour, int32_t most_q14)
{
    const uint8_t kind = take_u8(b);
    colour->r_q14 = (int16_t)(kind & 1 ? most_q14 : take_between(b, 0, most_q14));
    colour->g_q14 = kind & 6 ? colour->r_q14 : (int16_t)take_between(b, 0, most_q14);
    colour->b_q14 = kind & 6 ? colour->r_q14 : (int16_t)take_between(b, 0, most_q14);
}

/* Corner normals that differ by little to a right angle, under directional lights, from any depth to another: what the
 * tiers between one colour and exact are for. Triangles from a pixel to far beyond the display. */
static inline void hard_smooth(bytes *b, extreme_scene *e)
{
    static const uint16_t sizes[] = {3, 8, 12, 16, 24, 24, 33, 64}, exponents[] = {0, 1, 16, 80, 160, 640, 4000, 16384};
    static const int16_t intensities[] = {INT16_MAX, 16384, 1200, 90}; /* a dim light lets a tier err by more of it */
    const uint16_t size = ONE_OF(b, sizes);
    hard_begin(e, size, size, take_rarely(b, 4) ? 30947 : 8192);
    e->way = (uint8_t)take_between(b, 0, EXTREME_WAYS - 1);
    e->mesh.fraction_bits = 2;
    hard_colour(b, &e->material.diffuse, 16384);
    hard_colour(b, &e->material.specular, 16384);
    e->material.exponent_q4 = ONE_OF(b, exponents);
    e->material.specular_model = (uint8_t)take_between(b, GLINT_PHONG, GLINT_BLINN);
    e->scene.ambient = (glint_colour){1638, 1638, 1638};
    e->scene.light_count = (uint16_t)take_between(b, 1, EXTREME_LIGHTS);
    for (int i = 0; i < e->scene.light_count; i++) {
        glint_light *light = &e->lights[i];
        const bool from_eye = take_rarely(b, 3); /* where the highlight is seen */
        light->kind = GLINT_DIRECTIONAL;
        hard_colour(b, &light->colour, ONE_OF(b, intensities));
        for (int k = 0; k < 3; k++) {
            light->direction[k] = (int16_t)(take_between(b, -99, 99) + (k < 2 ? 0 : from_eye ? 999 : 1));
        }
    }
    const double reach = size * exp2(take_between(b, -5, 3)), bend = exp2(-take_share(b) * 10),
                 depths = exp2(take_share(b) * 6) - 1;
    const double base[3] = {take_share(b) - 0.5, take_share(b) - 0.5, -0.3 - take_share(b)};
    for (int v = 0; v < EXTREME_VERTICES; v++) {
        double n[3], length = 0;
        hard_vertex(e, v, (take_share(b) - 0.5) * reach, (take_share(b) - 0.5) * reach,
                    200 * (1 + depths * take_share(b)));
        for (int k = 0; k < 3; k++) {
            n[k] = base[k] + bend * (take_share(b) - 0.5);
            length += n[k] * n[k];
        }
        for (int k = 0; k < 3 && length > 0; k++) {
            e->normals[v][k] = (int16_t)lrint(16384 / sqrt(length) * n[k]);
        }
    }
}

/* A corner that faces a light so dim that the cheapest tier's cosine may be off by a sixth: 1/|N| is that of a normal
 * between corners that are turned away as far as a tier serves, which takes the cosine beyond 1. */
static inline void hard_dim(extreme_scene *e, int which)
{
    const double turn = 0.7 + 0.07 * (which % 8);
    hard_begin(e, 16, 16, 8192);
    hard_fill(e, 64);
    hard_vertex(e, 0, 0, 0, 64);
    e->way = EXTREME_WAYS - 1;
    for (int v = 0; v < EXTREME_VERTICES; v++) {
        if (v % 3 != 0) {
            e->normals[v][v % 3 - 1] = (int16_t)lrint(16384 * sin(turn));
            e->normals[v][2] = (int16_t)-lrint(16384 * cos(turn));
        }
    }
    const int16_t light = (int16_t)(300 + 200 * (which / 8));
    e->lights[0].colour = (glint_colour){light, light, light};
    e->material.specular = e->material.ambient = (glint_colour){0, 0, 0};
}

/* Effects at their ends where something of them is seen: on smooth surfaces, on steep ones, over the guard band. */
static inline void hard_effects(bytes *b, extreme_scene *e, int which)
{
    if (which % 4 == 0) {
        hard_steep(b, e);
    } else if (which % 32 == 1) {
        hard_guard(b, e, 64, 48);
    } else {
        hard_smooth(b, e);
    }
    const double about_q16 = e->positions[0][2] * 65536.0 * exp2(-e->mesh.fraction_bits);
    for (uint16_t i = 0; i < e->scene.light_count; i++) {
        glint_light *light = &e->lights[i];
        if (take_rarely(b, 2)) {
            light->kind = GLINT_POINT;
            for (int k = 0; k < 3; k++) {
                const double beside = about_q16 * exp2(-take_between(b, 0, 16)) * (take_share(b) - 0.5);
                light->position_q16[k] = clamp_q16((k == 2 ? about_q16 : 0) + beside, -FARTHEST_Q16, FARTHEST_Q16);
            }
        }
    }
    take_extreme_effects(b, e, about_q16);
    e->display.band_px = (uint16_t)(which & 1 ? 5 : 0);
}

/* Makes scene number `which` of a kind; false after the kind's last. */
static inline bool hard_scene(bytes *b, extreme_scene *e, unsigned kind, int which)
{
    static const int scenes[HARD_KINDS] = {2, 2, 26, 64, 32, INT32_MAX, INT32_MAX, INT32_MAX, 64, INT32_MAX};
    if (which >= scenes[kind]) {
        return false;
    }
    switch (kind) {
    case 0:
        hard_lights(e);
        if (which == 1) { /* over a texture, too */
            take_extreme_texture(b, e);
        }
        break;
    case 1:
        hard_triangles(e, which);
        break;
    case 2:
        hard_needle(e, which);
        break;
    case 3:
        hard_far_light(e, which);
        break;
    case 4:
        hard_guard(b, e, GLINT_MAX_SIZE_PX, which < 4 ? GLINT_MAX_SIZE_PX : 16);
        break;
    case 5:
        hard_normals(b, e);
        break;
    case 6:
        hard_steep(b, e);
        break;
    case 7:
        hard_smooth(b, e);
        break;
    case 8:
        hard_dim(e, which);
        break;
    default:
        hard_effects(b, e, which);
        break;
    }
    return true;
}

#endif
