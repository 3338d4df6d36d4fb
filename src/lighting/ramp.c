/* SPDX-License-Identifier: MIT */
#include "lighting/ramp.h"

#include "number/fixed.h"

static void channels(const glint_colour *colour, int32_t out_q14[3])
{
    out_q14[0] = colour->r_q14;
    out_q14[1] = colour->g_q14;
    out_q14[2] = colour->b_q14;
}

static bool same_chromaticity(const int32_t a[3], const int32_t b[3])
{
    return a[0] * b[1] == a[1] * b[0] && a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2];
}

/* By how much specular differs from diffuse times one factor: twice the units of Q14, rounded up, or 5 for more than 2
 * units. */
static uint32_t disproportion(const int32_t diffuse[3], const int32_t specular[3], int strongest)
{
    uint32_t twice = 0;
    for (int k = 0; k < 3; k++) {
        const uint32_t difference =
            magnitude32(specular[k] * diffuse[strongest] - specular[strongest] * diffuse[k]); /* < 2^29 */
        while (twice < 5 && 2 * difference > twice * (uint32_t)diffuse[strongest]) {
            twice++;
        }
    }
    return twice;
}

void glint_ramp_set_up(glint_ramp *ramp, const glint_scene *scene, const glint_material *material)
{
    int32_t diffuse[3], specular[3], ambient[3], ambient_light[3], emission[3], first[3] = {0, 0, 0};
    uint32_t total_q14[3] = {0, 0, 0};
    ramp->usable = false;
    ramp->channel = 0;
    ramp->full_q15 = 0;
    ramp->error_q8 = 0;
    ramp->specular = false;
    channels(&material->diffuse, diffuse);
    channels(&material->specular, specular);
    channels(&material->ambient, ambient);
    channels(&scene->ambient, ambient_light);
    channels(&material->emission, emission);
    for (uint16_t i = 0; i < scene->light_count; i++) {
        int32_t light[3];
        channels(&scene->lights[i].colour, light);
        if ((first[0] | first[1] | first[2]) == 0) {
            channels(&scene->lights[i].colour, first); /* the first that is not black */
        }
        if (!same_chromaticity(first, light)) {
            return;
        }
        for (int k = 0; k < 3; k++) {
            total_q14[k] += (uint32_t)light[k]; /* < 2^12 2^15 */
        }
    }
    int strongest = 0;
    for (int k = 1; k < 3; k++) {
        strongest =
            (uint32_t)diffuse[k] * (uint32_t)first[k] > (uint32_t)diffuse[strongest] * (uint32_t)first[strongest]
                ? k
                : strongest;
    }
    ramp->channel = (uint8_t)strongest;
    const uint32_t twice = disproportion(diffuse, specular, strongest);
    ramp->specular = twice < 5;
    for (int k = 0; k < 3; k++) {
        const uint32_t reflectance = (uint32_t)(ramp->specular ? diffuse[k] + specular[k] : diffuse[k]);
        if (total_q14[k] > 65535) {
            return;
        }
        const uint32_t full_q15 = (reflectance * total_q14[k] + (1 << 12)) >> 13; /* < 2^15 2^16 */
        if (full_q15 > 65536) {
            return; /* so bright that a step would be more than a code */
        }
        /* full / 960 in Q27: 2^12 / 960 = 34953 / 2^13 */
        ramp->step_q27[k] = (full_q15 * 34953u + 4096) >> 13;
        ramp->base_q27[k] = (((uint32_t)ambient[k] * (uint32_t)ambient_light[k]) >> 1) + ((uint32_t)emission[k] << 13) +
                            ramp->step_q27[k] / 2;
        if (k == strongest) {
            ramp->full_q15 = full_q15;
        }
        /* 255 256 / 2^15 codes / 960 / 2; and half units of Q14 of specular, 2 at intensity 1 */
        const uint32_t error =
            ((full_q15 * 69) >> 16) + 1 + (ramp->specular ? ((twice * (total_q14[k] + 1)) >> 13) + 1 : 0);
        ramp->error_q8 = error > ramp->error_q8 ? (uint16_t)error : ramp->error_q8;
    }
    /* the shares of very dim lights, each rounded, could add up to more than the ramp has room for */
    ramp->usable = ramp->full_q15 > 0 && ramp->full_q15 >= 64 * (uint32_t)scene->light_count;
}

uint16_t glint_ramp_share_q15(const glint_ramp *ramp, uint32_t product_q15)
{
    const int zeros = clz32(ramp->full_q15) & 31; /* full is not 0 */
    const uint32_t r = glint_reciprocal_q31(ramp->full_q15 << zeros);
    /* 2^30 product / full, at most 2^30; 15/16 of it in Q15 */
    const uint32_t share_q30 = multiply_high_u32(product_q15 << zeros, r);
    return (uint16_t)((share_q30 - (share_q30 >> 4) + (1 << 14)) >> 15);
}

glint_shade glint_ramp_colour(const glint_ramp *ramp, uint32_t index)
{
    uint16_t channel[3];
    for (int k = 0; k < 3; k++) {
        const uint32_t q15 = (ramp->base_q27[k] + index * ramp->step_q27[k] + 2048) >> 12;
        channel[k] = (uint16_t)(q15 > 32768 ? 32768 : q15);
    }
    const glint_shade shade = {channel[0], channel[1], channel[2]};
    return shade;
}
