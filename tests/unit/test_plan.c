/* SPDX-License-Identifier: MIT */
/*
 * The plan of an object: its bounds hold it; a light is left out for range or cone only where it arrives at no point of
 * the object, and is left out where it plainly does not; each reason is given for what it says.
 */
#include "tests/unit/geometry_world.h"

#include <stdio.h>

#include <glint/plan.h>

#include "examples/meshes/meshes.h"
#include "tests/unit/board.h"

#define ROUNDS 4000
#define RANDOM_POINTS 200

static const glint_mesh *const meshes[] = {&glint_mesh_sphere_10x6, &glint_mesh_box, &glint_mesh_plane,
                                           &glint_mesh_teapot_small, &glint_mesh_sphere_24x12};

/* A point of the object in world units: a vertex, or within a triangle. */
static void any_point(const glint_object *object, long double out[3])
{
    const glint_mesh *mesh = object->mesh;
    const uint16_t *triangle = mesh->triangles[random_between(0, mesh->triangle_count - 1)];
    long double linear[3][3], weight[3], local[3] = {0, 0, 0}, sum = 0;
    exact_linear_of(&object->place, linear);
    const bool at_corner = random_u32() & 1;
    for (int i = 0; i < 3; i++) {
        weight[i] = at_corner ? i == 0 : random_unit();
        sum += weight[i];
    }
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            local[k] += weight[i] / sum * mesh->positions[triangle[i]][k];
        }
    }
    for (int k = 0; k < 3; k++) {
        out[k] = ldexpl(dot(linear[k], local), -mesh->fraction_bits) + object->place.origin_q16[k] / 65536.0L;
    }
}

static void any_scene(board *b)
{
    board_set_up(b);
    b->object.mesh = meshes[random_between(0, 4)];
    b->object.place = random_place(random_u32() & 1);
    const long double size = exp2l(-8 * random_unit());
    for (int i = 0; i < 9; i++) { /* from a hundredth of a unit to hundreds */
        b->object.place.linear_q16[i / 3][i % 3] = (int32_t)(b->object.place.linear_q16[i / 3][i % 3] * size);
    }
    glint_light *light = &b->light[0];
    light->kind = random_u32() & 1 ? GLINT_SPOT : GLINT_POINT;
    for (int k = 0; k < 3; k++) {
        b->object.place.origin_q16[k] = random_any_size(26);
        light->position_q16[k] = random_any_size(28);
        light->direction[k] = (int16_t)random_between(-32768, 32767);
    }
    if (random_u32() & 1) { /* not far off the object */
        for (int k = 0; k < 3; k++) {
            const int32_t away = light->position_q16[k] - b->object.place.origin_q16[k];
            light->direction[k] = (int16_t)(-away / 16384 + random_between(-3000, 3000));
        }
    }
    light->direction[0] = (int16_t)(light->direction[0] | 1);
    light->outer_turn16 = (uint16_t)random_between(182, 16384);
    light->inner_turn16 = (uint16_t)random_between(0, light->outer_turn16 - 182);
    light->attenuation.range_q16 = random_u32() % 4 ? (uint32_t)(256 * exp2l(22 * random_unit())) : 0;
    b->material.diffuse = b->material.specular = board_grey(9000);
}

static long double distance_of(const glint_light *light, const long double point[3], long double away[3])
{
    for (int k = 0; k < 3; k++) {
        away[k] = point[k] - light->position_q16[k] / 65536.0L;
    }
    return normalise(away);
}

/* Whether the light arrives at a point, and by how far not: in shares of the range, in cosines of the outer cone. */
static bool arrives(const glint_light *light, const long double point[3], bool *far, bool *beside)
{
    long double away[3], axis[3];
    const long double distance = distance_of(light, point, away);
    for (int k = 0; k < 3; k++) {
        axis[k] = light->direction[k];
    }
    (void)normalise(axis);
    *far = light->attenuation.range_q16 != 0 && distance >= light->attenuation.range_q16 / 65536.0L;
    *beside = light->kind == GLINT_SPOT && dot(away, axis) <= cosl(light->outer_turn16 * PI / 32768);
    return !*far && !*beside;
}

static void test_what_is_left_out_does_not_arrive(void **state)
{
    (void)state;
    unsigned long out_of_range = 0, outside = 0, could_be_out = 0, left_out = 0;
    for (int round = 0; round < ROUNDS; round++) {
        board b;
        glint_object_plan of_object;
        glint_light_plan plan;
        bool all_far = true, all_beside = true;
        any_scene(&b);
        glint_plan_object(&b.scene, 0, &of_object);
        glint_plan_light(&b.scene, 0, &of_object, 0, &plan);
        for (int i = 0; i < RANDOM_POINTS; i++) {
            long double point[3], away[3], square = 0;
            bool far, beside;
            any_point(&b.object, point);
            const bool there = arrives(&b.light[0], point, &far, &beside);
            all_far = all_far && far;
            all_beside = all_beside && beside;
            assert_true(plan.diffuse != GLINT_OUT_OF_RANGE || far);
            assert_true(plan.diffuse != GLINT_OUTSIDE_CONE || beside);
            assert_true(plan.diffuse == GLINT_NEEDED || !there);
            for (int k = 0; k < 3 && of_object.needs_bounds; k++) {
                away[k] = point[k] - of_object.bounds.centre_q16[k] / 65536.0L;
                square += away[k] * away[k];
            }
            assert_true(!of_object.needs_bounds || sqrtl(square) <= of_object.bounds.radius_q16 / 65536.0L);
        }
        out_of_range += plan.diffuse == GLINT_OUT_OF_RANGE;
        outside += plan.diffuse == GLINT_OUTSIDE_CONE;
        could_be_out += all_far || all_beside;
        left_out += plan.diffuse != GLINT_NEEDED;
    }
    printf(
        "of %d lights %lu out of range, %lu with the object outside of their cone; of %lu that arrive at no point that "
        "was tried %lu are left out\n",
        ROUNDS, out_of_range, outside, could_be_out, left_out);
    assert_true(out_of_range > 100 && outside > 100);
    /* the sphere about the object is larger than it, so some stay that need not */
    assert_true(left_out <= could_be_out && 10 * left_out > 6 * could_be_out);
}

