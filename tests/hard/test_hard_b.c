/* SPDX-License-Identifier: MIT */
/*
 * Hard cases B: lights. docs/hard-cases.md has the defined behaviour; hard.h the form of a test.
 *
 * Budgets:
 */
#define SAME_CODES 1      /* a far point light against the directional light it stands for */
#define TERMINATOR_GAP 10 /* B2: codes that clamping at the corners loses, at least */

#include "examples/scenes/scenes.h"
#include "tests/hard/hard.h"

static void diffuse_board(board *b)
{
    board_set_up(b);
    b->material.diffuse = board_grey(16384);
}

static void point_light(board *b, double x, double y, double z)
{
    b->light[0].kind = GLINT_POINT;
    b->light[0].position_q16[0] = BOARD_Q16(x);
    b->light[0].position_q16[1] = BOARD_Q16(y);
    b->light[0].position_q16[2] = BOARD_Q16(z);
}

static void test_B1_light_from_behind(void **state)
{
    (void)state;
    board one, two;
    const double naive = worse_of(0.8 + -0.8, 0); /* the sum clamped, not each light */
    assert_true(naive < 0.01);
    diffuse_board(&one);
    board_light(&one, 0, -3, 0, -4);
    diffuse_board(&two);
    two.light[0] = one.light[0];
    board_light(&two, 1, 3, 0, 4);
    board_light(&two, 2, 0, 0, 1);
    two.scene.light_count = 3;
    expect_same_pictures(&one.scene, &two.scene, BOARD_PX, BOARD_PX);
    expect_all(&two, 204, "with lights behind");
    hard_pass("B1", "n.l < 0", text("code %.0f where 204 is right: one light takes away the other's", 255 * naive),
              "each light clamped: the same bytes with and without two lights behind");
}

/* Normals from -half to +half degrees about the terminator, left to right. */
static void test_B2_terminator_inside_a_triangle(void **state)
{
    (void)state;
    double worst = 0, loss = 0;
    const double half = 5 * 3.14159265358979 / 180;
    for (int i = 0; i <= 100; i++) {
        const double t = i / 100.0, clamped = t * sin(half), right = worse_of(sin((2 * t - 1) * half), 0);
        loss = worse_of(loss, 255 * fabs(clamped - right));
    }
    assert_true(loss > TERMINATOR_GAP);
    for (int turn = 0; turn < 4; turn++) {
        board b;
        diffuse_board(&b);
        for (int i = 0; i < 4; i++) {
            const double angle = b.positions[i][turn % 2] > 0 ? half : -half;
            b.normals[i][turn % 2] = (int16_t)lround(16384 * sin(angle) * (turn < 2 ? 1 : -1));
            b.normals[i][2] = (int16_t)lround(16384 * cos(angle));
        }
        board_light(&b, 0, turn % 2 == 0 ? -1 : 0, turn % 2, 0);
        worst = worse_of(worst, expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "terminator"));
    }
    hard_pass("B2", "terminator inside a triangle", text("clamped at the corners: %.1f codes off at 10 degrees", loss),
              text("clamped at each pixel: within %.2f codes", worst));
}

/* Light exactly in the board's plane. */
static void test_B3_cosine_exactly_zero(void **state)
{
    (void)state;
    static const int16_t directions[][2] = {{1, 0}, {-1, 0}, {0, 32767}, {3, 4}, {-5000, 12000}, {1, -32767}};
    static const uint16_t exponents[] = {0, 1, 16, 16384};
    /* >= for the specular term beside > for the diffuse one, exponent 0 */
    const double cosine = 0, naive = (cosine > 0 ? cosine : 0) + (cosine >= 0 ? 1 : 0);
    assert_true(naive > 0);
    for (size_t i = 0; i < sizeof directions / sizeof *directions; i++) {
        for (size_t e = 0; e < 2 * sizeof exponents / sizeof *exponents; e++) {
            board b;
            diffuse_board(&b);
            b.material.specular = board_grey(16384);
            b.material.exponent_q4 = exponents[e / 2];
            b.material.specular_model = e % 2 ? GLINT_BLINN : GLINT_PHONG;
            board_light(&b, 0, directions[i][0], directions[i][1], 0);
            expect_all(&b, 0, "grazing");
        }
    }
    hard_pass("B3", "n.l exactly 0", text("code %.0f where the two terms are compared differently", 255 * naive),
              "one comparison for both terms: all pixels 0, 6 directions, 8 materials");
}

