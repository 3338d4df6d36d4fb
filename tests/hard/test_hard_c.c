/* SPDX-License-Identifier: MIT */
/*
 * Hard cases C: the specular term. docs/hard-cases.md has the defined behaviour; hard.h the form of a test.
 *
 * Budgets:
 */
#define POWER_ERROR (GLINT_SMALL_TABLES ? 0.00034 : 0.00016) /* of 1, fixed: what number/fixed.h states */
#define HALF_VECTOR 0.1                                      /* C2: of |s + c|; shorter ones are C8's */
#define FLOAT_POWER_ERROR 2e-7                               /* of 1, float: what number/real.h states */
#define LAST_STEP (1.0 / 32768)          /* C11: the last value of the power before 0, fixed: an ulp of Q15 */
#define LAST_FLOAT_STEP (1.0 / 16777216) /* the same in float at exponent 1: the ulp of the gap below 1 */

#include "examples/scenes/scenes.h"
#include "tests/hard/hard.h"

#include "number/fixed.h"
#include "number/real.h"

static void mirror_board(board *b, int exponent)
{
    board_set_up(b);
    b->material.specular = board_grey(16384);
    b->material.exponent_q4 = (uint16_t)(exponent * 16);
}

/* Direction from the board's point under a pixel to the eye. */
static void towards_eye(int pixel, double c[3])
{
    const int column = pixel % BOARD_PX, row = pixel / BOARD_PX;
    c[0] = -5 * (column + 0.5 - BOARD_PX / 2.0) / (BOARD_PX / 2.0);
    c[1] = 5 * (row + 0.5 - BOARD_PX / 2.0) / (BOARD_PX / 2.0);
    c[2] = 5;
    unit3(c);
}

static void test_C1_highlight_on_the_dark_side(void **state)
{
    (void)state;
    static const int16_t light[3] = {-20000, 0, 2000}; /* s = (0.995, 0, -0.0995): below the board */
    double s[3] = {20000, 0, -2000}, naive = 0;
    unit3(s);
    const double r[3] = {-s[0], -s[1], s[2]}; /* 2 (n.s) n - s, n = (0, 0, 1) */
    for (int i = 0; i < BOARD_PX * BOARD_PX; i++) {
        double c[3];
        towards_eye(i, c);
        naive = worse_of(naive, 255 * worse_of(dot3(r, c), 0));
    }
    assert_true(naive > 50);
    for (int model = GLINT_PHONG; model <= GLINT_BLINN; model++) {
        for (int exponent = 0; exponent <= 64; exponent = 4 * exponent + 1) {
            board b;
            mirror_board(&b, exponent);
            b.material.specular_model = (uint8_t)model;
            board_light(&b, 0, light[0], light[1], light[2]);
            expect_all(&b, 0, "light below the horizon");
        }
    }
    hard_pass("C1", "n.l <= 0 but r.v > 0", text("a highlight of up to %.0f codes on the dark side", naive),
              "gated: all pixels 0, Phong and Blinn, exponents 0 to 21");
}

/* Least |s + c| over the board's pixels. */
static double least_half_vector(const double s[3])
{
    double least = 2;
    for (int i = 0; i < BOARD_PX * BOARD_PX; i++) {
        double c[3];
        towards_eye(i, c);
        const double h[3] = {s[0] + c[0], s[1] + c[1], s[2] + c[2]};
        least = sqrt(dot3(h, h)) < least ? sqrt(dot3(h, h)) : least;
    }
    return least;
}

