/* SPDX-License-Identifier: MIT */
/*
 * The built-in scenes: names, ranges of <glint/scene.h>, the yardstick's figures against the formulas that define them,
 * turning, and framing (nothing cut off at the picture's edge or at the near plane), seen through the reference.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <glint/config.h>
#include <glint/display.h>
#include <glint/quality.h>

#include <examples/meshes/meshes.h>
#include <examples/scenes/scenes.h>
#include <tests/reference/reference.h>

enum { MAX_OBJECTS = 64 };

static const int32_t max_coordinate_q16 = INT32_C(1) << 30;

static void test_names(void **state)
{
    (void)state;
    static const char *const wanted[] = {"sphere-10x6",   "sphere-32x16", "sphere-64x32",    "teapot",
                                         "torus-knot",    "room",         "three-lights",    "ambient-ratio",
                                         "specular-grid", "ambient-only", "diffuse-only",    "full-phong",
                                         "lights-blue",   "many-lights",  "lights-blue-red", "lights-blue-red-green",
                                         "point-light",   "blinn"};
    for (size_t i = 0; i < sizeof wanted / sizeof wanted[0]; i++) {
        assert_non_null(demo_scene_named(wanted[i]));
    }
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        const demo_scene *s = &demo_scenes[i];
        assert_ptr_equal(demo_scene_named(s->name), s); /* the first of that name: so names are unique */
        assert_true(strlen(s->title) > 0 && strchr(s->title, '\n') == NULL);
        assert_in_range(s->width_px, 1, GLINT_MAX_SIZE_PX);
        assert_in_range(s->height_px, 1, GLINT_MAX_SIZE_PX);
    }
    assert_null(demo_scene_named("no such scene"));
    assert_null(demo_scene_named("teapo"));
    assert_null(demo_scene_named(""));
    assert_null(demo_scene_named(NULL));
}

static void check_colour(glint_colour c, int greatest)
{
    assert_true(c.r_q14 >= 0 && c.r_q14 <= greatest);
    assert_true(c.g_q14 >= 0 && c.g_q14 <= greatest);
    assert_true(c.b_q14 >= 0 && c.b_q14 <= greatest);
}

static void check_point(const int32_t point_q16[3])
{
    for (int k = 0; k < 3; k++) {
        assert_true(point_q16[k] >= -max_coordinate_q16 && point_q16[k] <= max_coordinate_q16);
    }
}

static void check_object(const glint_object *object)
{
    assert_non_null(object->mesh);
    assert_non_null(object->material);
    const glint_material *m = object->material;
    check_colour(m->ambient, 16384);
    check_colour(m->diffuse, 16384);
    check_colour(m->specular, 16384);
    assert_true(m->exponent_q4 <= GLINT_MAX_EXPONENT * 16);
    assert_true(m->specular_model == GLINT_PHONG || m->specular_model == GLINT_BLINN);

    check_point(object->place.origin_q16);
    double a[3][3], greatest = 0.0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            a[i][k] = object->place.linear_q16[i][k] / 65536.0;
            greatest = fmax(greatest, fabs(a[i][k]));
        }
    }
    double determinant = a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
                         a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
                         a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    assert_true(greatest <= 1024);
    assert_true(greatest <= 0.0 || fabs(determinant) > 0.001 * greatest * greatest * greatest);
    assert_true(determinant >= 0.0); /* no scene mirrors */
}

