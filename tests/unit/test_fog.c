/* SPDX-License-Identifier: MIT */
/*
 * Fog against <glint/scene.h> in long double: its share at any depth, in any fog; and that the error promised holds
 * when the depth is off by as much as is said.
 */
#include "tests/unit/geometry_world.h"

#include <stdio.h>

#include "effects/fog.h"

#define ROUNDS 4000000
#define RELATIVE (1.0L / (1 << 26)) /* of T */
#define ABSOLUTE (1.0L / (1 << 16))
#define LAST_BITS 1.5L
#define DEPTH_RELATIVE (1.0L / (1 << 20)) /* what glint_fog_error_q8() allows the vertices */

typedef struct any_fog {
    glint_fog fog;
    glint_view view;
    long double near, begin, end, steepest;
    glint_fog_state state;
} any_fog;

static int32_t any_distance_q16(int least_bits)
{
    return (int32_t)(exp2l(least_bits + (30 - least_bits) * random_unit()));
}

static void make_fog(any_fog *f)
{
    memset(f, 0, sizeof *f);
    f->view.near_units = glint_scaled_from((uint64_t)any_distance_q16(6), 16);
    f->near = ldexpl(f->view.near_units.m, -f->view.near_units.f);
    f->fog.begin_q16 = random_u32() & 3 ? any_distance_q16(0) - 1 : 0;
    const int32_t most = ((int32_t)1 << 30) - 256;
    f->fog.begin_q16 = f->fog.begin_q16 < most ? f->fog.begin_q16 : most;
    const int32_t deep = any_distance_q16(8), room = ((int32_t)1 << 30) - f->fog.begin_q16;
    f->fog.end_q16 = f->fog.begin_q16 + (deep < room ? deep : room);
    f->begin = f->fog.begin_q16 / 65536.0L;
    f->end = f->fog.end_q16 / 65536.0L;
    f->steepest = f->end / (f->end - f->begin);
    glint_fog_set_up(&f->state, &f->fog, &f->view);
    assert_true(f->state.present && f->state.fraction >= 5);
    assert_true(f->state.steepest_q4 >= 16 * f->steepest * (1 - 1e-8L));
    assert_true(f->state.steepest_q4 <= 16 * f->steepest * (1 + 1e-8L) + 1);
}

static long double exact_share(const any_fog *f, long double d_q30)
{
    const long double depth = GLINT_DEPTH_SPAN * f->near / d_q30;
    return fminl(1, fmaxl(0, (depth - f->begin) / (f->end - f->begin)));
}

/* A depth within the fog, or anywhere. */
static uint32_t any_inverse_depth(const any_fog *f)
{
    const long double depth = random_u32() & 3 ? f->begin + (f->end - f->begin) * (1.2L * random_unit() - 0.1L)
                                               : f->near * exp2l(20 * random_unit());
    const long double d_q30 = GLINT_DEPTH_SPAN * f->near / fmaxl(depth, f->near);
    return d_q30 < 1 ? 1 : (uint32_t)d_q30;
}

static void test_share(void **state)
{
    long double worst = 0;
    (void)state;
    for (int i = 0; i < ROUNDS; i++) {
        static any_fog f;
        if (i % 16 == 0) {
            make_fog(&f);
        }
        const uint32_t d_q30 = any_inverse_depth(&f), share_q15 = glint_fog_q15(&f.state, d_q30);
        const long double error = fabsl(share_q15 / 32768.0L - exact_share(&f, d_q30));
        const long double bound = f.steepest * RELATIVE + ABSOLUTE + LAST_BITS * ldexpl(1, -f.state.fraction);
        worst = fmaxl(worst, error / bound);
        if (error > bound) {
            fail_msg("begin %d end %d d %u: share %u, %.9Lf, off by %.9Lf, allowed %.9Lf", f.fog.begin_q16,
                     f.fog.end_q16, d_q30, share_q15, exact_share(&f, d_q30), error, bound);
        }
    }
    printf("error of the share: at most %.3Lf of what is stated\n", worst);
    assert_true(worst > 0.3L);
}

/* A colour mixed at a depth that is off, against the exact depth; the share's contrast is the greatest there is. */
static void test_promise(void **state)
{
    long double worst = 0;
    (void)state;
    for (int i = 0; i < ROUNDS / 4; i++) {
        static any_fog f;
        if (i % 16 == 0) {
            make_fog(&f);
        }
        const uint32_t error = (uint32_t)random_between(0, 65535), least_q30 = any_inverse_depth(&f);
        const uint32_t d_q30 = least_q30 + (uint32_t)(random_unit() * random_unit() * least_q30);
        const uint16_t promise_q8 = glint_fog_error_q8(&f.state, least_q30, error);
        const long double off = ((long double)error + DEPTH_RELATIVE * d_q30) * (random_u32() & 1 ? 1 : -1);
        const long double real_d = fmaxl((long double)d_q30 + off, 1e-3L);
        const glint_shade black = {0, 0, 0}, white = {32768, 32768, 32768};
        glint_shade mixed = random_u32() & 1 ? white : black;
        const bool dark = mixed.r_q15 == 0;
        glint_fog_mix(&mixed, dark ? &white : &black, glint_fog_q15(&f.state, d_q30));
        const long double shown = dark ? mixed.r_q15 / 32768.0L : 1 - mixed.r_q15 / 32768.0L;
        const long double codes = 255 * fabsl(shown - exact_share(&f, real_d));
        if (promise_q8 == UINT16_MAX) {
            continue;
        }
        worst = fmaxl(worst, codes * 256 / promise_q8);
        if (codes * 256 > promise_q8 + 1e-9L && real_d >= least_q30) {
            fail_msg("begin %d end %d d %u least %u error %u: %.4Lf codes, promised %.4f", f.fog.begin_q16,
                     f.fog.end_q16, d_q30, least_q30, error, codes, promise_q8 / 256.0);
        }
    }
    printf("observed over promised: at most %.3Lf\n", worst);
}

static void test_ends_are_exact(void **state)
{
    (void)state;
    for (int i = 0; i < 20000; i++) {
        any_fog f;
        make_fog(&f);
        assert_int_equal(glint_fog_q15(&f.state, f.state.whole_q30), 32768);
        assert_int_equal(glint_fog_q15(&f.state, 0), 32768);
        if (f.state.clear_q30 != UINT32_MAX) {
            assert_int_equal(glint_fog_q15(&f.state, f.state.clear_q30), 0);
            assert_int_equal(
                glint_fog_q15(&f.state, (uint32_t)1 << 30 > f.state.clear_q30 ? (uint32_t)1 << 30 : f.state.clear_q30),
                0);
        }
    }
    const glint_shade colour = {1, 20000, 32768};
    glint_shade shade = {32768, 5, 0};
    glint_fog_mix(&shade, &colour, 0);
    assert_true(shade.r_q15 == 32768 && shade.g_q15 == 5 && shade.b_q15 == 0);
    glint_fog_mix(&shade, &colour, 32768);
    assert_true(shade.r_q15 == 1 && shade.g_q15 == 20000 && shade.b_q15 == 32768);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_share),
        cmocka_unit_test(test_promise),
        cmocka_unit_test(test_ends_are_exact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
