/* SPDX-License-Identifier: MIT */
/*
 * Sides of a surface: what is drawn of a bowl, and how it is lit. A two-sided surface seen from inside is the same
 * surface turned inside out, its normals with it, seen from outside: bit for bit, in every shading, clipped or not.
 */
#include "tests/image/frame.h"

#include <examples/meshes/meshes.h>

#define SIDE_PX 64
#define MOST_VERTICES 300
#define MOST_TRIANGLES 500

/* The eye looks into a bowl; or stands in it, so that the near plane and the guard band cut its triangles. */
typedef struct bowl_world {
    int16_t normals[MOST_VERTICES][3];
    uint16_t triangles[MOST_TRIANGLES][3];
    glint_mesh inside_out;
    glint_material material;
    glint_object object;
    glint_light light[2];
    glint_camera camera;
    glint_scene scene;
} bowl_world;

static void set_up(bowl_world *w, uint8_t sides, bool within, bool mirrored)
{
    const glint_mesh *mesh = &glint_mesh_bowl;
    const glint_colour white = {14000, 15000, 16000}, dim = {3000, 2000, 4000};
    memset(w, 0, sizeof *w);
    assert_true(mesh->vertex_count <= MOST_VERTICES && mesh->triangle_count <= MOST_TRIANGLES);
    for (int v = 0; v < mesh->vertex_count; v++) {
        for (int k = 0; k < 3; k++) {
            w->normals[v][k] = (int16_t)-mesh->normals_q14[v][k];
        }
    }
    for (int t = 0; t < mesh->triangle_count; t++) {
        w->triangles[t][0] = mesh->triangles[t][0];
        w->triangles[t][1] = mesh->triangles[t][2];
        w->triangles[t][2] = mesh->triangles[t][1];
    }
    w->inside_out = *mesh;
    w->inside_out.normals_q14 = (const int16_t(*)[3])w->normals;
    w->inside_out.triangles = (const uint16_t(*)[3])w->triangles;
    w->material.ambient = w->material.diffuse = white;
    w->material.specular = dim;
    w->material.exponent_q4 = 20 * 16;
    w->material.sides = sides;
    w->object.mesh = mesh;
    w->object.material = &w->material;
    for (int k = 0; k < 3; k++) {
        w->object.place.linear_q16[k][k] = 65536;
    }
    if (mirrored) {
        w->object.place.linear_q16[0][0] = -65536;
    }
    w->light[0].direction[0] = 300;
    w->light[0].direction[1] = -1000;
    w->light[0].direction[2] = -400;
    w->light[0].colour = white;
    w->light[1].kind = GLINT_POINT;
    w->light[1].position_q16[1] = 30000;
    w->light[1].position_q16[0] = 10000;
    w->light[1].colour = dim;
    w->camera.eye_q16[1] = within ? -20000 : 180000;
    w->camera.eye_q16[2] = within ? 9000 : 120000;
    w->camera.target_q16[1] = within ? -26000 : -20000;
    w->camera.target_q16[0] = within ? 30000 : 0;
    w->camera.field_of_view_turn16 = within ? 20000 : 8000;
    w->camera.near_q16 = within ? 6000 : 65536;
    w->scene.camera = &w->camera;
    w->scene.objects = &w->object;
    w->scene.object_count = 1;
    w->scene.lights = w->light;
    w->scene.light_count = 2;
    w->scene.ambient = dim;
    w->scene.background.b_q14 = 16384;
}

static void draw(frame *f, const bowl_world *w, int backend, uint8_t shading, uint8_t tolerance, uint16_t band_px)
{
    memset(f, 0, sizeof *f);
    f->display.width_px = f->display.height_px = SIDE_PX;
    f->display.band_px = band_px;
    f->shading = shading;
    f->tolerance = tolerance;
    assert_int_equal(frame_draw(f, &w->scene, backend), 0);
}

/* Two bowls in one frame, the culled one and the same inside out, against one bowl of two sides. */
static void test_inside_is_the_outside_of_the_bowl_turned(void **state)
{
    static bowl_world turned, both;
    (void)state;
    for (int n = 0; n < FRAME_BACKENDS * 4 * 4; n++) {
        static const uint8_t shading[4] = {GLINT_SHADING_EXACT, GLINT_SHADING_GOURAUD, GLINT_SHADING_FLAT,
                                           GLINT_SHADING_EXACT};
        const int backend = n % 2, how = n / 2 % 4, within = n / 8 % 2, mirrored = n / 16;
        frame a, b;
        set_up(&turned, GLINT_FRONT_SIDE, within, mirrored);
        set_up(&both, GLINT_TWO_SIDED, within, mirrored);
        const glint_object parts[2] = {
            {&glint_mesh_bowl, &turned.material, turned.object.place},
            {&turned.inside_out, &turned.material, turned.object.place},
        };
        turned.scene.objects = parts;
        turned.scene.object_count = 2;
        draw(&a, &turned, backend, shading[how], how == 3 ? 16 : 0, 0);
        draw(&b, &both, backend, shading[how], how == 3 ? 16 : 0, 8);
        assert_memory_equal(a.pixels, b.pixels, a.bytes);
        assert_int_equal(b.report.triangles_facing_away, 0);
        assert_int_equal(a.report.triangles_drawn, b.report.triangles_drawn);
        assert_int_equal(a.report.pixels_shaded, b.report.pixels_shaded);
        frame_free(&a);
        frame_free(&b);
    }
}

/* Each side lit by the stored normals: Gouraud shading's colours at the corners know of no side. */
static void test_each_side_keeps_its_normals(void **state)
{
    static bowl_world w;
    (void)state;
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame a, b;
        set_up(&w, GLINT_EACH_SIDE, false, false);
        draw(&a, &w, backend, GLINT_SHADING_EXACT, 0, 0);
        /* the same triangles wound the other way, normals kept */
        set_up(&w, GLINT_EACH_SIDE, false, false);
        w.inside_out.normals_q14 = glint_mesh_bowl.normals_q14;
        w.object.mesh = &w.inside_out;
        draw(&b, &w, backend, GLINT_SHADING_EXACT, 0, 0);
        assert_memory_equal(a.pixels, b.pixels, a.bytes);
        assert_int_equal(a.report.triangles_facing_away, 0);
        assert_true(a.report.triangles_drawn > 400);
        frame_free(&a);
        frame_free(&b);
    }
}

static void test_front_side_alone_is_culled(void **state)
{
    static bowl_world w;
    (void)state;
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame f;
        set_up(&w, GLINT_FRONT_SIDE, false, false);
        draw(&f, &w, backend, GLINT_SHADING_EXACT, 0, 0);
        assert_true(f.report.triangles_facing_away > 200);
        assert_int_equal(f.report.triangles_facing_away + f.report.triangles_drawn + f.report.triangles_empty, 480);
        frame_free(&f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_inside_is_the_outside_of_the_bowl_turned),
        cmocka_unit_test(test_each_side_keeps_its_normals),
        cmocka_unit_test(test_front_side_alone_is_culled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
