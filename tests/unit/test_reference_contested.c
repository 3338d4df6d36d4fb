/* SPDX-License-Identifier: MIT */
/*
 * Tests of the reference's judgement: which pixels are contested, by whom, and what a verdict counts.
 */
#include "tests/unit/reference_world.h"

static void terminator_is_contested(void **state)
{
    world w;
    reference_candidate c[4];
    (void)state;
    set_up(&w);
    set_direction(&w, 1, 0, 0);
    w.material[0].specular = (glint_colour){8192, 8192, 8192};
    for (int shading = 0; shading < 3; shading++) {
        draw(&w, shading);
        expect_level(level_at(&w, 20, 11)[0], 0.0); /* n.s = 0 is not > 0 */
        assert_int_equal(w.image.mask[11 * SIZE + 20], REFERENCE_TERMINATOR);
        int count = reference_candidates(&w.image, 20, 11, c, 4);
        assert_int_equal(count, shading == GLINT_SHADING_GOURAUD ? 8 : 2);
        expect_level(c[0].high[0], 0.0);
        if (count == 2) {
            expect_level(c[1].low[0], 0.5);
        }
        reference_free(&w.image);
    }
    w.material[0].exponent_q4 = 16; /* r.c is -s.c, and c has no share of -s left of the middle */
    draw(&w, GLINT_SHADING_EXACT);
    assert_int_equal(w.image.mask[11 * SIZE + 40], 0);
    assert_int_equal(w.image.mask[11 * SIZE + 20], REFERENCE_TERMINATOR);
    reference_free(&w.image);
}

static void first_of_equals_stays_and_is_contested(void **state)
{
    world w;
    reference_candidate c[8];
    (void)state;
    set_up(&w);
    w.scene.object_count = 2;
    draw(&w, GLINT_SHADING_EXACT);
    assert_in_range(w.image.triangle[20 * SIZE + 25], 0, 1);
    assert_int_equal(w.image.mask[20 * SIZE + 25], REFERENCE_DEPTH);
    assert_int_equal(reference_candidates(&w.image, 25, 20, c, 8), 2);
    expect_level(c[0].low[1], 0.5);
    expect_level(c[1].high[0], 1.0);
    reference_free(&w.image);
    /* 65519 * 0.5 / 5 = 6552 steps: 1/128 behind is 10 steps */
    w.object[1].place.linear_q16[0][0] = w.object[1].place.linear_q16[1][1] = w.object[1].place.linear_q16[2][2] =
        65536;
    w.object[1].place.origin_q16[2] = 512;
    draw(&w, GLINT_SHADING_EXACT);
    assert_in_range(w.image.triangle[20 * SIZE + 25], 2, 3);
    assert_int_equal(w.image.mask[20 * SIZE + 25], 0);
    reference_free(&w.image);
}

/* The square's diagonal runs through pixel centres: either triangle may be seen there, but never the background. The
 * square's lower edge is moved onto pixel centres: there the background may be seen. */
static void edges_are_contested_but_cracks_are_not_excused(void **state)
{
    world w;
    reference_candidate c[8];
    reference_verdict v;
    static uint8_t codes[SIZE * SIZE * 3];
    (void)state;
    set_up(&w);
    w.object[0].place.linear_q16[0][0] = w.object[0].place.linear_q16[2][2] = 65536;
    w.object[0].place.linear_q16[1][1] = 65536;
    draw(&w, GLINT_SHADING_EXACT);
    assert_int_equal(w.image.mask[31 * SIZE + 32], REFERENCE_EDGE);
    assert_int_equal(reference_candidates(&w.image, 32, 31, c, 8), 2);
    assert_int_equal(c[0].triangle + c[1].triangle, 1);
    reference_codes(&w.image, codes);
    reference_check(&w.image, codes, 0.0, &v);
    assert_int_equal(v.contested, 52);
    assert_int_equal(v.unmatched, 0);
    codes[(31 * SIZE + 32) * 3] = 0;
    codes[(31 * SIZE + 32) * 3 + 1] = 0;
    codes[(31 * SIZE + 32) * 3 + 2] = 64; /* the background */
    reference_check(&w.image, codes, 1.0, &v);
    assert_int_equal(v.unmatched, 1);
    assert_int_equal(v.unmatched_x, 32);
    assert_int_equal(v.unmatched_y, 31);
    reference_free(&w.image);

    /* -4 + dy is seen at y = 32 + 32 (4 - dy) / 5 px: dy = 1/64 brings 57.6 to 57.5 */
    w.object[0].place.origin_q16[1] = 1024;
    draw(&w, GLINT_SHADING_EXACT);
    assert_int_equal(w.image.mask[57 * SIZE + 20], REFERENCE_EDGE);
    assert_int_equal(reference_candidates(&w.image, 20, 57, c, 8), 2);
    assert_true(c[0].triangle == -1 || c[1].triangle == -1);
    reference_free(&w.image);

    /* 6.4 / 65536 px in each step: 30 steps are within 1/256 px, 51 are beyond */
    w.object[0].place.origin_q16[1] = 1024 - 30;
    draw(&w, GLINT_SHADING_EXACT);
    assert_int_equal(w.image.mask[57 * SIZE + 20], REFERENCE_EDGE);
    reference_free(&w.image);
    w.object[0].place.origin_q16[1] = 1024 - 51;
    draw(&w, GLINT_SHADING_EXACT);
    assert_int_equal(w.image.mask[57 * SIZE + 20], 0);
    assert_in_range(w.image.triangle[57 * SIZE + 20], 0, 1);
    reference_free(&w.image);
}

