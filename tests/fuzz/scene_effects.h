/* SPDX-License-Identifier: MIT */
/*
 * The effects of a fuzzer's scene: a few of those that the headers have, valid or not, added to a scene of
 * scene_case.h.
 *
 * They are read from the end of the input, so that what its beginning means stays, and a mutation finds them wherever
 * the rest of the scene ends. Texels, palettes and texture coordinates are allocated to the byte.
 */
#ifndef GLINT_TESTS_FUZZ_SCENE_EFFECTS_H
#define GLINT_TESTS_FUZZ_SCENE_EFFECTS_H

#include "tests/fuzz/scene_case.h"

enum {
    EFFECT_ATTENUATION,
    EFFECT_SPOT,
    EFFECT_PANEL,
    EFFECT_BALL,
    EFFECT_SHADOW,
    EFFECT_SKY,
    EFFECT_EMISSION,
    EFFECT_MIRROR,
    EFFECT_SIDES,
    EFFECT_FOG,
    EFFECT_TRANSMISSION,
    EFFECT_GRAZING,
    EFFECT_WIRE,
    EFFECT_TEXTURE,
    EFFECTS
};

static const char *const effect_name[EFFECTS] = {"attenuation",  "spot",     "panel",  "ball",   "shadow",
                                                 "sky",          "emission", "mirror", "sides",  "fog",
                                                 "transmission", "grazing",  "wire",   "texture"};

/* Which effects there are to be, as bits: none, one, a few or any. */
static inline uint16_t take_effects(bytes *b)
{
    const uint8_t kind = take_u8(b);
    const uint16_t first = take_u16(b), second = take_u16(b);
    const uint16_t all = (1u << EFFECTS) - 1;
    return (uint16_t)(kind < 8     ? 0
                      : kind < 96  ? 1u << first % EFFECTS
                      : kind < 208 ? first & second & all
                                   : first & all);
}

/* 0, or a distance about the scene's size, or any. */
static inline uint32_t take_distance(bytes *b, bool wild)
{
    const uint8_t kind = take_u8(b);
    if (wild && kind >= 240) {
        return kind & 1 ? GLINT_LEAST_DISTANCE_Q16 - 1 : GLINT_MAX_DISTANCE_Q16 + 1;
    }
    if (kind >= 208) {
        return kind & 1 ? GLINT_LEAST_DISTANCE_Q16 : GLINT_MAX_DISTANCE_Q16;
    }
    return kind < 64 ? 0 : (uint32_t)(256 + take_u8(b)) << (kind < 192 ? 4 + (kind & 7) : kind % 22);
}

static inline void take_extent(bytes *b, glint_light *light, bool wild)
{
    const uint8_t kind = take_u8(b);
    for (int k = 0; k < 3; k++) {
        if (!wild) { /* a quarter of the range each */
            light->position_q16[k] >>= 2;
        }
        for (int i = 0; i < 2; i++) {
            light->edge_q16[i][k] = (kind & 7) == 0   ? take_any_size(b, wild ? INT32_MAX - 1 : 1 << 28, wild)
                                    : (kind & 7) == 1 ? 0
                                                      : take_between(b, -128, 127) * 2048;
        }
    }
    light->radius_q16 = (kind & 48) == 0 ? take_any_size(b, 1 << 28, wild) : take_u8(b) << (kind >> 4 & 3) * 3;
    light->radius_q16 = wild || light->radius_q16 >= 0 ? light->radius_q16 : -light->radius_q16;
    light->samples = (uint8_t)(kind & 64 ? take_between(b, 0, wild ? 255 : GLINT_MAX_SAMPLES) : 0);
}

