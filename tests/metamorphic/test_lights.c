/* SPDX-License-Identifier: MIT */
/*
 * What must become of a picture when its lights are permuted, joined by black ones, or split into halves.
 *
 * Budgets:
 *   permuted   fixed: none, sums of light are integers. Float: 1 code, since a sum of floats depends on its order by a
 * few units of 2^-24, which may carry a value over the border between two codes. black      none: a light that is black
 * is left out, whatever else it holds. halves     1 code. Fixed: a product of reflectance and intensity is rounded to
 * Q15, so two of half the intensity differ from the whole by at most 1 unit; each of the two terms of a light is
 * rounded to Q16 once more (1/2 each, three times): 3.5 units a term, 7 a light, 42 for 6 lights, 0.16 code. So no more
 * than that share of the pixels' channels can cross the border between two codes, three times for a pixel; lights that
 * overlap in fact get far less. Float: halving is exact; what is left is the order of the sum.
 */
#define PERMUTED_FLOAT_CODES 1
#define HALVES_CODES 1
#define FIXED_HALVES_SHARE 0.02 /* measured: 0.0055 */
#define FLOAT_SHARE 0.0005      /* measured: 0.00004 */

#include "tests/metamorphic/world.h"

static void test_permuted_lights(void **state)
{
    comparison sum[FRAME_BACKENDS] = {{0}}, within[FRAME_BACKENDS] = {{0}};
    (void)world_seed(state);
    for (int n = 0; n < WORLD_SCENES; n++) {
        static world w, permuted;
        world_make(&w);
        world_copy(&permuted, &w);
        for (uint16_t i = w.scene.light_count; i > 1; i--) { /* Fisher and Yates */
            const int32_t j = world_between(0, i - 1);
            const glint_light light = permuted.lights[i - 1];
            permuted.lights[i - 1] = permuted.lights[j];
            permuted.lights[j] = light;
        }
        for (int i = 0; i < FRAME_BACKENDS * WORLD_SHADINGS; i++) {
            const int backend = i % FRAME_BACKENDS;
            frame a = world_draw(&w, WORLD_WIDTH, i / FRAME_BACKENDS, backend);
            frame b = world_draw(&permuted, WORLD_WIDTH, i / FRAME_BACKENDS, backend);
            world_compare(&sum[backend], &a, &b, 0, 0, NULL);
            frame_free(&a);
            frame_free(&b);
        }
        world_compare_within(within, &w, &permuted, 0, 0, NULL);
    }
    world_expect(&sum[FRAME_FIXED], "lights permuted, fixed", 0, 0);
    world_expect(&sum[FRAME_FLOAT], "lights permuted, float", PERMUTED_FLOAT_CODES, FLOAT_SHARE);
    world_expect_within(within, "lights permuted", WITHIN_CODES, ANY_SHARE);
}

static void test_black_light(void **state)
{
    comparison sum[FRAME_BACKENDS] = {{0}}, within[FRAME_BACKENDS] = {{0}};
    (void)world_seed(state);
    for (int n = 0; n < WORLD_SCENES; n++) {
        static world w, more;
        world_make(&w);
        world_copy(&more, &w);
        const int32_t at = world_between(0, w.scene.light_count);
        memmove(&more.lights[at + 1], &more.lights[at], (size_t)(w.scene.light_count - at) * sizeof *more.lights);
        more.lights[at] = w.lights[world_between(0, w.scene.light_count - 1)];
        memset(&more.lights[at].colour, 0, sizeof more.lights[at].colour);
        more.scene.light_count++;
        for (int i = 0; i < FRAME_BACKENDS * WORLD_SHADINGS; i++) {
            const int backend = i % FRAME_BACKENDS;
            frame a = world_draw(&w, WORLD_WIDTH, i / FRAME_BACKENDS, backend);
            frame b = world_draw(&more, WORLD_WIDTH, i / FRAME_BACKENDS, backend);
            world_compare(&sum[backend], &a, &b, 0, 0, NULL);
            frame_free(&a);
            frame_free(&b);
        }
        world_compare_within(within, &w, &more, 0, 0, NULL);
    }
    world_expect(&sum[FRAME_FIXED], "a black light added, fixed", 0, 0);
    world_expect(&sum[FRAME_FLOAT], "a black light added, float", 0, 0);
    world_expect_within(within, "a black light added", 0, 0);
}

static void test_split_lights(void **state)
{
    comparison sum[FRAME_BACKENDS] = {{0}}, within[FRAME_BACKENDS] = {{0}};
    (void)world_seed(state);
    for (int n = 0; n < WORLD_SCENES; n++) {
        static world w, halves;
        world_make(&w);
        for (uint16_t i = 0; i < w.scene.light_count; i++) {
            glint_colour *c = &w.lights[i].colour;
            c->r_q14 = (int16_t)(c->r_q14 & ~1);
            c->g_q14 = (int16_t)(c->g_q14 & ~1);
            c->b_q14 = (int16_t)(c->b_q14 & ~1);
        }
        world_copy(&halves, &w);
        for (uint16_t i = 0; i < w.scene.light_count; i++) {
            glint_light *half = &halves.lights[2 * i];
            *half = w.lights[i];
            half->colour.r_q14 /= 2;
            half->colour.g_q14 /= 2;
            half->colour.b_q14 /= 2;
            half[1] = *half;
        }
        halves.scene.light_count = (uint16_t)(2 * w.scene.light_count);
        for (int i = 0; i < FRAME_BACKENDS * WORLD_SHADINGS; i++) {
            const int backend = i % FRAME_BACKENDS;
            frame a = world_draw(&w, WORLD_WIDTH, i / FRAME_BACKENDS, backend);
            frame b = world_draw(&halves, WORLD_WIDTH, i / FRAME_BACKENDS, backend);
            world_compare(&sum[backend], &a, &b, 0, 0, NULL);
            frame_free(&a);
            frame_free(&b);
        }
        world_compare_within(within, &w, &halves, 0, 0, NULL);
    }
    world_expect(&sum[FRAME_FIXED], "each light split into halves, fixed", HALVES_CODES, FIXED_HALVES_SHARE);
    world_expect(&sum[FRAME_FLOAT], "each light split into halves, float", HALVES_CODES, FLOAT_SHARE);
    world_expect_within(within, "each light split into halves", WITHIN_CODES, ANY_SHARE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_permuted_lights),
        cmocka_unit_test(test_black_light),
        cmocka_unit_test(test_split_lights),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
