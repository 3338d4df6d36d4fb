/* SPDX-License-Identifier: MIT */
/*
 * What becomes of a shaded pixel: the side of the surface that is seen; fog.
 */
#include <examples/scenes/parts.h>

/* ------------------------------------------------------------------------------------------------------------- sides */

static const glint_camera bowl_camera = {
    .eye_q16 = POINT(0, 4200, 8200),
    .target_q16 = POINT(0, 250, 0),
    .field_of_view_turn16 = DEGREES_TURN16(34),
    .near_q16 = MILLI_Q16(5000),
};

static const glint_material floor_grey = {.ambient = COLOUR(500, 500, 520), .diffuse = COLOUR(500, 500, 520)};

#define CLAY(r, g, b, of_sides)                                                                                        \
    {                                                                                                                  \
        .ambient = COLOUR(r, g, b), .diffuse = COLOUR(r, g, b), .specular = COLOUR(350, 350, 350),                     \
        .exponent_q4 = 24 * 16, .sides = (of_sides)                                                                    \
    }
static const glint_material culled = CLAY(750, 350, 250, GLINT_FRONT_SIDE);
static const glint_material alike = CLAY(350, 650, 300, GLINT_EACH_SIDE);
static const glint_material two_sided = CLAY(300, 450, 800, GLINT_TWO_SIDED);

/* Lying on their side, the rim towards the camera, above; standing on their foot, below. */
#define TIPPED(x, y, z)                                                                                                \
    {                                                                                                                  \
        .linear_q16 = {{MILLI_Q16(850), 0, 0}, {0, Q16(4 * 850, 5000), Q16(-3 * 850, 5000)},                           \
                       {0, Q16(3 * 850, 5000), Q16(4 * 850, 5000)}},                                                   \
        .origin_q16 = POINT(x, y, z)                                                                                   \
    }

static const glint_object bowl_objects[] = {
    {&glint_mesh_plane, &floor_grey, PLACE_SCALED(4200, 1000, 3600, 0, -900, 0)},
    {&glint_mesh_bowl, &culled, TIPPED(-2100, 900, -1400)},
    {&glint_mesh_bowl, &alike, TIPPED(0, 900, -1400)},
    {&glint_mesh_bowl, &two_sided, TIPPED(2100, 900, -1400)},
    {&glint_mesh_bowl, &culled, PLACE_SCALED(850, 850, 850, -1800, -40, 1100)},
    {&glint_mesh_bowl, &alike, PLACE_SCALED(850, 850, 850, 0, -40, 1100)},
    {&glint_mesh_bowl, &two_sided, PLACE_SCALED(-850, 850, 850, 1800, -40, 1100)}, /* mirrored: outside stays outside */
};

static const glint_light bowl_lights[] = {
    {.kind = GLINT_DIRECTIONAL, .direction = {4, -7, -5}, .colour = COLOUR(800, 780, 740)},
    {.kind = GLINT_POINT, .position_q16 = POINT(-3000, 3000, 4000), .colour = COLOUR(250, 250, 300)},
};

const glint_scene demo_bowls = {
    .camera = &bowl_camera,
    .objects = bowl_objects,
    .object_count = LENGTH_OF(bowl_objects),
    .lights = bowl_lights,
    .light_count = LENGTH_OF(bowl_lights),
    .ambient = COLOUR(220, 220, 230),
    .background = COLOUR(90, 100, 120),
};

/* --------------------------------------------------------------------------------------------------------------- fog */

static const glint_camera avenue_camera = {
    .eye_q16 = POINT(0, 1700, 9000),
    .target_q16 = POINT(0, 1000, 0),
    .field_of_view_turn16 = DEGREES_TURN16(45),
    .near_q16 = MILLI_Q16(2000),
};

static const glint_material road = {.ambient = COLOUR(300, 290, 280), .diffuse = COLOUR(450, 430, 400)};
static const glint_material stone = {.ambient = COLOUR(600, 560, 500), .diffuse = COLOUR(650, 600, 520)};
static const glint_material ball = {
    .ambient = COLOUR(700, 150, 120),
    .diffuse = COLOUR(700, 150, 120),
    .specular = COLOUR(500, 500, 500),
    .exponent_q4 = 40 * 16,
};

/* Pillars on both sides of a road, each with a ball on top. */
#define PILLARS(z)                                                                                                     \
    {&glint_mesh_box, &stone, PLACE_SCALED(300, 1000, 300, -2200, 1000, z)},                                           \
        {&glint_mesh_box, &stone, PLACE_SCALED(300, 1000, 300, 2200, 1000, z)},                                        \
        {&glint_mesh_sphere_24x12, &ball, PLACE_SCALED(450, 450, 450, -2200, 2450, z)},                                \
        {&glint_mesh_sphere_24x12, &ball, PLACE_SCALED(450, 450, 450, 2200, 2450, z)}

static const glint_object avenue_objects[] = {
    {&glint_mesh_plane, &road, PLACE_SCALED(6000, 1000, 18000, 0, 0, -12000)},
    PILLARS(3000),
    PILLARS(-1000),
    PILLARS(-5000),
    PILLARS(-10000),
    PILLARS(-20000),
};

static const glint_light avenue_sun = {
    .kind = GLINT_DIRECTIONAL, .direction = {6, -8, -5}, .colour = COLOUR(850, 830, 780)};

const glint_scene demo_avenue = {
    .camera = &avenue_camera,
    .objects = avenue_objects,
    .object_count = LENGTH_OF(avenue_objects),
    .lights = &avenue_sun,
    .light_count = 1,
    .ambient = COLOUR(300, 310, 330),
    .background = COLOUR(640, 680, 740),
    .fog = {.colour = COLOUR(640, 680, 740), .begin_q16 = MILLI_Q16(7000), .end_q16 = MILLI_Q16(25000)},
};