static inline void take_light_effects(bytes *b, glint_light *light, uint16_t effects, bool wild)
{
    static const uint8_t kinds[4] = {GLINT_POINT, GLINT_SPOT, GLINT_PANEL, GLINT_BALL};
    const uint8_t kind = take_u8(b);
    for (int i = 0; i < 4 && kind >= 48; i++) { /* one of those that there are to be, or left as it is */
        const int k = (kind + i) & 3;
        if (effects >> (EFFECT_ATTENUATION + k) & 1) {
            light->kind = kinds[k];
            break;
        }
    }
    if (light->kind == GLINT_SPOT) {
        const uint16_t widest = GLINT_WIDEST_CONE_TURN16;
        light->outer_turn16 = (uint16_t)take_between(b, GLINT_LEAST_CONE_TURN16, wild ? widest + 1 : widest);
        light->inner_turn16 = (uint16_t)take_between(b, 0, light->outer_turn16 - (wild ? 0 : GLINT_LEAST_CONE_TURN16));
        for (int k = 0; k < 3; k++) { /* towards the middle of the scene, about */
            const int32_t way = take_between(b, -64, 63) - light->position_q16[k] / 8192;
            light->direction[k] = (int16_t)(take_rarely(b, wild ? 4 : 256) ? 0 : way | 1);
        }
    }
    if (light->kind == GLINT_SPOT && !wild) {
        light->direction[0] = (int16_t)(light->direction[0] | 1);
    }
    if (light->kind >= GLINT_PANEL) {
        take_extent(b, light, wild);
    }
    if (effects & 1u << EFFECT_ATTENUATION) {
        for (int k = 0; k < 3; k++) {
            const uint8_t size = take_u8(b);
            light->attenuation.k_q14[k] = (uint16_t)(size < 96 ? 0 : take_u16(b) >> (size & 15));
        }
        light->attenuation.unit_q16 = take_distance(b, wild);
        light->attenuation.range_q16 = take_distance(b, wild);
    }
    if (effects & 1u << EFFECT_SHADOW) {
        light->casts_shadows = !take_rarely(b, 4) && (light->kind < GLINT_PANEL || (wild && take_rarely(b, 2)));
    }
}

static inline void fill(void *to, size_t bytes_wanted, uint64_t *random)
{
    for (size_t i = 0; i < bytes_wanted; i++) {
        *random = *random * 6364136223846793005u + 1442695040888963407u;
        ((uint8_t *)to)[i] = (uint8_t)(*random >> 56);
    }
}

static inline void take_texture(bytes *b, scene_case *c, int number, bool wild)
{
    static const uint16_t sides[] = {1, 2, 3, 4, 5, 7, 8, 16, 17, 24, 32, 64, 128, 1024, 0, 1025};
    glint_texture *texture = &c->textures[number];
    const uint8_t kind = take_u8(b), size = take_u8(b);
    const int slot = 3 * CASE_MESHES + 2 * number;
    texture->width_px = sides[(size & 15) % (wild ? 16 : 14)];
    texture->height_px = sides[(size >> 4) % (wild ? 16 : 14)];
    if ((uint32_t)texture->width_px * texture->height_px > 4096) { /* of no use, and slow to fill */
        texture->height_px = (uint16_t)(1 + (size & 3));
    }
    texture->format = (uint8_t)(wild && kind >= 248 ? 2 : kind & 1);
    texture->filter = (uint8_t)(wild && kind >= 240 && kind < 248 ? 2 : kind >> 1 & 1);
    texture->wrap_u = (uint8_t)(wild && kind >= 232 && kind < 240 ? 2 : kind >> 2 & 1);
    texture->wrap_v = (uint8_t)(wild && kind >= 224 && kind < 232 ? 2 : kind >> 3 & 1);
    texture->palette_count = (uint16_t)take_between(b, wild ? 0 : 1, kind & 16 ? 8 : 256 + wild);
    const size_t texel_bytes = texture->format == GLINT_TEXTURE_PALETTE8 ? 1 : 2;
    const size_t texels_bytes = (size_t)texture->width_px * texture->height_px * texel_bytes;
    const size_t palette_bytes = texel_bytes == 1 ? texture->palette_count * sizeof *texture->palette : 0;
    void *const texels = allocate(c, slot, texels_bytes + !texels_bytes);
    uint16_t *const palette = allocate(c, slot + 1, palette_bytes + !palette_bytes);
    uint64_t random = take_u32(b);
    fill(texels, texels_bytes, &random);
    fill(palette, palette_bytes, &random);
    texture->texels = wild && take_rarely(b, 16) ? NULL : texels;
    texture->palette = palette_bytes == 0 || (wild && take_rarely(b, 16)) ? NULL : palette;
}

