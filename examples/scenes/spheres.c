/* SPDX-License-Identifier: MIT */
/*
 * The yardstick scene, by which renderers of this kind are compared: a unit sphere of body colour (0.9, 0.6, 0.3) that
 * fills 77 % of 240 x 240 pixels, ambient 0.1, diffuse 0.6 and specular 0.3 of the body colour, exponent 32, one white
 * light. In three tessellations, and with Blinn's cosine.
 */
#include <examples/scenes/parts.h>

static const glint_camera camera = {
    .eye_q16 = {0, 0, Q16(26356, 10000)},
    .target_q16 = {0, 0, 0},
    .field_of_view_turn16 = DEGREES_TURN16(45),
    .near_q16 = MILLI_Q16(1600), /* the sphere begins at 1.6356 */
};

static const glint_light light = {.kind = GLINT_DIRECTIONAL, .direction = {-5, -6, -10}, .colour = GLINT_WHITE};

#define YARDSTICK(model)                                                                                               \
    {                                                                                                                  \
        .ambient = SHARE(100, 900, 600, 300), .diffuse = SHARE(600, 900, 600, 300),                                    \
        .specular = SHARE(300, 900, 600, 300), .exponent_q4 = 32 * 16, .specular_model = (model)                       \
    }

static const glint_material phong = YARDSTICK(GLINT_PHONG);
static const glint_material blinn = YARDSTICK(GLINT_BLINN);

/* Turned by 20 degrees about (0.3, 1, 0.1): Rodrigues' formula in double precision, rounded to Q16. */
#define TURNED                                                                                                         \
    {                                                                                                                  \
        .linear_q16 = {                                                                                                \
            {61907, -1059, 21479}, /* 0.944627, -0.016163, 0.327748 */                                                 \
            {3215, 65177, -6052},  /* 0.049058, 0.994518, -0.092349 */                                                 \
            {-21264, 6771, 61620}, /* -0.324459, 0.103314, 0.940241 */                                                 \
        }                                                                                                              \
    }

static const glint_object sphere_10x6 = {&glint_mesh_sphere_10x6, &phong, TURNED};
static const glint_object sphere_32x16 = {&glint_mesh_sphere_32x16, &phong, TURNED};
static const glint_object sphere_64x32 = {&glint_mesh_sphere_64x32, &phong, TURNED};
static const glint_object sphere_blinn = {&glint_mesh_sphere_32x16, &blinn, TURNED};

#define SCENE(object)                                                                                                  \
    {                                                                                                                  \
        .camera = &camera, .objects = &(object), .object_count = 1, .lights = &light, .light_count = 1,                \
        .ambient = GLINT_WHITE, .background = GLINT_BLACK                                                              \
    }

const glint_scene demo_sphere_10x6 = SCENE(sphere_10x6);
const glint_scene demo_sphere_32x16 = SCENE(sphere_32x16);
const glint_scene demo_sphere_64x32 = SCENE(sphere_64x32);
const glint_scene demo_blinn = SCENE(sphere_blinn);
