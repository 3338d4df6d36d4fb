/* SPDX-License-Identifier: MIT */
/*
 * A row of six spheres whose ratio of ambient to diffuse reflectance grows from left to right, their sum being 0.9: the
 * brightest point stays as bright, and the dark side comes up to it until the sphere looks like a disc.
 */
#include <examples/scenes/parts.h>

/* From afar, so that the outer spheres look as round as the inner ones. */
static const glint_camera camera = {
    .eye_q16 = POINT(0, 0, 35000),
    .target_q16 = POINT(0, 0, 0),
    .field_of_view_turn16 = DEGREES_TURN16(6),
    .near_q16 = MILLI_Q16(28000), /* the row turned to the camera begins at 28.25 */
};

static const glint_light light = {.kind = GLINT_DIRECTIONAL, .direction = {6, -6, -5}, .colour = GLINT_WHITE};

/* ambient + diffuse = 900 thousandths */
#define STEP(ambient_share)                                                                                            \
    {                                                                                                                  \
        .ambient = SHARE(ambient_share, 1000, 780, 480), .diffuse = SHARE(900 - (ambient_share), 1000, 780, 480)       \
    }

static const glint_material materials[] = {STEP(0), STEP(100), STEP(250), STEP(450), STEP(650), STEP(850)};

#define SPHERE(column)                                                                                                 \
    {                                                                                                                  \
        &glint_mesh_sphere_24x12, &materials[column], PLACE_AT(2300 * (column)-5750, 0, 0)                             \
    }

static const glint_object objects[] = {SPHERE(0), SPHERE(1), SPHERE(2), SPHERE(3), SPHERE(4), SPHERE(5)};

const glint_scene demo_ambient_ratio = {
    .camera = &camera,
    .objects = objects,
    .object_count = LENGTH_OF(objects),
    .lights = &light,
    .light_count = 1,
    .ambient = GLINT_WHITE,
    .background = COLOUR(60, 65, 80),
};
