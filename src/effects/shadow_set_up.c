/* SPDX-License-Identifier: MIT */
/*
 * What shadows need of a scene, once a frame: lights and objects on the grid, coarse vertices and boxes.
 */
#include <stddef.h>
#include <string.h>

#include "effects/shadow_plane.h"

uint16_t glint_shadow_light_count(const glint_scene *scene)
{
    uint16_t count = 0;
    for (uint16_t i = 0; i < scene->light_count; i++) {
        count = (uint16_t)(count + scene->lights[i].casts_shadows);
    }
    return count;
}

/* Boxes of a mesh: of GLINT_SHADOW_LEAF triangles each, then of two of these, up to one of all. */
static uint32_t box_count(const glint_mesh *mesh)
{
    uint32_t level = ((uint32_t)mesh->triangle_count + GLINT_SHADOW_LEAF - 1) / GLINT_SHADOW_LEAF, count = level;
    while (level > 1) {
        level = (level + 1) / 2;
        count += level;
    }
    return count;
}

static uint32_t coarse_bytes(uint32_t vertices)
{
    return (vertices * 6 + 3) & ~(uint32_t)3;
}

static uint32_t mask_words(uint16_t width_px)
{
    return (width_px + 31u) / 32;
}

uint64_t glint_shadow_bytes(const glint_scene *scene, uint16_t width_px, uint16_t band_px)
{
    const uint64_t lights = glint_shadow_light_count(scene);
    uint64_t of_meshes = 0;
    for (uint16_t i = 0; i < scene->object_count; i++) {
        const glint_mesh *mesh = scene->objects[i].mesh;
        of_meshes += box_count(mesh) * (uint64_t)sizeof(glint_shadow_box) + coarse_bytes(mesh->vertex_count);
    }
    return lights == 0
               ? 0
               : scene->object_count * (uint64_t)sizeof(glint_shadow_object) +
                     lights * (sizeof(glint_shadow_light) + mask_words(width_px) * 4u * (uint64_t)band_px) + of_meshes;
}

/* A light as an object of one point: its position, or the tip of a vector along x. */
static const glint_mesh point_mesh = {.vertex_count = 1, .fraction_bits = GLINT_MAX_FRACTION_BITS};

static void light_transform(glint_transform *transform, const glint_light *light, const glint_view *view)
{
    glint_object point;
    memset(&point, 0, sizeof point);
    point.mesh = &point_mesh;
    for (int k = 0; k < 3; k++) {
        if (light->kind == GLINT_DIRECTIONAL) {
            point.place.linear_q16[k][0] = -(int32_t)light->direction[k] * (1 << 10);
            point.place.origin_q16[k] = view->eye_q16[k];
        } else {
            point.place.origin_q16[k] = light->position_q16[k];
        }
    }
    glint_transform_set_up(transform, view, &point);
}

static int16_t smaller(int16_t a, int16_t b)
{
    return a < b ? a : b;
}

void glint_shadow_shear(const glint_shadows *shadows, const int32_t p[3], int32_t out[3])
{
    const int a = shadows->along;
    for (int k = 0; k < 3; k++) {
        out[k] = p[k];
        if (k != a) { /* (|v_a| p_b - v_b p_a) / 2^30, each rounded down, doubled; p and v reach 2^29 */
            out[k] = 2 * (multiply_high_s32(p[k] * 2, shadows->shear[a] * 2) -
                          multiply_high_s32(p[a] * 2, shadows->shear[k] * 2));
        }
        GLINT_TRACE("shadow sheared", out[k]);
    }
}

/* Shears along this light, or with NULL not at all. */
static void shear_set_up(glint_shadows *shadows, glint_shadow_light *light)
{
    static const int32_t none[3] = {0, 0, (int32_t)1 << 29};
    const int32_t *const v = light ? light->v : none;
    int a = 2;
    for (int k = 0; k < 2; k++) {
        a = magnitude32(v[k]) > magnitude32(v[a]) ? k : a;
    }
    shadows->along = (uint8_t)a;
    for (int k = 0; k < 3; k++) {
        shadows->shear[k] = v[a] < 0 ? -v[k] : v[k];
    }
    if (light) {
        light->sheared = true;
    }
}

