/* SPDX-License-Identifier: MIT */
/*
 * Tests of the double-precision reference against closed forms: each picture here can be worked out with pen and paper.
 * The budget is LEVEL_ERROR in reference_world.h.
 */
#include "tests/unit/reference_world.h"

/* The direction from the square's point at a pixel to the eye, times 1 / cos of its angle with z. */
static void to_eye(int x, int y, double c[3])
{
    c[0] = -(x + 0.5 - 32.0) / 32.0;
    c[1] = (y + 0.5 - 32.0) / 32.0;
    c[2] = 1.0;
}

static double cosine_to_eye(int x, int y)
{
    double c[3];
    to_eye(x, y, c);
    return 1.0 / sqrt(c[0] * c[0] + c[1] * c[1] + 1.0);
}

static void ambient_and_diffuse_follow_the_formula(void **state)
{
    world w;
    (void)state;
    set_up(&w);
    set_direction(&w, -3, 0, -4); /* n.s = 4 / 5 */
    w.material[0].ambient = (glint_colour){4096, 0, 16384};
    w.scene.ambient = (glint_colour){8192, 8192, 8192};
    w.light.colour = (glint_colour){16384, 8192, 20480};
    for (int shading = 0; shading < 3; shading++) {
        draw(&w, shading);
        for (int i = 0; i < SIZE * SIZE; i++) {
            if (w.image.triangle[i] >= 0) {
                expect_level(w.image.rgb[i * 3], 0.25 * 0.5 + 0.5 * 0.8);
                expect_level(w.image.rgb[i * 3 + 1], 0.5 * 0.5 * 0.8);
                expect_level(w.image.rgb[i * 3 + 2], 1.0); /* 0.5 + 1.25 * 0.5 * 0.8, and not clamped before */
            } else {
                expect_level(w.image.rgb[i * 3 + 2], 0.25);
            }
        }
        reference_free(&w.image);
    }
}

/* The square's edges are at 32 +- 25.6 px. */
static void square_covers_its_pixels(void **state)
{
    world w;
    (void)state;
    set_up(&w);
    draw(&w, GLINT_SHADING_FLAT);
    for (int y = 0; y < SIZE; y++) {
        for (int x = 0; x < SIZE; x++) {
            bool inside = x >= 6 && x < 58 && y >= 6 && y < 58;
            assert_int_equal(w.image.triangle[y * SIZE + x] >= 0, inside);
            if (inside) {
                expect_level(w.image.depth[y * SIZE + x], 5.0);
            }
        }
    }
    reference_free(&w.image);
}

static void highlight_is_at_the_mirror_direction(void **state)
{
    world w;
    (void)state;
    set_up(&w);
    double c[3], target[3], best = -1.0;
    int best_x = 0, best_y = 0;
    to_eye(40, 32, target);
    set_direction(&w, (int)(target[0] * 640.0), (int)(target[1] * 640.0), -640); /* (-170, 10, -640) exactly */
    w.material[0].diffuse = (glint_colour){0, 0, 0};
    w.material[0].specular = (glint_colour){8192, 16384, 4096};
    w.material[0].exponent_q4 = 20 * 16;
    draw(&w, GLINT_SHADING_EXACT);
    for (int y = 8; y < 56; y++) {
        for (int x = 8; x < 56; x++) {
            to_eye(x, y, c);
            double cosine = (c[0] * target[0] + c[1] * target[1] + 1.0) * cosine_to_eye(x, y) * cosine_to_eye(40, 32);
            expect_level(level_at(&w, x, y)[1], pow(cosine, 20.0));
            expect_level(level_at(&w, x, y)[0], 0.5 * pow(cosine, 20.0));
            if (level_at(&w, x, y)[1] > best) {
                best = level_at(&w, x, y)[1];
                best_x = x;
                best_y = y;
            }
        }
    }
    assert_int_equal(best_x, 40);
    assert_int_equal(best_y, 32);
    expect_level(best, 1.0);
    reference_free(&w.image);
}

