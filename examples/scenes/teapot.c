/* SPDX-License-Identifier: MIT */
/*
 * The Utah teapot: in copper under one light, in white porcelain under three coloured lights, and unglazed under many.
 * The camera keeps the whole teapot in the picture however it is turned about its axis.
 */
#include <examples/scenes/parts.h>

/* 22 degrees above the table; 11.5 from the target */
static const glint_camera camera = {
    .eye_q16 = POINT(0, 5700, 10660),
    .target_q16 = POINT(0, 1400, 0),
    .field_of_view_turn16 = DEGREES_TURN16(30),
    .near_q16 = MILLI_Q16(7800), /* the spout turned to the camera begins at 7.9 */
};

/* The spout to the right and forward. */
#define THREE_QUARTER PLACE_TURNED(15, -8, 17, 1000, 0, 0, 0)

static const glint_material copper = {
    .ambient = COLOUR(700, 340, 180),
    .diffuse = COLOUR(650, 320, 165),
    .specular = COLOUR(500, 380, 270),
    .exponent_q4 = 30 * 16,
};
static const glint_light lamp = {.kind = GLINT_DIRECTIONAL, .direction = {6, -7, -7}, .colour = GLINT_WHITE};
static const glint_object copper_teapot = {&glint_mesh_teapot, &copper, THREE_QUARTER};

const glint_scene demo_teapot = {
    .camera = &camera,
    .objects = &copper_teapot,
    .object_count = 1,
    .lights = &lamp,
    .light_count = 1,
    .ambient = COLOUR(150, 150, 170),
    .background = COLOUR(70, 80, 100),
};

static const glint_material porcelain = {
    .ambient = COLOUR(900, 900, 900),
    .diffuse = COLOUR(700, 700, 700),
    .specular = COLOUR(300, 300, 300),
    .exponent_q4 = 50 * 16,
};
static const glint_light coloured[] = {
    {.kind = GLINT_DIRECTIONAL, .direction = {9, -5, -5}, .colour = COLOUR(200, 350, 1000)},
    {.kind = GLINT_DIRECTIONAL, .direction = {-9, -4, -5}, .colour = COLOUR(1000, 250, 200)},
    {.kind = GLINT_DIRECTIONAL, .direction = {0, -10, -3}, .colour = COLOUR(250, 900, 300)},
};
static const glint_object porcelain_teapot = {&glint_mesh_teapot, &porcelain, THREE_QUARTER};

const glint_scene demo_three_lights = {
    .camera = &camera,
    .objects = &porcelain_teapot,
    .object_count = 1,
    .lights = coloured,
    .light_count = LENGTH_OF(coloured),
    .ambient = COLOUR(60, 60, 70),
    .background = COLOUR(40, 40, 50),
};

static const glint_material unglazed = {.ambient = COLOUR(880, 840, 760), .diffuse = COLOUR(880, 840, 760)};

/* Eight lights, none above 0.45: where most of them meet, the sum stays below 1. */
static const glint_light many[] = {
    {.kind = GLINT_DIRECTIONAL, .direction = {9, -5, -4}, .colour = COLOUR(450, 420, 360)},
    {.kind = GLINT_DIRECTIONAL, .direction = {-10, -2, -3}, .colour = COLOUR(220, 260, 330)},
    {.kind = GLINT_DIRECTIONAL, .direction = {10, -1, 3}, .colour = COLOUR(260, 200, 150)},
    {.kind = GLINT_DIRECTIONAL, .direction = {-10, -1, 4}, .colour = COLOUR(150, 200, 260)},
    {.kind = GLINT_DIRECTIONAL, .direction = {0, -10, 0}, .colour = COLOUR(300, 300, 290)},
    {.kind = GLINT_DIRECTIONAL, .direction = {0, 10, -2}, .colour = COLOUR(120, 100, 80)},
    {.kind = GLINT_DIRECTIONAL, .direction = {0, -3, 10}, .colour = COLOUR(250, 250, 250)},
    {.kind = GLINT_POINT, .position_q16 = POINT(-2500, 4500, 3500), .colour = COLOUR(300, 280, 250)},
};
static const glint_object unglazed_teapot = {&glint_mesh_teapot, &unglazed, THREE_QUARTER};

const glint_scene demo_many_lights = {
    .camera = &camera,
    .objects = &unglazed_teapot,
    .object_count = 1,
    .lights = many,
    .light_count = LENGTH_OF(many),
    .ambient = COLOUR(30, 30, 30),
    .background = COLOUR(60, 70, 80),
};
