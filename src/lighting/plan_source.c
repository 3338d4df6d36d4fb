/* SPDX-License-Identifier: MIT */
/*
 * The plan of an extended source: how many point lights stand for it on one object. See lighting/source.h.
 */
#include <glint/plan.h>

#include "lighting/bound.h"
#include "lighting/source.h"
#include "number/fixed.h"

#define ONE_Q16 ((uint32_t)1 << 16)
#define ANGLE_OF_66_DEGREES_Q15 37749

/* size / |v|, Q16, rounded up; 1 where that is more. */
static uint32_t part_q16(uint64_t size, const int64_t v[3])
{
    uint64_t any = size | 1, square = 0;
    for (int k = 0; k < 3; k++) {
        any |= magnitude64(v[k]);
    }
    const int down = bit_length64(any) > 30 ? bit_length64(any) - 30 : 0;
    for (int k = 0; k < 3; k++) {
        const uint64_t m = magnitude64(v[k]) >> down;
        square += m * m; /* < 3 2^60 */
    }
    const uint32_t part = (uint32_t)(size >> down) + (down > 0), whole = glint_square_root_u64(square);
    if (part >= whole) {
        return ONE_Q16;
    }
    const int up = clz32(whole) & 31; /* not 0 */
    /* 2^30 part / whole, within 2^-28 of it */
    const uint32_t quotient_q16 = (multiply_high_u32(part << up, glint_reciprocal_q31(whole << up)) >> 14) + 2;
    return quotient_q16 < ONE_Q16 ? quotient_q16 : ONE_Q16;
}

/* An angle of the sine t is at most t + 0.571 t^3; Q15. */
static uint32_t angle_most_q15(uint32_t sine_q16)
{
    const uint32_t cube_q16 = (sine_q16 * (sine_q16 >> 1) >> 15) * (sine_q16 >> 1) >> 15;
    return (sine_q16 + (cube_q16 * 9 >> 4) + (cube_q16 >> 7) + 8) >> 1;
}

/* The least angle, Q15, between the ways from a point of the object to the eye and on from a point of the source to it:
 * that of the centres, less what source and object take up. The angle of two unit vectors is at least their chord. */
static uint32_t clear_angle_q15(const glint_scene *scene, const glint_bounds *bounds, const glint_light *light)
{
    int64_t to_eye[3], to_light[3], chord_square = 0;
    int32_t eye_q30[3], light_q30[3];
    for (int k = 0; k < 3; k++) {
        to_eye[k] = scene->camera->eye_q16[k] - bounds->centre_q16[k];
        to_light[k] = light->position_q16[k] - bounds->centre_q16[k];
    }
    const uint64_t radius = (uint64_t)bounds->radius_q16;
    const uint32_t taken = angle_most_q15(part_q16(radius, to_eye)) +
                           angle_most_q15(part_q16(radius + glint_source_size_q16(light), to_light));
    if (!glint_unit_q30(to_eye, eye_q30) || !glint_unit_q30(to_light, light_q30)) {
        return 0;
    }
    for (int k = 0; k < 3; k++) {
        const int64_t sum = (int64_t)eye_q30[k] + light_q30[k];
        chord_square += sum * sum;
    }
    const uint32_t chord_q15 = glint_square_root_u64((uint64_t)chord_square) >> 15;
    return chord_q15 > taken ? chord_q15 - taken : 0;
}

static uint32_t strongest_q8(const glint_colour *reflectance, const glint_colour *light)
{
    const uint32_t r = (uint32_t)reflectance->r_q14 * (uint32_t)light->r_q14,
                   g = (uint32_t)reflectance->g_q14 * (uint32_t)light->g_q14,
                   b = (uint32_t)reflectance->b_q14 * (uint32_t)light->b_q14;
    const uint32_t greatest = r > g ? r : g;
    return glint_bound_codes(((greatest > b ? greatest : b) + 8191) >> 13);
}

static uint32_t share_of(uint32_t light_q8, uint32_t share_q16)
{
    return multiply_high_u32(light_q8 << 8, share_q16 << 8) + 1; /* 2^18 and 2^16 at most */
}

void glint_plan_source(const glint_scene *scene, uint16_t object, const glint_object_plan *of_object, uint16_t light,
                       const glint_light_plan *of_light, uint32_t room_q8, glint_source_plan *plan)
{
    const glint_light *const source = &scene->lights[light];
    const glint_material *const material = scene->objects[object].material;
    const uint8_t rules = glint_source_rules(source);
    plan->points = 1;
    plan->enough = true;
    plan->error_q8 = 0;
    if (!glint_source_extends(source)) {
        return;
    }
    const glint_bounds *const bounds = &of_object->bounds;
    int64_t gap[3];
    for (int k = 0; k < 3; k++) {
        const int64_t away = (int64_t)magnitude64(source->position_q16[k] - bounds->centre_q16[k]);
        gap[k] = away > bounds->half_q16[k] ? away - bounds->half_q16[k] : 0;
    }
    const uint32_t size_q16 = part_q16(glint_source_size_q16(source), gap);
    const uint32_t diffuse_q8 = strongest_q8(&material->diffuse, &source->colour);
    const uint32_t specular_q8 = strongest_q8(&material->specular, &source->colour);
    uint32_t gate_q8 = specular_q8;
    bool bounded = true; /* the specular error is */
    if (specular_q8 != 0) {
        const uint32_t clear_q15 = clear_angle_q15(scene, bounds, source);
        const bool blinn = material->specular_model == GLINT_BLINN;
        /* h turns faster than s where s and c nearly cancel */
        bounded = !blinn || clear_q15 > ANGLE_OF_66_DEGREES_Q15;
        if (gate_q8 > GLINT_HIGHLIGHT_LEFT &&
            (blinn ? clear_q15 / 2 : clear_q15) > glint_bound_highlight_q15(specular_q8, material->exponent_q4)) {
            gate_q8 = GLINT_HIGHLIGHT_LEFT;
        }
    }
    plan->error_q8 = UINT32_MAX;
    for (uint8_t rule = 0; rule < rules && plan->error_q8 > room_q8; rule++) {
        uint32_t error_q8 =
            share_of(diffuse_q8, glint_source_diffuse_q16(source, rule, size_q16, of_light->attenuation));
        if (specular_q8 != 0) {
            const uint32_t share_q16 = bounded ? glint_source_specular_q16(source, rule, size_q16,
                                                                           material->exponent_q4, of_light->attenuation)
                                               : ONE_Q16;
            error_q8 += share_of(specular_q8, share_q16) + share_of(gate_q8, glint_source_gate_q16(rule));
        }
        if (error_q8 > diffuse_q8 + specular_q8) {
            error_q8 = diffuse_q8 + specular_q8;
        }
        if (error_q8 <= plan->error_q8) {
            plan->error_q8 = error_q8;
            plan->points = glint_source_points(rule);
        }
    }
    plan->enough = plan->error_q8 <= room_q8;
}

uint32_t glint_plan_room_q8(const glint_scene *scene, uint8_t tolerance)
{
    uint32_t sources = 0;
    for (uint16_t i = 0; i < scene->light_count; i++) {
        sources += glint_source_extends(&scene->lights[i]);
    }
    const uint32_t all_q8 = tolerance == 0 ? GLINT_CODE_UNITS / 4
                                           : ((uint32_t)tolerance * (GLINT_CODE_UNITS / 16) - GLINT_CODE_UNITS / 2) / 2;
    return sources > 1 ? all_q8 / sources : all_q8;
}
