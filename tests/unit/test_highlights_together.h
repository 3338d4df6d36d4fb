/* SPDX-License-Identifier: MIT */
/*
 * What the highlights of several lights cost together (lighting/highlight.inc) against their sum in long double: at
 * random directions, and at the best that a climb from there finds. A test file includes the backend's source, defines
 * UNIT_ONE, the scale of its unit vectors, and then includes this.
 */
#ifndef GLINT_TESTS_UNIT_TEST_HIGHLIGHTS_TOGETHER_H
#define GLINT_TESTS_UNIT_TEST_HIGHLIGHTS_TOGETHER_H

#include "tests/unit/directions.h"
#include "tests/unit/numeric.h"

#define LIGHTS 8

typedef struct together_case {
    light_state lights[LIGHTS];
    lit_material lit;
    long double towards[LIGHTS][3];
} together_case;

/* Lights within a cone, every fifth at a point. */
static void random_lights(together_case *c)
{
    const long double spread = 2 * random_unit();
    long double base[3];
    random_direction(base);
    memset(c, 0, sizeof *c);
    c->lit.lights = c->lights;
    c->lit.light_count = (uint16_t)random_between(2, LIGHTS);
    c->lit.exponent_q4 = (uint16_t)(16 * exp2l(8 * random_unit()));
    c->lit.exponent = exponent_from(c->lit.exponent_q4);
    for (int i = 0; i < c->lit.light_count; i++) {
        long double v[3];
        random_direction(v);
        for (int k = 0; k < 3; k++) {
            v[k] = base[k] + spread * v[k];
        }
        const long double length = sqrtl(dot3(v, v));
        for (int k = 0; k < 3; k++) {
            c->towards[i][k] = v[k] / length;
            c->lights[i].place.v[k] = (real)(UNIT_ONE == 1 ? v[k] / length : rintl(v[k] / length * UNIT_ONE));
        }
        c->lights[i].specular_q8 = (uint32_t)random_between(100, 65535);
        c->lights[i].is_point = random_between(0, 4) == 0;
    }
}

/* The sum of w (1 - g)^(exponent - 1) over the directional lights, gaps less what they may be off. */
static long double slopes_at(const together_case *c, const long double v[3])
{
    long double sum = 0;
    for (int i = 0; i < c->lit.light_count; i++) {
        const long double cosine = dot3(v, c->towards[i]) + GLINT_GAP_OFF_Q28 / 268435456.0L;
        if (!c->lights[i].is_point && cosine > 0) {
            sum += c->lights[i].specular_q8 * powl(fminl(1, cosine), c->lit.exponent_q4 / 16.0L - 1);
        }
    }
    return sum;
}

static long double climbed(const together_case *c, int rounds)
{
    long double best[3], most = 0, size = 0.5L;
    const int start = random_between(0, c->lit.light_count - 1);
    memcpy(best, c->towards[start], sizeof best);
    for (int round = 0; round < rounds; round++) {
        long double v[3];
        random_direction(v);
        for (int k = 0; k < 3; k++) {
            v[k] = best[k] + size * v[k];
        }
        const long double length = sqrtl(dot3(v, v));
        for (int k = 0; k < 3; k++) {
            v[k] /= length;
        }
        const long double there = slopes_at(c, v);
        if (there > most) {
            most = there;
            memcpy(best, v, sizeof best);
        } else {
            size *= 0.97L;
        }
    }
    return most;
}

static void slopes_add_up_to_no_more(void **state)
{
    long double worst = 0;
    long less = 0;
    (void)state;
    for (int round = 0; round < 20000; round++) {
        together_case c;
        uint32_t all = 0;
        random_lights(&c);
        for (int i = 0; i < c.lit.light_count; i++) {
            all += c.lights[i].specular_q8;
        }
        const uint32_t together = gloss_together(&c.lit);
        assert_true(together <= all);
        less += together < all / 2;
        worst = worse(worst, climbed(&c, 100) / together);
    }
    print_message("    %ld of 20000 below half of the lights' sum\n", less);
    assert_true(less > 2000);
    expect_bound("slopes of highlights at one place, over what is counted", worst, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {numeric_test(slopes_add_up_to_no_more)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

#endif