/* Light from the left at s = (-4, 0, 3) / 5: where r.c < 0 there is no highlight, not even of an odd or broken power.
 */
static void highlight_ends_at_a_right_angle(void **state)
{
    world w;
    int dark = 0;
    (void)state;
    set_up(&w);
    set_direction(&w, 4, 0, -3);
    w.material[0].diffuse = (glint_colour){0, 0, 0};
    w.material[0].specular = (glint_colour){16384, 16384, 16384};
    for (int exponent_q4 = 16; exponent_q4 < 64; exponent_q4 += 8) {
        w.material[0].exponent_q4 = (uint16_t)exponent_q4;
        draw(&w, GLINT_SHADING_EXACT);
        for (int x = 8; x < 57; x++) {
            double c[3];
            to_eye(x, 30, c);
            double cosine = (4.0 * c[0] + 3.0) / 5.0 * cosine_to_eye(x, 30);
            expect_level(level_at(&w, x, 30)[0], cosine > 0.0 ? pow(cosine, exponent_q4 / 16.0) : 0.0);
            dark += cosine < 0.0;
        }
        reference_free(&w.image);
    }
    assert_true(dark > 0);
}

/* A light at the eye: s = c, so r.c = cos 2t and, with Blinn, n.h = cos t. */
static void point_light_at_the_eye(void **state)
{
    world w;
    (void)state;
    set_up(&w);
    w.light.kind = GLINT_POINT;
    w.light.position_q16[2] = Q16(5);
    w.material[0].diffuse = (glint_colour){8192, 0, 0};
    w.material[0].specular = (glint_colour){0, 16384, 0};
    w.material[0].exponent_q4 = 24; /* 1.5 */
    for (int blinn = 0; blinn < 2; blinn++) {
        w.material[0].specular_model = blinn ? GLINT_BLINN : GLINT_PHONG;
        draw(&w, GLINT_SHADING_EXACT);
        for (int i = 8; i < 56; i++) {
            double cosine = cosine_to_eye(i, 20), twice = 2.0 * cosine * cosine - 1.0;
            expect_level(level_at(&w, i, 20)[0], 0.5 * cosine);
            expect_level(level_at(&w, i, 20)[1], pow(blinn ? cosine : twice, 1.5));
        }
        reference_free(&w.image);
    }
}

/* Light along -z: the half vector halves the angle between c and n. */
static void blinn_halves_the_angle(void **state)
{
    world w;
    (void)state;
    set_up(&w);
    w.material[0].diffuse = (glint_colour){0, 0, 0};
    w.material[0].specular = (glint_colour){16384, 16384, 16384};
    w.material[0].exponent_q4 = 8 * 16;
    w.material[0].specular_model = GLINT_BLINN;
    draw(&w, GLINT_SHADING_EXACT);
    for (int i = 8; i < 56; i++) {
        expect_level(level_at(&w, i, 33)[0], pow((1.0 + cosine_to_eye(i, 33)) / 2.0, 4.0));
    }
    reference_free(&w.image);
}

static void specular_ends_where_the_light_is_behind(void **state)
{
    world w;
    (void)state;
    set_up(&w);
    w.material[0].ambient = (glint_colour){4096, 4096, 4096};
    w.scene.ambient = (glint_colour){16384, 16384, 16384};
    w.material[0].diffuse = (glint_colour){0, 0, 0};
    w.material[0].specular = (glint_colour){8192, 8192, 8192};
    for (int model = 0; model < 2; model++) {
        w.material[0].exponent_q4 = 0; /* 0^0 is 1: the whole lit side shines */
        w.material[0].specular_model = (uint8_t)model;
        set_direction(&w, 1000, 0, -1);
        draw(&w, GLINT_SHADING_EXACT);
        expect_level(level_at(&w, 10, 10)[0], 0.75);
        expect_level(level_at(&w, 50, 40)[0], 0.75);
        reference_free(&w.image);
        set_direction(&w, 1000, 0, 1);
        draw(&w, GLINT_SHADING_EXACT);
        expect_level(level_at(&w, 10, 10)[0], 0.25);
        assert_int_equal(w.image.mask[10 * SIZE + 10], 0);
        reference_free(&w.image);
    }
}