static void test_C2_normal_away_from_the_viewer(void **state)
{
    (void)state;
    double naive = 0, worst = 0;
    for (int degrees = 95; degrees < 180; degrees += 7) {
        const double angle = degrees * 3.14159265358979 / 180;
        const double n[3] = {sin(angle), 0, cos(angle)}; /* n.c < 0 at the centre, c = (0, 0, 1) */
        for (int tilt = -80; tilt <= 80; tilt += 20) {
            const double at = angle + tilt * 3.14159265358979 / 180, s[3] = {sin(at), 0, cos(at)};
            const double cosine = dot3(n, s), rc = 2 * cosine * n[2] - s[2];
            board b;
            naive = worse_of(naive, rc < 0 ? 255 * pow(rc, 20) : 0); /* the even power of a negative cosine */
            mirror_board(&b, 20);
            board_normals(&b, (int)lround(16384 * n[0]), 0, (int)lround(16384 * n[2]));
            board_light(&b, 0, (int)lround(-30000 * s[0]), 0, (int)lround(-30000 * s[2]));
            expect_centre(&b, GLINT_SHADING_EXACT, rc > 0 ? pow(rc, 20) : 0, "silhouette");
            for (int model = GLINT_PHONG; model <= GLINT_BLINN; model++) {
                b.material.specular_model = (uint8_t)model;
                if (model == GLINT_BLINN && least_half_vector(s) < HALF_VECTOR) {
                    continue; /* C8 */
                }
                worst = worse_of(worst, expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT,
                                                         text("%d+%d model %d", degrees, tilt, model)));
            }
        }
    }
    assert_true(naive > 200);
    hard_pass("C2", "n.v < 0 at silhouettes", text("(r.v)^20 of a negative r.v sparkles with %.0f codes", naive),
              text("documented: the formula as it stands, r.c clamped at 0; within %.2f codes", worst));
}

static void test_C3_cosine_above_one(void **state)
{
    (void)state;
    int over = 0;
    int32_t most = 0;
    for (int round = 0; round < 200000; round++) {
        int32_t v[3], a[3];
        for (int k = 0; k < 3; k++) {
            v[k] = hard_between(-32768, 32767);
        }
        if (glint_unit_q15(v, a)) {
            const int32_t cosine = (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) >> 15;
            over += cosine > 32768;
            most = cosine > most ? cosine : most;
        }
    }
    assert_true(over > 1000); /* index 256 and beyond of a table with 256 entries, too */
    const double naive = pow(most / 32768.0, 1024);
    assert_true(naive > 1.02);
    for (uint32_t e = 0; e <= 16384; e += 512) {
        for (uint32_t gap = 0; gap < 5000; gap++) {
            assert_true(glint_power_q15(gap, (uint16_t)e) <= 32768);
            assert_true(glint_power_q15(gap + ((uint32_t)1 << 31) - 2500, (uint16_t)e) <= 32768);
            assert_true(glint_power((float)gap * 1e-7f - 1e-5f, (float)e / 16) <= 1.0f);
        }
    }
    /* whole pictures: a mirror that returns the light to the eye, half as bright as one */
    for (int exponent = 1; exponent <= 1024; exponent *= 4) {
        for (int round = 0; round < 40; round++) {
            board b;
            mirror_board(&b, exponent);
            b.material.specular = board_grey(8192);
            const int x = hard_between(-9000, 9000), y = hard_between(-9000, 9000);
            double n[3] = {x, y, 16000}, r[3];
            unit3(n);
            for (int k = 0; k < 3; k++) {
                r[k] = 2 * n[2] * n[k] - (k == 2); /* s so that r is (0, 0, 1) */
            }
            board_normals(&b, x, y, 16000);
            board_light(&b, 0, (int)lround(-32000 * r[0]), (int)lround(-32000 * r[1]), (int)lround(-32000 * r[2]));
            for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
                frame f = board_draw(&b, GLINT_SHADING_EXACT, backend);
                for (size_t i = 0; i < f.bytes; i++) {
                    assert_true(f.pixels[i] <= 128);
                }
                assert_true(f.pixels[3 * HARD_CENTRE] >= 126);
                frame_free(&f);
            }
        }
    }
    hard_pass("C3", "r.v slightly above 1",
              text("%d of 200000 cosines pass 1, up to %d/32768; ^1024 is %.2f", over, (int)most, naive),
              "the gap 1 - r.c is never negative: power at most 1 for every exponent; 240 mirrors at most 128");
}

