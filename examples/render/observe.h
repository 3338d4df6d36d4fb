/* SPDX-License-Identifier: MIT */
/*
 * How each pixel of a frame was shaded: the tier of the triangle that it shows, and the error promised for it. Noted
 * while an observing copy of a backend draws (see observed_backend.h); the library itself keeps none of this.
 */
#ifndef EXAMPLES_RENDER_OBSERVE_H
#define EXAMPLES_RENDER_OBSERVE_H

#include <stddef.h>
#include <stdint.h>

#include <glint/display.h>
#include <glint/quality.h>
#include <glint/scene.h>

/* Of a pixel that no triangle covers. */
#define OBSERVED_BACKGROUND GLINT_TIERS

typedef struct observation {
    uint16_t width_px, height_px;
    uint8_t *tier;        /* GLINT_TIER_UNLIT ..., or OBSERVED_BACKGROUND; rows from the top without gap */
    uint16_t *promise_q8; /* 1/256 code; 65535: none is promised; 0 for the background */
} observation;

/* Makes an observation of a frame with nothing in it and notes in it from now on, until observe_end(). Returns 0, or -1
 * without memory. One at a time: the hook that tells of pixels has no context. */
int observe_begin(observation *o, uint16_t width_px, uint16_t height_px);
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
void observe_triangle(uint8_t tier, uint16_t promise_q8, observed_run run);
void observe_run(struct shade_state *state, int16_t x, int16_t y, uint16_t count);

#endif