/* A floor y = -1 from z = 4.8 to z = -11 with a normal at each corner, cut at the near plane z = 3.5. */
static const int16_t floor_positions[3][3] = {
    {-8 * UNIT, -UNIT, 4915}, {8 * UNIT, -UNIT, 4915}, {0, -UNIT, -11 * UNIT}};
static const int16_t floor_normals[3][3] = {{16384, 0, 0}, {0, 16384, 0}, {0, 0, 8000}};
static const glint_mesh floor_mesh = {floor_positions, floor_normals, one_triangle, 3, 1, UNIT_BITS, 0, NULL};
#define FLOOR_END (4915.0 / UNIT)
#define FLOOR_NEAR 1.5

static void set_up_floor(world *w)
{
    set_up(w);
    w->camera.near_q16 = Q16(FLOOR_NEAR);
    w->object[0].mesh = &floor_mesh;
    set_direction(w, -2, -3, -6); /* s = (2, 3, 6) / 7 */
}

static void floor_has_perspective_barycentrics(void **state)
{
    world w;
    int seen = 0;
    (void)state;
    set_up_floor(&w);
    draw(&w, GLINT_SHADING_EXACT);
    for (int y = 0; y < SIZE; y++) {
        for (int x = 0; x < SIZE; x++) {
            double z_view = 32.0 / (y + 0.5 - 32.0), px = (x + 0.5 - 32.0) / 32.0 * z_view, pz = 5.0 - z_view;
            double b2 = (FLOOR_END - pz) / (FLOOR_END + 11.0);
            double b1 = ((px + 8.0) - b2 * 8.0) / 16.0, b0 = 1.0 - b1 - b2; /* x = -8 b0 + 8 b1 */
            bool inside = z_view > FLOOR_NEAR && b0 >= 0.0 && b1 >= 0.0 && b2 >= 0.0;
            assert_int_equal(w.image.triangle[y * SIZE + x] >= 0, inside);
            if (inside) {
                expect_level(w.image.depth[y * SIZE + x] / z_view, 1.0);
                expect_level(level_at(&w, x, y)[0],
                             0.5 * (2.0 * b0 + 3.0 * b1 + 6.0 * b2) / 7.0 / sqrt(b0 * b0 + b1 * b1 + b2 * b2));
                seen++;
            }
        }
    }
    assert_in_range(seen, 300, 2000);
    reference_free(&w.image);
}

/* What is left of the floor is a triangle with two new corners on the near plane, a fraction t of the way from corner
 * 2, at which the colour is that far between the corners' (1/7, 3/14, 3/7); on the screen it is linear. */
static void gouraud_is_cut_at_the_near_plane(void **state)
{
    world w;
    int seen = 0;
    double t = (16.0 - FLOOR_NEAR) / (11.0 + FLOOR_END), bottom = 32.0 + 32.0 / FLOOR_NEAR,
           reach = 32.0 * 8.0 * t / FLOOR_NEAR;
    double left = 3.0 / 7.0 + t * (1.0 / 7.0 - 3.0 / 7.0), right = 3.0 / 7.0 + t * (1.5 / 7.0 - 3.0 / 7.0);
    (void)state;
    set_up_floor(&w);
    draw(&w, GLINT_SHADING_GOURAUD);
    for (int y = 0; y < SIZE; y++) {
        for (int x = 0; x < SIZE; x++) {
            double v = (y + 0.5 - 34.0) / (bottom - 34.0), u = (x + 0.5 - 32.0) / reach; /* |u| <= v inside */
            if (w.image.triangle[y * SIZE + x] >= 0) {
                expect_level(level_at(&w, x, y)[0],
                             (1.0 - v) * 3.0 / 7.0 + (v - u) / 2.0 * left + (v + u) / 2.0 * right);
                seen++;
            }
        }
    }
    assert_in_range(seen, 300, 2000);
    reference_free(&w.image);
}

