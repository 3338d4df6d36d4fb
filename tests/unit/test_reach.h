/* SPDX-License-Identifier: MIT */
/*
 * Attenuation and cones of lights against <glint/scene.h> in long double: random distances, coefficients, ranges and
 * angles, on the edges of cones and ranges too.
 *
 * A test file defines the budgets and `surface_at`, which makes a surface of a point (in near distances, the eye the
 * origin) seen at a depth, and says what point it stands for after rounding.
 */
#include "tests/unit/geometry_world.h"

#include <stdio.h>

#define ROUNDS 400000

static glint_view view_with_near(long double near)
{
    glint_view view;
    memset(&view, 0, sizeof view);
    view.near_units = glint_scaled_from((uint64_t)(int64_t)Q16(near), 16);
    return view;
}

static glint_frame upright_frame(void)
{
    glint_frame frame;
    memset(&frame, 0, sizeof frame);
    for (int k = 0; k < 3; k++) {
        frame.from_world_q30[k][k] = (int32_t)1 << 30;
    }
    return frame;
}

static uint16_t any_k(void)
{
    return random_u32() & 3 ? (uint16_t)(65535.0L * exp2l(-14 * random_unit())) : 0;
}

static glint_attenuation any_attenuation(void)
{
    glint_attenuation a = {{any_k(), any_k(), any_k()}, 0, 0};
    if (random_u32() & 1) {
        a.unit_q16 = (uint32_t)(256 * exp2l(22 * random_unit()));
    }
    if (random_u32() & 1) {
        a.range_q16 = (uint32_t)(256 * exp2l(22 * random_unit()));
    }
    return a;
}

static long double exact_attenuation(const glint_attenuation *a, long double distance)
{
    const long double t = distance / (a->unit_q16 ? a->unit_q16 / 65536.0L : 1);
    const long double divisor = (a->k_q14[0] + a->k_q14[1] * t + a->k_q14[2] * t * t) / 16384;
    const long double quotient = (a->k_q14[0] | a->k_q14[1] | a->k_q14[2]) == 0 || divisor < 1 ? 1 : 1 / divisor;
    const long double u = a->range_q16 ? distance / (a->range_q16 / 65536.0L) : 0;
    return u >= 1 ? 0 : quotient * (1 - u * u * u * u);
}

static long double exact_cone(const glint_light *light, const long double towards[3])
{
    const long double inner = cosl(light->inner_turn16 * PI / 32768), outer = cosl(light->outer_turn16 * PI / 32768);
    long double axis[3];
    for (int k = 0; k < 3; k++) {
        axis[k] = -light->direction[k];
    }
    (void)normalise(axis);
    const long double share = (dot(axis, towards) - outer) / (inner - outer);
    return share <= 0 ? 0 : share >= 1 ? 1 : share * share;
}

/* A light somewhere between very near to the surface and very far from it. Returns the factor; its exact value and the
 * distance's are told, and what the light's rounding of its position makes that uncertain by. */
static long double factor_of(glint_light *light, long double distance, const long double direction[3],
                             long double *exact, long double *uncertain)
{
    const long double near = exp2l(-4 + 8 * random_unit());
    const glint_view view = view_with_near(near);
    const glint_frame frame = upright_frame();
    const long double real_near = ldexpl(view.near_units.m, -view.near_units.f);
    long double point[3], towards[3];
    surface at;
    light_place place;
    light_reach reach;
    real v[3], s[3];
    surface_at(&at, point);
    for (int k = 0; k < 3; k++) {
        light->position_q16[k] = Q16(fminl(fmaxl(point[k] * real_near + direction[k] * distance, -16384), 16384));
        towards[k] = light->position_q16[k] / 65536.0L - point[k] * real_near;
    }
    light_place_position(&place, &frame, &view, light);
    light_reach_set_up(&reach, &frame, &view, light);
    if (!light_towards(&place, &at, v, s)) {
        return -1;
    }
    const long double size = normalise(towards), whole = sqrtl(dot(point, point)) * real_near + size;
    *uncertain = whole / size * POSITION_ERROR;
    *exact =
        exact_attenuation(&light->attenuation, size) * (light->kind == GLINT_SPOT ? exact_cone(light, towards) : 1);
    const real factor = light_reach_factor(&reach, &at, v, light_vector_fraction(&place, &at), s);
    return (long double)factor / FACTOR_ONE;
}

