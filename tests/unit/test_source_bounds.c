/* SPDX-License-Identifier: MIT */
/*
 * The bounds of lighting/source.h, searched for: how far the point lights that stand for an extended source are from
 * the integral over it, over what the library says they are at most. And what it says of the points themselves.
 *
 * GLINT_LONG=1 searches ten times as long.
 */
#include "tests/unit/source_search.h"

/* A search that ends far below a bound has not searched, or the bound is loose: of all searches together this much. */
#define TIGHT 0.7

static int searches(int few)
{
    const char *text = getenv("GLINT_LONG");
    return text && strcmp(text, "1") == 0 ? 10 * few : few;
}

static uint32_t q16_up(double value)
{
    return (uint32_t)ceil(value * 65536.0);
}

static glint_light any_of(const search *what)
{
    glint_light light;
    memset(&light, 0, sizeof light);
    light.kind = what->kind;
    light.edge_q16[0][0] = 1;
    light.radius_q16 = 1;
    return light;
}

static void diffuse_errors(void **state)
{
    static const double sizes[] = {0.1, 0.5, 0.75, 0.97};
    double worst = 0.0;
    (void)state;
    for (int kind = GLINT_PANEL; kind <= GLINT_BALL; kind++) {
        for (int i = 0; i < 4 * 2 * GLINT_SOURCE_RULES; i++) {
            const search what = {.kind = (uint8_t)kind,
                                 .rule = (uint8_t)(i % GLINT_SOURCE_RULES),
                                 .term = DIFFUSE,
                                 .fades = i >= 4 * GLINT_SOURCE_RULES,
                                 .size = sizes[i / GLINT_SOURCE_RULES % 4]};
            const glint_light light = any_of(&what);
            const double bound = glint_source_diffuse_q16(&light, what.rule, q16_up(what.size), what.fades) / 65536.0;
            const double found = climb(&what, searches(2), 120);
            if (!(found <= bound)) {
                fail_msg("kind %d, rule %d, size %g, fades %d: found %g, bound %g", kind, what.rule, what.size,
                         what.fades, found, bound);
            }
            worst = fmax(worst, found / bound);
        }
    }
    expect_at_most("diffuse errors, over their bounds", (long double)worst, 1);
    assert_true(worst >= TIGHT);
}

/* A size is any that goes with the spread: the bound of the greatest exponent and of the least. */
static void specular_errors(void **state)
{
    double worst = 0.0;
    (void)state;
    for (int kind = GLINT_PANEL; kind <= GLINT_BALL; kind++) {
        for (int i = 0; i < 12 * GLINT_SOURCE_RULES; i++) {
            const search what = {.kind = (uint8_t)kind,
                                 .rule = (uint8_t)(i % GLINT_SOURCE_RULES),
                                 .term = SPECULAR,
                                 .blinn = i / GLINT_SOURCE_RULES % 3 == 1,
                                 .spread = exp2((i / GLINT_SOURCE_RULES - 4) / 2.0)};
            const glint_light light = any_of(&what);
            /* at an exponent of 4, and a size above it by as much as rounding */
            const double bound = glint_source_specular_q16(&light, what.rule, q16_up(0.5 * what.spread), 64, false);
            const double at_size = what.spread >= 2.0
                                       ? glint_source_specular_q16(&light, what.rule, q16_up(what.spread / 31.5),
                                                                   (uint16_t)(31.5 * 31.5 * 16), false)
                                       : bound;
            const double found =
                65536.0 * (climb(&what, searches(2), 120) - 0.001 * glint_source_gate_q16(what.rule) / 65536.0);
            if (!(found <= at_size)) {
                fail_msg("kind %d, rule %d, spread %g: found %g, bound %g", kind, what.rule, what.spread, found,
                         at_size);
            }
            worst = fmax(worst, found / at_size);
        }
    }
    expect_at_most("specular errors, over their bounds", (long double)worst, 1);
    assert_true(worst >= TIGHT);
}