static void test_ranges(void **state)
{
    (void)state;
    for (uint16_t n = 0; n < demo_scene_count; n++) {
        const glint_scene *s = demo_scenes[n].scene;
        assert_non_null(s);
        assert_non_null(s->camera);
        assert_non_null(s->objects);
        assert_in_range(s->object_count, 1, MAX_OBJECTS);
        assert_true(s->lights != NULL || s->light_count == 0);
        check_colour(s->ambient, INT16_MAX);
        check_colour(s->background, 16384);

        const glint_camera *c = s->camera;
        check_point(c->eye_q16);
        check_point(c->target_q16);
        assert_true(memcmp(c->eye_q16, c->target_q16, sizeof c->eye_q16) != 0);
        assert_in_range(c->field_of_view_turn16, 182, 30947);
        assert_in_range(c->near_q16, 64, max_coordinate_q16);
        /* up is the default, y: not along the view */
        assert_true(c->up[0] == 0 && c->up[1] == 0 && c->up[2] == 0);
        assert_true(c->eye_q16[0] != c->target_q16[0] || c->eye_q16[2] != c->target_q16[2]);

        for (uint16_t i = 0; i < s->object_count; i++) {
            check_object(&s->objects[i]);
        }
        for (uint16_t i = 0; i < s->light_count; i++) {
            const glint_light *l = &s->lights[i];
            check_colour(l->colour, INT16_MAX);
            assert_true(l->colour.r_q14 > 0 || l->colour.g_q14 > 0 || l->colour.b_q14 > 0);
            if (l->kind != GLINT_DIRECTIONAL) {
                check_point(l->position_q16);
            }
            if (l->kind != GLINT_POINT) {
                assert_in_range(l->kind, GLINT_DIRECTIONAL, GLINT_SPOT);
                assert_true(l->direction[0] != 0 || l->direction[1] != 0 || l->direction[2] != 0);
            }
        }
    }
}

static void assert_rounded(long actual, double exact)
{
    if (fabs((double)actual - exact) > 0.5) {
        fail_msg("%ld, expected %.3f rounded", actual, exact);
    }
}

static void assert_colour(glint_colour actual, double share)
{
    assert_rounded(actual.r_q14, share * 0.9 * 16384);
    assert_rounded(actual.g_q14, share * 0.6 * 16384);
    assert_rounded(actual.b_q14, share * 0.3 * 16384);
}

static void test_yardstick(void **state)
{
    (void)state;
    static const char *const names[] = {"sphere-10x6", "sphere-32x16", "sphere-64x32", "blinn"};
    static const glint_mesh *const spheres[] = {&glint_mesh_sphere_10x6, &glint_mesh_sphere_32x16,
                                                &glint_mesh_sphere_64x32, &glint_mesh_sphere_32x16};
    const double pi = 3.14159265358979323846, angle = 20 * pi / 180, length = sqrt(0.3 * 0.3 + 1.0 + 0.1 * 0.1);
    const double a[3] = {0.3 / length, 1.0 / length, 0.1 / length};
    const double across[3][3] = {{0, -a[2], a[1]}, {a[2], 0, -a[0]}, {-a[1], a[0], 0}};
    for (int n = 0; n < 4; n++) {
        const demo_scene *demo = demo_scene_named(names[n]);
        assert_non_null(demo);
        const glint_scene *s = demo->scene;
        assert_int_equal(demo->width_px, 240);
        assert_int_equal(demo->height_px, 240);
        assert_int_equal(s->object_count, 1);
        assert_int_equal(s->light_count, 1);
        assert_ptr_equal(s->objects[0].mesh, spheres[n]);

        for (int i = 0; i < 3; i++) { /* Rodrigues' rotation formula */
            assert_int_equal(s->objects[0].place.origin_q16[i], 0);
            for (int k = 0; k < 3; k++) {
                double r = (i == k ? cos(angle) : 0.0) + (1 - cos(angle)) * a[i] * a[k] + sin(angle) * across[i][k];
                assert_rounded(s->objects[0].place.linear_q16[i][k], r * 65536);
            }
        }
        assert_rounded(s->camera->eye_q16[2], 2.6356 * 65536);
        assert_int_equal(s->camera->field_of_view_turn16, 65536 / 8);

        /* along (-0.5, -0.6, -1) */
        const int16_t *d = s->lights[0].direction;
        assert_int_equal(s->lights[0].kind, GLINT_DIRECTIONAL);
        assert_true(d[2] < 0 && d[0] * 10 == d[2] * 5 && d[1] * 10 == d[2] * 6);

        const glint_material *m = s->objects[0].material;
        assert_colour(m->ambient, 0.1 * 16384 / s->ambient.r_q14);
        assert_colour(m->diffuse, 0.6 * 16384 / s->lights[0].colour.r_q14);
        assert_colour(m->specular, 0.3 * 16384 / s->lights[0].colour.r_q14);
        assert_int_equal(m->exponent_q4, 32 * 16);
        assert_int_equal(m->specular_model, n == 3 ? GLINT_BLINN : GLINT_PHONG);
    }
}