static void test_B4_point_light_on_the_surface(void **state)
{
    (void)state;
    const volatile float distance = 0.0f;
    const float naive = distance / sqrtf(distance * distance);
    assert_true(isnan(naive));
    static const double places[][2] = {{0, 0}, {1, 0}, {-2.5, 1.25}};
    int most = 0;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        board b;
        diffuse_board(&b);
        b.material.ambient = b.scene.ambient = board_grey(8192);
        b.material.specular = board_grey(16384);
        b.material.exponent_q4 = 20 * 16;
        point_light(&b, places[i][0], places[i][1], 0); /* in the board: n.s is 0 everywhere else */
        for (int n = 0; n < FRAME_BACKENDS; n++) {
            frame f = board_draw(&b, GLINT_SHADING_EXACT, n);
            for (size_t k = 0; k < f.bytes; k++) {
                most = f.pixels[k] > most ? f.pixels[k] : most;
                assert_true(f.pixels[k] >= 64);
            }
            assert_int_equal(f.pixels[3 * HARD_CENTRE], 64);
            frame_free(&f);
        }
    }
    assert_true(most <= 65);
    /* the light in a corner of the mesh: Gouraud and flat shading ask there */
    board b;
    diffuse_board(&b);
    b.material.ambient = b.scene.ambient = board_grey(8192);
    b.material.specular = board_grey(16384);
    point_light(&b, -20, -20, 0);
    for (int n = 0; n < FRAME_BACKENDS; n++) {
        frame f = board_draw(&b, GLINT_SHADING_GOURAUD, n);
        for (size_t k = 0; k < f.bytes; k++) {
            assert_int_equal(f.pixels[k], 64);
        }
        frame_free(&f);
    }
    hard_pass("B4", "point light on the surface point",
              text("d over its length is %s", isnan(naive) ? "NaN" : "a number"),
              text("ambient (64) alone at the point; at most %d in the light's plane", most));
}

static void test_B5_light_very_far_away(void **state)
{
    (void)state;
    static const int32_t far_q16[] = {1 << 20, 1 << 24, 1 << 28, 1 << 30};
    double worst = 0;
    int most = 0;
    const uint32_t naive = (uint32_t)far_q16[3] * (uint32_t)far_q16[3];
    assert_int_equal(naive, 0);
    for (size_t i = 0; i < sizeof far_q16 / sizeof *far_q16; i++) {
        for (int corner = 0; corner < 4; corner++) {
            board b, d;
            diffuse_board(&b);
            diffuse_board(&d);
            b.material.specular = d.material.specular = board_grey(8192);
            b.material.exponent_q4 = d.material.exponent_q4 = 10 * 16;
            const int x = corner & 1 ? 1 : -1, y = corner & 2 ? 1 : -1;
            point_light(&b, 0, 0, 0);
            b.light[0].position_q16[0] = x * far_q16[i];
            b.light[0].position_q16[1] = y * far_q16[i];
            b.light[0].position_q16[2] = far_q16[i];
            board_light(&d, 0, -x, -y, -1);
            worst = worse_of(worst, expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "far light"));
            worst = worse_of(worst, expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_FLAT, "far light"));
            for (int n = 0; n < FRAME_BACKENDS && far_q16[i] > 1 << 28; n++) {
                frame f = board_draw(&b, GLINT_SHADING_EXACT, n), g = board_draw(&d, GLINT_SHADING_EXACT, n);
                for (size_t k = 0; k < f.bytes; k++) {
                    const int difference = abs(f.pixels[k] - g.pixels[k]);
                    most = difference > most ? difference : most;
                }
                frame_free(&f);
                frame_free(&g);
            }
        }
    }
    assert_true(most <= SAME_CODES);
    hard_pass("B5", "light very far away", text("d^2 of 16384 in Q16 is %u in 32 bits", naive),
              text("within %.2f codes of the reference; at 16384 within %d of a directional light", worst, most));
}

