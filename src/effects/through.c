/* SPDX-License-Identifier: MIT */
#include "effects/through.h"

#include "number/fixed.h"

#define ONE_Q14 16384
#define ONE_Q15 32768

static int16_t scaled(int16_t q14, uint16_t share_q14)
{
    return (int16_t)(((int32_t)q14 * (int32_t)share_q14 + (1 << 13)) >> 14);
}

static void scale(glint_colour *colour, uint16_t share_q14)
{
    colour->r_q14 = scaled(colour->r_q14, share_q14);
    colour->g_q14 = scaled(colour->g_q14, share_q14);
    colour->b_q14 = scaled(colour->b_q14, share_q14);
}

void glint_through_body(glint_material *body, const glint_material *material)
{
    const uint16_t share_q14 = (uint16_t)(ONE_Q14 - material->transmission_q14);
    *body = *material;
    scale(&body->ambient, share_q14);
    scale(&body->diffuse, share_q14);
    scale(&body->emission, share_q14);
}

static uint32_t brightest_q14(const glint_colour *colour)
{
    const int16_t rg = colour->r_q14 > colour->g_q14 ? colour->r_q14 : colour->g_q14;
    return (uint32_t)(int32_t)(rg > colour->b_q14 ? rg : colour->b_q14);
}

/* All the light that a reflectance may be multiplied by, Q14. */
static uint32_t light_of(const glint_scene *scene)
{
    uint32_t sum_q14 =
        ONE_Q14 + brightest_q14(&scene->ambient) + brightest_q14(&scene->sky) + brightest_q14(&scene->ground);
    for (uint16_t i = 0; i < scene->light_count; i++) {
        sum_q14 += brightest_q14(&scene->lights[i].colour); /* 4096 lights at most: below 2^28 */
    }
    return sum_q14;
}

static glint_shade shade_of(const glint_colour *colour)
{
    const glint_shade shade = {(uint16_t)((uint16_t)colour->r_q14 << 1), (uint16_t)((uint16_t)colour->g_q14 << 1),
                               (uint16_t)((uint16_t)colour->b_q14 << 1)};
    return shade;
}

void glint_through_set_up(glint_through *through, const glint_scene *scene, uint16_t object,
                          const glint_object_plan *plan)
{
    const glint_material *const material = scene->objects[object].material;
    through->t_q15 = 0;
    through->error_q8 = 0;
    through->order = 0;
    through->grazes = plan->grazing == GLINT_NEEDED;
    if (plan->transmission != GLINT_NEEDED) {
        return;
    }
    through->t_q15 = (uint16_t)(material->transmission_q14 << 1);
    through->grazing = shade_of(&material->grazing);
    /* half a unit of Q14 of each reflectance counts 2 units of 1/256 code a light of 1; 1 for the mixing */
    uint32_t error_q8 = (light_of(scene) >> 13) + 2;
    if (through->grazes) {
        /* the cosine of two vectors in Q15 errs by at most 5 units, the power by 27; 2 for the rounding of what it is
         * multiplied with */
        error_q8 += (through->t_q15 * 29u * 2 >> 15) + 1;
    }
    through->error_q8 = error_q8 < UINT16_MAX ? (uint16_t)error_q8 : UINT16_MAX;
    through->order = glint_through_order(&plan->bounds, scene->camera->eye_q16);
}

uint32_t glint_through_mirrored_q15(int32_t cosine_q15)
{
    const uint32_t cosine = magnitude32(cosine_q15), rest = cosine < ONE_Q15 ? ONE_Q15 - cosine : 0;
    /* powers in Q30, so that the last rounding is all that counts */
    const uint32_t square_q30 = rest * rest;
    const uint32_t fourth_q30 = multiply_high_u32(square_q30 << 1, square_q30 << 1);
    const uint32_t fifth_q15 = (multiply_high_u32(fourth_q30 << 1, rest << 16) + (1 << 14)) >> 15;
    GLINT_TRACE("grazing share q15", fifth_q15);
    return fifth_q15;
}

static uint16_t added(uint16_t own, uint16_t colour, uint32_t part_q15)
{
    const uint32_t sum = own + ((colour * part_q15 + (1 << 14)) >> 15); /* <= 2^16 */
    GLINT_TRACE("layered colour q15", sum);
    return (uint16_t)(sum < ONE_Q15 ? sum : ONE_Q15);
}

void glint_through_add(glint_shade *shade, const glint_shade *colour, uint32_t part_q15)
{
    shade->r_q15 = added(shade->r_q15, colour->r_q15, part_q15);
    shade->g_q15 = added(shade->g_q15, colour->g_q15, part_q15);
    shade->b_q15 = added(shade->b_q15, colour->b_q15, part_q15);
}

glint_shade glint_through_rest(const glint_shade *colour, uint32_t through_q15)
{
    const uint32_t rest_q15 = ONE_Q15 - through_q15;
    const glint_shade rest = {(uint16_t)((colour->r_q15 * rest_q15 + (1 << 14)) >> 15),
                              (uint16_t)((colour->g_q15 * rest_q15 + (1 << 14)) >> 15),
                              (uint16_t)((colour->b_q15 * rest_q15 + (1 << 14)) >> 15)};
    return rest;
}

/* A number as 10 bits of exponent and 20 of mantissa, which compare as it does; `negative` ones below 0. */
static int32_t ordered(glint_scaled size, bool negative)
{
    const int32_t exponent = 512 - size.f, mantissa = (size.m - ((int32_t)1 << 30)) >> 10;
    const int32_t order = exponent * ((int32_t)1 << 20) + mantissa;
    GLINT_TRACE("order of layers", order);
    return negative ? -order : order;
}

int32_t glint_through_order(const glint_bounds *bounds, const int32_t eye_q16[3])
{
    int64_t away[3];
    uint64_t any = 1, square = 0;
    for (int k = 0; k < 3; k++) {
        away[k] = bounds->centre_q16[k] - eye_q16[k];
        any |= magnitude64(away[k]);
    }
    /* to 30 bits: squares below 2^60 */
    const int bits = bit_length64(any), up = bits < 30 ? (30 - bits) & ~1 : 30 - bits;
    for (int k = 0; k < 3; k++) {
        const int64_t part = glint_shift_round64(away[k], up);
        square += (uint64_t)(part * part);
    }
    const int64_t root = (int64_t)glint_square_root_u64(square);
    const int64_t distance = up > 0 ? root >> up : root * ((int64_t)1 << -up);
    /* (d - r) (d + r), below 2^48 each */
    const int64_t difference = distance - bounds->radius_q16, sum = distance + bounds->radius_q16;
    GLINT_TRACE("sphere's nearest distance", difference);
    GLINT_TRACE("sphere's farthest distance", sum);
    if (difference == 0 || sum == 0) {
        return 0;
    }
    const glint_scaled a = glint_scaled_from(magnitude64(difference), 0), b = glint_scaled_from((uint64_t)sum, 0);
    return ordered(glint_scaled_times(a, (uint32_t)b.m, b.f), difference < 0);
}
