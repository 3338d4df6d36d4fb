/* SPDX-License-Identifier: MIT */
/*
 * What becomes of a shaded pixel: the side of the surface that is seen.
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