static uint8_t diffuse_reason(const board *b)
{
    glint_object_plan of_object;
    glint_light_plan plan;
    glint_plan_object(&b->scene, 0, &of_object);
    glint_plan_light(&b->scene, 0, &of_object, 0, &plan);
    return plan.diffuse;
}

static void test_reasons(void **state)
{
    (void)state;
    board b;
    glint_object_plan of_object;
    const glint_colour red = {9000, 0, 0}, blue = {0, 0, 9000};
    board_set_up(&b);
    b.material.ambient = b.material.diffuse = board_grey(0);
    assert_int_equal(diffuse_reason(&b), GLINT_REFLECTANCE_ZERO);
    b.material.diffuse = red;
    assert_int_equal(diffuse_reason(&b), GLINT_NEEDED);
    b.light[0].colour = board_grey(0);
    assert_int_equal(diffuse_reason(&b), GLINT_LIGHT_ZERO);
    b.light[0].colour = blue;
    assert_int_equal(diffuse_reason(&b), GLINT_NO_COMMON_COLOUR);
    b.scene.ambient = board_grey(16384);
    b.scene.sky = red;
    glint_plan_object(&b.scene, 0, &of_object);
    assert_int_equal(of_object.ambient, GLINT_REFLECTANCE_ZERO);
    assert_int_equal(of_object.emission, GLINT_REFLECTANCE_ZERO);
    assert_false(of_object.needs_bounds);
    b.material.ambient = blue;
    b.material.emission = blue;
    glint_plan_object(&b.scene, 0, &of_object);
    assert_int_equal(of_object.ambient, GLINT_NEEDED);
    assert_int_equal(of_object.sky, GLINT_NO_COMMON_COLOUR);
    assert_int_equal(of_object.ground, GLINT_LIGHT_ZERO);
    assert_int_equal(of_object.emission, GLINT_NEEDED);
    for (int reason = GLINT_NEEDED; reason <= GLINT_NOTHING_CASTS; reason++) {
        assert_string_not_equal(glint_reason_text(reason), "unknown reason");
    }
    assert_string_equal(glint_reason_text(-1), "unknown reason");
    assert_string_equal(glint_reason_text(GLINT_NOTHING_CASTS + 1), "unknown reason");
}

static uint8_t texture_reason(const board *b)
{
    glint_object_plan plan;
    glint_plan_object(&b->scene, 0, &plan);
    return plan.texture;
}

/* A texture is needed where an ambient or a diffuse term is, of a light that may be out of reach too. */
static void test_reasons_of_textures(void **state)
{
    (void)state;
    board b;
    const glint_texture texture = {.width_px = 1, .height_px = 1};
    board_set_up(&b);
    b.material.specular = board_grey(9000);
    assert_int_equal(texture_reason(&b), GLINT_REFLECTANCE_ZERO);
    b.material.texture = &texture;
    assert_int_equal(texture_reason(&b), GLINT_NOTHING_TO_COLOUR);
    b.material.ambient = board_grey(9000);
    assert_int_equal(texture_reason(&b), GLINT_NOTHING_TO_COLOUR);
    b.scene.ground = board_grey(1);
    assert_int_equal(texture_reason(&b), GLINT_NEEDED);
    b.material.ambient = board_grey(0);
    b.material.diffuse = board_grey(1);
    assert_int_equal(texture_reason(&b), GLINT_NEEDED);
    b.light[0].colour = board_grey(0);
    assert_int_equal(texture_reason(&b), GLINT_NOTHING_TO_COLOUR);
}

static uint8_t shadow_reason(const board *b)
{
    glint_object_plan of_object;
    glint_light_plan plan;
    glint_plan_object(&b->scene, 0, &of_object);
    glint_plan_light(&b->scene, 0, &of_object, 0, &plan);
    return plan.shadow;
}

static void test_reasons_of_shadows(void **state)
{
    (void)state;
    board b;
    board_set_up(&b);
    b.light[0].casts_shadows = true;
    assert_int_equal(shadow_reason(&b), GLINT_REFLECTANCE_ZERO);
    b.material.diffuse = board_grey(9000);
    assert_int_equal(shadow_reason(&b), GLINT_NEEDED);
    b.material.shadows = GLINT_TAKES_NO_SHADOW;
    assert_int_equal(shadow_reason(&b), GLINT_NOT_TAKEN);
    b.material.shadows = GLINT_CASTS_NO_SHADOW;
    assert_int_equal(shadow_reason(&b), GLINT_NOTHING_CASTS);
    b.material.shadows = 0;
    b.light[0].casts_shadows = false;
    assert_int_equal(shadow_reason(&b), GLINT_NOT_CAST);
    b.light[0].casts_shadows = true;
    b.light[0].kind = GLINT_POINT;
    b.light[0].position_q16[2] = BOARD_Q16(50);
    b.light[0].attenuation.range_q16 = BOARD_Q16(1);
    assert_int_equal(shadow_reason(&b), GLINT_OUT_OF_RANGE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_what_is_left_out_does_not_arrive),
        cmocka_unit_test(test_reasons),
        cmocka_unit_test(test_reasons_of_textures),
        cmocka_unit_test(test_reasons_of_shadows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
