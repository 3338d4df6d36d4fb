/* SPDX-License-Identifier: MIT */
/*
 * Lights. Ambient ones add up to the scene's ambient intensity; spot and area lights become point lights.
 *
 * Glint's lights have no attenuation with distance: a file's is evaluated once, at the centre of all objects (but not
 * nearer to the light than a quarter of their radius). glTF's intensities are photometric (lux, candela), with no
 * exposure to say what is white: they are scaled so that the brightest light has 1 in its greatest channel. Other
 * files' intensities are taken as they are, unless one exceeds the format's 1.99994; then they are scaled in the same
 * way.
 *
 * A file without lights gets a white directional light over the camera's left shoulder and an ambient intensity of 0.1.
 */
#include "tools/import/internal.h"

#ifdef GLINT_HAVE_ASSIMP

#include <math.h>

#define GREATEST_INTENSITY (INT16_MAX / FIXED_ONE_Q14)
#define DEFAULT_AMBIENT 0.1
#define NEAREST_RADII 0.25
/* A point light beyond what its position can hold is so far away that its light is parallel. */
#define FARTHEST (ORIGIN_LIMIT - 1)

typedef struct float_light {
    double colour[3];
    double position[3], direction[3]; /* in world units of the file; unit vector */
    bool point;
} float_light;

static void to_q14(const double intensity[3], double scale, glint_colour *result)
{
    int16_t codes[3];
    for (int k = 0; k < 3; k++) {
        codes[k] = (int16_t)fmax(0, to_fixed(intensity[k] * scale, FIXED_ONE_Q14, INT16_MAX));
    }
    *result = (glint_colour){codes[0], codes[1], codes[2]};
}

static void attenuate(const importer *import, const struct aiLight *light, float_light *result)
{
    double away[3];
    for (int k = 0; k < 3; k++) {
        away[k] = result->position[k] - import->centre[k];
    }
    double distance = fmax(length3(away), NEAREST_RADII * import->radius);
    double divisor = (double)light->mAttenuationConstant + (double)light->mAttenuationLinear * distance +
                     (double)light->mAttenuationQuadratic * distance * distance;
    for (int k = 0; k < 3 && divisor > 0; k++) {
        result->colour[k] /= divisor;
    }
}

/* Returns false for a light that is left out. */
static bool read_light(importer *import, const struct aiLight *light, float_light *result)
{
    const char *name = name_of(&light->mName);
    matrix34 world;
    if (!gather_node_matrix(import, light->mName.data, &world)) {
        store_warn(import->out, "light '%s' is in no node and is ignored", name);
        return false;
    }
    result->colour[0] = (double)light->mColorDiffuse.r;
    result->colour[1] = (double)light->mColorDiffuse.g;
    result->colour[2] = (double)light->mColorDiffuse.b;
    bool negative = false;
    for (int k = 0; k < 3; k++) {
        negative = negative || result->colour[k] < 0;
        result->colour[k] = fmax(0, result->colour[k]);
    }
    if (negative) {
        store_warn(import->out, "light '%s': negative intensity is taken as 0", name);
    }
    result->point = light->mType != aiLightSource_DIRECTIONAL;
    if (!result->point) {
        const double direction[3] = {(double)light->mDirection.x, (double)light->mDirection.y,
                                     (double)light->mDirection.z};
        transform_direction(&world, direction, result->direction);
        if (!normalise3(result->direction)) {
            store_warn(import->out, "light '%s' has no direction and is ignored", name);
            return false;
        }
        return true;
    }
    const double position[3] = {(double)light->mPosition.x, (double)light->mPosition.y, (double)light->mPosition.z};
    transform_point(&world, position, result->position);
    if (light->mType != aiLightSource_POINT) {
        store_warn(import->out, "light '%s': spot and area lights are drawn as point lights", name);
    }
    if (import->kind != FILE_GLTF && (light->mAttenuationLinear > 0 || light->mAttenuationQuadratic > 0)) {
        store_warn(import->out, "light '%s': its attenuation is taken at the centre of the objects", name);
    }
    attenuate(import, light, result);
    return true;
}

