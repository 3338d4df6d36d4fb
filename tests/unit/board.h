/* SPDX-License-Identifier: MIT */
/*
 * A board that fills the picture: two triangles in the plane z = 0 that face the eye at (0, 0, 5), which looks at the
 * origin with a field of view of 90 degrees. At BOARD_PX (odd) pixels the middle of the centre pixel sees the origin
 * along the board's normal, so that the model has a closed form there.
 */
#ifndef GLINT_TESTS_UNIT_BOARD_H
#define GLINT_TESTS_UNIT_BOARD_H

#include "tests/image/frame.h"

#define BOARD_PX 33
#define BOARD_UNIT 1024 /* positions in 1/1024 */
#define BOARD_Q16(x) ((int32_t)((x)*65536.0))
#define BOARD_LIGHTS 4

typedef struct board {
    int16_t positions[4][3], normals[4][3];
    uint16_t triangles[2][3];
    glint_mesh mesh;
    glint_camera camera;
    glint_material material;
    glint_light light[BOARD_LIGHTS];
    glint_object object;
    glint_scene scene;
} board;

static inline glint_colour board_grey(int q14)
{
    const glint_colour colour = {(int16_t)q14, (int16_t)q14, (int16_t)q14};
    return colour;
}

static inline void board_light(board *b, int number, int x, int y, int z)
{
    b->light[number].kind = GLINT_DIRECTIONAL;
    b->light[number].direction[0] = (int16_t)x;
    b->light[number].direction[1] = (int16_t)y;
    b->light[number].direction[2] = (int16_t)z;
    b->light[number].colour = board_grey(16384);
}

static inline void board_normals(board *b, int x, int y, int z)
{
    for (int i = 0; i < 4; i++) {
        b->normals[i][0] = (int16_t)x;
        b->normals[i][1] = (int16_t)y;
        b->normals[i][2] = (int16_t)z;
    }
}

/* Black material, one white light along -z; points into itself, so it is not copied. */
static inline void board_set_up(board *b)
{
    static const int16_t corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    static const uint16_t triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
    memset(b, 0, sizeof *b);
    for (int i = 0; i < 4; i++) {
        b->positions[i][0] = (int16_t)(corner[i][0] * 20 * BOARD_UNIT);
        b->positions[i][1] = (int16_t)(corner[i][1] * 20 * BOARD_UNIT);
    }
    memcpy(b->triangles, triangles, sizeof triangles);
    board_normals(b, 0, 0, 16384);
    b->mesh.positions = (const int16_t(*)[3])b->positions;
    b->mesh.normals_q14 = (const int16_t(*)[3])b->normals;
    b->mesh.triangles = (const uint16_t(*)[3])b->triangles;
    b->mesh.vertex_count = 4;
    b->mesh.triangle_count = 2;
    b->mesh.fraction_bits = 10;
    b->camera.eye_q16[2] = BOARD_Q16(5);
    b->camera.field_of_view_turn16 = 16384;
    b->camera.near_q16 = BOARD_Q16(1);
    for (int i = 0; i < BOARD_LIGHTS; i++) {
        board_light(b, i, 0, 0, -1);
    }
    b->object.mesh = &b->mesh;
    b->object.material = &b->material;
    b->scene.camera = &b->camera;
    b->scene.objects = &b->object;
    b->scene.lights = b->light;
    b->scene.object_count = 1;
    b->scene.light_count = 1;
}

#endif
