/* SPDX-License-Identifier: MIT */
/*
 * Hard cases A: normals. docs/hard-cases.md has the defined behaviour; hard.h the form of a test.
 *
 * Budgets:
 */
#define UNIT_ULP 1.2       /* of Q15, a component of a fixed-point unit vector: what number/fixed.h states */
#define SIGN_CODES 1       /* between a picture and its mirror image: rays are rounded in one direction */
#define SCALE_DEGREES 10.0 /* A8: the naive normal is at least that wrong */

#include "examples/scenes/scenes.h"
#include "tests/hard/sheet.h"

#include "number/fixed.h"

static const double sixth[3] = {0.6, 0, 0.8};

/* Lit from the side, so that another normal gives another code. */
static void lit_board(board *b, int x, int y, int z)
{
    board_set_up(b);
    b->material.diffuse = board_grey(16384);
    board_light(b, 0, x, y, z);
}

static void test_A1_zero_length_normal(void **state)
{
    (void)state;
    board zero, stored;
    const volatile float nothing = 0.0f;
    const float naive = nothing / sqrtf(nothing * nothing); /* the first component of v / |v| */
    assert_true(isnan(naive));
    lit_board(&zero, -3, 0, -4);
    lit_board(&stored, -3, 0, -4);
    board_normals(&zero, 0, 0, 0);
    expect_same_pictures(&zero.scene, &stored.scene, BOARD_PX, BOARD_PX);
    expect_centre(&zero, GLINT_SHADING_EXACT, sixth[2], "face normal");

    /* corners in a line have no face normal, but snapping may give them an area: then n is the direction to the viewer
     */
    enum { SIDE = 16 };
    static sheet s;
    static const glint_light light = {.direction = {-3, 0, -4}, .colour = GLINT_WHITE};
    long pixels[FRAME_BACKENDS] = {0, 0};
    for (int round = 0; round < 20000; round++) {
        const int32_t x = hard_between(-32767, 32767), y = hard_between(-32767, 32767);
        const int32_t dx = hard_between(-(32767 + x) / 2, (32767 - x) / 2);
        const int32_t dy = hard_between(-(32767 + y) / 2, (32767 - y) / 2);
        int32_t line[3][2] = {{x, y}, {x + dx, y + dy}, {x + 2 * dx, y + 2 * dy}};
        if (round % 64 == 0) {
            sheet_begin(&s, SIDE, SIDE, 12);
        }
        sheet_add(&s, line);
        if (round % 64 != 63) {
            continue;
        }
        memset(s.normals, 0, sizeof s.normals);
        s.material.ambient = board_grey(0);
        s.material.diffuse = board_grey(16384);
        s.scene.lights = &light;
        s.scene.light_count = 1;
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame f = sheet_draw(&s, GLINT_SHADING_EXACT, backend);
            for (int i = 0; i < SIDE * SIDE; i++) {
                const int column = i % SIDE, row = i / SIDE;
                double c[3] = {SIDE / 2.0 - column - 0.5, row + 0.5 - SIDE / 2.0, SIDE / 2.0};
                unit3(c);
                const double level = worse_of(dot3(c, sixth), 0);
                if (f.pixels[i] != 0 || level == 0) {
                    assert_true(fabs(f.pixels[i] - 255 * level) <= HARD_CODES);
                    pixels[backend]++;
                }
            }
            frame_free(&f);
        }
    }
    assert_true(pixels[0] > 20 && pixels[1] > 20);
    hard_pass("A1", "zero-length vertex normal", text("v over its length is %s", isnan(naive) ? "NaN" : "a number"),
              text("the face normal, same bytes as stored; corners in a line: the viewer's direction, %ld and %ld px",
                   pixels[0], pixels[1]));
}

/* Greatest error of a unit vector's component in ulp of Q15. */
static double unit_error(const int32_t v[3])
{
    int32_t unit[3];
    double exact[3] = {v[0], v[1], v[2]}, worst = 0;
    assert_true(glint_unit_q15(v, unit));
    unit3(exact);
    for (int k = 0; k < 3; k++) {
        worst = worse_of(worst, fabs(unit[k] - 32768 * exact[k]));
    }
    return worst;
}