/* Of a whole mesh within one texel, or about one texture, or over many. */
static inline void take_texcoords(bytes *b, scene_case *c, int number, bool wild)
{
    glint_mesh *mesh = &c->meshes[number];
    const uint8_t spread = take_u8(b);
    int16_t(*texcoords)[2] = allocate(c, 5 * CASE_MESHES + number, (size_t)mesh->vertex_count * sizeof *texcoords);
    for (uint16_t v = 0; v < mesh->vertex_count; v++) {
        for (int k = 0; k < 2; k++) {
            texcoords[v][k] = (int16_t)(take_between(b, -128, 127) * (1 << (spread & 7)) + (spread & 8 ? spread : 0));
        }
    }
    mesh->texcoords = wild && take_rarely(b, 16) ? NULL : (const int16_t(*)[2])texcoords;
    mesh->texcoord_bits = (int8_t)take_between(b, wild ? 8 : 9, wild ? 16 : 15);
}

static inline void take_environment(bytes *b, scene_case *c, bool wild)
{
    static const uint8_t bad[] = {0, 7, 12, 129};
    glint_environment *around = &c->environment;
    const uint8_t kind = take_u8(b);
    around->side = (uint8_t)(wild && kind >= 240 ? bad[kind & 3] : 8 << (kind & 64 ? kind % 3 : 0));
    const size_t count = (size_t)around->side * around->side;
    uint16_t *texels = allocate(c, 6 * CASE_MESHES, count * sizeof *texels + 1);
    uint64_t random = take_u32(b);
    fill(texels, count * sizeof *texels, &random);
    for (size_t i = 0; i < count && !(kind & 1); i++) {
        texels[i] = (uint16_t)(0x8410u + (texels[i] & 0x21u));
    }
    /* neighbours differ by anything; or by one step of 63 in green and one of 31 in blue */
    around->steepest = (uint8_t)(kind & 1 ? kind & 2 ? 255 : 0 : 9);
    around->texels = wild && kind >= 224 && kind < 240 ? NULL : texels;
    c->scene.environment = wild && kind >= 208 && kind < 224 ? NULL : around;
}

static inline void take_material_effects(bytes *b, scene_case *c, int number, uint16_t effects, bool wild)
{
    glint_material *material = &c->materials[number];
    const uint16_t mine = (uint16_t)(take_rarely(b, 3) ? effects & take_u16(b) : effects); /* not all have all */
    if (mine & 1u << EFFECT_EMISSION) {
        material->emission = take_rgb(b, 16384, wild);
    }
    if (mine & 1u << EFFECT_MIRROR) {
        material->mirror = take_rgb(b, 16384, wild);
    }
    if (mine & 1u << EFFECT_SIDES) {
        material->sides = (uint8_t)take_between(b, 0, wild ? GLINT_TWO_SIDED + 1 : GLINT_TWO_SIDED);
    }
    if (mine & 1u << EFFECT_SHADOW) {
        material->shadows = (uint8_t)(take_rarely(b, 3) ? take_between(b, 0, wild ? 4 : 3) : 0);
    }
    if (mine & 1u << EFFECT_TRANSMISSION) {
        material->transmission_q14 = (uint16_t)take_between(b, 0, wild ? 16385 : 16384);
    }
    if (mine & 1u << EFFECT_GRAZING) {
        material->transmission_q14 = (uint16_t)(material->transmission_q14 / 2 + (take_u8(b) << 5));
        material->grazing = take_rgb(b, 16384, wild);
    }
    if (mine & 1u << EFFECT_WIRE) {
        material->wire = take_rgb(b, 16384, wild);
        material->wire_width_q4 =
            (uint16_t)(take_rarely(b, 8) ? take_between(b, 0, wild ? GLINT_MAX_WIRE_Q4 + 1 : GLINT_MAX_WIRE_Q4)
                                         : take_between(b, 0, 64));
    }
    if (mine & 1u << EFFECT_TEXTURE) {
        material->texture = &c->textures[number];
    }
}

