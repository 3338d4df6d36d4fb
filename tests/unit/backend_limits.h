/* SPDX-License-Identifier: MIT */
/*
 * Parts of a backend at limits that a scene reaches seldom or, by construction, never: polygons that are not convex,
 * corners that are not finite, a corner in the eye, colours that interpolation takes beyond their range.
 *
 * A test file includes the backend's source, for its static functions, and then this.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>

#include <cmocka.h>

#define CANARIES 4
#define CANARY_BYTE 0xa5

/* The near plane at 1000 units of depth. */
#define NEAR 1000

/* Clipping at the near plane, for polygons that go to and fro through it: what a convex one cannot, and one bent by
 * rounding could. The corners that are kept come in order, and none is written past the end of the array. */
static void expect_cut(const corner *polygon, int count)
{
    transform_state transform;
    corner room[CLIP_MOST + CANARIES];
    uint8_t canaries[CANARIES * sizeof *room];
    int kept = 0, wanted = 0;
    memset(&transform, 0, sizeof transform);
    transform.near_z = NEAR;
    memset(room, CANARY_BYTE, sizeof room);
    memset(canaries, CANARY_BYTE, sizeof canaries);
    memcpy(room, polygon, (size_t)count * sizeof *polygon);
    kept = clip_at_plane(&transform, 0, room, count);
    assert_memory_equal(&room[CLIP_MOST], canaries, sizeof canaries);
    for (int i = 0; i < count; i++) {
        const corner *a = &polygon[i], *b = &polygon[(i + 1) % count];
        if (a->view.z > NEAR && wanted++ < CLIP_MOST) {
            assert_memory_equal(&room[wanted - 1], a, sizeof *a);
        }
        if ((a->view.z > NEAR) != (b->view.z > NEAR) && wanted++ < CLIP_MOST) {
            /* half way, by what the corners are: depth NEAR +- 500, x the number of the corner times 64 */
            const corner *c = &room[wanted - 1];
            const double middle = (double)(a->view.x + b->view.x) / 2;
            assert_true((double)c->view.z >= NEAR - 1 && (double)c->view.z <= NEAR + 1);
            assert_true((double)c->view.x >= middle - 1 && (double)c->view.x <= middle + 1);
            assert_true((double)c->attribute[0] >= middle - 1 && (double)c->attribute[0] <= middle + 1);
        }
    }
    assert_int_equal(kept, wanted < CLIP_MOST ? wanted : CLIP_MOST);
}

static void test_polygons_that_are_not_convex(void **state)
{
    (void)state;
    for (int count = 3; count <= CLIP_MOST; count++) {
        for (int inside = 0; inside < 1 << count; inside++) { /* a bit a corner */
            corner polygon[CLIP_MOST];
            memset(polygon, 0, sizeof polygon);
            for (int i = 0; i < count; i++) {
                polygon[i].view.x = polygon[i].attribute[0] = (real)(i * 64);
                polygon[i].view.z = (real)(inside >> i & 1 ? NEAR + 500 : NEAR - 500);
            }
            expect_cut(polygon, count);
        }
    }
}

/* A triangle's fate before clipping, for each kind of corner in each place. */
static void test_fates_by_kinds_of_corners(void **state)
{
    static const int32_t kind[4] = {GLINT_DEPTH_BIAS, VERTEX_NEAR, VERTEX_BEYOND, VERTEX_NOT_FINITE};
    (void)state;
    for (int n = 0; n < 64; n++) {
        const int32_t depth[3] = {kind[n & 3], kind[n >> 2 & 3], kind[n >> 4 & 3]};
        glint_screen_vertex screen[3];
        int seen[4] = {0, 0, 0, 0};
        enum triangle_fate fate;
        memset(screen, 0, sizeof screen);
        for (int i = 0; i < 3; i++) {
            screen[i].depth_q30 = depth[i];
            seen[n >> (2 * i) & 3]++;
        }
        const glint_screen_vertex *const corner_at[3] = {&screen[0], &screen[1], &screen[2]};
        const bool clip = needs_clipping(corner_at, &fate);
        assert_int_equal(clip, seen[0] < 3);
        assert_int_equal(fate, seen[3] > 0 ? TRIANGLE_REFUSED : seen[1] == 3 ? TRIANGLE_OUTSIDE : TRIANGLE_DRAWN);
    }
}