static void test_C4_large_exponent_near_one(void **state)
{
    (void)state;
    const double naive = 255 * (1 - pow(1 - 1.0 / 16384, 1000));
    double worst = 0, pictures = 0, codes = 0;
    assert_true(naive > 14);
    for (uint32_t gap = 0; gap < (uint32_t)1 << 26; gap += 997) {
        const long double exact = powl(1 - (long double)gap / 2147483648.0L, 1000);
        worst = worse_of(worst, fabs((double)(glint_power_q15(gap, 16000) / 32768.0L - exact)));
        const float rounded = (float)gap / 2147483648.0f;
        codes = worse_of(
            codes, fabs((double)((long double)glint_power(rounded, 1000) - powl(1 - (long double)rounded, 1000))));
    }
    assert_true(worst <= POWER_ERROR && codes <= FLOAT_POWER_ERROR);
    for (int degrees = 0; degrees < 60; degrees += 3) {
        const double angle = degrees * 3.14159265358979 / 180;
        board b;
        mirror_board(&b, 1000);
        board_normals(&b, (int)lround(16384 * sin(angle / 2)), 0, (int)lround(16384 * cos(angle / 2)));
        board_light(&b, 0, (int)lround(-32000 * sin(angle)), 0, (int)lround(-32000 * cos(angle)));
        pictures =
            worse_of(pictures, expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "exponent 1000"));
    }
    hard_pass("C4", "r.v just below 1, exponent 1000", text("2^-14 lost from the cosine costs %.1f codes", naive),
              text("power within %.3f codes (fixed), %.4f (float); pictures within %.2f", 255 * worst, 255 * codes,
                   pictures));
}

static void test_C5_exponent_zero(void **state)
{
    (void)state;
    const volatile double cosine = 0, exponent = 0;
    /* cppcheck-suppress invalidFunctionArg ; what is shown */
    const double naive = exp(exponent * log(cosine));
    assert_true(isnan(naive));
    for (int model = GLINT_PHONG; model <= GLINT_BLINN; model++) {
        static const int16_t lights[][3] = {{0, 0, -1}, {-30000, 0, -3000}, {0, 20000, -500}, {-1, 1, -1}};
        for (size_t i = 0; i < sizeof lights / sizeof *lights; i++) {
            board b;
            mirror_board(&b, 0);
            b.material.specular = board_grey(8192);
            b.material.specular_model = (uint8_t)model;
            board_light(&b, 0, lights[i][0], lights[i][1], lights[i][2]);
            expect_all(&b, 128, "exponent 0"); /* also where r.c is negative */
        }
    }
    hard_pass("C5", "exponent 0", text("exp(0 log 0) is %s", isnan(naive) ? "NaN" : "a number"),
              "1 at every pixel with n.l > 0, r.c negative included");
}

static void test_C6_fractional_exponents(void **state)
{
    (void)state;
    double naive = 0, worst = 0, worst_float = 0, pictures = 0;
    for (int e = 1; e < 400; e += e < 32 ? 1 : 13) {
        const double exponent = e / 16.0;
        for (int i = 1; i < 4096; i++) { /* a table of 256 cells over the cosine, linear between */
            const double x = i / 4096.0, low = floor(x * 256) / 256, high = low + 1.0 / 256;
            const double table = pow(low, exponent) + (x - low) * 256 * (pow(high, exponent) - pow(low, exponent));
            naive = worse_of(naive, 255 * fabs(table - pow(x, exponent)));
        }
        for (uint32_t i = 0; i < 20000; i++) { /* all of 0..1, and densely near a cosine of 0 */
            const uint32_t x_q31 = i < 10000 ? i * 214748 : (i - 10000) * (i - 10000);
            const uint32_t gap = ((uint32_t)1 << 31) - x_q31;
            const double exact = x_q31 ? pow(x_q31 / 2147483648.0, exponent) : 0;
            worst = worse_of(worst, fabs(glint_power_q15(gap, (uint16_t)e) / 32768.0 - exact));
            const float rounded = (float)gap / 2147483648.0f;
            const double x = 1 - (double)rounded;
            worst_float = worse_of(
                worst_float, fabs((double)glint_power(rounded, (float)exponent) - (x > 0 ? pow(x, exponent) : 0)));
        }
    }
    assert_true(naive > 50);
    assert_true(worst <= POWER_ERROR && worst_float <= FLOAT_POWER_ERROR);
    for (int e = 1; e < 64; e += 5) {
        board b;
        mirror_board(&b, 1);
        b.material.exponent_q4 = (uint16_t)e;
        board_light(&b, 0, -20000, 5000, -9000);
        pictures = worse_of(pictures, expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "below 1"));
    }
    hard_pass("C6", "exponent not whole, or below 1",
              text("a table over the cosine is off by %.0f codes near 0", naive),
              text("power within %.3f codes (fixed), %.4f (float); pictures within %.2f", 255 * worst,
                   255 * worst_float, pictures));
}

