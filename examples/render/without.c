/* SPDX-License-Identifier: MIT */
#include "without.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const glint_colour black = GLINT_BLACK;

/* Takes a colour away; returns whether there was one. */
static bool take(glint_colour *colour)
{
    const bool had = (colour->r_q14 | colour->g_q14 | colour->b_q14) != 0;
    *colour = black;
    return had;
}

static bool take_ambient(glint_scene *scene)
{
    return take(&scene->ambient);
}

static bool take_sky(glint_scene *scene)
{
    const bool had = take(&scene->sky);
    return take(&scene->ground) || had;
}

static bool take_fog(glint_scene *scene)
{
    const bool had = (scene->fog.begin_q16 | scene->fog.end_q16) != 0;
    scene->fog = (glint_fog){.begin_q16 = 0};
    return had;
}

static bool take_diffuse(glint_material *material)
{
    return take(&material->diffuse);
}

static bool take_specular(glint_material *material)
{
    return take(&material->specular);
}

static bool take_emission(glint_material *material)
{
    return take(&material->emission);
}

static bool take_mirror(glint_material *material)
{
    return take(&material->mirror);
}

static bool take_grazing(glint_material *material)
{
    return take(&material->grazing);
}

static bool take_transmission(glint_material *material)
{
    const bool had = material->transmission_q14 != 0;
    material->transmission_q14 = 0;
    material->grazing = black; /* it has a meaning with transmission only */
    return had;
}

static bool take_texture(glint_material *material)
{
    const bool had = material->texture != NULL;
    material->texture = NULL;
    return had;
}

static bool take_wire(glint_material *material)
{
    const bool had = material->wire_width_q4 != 0;
    material->wire_width_q4 = 0;
    return had;
}

static bool take_sides(glint_material *material)
{
    const bool had = material->sides != GLINT_FRONT_SIDE;
    material->sides = GLINT_FRONT_SIDE;
    return had;
}

static bool take_attenuation(glint_light *light)
{
    const glint_attenuation *a = &light->attenuation;
    const bool had = light->kind != GLINT_DIRECTIONAL && (a->k_q14[0] | a->k_q14[1] | a->k_q14[2] | a->range_q16) != 0;
    light->attenuation = (glint_attenuation){.range_q16 = 0};
    return had;
}

/* What is left of a spot light, or of a source with an extent, is a lamp at its place. */
static bool take_cones(glint_light *light)
{
    const bool had = light->kind == GLINT_SPOT;
    light->kind = had ? GLINT_POINT : light->kind;
    return had;
}

static bool take_extents(glint_light *light)
{
    const bool had = light->kind == GLINT_PANEL || light->kind == GLINT_BALL;
    light->kind = had ? GLINT_POINT : light->kind;
    return had;
}

static bool take_shadows(glint_light *light)
{
    const bool had = light->casts_shadows;
    light->casts_shadows = false;
    return had;
}

/* One of the three takes the effect away from a scene, or from each of its materials or lights. */
static const struct {
    const char *name;
    bool (*from_scene)(glint_scene *);
    bool (*from_material)(glint_material *);
    bool (*from_light)(glint_light *);
} table[] = {
    {"ambient", take_ambient, NULL, NULL},
    {"diffuse", NULL, take_diffuse, NULL},
    {"specular", NULL, take_specular, NULL},
    {"sky", take_sky, NULL, NULL},
    {"emission", NULL, take_emission, NULL},
    {"mirror", NULL, take_mirror, NULL},
    {"texture", NULL, take_texture, NULL},
    {"attenuation", NULL, NULL, take_attenuation},
    {"cones", NULL, NULL, take_cones},
    {"extents", NULL, NULL, take_extents},
    {"shadows", NULL, NULL, take_shadows},
    {"fog", take_fog, NULL, NULL},
    {"transmission", NULL, take_transmission, NULL},
    {"grazing", NULL, take_grazing, NULL},
    {"wire", NULL, take_wire, NULL},
    {"sides", NULL, take_sides, NULL},
};
enum { EFFECT_COUNT = sizeof table / sizeof table[0] };

int without_parse(const char *names, uint32_t *effects, char *error, size_t error_bytes)
{
    *effects = 0;
    for (;;) {
        const size_t length = strcspn(names, ",");
        int i = 0;
        while (i < EFFECT_COUNT && (strlen(table[i].name) != length || memcmp(table[i].name, names, length) != 0)) {
            i++;
        }
        if (i == EFFECT_COUNT) {
            (void)snprintf(error, error_bytes, "--without %.*s: expected one of " WITHOUT_NAMES_1 " " WITHOUT_NAMES_2,
                           (int)length, names);
            return -1;
        }
        *effects |= (uint32_t)1 << i;
        if (names[length] == '\0') {
            return 0;
        }
        names += length + 1;
    }
}

/* Takes one effect away from the copy; returns whether it was there. */
static bool take_effect(int effect, glint_scene *scene, const without_copy *copy)
{
    bool had = table[effect].from_scene != NULL && table[effect].from_scene(scene);
    for (uint16_t i = 0; table[effect].from_material != NULL && i < scene->object_count; i++) {
        had = table[effect].from_material(&copy->materials[i]) || had;
    }
    for (uint16_t i = 0; table[effect].from_light != NULL && i < scene->light_count; i++) {
        had = table[effect].from_light(&copy->lights[i]) || had;
    }
    return had;
}

int without(const glint_scene *in, uint32_t effects, without_copy *copy, glint_scene *out, char *error,
            size_t error_bytes)
{
    *out = *in;
    copy->objects = calloc((size_t)in->object_count + 1, sizeof *copy->objects);
    copy->materials = calloc((size_t)in->object_count + 1, sizeof *copy->materials);
    copy->lights = calloc((size_t)in->light_count + 1, sizeof *copy->lights);
    if (copy->objects == NULL || copy->materials == NULL || copy->lights == NULL) {
        (void)snprintf(error, error_bytes, "out of memory");
        return -1;
    }
    for (uint16_t i = 0; i < in->object_count; i++) {
        copy->objects[i] = in->objects[i];
        copy->materials[i] = *in->objects[i].material;
        copy->objects[i].material = &copy->materials[i];
    }
    for (uint16_t i = 0; i < in->light_count; i++) {
        copy->lights[i] = in->lights[i];
    }
    out->objects = copy->objects;
    out->lights = copy->lights;
    for (int i = 0; i < EFFECT_COUNT; i++) {
        if ((effects >> i & 1) != 0 && !take_effect(i, out, copy)) {
            (void)snprintf(error, error_bytes, "--without %s: the scene has none of it", table[i].name);
            return -1;
        }
    }
    return 0;
}

void without_free(without_copy *copy)
{
    free(copy->objects);
    free(copy->materials);
    free(copy->lights);
    *copy = (without_copy){0};
}
