/* SPDX-License-Identifier: MIT */
#include "memory.h"

#include "effects/shadow.h"
#include "lighting/source.h"
#include "raster/bands.h"
#include "raster/edges.h"

static uint64_t whole_words(uint64_t bytes)
{
    return (bytes + 3) & ~(uint64_t)3;
}

/* Does it depend on the place how much of a light arrives? */
static bool light_reaches(const glint_light *light)
{
    const glint_attenuation *a = &light->attenuation;
    return light->kind == GLINT_SPOT ||
           (light->kind != GLINT_DIRECTIONAL && (a->range_q16 != 0 || (a->k_q14[0] | a->k_q14[1] | a->k_q14[2]) != 0));
}

bool glint_mirrors(const glint_material *material)
{
    return material != NULL && (material->mirror.r_q14 | material->mirror.g_q14 | material->mirror.b_q14) != 0;
}

void glint_memory_needs(glint_needs *needs, const glint_scene *scene, const glint_display *display,
                        const glint_state_bytes *bytes)
{
    const uint16_t height = display->height_px;
    const uint16_t band = display->band_px == 0 || display->band_px > height ? height : display->band_px;
    const uint16_t rows = display->format == GLINT_MONO_PAGES ? (uint16_t)((band + 7u) / 8) : band;
    uint64_t vertex_count = 0;
    uint64_t triangle_count = 0, mirror_count = 0;
    for (uint16_t i = 0; i < scene->object_count; i++) {
        vertex_count += scene->objects[i].mesh->vertex_count;
        /* a see-through object of two sides is gone through twice */
        const glint_material *material = scene->objects[i].material;
        const bool twice = material != NULL && material->transmission_q14 != 0 && material->sides != GLINT_FRONT_SIDE;
        triangle_count += (uint32_t)scene->objects[i].mesh->triangle_count * (twice ? 2u : 1u);
        mirror_count += material != NULL && glint_mirrors(material);
    }
    needs->stride = display->stride_bytes ? display->stride_bytes : glint_row_bytes(display->format, display->width_px);
    needs->band_px = band;
    needs->band_count = (uint16_t)((height + band - 1u) / band);
    needs->buffer = (uint32_t)whole_words((uint64_t)rows * needs->stride);
    needs->buffers = (uint64_t)needs->buffer * (display->buffer_count == 2 ? 2 : 1);
    needs->depth = whole_words((uint64_t)display->width_px * band * 2);
    needs->drawing = whole_words(bytes->drawing);
    needs->objects = (uint64_t)scene->object_count * whole_words(bytes->object);
    needs->shadows = bytes->shadow == 0 ? 0 : glint_shadow_bytes(scene, display->width_px, band);
    needs->shadows += needs->shadows ? whole_words(bytes->shadow) : 0;
    needs->light_count = needs->reach_count = 0;
    for (uint16_t i = 0; i < scene->light_count; i++) {
        const uint8_t points = glint_source_most(&scene->lights[i]);
        needs->light_count = (uint16_t)(needs->light_count + points);
        needs->reach_count = (uint16_t)(needs->reach_count + (light_reaches(&scene->lights[i]) ? points : 0));
    }
    /* with shadows, one of each light once more: see effects/shadow.inc */
    needs->lights =
        (scene->object_count + (uint64_t)(needs->shadows != 0)) * needs->light_count * whole_words(bytes->light);
    needs->reaches = (uint64_t)scene->object_count * needs->reach_count * whole_words(bytes->reach);
    needs->mirrors = mirror_count * whole_words(bytes->mirror);
    needs->texture = 0;
    for (uint16_t i = 0; i < scene->object_count && needs->texture == 0; i++) {
        const glint_material *material = scene->objects[i].material;
        needs->texture = material != NULL && material->texture != NULL ? (uint32_t)whole_words(bytes->texture) + 4 : 0;
    }
    needs->triangle_count = (uint32_t)triangle_count; /* at most 65535^2 */
    needs->bands = needs->band_count > 1 && triangle_count < GLINT_NO_TRIANGLE
                       ? whole_words((triangle_count + needs->band_count) * 2)
                       : 0;
    needs->vertices = vertex_count * sizeof(glint_screen_vertex);
    needs->least = needs->drawing + needs->objects + needs->lights + needs->shadows + needs->reaches + needs->mirrors +
                   needs->texture + needs->buffers + needs->depth;
    needs->full = needs->least + needs->bands + needs->vertices;
}
