/* SPDX-License-Identifier: MIT */
/*
 * Light sources with an extent: a window, a tube and a globe, which make soft terminators and long highlights.
 */
#include <examples/scenes/parts.h>

static const glint_camera camera = {
    .eye_q16 = POINT(0, 3000, 7800),
    .target_q16 = POINT(0, 800, 0),
    .field_of_view_turn16 = DEGREES_TURN16(36),
    .near_q16 = MILLI_Q16(4300),
};

static const glint_material floor_stone = {.ambient = COLOUR(500, 480, 450), .diffuse = COLOUR(500, 480, 450)};
static const glint_material glazed = {
    .ambient = COLOUR(300, 420, 520),
    .diffuse = COLOUR(300, 420, 520),
    .specular = COLOUR(350, 350, 350),
    .exponent_q4 = 40 * 16,
};
static const glint_material clay = {.ambient = COLOUR(640, 380, 260), .diffuse = COLOUR(640, 380, 260)};
static const glint_material bronze = {
    .ambient = COLOUR(450, 330, 150),
    .diffuse = COLOUR(450, 330, 150),
    .specular = COLOUR(400, 350, 250),
    .exponent_q4 = 24 * 16,
};

#define ROOM_OBJECTS                                                                                                   \
    {&glint_mesh_plane, &floor_stone, PLACE_SCALED(4500, 1000, 3500, 0, 0, 0)},                                        \
        {&glint_mesh_sphere_32x16, &glazed, PLACE_SCALED(850, 850, 850, -1900, 850, 0)},                               \
        {&glint_mesh_torus_knot, &bronze, PLACE_TURNED(24, 7, 25, 650, 0, 1150, -300)},                                \
    {                                                                                                                  \
        &glint_mesh_box, &clay, PLACE_TURNED(4, 3, 5, 650, 2000, 650, -200)                                            \
    }

static const glint_object objects[] = {ROOM_OBJECTS};

/* A window to the left in front, and a tube high at the back. */
static const glint_light panels[] = {
    {.kind = GLINT_PANEL,
     .position_q16 = POINT(-4800, 4200, 4200),
     .edge_q16 = {POINT(700, 0, 700), POINT(0, 900, 0)},
     .colour = COLOUR(1250, 1220, 1130),
     .samples = 53},
    {.kind = GLINT_PANEL,
     .position_q16 = POINT(2500, 5200, 1000),
     .edge_q16 = {POINT(0, 0, 1200), POINT(0, 0, 0)},
     .colour = COLOUR(350, 420, 600),
     .samples = 29},
};

const glint_scene demo_panels = {
    .camera = &camera,
    .objects = objects,
    .object_count = LENGTH_OF(objects),
    .lights = panels,
    .light_count = LENGTH_OF(panels),
    .ambient = COLOUR(120, 120, 130),
    .background = COLOUR(40, 44, 52),
};

/* A globe in front to the right, whose light falls off with distance. */
static const glint_light globe = {
    .kind = GLINT_BALL,
    .position_q16 = POINT(2600, 3800, 4200),
    .radius_q16 = MILLI_Q16(900),
    .colour = COLOUR(1500, 1350, 1050),
    .attenuation = {.k_q14 = {0, 0, 16384}, .unit_q16 = MILLI_Q16(5000)},
    .samples = 53,
};

const glint_scene demo_globe = {
    .camera = &camera,
    .objects = objects,
    .object_count = LENGTH_OF(objects),
    .lights = &globe,
    .light_count = 1,
    .ambient = COLOUR(110, 115, 140),
    .background = COLOUR(20, 22, 34),
};