static void light_set_up(glint_shadow_light *out, const glint_shadows *shadows, const glint_light *light,
                         const glint_view *view)
{
    glint_transform t;
    light_transform(&t, light, view);
    const int xy = shadows->xy_fraction - t.xy_fraction, z = shadows->z_fraction - t.z_fraction;
    out->directional = light->kind == GLINT_DIRECTIONAL;
    out->falls = out->sheared = false;
    if (out->directional) {
        const int most = xy > z ? xy : z;
        const int64_t v[3] = {glint_shift_round64((int64_t)t.x[0] * ((int64_t)1 << 30), xy - most),
                              glint_shift_round64((int64_t)t.y[0] * ((int64_t)1 << 30), xy - most),
                              glint_shift_round64((int64_t)t.z[0] * ((int64_t)1 << 30), z - most)};
        (void)shadow_narrow(v, true, out->v);
    } else {
        out->v[0] = shift_round32(t.x[3], -xy);
        out->v[1] = shift_round32(t.y[3], -xy);
        out->v[2] = shift_round32(t.z[3], -z);
    }
}

static void object_set_up(glint_shadow_object *out, const glint_shadows *shadows, const glint_transform *t,
                          const glint_object *object)
{
    for (int k = 0; k < 4; k++) {
        out->row[0][k] = shift_round32(t->x[k], t->xy_fraction - shadows->xy_fraction);
        out->row[1][k] = shift_round32(t->y[k], t->xy_fraction - shadows->xy_fraction);
        out->row[2][k] = shift_round32(t->z[k], t->z_fraction - shadows->z_fraction);
    }
    out->mesh = object->mesh;
    out->casts = (object->material->shadows & GLINT_CASTS_NO_SHADOW) == 0;
    out->own_front = object->material->sides != GLINT_FRONT_SIDE;
}

void glint_shadow_vertex(const glint_shadow_object *object, uint16_t vertex, int32_t out[3])
{
    int16_t p[3];
    for (int k = 0; k < 3; k++) {
        p[k] = flash_s16(&object->mesh->positions[vertex][k]);
    }
    for (int k = 0; k < 3; k++) {
        const int32_t *row = object->row[k];
        out[k] = multiply_q16(row[0], p[0]) + multiply_q16(row[1], p[1]) + multiply_q16(row[2], p[2]) + row[3];
        GLINT_TRACE("shadow position", out[k]);
    }
}

/* The box of a part of a mesh. */
static void box_clear(glint_shadow_box *box)
{
    for (int k = 0; k < 3; k++) {
        box->low[k] = INT16_MAX;
        box->high[k] = INT16_MIN;
    }
}

static void box_add(glint_shadow_box *box, const int16_t low[3], const int16_t high[3])
{
    for (int k = 0; k < 3; k++) {
        box->low[k] = low[k] < box->low[k] ? low[k] : box->low[k];
        box->high[k] = high[k] > box->high[k] ? high[k] : box->high[k];
    }
}

/* Coarse vertices, and the boxes over them. */
static void mesh_set_up(glint_shadow_object *object, const glint_shadows *shadows)
{
    const glint_mesh *mesh = object->mesh;
    for (uint16_t v = 0; v < mesh->vertex_count; v++) {
        int32_t fine[3], sheared[3];
        glint_shadow_vertex(object, v, fine);
        glint_shadow_shear(shadows, fine, sheared);
        for (int k = 0; k < 3; k++) {
            object->coarse[v][k] = (int16_t)(sheared[k] >> shadows->coarse_bits[k]);
        }
    }
    uint32_t level = 0;
    for (uint16_t first = 0; first < mesh->triangle_count; level++) {
        const uint16_t left = (uint16_t)(mesh->triangle_count - first);
        const uint16_t count = left < GLINT_SHADOW_LEAF ? left : GLINT_SHADOW_LEAF;
        box_clear(&object->box[level]);
        for (uint16_t i = 0; i < 3 * count; i++) {
            const int16_t *at = object->coarse[flash_u16(&mesh->triangles[first + i / 3][i % 3])];
            box_add(&object->box[level], at, at);
        }
        if (left <= GLINT_SHADOW_LEAF) {
            level++;
            break;
        }
        first = (uint16_t)(first + count);
    }
    glint_shadow_box *from = object->box;
    while (level > 1) {
        glint_shadow_box *const to = from + level;
        for (uint32_t i = 0; i < level; i++) {
            if (i % 2 == 0) {
                to[i / 2] = from[i];
            } else {
                box_add(&to[i / 2], from[i].low, from[i].high);
            }
        }
        from = to;
        level = (level + 1) / 2;
    }
}

