/* SPDX-License-Identifier: MIT */
#include "validate.h"

#include <stdbool.h>
#include <stddef.h>

#include <glint/error.h>

#include "backend/parts.h"
#include "geometry/view.h"
#include "lighting/source.h"
#include "number/integer.h"

#define ONE_Q14 16384
#define GREATEST_COORDINATE_Q16 ((uint32_t)1 << 30)

static bool in_range(const glint_colour *colour, int16_t greatest_q14)
{
    return colour->r_q14 >= 0 && colour->g_q14 >= 0 && colour->b_q14 >= 0 && colour->r_q14 <= greatest_q14 &&
           colour->g_q14 <= greatest_q14 && colour->b_q14 <= greatest_q14;
}

static bool position_in_range(const int32_t position_q16[3])
{
    return magnitude32(position_q16[0]) <= GREATEST_COORDINATE_Q16 &&
           magnitude32(position_q16[1]) <= GREATEST_COORDINATE_Q16 &&
           magnitude32(position_q16[2]) <= GREATEST_COORDINATE_Q16;
}

static int check_mesh_sizes(const glint_mesh *mesh)
{
    if (mesh == NULL || mesh->positions == NULL || mesh->normals_q14 == NULL || mesh->triangles == NULL) {
        return GLINT_ERROR_NULL_MESH;
    }
    if (mesh->vertex_count < 3 || mesh->triangle_count == 0) {
        return GLINT_ERROR_MESH_EMPTY;
    }
    if (mesh->fraction_bits < 0 || mesh->fraction_bits > GLINT_MAX_FRACTION_BITS) {
        return GLINT_ERROR_MESH_FRACTION;
    }
    return GLINT_OK;
}

static int check_indices(const glint_mesh *mesh)
{
    for (uint16_t i = 0; i < mesh->triangle_count; i++) {
        const uint16_t *triangle = mesh->triangles[i];
        if (flash_u16(&triangle[0]) >= mesh->vertex_count || flash_u16(&triangle[1]) >= mesh->vertex_count ||
            flash_u16(&triangle[2]) >= mesh->vertex_count) {
            return GLINT_ERROR_MESH_INDEX;
        }
    }
    return GLINT_OK;
}

static int check_material(const glint_material *material, const glint_environment *environment)
{
    if (material == NULL) {
        return GLINT_ERROR_NULL_MATERIAL;
    }
    if (!in_range(&material->ambient, ONE_Q14) || !in_range(&material->diffuse, ONE_Q14) ||
        !in_range(&material->specular, ONE_Q14)) {
        return GLINT_ERROR_REFLECTANCE;
    }
    if (material->exponent_q4 > GLINT_MAX_EXPONENT * 16) {
        return GLINT_ERROR_EXPONENT;
    }
    if (material->specular_model > GLINT_BLINN) {
        return GLINT_ERROR_SPECULAR_MODEL;
    }
    if (material->sides > GLINT_TWO_SIDED) {
        return GLINT_ERROR_SIDES;
    }
    if (material->shadows > (GLINT_CASTS_NO_SHADOW | GLINT_TAKES_NO_SHADOW)) {
        return GLINT_ERROR_SHADOWS;
    }
    if (!in_range(&material->emission, ONE_Q14)) {
        return GLINT_ERROR_EMISSION;
    }
    if (!in_range(&material->mirror, ONE_Q14)) {
        return GLINT_ERROR_MIRROR;
    }
    const bool mirrors = (material->mirror.r_q14 | material->mirror.g_q14 | material->mirror.b_q14) != 0;
    if (mirrors && environment == NULL) {
        return GLINT_ERROR_NULL_ENVIRONMENT;
    }
    if (material->transmission_q14 > ONE_Q14) {
        return GLINT_ERROR_TRANSMISSION;
    }
    if (!in_range(&material->grazing, ONE_Q14)) {
        return GLINT_ERROR_GRAZING;
    }
    return material->wire_width_q4 <= GLINT_MAX_WIRE_Q4 && in_range(&material->wire, ONE_Q14) ? GLINT_OK
                                                                                              : GLINT_ERROR_WIRE;
}

/* What is not looked at may hold anything: a mesh's texture coordinates without a texture, a palette without numbers
 * into it. */
