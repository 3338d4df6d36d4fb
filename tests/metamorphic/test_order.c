/* SPDX-License-Identifier: MIT */
/*
 * What must become of a picture when the corners of its triangles are rotated, or its objects drawn in another order.
 *
 * Budgets:
 *   corners rotated   silhouettes: none, since a triangle's three edges run as before, and the edge functions are
 * exact. Shaded: 1 code; planes are set up from another corner, with other rounding. Flat: the mean of the corners and
 * the cross product do not depend on the order but for rounding: 1 code too. objects           none in either backend,
 * as no two surfaces have equal depth at a pixel (see world.h).
 */
#define ROTATED_CODES 1
#define ROTATED_SHARE 0.0002 /* measured: 0.000002 */

#include "tests/metamorphic/world.h"

#define MOST_TRIANGLES 528

static void rotate_corners(world *w, glint_mesh meshes[WORLD_OBJECTS],
                           uint16_t triangles[WORLD_OBJECTS][MOST_TRIANGLES][3])
{
    for (int i = 0; i < WORLD_OBJECTS; i++) {
        meshes[i] = *w->objects[i].mesh;
        for (uint16_t t = 0; t < meshes[i].triangle_count; t++) {
            const int by = world_between(0, 2);
            for (int k = 0; k < 3; k++) {
                triangles[i][t][k] = meshes[i].triangles[t][(k + by) % 3];
            }
        }
        meshes[i].triangles = (const uint16_t(*)[3])triangles[i];
        w->objects[i].mesh = &meshes[i];
    }
}

static void test_rotated_corners(void **state)
{
    comparison silhouettes = {0}, sum[FRAME_BACKENDS] = {{0}}, within[FRAME_BACKENDS] = {{0}};
    (void)world_seed(state);
    for (int n = 0; n < WORLD_SCENES; n++) {
        static world w, rotated;
        static glint_mesh meshes[WORLD_OBJECTS];
        static uint16_t triangles[WORLD_OBJECTS][MOST_TRIANGLES][3];
        world_make(&w);
        world_copy(&rotated, &w);
        rotate_corners(&rotated, meshes, triangles);
        world_compare_within(within, &w, &rotated, 0, 0, NULL);
        for (int i = 0; i < FRAME_BACKENDS * (WORLD_SHADINGS + 1); i++) {
            const int backend = i % FRAME_BACKENDS, shading = i / FRAME_BACKENDS;
            if (i == FRAME_BACKENDS * WORLD_SHADINGS) {
                world_silhouette(&w);
                world_silhouette(&rotated);
            }
            const int outline = shading == WORLD_SHADINGS;
            frame a = world_draw(&w, WORLD_WIDTH, outline ? GLINT_SHADING_FLAT : shading, backend);
            frame b = world_draw(&rotated, WORLD_WIDTH, outline ? GLINT_SHADING_FLAT : shading, backend);
            world_compare(outline ? &silhouettes : &sum[backend], &a, &b, 0, 0, NULL);
            frame_free(&a);
            frame_free(&b);
        }
    }
    world_expect(&silhouettes, "corners rotated, silhouettes, both", 0, 0);
    world_expect(&sum[FRAME_FIXED], "corners rotated, fixed", ROTATED_CODES, ROTATED_SHARE);
    world_expect(&sum[FRAME_FLOAT], "corners rotated, float", ROTATED_CODES, ROTATED_SHARE);
    world_expect_within(within, "corners rotated", WITHIN_CODES, ANY_SHARE);
}

/*
 * Random edges hardly ever meet a pixel's centre, where the fill rule decides. So: the 8 x 8 grid, head on, a pixel a
 * cell, its corners on pixel centres. 4 px a unit at a distance of 7, as the focal length is half the height, 28 px.
 */
static void test_rotated_corners_on_pixel_centres(void **state)
{
    static world w, rotated;
    static glint_mesh meshes[WORLD_OBJECTS];
    static uint16_t triangles[WORLD_OBJECTS][MOST_TRIANGLES][3];
    (void)world_seed(state);
    memset(&w, 0, sizeof w);
    w.camera.eye_q16[2] = 7 * (int32_t)ONE_Q16;
    w.camera.field_of_view_turn16 = 16384;
    w.camera.near_q16 = (int32_t)ONE_Q16;
    w.scene.camera = &w.camera;
    w.scene.objects = w.objects;
    w.scene.lights = w.lights;
    for (int i = 0; i < WORLD_OBJECTS; i++) {
        w.objects[i].mesh = &glint_mesh_plane;
        w.objects[i].material = &w.materials[i];
        w.objects[i].place = glint_turn_x(16384); /* y, the plane's outside, to z, the eye */
        w.objects[i].place.origin_q16[0] = (i - 1) * 4 * (int32_t)ONE_Q16 + (1 << 13);
        w.objects[i].place.origin_q16[1] = 1 << 13;
    }
    w.scene.object_count = WORLD_OBJECTS;
    world_silhouette(&w);
    w.scene.background.r_q14 = w.scene.background.g_q14 = w.scene.background.b_q14 = 8192;
    for (int n = 0; n < WORLD_SCENES; n++) {
        world_copy(&rotated, &w);
        rotate_corners(&rotated, meshes, triangles);
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame a = world_draw(&w, WORLD_WIDTH, GLINT_SHADING_FLAT, backend);
            frame b = world_draw(&rotated, WORLD_WIDTH, GLINT_SHADING_FLAT, backend);
            assert_int_equal(a.report.pixels_shaded, WORLD_OBJECTS * 8 * 8);
            assert_int_equal(b.report.pixels_shaded, WORLD_OBJECTS * 8 * 8);
            assert_memory_equal(a.pixels, b.pixels, a.bytes);
            frame_free(&a);
            frame_free(&b);
        }
    }
}

static void test_order_of_objects(void **state)
{
    static const int orders[][WORLD_OBJECTS] = {{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    comparison sum[FRAME_BACKENDS] = {{0}}, within[FRAME_BACKENDS] = {{0}};
    (void)world_seed(state);
    for (int n = 0; n < WORLD_SCENES; n++) {
        static world w, other;
        world_make(&w);
        world_copy(&other, &w);
        const int *order = orders[n % 5];
        for (int i = 0; i < WORLD_OBJECTS; i++) {
            other.objects[i] = w.objects[order[i]];
        }
        world_compare_within(within, &w, &other, 0, 0, NULL);
        for (int i = 0; i < FRAME_BACKENDS * WORLD_SHADINGS; i++) {
            const int backend = i % FRAME_BACKENDS;
            frame a = world_draw(&w, WORLD_WIDTH, i / FRAME_BACKENDS, backend);
            frame b = world_draw(&other, WORLD_WIDTH, i / FRAME_BACKENDS, backend);
            world_compare(&sum[backend], &a, &b, 0, 0, NULL);
            frame_free(&a);
            frame_free(&b);
        }
    }
    world_expect(&sum[FRAME_FIXED], "objects in another order, fixed", 0, 0);
    world_expect(&sum[FRAME_FLOAT], "objects in another order, float", 0, 0);
    world_expect_within(within, "objects in another order", 0, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rotated_corners),
        cmocka_unit_test(test_rotated_corners_on_pixel_centres),
        cmocka_unit_test(test_order_of_objects),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