/* All bounds together, gate, attenuation and exponents below 2 too, as glint_plan_source() adds them. */
static void errors_of_both_by_the_gate(void **state)
{
    double worst = 0.0;
    (void)state;
    for (int i = 0; i < 6 * 2 * 2 * GLINT_SOURCE_RULES; i++) {
        search what = {.kind = (uint8_t)(i & 1 ? GLINT_BALL : GLINT_PANEL),
                       .rule = (uint8_t)(i / 4 % GLINT_SOURCE_RULES),
                       .term = GATED,
                       .fades = (i & 2) != 0,
                       .spread = exp2(i / (4 * GLINT_SOURCE_RULES) - 3.0)};
        const glint_light light = any_of(&what);
        for (int start = 0; start < searches(600); start++) {
            sight at;
            sight_random(&at, &what);
            if (start & 1) { /* across the horizon */
                at.n = unit(plus(cross(at.toward, at.n), times(0.4 * at.size, at.c)));
            }
            const double exponent = exponent_of(&at, &what);
            if (exponent < 1.0) {
                continue;
            }
            const double bound = (glint_source_specular_q16(&light, what.rule, q16_up(at.size),
                                                            (uint16_t)floor(exponent * 16.0), what.fades) +
                                  gate_of(&at, &what) * glint_source_gate_q16(what.rule)) /
                                 65536.0;
            worst = fmax(worst, difference(&at, &what) / bound);
        }
    }
    expect_at_most("gated errors, over their bounds", (long double)worst, 1);
    assert_true(worst >= TIGHT / 2);
}

/* Every number of points: their mean is the centre, on a panel each coordinate is there once; on a ball all are on it,
 * and their mean is near to the centre. Parts of a light add up. */
static void points_of_sources(void **state)
{
    (void)state;
    for (uint8_t rule = 0; rule < GLINT_SOURCE_RULES; rule++) {
        const uint8_t count = glint_source_points(rule);
        const glint_light panel = {.kind = GLINT_PANEL,
                                   .samples = count,
                                   .position_q16 = {7, -5, 1 << 29},
                                   .edge_q16 = {{1 << 20, 0, 0}, {0, 1 << 20, 0}}};
        const glint_light ball = {
            .kind = GLINT_BALL, .samples = count, .position_q16 = {9, 1 << 28, 3}, .radius_q16 = 1 << 20};
        bool seen[2][64] = {{false}};
        double sum[3] = {0.0, 0.0, 0.0};
        uint32_t parts = 0;
        assert_int_equal(glint_source_most(&panel), count);
        assert_int_equal(glint_source_rules(&ball), rule + 1);
        for (uint8_t i = 0; i < count; i++) {
            glint_light point;
            const glint_light *at = glint_source_point(&panel, count, i, &point);
            for (int k = 0; k < 2; k++) {
                const double place = (at->position_q16[k] - panel.position_q16[k]) / 1048576.0 * count / 2.0;
                const int number = (int)lrint(place) + count / 2;
                assert_true(fabs(place - rint(place)) < 1e-4 && number >= 0 && number < count && !seen[k][number]);
                seen[k][number] = true;
            }
            assert_int_equal(at->position_q16[2], panel.position_q16[2]);
            at = glint_source_point(&ball, count, i, &point);
            double square = 0.0;
            for (int k = 0; k < 3; k++) {
                const double place = (at->position_q16[k] - ball.position_q16[k]) / 1048576.0;
                square += place * place;
                sum[k] += place / count;
            }
            assert_true(count == 1 ? square == 0.0 : fabs(square - 1.0) < 1e-5);
            parts += glint_source_part(65535, count, i);
        }
        assert_int_equal(parts, 65535);
        assert_true(fabs(sum[0]) < 0.06 && fabs(sum[1]) < 0.06 && fabs(sum[2]) < 1e-5);
    }
    const glint_light none = {.kind = GLINT_BALL, .samples = 64}, few = {.kind = GLINT_BALL, .radius_q16 = 1};
    const glint_light other = {.kind = GLINT_POINT, .radius_q16 = 5, .samples = 64};
    assert_int_equal(glint_source_most(&none), 1);
    assert_int_equal(glint_source_most(&few), 13);
    assert_int_equal(glint_source_most(&other), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(points_of_sources),
        numeric_test(diffuse_errors),
        numeric_test(specular_errors),
        numeric_test(errors_of_both_by_the_gate),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
