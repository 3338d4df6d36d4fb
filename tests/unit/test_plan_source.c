/* SPDX-License-Identifier: MIT */
/*
 * The plan of an extended source (glint_plan_source): what it says of the difference between the points that it takes
 * and the whole source holds at random points of random objects, with any normal; and it takes no more than it needs.
 */
#include "tests/unit/source_search.h"

#include <stdio.h>

#include <glint/glint.h>

#include "examples/meshes/meshes.h"

#define ROUNDS 3000
#define POINTS 12
#define CODES_Q8 (255.0 * 256.0)

/* A light beside, over or in a stretched box or plane, and an eye. */
typedef struct stage {
    glint_camera camera;
    glint_material material;
    glint_object object;
    glint_light light;
    glint_scene scene;
} stage;

static int32_t any_q16(double most)
{
    return (int32_t)(65536.0 * most * (2.0 * (double)random_unit() - 1.0));
}

static void stage_set_up(stage *s)
{
    memset(s, 0, sizeof *s);
    s->camera.field_of_view_turn16 = 8192;
    s->camera.near_q16 = 65536;
    for (int k = 0; k < 3; k++) {
        s->camera.eye_q16[k] = any_q16(8);
        s->light.position_q16[k] = any_q16(6);
        s->object.place.origin_q16[k] = any_q16(0.5);
        s->object.place.linear_q16[k][k] = (int32_t)(65536.0 * exp2(-3.0 * (double)random_unit()));
        for (int i = 0; i < 2; i++) {
            s->light.edge_q16[i][k] = any_q16(1);
        }
    }
    s->light.radius_q16 = (int32_t)(65536.0 * (double)random_unit());
    s->light.kind = random_u32() & 1 ? GLINT_PANEL : GLINT_BALL;
    s->light.samples = (uint8_t)random_between(0, GLINT_MAX_SAMPLES);
    s->light.colour.g_q14 = (int16_t)random_between(1, 20000);
    if (random_u32() % 3 == 0) {
        s->light.attenuation.k_q14[2] = (uint16_t)random_between(0, 65535);
        s->light.attenuation.unit_q16 = (uint32_t)random_between(65536, 8 * 65536);
        s->light.attenuation.range_q16 = random_u32() & 1 ? (uint32_t)random_between(3 * 65536, 9 * 65536) : 0;
    }
    s->material.diffuse.g_q14 = (int16_t)random_between(0, 16384);
    s->material.specular.g_q14 = random_u32() & 1 ? (int16_t)random_between(0, 16384) : 0;
    s->material.exponent_q4 = (uint16_t)(16 * exp2(7.0 * (double)random_unit()));
    s->material.specular_model = random_u32() & 1 ? GLINT_BLINN : GLINT_PHONG;
    s->object.mesh = random_u32() & 1 ? &glint_mesh_box : &glint_mesh_plane;
    s->object.material = &s->material;
    s->scene.camera = &s->camera;
    s->scene.objects = &s->object;
    s->scene.object_count = 1;
    s->scene.lights = &s->light;
    s->scene.light_count = 1;
}

/* A corner of the mesh in the world. */
static vector any_point(const stage *s)
{
    const int16_t *p = s->object.mesh->positions[random_between(0, s->object.mesh->vertex_count - 1)];
    double world[3];
    for (int k = 0; k < 3; k++) {
        world[k] = ldexp(p[k], -s->object.mesh->fraction_bits) * s->object.place.linear_q16[k][k] / 65536.0 +
                   s->object.place.origin_q16[k] / 65536.0;
    }
    return vector_of(world[0], world[1], world[2]);
}

/* 1/256 code between the source and its points, in the green channel. */
static double difference_at(const stage *s, uint8_t count, vector point, vector n)
{
    const surface f = {.exponent = s->material.exponent_q4 / 16.0, .blinn = s->material.specular_model == GLINT_BLINN};
    const int32_t *eye = s->camera.eye_q16;
    const vector c = unit(minus(vector_of(eye[0] / 65536.0, eye[1] / 65536.0, eye[2] / 65536.0), point));
    lamp l, one;
    lamp_load(&l, &s->light);
    area_mean exact = area_light(&l, &f, point, n, c);
    for (uint8_t i = 0; i < count; i++) {
        glint_light moved;
        vector to;
        lamp_load(&one, glint_source_point(&s->light, count, i, &moved));
        one.is_area = false;
        if (lamp_toward(&one, point, &to) && dot(n, to) > 0.0) {
            const double factor = lamp_factor(&one, point, to) / count;
            exact.diffuse -= factor * dot(n, to);
            exact.specular -= factor * shade_highlight(&f, n, to, c);
        }
    }
    return fabs(exact.diffuse * s->material.diffuse.g_q14 + exact.specular * s->material.specular.g_q14) / 16384.0 *
           s->light.colour.g_q14 / 16384.0 * CODES_Q8;
}

