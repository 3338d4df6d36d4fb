/* SPDX-License-Identifier: MIT */
/*
 * Is a scene valid by the letter of the public headers? Written from them alone, in floating point where they speak of
 * angles and determinants, so that it shares no code and no arithmetic with src/validate.inc.
 */
#ifndef GLINT_TESTS_FUZZ_SCENE_VALIDITY_H
#define GLINT_TESTS_FUZZ_SCENE_VALIDITY_H

#include "tests/fuzz/scene_case.h"

static inline validity both(validity a, validity b)
{
    return a < b ? a : b;
}

static inline validity colour_validity(const glint_colour *c, int most)
{
    return c->r_q14 >= 0 && c->r_q14 <= most && c->g_q14 >= 0 && c->g_q14 <= most && c->b_q14 >= 0 && c->b_q14 <= most
               ? VALID
               : INVALID;
}

static inline validity point_validity(const int32_t v[3])
{
    const int64_t most = (int64_t)1 << 30;
    for (int k = 0; k < 3; k++) {
        if (v[k] > most || v[k] < -most) {
            return INVALID;
        }
    }
    return VALID;
}

static inline validity place_validity(const glint_place *place)
{
    double m[3][3], greatest = 0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            m[i][k] = place->linear_q16[i][k];
            greatest = fmax(greatest, fabs(m[i][k]));
        }
    }
    if (greatest == 0) {
        return point_validity(place->origin_q16); /* the identity */
    }
    /* scaled so that products stay exact enough: the relative error is below 2^-48 of m^3 */
    const double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    const double ratio = fabs(determinant) / (greatest * greatest * greatest) * 16777216; /* over 2^-24 */
    if (greatest > 67108864 || ratio < 0.9) {
        return INVALID;
    }
    return both(ratio < 1.1 ? EITHER : VALID, point_validity(place->origin_q16));
}

static inline validity camera_validity(const glint_camera *camera)
{
    double forward[3], up[3], f = 0, u = 0, along = 0;
    if (camera == NULL || point_validity(camera->eye_q16) != VALID || point_validity(camera->target_q16) != VALID ||
        camera->field_of_view_turn16 < 182 || camera->field_of_view_turn16 > 30947 || camera->near_q16 < 64 ||
        camera->near_q16 > (int32_t)1 << 30) {
        return INVALID;
    }
    for (int k = 0; k < 3; k++) {
        forward[k] = (double)camera->target_q16[k] - camera->eye_q16[k];
        up[k] = camera->up[k];
        f += forward[k] * forward[k];
        u += up[k] * up[k];
    }
    if (f == 0) {
        return INVALID;
    }
    if (u == 0) {
        up[1] = u = 1;
    }
    double sine = 0;
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        along = forward[i] * up[j] - forward[j] * up[i];
        sine += along * along;
    }
    sine = sqrt(sine / f / u);
    /* 0.1 degrees; below, the library may refuse from less than half of it on */
    return sine < 0.0005 ? INVALID : sine < sin(0.1 * 3.14159265358979 / 180) ? EITHER : VALID;
}

static inline validity mesh_validity(const glint_mesh *mesh)
{
    if (mesh == NULL || mesh->positions == NULL || mesh->normals_q14 == NULL || mesh->triangles == NULL ||
        mesh->vertex_count < 3 || mesh->triangle_count == 0 || mesh->fraction_bits < 0 ||
        mesh->fraction_bits > GLINT_MAX_FRACTION_BITS) {
        return INVALID;
    }
    for (uint16_t t = 0; t < mesh->triangle_count; t++) {
        for (int k = 0; k < 3; k++) {
            if (mesh->triangles[t][k] >= mesh->vertex_count) {
                return INVALID;
            }
        }
    }
    return VALID;
}

static inline validity material_validity(const glint_material *m)
{
    if (m == NULL || m->exponent_q4 > GLINT_MAX_EXPONENT * 16 || m->specular_model > GLINT_BLINN) {
        return INVALID;
    }
    return both(colour_validity(&m->ambient, 16384),
                both(colour_validity(&m->diffuse, 16384), colour_validity(&m->specular, 16384)));
}

static inline validity light_validity(const glint_light *light)
{
    const bool still = light->direction[0] == 0 && light->direction[1] == 0 && light->direction[2] == 0;
    if (light->kind > GLINT_POINT || (light->kind == GLINT_DIRECTIONAL && still)) {
        return INVALID;
    }
    return both(colour_validity(&light->colour, INT16_MAX),
                light->kind == GLINT_POINT ? point_validity(light->position_q16) : VALID);
}

static inline validity display_validity(const glint_display *d)
{
    const uint32_t row = glint_row_bytes(d->format, d->width_px);
    const bool good = d->width_px >= 1 && d->width_px <= GLINT_MAX_SIZE_PX && d->height_px >= 1 &&
                      d->height_px <= GLINT_MAX_SIZE_PX && d->format <= GLINT_MONO_PAGES &&
                      d->dither <= GLINT_DITHER_BAYER && d->buffer_count <= 2 &&
                      (d->buffer_count < 2 || d->transfers != NULL) &&
                      (d->stride_bytes == 0 || d->stride_bytes >= row) &&
                      (d->stride_bytes % 2 == 0 || (d->format != GLINT_RGB565 && d->format != GLINT_RGB565_SWAPPED)) &&
                      (d->format != GLINT_MONO_PAGES || d->band_px % 8 == 0 || d->band_px >= d->height_px);
    return good ? VALID : INVALID;
}

static inline validity quality_validity(const glint_quality *q)
{
    const bool good =
        q->shading <= GLINT_SHADING_Q2 &&
        (q->tolerance == 0 || (q->tolerance >= GLINT_LEAST_TOLERANCE && q->shading == GLINT_SHADING_EXACT));
    return good ? VALID : INVALID;
}

static inline validity scene_case_validity(const scene_case *c)
{
    const glint_scene *scene = &c->scene;
    if (c->null != 0 || scene->light_count > GLINT_MAX_LIGHTS || (scene->object_count > 0 && scene->objects == NULL) ||
        (scene->light_count > 0 && scene->lights == NULL) || quality_validity(&c->quality) != VALID) {
        return INVALID;
    }
    validity v = both(camera_validity(scene->camera), display_validity(&c->display));
    v = both(v, both(colour_validity(&scene->ambient, INT16_MAX), colour_validity(&scene->background, 16384)));
    for (uint16_t i = 0; i < scene->object_count; i++) {
        v = both(v, both(mesh_validity(scene->objects[i].mesh), material_validity(scene->objects[i].material)));
        v = both(v, place_validity(&scene->objects[i].place));
    }
    for (uint16_t i = 0; i < scene->light_count; i++) {
        v = both(v, light_validity(&scene->lights[i]));
    }
    return v;
}

#endif
