/* SPDX-License-Identifier: MIT */
/*
 * Effects at the ends of what validation lets pass, for the scenes of ranges_scenes.h: distances beside which the scene
 * is nothing or all, cones of a degree and of a right angle, fog as shallow and as deep as may be, textures of one
 * texel and of 1024, shown whole, a thousandth of them or tiled as often as coordinates allow.
 */
#ifndef GLINT_TESTS_FUZZ_RANGES_EFFECTS_H
#define GLINT_TESTS_FUZZ_RANGES_EFFECTS_H

#include "tests/fuzz/ranges_scenes.h"

static inline uint32_t take_extreme_distance(bytes *b, double about_q16)
{
    static const uint32_t ends[] = {0, GLINT_LEAST_DISTANCE_Q16, GLINT_MAX_DISTANCE_Q16};
    return take_rarely(b, 2) ? ONE_OF(b, ends)
                             : (uint32_t)clamp_q16(about_q16 * exp2(take_between(b, -6, 3)), GLINT_LEAST_DISTANCE_Q16,
                                                   GLINT_MAX_DISTANCE_Q16);
}

/* `about_q16`: how far the object is. */
static inline void take_extreme_reach(bytes *b, extreme_scene *e, glint_light *light, double about_q16)
{
    static const uint16_t terms[] = {0, 0, 1, 16384, UINT16_MAX};
    static const uint16_t outer[] = {GLINT_LEAST_CONE_TURN16, GLINT_WIDEST_CONE_TURN16, 8192, 2000};
    if (light->kind == GLINT_DIRECTIONAL) {
        return;
    }
    for (int k = 0; k < 3; k++) {
        light->attenuation.k_q14[k] = ONE_OF(b, terms);
    }
    light->attenuation.unit_q16 = take_extreme_distance(b, about_q16);
    light->attenuation.range_q16 = take_extreme_distance(b, about_q16);
    if (light->kind == GLINT_POINT && take_rarely(b, 2)) {
        light->kind = GLINT_SPOT;
        light->outer_turn16 = ONE_OF(b, outer);
        light->inner_turn16 = (uint16_t)(take_rarely(b, 2) ? light->outer_turn16 - GLINT_LEAST_CONE_TURN16 : 0);
        for (int k = 0; k < 3; k++) { /* towards the object */
            const double way = ((double)e->object.place.origin_q16[k] - light->position_q16[k]) / FARTHEST_Q16;
            light->direction[k] = (int16_t)clamp_q16(way * INT16_MAX / 2, INT16_MIN, INT16_MAX);
        }
        light->direction[0] = (int16_t)(light->direction[0] | 1);
    }
}

static inline void take_extreme_fog(bytes *b, glint_fog *fog, double about_q16)
{
    const int32_t deepest = FARTHEST_Q16, least = GLINT_LEAST_DISTANCE_Q16;
    const uint8_t kind = take_u8(b);
    fog->colour = kind & 1 ? (glint_colour){16384, 16384, 0} : take_rgb(b, 16384, false);
    fog->begin_q16 = kind & 2 ? 0 : clamp_q16(about_q16 * exp2(take_between(b, -3, 1)), 0, deepest - least);
    fog->begin_q16 = (kind & 12) == 12 ? deepest - least : fog->begin_q16;
    const double deep = (kind & 48) == 0    ? least
                        : (kind & 48) == 16 ? deepest
                                            : about_q16 * exp2(take_between(b, -16, 2));
    fog->end_q16 = clamp_q16(fog->begin_q16 + deep, fog->begin_q16 + least, deepest);
}

static inline void take_extreme_texture(bytes *b, extreme_scene *e)
{
    static uint8_t numbers[GLINT_MAX_TEXTURE_PX * GLINT_MAX_TEXTURE_PX]; /* also as RGB565, of half the height */
    static const uint16_t colours[3] = {0, UINT16_MAX, 0x1234};
    static const uint16_t sides[] = {1, 2, 3, 1023, GLINT_MAX_TEXTURE_PX};
    static const int16_t ends[] = {INT16_MIN, INT16_MAX, 0, 1, 16384};
    glint_texture *texture = &e->texture;
    const uint8_t kind = take_u8(b);
    for (size_t i = 0; i < sizeof numbers && numbers[1] == 0; i++) {
        numbers[i] = (uint8_t)(i % 3 + i / 1021 % 5);
    }
    texture->format = kind & 1;
    texture->filter = kind >> 1 & 1;
    texture->wrap_u = kind >> 2 & 1;
    texture->wrap_v = kind >> 3 & 1;
    texture->width_px = ONE_OF(b, sides);
    texture->height_px = ONE_OF(b, sides);
    if (texture->format == GLINT_TEXTURE_RGB565 && texture->height_px > GLINT_MAX_TEXTURE_PX / 2) {
        texture->height_px = GLINT_MAX_TEXTURE_PX / 2;
    }
    texture->texels = numbers;
    texture->palette = colours;
    texture->palette_count = 3;
    for (int v = 0; v < EXTREME_VERTICES; v++) {
        for (int k = 0; k < 2; k++) {
            e->texcoords[v][k] = kind & 16 ? ONE_OF(b, ends) : take_s16(b);
        }
    }
    e->mesh.texcoords = (const int16_t(*)[2])e->texcoords;
    e->mesh.texcoord_bits = (int8_t)(kind & 32 ? GLINT_LEAST_TEXCOORD_BITS : GLINT_MAX_TEXCOORD_BITS);
    e->material.texture = texture;
}

/* Each effect in every second scene or so. */
static inline void take_extreme_effects(bytes *b, extreme_scene *e, double about_q16)
{
    static const uint16_t transmissions[] = {0, 1, 8192, 16383, 16384};
    static const uint16_t widths[] = {1, 16, 64, GLINT_MAX_WIRE_Q4};
    const uint8_t kind = take_u8(b), more = take_u8(b);
    for (uint16_t i = 0; i < e->scene.light_count && e->scene.lights == e->lights; i++) {
        if (kind & 1) {
            take_extreme_reach(b, e, &e->lights[i], about_q16);
        }
        e->lights[i].casts_shadows = kind & 2 && e->lights[i].kind <= GLINT_SPOT;
    }
    if (kind & 4) {
        take_extreme_fog(b, &e->scene.fog, about_q16);
    }
    if (kind & 8) {
        e->material.transmission_q14 = ONE_OF(b, transmissions);
        e->material.grazing = more & 1 ? (glint_colour){16384, 16384, 1} : (glint_colour){0, 0, 0};
    }
    if ((kind & 48) == 48) {
        e->material.wire = (glint_colour){16384, 0, 1};
        e->material.wire_width_q4 = ONE_OF(b, widths);
    }
    if (kind & 64) {
        take_extreme_texture(b, e);
    }
    if (kind & 128) {
        e->scene.sky = e->scene.ground = (glint_colour){INT16_MAX, INT16_MAX, INT16_MAX};
        e->material.emission = (glint_colour){16384, 16384, 16384};
    }
    e->material.sides = (uint8_t)((more >> 1) % 3);
}

#endif