/* Corners at (16, 48), (48, 48), (16, 16) px but at depths 5, 2.5 and 10: Gouraud is linear on the screen all the same,
 * with f X / Z = -16, 16 and so on. */
static void gouraud_is_linear_on_the_screen(void **state)
{
    static const int16_t positions[3][3] = {{-5 * UNIT / 2, -5 * UNIT / 2, 0},
                                            {5 * UNIT / 4, -5 * UNIT / 4, 5 * UNIT / 2},
                                            {-5 * UNIT, 5 * UNIT, -5 * UNIT}};
    static const int16_t normals[3][3] = {{16384, 0, 0}, {0, 16384, 0}, {0, 0, 16384}};
    static const glint_mesh mesh = {positions, normals, one_triangle, 3, 1, UNIT_BITS, 0, NULL};
    world w;
    (void)state;
    set_up(&w);
    w.object[0].mesh = &mesh;
    set_direction(&w, -2, -3, -6);
    w.material[0].diffuse = (glint_colour){16384, 16384, 16384};
    draw(&w, GLINT_SHADING_GOURAUD);
    assert_int_equal(w.image.triangle[40 * SIZE + 20], 0);
    double b1 = 4.5 / 32.0, b2 = 7.5 / 32.0;
    expect_level(level_at(&w, 20, 40)[0], (2.0 * (1.0 - b1 - b2) + 3.0 * b1 + 6.0 * b2) / 7.0);
    reference_free(&w.image);
}