static int check_texture(const glint_texture *texture, const glint_mesh *mesh)
{
    if (texture == NULL) {
        return GLINT_OK;
    }
    if (texture->format > GLINT_TEXTURE_PALETTE8) {
        return GLINT_ERROR_TEXTURE_FORMAT;
    }
    const uint64_t texels = (uint64_t)texture->width_px * texture->height_px;
    if (texels == 0 || texture->width_px > GLINT_MAX_TEXTURE_PX || texture->height_px > GLINT_MAX_TEXTURE_PX ||
        (texels << (texture->format == GLINT_TEXTURE_RGB565)) > SIZE_MAX / 2) {
        return GLINT_ERROR_TEXTURE_SIZE;
    }
    if (texture->texels == NULL) {
        return GLINT_ERROR_TEXTURE_TEXELS;
    }
    if (texture->format == GLINT_TEXTURE_PALETTE8 &&
        (texture->palette == NULL || texture->palette_count == 0 || texture->palette_count > GLINT_MAX_PALETTE)) {
        return GLINT_ERROR_TEXTURE_PALETTE;
    }
    if (texture->filter > GLINT_BILINEAR) {
        return GLINT_ERROR_TEXTURE_FILTER;
    }
    if (texture->wrap_u > GLINT_CLAMP || texture->wrap_v > GLINT_CLAMP) {
        return GLINT_ERROR_TEXTURE_WRAP;
    }
    if (mesh->texcoords == NULL) {
        return GLINT_ERROR_TEXTURE_TEXCOORDS;
    }
    return mesh->texcoord_bits < GLINT_LEAST_TEXCOORD_BITS || mesh->texcoord_bits > GLINT_MAX_TEXCOORD_BITS
               ? GLINT_ERROR_TEXCOORD_BITS
               : GLINT_OK;
}

static bool distance_in_range(uint32_t distance_q16)
{
    return distance_q16 == 0 || (distance_q16 >= GLINT_LEAST_DISTANCE_Q16 && distance_q16 <= GLINT_MAX_DISTANCE_Q16);
}

/* A panel's corners and a ball's outermost points are positions too. */
static int check_extent(const glint_light *light)
{
    for (int k = 0; k < 3; k++) {
        const uint32_t extent = light->kind == GLINT_BALL
                                    ? magnitude32(light->radius_q16)
                                    : magnitude32(light->edge_q16[0][k]) + magnitude32(light->edge_q16[1][k]);
        const bool wraps = light->kind == GLINT_PANEL && extent < magnitude32(light->edge_q16[0][k]);
        if (wraps || extent > GREATEST_COORDINATE_Q16 ||
            magnitude32(light->position_q16[k]) + extent > GREATEST_COORDINATE_Q16) {
            return GLINT_ERROR_LIGHT_EXTENT;
        }
    }
    if (light->kind == GLINT_BALL && light->radius_q16 < 0) {
        return GLINT_ERROR_LIGHT_EXTENT;
    }
    if (light->casts_shadows) {
        return GLINT_ERROR_LIGHT_SHADOWS;
    }
    return light->samples > GLINT_MAX_SAMPLES ? GLINT_ERROR_LIGHT_SAMPLES : GLINT_OK;
}

/* A field that the light's kind has no use for may hold anything. */
static int check_light(const glint_light *light)
{
    if (!in_range(&light->colour, INT16_MAX)) {
        return GLINT_ERROR_LIGHT_COLOUR;
    }
    if (light->kind > GLINT_BALL) {
        return GLINT_ERROR_LIGHT_KIND;
    }
    const bool directed = light->kind == GLINT_DIRECTIONAL || light->kind == GLINT_SPOT;
    if (directed && light->direction[0] == 0 && light->direction[1] == 0 && light->direction[2] == 0) {
        return GLINT_ERROR_LIGHT_DIRECTION;
    }
    if (light->kind == GLINT_DIRECTIONAL) {
        return GLINT_OK;
    }
    if (!position_in_range(light->position_q16)) {
        return GLINT_ERROR_LIGHT_POSITION;
    }
    if (!distance_in_range(light->attenuation.unit_q16) || !distance_in_range(light->attenuation.range_q16)) {
        return GLINT_ERROR_LIGHT_DISTANCE;
    }
    if (light->kind == GLINT_PANEL || light->kind == GLINT_BALL) {
        return check_extent(light);
    }
    return light->kind == GLINT_SPOT && (light->outer_turn16 > GLINT_WIDEST_CONE_TURN16 ||
                                         (uint32_t)light->inner_turn16 + GLINT_LEAST_CONE_TURN16 > light->outer_turn16)
               ? GLINT_ERROR_LIGHT_CONE
               : GLINT_OK;
}

