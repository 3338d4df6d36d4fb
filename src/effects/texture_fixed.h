/* SPDX-License-Identifier: MIT */
/*
 * Light times a texture's colour, in fixed point.
 */
#ifndef GLINT_EFFECTS_TEXTURE_FIXED_H
#define GLINT_EFFECTS_TEXTURE_FIXED_H

#include "effects/texture.h"
#include "lighting/light_fixed.h"

/* sum T, rounded to a unit of Q16. A sum is below 2^31, T at most 2^15: its parts of 16 and 15 bits times T fit. */
static inline void light_times(light_sum *sum, const glint_texel *texel)
{
    for (int k = 0; k < 3; k++) {
        const uint32_t t = texel->q15[k];
        GLINT_TRACE("light before a texture q16", sum->q16[k]);
        sum->q16[k] = (sum->q16[k] >> 15) * t + (((sum->q16[k] & 0x7fff) * t + (1 << 14)) >> 15);
    }
}

static inline void light_join(light_sum *sum, const light_sum *more)
{
    for (int k = 0; k < 3; k++) {
        sum->q16[k] += more->q16[k];
    }
}

/* A shaded colour as a sum of light. */
static inline void light_from_shade(light_sum *sum, const glint_shade *shade)
{
    sum->q16[0] = (uint32_t)shade->r_q15 << 1;
    sum->q16[1] = (uint32_t)shade->g_q15 << 1;
    sum->q16[2] = (uint32_t)shade->b_q15 << 1;
}

/* Texture coordinates as what clipping interpolates, and back. */
static inline real texcoord_to_attribute(int32_t from_first_q22)
{
    return from_first_q22;
}

static inline int32_t texcoord_of_attribute(real attribute)
{
    return attribute;
}

#endif
