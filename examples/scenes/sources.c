/* SPDX-License-Identifier: MIT */
/*
 * Light sources beyond lamps and the sun: spot lights whose light falls off with distance on a stage; a figure under a
 * bright sky over a green ground; lanterns that shine by themselves.
 */
#include <examples/scenes/parts.h>

static const glint_camera stage_camera = {
    .eye_q16 = POINT(0, 3600, 9000),
    .target_q16 = POINT(0, 900, 0),
    .field_of_view_turn16 = DEGREES_TURN16(36),
    .near_q16 = MILLI_Q16(5500),
};

static const glint_material boards = {
    .ambient = COLOUR(420, 330, 240),
    .diffuse = COLOUR(420, 330, 240),
    .specular = COLOUR(120, 120, 120),
    .exponent_q4 = 16 * 16,
};
static const glint_material plaster = {.ambient = COLOUR(780, 760, 720), .diffuse = COLOUR(780, 760, 720)};
static const glint_material lacquer = {
    .ambient = COLOUR(620, 120, 100),
    .diffuse = COLOUR(620, 120, 100),
    .specular = COLOUR(400, 400, 400),
    .exponent_q4 = 50 * 16,
};

#define STAGE                                                                                                          \
    {                                                                                                                  \
        &glint_mesh_plane, &boards, PLACE_SCALED(4500, 1000, 3500, 0, 0, 0)                                            \
    }

static const glint_object stage_objects[] = {
    STAGE,
    {&glint_mesh_sphere_32x16, &plaster, PLACE_SCALED(800, 800, 800, -2000, 800, -400)},
    {&glint_mesh_torus_knot, &lacquer, PLACE_TURNED(24, 7, 25, 650, 0, 1150, -200)},
    {&glint_mesh_box, &plaster, PLACE_TURNED(4, 3, 5, 600, 2100, 600, -500)},
};

/* A wide one with a soft edge, a narrow one with a hard edge, and a lamp on the floor that does not reach far. */
static const glint_light spots[] = {
    {.kind = GLINT_SPOT,
     .position_q16 = POINT(-2500, 4500, 2500),
     .direction = {5, -40, -28},
     .colour = COLOUR(1000, 800, 550),
     .attenuation = {.k_q14 = {0, 0, 16384}, .unit_q16 = MILLI_Q16(4600)},
     .inner_turn16 = DEGREES_TURN16(8),
     .outer_turn16 = DEGREES_TURN16(20)},
    {.kind = GLINT_SPOT,
     .position_q16 = POINT(3000, 5000, 2000),
     .direction = {-12, -45, -24},
     .colour = COLOUR(450, 600, 1000),
     .inner_turn16 = DEGREES_TURN16(13),
     .outer_turn16 = DEGREES_TURN16(14)},
    {.kind = GLINT_POINT,
     .position_q16 = POINT(-700, 300, 1500),
     .colour = COLOUR(900, 500, 200),
     .attenuation = {.k_q14 = {8192, 8192, 0}, .range_q16 = MILLI_Q16(2200)}},
};

const glint_scene demo_spots = {
    .camera = &stage_camera,
    .objects = stage_objects,
    .object_count = LENGTH_OF(stage_objects),
    .lights = spots,
    .light_count = LENGTH_OF(spots),
    .ambient = COLOUR(90, 90, 110),
    .background = COLOUR(15, 15, 25),
};

/* The same stage in plain daylight: the sun, and light from the sky and back from the ground. */
static const glint_light sun = {.kind = GLINT_DIRECTIONAL, .direction = {-6, -7, -5}, .colour = COLOUR(550, 520, 450)};

const glint_scene demo_open_sky = {
    .camera = &stage_camera,
    .objects = stage_objects,
    .object_count = LENGTH_OF(stage_objects),
    .lights = &sun,
    .light_count = 1,
    .sky = COLOUR(420, 520, 700),
    .ground = COLOUR(160, 240, 90),
    .background = COLOUR(500, 650, 850),
};

static const glint_material glow_red = {.diffuse = COLOUR(300, 60, 40), .emission = COLOUR(850, 220, 120)};
static const glint_material glow_gold = {.diffuse = COLOUR(300, 220, 60), .emission = COLOUR(800, 640, 240)};

static const glint_object lantern_objects[] = {
    STAGE,
    {&glint_mesh_sphere_32x16, &glow_red, PLACE_SCALED(450, 450, 450, -1600, 1500, -300)},
    {&glint_mesh_sphere_32x16, &glow_gold, PLACE_SCALED(350, 350, 350, 1500, 1200, 400)},
    {&glint_mesh_torus_knot, &plaster, PLACE_TURNED(24, 7, 25, 650, 0, 1150, -900)},
};

/* What the lanterns throw on the rest: a surface that emits light does not light others by itself. */
static const glint_light lantern_lights[] = {
    {.kind = GLINT_POINT,
     .position_q16 = POINT(-1600, 1500, -300),
     .colour = COLOUR(900, 300, 180),
     .attenuation = {.k_q14 = {0, 0, 16384}, .unit_q16 = MILLI_Q16(1300), .range_q16 = MILLI_Q16(7000)}},
    {.kind = GLINT_POINT,
     .position_q16 = POINT(1500, 1200, 400),
     .colour = COLOUR(850, 700, 300),
     .attenuation = {.k_q14 = {0, 0, 16384}, .unit_q16 = MILLI_Q16(1200), .range_q16 = MILLI_Q16(7000)}},
};

const glint_scene demo_lanterns = {
    .camera = &stage_camera,
    .objects = lantern_objects,
    .object_count = LENGTH_OF(lantern_objects),
    .lights = lantern_lights,
    .light_count = LENGTH_OF(lantern_lights),
    .ambient = COLOUR(70, 75, 120),
    .background = COLOUR(10, 12, 30),
};