/* Corners on the three axes: the face normal is (1, 1, 1) / sqrt 3. It serves in flat shading and for stored zeros. */
static void face_normal_is_used(void **state)
{
    static const int16_t positions[3][3] = {{2 * UNIT, 0, 0}, {0, 2 * UNIT, 0}, {0, 0, 2 * UNIT}};
    static const int16_t zero[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    static const glint_mesh mesh = {positions, zero, one_triangle, 3, 1, UNIT_BITS, 0, NULL};
    world w;
    (void)state;
    set_up(&w);
    w.object[0].mesh = &mesh;
    w.light.direction[2] = -1; /* n.s = 1 / sqrt 3 */
    for (int shading = 0; shading < 3; shading++) {
        draw(&w, shading);
        assert_int_equal(w.image.triangle[28 * SIZE + 35], 0);
        expect_level(level_at(&w, 35, 28)[0], 0.5 / sqrt(3.0));
        reference_free(&w.image);
    }
}

/* The one pixel of the picture looks at (1/4, -1/2, 0). There b_2 = (y + 1) / 2 = 1/4 and b_1 - b_0 = x = 1/4, so that
 * b = (1/4, 1/2, 1/4) and the normals (x, -x, x) cancel out. */
static void cancelling_normals_leave_the_face_normal(void **state)
{
    static const int16_t positions[3][3] = {{-UNIT, -UNIT, 0}, {UNIT, -UNIT, 0}, {0, UNIT, 0}};
    static const int16_t normals[3][3] = {{16384, 0, 0}, {-16384, 0, 0}, {16384, 0, 0}};
    static const glint_mesh mesh = {positions, normals, one_triangle, 3, 1, UNIT_BITS, 0, NULL};
    world w;
    (void)state;
    set_up(&w);
    w.object[0].mesh = &mesh;
    w.camera.target_q16[0] = Q16(0.25);
    w.camera.eye_q16[0] = Q16(3.25); /* aslant, so that the face normal is not the direction to the eye */
    w.camera.eye_q16[1] = w.camera.target_q16[1] = Q16(-0.5);
    char error[100] = "";
    if (reference_render(&w.scene, 1, 1, GLINT_SHADING_EXACT, &w.image, error, sizeof error) || !w.image.triangle) {
        fail_msg("%s", error);
        abort(); /* fail_msg() does not return, but the compiler is not told */
    }
    assert_int_equal(w.image.triangle[0], 0);
    expect_level(w.image.rgb[0], 0.5); /* the face's n.s = 1; along x it would be 0 */
    reference_free(&w.image);
}

static void mirrored_place_keeps_outside_outside(void **state)
{
    world w;
    (void)state;
    set_up(&w);
    for (int mirror = 0; mirror < 3; mirror++) {
        memset(&w.object[0].place, 0, sizeof w.object[0].place);
        for (int i = 0; i < 3; i++) {
            w.object[0].place.linear_q16[i][i] = i == mirror ? -65536 : 65536;
        }
        draw(&w, GLINT_SHADING_EXACT);
        if (mirror == 2) { /* its outside is turned to -z */
            assert_int_equal(w.image.triangle[20 * SIZE + 20], -1);
        } else {
            assert_in_range(w.image.triangle[20 * SIZE + 20], 0, 1);
            expect_level(level_at(&w, 20, 20)[0], 0.5);
        }
        reference_free(&w.image);
    }
}

/* One triangle of the unit sphere, normals = positions, stretched by (2, 1, 1/2): the normals of the ellipsoid
 * x^2/4 + y^2 + 4 z^2 = 1 at its corners are along (x/4, y, 4z), (x, y, z) on the ellipsoid. */
static void stretched_sphere_has_the_ellipsoid_normals(void **state)
{
    static const double scale[3] = {2.0, 1.0, 0.5};
    static const int16_t ball[3][3] = {{12288, 0, 10837}, {0, 12288, 10837}, {-9000, -9000, 10266}};
    static const glint_mesh mesh = {ball, ball, one_triangle, 3, 1, 14, 0, NULL};
    world w;
    double n[3][3], p[3][3];
    int seen = 0;
    (void)state;
    set_up(&w);
    w.camera.eye_q16[2] = Q16(2);
    w.object[0].mesh = &mesh;
    set_direction(&w, -2, -3, -6);
    for (int i = 0; i < 3; i++) {
        double l = 0.0;
        w.object[0].place.linear_q16[i][i] = Q16(scale[i]);
        for (int k = 0; k < 3; k++) {
            p[i][k] = ball[i][k] / 16384.0 * scale[k];
            n[i][k] = p[i][k] / (scale[k] * scale[k]);
            l += n[i][k] * n[i][k];
        }
        for (int k = 0; k < 3; k++) {
            n[i][k] /= sqrt(l);
        }
    }
    draw(&w, GLINT_SHADING_EXACT);
    for (int i = 0; i < SIZE * SIZE; i++) {
        if (w.image.triangle[i] == 0) {
            int column = i % SIZE, row = i / SIZE;
            double z = w.image.depth[i], x = (column + 0.5 - 32.0) / 32.0 * z, y = -(row + 0.5 - 32.0) / 32.0 * z;
            /* barycentric from x and y, by Cramer's rule */
            double a = p[0][0] - p[2][0], b = p[1][0] - p[2][0], c = p[0][1] - p[2][1], d = p[1][1] - p[2][1];
            double b0 = ((x - p[2][0]) * d - b * (y - p[2][1])) / (a * d - b * c);
            double b1 = (a * (y - p[2][1]) - c * (x - p[2][0])) / (a * d - b * c), sum[3], l = 0.0;
            for (int k = 0; k < 3; k++) {
                sum[k] = b0 * n[0][k] + b1 * n[1][k] + (1.0 - b0 - b1) * n[2][k];
                l += sum[k] * sum[k];
            }
            expect_level(2.0 - z, b0 * p[0][2] + b1 * p[1][2] + (1.0 - b0 - b1) * p[2][2]);
            expect_level(w.image.rgb[i * 3],
                         fmax(0.0, 0.5 * (2.0 * sum[0] + 3.0 * sum[1] + 6.0 * sum[2]) / 7.0 / sqrt(l)));
            seen++;
        }
    }
    assert_in_range(seen, 50, 1000);
    reference_free(&w.image);
}

/* A small triangle around (1, 1.5, 0) is seen at (32 + 6.4, 32 - 9.6); with up = -x, x goes down and y to the right. */
static void camera_follows_its_conventions(void **state)
{
    static const int16_t positions[3][3] = {
        {UNIT - 90, 3 * UNIT / 2 - 90, 0}, {UNIT + 90, 3 * UNIT / 2 - 90, 0}, {UNIT, 3 * UNIT / 2 + 90, 0}};
    static const glint_mesh mesh = {positions, square_normals, one_triangle, 3, 1, UNIT_BITS, 0, NULL};
    world w;
    (void)state;
    set_up(&w);
    w.object[0].mesh = &mesh;
    draw(&w, GLINT_SHADING_FLAT);
    assert_int_equal(w.image.triangle[22 * SIZE + 38], 0);
    reference_free(&w.image);
    w.camera.up[0] = -7;
    draw(&w, GLINT_SHADING_FLAT);
    assert_int_equal(w.image.triangle[38 * SIZE + 41], 0);
    reference_free(&w.image);
    w.camera.eye_q16[2] = Q16(-5); /* from behind: its inside */
    draw(&w, GLINT_SHADING_FLAT);
    for (int i = 0; i < SIZE * SIZE; i++) {
        assert_int_equal(w.image.triangle[i], -1);
    }
    reference_free(&w.image);
}

static void what_cannot_be_drawn_is_an_error(void **state)
{
    static const uint16_t wrong[1][3] = {{0, 1, 4}};
    glint_mesh mesh = square;
    world w;
    char error[200] = "";
    (void)state;
    set_up(&w);
    assert_int_equal(reference_render(&w.scene, 0, 4, 0, &w.image, error, sizeof error), -1);
    assert_int_equal(reference_render(&w.scene, 4, 4, 3, &w.image, error, sizeof error), -1);
    mesh.triangles = wrong;
    mesh.triangle_count = 1;
    w.object[0].mesh = &mesh;
    assert_int_equal(reference_render(&w.scene, 4, 4, 0, &w.image, error, sizeof error), -1);
    assert_non_null(strstr(error, "vertex 4"));
    assert_null(w.image.rgb);
    w.scene.camera = NULL;
    assert_int_equal(reference_render(&w.scene, 4, 4, 0, &w.image, NULL, 0), -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ambient_and_diffuse_follow_the_formula),
        cmocka_unit_test(square_covers_its_pixels),
        cmocka_unit_test(highlight_is_at_the_mirror_direction),
        cmocka_unit_test(highlight_ends_at_a_right_angle),
        cmocka_unit_test(point_light_at_the_eye),
        cmocka_unit_test(blinn_halves_the_angle),
        cmocka_unit_test(specular_ends_where_the_light_is_behind),
        cmocka_unit_test(floor_has_perspective_barycentrics),
        cmocka_unit_test(gouraud_is_cut_at_the_near_plane),
        cmocka_unit_test(gouraud_is_linear_on_the_screen),
        cmocka_unit_test(face_normal_is_used),
        cmocka_unit_test(cancelling_normals_leave_the_face_normal),
        cmocka_unit_test(mirrored_place_keeps_outside_outside),
        cmocka_unit_test(stretched_sphere_has_the_ellipsoid_normals),
        cmocka_unit_test(camera_follows_its_conventions),
        cmocka_unit_test(what_cannot_be_drawn_is_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