static void test_A3_tiny_normal(void **state)
{
    (void)state;
    double worst = 0;
    int naive = 0, tried = 0;
    for (int32_t n = 1; n < 41 * 41 * 41; n++) {
        const int32_t v[3] = {n % 41 - 20, n / 41 % 41 - 20, n / 1681 - 20};
        if (v[0] == 0 && v[1] == 0 && v[2] == 0) {
            continue;
        }
        /* squares of Q15 components, kept in Q15 */
        naive += ((v[0] * v[0]) >> 15) + ((v[1] * v[1]) >> 15) + ((v[2] * v[2]) >> 15) == 0;
        tried++;
        worst = worse_of(worst, unit_error(v));
    }
    assert_int_equal(naive, tried); /* (20, 20, 20) still squares to 0 */
    assert_true(worst <= UNIT_ULP);
    const int32_t one[3] = {1, 0, 0};
    int32_t unit[3];
    assert_true(glint_unit_q15(one, unit) && unit[0] == 32768 && unit[1] == 0 && unit[2] == 0);
    board tiny, full;
    lit_board(&tiny, -3, 0, -4);
    lit_board(&full, -3, 0, -4);
    board_normals(&tiny, 0, 0, 1);
    expect_same_pictures(&tiny.scene, &full.scene, BOARD_PX, BOARD_PX);
    hard_pass("A3", "tiny normal such as (1,0,0)", text("squares to zero for %d of %d vectors up to 20", naive, tried),
              text("direction within %.2f ulp of Q15; (0,0,1) draws the bytes of (0,0,16384)", worst));
}

static void test_A4_huge_components(void **state)
{
    (void)state;
    double worst = 0;
    int naive = 0, tried = 0;
    for (int round = 0; round < 100000; round++) {
        int32_t v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = hard_between(INT32_MAX - 100000, INT32_MAX) * (hard_random() & 1 ? 1 : -1);
        }
        v[round % 3] >>= round % 8; /* not all of one size */
        const uint32_t squares =
            (uint32_t)v[0] * (uint32_t)v[0] + (uint32_t)v[1] * (uint32_t)v[1] + (uint32_t)v[2] * (uint32_t)v[2];
        const double length = sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
        naive += fabs(sqrt(squares) - length) > 0.01 * length; /* the sum as 32 bits hold it */
        tried++;
        worst = worse_of(worst, unit_error(v));
    }
    assert_int_equal(naive, tried);
    assert_true(worst <= UNIT_ULP);
    board huge;
    lit_board(&huge, 0, 0, -1);
    board_normals(&huge, 32767, 32767, 32767);
    expect_centre(&huge, GLINT_SHADING_EXACT, 1 / sqrt(3), "huge");
    expect_centre(&huge, GLINT_SHADING_GOURAUD, 1 / sqrt(3), "huge");
    hard_pass("A4", "huge components", text("the 32-bit sum of squares is wrong for %d of %d", naive, tried),
              text("direction within %.2f ulp of Q15", worst));
}

static void test_A5_most_negative_component(void **state)
{
    (void)state;
    static const int32_t few[] = {INT32_MIN, INT32_MIN + 1, INT32_MAX, -1, 0, 1, 12345};
    double worst = 0;
    const int32_t naive = (int32_t)(0u - (uint32_t)INT32_MIN); /* what -INT32_MIN is where it wraps */
    assert_true(naive < 0);
    for (int n = 0; n < 343; n++) {
        const int32_t v[3] = {few[n % 7], few[n / 7 % 7], few[n / 49]};
        if (v[0] != 0 || v[1] != 0 || v[2] != 0) {
            worst = worse_of(worst, unit_error(v));
        }
    }
    assert_true(worst <= UNIT_ULP);
    const int32_t least[3] = {INT32_MIN, 0, 0};
    int32_t unit[3];
    assert_true(glint_unit_q15(least, unit) && unit[0] == -32768 && unit[1] == 0 && unit[2] == 0);
    board b;
    lit_board(&b, 0, 0, INT16_MIN); /* s = (0, 0, 1) */
    expect_all(&b, 255, "light direction");
    board_normals(&b, INT16_MIN, INT16_MIN, INT16_MIN);
    board_light(&b, 0, INT16_MAX, INT16_MAX, INT16_MAX);
    expect_centre(&b, GLINT_SHADING_EXACT, 1, "normal");
    b.camera.up[1] = INT16_MIN; /* upside down */
    expect_centre(&b, GLINT_SHADING_EXACT, 1, "up");
    hard_pass("A5", "INT32_MIN or INT16_MIN component", text("the negation stays %d", (int)naive),
              text("exact -1 for (INT32_MIN,0,0); at most %.2f ulp; normals, directions and up drawn", worst));
}