/* How far down coordinates are shifted to have 16 bits, and what rounding may make of a height then. */
static void coarse_set_up(glint_shadows *shadows)
{
    uint32_t any[3] = {0, 0, 0};
    for (uint16_t i = 0; i < shadows->object_count; i++) {
        for (uint16_t v = 0; v < shadows->objects[i].mesh->vertex_count; v++) {
            int32_t fine[3], sheared[3];
            glint_shadow_vertex(&shadows->objects[i], v, fine);
            glint_shadow_shear(shadows, fine, sheared);
            for (int k = 0; k < 3; k++) {
                any[k] |= magnitude32(sheared[k]);
            }
        }
    }
    for (int k = 0; k < 3; k++) {
        const int bits = 32 - clz32(any[k] | 1);
        shadows->coarse_bits[k] = (uint8_t)(bits > 15 ? bits - 15 : 0);
    }
}

void glint_shadows_set_up(glint_shadows *shadows, const glint_scene *scene, const glint_view *view, uint8_t *memory,
                          uint16_t band_px)
{
    glint_transform t;
    shadows->object_count = scene->object_count;
    shadows->light_count = glint_shadow_light_count(scene);
    shadows->words = (uint16_t)mask_words(view->width_px);
    shadows->width_px = view->width_px;
    shadows->height_px = view->height_px;
    shadows->tests = 0;
    shadows->objects = (glint_shadow_object *)(void *)memory;
    shadows->lights = (glint_shadow_light *)(void *)(shadows->objects + shadows->object_count);
    uint8_t *free_part = (uint8_t *)(void *)(shadows->lights + shadows->light_count);

    /* the grid: the coarsest of all, and one bit less, so that differences have 30 bits */
    shadows->xy_fraction = shadows->z_fraction = INT16_MAX;
    for (uint16_t i = 0; i < scene->light_count; i++) {
        if (scene->lights[i].casts_shadows && scene->lights[i].kind != GLINT_DIRECTIONAL) {
            light_transform(&t, &scene->lights[i], view);
            shadows->xy_fraction = smaller(shadows->xy_fraction, (int16_t)(t.xy_fraction - 1));
            shadows->z_fraction = smaller(shadows->z_fraction, (int16_t)(t.z_fraction - 1));
        }
    }
    for (uint16_t i = 0; i < scene->object_count; i++) {
        glint_transform_set_up(&t, view, &scene->objects[i]);
        shadows->xy_fraction = smaller(shadows->xy_fraction, (int16_t)(t.xy_fraction - 1));
        shadows->z_fraction = smaller(shadows->z_fraction, (int16_t)(t.z_fraction - 1));
    }
    for (uint16_t i = 0; i < scene->object_count; i++) {
        glint_frame frame;
        glint_shadow_object *object = &shadows->objects[i];
        glint_transform_set_up(&t, view, &scene->objects[i]);
        glint_frame_set_up(&frame, view, &scene->objects[i]);
        object_set_up(object, shadows, &t, &scene->objects[i]);
        object->mirrored = frame.mirrored;
        object->box = (glint_shadow_box *)(void *)free_part;
        free_part += box_count(object->mesh) * sizeof(glint_shadow_box);
        object->coarse = (int16_t(*)[3])(void *)free_part;
        free_part += coarse_bytes(object->mesh->vertex_count);
    }
    uint32_t *mask = (uint32_t *)(void *)free_part;
    glint_shadow_light *light = shadows->lights, *along = NULL;
    for (uint16_t i = 0; i < scene->light_count; i++) {
        if (scene->lights[i].casts_shadows) {
            light_set_up(light, shadows, &scene->lights[i], view);
            along = along == NULL && light->directional ? light : along;
            light++->mask = mask;
            mask += (uint32_t)shadows->words * band_px;
        }
    }
    shear_set_up(shadows, along);
    coarse_set_up(shadows);
    for (uint16_t i = 0; i < scene->object_count; i++) {
        mesh_set_up(&shadows->objects[i], shadows);
    }
}
