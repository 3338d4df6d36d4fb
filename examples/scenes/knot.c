/* SPDX-License-Identifier: MIT */
/*
 * A (2,3) torus knot in glossy plastic: many depths one behind another, and narrow highlights that bend.
 */
#include <examples/scenes/parts.h>

static const glint_camera camera = {
    .eye_q16 = POINT(0, 2400, 5700),
    .target_q16 = POINT(0, 0, 0),
    .field_of_view_turn16 = DEGREES_TURN16(36),
    .near_q16 = MILLI_Q16(4400), /* 6.18 away, 1.72 about the target */
};

static const glint_material plastic = {
    .ambient = COLOUR(200, 550, 600),
    .diffuse = COLOUR(150, 520, 560),
    .specular = COLOUR(500, 500, 500),
    .exponent_q4 = 60 * 16,
};

static const glint_light lights[] = {
    {.kind = GLINT_DIRECTIONAL, .direction = {5, -8, -7}, .colour = GLINT_WHITE},
    {.kind = GLINT_DIRECTIONAL, .direction = {-9, 1, -3}, .colour = COLOUR(500, 250, 350)},
};

static const glint_object knot = {&glint_mesh_torus_knot, &plastic, PLACE_TURNED(24, 7, 25, 1000, 0, 0, 0)};

const glint_scene demo_torus_knot = {
    .camera = &camera,
    .objects = &knot,
    .object_count = 1,
    .lights = lights,
    .light_count = LENGTH_OF(lights),
    .ambient = COLOUR(180, 180, 200),
    .background = COLOUR(50, 45, 70),
};
