/* SPDX-License-Identifier: MIT */
/*
 * A grid of spheres: the specular share of the reflected light grows downwards (0.2, 0.4, 0.6, 0.8), the exponent to
 * the right (2, 8, 32, 128, 512). A larger exponent makes a narrower highlight. And a row of spheres for the exponent
 * alone.
 */
#include <examples/scenes/parts.h>

/* From afar, so that the outer spheres look as round as the inner ones. */
static const glint_camera camera = {
    .eye_q16 = POINT(0, 0, 30500),
    .target_q16 = POINT(0, 0, 0),
    .field_of_view_turn16 = DEGREES_TURN16(18),
    .near_q16 = MILLI_Q16(24500), /* the grid turned to the camera begins at 24.66 */
};

static const glint_light light = {.kind = GLINT_DIRECTIONAL, .direction = {4, -5, -7}, .colour = GLINT_WHITE};

#define MATERIAL(share, exponent)                                                                                      \
    {                                                                                                                  \
        .ambient = COLOUR(100, 250, 400), .diffuse = SHARE(1000 - (share), 200, 520, 850),                             \
        .specular = SHARE(share, 1000, 1000, 1000), .exponent_q4 = (exponent)*16                                       \
    }
#define MATERIALS(share)                                                                                               \
    {                                                                                                                  \
        MATERIAL(share, 2), MATERIAL(share, 8), MATERIAL(share, 32), MATERIAL(share, 128), MATERIAL(share, 512)        \
    }

static const glint_material materials[4][5] = {MATERIALS(200), MATERIALS(400), MATERIALS(600), MATERIALS(800)};

#define SPHERE(row, column)                                                                                            \
    {                                                                                                                  \
        &glint_mesh_sphere_24x12, &materials[row][column], PLACE_AT(2420 * (column)-4840, 3480 - 2320 * (row), 0)      \
    }
#define ROW(row) SPHERE(row, 0), SPHERE(row, 1), SPHERE(row, 2), SPHERE(row, 3), SPHERE(row, 4)

static const glint_object objects[] = {ROW(0), ROW(1), ROW(2), ROW(3)};

const glint_scene demo_specular_grid = {
    .camera = &camera,
    .objects = objects,
    .object_count = LENGTH_OF(objects),
    .lights = &light,
    .light_count = 1,
    .ambient = COLOUR(200, 200, 200),
    .background = COLOUR(50, 50, 60),
};

static const glint_camera row_camera = {
    .eye_q16 = POINT(0, 0, 35000),
    .target_q16 = POINT(0, 0, 0),
    .field_of_view_turn16 = DEGREES_TURN16(6),
    .near_q16 = MILLI_Q16(28000), /* the row turned to the camera begins at 28.25 */
};

static const glint_material row_materials[] = {MATERIAL(500, 2),  MATERIAL(500, 8),   MATERIAL(500, 32),
                                               MATERIAL(500, 96), MATERIAL(500, 256), MATERIAL(500, 1024)};

#define OF_ROW(column)                                                                                                 \
    {                                                                                                                  \
        &glint_mesh_sphere_32x16, &row_materials[column], PLACE_AT(2300 * (column)-5750, 0, 0)                         \
    }

static const glint_object row[] = {OF_ROW(0), OF_ROW(1), OF_ROW(2), OF_ROW(3), OF_ROW(4), OF_ROW(5)};

const glint_scene demo_exponents = {
    .camera = &row_camera,
    .objects = row,
    .object_count = LENGTH_OF(row),
    .lights = &light,
    .light_count = 1,
    .ambient = COLOUR(200, 200, 200),
    .background = COLOUR(50, 50, 60),
};