/* To the right the ambient share grows and the diffuse one falls, their sum stays. */
static void test_ambient_ratio_grows(void **state)
{
    (void)state;
    const glint_object *o = demo_ambient_ratio.objects;
    assert_true(demo_ambient_ratio.object_count >= 5);
    for (uint16_t i = 1; i < demo_ambient_ratio.object_count; i++) {
        const glint_material *before = o[i - 1].material, *now = o[i].material;
        assert_true(o[i].place.origin_q16[0] > o[i - 1].place.origin_q16[0]);
        assert_true(now->ambient.r_q14 > before->ambient.r_q14);
        assert_true(now->diffuse.r_q14 < before->diffuse.r_q14);
        assert_in_range(now->ambient.r_q14 + now->diffuse.r_q14 + 1 - before->ambient.r_q14 - before->diffuse.r_q14, 0,
                        2);
    }
}

/* To the right the exponent grows at one specular share; downwards the share grows at one exponent. */
static void test_specular_grid_grows(void **state)
{
    (void)state;
    const glint_object *o = demo_specular_grid.objects;
    int right = 0, down = 0;
    for (uint16_t i = 0; i < demo_specular_grid.object_count; i++) {
        for (uint16_t j = 0; j < demo_specular_grid.object_count; j++) {
            const int32_t *p = o[i].place.origin_q16, *q = o[j].place.origin_q16;
            const glint_material *a = o[i].material, *b = o[j].material;
            if (p[1] == q[1] && p[0] < q[0]) {
                assert_true(a->exponent_q4 < b->exponent_q4 && a->specular.g_q14 == b->specular.g_q14);
                right++;
            } else if (p[0] == q[0] && p[1] > q[1]) {
                assert_true(a->specular.g_q14 < b->specular.g_q14 && a->diffuse.g_q14 > b->diffuse.g_q14);
                assert_int_equal(a->exponent_q4, b->exponent_q4);
                down++;
            }
        }
    }
    assert_int_equal(right, 4 * 10); /* pairs in 4 rows of 5 */
    assert_int_equal(down, 5 * 6);   /* pairs in 5 columns of 4 */
}

/* The linear part with its default written out. */
static void effect_of(const glint_place *place, int32_t linear_q16[3][3])
{
    static const int32_t zero[3][3];
    memcpy(linear_q16, place->linear_q16, sizeof zero);
    if (memcmp(zero, linear_q16, sizeof zero) == 0) {
        for (int k = 0; k < 3; k++) {
            linear_q16[k][k] = INT32_C(1) << 16;
        }
    }
}

static void test_turn_by_nothing(void **state)
{
    (void)state;
    for (uint16_t n = 0; n < demo_scene_count; n++) {
        const glint_scene *in = demo_scenes[n].scene;
        glint_object objects[MAX_OBJECTS];
        glint_scene out;
        assert_int_equal(demo_scene_turn(in, 0, objects, &out), 0);
        assert_ptr_equal(out.objects, objects);
        for (uint16_t i = 0; i < in->object_count; i++) {
            int32_t before[3][3], after[3][3];
            effect_of(&in->objects[i].place, before);
            effect_of(&objects[i].place, after);
            assert_memory_equal(before, after, sizeof before);
            assert_memory_equal(in->objects[i].place.origin_q16, objects[i].place.origin_q16,
                                sizeof objects[i].place.origin_q16);
            assert_ptr_equal(objects[i].mesh, in->objects[i].mesh);
            assert_ptr_equal(objects[i].material, in->objects[i].material);
        }
        out.objects = in->objects;
        assert_true(out.camera == in->camera && out.lights == in->lights && out.object_count == in->object_count &&
                    out.light_count == in->light_count);
        assert_memory_equal(&out.ambient, &in->ambient, sizeof out.ambient);
        assert_memory_equal(&out.background, &in->background, sizeof out.background);
    }
}

