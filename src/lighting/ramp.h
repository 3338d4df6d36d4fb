/* SPDX-License-Identifier: MIT */
/*
 * Ramps: where all lights have one chromaticity, the colour of a material under them is a function of one number, the
 * light that it reflects, and one table of colours serves for three channels.
 *
 *     colour = ambient and emission + t full,   t = sum_j share_j cosine_j in 0..1,   full = the sum of all lights at
 * cosine 1
 *
 * t is cut into GLINT_RAMP_STEPS equal parts, of which each gets the colour of its middle. Indices go a little beyond,
 * for cosines that an approximation takes above 1.
 *
 * Integers, compiled once for both backends.
 */
#ifndef GLINT_LIGHTING_RAMP_H
#define GLINT_LIGHTING_RAMP_H

#include <stdbool.h>
#include <stdint.h>

#include <glint/scene.h>

#include "display/pack.h"

#define GLINT_RAMP_STEPS 960    /* of t = 0..1 */
#define GLINT_RAMP_ENTRIES 1024 /* t = 1 is at 960 of 1024, so that a sixteenth more has room */

typedef struct glint_ramp {
    uint32_t base_q27[3], step_q27[3]; /* colour of entry 0, and from one to the next */
    uint32_t full_q15;                 /* of the strongest channel */
    uint8_t channel;                   /* which one that is */
    uint16_t error_q8;                 /* 1/256 code: half a step, and what the shares of the channels differ by */
    bool usable;
    bool specular; /* the specular terms are of the same chromaticity as the diffuse ones and count in `full` */
} glint_ramp;

void glint_ramp_set_up(glint_ramp *ramp, const glint_scene *scene, const glint_material *material);

/* What takes the cosine of a light, of this product in the ramp's channel, to steps of t: (product / full) 960 / 1024.
 */
uint16_t glint_ramp_share_q15(const glint_ramp *ramp, uint32_t product_q15);

glint_shade glint_ramp_colour(const glint_ramp *ramp, uint32_t index);

#endif