static void test_C7_huge_exponent(void **state)
{
    (void)state;
    double naive[2] = {0, 0}, worst = 0;
    for (int i = 0; i < BOARD_PX * BOARD_PX; i++) {
        double c[3];
        towards_eye(i, c); /* the light straight before the board, then half a pixel beside it */
        naive[0] = worse_of(naive[0], 255 * pow(c[2], 1e6));
        const double r[3] = {0.5 / (BOARD_PX / 2.0), 0, 1};
        naive[1] = worse_of(naive[1], 255 * pow(worse_of(dot3(r, c) / sqrt(dot3(r, r)), 0), 1e6));
    }
    assert_true(naive[0] > 250 && naive[1] < 1);
    for (int shift = 0; shift < 12; shift++) {
        board b;
        mirror_board(&b, GLINT_MAX_EXPONENT);
        board_light(&b, 0, shift * 100, shift * 37, -32000);
        worst = worse_of(worst, expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "exponent 1024"));
    }
    board b;
    mirror_board(&b, GLINT_MAX_EXPONENT);
    const glint_display display = {.width_px = BOARD_PX, .height_px = BOARD_PX};
    b.material.exponent_q4++;
    expect_refused(&b.scene, display, GLINT_ERROR_EXPONENT);
    b.material.exponent_q4 = UINT16_MAX;
    expect_refused(&b.scene, display, GLINT_ERROR_EXPONENT);
    hard_pass(
        "C7", "huge exponent", text("10^6: the highlight is %.0f codes, half a pixel on %.0f", naive[0], naive[1]),
        text("documented: sampled at pixel centres, exponent at most 1024 (%.2f codes off), above refused", worst));
}

static void test_C8_half_vector_undefined(void **state)
{
    (void)state;
    const volatile double s = -1, c = 1;
    const double naive = (s + c) / sqrt((s + c) * (s + c));
    assert_true(isnan(naive));
    board b;
    mirror_board(&b, 0); /* with exponent 0 any half vector at all would give 1 */
    b.material.specular_model = GLINT_BLINN;
    b.material.diffuse = board_grey(4096);
    board_normals(&b, 0, 0, -16384);
    board_light(&b, 0, 0, 0, 1); /* s = (0, 0, -1) = -c at the centre, n.s = 1 */
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        assert_int_equal(board_centre(&b, GLINT_SHADING_EXACT, backend), 64);
        frame f = board_draw(&b, GLINT_SHADING_EXACT, backend);
        assert_int_equal(f.pixels[0], 255); /* elsewhere there is one */
        frame_free(&f);
    }
    hard_pass("C8", "half vector undefined (l = -v)", text("h is %s", isnan(naive) ? "NaN" : "a number"),
              "no specular term at that pixel: diffuse (64) alone");
}

static void test_C9_highlight_between_dark_corners(void **state)
{
    (void)state;
    board b;
    mirror_board(&b, 64);
    double worst = 0;
    uint32_t exact_px = 0;
    const int gouraud[2] = {board_centre(&b, GLINT_SHADING_GOURAUD, FRAME_FIXED),
                            board_centre(&b, GLINT_SHADING_GOURAUD, FRAME_FLOAT)};
    assert_true(gouraud[0] < 5 && gouraud[1] < 5);
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        assert_int_equal(board_centre(&b, GLINT_SHADING_EXACT, backend), 255);
        frame exact = board_draw(&b, GLINT_SHADING_EXACT, backend), within = board_draw_within(&b, backend);
        assert_true(within.pixels[3 * HARD_CENTRE] >= 254);
        for (size_t i = 0; i < within.bytes; i++) {
            assert_true(abs(within.pixels[i] - exact.pixels[i]) <= 2); /* each within 1 code of the model */
        }
        exact_px = within.report.tier_pixels[GLINT_TIER_EXACT];
        frame_free(&exact);
        frame_free(&within);
    }
    worst = expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "highlight");
    hard_pass(
        "C9", "highlight inside a triangle whose vertices are dark",
        text("shading at the corners gives %d", gouraud[0]),
        text("exact shading: 255, within %.2f codes; at tolerance 1 the bound sees it: 254 or 255, %u of %d px exact",
             worst, (unsigned)exact_px, BOARD_PX * BOARD_PX));
}