static void write_light(importer *import, const float_light *from, double scale, glint_light *light)
{
    to_q14(from->colour, scale, &light->colour);
    if (!from->point) {
        light->kind = GLINT_DIRECTIONAL;
        to_direction(from->direction, light->direction);
        return;
    }
    double greatest = 0, direction[3];
    for (int k = 0; k < 3; k++) {
        greatest = fmax(greatest, fabs(from->position[k] * import->world_scale));
        direction[k] = import->centre[k] - from->position[k];
    }
    if (greatest > FARTHEST && normalise3(direction)) {
        light->kind = GLINT_DIRECTIONAL;
        to_direction(direction, light->direction);
        store_warn(import->out, "a point light %g units away is drawn as a directional light", greatest);
        return;
    }
    light->kind = GLINT_POINT;
    for (int k = 0; k < 3; k++) {
        light->position_q16[k] = (int32_t)to_fixed(from->position[k] * import->world_scale, FIXED_ONE_Q16, 1 << 30);
    }
}

static void make_default_light(importer *import, glint_light *light)
{
    const view *from = &import->view;
    double right[3], direction[3];
    cross3(from->forward, from->up, right);
    normalise3(right);
    for (int k = 0; k < 3; k++) {
        direction[k] = from->forward[k] + 0.5 * right[k] - 0.5 * from->up[k];
    }
    light->kind = GLINT_DIRECTIONAL;
    to_direction(direction, light->direction);
    const double white[3] = {1, 1, 1}, ambient[3] = {DEFAULT_AMBIENT, DEFAULT_AMBIENT, DEFAULT_AMBIENT};
    to_q14(white, 1, &light->colour);
    to_q14(ambient, 1, &import->out->scene.ambient);
}

/* Adds up the ambient lights and reads the others; returns how many those are. */
static size_t read_lights(importer *import, float_light *lights, double ambient[3])
{
    size_t count = 0;
    for (unsigned i = 0; i < import->file->mNumLights; i++) {
        const struct aiLight *light = import->file->mLights[i];
        if (light->mType == aiLightSource_AMBIENT) {
            ambient[0] += (double)light->mColorAmbient.r;
            ambient[1] += (double)light->mColorAmbient.g;
            ambient[2] += (double)light->mColorAmbient.b;
        } else if (read_light(import, light, &lights[count])) {
            count++;
        }
    }
    return count;
}

int make_lights(importer *import)
{
    imported_scene *out = import->out;
    unsigned room = import->file->mNumLights;
    if (room > UINT16_MAX) {
        return fail(import, "the file has %u lights; at most %d expected", room, UINT16_MAX);
    }
    float_light *read = store_take(out, room, sizeof *read);
    glint_light *lights = store_take(out, (size_t)room + 1, sizeof *lights);
    if (!read || !lights) {
        return fail_memory(import);
    }
    double ambient[3] = {0, 0, 0};
    size_t count = read_lights(import, read, ambient);
    double brightest = 0;
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++) {
            brightest = fmax(brightest, read[i].colour[k]);
        }
    }
    double scale = 1;
    if (brightest > 0 && (import->kind == FILE_GLTF || brightest > GREATEST_INTENSITY)) {
        scale = 1 / brightest;
        if (import->kind != FILE_GLTF) {
            store_warn(out, "the lights' intensities are scaled by %g, so that the brightest is 1", scale);
        }
    }
    for (size_t i = 0; i < count; i++) {
        write_light(import, &read[i], scale, &lights[i]);
    }
    bool ambient_only = !count && (ambient[0] > 0 || ambient[1] > 0 || ambient[2] > 0);
    if (!count && !ambient_only) {
        make_default_light(import, &lights[0]);
        count = 1;
    } else {
        if (ambient[0] > GREATEST_INTENSITY || ambient[1] > GREATEST_INTENSITY || ambient[2] > GREATEST_INTENSITY) {
            store_warn(out, "the ambient intensity is limited to %g", GREATEST_INTENSITY);
        }
        to_q14(ambient, 1, &out->scene.ambient);
    }
    out->scene.lights = lights;
    out->scene.light_count = (uint16_t)count;
    out->report.lights = (uint32_t)count;
    return 0;
}

#endif