static void test_A6_exact_one(void **state)
{
    (void)state;
    const int naive = 0x7fff * 255 >> 15;
    assert_int_equal(naive, 254);
    board b;
    board_set_up(&b);
    b.material.ambient = b.scene.ambient = board_grey(16384);
    expect_all(&b, 255, "ambient");
    lit_board(&b, 0, 0, -1);
    expect_all(&b, 255, "diffuse");
    b.material.diffuse = board_grey(0);
    b.material.specular = board_grey(16384);
    expect_all(&b, 255, "specular, exponent 0");
    for (int format = GLINT_RGB565; format <= GLINT_GREY8; format++) {
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame f = hard_draw(&b.scene, BOARD_PX, BOARD_PX, (uint8_t)format, GLINT_SHADING_EXACT, backend);
            for (size_t i = 0; i < f.bytes; i++) {
                assert_int_equal(f.pixels[i], 255);
            }
            frame_free(&f);
        }
    }
    hard_pass("A6", "1.0 as 0x7FFF", text("white is %d", naive), "white is 255: each term, each shading, each format");
}

static void test_A7_normals_not_of_unit_length(void **state)
{
    (void)state;
    static const int lengths[] = {1, 7, 1000, 8192, 16383, 20000, 32767};
    board b, full;
    lit_board(&full, -3, 0, -4);
    const int naive = (int)lround(255 * 0.8 * 8192 / 16384); /* n.s with n as it is stored */
    const int right = board_centre(&full, GLINT_SHADING_EXACT, FRAME_FIXED);
    assert_true(abs(naive - right) > 50);
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        lit_board(&b, -3, 0, -4);
        board_normals(&b, 0, 0, lengths[i]);
        expect_same_pictures(&b.scene, &full.scene, BOARD_PX, BOARD_PX);
        board_normals(&b, lengths[i] / 5 * 3, 0, lengths[i] / 5 * 4);
        if (lengths[i] > 5) {
            expect_centre(&b, GLINT_SHADING_EXACT, 1, "towards the light");
        }
    }
    hard_pass("A7", "normals not of unit length", text("code %d instead of %d at half the length", naive, right),
              "normalised on reading: the same bytes at lengths 1 to 32767 of 16384");
}

static void test_A8_non_uniform_scale(void **state)
{
    (void)state;
    /* (1, 1, 0) on a body that is drawn out four times along y */
    double by_matrix[3] = {1, 4, 0}, by_inverse[3] = {1, 0.25, 0};
    unit3(by_matrix);
    unit3(by_inverse);
    const double naive = acos(dot3(by_matrix, by_inverse)) * 180 / 3.14159265358979;
    assert_true(naive > SCALE_DEGREES);
    double worst = 0;
    static const int32_t factors[][3] = {{1, 4, 1}, {3, 1, 1}, {1, 1, 5}, {1, 2, 3}};
    for (size_t i = 0; i < sizeof factors / sizeof *factors; i++) {
        glint_scene scene = demo_sphere_32x16;
        glint_object object = scene.objects[0];
        const glint_place scale = glint_scale(factors[i][0] * 16384, factors[i][1] * 16384, factors[i][2] * 16384);
        const glint_place turn = glint_turn_z(5000);
        glint_place place = glint_then(&scale, &turn);
        place = glint_then(&place, &scene.objects[0].place);
        object.place = place;
        scene.objects = &object;
        scene.object_count = 1;
        worst = worse_of(worst, expect_reference(&scene, 96, 96, GLINT_SHADING_EXACT, "scaled"));
        worst = worse_of(worst, expect_reference(&scene, 96, 96, GLINT_SHADING_GOURAUD, "scaled"));
    }
    hard_pass("A8", "non-uniform scale", text("the normal of (1,1,0) is off by %.0f degrees at a scale of 4", naive),
              text("inverse transpose: within %.2f codes of the reference", worst));
}

