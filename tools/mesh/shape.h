/* SPDX-License-Identifier: MIT */
/*
 * A triangle mesh in double precision while it is being made: a list of surfaces, each a grid of points with their true
 * normals. The shapes (shape_*.c) only evaluate points; welding, quantisation and the C source are mesh_writer.c's.
 */
#ifndef TOOLS_MESH_SHAPE_H
#define TOOLS_MESH_SHAPE_H

#include <stddef.h>
#include <stdint.h>

typedef struct shape_point {
    double position[3]; /* model units */
    double normal[3];   /* unit */
    double texcoord[2]; /* u, v; 0 in a shape without */
} shape_point;

typedef struct shape {
    shape_point *points;
    uint32_t (
        *triangles)[3]; /* counter-clockwise from outside; may have repeated points where a grid's row is one point */
    size_t point_count, point_room;
    size_t triangle_count, triangle_room;
    int has_texcoords; /* points that differ in them are kept apart, and they are written */
} shape;

/* Point (i, j) of a surface: i = 0..rows, j = 0..columns. Must give the same bits wherever two grid points coincide. */
typedef shape_point shape_surface(const void *context, int i, int j);

/*
 * Adds the grid of (rows + 1) x (columns + 1) points and its 2 * rows * columns triangles.
 * Outside is where (direction of growing i) x (direction of growing j) points.
 */
void shape_add(shape *mesh, int rows, int columns, shape_surface *surface, const void *context);

void shape_free(shape *mesh);

/* Greatest value of each argument below; keeps every mesh within 16-bit indices before the writer has to refuse it. */
#define SHAPE_MAX_DIVISIONS 2048

/* Each adds one shape to `mesh`; see the files for axes and sizes. Arguments are checked by the caller. */
void shape_sphere(shape *mesh, int sectors, int stacks);                   /* sectors >= 3, stacks >= 2 */
void shape_bowl(shape *mesh, int sectors, int stacks);                     /* sectors >= 3, stacks >= 1 */
void shape_globe(shape *mesh, int sectors, int stacks);                    /* a sphere with texture coordinates */
void shape_teapot(shape *mesh, int divisions);                             /* divisions >= 4: the lip of the spout */
void shape_torus_knot(shape *mesh, int p, int q, int segments, int sides); /* p, q >= 1 without common divisor */
void shape_box(shape *mesh);
void shape_plane(shape *mesh, int cells);              /* cells >= 1 */
void shape_floor(shape *mesh, int cells, int repeats); /* a plane with texture coordinates; repeats 1..63 */

/* Small vector helpers that the shapes share. */
static inline void shape_cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static inline double shape_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* In place; a zero vector stays. Returns the length that it had. */
double shape_normalise(double v[3]);

#endif