static void test_attenuation(void **state)
{
    (void)state;
    long double worst = 0;
    long seen = 0, none = 0, full = 0;
    for (int round = 0; round < ROUNDS; round++) {
        glint_light light;
        long double direction[3], exact, uncertain;
        memset(&light, 0, sizeof light);
        light.kind = GLINT_POINT;
        light.attenuation = any_attenuation();
        random_direction(direction);
        const long double range = light.attenuation.range_q16 / 65536.0L;
        const bool edge = range > 0 && range < 8000 && random_u32() % 4 == 0;
        const long double distance = edge ? range * (0.9L + 0.2L * random_unit()) : exp2l(-6 + 20 * random_unit());
        const long double factor = factor_of(&light, distance, direction, &exact, &uncertain);
        if (factor < 0 || uncertain > 1e-4L) {
            continue;
        }
        seen++;
        none += exact == 0;
        full += exact == 1;
        assert_true(factor <= 1);
        /* a relative error of the distance counts four times in u^4, at most thrice in the quotient */
        worst = worse(worst, fabsl(factor - exact) / (ATTENUATION_ERROR + 7 * uncertain));
        assert_true(exact > 0 || factor < ATTENUATION_ERROR);
    }
    printf("attenuation: worst error %.3Lf of the bound %.2Le, %ld points, %ld out of range, %ld in full light\n",
           worst, (long double)ATTENUATION_ERROR, seen, none, full);
    assert_true(worst <= 1 && worst > 0.5L);
    assert_true(seen > ROUNDS / 2 && none > 1000 && full > 1000);
}

static void test_cone(void **state)
{
    (void)state;
    long double worst = 0;
    long seen = 0, dark = 0, full = 0;
    for (int round = 0; round < ROUNDS; round++) {
        glint_light light;
        long double axis[3], other[3], across[3], direction[3], exact, uncertain, length = 0;
        memset(&light, 0, sizeof light);
        light.kind = GLINT_SPOT;
        const int width = random_u32() & 1 ? 182 : random_between(182, 16384);
        light.inner_turn16 = (uint16_t)random_between(0, 16384 - width);
        light.inner_turn16 = random_u32() % 4 == 0 ? 0 : light.inner_turn16;
        light.outer_turn16 = (uint16_t)(light.inner_turn16 + width);
        random_direction(axis);
        random_direction(other);
        cross_product(axis, other, across);
        (void)normalise(across);
        for (int k = 0; k < 3; k++) {
            light.direction[k] = (int16_t)lrintl(-32000 * axis[k]);
        }
        /* mostly in the penumbra, or at its edges */
        const long double part = random_u32() & 3 ? random_unit() : 2 * random_unit() - 0.5L;
        const long double angle = (light.inner_turn16 + part * width) * PI / 32768;
        for (int k = 0; k < 3; k++) {
            direction[k] = cosl(angle) * axis[k] + sinl(angle) * across[k];
            length += direction[k] * direction[k];
        }
        assert_true(fabsl(length - 1) < 1e-9L);
        const long double factor = factor_of(&light, exp2l(-3 + 12 * random_unit()), direction, &exact, &uncertain);
        if (factor < 0 || uncertain > 1e-6L) {
            continue;
        }
        seen++;
        dark += exact == 0;
        full += exact == 1;
        /* twice the slope of the cosine, over the step of cosines from edge to edge, times the direction's error */
        const long double inner = cosl(light.inner_turn16 * PI / 32768), outer = cosl(light.outer_turn16 * PI / 32768);
        const long double slope = 2 * (sinl(light.outer_turn16 * PI / 32768) + uncertain) / (inner - outer);
        worst = worse(worst, fabsl(factor - exact) / (CONE_ERROR + slope * uncertain));
    }
    printf("cone: worst error %.3Lf of the bound %.2Le, %ld points, %ld outside, %ld inside\n", worst,
           (long double)CONE_ERROR, seen, dark, full);
    assert_true(worst <= 1 && worst > 0.5L);
    assert_true(seen > ROUNDS / 4 && dark > 1000 && full > 1000);
}

/* What the model says at its corners: full light at the light itself, none from the range on, all along the axis. */
static void test_ends(void **state)
{
    (void)state;
    long double direction[3] = {0, 0, 1}, exact, uncertain;
    glint_light light;
    memset(&light, 0, sizeof light);
    light.kind = GLINT_SPOT;
    light.direction[2] = -5;
    light.outer_turn16 = 182;
    assert_true(factor_of(&light, 8, direction, &exact, &uncertain) > 1 - CONE_ERROR);
    light.attenuation.range_q16 = 4 << 16;
    assert_true(factor_of(&light, 8, direction, &exact, &uncertain) == 0);
    light.attenuation.range_q16 = 0;
    light.attenuation.k_q14[2] = 65535;
    light.attenuation.unit_q16 = 1 << 20;
    assert_true(factor_of(&light, 0.5L, direction, &exact, &uncertain) > 1 - CONE_ERROR);
    light.direction[2] = 5;
    assert_true(factor_of(&light, 0.5L, direction, &exact, &uncertain) == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_attenuation),
        cmocka_unit_test(test_cone),
        cmocka_unit_test(test_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