static int check_fog(const glint_fog *fog)
{
    if (fog->begin_q16 == 0 && fog->end_q16 == 0) {
        return GLINT_OK;
    }
    return fog->begin_q16 >= 0 && fog->end_q16 >= 0 && (uint32_t)fog->end_q16 <= GREATEST_COORDINATE_Q16 &&
                   fog->end_q16 - fog->begin_q16 >= GLINT_LEAST_DISTANCE_Q16 && in_range(&fog->colour, ONE_Q14)
               ? GLINT_OK
               : GLINT_ERROR_FOG;
}

static int check_environment(const glint_environment *environment)
{
    if (environment == NULL) {
        return GLINT_OK;
    }
    const uint8_t side = environment->side;
    if (side < 8 || side > 128 || (side & (side - 1)) != 0) {
        return GLINT_ERROR_ENVIRONMENT_SIDE;
    }
    return environment->texels == NULL ? GLINT_ERROR_NULL_ENVIRONMENT : GLINT_OK;
}

static int check_camera(const glint_camera *camera)
{
    if (camera == NULL) {
        return GLINT_ERROR_NULL_CAMERA;
    }
    if (!position_in_range(camera->eye_q16) || !position_in_range(camera->target_q16)) {
        return GLINT_ERROR_CAMERA_RANGE;
    }
    if (camera->field_of_view_turn16 < 182 || camera->field_of_view_turn16 > 30947) {
        return GLINT_ERROR_CAMERA_FIELD;
    }
    if (camera->near_q16 < 64 || magnitude32(camera->near_q16) > GREATEST_COORDINATE_Q16) {
        return GLINT_ERROR_CAMERA_NEAR;
    }
    return glint_camera_check(camera);
}

static int check_display(const glint_display *display)
{
    if (display->width_px == 0 || display->height_px == 0 || display->width_px > GLINT_MAX_SIZE_PX ||
        display->height_px > GLINT_MAX_SIZE_PX) {
        return GLINT_ERROR_DISPLAY_SIZE;
    }
    const uint32_t row_bytes = glint_row_bytes(display->format, display->width_px);
    if (row_bytes == 0) {
        return GLINT_ERROR_DISPLAY_FORMAT;
    }
    if (display->format == GLINT_MONO_PAGES && display->band_px % 8 != 0 && display->band_px < display->height_px) {
        return GLINT_ERROR_DISPLAY_BAND;
    }
    if (display->dither > GLINT_DITHER_BAYER) {
        return GLINT_ERROR_DISPLAY_DITHER;
    }
    if (display->buffer_count > 2 || (display->buffer_count == 2 && display->transfers == NULL)) {
        return GLINT_ERROR_DISPLAY_BUFFERS;
    }
    /* the upper limit keeps a band's bytes within 32 bits; 16-bit pixels are written as such */
    const bool halves = display->format == GLINT_RGB565 || display->format == GLINT_RGB565_SWAPPED;
    if (halves && (display->stride_bytes & 1) != 0) {
        return GLINT_ERROR_DISPLAY_STRIDE;
    }
    if (display->stride_bytes != 0 && (display->stride_bytes < row_bytes || display->stride_bytes > 0xfffff)) {
        return GLINT_ERROR_DISPLAY_STRIDE;
    }
    return GLINT_OK;
}

int glint_validate_sizes(const glint_scene *scene, const glint_display *display)
{
    if (scene == NULL || display == NULL) {
        return GLINT_ERROR_NULL_ARGUMENT;
    }
    if (scene->object_count > 0 && scene->objects == NULL) {
        return GLINT_ERROR_NULL_OBJECTS;
    }
    if (scene->light_count > 0 && scene->lights == NULL) {
        return GLINT_ERROR_NULL_LIGHTS;
    }
    uint32_t points = scene->light_count;
    for (uint16_t i = 0; points <= GLINT_MAX_LIGHTS && i < scene->light_count; i++) {
        points += glint_source_most(&scene->lights[i]) - 1u;
    }
    if (points > GLINT_MAX_LIGHTS) {
        return GLINT_ERROR_LIGHT_COUNT;
    }
    for (uint16_t i = 0; i < scene->object_count; i++) {
        const int error = check_mesh_sizes(scene->objects[i].mesh);
        if (error) {
            return error;
        }
    }
    return check_display(display);
}

