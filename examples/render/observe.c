/* SPDX-License-Identifier: MIT */
/*
 * What a frame evaluated: see observe.h. Of the tier and the promise of a pixel the last note stands, since it shows
 * the last triangle that passed its depth test.
 */
#include "observe.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include <glint/config.h>

static observation *noted; /* where to */
static struct {
    const char *first; /* of the light states, which lie side by side, */
    size_t bytes;      /* of so many bytes each */
} states;
static observed_triangle triangle; /* the one being drawn */
static uint16_t object;            /* whose it is */
static uint32_t shadow_tests;      /* of the lights before, on this triangle */
static struct {
    uint16_t count;
    uint16_t number[GLINT_MAX_LIGHTS];
    uint8_t term[GLINT_MAX_LIGHTS];
} measured; /* what was found of its lights */

int observe_begin(observation *o, const glint_scene *scene, uint16_t width_px, uint16_t height_px)
{
    const size_t pixels = (size_t)width_px * height_px, objects = scene->object_count, lights = scene->light_count;
    *o = (observation){.width_px = width_px, .height_px = height_px, .light_count = scene->light_count};
    o->tier = malloc(pixels);
    o->promise_q8 = calloc(pixels, sizeof *o->promise_q8);
    o->objects = calloc(objects + 1, sizeof *o->objects);
    o->lights = calloc(objects * lights + 1, sizeof *o->lights);
    /* as many as may stand for all lights of all objects, and of one object more, whose copies shadows take from */
    o->numbers = calloc((objects + 1) * lights * GLINT_MAX_SAMPLES + 1, sizeof *o->numbers);
    if (o->tier == NULL || o->promise_q8 == NULL || o->objects == NULL || o->lights == NULL || o->numbers == NULL) {
        observation_free(o);
        return -1;
    }
    memset(o->tier, OBSERVED_BACKGROUND, pixels);
    noted = o;
    states.first = NULL;
    measured.count = 0;
    shadow_tests = 0;
    return 0;
}

void observe_end(void)
{
    noted = NULL;
}

void observation_free(observation *o)
{
    free(o->tier);
    free(o->promise_q8);
    free(o->objects);
    free(o->lights);
    free(o->numbers);
    *o = (observation){0};
}

/* ------------------------------------------------------------------------------------------------------------- lights
 */

/* The first one that is told has the lowest address: objects are prepared in their order. */
void observe_light(const void *state, size_t bytes, uint16_t number)
{
    if (states.first == NULL) {
        states.first = state;
        states.bytes = bytes;
    }
    noted->numbers[(size_t)((const char *)state - states.first) / states.bytes] = number;
}

uint16_t observe_number(const void *state)
{
    return noted->numbers[(size_t)((const char *)state - states.first) / states.bytes];
}

static uint64_t *count_of(uint16_t light, int term)
{
    return &noted->lights[(size_t)object * noted->light_count + light].count[term];
}

void observe_term(const void *state, int term, uint32_t times)
{
    *count_of(observe_number(state), term) += times;
}

void observe_gaps(const void *state, const uint32_t *gap_q28, uint16_t count)
{
    uint32_t found = 0;
    for (uint16_t i = 0; i < count; i++) {
        found += gap_q28[i] != UINT32_MAX;
    }
    observe_term(state, OBSERVED_SPECULAR, found);
}

void observe_shadow(const void *state, uint32_t tests)
{
    *count_of(observe_number(state), OBSERVED_SHADOWS) += tests - shadow_tests;
    shadow_tests = tests;
}

void observe_mirror(uint32_t times)
{
    noted->objects[object].environment_lookups += times;
}

/* ---------------------------------------------------------------------------------------------------------- triangles
 */

void observe_object(uint16_t number)
{
    object = number;
    measured.count = 0;
}

/* What is found of a light counts if the triangle's tier makes use of it. */
void observe_measured(const void *state, int term)
{
    if (measured.count < GLINT_MAX_LIGHTS) {
        measured.number[measured.count] = observe_number(state);
        measured.term[measured.count++] = (uint8_t)term;
    }
}

void observe_set_up(uint8_t tier, bool by_measure)
{
    noted->objects[object].tier_triangles[tier]++;
    for (uint16_t i = 0; i < measured.count; i++) {
        if (by_measure &&
            (measured.term[i] == OBSERVED_CULLED || (tier != GLINT_TIER_EXACT && tier >= GLINT_TIER_CURVED))) {
            (*count_of(measured.number[i], measured.term[i]))++;
        }
    }
}

void observe_triangle(const observed_triangle *drawn)
{
    triangle = *drawn;
    object = drawn->object;
    shadow_tests = 0;
}

void observe_run(struct shade_state *state, int16_t x, int16_t y, uint16_t count)
{
    assert(noted != NULL && x >= 0 && y >= 0 && x + count <= noted->width_px && y < noted->height_px);
    observed_object *const of = &noted->objects[object];
    const size_t first = (size_t)y * noted->width_px + (size_t)x;
    for (size_t i = first; i < first + count; i++) {
        noted->tier[i] = triangle.tier;
        noted->promise_q8[i] = triangle.promise_q8;
    }
    of->tier_pixels[triangle.tier] += count;
    for (uint8_t i = 0; i < triangle.crossing_count; i++) {
        observe_term(triangle.lights + triangle.crossing[i] * states.bytes, OBSERVED_DIFFUSE, count);
    }
    if (triangle.texture != NULL) {
        of->texture_texels += (uint64_t)count * (triangle.texture->filter == GLINT_BILINEAR ? 4 : 1);
    }
    of->sky_pixels += triangle.sky ? count : 0;
    of->fog_pixels += triangle.fog ? count : 0;
    of->hidden_pixels += triangle.hidden ? count : 0;
    of->layer_pixels += triangle.layer ? count : 0;
    of->wire_pixels += triangle.wire ? count : 0;
    const uint32_t highlights = triangle.report->pixels_specular, shadowed = triangle.report->pixels_shadowed;
    triangle.run(state, x, y, count);
    of->highlight_pixels += triangle.report->pixels_specular - highlights;
    of->shadowed_pixels += triangle.report->pixels_shadowed - shadowed;
}
