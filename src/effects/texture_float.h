/* SPDX-License-Identifier: MIT */
/*
 * Light times a texture's colour, in float. See texture_fixed.h for what each does.
 */
#ifndef GLINT_EFFECTS_TEXTURE_FLOAT_H
#define GLINT_EFFECTS_TEXTURE_FLOAT_H

#include "effects/texture.h"
#include "lighting/light_float.h"

static inline void light_times(light_sum *sum, const glint_texel *texel)
{
    for (int k = 0; k < 3; k++) {
        sum->channel[k] *= (float)texel->q15[k] * (1.0f / 32768);
    }
}

static inline void light_join(light_sum *sum, const light_sum *more)
{
    for (int k = 0; k < 3; k++) {
        sum->channel[k] += more->channel[k];
    }
}

static inline void light_from_shade(light_sum *sum, const glint_shade *shade)
{
    sum->channel[0] = (float)shade->r_q15 * (1.0f / 32768);
    sum->channel[1] = (float)shade->g_q15 * (1.0f / 32768);
    sum->channel[2] = (float)shade->b_q15 * (1.0f / 32768);
}

static inline real texcoord_to_attribute(int32_t from_first_q22)
{
    return (float)from_first_q22;
}

static inline int32_t texcoord_of_attribute(real attribute)
{
    return (int32_t)attribute;
}

#endif