/* Against the rotation about the vertical through the target in double precision, for all scenes and several angles. */
static void test_turn_is_a_rotation(void **state)
{
    (void)state;
    static const uint16_t angles[] = {1, 5461, 16384, 30000, 32768, 49152, 65535};
    for (uint16_t n = 0; n < demo_scene_count; n++) {
        const glint_scene *in = demo_scenes[n].scene;
        for (size_t a = 0; a < sizeof angles / sizeof angles[0]; a++) {
            glint_object objects[MAX_OBJECTS];
            glint_scene out;
            assert_int_equal(demo_scene_turn(in, angles[a], objects, &out), 0);
            double turn = angles[a] * 2 * 3.14159265358979323846 / 65536, c = cos(turn), s = sin(turn);
            for (uint16_t i = 0; i < in->object_count; i++) {
                int32_t from[3][3];
                effect_of(&in->objects[i].place, from);
                double x[4], z[4], y[4]; /* columns of the linear part, then the origin about the axis */
                for (int k = 0; k < 3; k++) {
                    x[k] = from[0][k];
                    y[k] = from[1][k];
                    z[k] = from[2][k];
                }
                const int32_t *t = in->camera->target_q16, *o = in->objects[i].place.origin_q16;
                x[3] = (double)o[0] - t[0];
                y[3] = o[1];
                z[3] = (double)o[2] - t[2];
                for (int k = 0; k < 4; k++) {
                    double expected[3] = {c * x[k] + s * z[k] + (k == 3 ? t[0] : 0), y[k],
                                          -s * x[k] + c * z[k] + (k == 3 ? t[2] : 0)};
                    /* half a unit of the product's rounding, and 0.51 of each sine and cosine times its factor */
                    double bound = 0.51 + 0.51 * (fabs(x[k]) + fabs(z[k])) / 65536;
                    for (int r = 0; r < 3; r++) {
                        double actual = k == 3 ? objects[i].place.origin_q16[r] : objects[i].place.linear_q16[r][k];
                        assert_true(fabs(actual - expected[r]) <= bound);
                    }
                }
            }
        }
    }
}

static void test_turn_refuses(void **state)
{
    (void)state;
    glint_object objects[MAX_OBJECTS], untouched[MAX_OBJECTS];
    glint_scene out, out_before;
    memset(objects, 0x5a, sizeof objects);
    memset(&out, 0x5a, sizeof out);
    memcpy(untouched, objects, sizeof objects);
    memcpy(&out_before, &out, sizeof out);
    glint_scene no_camera = demo_teapot, no_objects = demo_teapot;
    no_camera.camera = NULL;
    no_objects.objects = NULL;
    assert_int_equal(demo_scene_turn(NULL, 1, objects, &out), GLINT_ERROR_NULL_ARGUMENT);
    assert_int_equal(demo_scene_turn(&demo_teapot, 1, NULL, &out), GLINT_ERROR_NULL_ARGUMENT);
    assert_int_equal(demo_scene_turn(&demo_teapot, 1, objects, NULL), GLINT_ERROR_NULL_ARGUMENT);
    assert_int_equal(demo_scene_turn(&no_camera, 1, objects, &out), GLINT_ERROR_NULL_CAMERA);
    assert_int_equal(demo_scene_turn(&no_objects, 1, objects, &out), GLINT_ERROR_NULL_OBJECTS);
    assert_memory_equal(objects, untouched, sizeof objects);
    assert_memory_equal(&out, &out_before, sizeof out);
}