static void test_B6_attenuation_near_distance_zero(void **state)
{
    (void)state;
    const volatile double least = 0;
    const double naive = 1 / (least * least);
    const double near = 1 / (1.0 / 1024 * (1.0 / 1024)); /* of a light of 1 */
    assert_true(isinf(naive) && near > 1e6);
    board b;
    int tried = 0, saturated = 0;
    diffuse_board(&b);
    b.material.diffuse = board_grey(8192); /* half, so that too much light would be seen */
    /* 1 / d^2 and 1 / d, in a unit of the world's or of the light's own, straight before the middle */
    for (int kind = 0; kind < 4; kind++) {
        const double unit = kind & 1 ? 0.25 : 1;
        for (int32_t height_q16 = 1 << 22; height_q16 >= 64; height_q16 /= 2) {
            const double t = height_q16 / 65536.0 / unit, level = fmin(1, kind & 2 ? 1 / t : 1 / (t * t));
            point_light(&b, 0, 0, 0);
            memset(&b.light[0].attenuation, 0, sizeof b.light[0].attenuation);
            b.light[0].position_q16[2] = height_q16;
            b.light[0].attenuation.k_q14[kind & 2 ? 1 : 2] = 16384;
            b.light[0].attenuation.unit_q16 = kind & 1 ? 16384 : 0;
            expect_centre(&b, GLINT_SHADING_EXACT, level / 2, "attenuated");
            for (int n = 0; n < FRAME_BACKENDS && level == 1; n++) {
                assert_int_equal(board_centre(&b, GLINT_SHADING_EXACT, n), 128); /* and no more */
                saturated++;
            }
            tried++;
        }
        point_light(&b, 0, 0, 0);
        b.light[0].attenuation.k_q14[2] = 16384;
        expect_centre(&b, GLINT_SHADING_EXACT, 0, "distance 0");
    }
    /* near the board: saturated below the light, falling beside it */
    point_light(&b, 0, 0, 0);
    b.light[0].position_q16[2] = 3 << 14;
    b.light[0].attenuation.k_q14[2] = 16384;
    const double worst = expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "near");
    hard_pass("B6", "attenuation near distance 0",
              text("1 / d^2 is %f at 0, %.0f times the light at 1/1024", naive, near),
              text("min(1, 1 / d^2), at each of %d distances from 64 to 1/1024, all of the light and no more at %d; "
                   "none at 0; beside it within %.2f codes",
                   tried, saturated, worst));
}

static void test_B7_light_behind_the_face(void **state)
{
    (void)state;
    board b;
    double worst = 0;
    diffuse_board(&b);
    board_normals(&b, 11585, 0, 11585);
    board_light(&b, 0, -16000, 0, 4000); /* s = (0.97, 0, -0.24): behind the face, before the normal */
    const double s = 4 / sqrt(17.0), level = (s - s / 4) * 11585 / sqrt(2.0 * 11585 * 11585);
    expect_centre(&b, GLINT_SHADING_EXACT, level, "lit by the normal");
    expect_centre(&b, GLINT_SHADING_GOURAUD, level, "lit by the normal");
    expect_centre(&b, GLINT_SHADING_FLAT, 0, "the face looks away");
    worst = expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "behind");
    hard_pass("B7", "light behind the face, normal leans to it",
              text("lit with %.0f codes by its normal, 0 by its face", 255 * level),
              text("documented: n.s of the normal decides (no geometric gate): within %.2f codes", worst));
}

static void test_B8_negative_colours(void **state)
{
    (void)state;
    const uint8_t naive = (uint8_t)(-1 * 255 / 255);
    assert_int_equal(naive, 255);
    glint_display display = {.width_px = BOARD_PX, .height_px = BOARD_PX};
    int refused = 0;
    for (int k = 0; k < 18; k++) {
        static const int errors[6] = {GLINT_ERROR_LIGHT_COLOUR, GLINT_ERROR_AMBIENT,     GLINT_ERROR_BACKGROUND,
                                      GLINT_ERROR_REFLECTANCE,  GLINT_ERROR_REFLECTANCE, GLINT_ERROR_REFLECTANCE};
        board b;
        diffuse_board(&b);
        glint_colour *const colours[6] = {&b.light[0].colour,  &b.scene.ambient,    &b.scene.background,
                                          &b.material.ambient, &b.material.diffuse, &b.material.specular};
        int16_t *const channels[3] = {&colours[k / 3]->r_q14, &colours[k / 3]->g_q14, &colours[k / 3]->b_q14};
        *channels[k % 3] = -1;
        expect_refused(&b.scene, display, errors[k / 3]);
        *channels[k % 3] = INT16_MIN;
        expect_refused(&b.scene, display, errors[k / 3]);
        refused += 2;
    }
    hard_pass("B8", "negative light colour or reflectance", text("-1 becomes %u in 8 bits", naive),
              text("refused with an error in all %d places, nothing written", refused));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        hard_test(test_B1_light_from_behind),     hard_test(test_B2_terminator_inside_a_triangle),
        hard_test(test_B3_cosine_exactly_zero),   hard_test(test_B4_point_light_on_the_surface),
        hard_test(test_B5_light_very_far_away),   hard_test(test_B6_attenuation_near_distance_zero),
        hard_test(test_B7_light_behind_the_face), hard_test(test_B8_negative_colours),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