/* A corner in the eye has no direction to the eye, so it has the ambient term alone, whatever lights there are. */
static void test_a_corner_in_the_eye(void **state)
{
    static const int16_t positions[3][3] = {{0, 0, 0}, {300, 5, -900}, {3, 500, -900}};
    static const int16_t normals[3][3] = {{0, 0, 16384}, {0, 0, 16384}, {0, 0, 16384}};
    static const uint16_t triangles[1][3] = {{0, 1, 2}};
    static const glint_mesh mesh = {.positions = positions,
                                    .normals_q14 = normals,
                                    .triangles = triangles,
                                    .vertex_count = 3,
                                    .triangle_count = 1,
                                    .fraction_bits = 4};
    const glint_material material = {.ambient = {16384, 8192, 4096},
                                     .diffuse = {9000, 9000, 9000},
                                     .specular = {7000, 7000, 7000},
                                     .exponent_q4 = 16};
    const glint_light lights[2] = {
        {.kind = GLINT_DIRECTIONAL, .direction = {1, -2, -9}, .colour = {16384, 16384, 16384}},
        {.kind = GLINT_POINT, .position_q16 = {0, 1 << 16, 3 << 16}, .colour = {16384, 16384, 16384}}};
    (void)state;
    for (int n = 0; n < 6; n++) {
        /* n = 0: the eye is where the corner is; otherwise at another corner, or at none, and the corner is lit */
        const glint_camera camera = {.eye_q16 = {0, 0, n < 3 ? 0 : 3 << 16},
                                     .target_q16 = {0, 1 << 16, -10 * (1 << 16)},
                                     .field_of_view_turn16 = 8192,
                                     .near_q16 = 1 << 16};
        const glint_object source = {.mesh = &mesh, .material = &material};
        const glint_scene scene = {.camera = &camera,
                                   .objects = &source,
                                   .object_count = 1,
                                   .lights = lights,
                                   .light_count = 2,
                                   .ambient = {8192, 8192, 8192}};
        static const uint16_t vertex[3] = {0, 1, 2};
        glint_view view;
        object_state object;
        light_state states[2];
        bool specular = false;
        glint_view_set_up(&view, &camera, 64, 48);
        object_prepare(&object, states, NULL, NULL, &scene, 0, &view, GLINT_SHADING_GOURAUD, 0);
        glint_shade plain;
        const glint_shade shade = corner_colour(&object, vertex, n % 3, false, &specular, &plain);
        if (n == 0) { /* the ambient products have few bits: exact */
            assert_int_equal(shade.r_q15, 16384);
            assert_int_equal(shade.g_q15, 8192);
            assert_int_equal(shade.b_q15, 4096);
            assert_false(specular);
        } else {
            assert_true(shade.r_q15 > 16384 + 1000 && shade.b_q15 > 4096 + 1000 && specular);
        }
    }
}

/* Colours survive the way into an attribute and back; what rounding takes beyond their range is clamped. */
static void test_colours_as_attributes(void **state)
{
    const real black = colour_to_attribute(0), white = colour_to_attribute(32768);
    const real step = colour_to_attribute(1) - black;
    (void)state;
    for (uint32_t q15 = 0; q15 <= 32768; q15++) {
        assert_int_equal(attribute_to_colour(colour_to_attribute((uint16_t)q15)), q15);
    }
    for (int part = 0; part <= 4000; part++) { /* up to 1000 units beyond, by quarters */
        const real beyond = (real)part * (step / 4);
        assert_int_equal(attribute_to_colour(black - beyond), 0);
        assert_int_equal(attribute_to_colour(white + beyond), 32768);
    }
}

#define LIMITS_TESTS                                                                                                   \
    cmocka_unit_test(test_polygons_that_are_not_convex), cmocka_unit_test(test_fates_by_kinds_of_corners),             \
        cmocka_unit_test(test_a_corner_in_the_eye), cmocka_unit_test(test_colours_as_attributes)
