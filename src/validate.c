/* SPDX-License-Identifier: MIT */
#include "validate.h"

#include <stdbool.h>
#include <stddef.h>

#include <glint/error.h>

#include "geometry/view.h"
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

static int check_material(const glint_material *material)
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
    return in_range(&material->emission, ONE_Q14) ? GLINT_OK : GLINT_ERROR_EMISSION;
}

static bool distance_in_range(uint32_t distance_q16)
{
    return distance_q16 == 0 || (distance_q16 >= GLINT_LEAST_DISTANCE_Q16 && distance_q16 <= GLINT_MAX_DISTANCE_Q16);
}

/* A field that the light's kind has no use for may hold anything. */
static int check_light(const glint_light *light)
{
    if (!in_range(&light->colour, INT16_MAX)) {
        return GLINT_ERROR_LIGHT_COLOUR;
    }
    if (light->kind > GLINT_SPOT) {
        return GLINT_ERROR_LIGHT_KIND;
    }
    if (light->casts_shadows && !GLINT_SHADOWS) {
        return GLINT_ERROR_NOT_BUILT;
    }
    if (light->kind != GLINT_POINT && light->direction[0] == 0 && light->direction[1] == 0 &&
        light->direction[2] == 0) {
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
    if (scene->light_count > GLINT_MAX_LIGHTS) {
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

int glint_validate(const glint_scene *scene, const glint_display *display, const glint_quality *quality)
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
    for (uint16_t i = 0; !error && i < scene->light_count; i++) {
        error = check_light(&scene->lights[i]);
    }
    for (uint16_t i = 0; !error && i < scene->object_count; i++) {
        const glint_object *object = &scene->objects[i];
        error = check_material(object->material);
        error = error ? error : glint_place_check(&object->place);
        error = error ? error : check_indices(object->mesh);
    }
    return error;
}