/* The square as a floor y = -1 under the eye, cut at the near plane. The centres of row 52 see it at a depth of
 * 32 / 20.5 = 102300.1 / 65536: just beyond the near plane, or just before it. The diagonal's neighbour does not seal
 * that cut. */
static void edge_of_the_near_plane_is_contested(void **state)
{
    world w;
    reference_candidate c[4];
    (void)state;
    set_up(&w);
    w.object[0].place = (glint_place){{{65536, 0, 0}, {0, 0, 65536}, {0, -65536, 0}}, {0, -65536, 65536}};
    for (int before = 0; before < 2; before++) {
        w.camera.near_q16 = 102300 + before;
        draw(&w, GLINT_SHADING_EXACT);
        for (int x = 8; x < 56; x++) {
            assert_int_equal(w.image.triangle[52 * SIZE + x] < 0, before);
            assert_int_equal(w.image.mask[52 * SIZE + x], REFERENCE_EDGE);
            assert_in_range(reference_candidates(&w.image, x, 52, c, 4), 2, 3);
            assert_true(c[0].triangle < 0 || c[1].triangle < 0);
            assert_true(w.image.triangle[51 * SIZE + x] >= 0 && w.image.triangle[53 * SIZE + x] < 0);
        }
        reference_free(&w.image);
    }
}

/* A triangle seen nearly edge-on through the pixel centres x = 32.5: its far corner is off the plane through the eye
 * (X = Z / 64) by 1/1024, 1/192 px. Of either winding it may be seen, since that is less than 2/256 px; a corner that
 * is off by 1/8 px makes sure of its facing. */
static void edge_on_triangles_are_contested(void **state)
{
    static const uint16_t turned[1][3] = {{0, 2, 1}};
    int16_t positions[3][3] = {{80, -UNIT, 0}, {80, UNIT, 0}, {97, 0, -UNIT}};
    glint_mesh mesh = {(const int16_t(*)[3])positions, square_normals, one_triangle, 3, 1, UNIT_BITS, 0, NULL};
    world w;
    reference_candidate c[4];
    int away = 0;
    (void)state;
    set_up(&w);
    w.object[0].mesh = &mesh;
    for (int winding = 0; winding < 2; winding++) {
        mesh.triangles = winding ? turned : one_triangle;
        positions[2][0] = 97;
        draw(&w, GLINT_SHADING_EXACT);
        assert_int_equal(w.image.mask[31 * SIZE + 32], REFERENCE_EDGE);
        assert_int_equal(reference_candidates(&w.image, 32, 31, c, 4), 2);
        reference_free(&w.image);
        positions[2][0] = 120;
        draw(&w, GLINT_SHADING_EXACT);
        bool seen = w.image.mask[31 * SIZE + 32] != 0; /* its edge is on the centre still */
        away += !seen;
        assert_int_equal(reference_candidates(&w.image, 32, 31, c, 4), seen ? 2 : 1);
        reference_free(&w.image);
    }
    assert_int_equal(away, 1);
}

static void verdict_counts_what_differs(void **state)
{
    world w;
    reference_verdict v;
    static uint8_t codes[SIZE * SIZE * 3];
    (void)state;
    set_up(&w);
    draw(&w, GLINT_SHADING_EXACT);
    reference_codes(&w.image, codes);
    reference_check(&w.image, codes, 1.0, &v);
    assert_true(v.max_codes <= 0.5 && v.mean_codes <= 0.5 && v.psnr_db > 1e300);
    assert_int_equal(v.differing, 0);
    assert_int_equal(v.pixels, SIZE * SIZE);
    codes[(20 * SIZE + 25) * 3 + 1] = (uint8_t)(codes[(20 * SIZE + 25) * 3 + 1] - 3); /* 128 of 127.5 */
    codes[(20 * SIZE + 26) * 3] = (uint8_t)(codes[(20 * SIZE + 26) * 3] - 1);
    reference_check(&w.image, codes, 1.0, &v);
    expect_level(v.max_codes, 2.5);
    assert_int_equal(v.worst_x, 25);
    assert_int_equal(v.worst_y, 20);
    assert_int_equal(v.differing, 2);
    assert_int_equal(v.above, 1);
    assert_int_equal(v.above_unexplained, 1);
    expect_level(v.psnr_db, 10.0 * log10(255.0 * 255.0 * 3.0 * (v.pixels - v.contested) / 10.0));
    reference_free(&w.image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(terminator_is_contested),
        cmocka_unit_test(first_of_equals_stays_and_is_contested),
        cmocka_unit_test(edges_are_contested_but_cracks_are_not_excused),
        cmocka_unit_test(edge_of_the_near_plane_is_contested),
        cmocka_unit_test(edge_on_triangles_are_contested),
        cmocka_unit_test(verdict_counts_what_differs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
