/* SPDX-License-Identifier: MIT */
/*
 * A mirror in float. See mirror_fixed.h for what each does.
 *
 * Error of the direction from given normal and ray: at most 6e-7 (found by tests/unit/test_mirror.h); of the place in
 * the map, 9e-8 of the side, in both coordinates.
 */
#ifndef GLINT_LIGHTING_MIRROR_FLOAT_H
#define GLINT_LIGHTING_MIRROR_FLOAT_H

#include "lighting/light_float.h"
#include "lighting/mirror.h"

typedef struct light_mirror {
    const glint_environment *map;
    float to_world[3][3];
    light_product reflectance;
    float half_side;
} light_mirror;

static inline void light_mirror_set_up(light_mirror *mirror, const glint_environment *map,
                                       const glint_colour *reflectance, const glint_frame *frame)
{
    static const glint_colour white = {16384, 16384, 16384};
    mirror->map = map;
    mirror->reflectance = light_multiply(reflectance, &white);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            mirror->to_world[i][k] = float_from_scaled(frame->from_world_q30[k][i], 30);
        }
    }
    mirror->half_side = 0.5f * (float)map->side;
}

static inline void mirror_direction(const light_mirror *mirror, const real normal[3], const real ray[3], real out[3])
{
    float n[3], d[3];
    const bool has_normal = unit(normal, n);
    const float twice = has_normal ? 2.0f * cosine_of(n, ray) : 0.0f;
    for (int k = 0; k < 3; k++) {
        d[k] = has_normal ? ray[k] - twice * n[k] : -ray[k];
    }
    for (int i = 0; i < 3; i++) {
        out[i] = cosine_of(mirror->to_world[i], d);
    }
}

static inline float mirror_size(float value)
{
    return value < 0.0f ? -value : value;
}

static inline void mirror_colour(const light_mirror *mirror, const real d[3], float colour[3])
{
    const float sum = mirror_size(d[0]) + mirror_size(d[1]) + mirror_size(d[2]);
    colour[0] = colour[1] = colour[2] = 0.0f;
    if (!(sum > 1e-30f && sum < 1e30f)) {
        return;
    }
    const float inverse = 1.0f / sum;
    float u = mirror_size(d[0]) * inverse, v = mirror_size(d[2]) * inverse;
    if (d[1] < 0.0f) {
        const float folded = 1.0f - v;
        v = 1.0f - u;
        u = folded;
    }
    const float x = (d[0] < 0.0f ? 1.0f - u : 1.0f + u) * mirror->half_side - 0.5f;
    const float y = (d[2] < 0.0f ? 1.0f - v : 1.0f + v) * mirror->half_side - 0.5f;
    const int32_t i = float_floor(x), j = float_floor(y);
    const float right = x - (float)i, lower = y - (float)j;
    const float weight[4] = {(1.0f - right) * (1.0f - lower), right * (1.0f - lower), (1.0f - right) * lower,
                             right * lower};
    for (int corner = 0; corner < 4; corner++) {
        uint16_t channel[3];
        glint_environment_channels(
            glint_environment_texel(mirror->map, (int16_t)(i + (corner & 1)), (int16_t)(j + (corner >> 1))), channel);
        colour[0] += weight[corner] * (float)channel[0] * (1.0f / 31);
        colour[1] += weight[corner] * (float)channel[1] * (1.0f / 63);
        colour[2] += weight[corner] * (float)channel[2] * (1.0f / 31);
    }
}

static inline void light_mirror_add(light_sum *sum, const light_mirror *mirror, const real normal[3], const real ray[3])
{
    float d[3], colour[3];
    mirror_direction(mirror, normal, ray, d);
    mirror_colour(mirror, d, colour);
    for (int k = 0; k < 3; k++) {
        sum->channel[k] += mirror->reflectance.channel[k] * colour[k];
    }
}

#endif
