/* SPDX-License-Identifier: MIT */
/*
 * Lights. Ambient ones add up to the scene's ambient intensity; area lights become point lights. Attenuation and the
 * cones of spot lights are taken over; glTF's range is, where the file says it.
 *
 * glTF's intensities are photometric (lux, candela), with no exposure to say what is white: they are scaled so that the
 * brightest light has 1 in its greatest channel at the centre of all objects (but not nearer to the light than a
 * quarter of their radius). Other files' intensities are taken as they are, unless one exceeds the format's 1.99994;
 * then they are scaled in the same way.
 *
 * A file without lights gets a white directional light over the camera's left shoulder and an ambient intensity of 0.1.
 */
#include "tools/import/internal.h"

#ifdef GLINT_HAVE_ASSIMP

#include <math.h>
#include <string.h>

#define GREATEST_INTENSITY (INT16_MAX / FIXED_ONE_Q14)
#define DEFAULT_AMBIENT 0.1
#define NEAREST_RADII 0.25
/* A point light beyond what its position can hold is so far away that its light is parallel. */
#define FARTHEST (ORIGIN_LIMIT - 1)

typedef struct float_light {
    double colour[3];
    double position[3], direction[3]; /* in world units of the file; unit vector */
    bool point, spot;
    double k[3]; /* of 1 / (k0 + k1 d + k2 d^2), d in the file's units */
    double range;
    double inner, outer; /* half the angles of the cones, radians */
    double level;        /* what arrives of it at the centre of the objects */
} float_light;

static void to_q14(const double intensity[3], double scale, glint_colour *result)
{
    int16_t codes[3];
    for (int k = 0; k < 3; k++) {
        codes[k] = (int16_t)fmax(0, to_fixed(intensity[k] * scale, FIXED_ONE_Q14, INT16_MAX));
    }
    *result = (glint_colour){codes[0], codes[1], codes[2]};
}

/* Of a glTF light, which assimp keeps beside its node: 0 where the file gives none. */
static double range_of(const importer *import, const struct aiLight *light)
{
    const struct aiNode *node = gather_find_node(import, light->mName.data);
    const struct aiMetadata *data = node ? node->mMetaData : NULL;
    for (unsigned i = 0; data && i < data->mNumProperties; i++) {
        if (strcmp(data->mKeys[i].data, "PBR_LightRange") == 0 && data->mValues[i].mType == AI_FLOAT) {
            float range;
            memcpy(&range, data->mValues[i].mData, sizeof range);
            return isfinite(range) && range > 0 ? (double)range : 0;
        }
    }
    return 0;
}

static void read_attenuation(const importer *import, const struct aiLight *light, float_light *result)
{
    double away[3];
    result->k[0] = fmax(0, (double)light->mAttenuationConstant);
    result->k[1] = fmax(0, (double)light->mAttenuationLinear);
    result->k[2] = fmax(0, (double)light->mAttenuationQuadratic);
    result->range = range_of(import, light);
    for (int k = 0; k < 3; k++) {
        away[k] = result->position[k] - import->centre[k];
    }
    const double distance = fmax(length3(away), NEAREST_RADII * import->radius);
    const double divisor = result->k[0] + result->k[1] * distance + result->k[2] * distance * distance;
    result->level = divisor > 0 ? 1 / divisor : 1;
    if (!(divisor > 0)) {
        result->k[0] = 1;
    }
}

/* assimp gives half the angle for glTF, as the file does; COLLADA's falloff_angle is taken for half of it too, since
 * its default, 180 degrees, stands for no cone at all. Beyond it there is no light; where the file gives no exponent,
 * assimp supposes one of 1 and an outer cone where that is down to a tenth, which is wider by acos(0.1). */
static void read_cone(const importer *import, const struct aiLight *light, float_light *result)
{
    const double right_angle = 1.5707963267948966;
    result->inner = fmax(0, (double)light->mAngleInnerCone);
    result->outer = fmax(result->inner, (double)light->mAngleOuterCone);
    if (import->kind == FILE_COLLADA && fabs(result->outer - result->inner - acos(0.1)) < 1e-3) {
        result->outer = result->inner;
    }
    result->spot = result->inner < right_angle && result->outer > 0;
    if (!result->spot) {
        store_warn(import->out, "light '%s': its cone of more than 180 degrees is left out", name_of(&light->mName));
    }
    result->outer = fmin(result->outer, right_angle);
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
    result->level = 1;
    if (!result->point || light->mType == aiLightSource_SPOT) {
        const double direction[3] = {(double)light->mDirection.x, (double)light->mDirection.y,
                                     (double)light->mDirection.z};
        transform_direction(&world, direction, result->direction);
        if (!normalise3(result->direction)) {
            store_warn(import->out, "light '%s' has no direction and is ignored", name);
            return false;
        }
    }
    if (!result->point) {
        return true;
    }
    const double position[3] = {(double)light->mPosition.x, (double)light->mPosition.y, (double)light->mPosition.z};
    transform_point(&world, position, result->position);
    if (light->mType == aiLightSource_AREA) {
        store_warn(import->out, "light '%s': area lights are drawn as point lights", name);
    }
    if (light->mType == aiLightSource_SPOT) {
        read_cone(import, light, result);
    }
    read_attenuation(import, light, result);
    return true;
}

