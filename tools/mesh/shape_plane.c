/* SPDX-License-Identifier: MIT */
/*
 * The square from (-1,0,-1) to (1,0,1), facing +y, as a grid of cells x cells: floors and walls. Cells matter where the
 * shading interpolates colours between corners (Gouraud), since a highlight may fall between them.
 */
#include "shape.h"

static shape_point plane_point(const void *context, int i, int j)
{
    const int *cells = context;
    shape_point point = {{2.0 * j / *cells - 1.0, 0.0, 2.0 * i / *cells - 1.0}, {0.0, 1.0, 0.0}};
    return point;
}

void shape_plane(shape *mesh, int cells)
{
    shape_add(mesh, cells, cells, plane_point, &cells);
}