static void test_C10_power_underflows(void **state)
{
    (void)state;
    const unsigned whole = 32;                              /* x = 2^-1, exponent 32 */
    const uint32_t naive = (uint32_t)32768 >> (whole & 31); /* as a processor that takes the shift modulo 32 */
    assert_int_equal(naive, 32768);
    long tried = 0;
    for (uint32_t e = 16 * 18; e <= 16384; e += 7) {
        /* t = -log2 x above 17 / exponent: below 2^-17 */
        const double x = exp2(-17.5 * 16 / e);
        for (int i = 0; i <= 200; i++) {
            const uint32_t x_q31 = (uint32_t)(x * 2147483648.0 * (200 - i) / 200);
            assert_int_equal(glint_power_q15(((uint32_t)1 << 31) - x_q31, (uint16_t)e), 0);
            tried++;
        }
        const float t = 41.0f * 16 / (float)e;
        assert_true(glint_power(1.0f - (float)exp2(-(double)t), (float)e / 16) == 0.0f);
        assert_true(glint_power(1.0f, (float)e / 16) == 0.0f);
    }
    hard_pass("C10", "power underflows", text("0.5^32 by a shift of 32 is %u/32768 where the shift wraps", naive),
              text("exactly 0 below 2^-17 for %ld pairs (float: below 2^-40)", tried));
}

static void test_C11_end_of_the_power_table(void **state)
{
    (void)state;
    const double naive = 255 * exp2(-6.0); /* a table of 2^-t that ends at t = 6, then 0 */
    double step = 0, last_fixed = 0, last_float = 0;
    assert_true(naive > 3);
    static const uint16_t exponents[] = {16, 160, 1024, 16384};
    for (size_t i = 0; i < sizeof exponents / sizeof *exponents; i++) {
        const double exponent = exponents[i] / 16.0;
        int32_t before = 32768;
        float before_float = 1;
        for (int t = 0; t < 45 * 512; t++) { /* steps of 1/512 in log2 */
            const double x = exp2(-t / 512.0 / exponent), gap = 1 - x;
            const int32_t value = glint_power_q15((uint32_t)(gap * 2147483648.0), exponents[i]);
            const float value_float = glint_power((float)gap, (float)exponent);
            step = worse_of(step, t > 0 ? abs(before - value) / 32768.0 - exp2(-t / 512.0) * 0.002 : 0);
            last_fixed = before > 0 && value == 0 ? worse_of(last_fixed, before / 32768.0) : last_fixed;
            last_float = before_float > 0 && value_float <= 0 ? worse_of(last_float, (double)before_float) : last_float;
            before = value;
            before_float = value_float;
        }
        assert_int_equal(before, 0);
        assert_true(before_float == 0.0f);
    }
    assert_true(last_fixed > 0 && last_fixed <= LAST_STEP);
    assert_true(last_float > 0 && last_float <= LAST_FLOAT_STEP);
    assert_true(step <= POWER_ERROR);
    hard_pass("C11", "end of the power table", text("a table to 2^-6 ends with a step of %.1f codes", naive),
              text("reaches exactly 0 from %.4f codes (fixed), %.0e (float)", 255 * last_fixed, 255 * last_float));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        hard_test(test_C1_highlight_on_the_dark_side),
        hard_test(test_C2_normal_away_from_the_viewer),
        hard_test(test_C3_cosine_above_one),
        hard_test(test_C4_large_exponent_near_one),
        hard_test(test_C5_exponent_zero),
        hard_test(test_C6_fractional_exponents),
        hard_test(test_C7_huge_exponent),
        hard_test(test_C8_half_vector_undefined),
        hard_test(test_C9_highlight_between_dark_corners),
        hard_test(test_C10_power_underflows),
        hard_test(test_C11_end_of_the_power_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
