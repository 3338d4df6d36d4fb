/* SPDX-License-Identifier: MIT */
/*
 * A (2,3) torus knot in polished gold: a warm lamp from the upper left, and a blue one low behind it on the right.
 */
#include "examples/pico_st7789/scene.h"

#include <examples/scenes/parts.h>

static const glint_camera camera = {
    .eye_q16 = POINT(0, 2400, 5400),
    .target_q16 = POINT(0, 0, 0),
    .field_of_view_turn16 = DEGREES_TURN16(36),
    .near_q16 = MILLI_Q16(4100), /* 5.91 away, 1.72 about the target */
};

static const glint_material gold = {
    .ambient = COLOUR(830, 620, 250),
    .diffuse = COLOUR(780, 560, 180),
    .specular = COLOUR(630, 560, 370),
    .exponent_q4 = 40 * 16,
};

static const glint_light lights[GOLD_KNOT_LIGHTS] = {
    {.kind = GLINT_DIRECTIONAL, .direction = {6, -8, -7}, .colour = COLOUR(1000, 960, 880)},
    {.kind = GLINT_DIRECTIONAL, .direction = {-9, 3, 1}, .colour = COLOUR(250, 400, 900)},
};

static const glint_object knot[GOLD_KNOT_OBJECTS] = {{.mesh = &glint_mesh_torus_knot, .material = &gold}};

const glint_scene gold_knot = {
    .camera = &camera,
    .objects = knot,
    .object_count = GOLD_KNOT_OBJECTS,
    .lights = lights,
    .light_count = GOLD_KNOT_LIGHTS,
    .ambient = COLOUR(160, 150, 170),
    .background = COLOUR(35, 40, 70),
};

const glint_quality gold_knot_quality = {.tolerance = GLINT_CODES(1)};