static void plan_of(const stage *s, uint32_t room_q8, glint_source_plan *plan)
{
    glint_object_plan of_object;
    glint_light_plan of_light;
    glint_plan_object(&s->scene, 0, &of_object);
    glint_plan_light(&s->scene, 0, &of_object, 0, &of_light);
    glint_plan_source(&s->scene, 0, &of_object, 0, &of_light, room_q8, plan);
}

static void test_error_holds(void **state)
{
    (void)state;
    double worst = 0.0, sum = 0.0;
    unsigned long enough = 0, points[GLINT_SOURCE_RULES] = {0}, seen = 0;
    for (int round = 0; round < ROUNDS; round++) {
        stage s;
        glint_source_plan plan, roomy;
        stage_set_up(&s);
        const uint32_t room_q8 = (uint32_t)exp2(5 + 7 * (double)random_unit());
        plan_of(&s, room_q8, &plan);
        plan_of(&s, 4 * room_q8, &roomy);
        assert_true(plan.points <= glint_source_most(&s.light) && roomy.points <= plan.points);
        assert_true(plan.enough == (plan.error_q8 <= room_q8));
        enough += plan.enough;
        for (int rule = 0; rule < GLINT_SOURCE_RULES; rule++) {
            points[rule] += glint_source_points((uint8_t)rule) == plan.points;
        }
        double most = 0.0;
        for (int i = 0; i < POINTS; i++) {
            const vector point = any_point(&s),
                         towards = minus(vector_of(s.light.position_q16[0] / 65536.0, s.light.position_q16[1] / 65536.0,
                                                   s.light.position_q16[2] / 65536.0),
                                         point);
            vector n = unit(random_vector());
            if (i & 1) { /* at the terminator */
                n = unit(plus(cross(unit(towards), n), times(0.05 * random_step(), n)));
            }
            most = fmax(most, difference_at(&s, plan.points, point, n));
        }
        if (most > plan.error_q8 + 0.01) {
            fail_msg("round %d: %u points, stated %u, found %.2f of 1/256 code", round, plan.points,
                     (unsigned)plan.error_q8, most);
        }
        if (plan.enough) {
            seen++;
            sum += most / plan.error_q8;
            worst = fmax(worst, most / plan.error_q8);
        }
    }
    printf("%d sources, %lu with points enough; as 1, 5, 13, 29, 53 points %lu %lu %lu %lu %lu; found over stated: "
           "worst %.2f, mean %.2f\n",
           ROUNDS, enough, points[0], points[1], points[2], points[3], points[4], worst, sum / (double)seen);
    for (int rule = 0; rule < GLINT_SOURCE_RULES; rule++) {
        assert_true(points[rule] > 20);
    }
    assert_true(worst > 0.4);
}

static void test_plain_cases(void **state)
{
    (void)state;
    stage s;
    glint_source_plan plan;
    stage_set_up(&s);
    s.light.kind = GLINT_POINT;
    plan_of(&s, 0, &plan);
    assert_true(plan.points == 1 && plan.enough && plan.error_q8 == 0);
    s.light.kind = GLINT_BALL;
    s.light.radius_q16 = 0;
    plan_of(&s, 0, &plan);
    assert_true(plan.points == 1 && plan.enough && plan.error_q8 == 0);
    /* inside of the object: no bound but all of the light */
    s.light.radius_q16 = 65536;
    s.light.samples = GLINT_MAX_SAMPLES;
    memcpy(s.light.position_q16, s.object.place.origin_q16, sizeof s.light.position_q16);
    s.light.colour.g_q14 = 16384;
    s.material.diffuse.g_q14 = 16384;
    s.material.specular.g_q14 = 0;
    plan_of(&s, 64, &plan);
    assert_false(plan.enough);
    assert_true(fabs(plan.error_q8 - CODES_Q8) <= 1.0);
    /* so far away that it is a point */
    s.light.position_q16[1] = 1 << 29;
    plan_of(&s, 64, &plan);
    assert_true(plan.points == 1 && plan.enough);
    /* black on this surface */
    s.light.position_q16[1] = 65536;
    s.material.diffuse.g_q14 = 0;
    plan_of(&s, 0, &plan);
    assert_int_equal(plan.points, 1);
}

static void test_room(void **state)
{
    (void)state;
    glint_light lights[3] = {{.kind = GLINT_PANEL, .edge_q16 = {{1, 0, 0}, {0, 0, 0}}}, {.kind = GLINT_POINT}};
    glint_scene scene = {.lights = lights, .light_count = 2};
    assert_int_equal(glint_plan_room_q8(&scene, 0), 64);
    assert_int_equal(glint_plan_room_q8(&scene, GLINT_CODES(1)), 64);
    assert_int_equal(glint_plan_room_q8(&scene, GLINT_LEAST_TOLERANCE), 32);
    lights[1].kind = GLINT_BALL;
    lights[1].radius_q16 = 1;
    assert_int_equal(glint_plan_room_q8(&scene, GLINT_CODES(4)), 224);
    scene.light_count = 0;
    assert_int_equal(glint_plan_room_q8(&scene, 0), 64);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(test_error_holds),
        numeric_test(test_plain_cases),
        numeric_test(test_room),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
