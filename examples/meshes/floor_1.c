/* SPDX-License-Identifier: MIT */ /* made by: generate-mesh floor 1 12 glint_mesh_floor_1 */
/*
 * 4 vertices, 2 triangles. Worst quantisation error: positions 0.00e+00 model units, normals 0.0000 degrees.
 */
#include <glint/mesh.h>

/* clang-format off */

static const int16_t glint_mesh_floor_1_positions[][3] GLINT_FLASH = {
    {-16384, 0, -16384}, {16384, 0, -16384}, {-16384, 0, 16384}, {16384, 0, 16384},
};

static const int16_t glint_mesh_floor_1_normals_q14[][3] GLINT_FLASH = {
    {0, 16384, 0}, {0, 16384, 0}, {0, 16384, 0}, {0, 16384, 0},
};

static const int16_t glint_mesh_floor_1_texcoords[][2] GLINT_FLASH = {
    {0, 0}, {24576, 0}, {0, 24576}, {24576, 24576},
};

static const uint16_t glint_mesh_floor_1_triangles[][3] GLINT_FLASH = {
    {0, 2, 3}, {0, 3, 1},
};

const glint_mesh glint_mesh_floor_1 = {
    .positions = glint_mesh_floor_1_positions,
    .normals_q14 = glint_mesh_floor_1_normals_q14,
    .triangles = glint_mesh_floor_1_triangles,
    .vertex_count = 4,
    .triangle_count = 2,
    .fraction_bits = 14,
    .texcoord_bits = 11,
    .texcoords = glint_mesh_floor_1_texcoords,
};
