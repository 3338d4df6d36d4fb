/* SPDX-License-Identifier: MIT */
/*
 * Textures: a tiled floor in strong perspective with crates of wood on it, and a planet.
 */
#include <examples/scenes/parts.h>
#include <examples/textures/textures.h>

static const glint_camera hall_camera = {
    .eye_q16 = POINT(0, 2600, 6500),
    .target_q16 = POINT(0, 700, 0),
    .field_of_view_turn16 = DEGREES_TURN16(50),
    .near_q16 = MILLI_Q16(3000),
};

/* The texture multiplies what the floor reflects, not the highlights of the lamps on it. */
static const glint_material polished_tiles = {
    .ambient = COLOUR(900, 900, 900),
    .diffuse = COLOUR(900, 900, 900),
    .specular = COLOUR(350, 350, 350),
    .exponent_q4 = 90 * 16,
    .texture = &glint_texture_tiles,
};
static const glint_material wood = {
    .ambient = COLOUR(1000, 1000, 1000),
    .diffuse = COLOUR(1000, 1000, 1000),
    .texture = &glint_texture_planks,
};
static const glint_material brass = {
    .ambient = COLOUR(560, 430, 160),
    .diffuse = COLOUR(560, 430, 160),
    .specular = COLOUR(500, 450, 300),
    .exponent_q4 = 40 * 16,
};

/* The floor is two triangles that the near plane cuts; the wall of wood is a floor put upright, 8 x 8 cells. */
static const glint_object hall_objects[] = {
    {&glint_mesh_floor_1, &polished_tiles, PLACE_SCALED(7000, 1000, 7000, 0, 0, 0)},
    {&glint_mesh_floor_8,
     &wood,
     {.linear_q16 = {{MILLI_Q16(7000), 0, 0}, {0, 0, -MILLI_Q16(1500)}, {0, MILLI_Q16(1000), 0}},
      .origin_q16 = POINT(0, 1500, -6900)}},
    {&glint_mesh_torus_knot, &brass, PLACE_TURNED(24, 7, 25, 550, 0, 1300, 500)},
};

static const glint_light hall_lights[] = {
    {.kind = GLINT_DIRECTIONAL, .direction = {3, -6, -4}, .colour = COLOUR(550, 540, 520)},
    {.kind = GLINT_POINT, .position_q16 = POINT(-2500, 2500, -3500), .colour = COLOUR(600, 500, 350)},
};

const glint_scene demo_tiles = {
    .camera = &hall_camera,
    .objects = hall_objects,
    .object_count = LENGTH_OF(hall_objects),
    .lights = hall_lights,
    .light_count = LENGTH_OF(hall_lights),
    .ambient = COLOUR(200, 200, 220),
    .background = COLOUR(60, 70, 90),
};

static const glint_camera space_camera = {
    .eye_q16 = POINT(0, 900, 4000),
    .target_q16 = POINT(0, 0, 0),
    .field_of_view_turn16 = DEGREES_TURN16(36),
    .near_q16 = MILLI_Q16(2800),
};

static const glint_material planet = {
    .ambient = COLOUR(1000, 1000, 1000),
    .diffuse = COLOUR(1000, 1000, 1000),
    .specular = COLOUR(250, 250, 250),
    .exponent_q4 = 24 * 16,
    .emission = COLOUR(0, 8, 24),
    .texture = &glint_texture_globe,
};

static const glint_object space_objects[] = {
    {&glint_mesh_globe_32x16, &planet, PLACE_TURNED(4, 3, 5, 1100, 0, 0, 0)},
};

static const glint_light star = {
    .kind = GLINT_DIRECTIONAL, .direction = {-6, -3, -5}, .colour = COLOUR(1000, 980, 940)};

const glint_scene demo_planet = {
    .camera = &space_camera,
    .objects = space_objects,
    .object_count = LENGTH_OF(space_objects),
    .lights = &star,
    .light_count = 1,
    .ambient = COLOUR(50, 50, 60),
    .background = COLOUR(5, 5, 15),
};
