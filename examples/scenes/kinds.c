/* SPDX-License-Identifier: MIT */
/*
 * The same things under a light of each kind from the same side: parallel light, a lamp, four lamps, and a panel, which
 * the four stand for coarsely; and a hall of eight lamps, of which two reach what stands in its middle.
 */
#include <examples/scenes/parts.h>

static const glint_camera camera = {
    .eye_q16 = POINT(0, 3300, 8000),
    .target_q16 = POINT(0, 620, 0),
    .field_of_view_turn16 = DEGREES_TURN16(25),
    .near_q16 = MILLI_Q16(4400), /* a corner of the floor turned to the camera begins at 4.5 */
};

static const glint_material paper = {.ambient = COLOUR(600, 600, 600), .diffuse = COLOUR(600, 600, 600)};
static const glint_material glazed = {
    .ambient = COLOUR(640, 480, 320),
    .diffuse = COLOUR(640, 480, 320),
    .specular = COLOUR(350, 350, 350),
    .exponent_q4 = 40 * 16,
};

static const glint_object objects[] = {
    {&glint_mesh_plane, &paper, PLACE_SCALED(3400, 1000, 2600, 0, 0, 0)},
    {&glint_mesh_sphere_32x16, &glazed, PLACE_SCALED(950, 950, 950, -900, 950, 0)},
    {&glint_mesh_box, &glazed, PLACE_TURNED(4, 3, 5, 600, 1250, 600, 100)},
};

/* From (-1.6, 3.4, 2.4). */
#define LAMP(x, y, z, intensity)                                                                                       \
    {                                                                                                                  \
        .kind = GLINT_POINT, .position_q16 = POINT(-1600 + (x), 3400 + (y), 2400 + (z)),                               \
        .colour = COLOUR(intensity, intensity, intensity)                                                              \
    }

static const glint_light parallel = {.kind = GLINT_DIRECTIONAL, .direction = {16, -34, -24}, .colour = GLINT_WHITE};
static const glint_light lamp = LAMP(0, 0, 0, 1000);
static const glint_light four_lamps[] = {
    LAMP(-425, 0, -250, 250),
    LAMP(425, 0, 250, 250),
    LAMP(-425, 0, 250, 250),
    LAMP(425, 0, -250, 250),
};
static const glint_light panel = {
    .kind = GLINT_PANEL,
    .position_q16 = POINT(-1600, 3400, 2400),
    .edge_q16 = {POINT(850, 0, 0), POINT(0, 0, 500)},
    .colour = GLINT_WHITE,
    .samples = 53,
};

#define UNDER(first, count)                                                                                            \
    {                                                                                                                  \
        .camera = &camera, .objects = objects, .object_count = LENGTH_OF(objects), .lights = (first),                  \
        .light_count = (count), .ambient = COLOUR(100, 105, 120), .background = COLOUR(25, 27, 32)                     \
    }

const glint_scene demo_source_directional = UNDER(&parallel, 1);
const glint_scene demo_source_point = UNDER(&lamp, 1);
const glint_scene demo_source_four = UNDER(four_lamps, LENGTH_OF(four_lamps));
const glint_scene demo_source_panel = UNDER(&panel, 1);

/* ------------------------------------------------------------------------------------------------------ the hall */

static const glint_camera hall_camera = {
    .eye_q16 = POINT(0, 3000, 8200),
    .target_q16 = POINT(0, 1150, 0),
    .field_of_view_turn16 = DEGREES_TURN16(38),
    .near_q16 = MILLI_Q16(2900),
};

static const glint_material tiles = {
    .ambient = COLOUR(460, 420, 380),
    .diffuse = COLOUR(460, 420, 380),
    .specular = COLOUR(150, 150, 150),
    .exponent_q4 = 16 * 16,
};
static const glint_material plaster = {.ambient = COLOUR(560, 540, 500), .diffuse = COLOUR(560, 540, 500)};
static const glint_material bronze = {
    .ambient = COLOUR(560, 400, 180),
    .diffuse = COLOUR(560, 400, 180),
    .specular = COLOUR(400, 350, 250),
    .exponent_q4 = 40 * 16,
};
static const glint_material bulb = {.emission = COLOUR(1000, 850, 550)};

#define BULB(x, z)                                                                                                     \
    {                                                                                                                  \
        &glint_mesh_sphere_10x6, &bulb, PLACE_SCALED(120, 120, 120, x, 900, z)                                         \
    }

static const glint_object hall_objects[] = {
    {&glint_mesh_torus_knot, &bronze, PLACE_TURNED(24, 7, 25, 500, 0, 1830, 0)},
    {&glint_mesh_box, &plaster, PLACE_SCALED(450, 450, 450, 0, 450, 0)},
    {&glint_mesh_plane, &tiles, PLACE_SCALED(4600, 1000, 3400, 0, 0, 0)},
    {&glint_mesh_plane,
     &plaster,
     {.linear_q16 = {{MILLI_Q16(4600), 0, 0}, {0, 0, MILLI_Q16(-1700)}, {0, MILLI_Q16(1000), 0}},
      .origin_q16 = POINT(0, 1700, -3400)}},
    BULB(-3400, 1800),
    BULB(-3700, -600),
    BULB(-2300, -2700),
    BULB(2300, -2700),
    BULB(3700, -600),
    BULB(3400, 1800),
};

/* Lamps of short range along the walls, and two spot lights on the knot. */
#define WALL_LAMP(x, z)                                                                                                \
    {                                                                                                                  \
        .kind = GLINT_POINT, .position_q16 = POINT(x, 900, z), .colour = COLOUR(900, 700, 420), .attenuation = {       \
            .range_q16 = MILLI_Q16(1800)                                                                               \
        }                                                                                                              \
    }

static const glint_light eight_lamps[] = {
    WALL_LAMP(-3400, 1800),
    WALL_LAMP(-3700, -600),
    WALL_LAMP(-2300, -2700),
    {.kind = GLINT_SPOT,
     .position_q16 = POINT(-2600, 4600, 3000),
     .direction = {26, -30, -30},
     .colour = COLOUR(900, 850, 750),
     .inner_turn16 = DEGREES_TURN16(12),
     .outer_turn16 = DEGREES_TURN16(22)},
    {.kind = GLINT_SPOT,
     .position_q16 = POINT(2800, 4400, 2400),
     .direction = {-28, -28, -24},
     .colour = COLOUR(350, 500, 800),
     .inner_turn16 = DEGREES_TURN16(12),
     .outer_turn16 = DEGREES_TURN16(22)},
    WALL_LAMP(2300, -2700),
    WALL_LAMP(3700, -600),
    WALL_LAMP(3400, 1800),
};

const glint_scene demo_eight_lamps = {
    .camera = &hall_camera,
    .objects = hall_objects,
    .object_count = LENGTH_OF(hall_objects),
    .lights = eight_lamps,
    .light_count = LENGTH_OF(eight_lamps),
    .ambient = COLOUR(120, 120, 150),
    .background = COLOUR(14, 15, 24),
};
