/* SPDX-License-Identifier: MIT */
/*
 * What is done to the pixels of a triangle between shading and packing.
 */
#ifndef GLINT_EFFECTS_PIXEL_H
#define GLINT_EFFECTS_PIXEL_H

#include "effects/fog.h"
#include "effects/through.h"

typedef struct pixel_effects {
    const glint_fog_state *fog; /* NULL: none at this triangle */
    const glint_through *through; /* NULL: it is opaque */
    bool hidden;                  /* all of it lies in the fog: one colour */
    uint16_t error_q8;          /* what they add to the promise, 1/256 code */
} pixel_effects;

static inline bool pixel_effects_any(const pixel_effects *effects)
{
    return effects->fog != NULL || effects->through != NULL;
}

#endif
