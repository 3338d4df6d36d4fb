/* SPDX-License-Identifier: MIT */
/*
 * What a frame evaluated, by object and light, and how each pixel of it was shaded. Noted while an observing copy of a
 * backend draws (see observed_backend.h); the library itself keeps none of this.
 */
#ifndef EXAMPLES_RENDER_OBSERVE_H
#define EXAMPLES_RENDER_OBSERVE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <glint/display.h>
#include <glint/quality.h>
#include <glint/scene.h>

/* Of a pixel that no triangle covers. */
#define OBSERVED_BACKGROUND GLINT_TIERS

/* Times that a term was evaluated, or triangles. */
enum {
    OBSERVED_DIFFUSE,  /* n.s found */
    OBSERVED_SPECULAR, /* r.c or n.h found */
    OBSERVED_FOLDED,   /* triangles on which the diffuse term is part of one sum with others */
    OBSERVED_CULLED,   /* triangles, seen not to be reached by it, that do not evaluate it */
    OBSERVED_SHADOWS,  /* shadows of single triangles that it throws on others */
    OBSERVED_COUNTS
};

typedef struct observed_light {
    uint64_t count[OBSERVED_COUNTS];
} observed_light;

typedef struct observed_object {
    uint32_t tier_triangles[GLINT_TIERS], tier_pixels[GLINT_TIERS];
    uint32_t highlight_pixels; /* as glint_report.pixels_specular */
    uint32_t shadowed_pixels;
    uint32_t sky_pixels;          /* with light by the normal from sky and ground */
    uint32_t fog_pixels;          /* whose depth was looked up in the fog, */
    uint32_t hidden_pixels;       /* or that have its colour alone */
    uint32_t layer_pixels;        /* mixed with what is behind them */
    uint32_t wire_pixels;         /* of triangles with lines near enough to be looked for */
    uint64_t texture_texels;      /* read from textures, */
    uint64_t environment_lookups; /* and how often the environment was, 4 texels each time */
} observed_object;

typedef struct observation {
    uint16_t width_px, height_px;
    uint8_t *tier;            /* GLINT_TIER_UNLIT ..., or OBSERVED_BACKGROUND; rows from the top without gap */
    uint16_t *promise_q8;     /* 1/256 code; 65535: none is promised; 0 for the background */
    observed_object *objects; /* of the scene */
    observed_light *lights;   /* light_count for each object */
    uint16_t light_count;
    uint16_t *numbers; /* which lights the library's light states stand for */
} observation;

/* Makes an observation of a frame with nothing in it and notes in it from now on, until observe_end(). Returns 0, or -1
 * without memory. One at a time: the hooks have no context. */
int observe_begin(observation *o, const glint_scene *scene, uint16_t width_px, uint16_t height_px);
void observe_end(void);

/* Does nothing on a zeroed one. */
void observation_free(observation *o);

/* As glint_fixed_render() and glint_float_render(): the same pixels and report. */
int observed_fixed_render(const glint_scene *scene, const glint_display *display, const glint_quality *quality,
                          void *memory, size_t memory_bytes, glint_report *report);
int observed_float_render(const glint_scene *scene, const glint_display *display, const glint_quality *quality,
                          void *memory, size_t memory_bytes, glint_report *report);

/* What a copy calls: before the pixels of a triangle, with the function that shades them; and in that one's place. */
struct shade_state;
typedef void (*observed_run)(struct shade_state *state, int16_t x, int16_t y, uint16_t count);
typedef struct observed_triangle {
    uint16_t object;
    uint8_t tier;
    uint16_t promise_q8;
    observed_run run;
    const glint_report *report; /* of the frame, up to now */
    const char *lights;         /* the light states of the object; of these each pixel finds n.s: */
    const uint16_t *crossing;
    uint8_t crossing_count;
    const glint_texture *texture; /* NULL: none is sampled */
    bool sky, fog, hidden, layer, wire;
} observed_triangle;
void observe_triangle(const observed_triangle *drawn);
void observe_run(struct shade_state *state, int16_t x, int16_t y, uint16_t count);

/* And as things are evaluated; `state` is a light state. See GLINT_COUNT in src/number/integer.h. */
void observe_object(uint16_t number);
void observe_light(const void *state, size_t bytes, uint16_t number);
uint16_t observe_number(const void *state);
void observe_term(const void *state, int term, uint32_t times);
void observe_gaps(const void *state, const uint32_t *gap_q28, uint16_t count);
void observe_measured(const void *state, int term);
void observe_set_up(uint8_t tier, bool by_measure); /* does the triangle do by what was found of its lights? */
void observe_shadow(const void *state, uint32_t tests);
void observe_mirror(uint32_t times);

#endif
