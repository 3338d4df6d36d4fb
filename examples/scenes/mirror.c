/* SPDX-License-Identifier: MIT */
/*
 * Mirrors under the open sky: a teapot of chrome, and a gilded knot beside a varnished ball that mirrors a little.
 */
#include <examples/scenes/environments.h>
#include <examples/scenes/parts.h>

static const glint_camera teapot_camera = {
    .eye_q16 = POINT(0, 5700, 10660),
    .target_q16 = POINT(0, 1400, 0),
    .field_of_view_turn16 = DEGREES_TURN16(30),
    .near_q16 = MILLI_Q16(7800),
};

/* The sun of the environment, for what the map is too coarse to show: its highlight. */
static const glint_light sun = {
    .kind = GLINT_DIRECTIONAL, .direction = {-424, -566, -707}, .colour = COLOUR(1000, 950, 850)};

static const glint_material chrome = {
    .diffuse = COLOUR(40, 40, 42),
    .specular = COLOUR(400, 400, 400),
    .exponent_q4 = 120 * 16,
    .mirror = COLOUR(820, 830, 850),
};
static const glint_object chrome_teapot = {&glint_mesh_teapot, &chrome, PLACE_TURNED(15, -8, 17, 1000, 0, 0, 0)};

const glint_scene demo_chrome = {
    .camera = &teapot_camera,
    .objects = &chrome_teapot,
    .object_count = 1,
    .lights = &sun,
    .light_count = 1,
    .background = COLOUR(330, 470, 700),
    .environment = &demo_environment_sky,
};

static const glint_camera camera = {
    .eye_q16 = POINT(0, 2400, 6600),
    .target_q16 = POINT(200, 0, 0),
    .field_of_view_turn16 = DEGREES_TURN16(36),
    .near_q16 = MILLI_Q16(4000),
};
static const glint_material gold = {
    .ambient = COLOUR(150, 110, 40),
    .mirror = COLOUR(900, 680, 300),
};
static const glint_material varnish = {
    .ambient = COLOUR(420, 90, 70),
    .diffuse = COLOUR(420, 90, 70),
    .mirror = COLOUR(200, 200, 200),
};
/* The ball is drawn out, so that its normals go by the inverse transpose. */
static const glint_object objects[] = {
    {&glint_mesh_torus_knot, &gold, PLACE_TURNED(24, 7, 25, 900, -700, 0, 0)},
    {&glint_mesh_sphere_32x16, &varnish, PLACE_SCALED(650, 1000, 650, 1650, 0, 300)},
};

const glint_scene demo_gilded = {
    .camera = &camera,
    .objects = objects,
    .object_count = LENGTH_OF(objects),
    .lights = &sun,
    .light_count = 1,
    .ambient = COLOUR(300, 320, 360),
    .background = COLOUR(330, 470, 700),
    .environment = &demo_environment_sky,
};