static inline void take_fog(bytes *b, glint_fog *fog, bool wild)
{
    const uint8_t kind = take_u8(b);
    const int32_t most = (int32_t)1 << 30;
    fog->colour = take_rgb(b, 16384, wild);
    fog->begin_q16 = take_any_size(b, most - GLINT_LEAST_DISTANCE_Q16, wild);
    fog->begin_q16 = kind & 1 ? take_u16(b) << 3 : wild || fog->begin_q16 >= 0 ? fog->begin_q16 : -fog->begin_q16;
    const int64_t end = (int64_t)fog->begin_q16 + GLINT_LEAST_DISTANCE_Q16 +
                        (kind & 2 ? (int64_t)take_u32(b) >> (kind >> 3) : take_u8(b) - (wild ? 64 : 0));
    fog->end_q16 = (int32_t)(end > most ? wild ? most + 1 : most : end < INT32_MIN ? INT32_MIN : end);
}

/* Adds effects to a scene; returns which, as bits. */
static inline uint16_t scene_case_effects(bytes *b, scene_case *c)
{
    const bool wild = take_rarely(b, 8);
    const uint16_t effects = take_effects(b);
    for (int i = 0; i < CASE_LIGHTS && i < c->scene.light_count; i++) {
        take_light_effects(b, &c->lights[i], effects, wild);
    }
    if (effects & 1u << EFFECT_SKY) {
        c->scene.sky = take_rgb(b, INT16_MAX, wild);
        c->scene.ground = take_rgb(b, INT16_MAX, wild);
        for (int k = 0; k < 3; k++) {
            c->scene.up[k] = (int16_t)(take_rarely(b, 3) ? take_s16(b) : 0);
        }
    }
    if (effects & 1u << EFFECT_FOG) {
        take_fog(b, &c->scene.fog, wild);
    }
    if (effects & 1u << EFFECT_MIRROR) {
        take_environment(b, c, wild);
    }
    for (int i = 0; i < c->mesh_count; i++) {
        if (effects & 1u << EFFECT_TEXTURE) {
            take_texture(b, c, i, wild);
            take_texcoords(b, c, i, wild);
        }
        take_material_effects(b, c, i, effects, wild);
    }
    return effects;
}

/* The same scene without one of its effects, a spot light, panel or ball as a point light. */
static inline void scene_case_without(scene_case *c, int effect)
{
    static const glint_attenuation no_attenuation = {{0}, 0, 0};
    static const glint_colour black = {0, 0, 0};
    static const glint_fog no_fog = {{0, 0, 0}, 0, 0};
    static const uint8_t kinds[EFFECTS] = {[EFFECT_SPOT] = GLINT_SPOT, GLINT_PANEL, GLINT_BALL};
    for (int i = 0; i < CASE_LIGHTS; i++) {
        glint_light *l = &c->lights[i];
        l->attenuation = effect == EFFECT_ATTENUATION ? no_attenuation : l->attenuation;
        l->kind = kinds[effect] != 0 && l->kind == kinds[effect] ? GLINT_POINT : l->kind;
        l->casts_shadows = l->casts_shadows && effect != EFFECT_SHADOW;
    }
    for (int i = 0; i < CASE_MESHES; i++) {
        glint_material *m = &c->materials[i];
        m->emission = effect == EFFECT_EMISSION ? black : m->emission;
        m->mirror = effect == EFFECT_MIRROR ? black : m->mirror;
        m->sides = effect == EFFECT_SIDES ? GLINT_FRONT_SIDE : m->sides;
        m->transmission_q14 = effect == EFFECT_TRANSMISSION ? 0 : m->transmission_q14;
        m->grazing = effect == EFFECT_GRAZING ? black : m->grazing;
        m->wire_width_q4 = effect == EFFECT_WIRE ? 0 : m->wire_width_q4;
        m->texture = effect == EFFECT_TEXTURE ? NULL : m->texture;
    }
    c->scene.sky = effect == EFFECT_SKY ? black : c->scene.sky;
    c->scene.ground = effect == EFFECT_SKY ? black : c->scene.ground;
    c->scene.fog = effect == EFFECT_FOG ? no_fog : c->scene.fog;
}

#endif
