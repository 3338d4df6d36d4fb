/* SPDX-License-Identifier: MIT */
/*
 * A room with a tea table, boxes and balls, under a weak directional light and two lamps. Turning the scene turns the
 * room about its middle around the camera, which stays within the walls: triangles reach behind the camera and beyond
 * the picture's edges.
 */
#include <examples/scenes/parts.h>

static const glint_camera camera = {
    .eye_q16 = POINT(0, 3000, 4700),
    .target_q16 = POINT(0, 1100, 0),
    .field_of_view_turn16 = DEGREES_TURN16(50),
    .near_q16 = MILLI_Q16(1500), /* a ball turned to the camera begins at 1.56 */
};

#define MATT(r, g, b)                                                                                                  \
    {                                                                                                                  \
        .ambient = COLOUR(r, g, b), .diffuse = COLOUR(r, g, b)                                                         \
    }
#define GLOSSY(r, g, b, gloss, exponent)                                                                               \
    {                                                                                                                  \
        .ambient = COLOUR(r, g, b), .diffuse = COLOUR(r, g, b), .specular = COLOUR(gloss, gloss, gloss),               \
        .exponent_q4 = (exponent)*16                                                                                   \
    }

static const glint_material wall = MATT(560, 530, 470), side_wall = MATT(420, 500, 540);
static const glint_material parquet = GLOSSY(460, 300, 180, 150, 12), wood = GLOSSY(520, 330, 180, 150, 16);
static const glint_material china = GLOSSY(620, 640, 680, 400, 60), red = GLOSSY(640, 120, 100, 450, 80);
static const glint_material green = GLOSSY(160, 480, 220, 300, 24), blue = GLOSSY(140, 240, 560, 200, 10);

/* Walls of 10 x 5, facing inwards: the plane's x along the wall, its y (its normal) into the room, its z downwards. */
#define WALL(mesh_material, x0, y0, z0, x1, y1, z1, x, z)                                                              \
    {                                                                                                                  \
        &glint_mesh_plane, &(mesh_material),                                                                           \
        {                                                                                                              \
            .linear_q16 = {{MILLI_Q16(5000 * (x0)), MILLI_Q16(1000 * (x1)), 0},                                        \
                           {MILLI_Q16(5000 * (y0)), MILLI_Q16(1000 * (y1)), MILLI_Q16(-2500)},                         \
                           {MILLI_Q16(5000 * (z0)), MILLI_Q16(1000 * (z1)), 0}},                                       \
            .origin_q16 = POINT(x, 2500, z)                                                                            \
        }                                                                                                              \
    }

static const glint_object objects[] = {
    {&glint_mesh_plane, &parquet, PLACE_SCALED(5000, 1000, 5000, 0, 0, 0)},
    WALL(wall, 1, 0, 0, 0, 0, 1, 0, -5000),       /* back */
    WALL(side_wall, 0, 0, -1, 1, 0, 0, -5000, 0), /* left */
    WALL(side_wall, 0, 0, 1, -1, 0, 0, 5000, 0),  /* right */
    WALL(wall, -1, 0, 0, 0, 0, -1, 0, 5000),      /* behind the camera */

    /* the table: a top of 2.4 x 1.8 on two trestles */
    {&glint_mesh_box, &wood, PLACE_SCALED(1300, 60, 900, 0, 1000, -400)},
    {&glint_mesh_box, &wood, PLACE_SCALED(60, 470, 750, -1000, 470, -400)},
    {&glint_mesh_box, &wood, PLACE_SCALED(60, 470, 750, 1000, 470, -400)},
    {&glint_mesh_teapot_small, &china, PLACE_TURNED(15, -8, 17, 270, -150, 1060, -500)},
    {&glint_mesh_sphere_32x16, &red, PLACE_SCALED(220, 220, 220, 900, 1280, 50)},

    {&glint_mesh_box, &blue, PLACE_TURNED(4, 3, 5, 550, -2400, 550, -2000)},
    {&glint_mesh_sphere_32x16, &green, PLACE_SCALED(450, 450, 450, -2400, 1550, -2000)},
    {&glint_mesh_box, &blue, PLACE_TURNED(12, -5, 13, 450, 2600, 450, -1500)},
    {&glint_mesh_sphere_32x16, &red, PLACE_SCALED(500, 500, 500, 2200, 500, 400)},
};

static const glint_light lights[] = {
    {.kind = GLINT_DIRECTIONAL, .direction = {-3, -8, -5}, .colour = COLOUR(300, 310, 340)},
    {.kind = GLINT_POINT, .position_q16 = POINT(-1500, 3800, 1000), .colour = COLOUR(700, 600, 450)},
    {.kind = GLINT_POINT, .position_q16 = POINT(3200, 3000, -3200), .colour = COLOUR(300, 330, 450)},
};

const glint_scene demo_room = {
    .camera = &camera,
    .objects = objects,
    .object_count = LENGTH_OF(objects),
    .lights = lights,
    .light_count = LENGTH_OF(lights),
    .ambient = COLOUR(220, 220, 230),
    .background = COLOUR(60, 65, 80),
};
