/* SPDX-License-Identifier: MIT */
/*
 * Hard shadows: of a low sun on a floor, the knot's on itself among them; and of two lamps and a spot light in a room,
 * where a box stands on the floor, a ball lies on it, and a column reaches behind the picture's edge.
 */
#include <examples/scenes/parts.h>

#define GLOSSY(r, g, b, gloss, exponent)                                                                               \
    {                                                                                                                  \
        .ambient = COLOUR(r, g, b), .diffuse = COLOUR(r, g, b), .specular = COLOUR(gloss, gloss, gloss),               \
        .exponent_q4 = (exponent)*16                                                                                   \
    }

static const glint_material sand = GLOSSY(620, 560, 460, 60, 12), wall = GLOSSY(520, 540, 580, 0, 0);
static const glint_material gold = GLOSSY(700, 500, 160, 450, 50), teal = GLOSSY(140, 520, 500, 450, 50);
static const glint_material brick = GLOSSY(640, 270, 180, 200, 12);

static const glint_camera sunny_camera = {
    .eye_q16 = POINT(0, 4600, 8400),
    .target_q16 = POINT(300, 500, -200),
    .field_of_view_turn16 = DEGREES_TURN16(36),
    .near_q16 = MILLI_Q16(5600),
};

static const glint_object sunny_objects[] = {
    {&glint_mesh_plane, &sand, PLACE_SCALED(4500, 1000, 4000, 0, 0, 0)},
    {&glint_mesh_sphere_32x16, &gold, PLACE_SCALED(700, 700, 700, -2100, 700, 300)},
    {&glint_mesh_box, &brick, PLACE_TURNED(4, 3, 5, 600, 1700, 600, 400)},
    {&glint_mesh_torus_knot, &teal, PLACE_TURNED(24, 7, 25, 600, 0, 1150, -900)},
};

static const glint_light sun = {
    .kind = GLINT_DIRECTIONAL, .direction = {80, -70, -45}, .colour = COLOUR(850, 820, 720), .casts_shadows = true};

const glint_scene demo_shadows_sun = {
    .camera = &sunny_camera,
    .objects = sunny_objects,
    .object_count = LENGTH_OF(sunny_objects),
    .lights = &sun,
    .light_count = 1,
    .ambient = COLOUR(200, 220, 280),
    .background = COLOUR(420, 540, 700),
};

static const glint_camera lamp_camera = {
    .eye_q16 = POINT(0, 3200, 6400),
    .target_q16 = POINT(0, 1000, 0),
    .field_of_view_turn16 = DEGREES_TURN16(46),
    .near_q16 = MILLI_Q16(2200),
};

static const glint_object lamp_objects[] = {
    {&glint_mesh_plane, &sand, PLACE_SCALED(4000, 1000, 4000, 0, 0, 0)},
    {&glint_mesh_plane,
     &wall,
     {.linear_q16 = {{MILLI_Q16(4000), 0, 0}, {0, 0, MILLI_Q16(-2000)}, {0, MILLI_Q16(1000), 0}},
      .origin_q16 = POINT(0, 2000, -2600)}},
    {&glint_mesh_box, &brick, PLACE_TURNED(12, 5, 13, 700, -700, 700, -600)},
    {&glint_mesh_sphere_32x16, &gold, PLACE_SCALED(450, 450, 450, -700, 1850, -600)},
    {&glint_mesh_torus_knot, &teal, PLACE_TURNED(24, 7, 25, 450, 1300, 900, 300)},
    {&glint_mesh_box, &wall, PLACE_SCALED(200, 2500, 200, -2700, 2500, 200)},
};

static const glint_light lamps[] = {
    {.kind = GLINT_POINT,
     .position_q16 = POINT(-2000, 2600, 2200),
     .colour = COLOUR(750, 560, 360),
     .casts_shadows = true},
    {.kind = GLINT_POINT,
     .position_q16 = POINT(2600, 3000, 600),
     .colour = COLOUR(260, 380, 560),
     .casts_shadows = true},
    {.kind = GLINT_SPOT,
     .position_q16 = POINT(500, 4500, 2500),
     .direction = {2, -40, -24},
     .colour = COLOUR(350, 350, 350),
     .inner_turn16 = DEGREES_TURN16(16),
     .outer_turn16 = DEGREES_TURN16(24)},
};

const glint_scene demo_shadows_lamps = {
    .camera = &lamp_camera,
    .objects = lamp_objects,
    .object_count = LENGTH_OF(lamp_objects),
    .lights = lamps,
    .light_count = LENGTH_OF(lamps),
    .ambient = COLOUR(140, 140, 170),
    .background = COLOUR(20, 22, 35),
};
