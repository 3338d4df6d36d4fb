/* SPDX-License-Identifier: MIT */
/*
 * What becomes of a shaded pixel: the side of the surface that is seen; fog; what shows through; the
 * edges of its mesh.
 */
#include <examples/scenes/parts.h>

/* ------------------------------------------------------------------------------------------------------------- sides
 */

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
        .linear_q16 = {{MILLI_Q16(850), 0, 0},                                                                         \
                       {0, Q16(4 * 850, 5000), Q16(-3 * 850, 5000)},                                                   \
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
    {&glint_mesh_bowl, &two_sided, PLACE_SCALED(850, 850, 850, 1800, -40, 1100)},
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

/* --------------------------------------------------------------------------------------------------------------- fog
 */

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
    {                                                                                                                  \
        &glint_mesh_sphere_24x12, &ball, PLACE_SCALED(450, 450, 450, 2200, 2450, z)                                    \
    }

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

/* ------------------------------------------------------------------------------------------------------ transmission
 */

static const glint_camera table_camera = {
    .eye_q16 = POINT(0, 2600, 7500),
    .target_q16 = POINT(0, 850, 0),
    .field_of_view_turn16 = DEGREES_TURN16(42),
    .near_q16 = MILLI_Q16(3500),
};

#define PAINT(r, g, b)                                                                                                 \
    {                                                                                                                  \
        .ambient = COLOUR(r, g, b), .diffuse = COLOUR(r, g, b)                                                         \
    }
static const glint_material white_tile = PAINT(800, 790, 760), dark_tile = PAINT(180, 190, 220);
static const glint_material red_paint = PAINT(750, 180, 140), yellow_paint = PAINT(800, 680, 180);

/* Clear glass that mirrors a pale sky at its rim; and a green one, alike at every angle. */
static const glint_material clear_glass = {
    .ambient = COLOUR(150, 170, 180),
    .diffuse = COLOUR(150, 170, 180),
    .specular = COLOUR(900, 900, 900),
    .exponent_q4 = 120 * 16,
    .sides = GLINT_TWO_SIDED,
    .transmission_q14 = Q14(920, 1000),
    .grazing = COLOUR(700, 750, 800),
};
static const glint_material green_glass = {
    .ambient = COLOUR(100, 600, 250),
    .diffuse = COLOUR(100, 600, 250),
    .specular = COLOUR(700, 700, 700),
    .exponent_q4 = 60 * 16,
    .sides = GLINT_EACH_SIDE,
    .transmission_q14 = Q14(600, 1000),
};

#define TILE(material, x, z)                                                                                           \
    {                                                                                                                  \
        &glint_mesh_box, &(material), PLACE_SCALED(500, 100, 500, x, -100, z)                                          \
    }
#define TILES(z, a, b)                                                                                                 \
    TILE(a, -2500, z), TILE(b, -1500, z), TILE(a, -500, z), TILE(b, 500, z), TILE(a, 1500, z), TILE(b, 2500, z)

static const glint_object glass_objects[] = {
    {&glint_mesh_sphere_24x12, &clear_glass, PLACE_SCALED(950, 950, 950, -900, 960, 700)},
    TILES(-2500, white_tile, dark_tile),
    TILES(-1500, dark_tile, white_tile),
    TILES(-500, white_tile, dark_tile),
    TILES(500, dark_tile, white_tile),
    TILES(1500, white_tile, dark_tile),
    {&glint_mesh_sphere_24x12, &red_paint, PLACE_SCALED(450, 450, 450, -1500, 451, -1400)},
    {&glint_mesh_box, &green_glass, PLACE_TURNED(4, 3, 5, 650, 1250, 651, -100)},
    {&glint_mesh_sphere_24x12, &yellow_paint, PLACE_SCALED(400, 400, 400, 1300, 401, -1900)},
};

static const glint_light glass_lights[] = {
    {.kind = GLINT_DIRECTIONAL, .direction = {5, -8, -6}, .colour = COLOUR(700, 690, 660)},
    {.kind = GLINT_POINT, .position_q16 = POINT(3000, 4500, 2500), .colour = COLOUR(250, 250, 270)},
};

const glint_scene demo_glass = {
    .camera = &table_camera,
    .objects = glass_objects,
    .object_count = LENGTH_OF(glass_objects),
    .lights = glass_lights,
    .light_count = LENGTH_OF(glass_lights),
    .ambient = COLOUR(280, 280, 300),
    .background = COLOUR(450, 550, 680),
};

/* A sheet of water over a floor, clear from above and like the sky from aside; what stands in it. */
static const glint_material water = {
    .ambient = COLOUR(60, 200, 220),
    .diffuse = COLOUR(60, 200, 220),
    .specular = COLOUR(600, 600, 600),
    .exponent_q4 = 90 * 16,
    .transmission_q14 = Q14(750, 1000),
    .grazing = COLOUR(560, 680, 820),
};

static const glint_object pond_objects[] = {
    {&glint_mesh_plane, &water, PLACE_SCALED(3000, 1000, 2500, 0, 350, -250)},
    TILES(-2500, white_tile, dark_tile),
    TILES(-1500, dark_tile, white_tile),
    TILES(-500, white_tile, dark_tile),
    TILES(500, dark_tile, white_tile),
    TILES(1500, white_tile, dark_tile),
    {&glint_mesh_torus_knot, &red_paint, PLACE_TURNED(24, 7, 25, 550, -1100, 600, -300)},
    {&glint_mesh_box, &yellow_paint, PLACE_TURNED(15, 8, 17, 400, 1300, 400, 300)},
};

const glint_scene demo_pond = {
    .camera = &table_camera,
    .objects = pond_objects,
    .object_count = LENGTH_OF(pond_objects),
    .lights = glass_lights,
    .light_count = LENGTH_OF(glass_lights),
    .ambient = COLOUR(280, 280, 300),
    .background = COLOUR(560, 680, 820),
};

/* -------------------------------------------------------------------------------------------------------------- wire
 */

static const glint_camera mesh_camera = {
    .eye_q16 = POINT(0, 6200, 11500),
    .target_q16 = POINT(200, 1500, 0),
    .field_of_view_turn16 = DEGREES_TURN16(24),
    .near_q16 = MILLI_Q16(6000),
};

static const glint_material meshed = {
    .ambient = COLOUR(700, 560, 350),
    .diffuse = COLOUR(700, 560, 350),
    .specular = COLOUR(400, 400, 400),
    .exponent_q4 = 30 * 16,
    .wire = COLOUR(40, 60, 200),
    .wire_width_q4 = 12,
};

static const glint_object mesh_objects[] = {{&glint_mesh_teapot, &meshed, PLACE_AT(0, 0, 0)}};

const glint_scene demo_mesh = {
    .camera = &mesh_camera,
    .objects = mesh_objects,
    .object_count = LENGTH_OF(mesh_objects),
    .lights = bowl_lights,
    .light_count = LENGTH_OF(bowl_lights),
    .ambient = COLOUR(220, 220, 230),
    .background = COLOUR(800, 830, 870),
};
