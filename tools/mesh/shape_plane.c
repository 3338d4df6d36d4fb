/* SPDX-License-Identifier: MIT */
/*
 * The square from (-1,0,-1) to (1,0,1), facing +y, as a grid of cells x cells: floors and walls. Cells matter where the
 * shading interpolates colours between corners (Gouraud), since a highlight may fall between them.
 *
 * As a floor it has texture coordinates: u from 0 to `repeats` along +x, v along +z, so that seen from above with +z
 * towards the viewer the texture's first row is the farthest one.
 */
#include "shape.h"

typedef struct plane {
    int cells, repeats;
} plane;

static shape_point plane_point(const void *context, int i, int j)
{
    const plane *p = context;
    shape_point point = {{2.0 * j / p->cells - 1.0, 0.0, 2.0 * i / p->cells - 1.0},
                         {0.0, 1.0, 0.0},
                         {(double)j * p->repeats / p->cells, (double)i * p->repeats / p->cells}};
    return point;
}

void shape_plane(shape *mesh, int cells)
{
    const plane p = {cells, 0};
    shape_add(mesh, cells, cells, plane_point, &p);
}

void shape_floor(shape *mesh, int cells, int repeats)
{
    const plane p = {cells, repeats};
    mesh->has_texcoords = 1;
    shape_add(mesh, cells, cells, plane_point, &p);
}
