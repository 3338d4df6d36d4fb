/* SPDX-License-Identifier: MIT */
/*
 * Is a scene valid by the letter of the public headers? Written from them alone, in floating point where they speak of
 * angles and determinants, so that it shares no code and no arithmetic with src/validate.inc.
 */
#ifndef GLINT_TESTS_FUZZ_SCENE_VALIDITY_H
#define GLINT_TESTS_FUZZ_SCENE_VALIDITY_H

#include "tests/fuzz/scene_faults.h"

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

static inline validity texture_validity(const glint_texture *t, const glint_mesh *mesh)
{
    const bool coded = t->format == GLINT_TEXTURE_PALETTE8;
    const bool good = t->format <= GLINT_TEXTURE_PALETTE8 && t->width_px >= 1 && t->width_px <= 1024 &&
                      t->height_px >= 1 && t->height_px <= 1024 && t->texels != NULL &&
                      (!coded || (t->palette != NULL && t->palette_count >= 1 && t->palette_count <= 256)) &&
                      t->filter <= GLINT_BILINEAR && t->wrap_u <= GLINT_CLAMP && t->wrap_v <= GLINT_CLAMP &&
                      mesh->texcoords != NULL && mesh->texcoord_bits >= 9 && mesh->texcoord_bits <= 15;
    return good ? VALID : INVALID;
}

static inline bool is_black(const glint_colour *c)
{
    return c->r_q14 == 0 && c->g_q14 == 0 && c->b_q14 == 0;
}

static inline validity material_validity(const glint_material *m, const glint_scene *scene)
{
    if (m == NULL || m->exponent_q4 > GLINT_MAX_EXPONENT * 16 || m->specular_model > GLINT_BLINN ||
        m->sides > GLINT_TWO_SIDED || m->shadows > 3 || m->transmission_q14 > 16384 || m->wire_width_q4 > 4096 ||
        (!is_black(&m->mirror) && scene->environment == NULL)) {
        return INVALID;
    }
    const glint_colour *const colours[] = {&m->ambient, &m->diffuse, &m->specular, &m->emission,
                                           &m->mirror,  &m->grazing, &m->wire};
    validity v = VALID;
    for (size_t i = 0; i < sizeof colours / sizeof *colours; i++) {
        v = both(v, colour_validity(colours[i], 16384));
    }
    return v;
}

static inline bool distance_is_good(uint32_t distance_q16)
{
    return distance_q16 == 0 || (distance_q16 / 65536.0 >= 1 / 256.0 && distance_q16 / 65536.0 <= 16384);
}

static inline validity extent_validity(const glint_light *light)
{
    const double most = 16384.0 * 65536;
    for (int k = 0; k < 3; k++) {
        const double extent = light->kind == GLINT_BALL
                                  ? light->radius_q16
                                  : fabs((double)light->edge_q16[0][k]) + fabs((double)light->edge_q16[1][k]);
        if (extent < 0 || fabs((double)light->position_q16[k]) + extent > most) {
            return INVALID;
        }
    }
    return light->samples <= 64 && !light->casts_shadows ? VALID : INVALID;
}

static inline validity light_validity(const glint_light *light)
{
    const bool still = light->direction[0] == 0 && light->direction[1] == 0 && light->direction[2] == 0;
    const validity colour = colour_validity(&light->colour, INT16_MAX);
    switch (light->kind) {
    case GLINT_DIRECTIONAL:
        return still ? INVALID : colour;
    case GLINT_SPOT:
        if (still || light->outer_turn16 > 65536 / 4 || light->outer_turn16 - light->inner_turn16 < 182) {
            return INVALID;
        }
        break;
    case GLINT_PANEL:
    case GLINT_BALL:
        if (extent_validity(light) != VALID) {
            return INVALID;
        }
        break;
    case GLINT_POINT:
        break;
    default:
        return INVALID;
    }
    if (!distance_is_good(light->attenuation.unit_q16) || !distance_is_good(light->attenuation.range_q16)) {
        return INVALID;
    }
    return both(colour, point_validity(light->position_q16));
}

static inline validity fog_validity(const glint_fog *fog)
{
    const double begin = fog->begin_q16 / 65536.0, end = fog->end_q16 / 65536.0;
    const bool none = fog->begin_q16 == 0 && fog->end_q16 == 0;
    const bool good = begin >= 0 && end <= 16384 && end - begin >= 1 / 256.0;
    return none ? VALID : good ? colour_validity(&fog->colour, 16384) : INVALID;
}

static inline validity environment_validity(const glint_environment *e)
{
    const bool good =
        e == NULL ||
        (e->texels != NULL && (e->side == 8 || e->side == 16 || e->side == 32 || e->side == 64 || e->side == 128));
    return good ? VALID : INVALID;
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
    v = both(v, both(colour_validity(&scene->sky, INT16_MAX), colour_validity(&scene->ground, INT16_MAX)));
    v = both(v, both(fog_validity(&scene->fog), environment_validity(scene->environment)));
    for (uint16_t i = 0; i < scene->object_count; i++) {
        const glint_object *o = &scene->objects[i];
        v = both(v, both(mesh_validity(o->mesh), material_validity(o->material, scene)));
        v = both(v, place_validity(&o->place));
        if (v != INVALID && o->material->texture != NULL) {
            v = both(v, texture_validity(o->material->texture, o->mesh));
        }
    }
    for (uint16_t i = 0; i < scene->light_count; i++) {
        v = both(v, light_validity(&scene->lights[i]));
    }
    return v;
}

/* Has the variant all that the (valid) scene asks for? Exact shading; `whole_phong` of the specular term and of point
 * lights, else of neither; no effect but emission, which is part of the ambient term. */
static inline bool variant_has_all(const scene_case *c, bool whole_phong)
{
    const glint_scene *scene = &c->scene;
    if (c->quality.shading != GLINT_SHADING_EXACT || c->quality.tolerance != 0 || !is_black(&scene->sky) ||
        !is_black(&scene->ground) || scene->fog.end_q16 != 0) {
        return false;
    }
    for (uint16_t i = 0; i < scene->light_count; i++) {
        const glint_light *l = &scene->lights[i];
        const uint16_t *k = l->attenuation.k_q14;
        if (l->casts_shadows || l->kind > GLINT_POINT ||
            (l->kind == GLINT_POINT &&
             (!whole_phong || l->attenuation.range_q16 != 0 || k[0] != 0 || k[1] != 0 || k[2] != 0))) {
            return false;
        }
    }
    for (uint16_t i = 0; i < scene->object_count; i++) {
        const glint_material *m = scene->objects[i].material;
        if ((!whole_phong && !is_black(&m->specular)) || !is_black(&m->mirror) || m->sides != GLINT_FRONT_SIDE ||
            m->transmission_q14 != 0 || m->wire_width_q4 != 0 || m->texture != NULL) {
            return false;
        }
    }
    return true;
}

#endif