static void test_turn_in_place(void **state)
{
    (void)state;
    glint_object apart[MAX_OBJECTS], here[MAX_OBJECTS];
    glint_scene expected, scene = demo_room;
    memcpy(here, demo_room.objects, demo_room.object_count * sizeof here[0]);
    scene.objects = here;
    assert_int_equal(demo_scene_turn(&demo_room, 12345, apart, &expected), 0);
    assert_int_equal(demo_scene_turn(&scene, 12345, here, &scene), 0);
    for (uint16_t i = 0; i < demo_room.object_count; i++) {
        assert_memory_equal(&here[i].place, &apart[i].place, sizeof here[i].place);
    }
}

static void draw(const glint_scene *scene, int width, int height, reference_image *image)
{
    char error[128];
    if (reference_render(scene, width, height, GLINT_SHADING_EXACT, image, error, sizeof error) != 0) {
        fail_msg("%s", error);
    }
}

/*
 * The near plane cuts nothing that is seen, however the scene is turned: with the plane moved up to the eye, no surface
 * is nearer than where the scene puts it. At a quarter of the size.
 */
static void test_near_plane_cuts_nothing(void **state)
{
    (void)state;
    for (uint16_t n = 0; n < demo_scene_count; n++) {
        for (int eighth = 0; eighth < 8; eighth++) {
            glint_object objects[MAX_OBJECTS];
            glint_scene scene;
            assert_int_equal(demo_scene_turn(demo_scenes[n].scene, (uint16_t)(eighth * 8192), objects, &scene), 0);
            glint_camera camera = *scene.camera;
            camera.near_q16 = 64;
            scene.camera = &camera;
            reference_image image;
            draw(&scene, demo_scenes[n].width_px / 4, demo_scenes[n].height_px / 4, &image);
            double nearest = HUGE_VAL;
            for (int i = 0; i < image.width * image.height; i++) {
                if (image.triangle[i] >= 0) {
                    nearest = fmin(nearest, image.depth[i]);
                }
            }
            reference_free(&image);
            if (nearest < demo_scenes[n].scene->camera->near_q16 / 65536.0) {
                fail_msg("%s turned by %d/8: a surface at %.3f is before the near plane", demo_scenes[n].name, eighth,
                         nearest);
            }
        }
    }
}

/* Scenes without a floor stand free: the picture's edge is background all round, and the picture is not empty. */
static void test_framing(void **state)
{
    (void)state;
    int free_standing = 0;
    for (uint16_t n = 0; n < demo_scene_count; n++) {
        const demo_scene *demo = &demo_scenes[n];
        int floor = 0;
        for (uint16_t i = 0; i < demo->scene->object_count; i++) {
            floor |= demo->scene->objects[i].mesh == &glint_mesh_plane;
        }
        reference_image image;
        draw(demo->scene, demo->width_px, demo->height_px, &image);
        int covered = 0, at_edge = 0;
        for (int y = 0; y < image.height; y++) {
            for (int x = 0; x < image.width; x++) {
                int seen = image.triangle[y * image.width + x] >= 0;
                covered += seen;
                at_edge += seen && (x == 0 || y == 0 || x == image.width - 1 || y == image.height - 1);
            }
        }
        reference_free(&image);
        assert_true(covered > demo->width_px * demo->height_px / 5);
        assert_true(floor || at_edge == 0);
        free_standing += !floor;
        if (demo->scene == &demo_sphere_32x16) { /* 76 to 78 % of the frame */
            assert_in_range(covered, 240 * 240 * 76 / 100, 240 * 240 * 78 / 100);
        }
    }
    assert_true(free_standing >= 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_ranges),
        cmocka_unit_test(test_yardstick),
        cmocka_unit_test(test_ambient_ratio_grows),
        cmocka_unit_test(test_specular_grid_grows),
        cmocka_unit_test(test_turn_by_nothing),
        cmocka_unit_test(test_turn_is_a_rotation),
        cmocka_unit_test(test_turn_refuses),
        cmocka_unit_test(test_turn_in_place),
        cmocka_unit_test(test_near_plane_cuts_nothing),
        cmocka_unit_test(test_framing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
