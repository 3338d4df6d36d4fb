/* SPDX-License-Identifier: MIT */
/*
 * Triangles given by where they stand on the display: a mesh in a plane that faces the eye at a distance where a unit
 * is a pixel. White in ambient light on black, so that in GLINT_GREY8 a covered pixel is 255.
 */
#ifndef GLINT_TESTS_HARD_SHEET_H
#define GLINT_TESTS_HARD_SHEET_H

#include "tests/hard/hard.h"

#define SHEET_TRIANGLES 2048

typedef struct sheet {
    int16_t positions[3 * SHEET_TRIANGLES][3], normals[3 * SHEET_TRIANGLES][3];
    uint16_t triangles[SHEET_TRIANGLES][3];
    uint16_t width, height;
    glint_mesh mesh;
    glint_camera camera;
    glint_material material;
    glint_object object;
    glint_scene scene;
} sheet;

/* Positions will be in 2^-fraction_bits px. Width and height are even. It points into itself: not to be copied. */
static inline void sheet_begin(sheet *s, uint16_t width, uint16_t height, int fraction_bits)
{
    memset(s, 0, sizeof *s);
    s->width = width;
    s->height = height;
    s->mesh.positions = (const int16_t(*)[3])s->positions;
    s->mesh.normals_q14 = (const int16_t(*)[3])s->normals;
    s->mesh.triangles = (const uint16_t(*)[3])s->triangles;
    s->mesh.fraction_bits = (int8_t)fraction_bits;
    s->camera.eye_q16[2] = (int32_t)height << 15; /* at 90 degrees a unit is a px there */
    s->camera.field_of_view_turn16 = 16384;
    s->camera.near_q16 = 1 << 16;
    s->material.ambient = board_grey(16384);
    s->scene.ambient = board_grey(16384);
    s->object.mesh = &s->mesh;
    s->object.material = &s->material;
    s->scene.camera = &s->camera;
    s->scene.objects = &s->object;
    s->scene.object_count = 1;
}

/* Adds a triangle as it is: x to the right and y down from the display's centre, in units of the mesh. */
static inline void sheet_add(sheet *s, int32_t xy[3][2])
{
    const uint16_t first = s->mesh.vertex_count;
    assert_true(s->mesh.triangle_count < SHEET_TRIANGLES);
    for (int i = 0; i < 3; i++) {
        s->positions[first + i][0] = (int16_t)xy[i][0];
        s->positions[first + i][1] = (int16_t)-xy[i][1];
        s->normals[first + i][2] = 16384;
        s->triangles[s->mesh.triangle_count][i] = (uint16_t)(first + i);
    }
    s->mesh.vertex_count = (uint16_t)(first + 3);
    s->mesh.triangle_count++;
}

/* Twice the area, positive for corners clockwise on the display. */
static inline int64_t sheet_area(int32_t xy[3][2])
{
    return (int64_t)(xy[1][0] - xy[0][0]) * (xy[2][1] - xy[0][1]) -
           (int64_t)(xy[2][0] - xy[0][0]) * (xy[1][1] - xy[0][1]);
}

/* Adds a triangle so that it faces the eye. */
static inline void sheet_add_facing(sheet *s, int32_t xy[3][2])
{
    const int turned = sheet_area(xy) > 0;
    int32_t facing[3][2] = {{xy[0][0], xy[0][1]},
                            {xy[turned ? 2 : 1][0], xy[turned ? 2 : 1][1]},
                            {xy[turned ? 1 : 2][0], xy[turned ? 1 : 2][1]}};
    sheet_add(s, facing);
}

static inline frame sheet_draw(const sheet *s, uint8_t shading, int backend)
{
    return hard_draw(&s->scene, s->width, s->height, GLINT_GREY8, shading, backend);
}

static inline long frame_covered(const frame *f)
{
    long count = 0;
    for (size_t i = 0; i < f->bytes; i++) {
        count += f->pixels[i] != 0;
    }
    return count;
}

#endif
