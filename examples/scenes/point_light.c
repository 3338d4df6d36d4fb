/* SPDX-License-Identifier: MIT */
/*
 * A point light close above a floor, among objects: its direction turns by more than a right angle within the picture,
 * and within single triangles.
 */
#include <examples/scenes/parts.h>

static const glint_camera camera = {
    .eye_q16 = POINT(0, 5200, 8200),
    .target_q16 = POINT(0, 600, 0),
    .field_of_view_turn16 = DEGREES_TURN16(38),
    .near_q16 = MILLI_Q16(6000),
};

#define GLOSSY(r, g, b, gloss, exponent)                                                                               \
    {                                                                                                                  \
        .ambient = COLOUR(r, g, b), .diffuse = COLOUR(r, g, b), .specular = COLOUR(gloss, gloss, gloss),               \
        .exponent_q4 = (exponent)*16                                                                                   \
    }

static const glint_material ground = GLOSSY(480, 470, 500, 200, 20), gold = GLOSSY(700, 500, 160, 450, 50);
static const glint_material violet = GLOSSY(420, 260, 620, 450, 50), teal = GLOSSY(140, 520, 500, 450, 50);
static const glint_material brick = GLOSSY(620, 260, 180, 200, 12);

static const glint_object objects[] = {
    {&glint_mesh_plane, &ground, PLACE_SCALED(4000, 1000, 4000, 0, 0, 0)},
    {&glint_mesh_sphere_32x16, &gold, PLACE_SCALED(800, 800, 800, -2200, 800, -300)},
    {&glint_mesh_sphere_32x16, &violet, PLACE_SCALED(550, 550, 550, -500, 550, 900)},
    {&glint_mesh_box, &brick, PLACE_TURNED(4, 3, 5, 650, 2000, 650, -500)},
    {&glint_mesh_torus_knot, &teal, PLACE_TURNED(24, 7, 25, 700, 100, 1230, -2400)},
};

static const glint_light light = {
    .kind = GLINT_POINT, .position_q16 = POINT(300, 2100, 1200), .colour = COLOUR(1000, 950, 850)};

const glint_scene demo_point_light = {
    .camera = &camera,
    .objects = objects,
    .object_count = LENGTH_OF(objects),
    .lights = &light,
    .light_count = 1,
    .ambient = COLOUR(130, 130, 150),
    .background = COLOUR(25, 28, 40),
};