static bool is_black(const glint_colour *colour)
{
    return (colour->r_q14 | colour->g_q14 | colour->b_q14) == 0;
}

static uint32_t parts_of_light(const glint_light *light)
{
    const glint_attenuation *a = &light->attenuation;
    const uint32_t shadows = light->casts_shadows ? GLINT_PART_SHADOWS : 0;
    if (light->kind == GLINT_DIRECTIONAL) {
        return shadows;
    }
    const bool attenuated = a->range_q16 != 0 || (a->k_q14[0] | a->k_q14[1] | a->k_q14[2]) != 0;
    return shadows | GLINT_PART_POINTS | (attenuated || light->kind == GLINT_SPOT ? GLINT_PART_REACH : 0) |
           (light->kind == GLINT_PANEL || light->kind == GLINT_BALL ? GLINT_PART_EXTENTS : 0);
}

static uint32_t parts_of_material(const glint_material *material)
{
    return (is_black(&material->specular) ? 0 : GLINT_PART_SPECULAR) |
           (is_black(&material->mirror) ? 0 : GLINT_PART_MIRRORS) |
           (material->sides == GLINT_FRONT_SIDE ? 0 : GLINT_PART_SIDES) |
           (material->texture == NULL ? 0 : GLINT_PART_TEXTURES) |
           (material->transmission_q14 == 0 ? 0 : GLINT_PART_TRANSMISSION) |
           (material->wire_width_q4 == 0 ? 0 : GLINT_PART_WIRE);
}

/* Is there a part that a valid scene asks for and the backend has not? */
static bool lacks_part(const glint_scene *scene, const glint_quality *quality, uint32_t parts)
{
    uint32_t asked = 0;
    if (quality->tolerance != 0 || quality->shading >= GLINT_SHADING_Q1) {
        asked |= GLINT_PART_TIERS;
    } else if (quality->shading != GLINT_SHADING_EXACT) {
        asked |= GLINT_PART_CORNERS;
    }
    asked |= is_black(&scene->sky) && is_black(&scene->ground) ? 0 : GLINT_PART_SKY;
    asked |= (scene->fog.begin_q16 | scene->fog.end_q16) == 0 ? 0 : GLINT_PART_FOG;
    for (uint16_t i = 0; i < scene->light_count; i++) {
        asked |= parts_of_light(&scene->lights[i]);
    }
    for (uint16_t i = 0; i < scene->object_count; i++) {
        asked |= parts_of_material(scene->objects[i].material);
    }
    return (asked & ~parts) != 0;
}

int glint_validate(const glint_scene *scene, const glint_display *display, const glint_quality *quality, uint32_t parts)
{
    int error = quality == NULL ? GLINT_ERROR_NULL_ARGUMENT : glint_validate_sizes(scene, display);
    if (error) {
        return error;
    }
    if (display->flush == NULL) {
        return GLINT_ERROR_NULL_FLUSH;
    }
    if (quality->shading > GLINT_SHADING_Q2) {
        return GLINT_ERROR_SHADING;
    }
    if (quality->tolerance != 0 &&
        (quality->tolerance < GLINT_LEAST_TOLERANCE || quality->shading != GLINT_SHADING_EXACT)) {
        return GLINT_ERROR_TOLERANCE;
    }
    if (!in_range(&scene->ambient, INT16_MAX) || !in_range(&scene->sky, INT16_MAX) ||
        !in_range(&scene->ground, INT16_MAX)) {
        return GLINT_ERROR_AMBIENT;
    }
    if (!in_range(&scene->background, ONE_Q14)) {
        return GLINT_ERROR_BACKGROUND;
    }
    error = check_camera(scene->camera);
    error = error ? error : check_fog(&scene->fog);
    error = error ? error : check_environment(scene->environment);
    for (uint16_t i = 0; !error && i < scene->light_count; i++) {
        error = check_light(&scene->lights[i]);
    }
    for (uint16_t i = 0; !error && i < scene->object_count; i++) {
        const glint_object *object = &scene->objects[i];
        error = check_material(object->material, scene->environment);
        error = error ? error : check_texture(object->material->texture, object->mesh);
        error = error ? error : glint_place_check(&object->place);
        error = error ? error : check_indices(object->mesh);
    }
    return error || !lacks_part(scene, quality, parts) ? error : GLINT_ERROR_PART;
}