static uint32_t distance_q16(const importer *import, double distance)
{
    const double least = GLINT_LEAST_DISTANCE_Q16 / FIXED_ONE_Q16, most = GLINT_MAX_DISTANCE_Q16 / FIXED_ONE_Q16;
    return (uint32_t)to_fixed(fmin(most, fmax(least, distance * import->world_scale)), FIXED_ONE_Q16,
                              GLINT_MAX_DISTANCE_Q16);
}

/*
 * colour / (k0 + k1 d + k2 d^2) as Glint has it, where the quotient ends at 1: a common factor brings k0 to 1, or,
 * where that would make the colour too bright, the colour to the greatest, so that what the end at 1 cuts off is beyond
 * white anyway. The unit of distance is the one that brings the coefficients to the format's greatest.
 */
static void write_attenuation(const importer *import, const float_light *from, double scale, glint_light *light)
{
    const double most_k = UINT16_MAX / FIXED_ONE_Q14;
    const double greatest = scale * fmax(from->colour[0], fmax(from->colour[1], from->colour[2]));
    double factor = from->k[0] > 0 ? 1 / from->k[0] : HUGE_VAL;
    if (greatest * factor > GREATEST_INTENSITY) {
        factor = GREATEST_INTENSITY / greatest;
    }
    if (!isfinite(factor)) {
        factor = 1; /* a black light */
    }
    to_q14(from->colour, scale * factor, &light->colour);
    light->attenuation.range_q16 = from->range > 0 ? distance_q16(import, from->range) : 0;
    if (from->k[1] > 0 || from->k[2] > 0 || factor * from->k[0] > 1) {
        const double unit = fmin(from->k[1] > 0 ? most_k / (factor * from->k[1]) : HUGE_VAL,
                                 from->k[2] > 0 ? sqrt(most_k / (factor * from->k[2])) : HUGE_VAL);
        light->attenuation.unit_q16 = distance_q16(import, isfinite(unit) ? unit : 1);
        const double t = light->attenuation.unit_q16 / FIXED_ONE_Q16 / import->world_scale;
        for (int i = 0; i < 3; i++) {
            const double k = factor * from->k[i] * pow(t, i);
            light->attenuation.k_q14[i] = (uint16_t)lrint(fmin(most_k, k) * FIXED_ONE_Q14);
        }
    }
}

static void write_cone(const float_light *from, glint_light *light)
{
    const double per_radian = 65536 / 6.283185307179586;
    const long inner = lrint(from->inner * per_radian), outer = lrint(from->outer * per_radian);
    light->kind = GLINT_SPOT;
    to_direction(from->direction, light->direction);
    light->outer_turn16 = (uint16_t)(outer < GLINT_LEAST_CONE_TURN16 ? GLINT_LEAST_CONE_TURN16 : outer);
    light->inner_turn16 =
        (uint16_t)(inner > light->outer_turn16 - GLINT_LEAST_CONE_TURN16 ? light->outer_turn16 - GLINT_LEAST_CONE_TURN16
                                                                         : inner);
}

static void write_light(importer *import, const float_light *from, double scale, glint_light *light)
{
    if (!from->point) {
        to_q14(from->colour, scale, &light->colour);
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
        to_q14(from->colour, scale * from->level, &light->colour);
        light->kind = GLINT_DIRECTIONAL;
        to_direction(direction, light->direction);
        store_warn(import->out, "a point light %g units away is drawn as a directional light", greatest);
        return;
    }
    light->kind = GLINT_POINT;
    for (int k = 0; k < 3; k++) {
        light->position_q16[k] = (int32_t)to_fixed(from->position[k] * import->world_scale, FIXED_ONE_Q16, 1 << 30);
    }
    write_attenuation(import, from, scale, light);
    if (from->spot) {
        write_cone(from, light);
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
            brightest = fmax(brightest, read[i].colour[k] * read[i].level);
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