static void test_A9_mirroring_transform(void **state)
{
    (void)state;
    const glint_scene *plain = &demo_sphere_32x16;
    const glint_mesh *mesh = plain->objects[0].mesh;
    /* Naive: the winding on the display alone. Orthographic along z; mirrored in x. */
    int outside = 0, naive = 0;
    for (uint16_t t = 0; t < mesh->triangle_count; t++) {
        double p[3][2];
        for (int i = 0; i < 3; i++) {
            p[i][0] = mesh->positions[mesh->triangles[t][i]][0];
            p[i][1] = mesh->positions[mesh->triangles[t][i]][1];
        }
        const double area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
        const double mirrored = (p[0][0] - p[1][0]) * (p[2][1] - p[0][1]) - (p[0][0] - p[2][0]) * (p[1][1] - p[0][1]);
        outside += area > 0;
        naive += area > 0 && mirrored > 0;
    }
    assert_true(outside > 100 && naive == 0);
    double worst = 0;
    long drawn[2] = {0, 0};
    for (int axis = 0; axis < 4; axis++) {
        glint_scene scene = *plain;
        glint_object object = plain->objects[0];
        const glint_place mirror =
            glint_scale(axis == 0 || axis == 3 ? -65536 : 65536, axis == 1 || axis == 3 ? -65536 : 65536,
                        axis == 2 || axis == 3 ? -65536 : 65536);
        object.place = glint_then(&mirror, &plain->objects[0].place);
        scene.objects = &object;
        scene.object_count = 1;
        worst = worse_of(worst, expect_reference(&scene, 96, 96, GLINT_SHADING_EXACT, "mirrored"));
        worst = worse_of(worst, expect_reference(&scene, 96, 96, GLINT_SHADING_FLAT, "mirrored"));
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame f = hard_draw(&scene, 96, 96, GLINT_RGB888, GLINT_SHADING_EXACT, backend);
            assert_true(f.report.triangles_drawn > 100);
            drawn[backend] += (long)f.report.triangles_drawn;
            frame_free(&f);
        }
    }
    hard_pass("A9", "mirroring transform", text("%d of %d faces that look outwards are kept", naive, outside),
              text("within %.2f codes of the reference; %ld and %ld triangles drawn in 4 mirrorings", worst, drawn[0],
                   drawn[1]));
}

static void test_A10_normals_away_from_the_face(void **state)
{
    (void)state;
    board b;
    double worst = 0;
    int lit = 0;
    for (int degrees = 90; degrees <= 180; degrees += 5) {
        const double angle = degrees * 3.14159265358979 / 180;
        lit_board(&b, (int)lround(-20000 * sin(angle)), 0, (int)lround(-20000 * cos(angle))); /* s = n */
        board_normals(&b, (int)lround(16384 * sin(angle)), 0, (int)lround(16384 * cos(angle)));
        expect_centre(&b, GLINT_SHADING_EXACT, 1, "leaning");
        expect_centre(&b, GLINT_SHADING_GOURAUD, 1, "leaning");
        expect_centre(&b, GLINT_SHADING_FLAT, worse_of(cos(angle), 0), "the face itself");
        worst = worse_of(worst, expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "leaning"));
        lit += cos(angle) < 0;
    }
    hard_pass("A10", "normals more than 90 degrees from the face",
              text("light from behind the face shows in %d of 19 directions", lit),
              text("documented: the stored normal is used as it is, no geometric gate; within %.2f codes", worst));
}

