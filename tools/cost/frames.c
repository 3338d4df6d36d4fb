/* SPDX-License-Identifier: MIT */
#include "tools/cost/cases.h"

#include <string.h>

#include <glint/fixed.h>
#include <glint/float.h>
#include <glint/memory.h>

#include "tests/target/selftest.h"

const char *const cost_backend_names[COST_BACKENDS] = {"fixed", "float"};

/* Both backends do not fit the AVR's 128 KB; the one that program.c counts there stands in for the other, too. */
#if !defined(__AVR__)
#define FIXED(function) glint_fixed_##function
#define FLOAT(function) glint_float_##function
#elif defined(FRAMES_IN_FLOAT)
#define FIXED(function) glint_float_##function
#define FLOAT(function) glint_float_##function
#else
#define FIXED(function) glint_fixed_##function
#define FLOAT(function) glint_fixed_##function
#endif

glint_scene cost_scene(const cost_case *c)
{
    glint_scene scene = *c->data;
    if (c->lights) {
        scene.lights = c->lights;
        scene.light_count = c->light_count;
    }
    return scene;
}

static glint_display display_of(const cost_case *c, uint8_t format)
{
    const glint_display display = {
        .width_px = c->width_px, .height_px = c->height_px, .band_px = c->band_px, .format = format};
    return display;
}

/* Room for the triangles that reach from band to band: the square root of how many there are, rounded up. */
static size_t kept_bytes(const glint_scene *scene)
{
    uint32_t triangles = 0, root = 0;
    for (uint16_t i = 0; i < scene->object_count; i++) {
        triangles += scene->objects[i].mesh->triangle_count;
    }
    while (root * root < triangles) {
        root++;
    }
    return (size_t)root * GLINT_KEPT_WORDS * sizeof(uint32_t);
}

size_t cost_frame_full_bytes(const cost_case *c, int backend, uint8_t format)
{
    const glint_scene scene = cost_scene(c);
    const glint_display display = display_of(c, format);
    return backend == COST_FIXED ? FIXED(memory_bytes)(&scene, &display) : FLOAT(memory_bytes)(&scene, &display);
}

size_t cost_frame_bytes(const cost_case *c, int backend, uint8_t format)
{
    const glint_scene scene = cost_scene(c);
    const size_t tables =
        c->quality.tolerance ? (size_t)scene.object_count * GLINT_RAMP_WORDS * sizeof(uint32_t) : (size_t)0;
    const size_t kept = c->band_px != 0 && c->band_px < c->height_px ? kept_bytes(&scene) : (size_t)0;
    const size_t bytes = cost_frame_full_bytes(c, backend, format);
    return bytes == 0 ? 0 : bytes + tables + kept;
}

size_t cost_frame_least_bytes(const cost_case *c, int backend, uint8_t format)
{
    const glint_scene scene = cost_scene(c);
    const glint_display display = display_of(c, format);
    return backend == COST_FIXED ? FIXED(memory_least_bytes)(&scene, &display)
                                 : FLOAT(memory_least_bytes)(&scene, &display);
}

int cost_draw(const cost_case *c, int backend, uint8_t format, glint_flush flush, void *context, void *memory,
              size_t memory_bytes, glint_report *report)
{
    const glint_scene scene = cost_scene(c);
    glint_display display = display_of(c, format);
    display.flush = flush;
    display.context = context;
    return backend == COST_FIXED ? FIXED(render)(&scene, &display, &c->quality, memory, memory_bytes, report)
                                 : FLOAT(render)(&scene, &display, &c->quality, memory, memory_bytes, report);
}

int cost_hash_band(void *context, const glint_band *band)
{
    uint64_t hash;
    memcpy(&hash, context, sizeof hash);
    for (uint32_t i = 0; i < band->bytes; i += 2) {
        uint16_t value;
        memcpy(&value, (const uint8_t *)band->pixels + i, sizeof value);
        hash = hash_bytes(hash, value, 2);
    }
    memcpy(context, &hash, sizeof hash);
    return 0;
}
