/* SPDX-License-Identifier: MIT */
/*
 * What is done to the pixels of a triangle between shading and packing.
 */
#ifndef GLINT_EFFECTS_PIXEL_H
#define GLINT_EFFECTS_PIXEL_H

#include "effects/fog.h"
#include "effects/through.h"
#include "effects/wire.h"

typedef struct pixel_effects {
    const glint_fog_state *fog;   /* NULL: none at this triangle */
    const glint_through *through; /* NULL: it is opaque */
    const glint_wire *wire;       /* NULL: no line of this triangle is drawn */
    uint8_t line_count;           /* lines of the wire, */
    glint_wire_line line[3];
    uint16_t error_q8; /* what they add to the promise, 1/256 code */
} pixel_effects;

#endif