static void test_A11_all_normals_equal(void **state)
{
    (void)state;
    board b;
    for (int degrees = 0; degrees < 90; degrees += 7) {
        const double angle = degrees * 3.14159265358979 / 180;
        lit_board(&b, (int)lround(-20000 * sin(angle)), 0, (int)lround(-20000 * cos(angle)));
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame flat = board_draw(&b, GLINT_SHADING_FLAT, backend);
            frame exact = board_draw(&b, GLINT_SHADING_EXACT, backend);
            frame within = board_draw_within(&b, backend);
            assert_int_equal(within.report.tier_pixels[GLINT_TIER_FLAT], BOARD_PX * BOARD_PX);
            for (size_t i = 0; i < flat.bytes; i++) {
                assert_true(abs(flat.pixels[i] - exact.pixels[i]) <= 1);
                assert_true(abs(within.pixels[i] - exact.pixels[i]) <= 1);
                assert_true(degrees > 0 || flat.pixels[i] == exact.pixels[i]);
            }
            frame_free(&within);
            frame_free(&flat);
            frame_free(&exact);
        }
    }
    hard_pass("A11", "all normals equal", text("the model %d times where once would do", BOARD_PX * BOARD_PX),
              "at tolerance 1 one colour a triangle; it, flat and exact shading agree within 1 code");
}

static void test_A12_rounding_of_negatives(void **state)
{
    (void)state;
    int naive = 0, differing = 0;
    double worst = 0;
    for (int32_t x = 1; x < 32768; x++) {
        /* cppcheck-suppress shiftNegativeLHS ; what is shown */
        naive += (x * 23170) >> 15 != -((-x * 23170) >> 15);
    }
    assert_true(naive > 30000);
    for (int round = 0; round < 300000; round++) {
        int32_t v[3], mirrored[3], a[3], c[3];
        for (int k = 0; k < 3; k++) {
            v[k] = hard_between(-32768, 32767) * ((int32_t)1 << round % 16);
            mirrored[k] = -v[k];
        }
        if (glint_unit_q15(v, a) && glint_unit_q15(mirrored, c)) {
            assert_true(a[0] == -c[0] && a[1] == -c[1] && a[2] == -c[2]);
        }
    }
    for (int round = 0; round < 60; round++) {
        board b, m;
        const int x = hard_between(-12000, 12000), y = hard_between(-9000, 9000), z = -16000;
        const int nx = hard_between(-7000, 7000), ny = hard_between(-7000, 7000), nz = 13000;
        lit_board(&b, x, y, z);
        lit_board(&m, -x, -y, z);
        board_normals(&b, nx, ny, nz);
        board_normals(&m, -nx, -ny, nz);
        b.material.specular = m.material.specular = board_grey(8192);
        b.material.exponent_q4 = m.material.exponent_q4 = 8 * 16;
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame f = board_draw(&b, GLINT_SHADING_EXACT, backend), g = board_draw(&m, GLINT_SHADING_EXACT, backend);
            for (int i = 0; i < BOARD_PX * BOARD_PX; i++) {
                const int one = f.pixels[3 * i], other = g.pixels[3 * (BOARD_PX * BOARD_PX - 1 - i)];
                assert_true(abs(one - other) <= SIGN_CODES);
                differing += one != other;
            }
            frame_free(&f);
            frame_free(&g);
            worst = worse_of(worst, abs(board_centre(&b, GLINT_SHADING_EXACT, backend) -
                                        board_centre(&m, GLINT_SHADING_EXACT, backend)));
        }
    }
    assert_true(worst == 0);
    hard_pass("A12", "rounding of negatives by >>", text("(-x) k >> 15 is not -(x k >> 15) for %d of 32767", naive),
              text("unit(-v) = -unit(v) for 300000; mirrored pictures within 1 code, %d of %d px differ", differing,
                   120 * BOARD_PX * BOARD_PX));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        hard_test(test_A1_zero_length_normal),
        hard_test(test_A3_tiny_normal),
        hard_test(test_A4_huge_components),
        hard_test(test_A5_most_negative_component),
        hard_test(test_A6_exact_one),
        hard_test(test_A7_normals_not_of_unit_length),
        hard_test(test_A8_non_uniform_scale),
        hard_test(test_A9_mirroring_transform),
        hard_test(test_A10_normals_away_from_the_face),
        hard_test(test_A11_all_normals_equal),
        hard_test(test_A12_rounding_of_negatives),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
