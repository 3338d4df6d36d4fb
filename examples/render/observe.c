/* SPDX-License-Identifier: MIT */
/*
 * How each pixel of a frame was shaded: see observe.h. A pixel shows the last triangle that passed its depth test, so
 * the last note of it stands.
 */
#include "observe.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static observation *noted; /* where to */
static struct {
    uint8_t tier;
    uint16_t promise_q8;
    observed_run run;
} triangle; /* the one being drawn */

int observe_begin(observation *o, uint16_t width_px, uint16_t height_px)
{
    const size_t pixels = (size_t)width_px * height_px;
    *o = (observation){.width_px = width_px, .height_px = height_px};
    o->tier = malloc(pixels);
    o->promise_q8 = calloc(pixels, sizeof *o->promise_q8);
    if (o->tier == NULL || o->promise_q8 == NULL) {
        observation_free(o);
        return -1;
    }
    memset(o->tier, OBSERVED_BACKGROUND, pixels);
    noted = o;
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
    *o = (observation){0};
}

void observe_triangle(uint8_t tier, uint16_t promise_q8, observed_run run)
{
    triangle.tier = tier;
    triangle.promise_q8 = promise_q8;
    triangle.run = run;
}

void observe_run(struct shade_state *state, int16_t x, int16_t y, uint16_t count)
{
    assert(noted != NULL && x >= 0 && y >= 0 && x + count <= noted->width_px && y < noted->height_px);
    const size_t first = (size_t)y * noted->width_px + (size_t)x;
    for (size_t i = first; i < first + count; i++) {
        noted->tier[i] = triangle.tier;
        noted->promise_q8[i] = triangle.promise_q8;
    }
    triangle.run(state, x, y, count);
}
