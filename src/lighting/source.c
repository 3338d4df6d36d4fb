/* SPDX-License-Identifier: MIT */
#include "lighting/source.h"

#include "number/fixed.h"

#define DEFAULT_SAMPLES 16
#define GOLDEN_TURN16 25033 /* (3 - sqrt(5)) / 2 of a turn */
#define ONE_Q24 ((int32_t)1 << 24)
#define ONE_Q16 ((uint32_t)1 << 16)

static const uint8_t points_of[GLINT_SOURCE_RULES] = {1, 5, 13, 29, 53};
static const uint8_t step_of[GLINT_SOURCE_RULES] = {0, 2, 5, 12, 23};

bool glint_source_extends(const glint_light *light)
{
    const int32_t *const e = light->edge_q16[0], *const f = light->edge_q16[1];
    return (light->kind == GLINT_PANEL && (e[0] | e[1] | e[2] | f[0] | f[1] | f[2]) != 0) ||
           (light->kind == GLINT_BALL && light->radius_q16 != 0);
}

uint32_t glint_source_size_q16(const glint_light *light)
{
    uint64_t square[2] = {0, 0}; /* of coordinates up to 2^30 */
    if (light->kind != GLINT_PANEL) {
        return light->kind == GLINT_BALL ? (uint32_t)light->radius_q16 : 0;
    }
    for (int k = 0; k < 3; k++) {
        const int64_t sum = (int64_t)light->edge_q16[0][k] + light->edge_q16[1][k];
        const int64_t difference = (int64_t)light->edge_q16[0][k] - light->edge_q16[1][k];
        square[0] += (uint64_t)(sum * sum);
        square[1] += (uint64_t)(difference * difference);
    }
    return glint_square_root_u64(square[square[1] > square[0]]) + 1;
}

uint8_t glint_source_rules(const glint_light *light)
{
    const uint8_t samples = light->samples ? light->samples : DEFAULT_SAMPLES;
    uint8_t rules = 1;
    while (glint_source_extends(light) && rules < GLINT_SOURCE_RULES && points_of[rules] <= samples) {
        rules++;
    }
    return rules;
}

uint8_t glint_source_points(uint8_t rule)
{
    return points_of[rule];
}

uint8_t glint_source_most(const glint_light *light)
{
    return points_of[glint_source_rules(light) - 1];
}

/* Coordinates of point `number` within -1..1, Q24, in the plane of a panel. */
static void on_panel(uint8_t count, uint8_t number, int32_t along_q24[2])
{
    uint8_t step = 0;
    for (int rule = 0; rule < GLINT_SOURCE_RULES; rule++) {
        step = points_of[rule] == count ? step_of[rule] : step;
    }
    const int32_t half = (int32_t)count / 2;
    /* the middle one is number `half` in both, so that the grid is symmetrical about it */
    const int32_t across = ((int32_t)step * number + half * (count + 1 - (int32_t)step)) % count;
    along_q24[0] = ((int32_t)number - half) * 2 * ONE_Q24 / count;
    along_q24[1] = (across - half) * 2 * ONE_Q24 / count;
}

/* The same as a unit vector. */
static void on_ball(uint8_t count, uint8_t number, int32_t w_q24[3])
{
    int32_t sine_q30, cosine_q30;
    const int32_t z_q24 = (2 * (int32_t)number + 1) * ONE_Q24 / count - ONE_Q24;
    const int64_t across_q24 = glint_square_root_u64((uint64_t)((int64_t)ONE_Q24 * ONE_Q24 - (int64_t)z_q24 * z_q24));
    glint_sine_cosine_q30((uint16_t)((uint32_t)number * GOLDEN_TURN16), &sine_q30, &cosine_q30);
    w_q24[0] = (int32_t)glint_shift_round64(across_q24 * cosine_q30, -30);
    w_q24[1] = (int32_t)glint_shift_round64(across_q24 * sine_q30, -30);
    w_q24[2] = z_q24;
}

const glint_light *glint_source_point(const glint_light *light, uint8_t count, uint8_t number, glint_light *point)
{
    int32_t along_q24[3];
    if (count == 1) {
        return light;
    }
    *point = *light;
    point->kind = GLINT_POINT;
    if (light->kind == GLINT_PANEL) {
        on_panel(count, number, along_q24);
    } else {
        on_ball(count, number, along_q24);
    }
    for (int k = 0; k < 3; k++) {
        const int64_t offset = light->kind == GLINT_PANEL ? (int64_t)along_q24[0] * light->edge_q16[0][k] +
                                                                (int64_t)along_q24[1] * light->edge_q16[1][k]
                                                          : (int64_t)along_q24[k] * light->radius_q16;
        point->position_q16[k] += (int32_t)glint_shift_round64(offset, -24);
    }
    return point;
}
