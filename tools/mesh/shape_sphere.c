/* SPDX-License-Identifier: MIT */
/*
 * The unit sphere about the origin as stacks of latitude and sectors of longitude, poles on the y axis. All points of a
 * pole and of the seam coincide with equal normals, so that the writer welds them to one vertex each:
 * sectors * (2 * stacks - 2) triangles, sectors * (stacks - 1) + 2 vertices.
 *
 * As a globe it has texture coordinates: u is the longitude, 0..1 eastwards from +z, v the latitude, 0 at the north
 * pole. The seam's points are there twice, with u = 0 and 1, and a pole's once for each sector, at its middle:
 * sectors * (stacks - 1) + stacks - 1 + 2 * sectors vertices.
 */
#include "shape.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

typedef struct sphere {
    int sectors, stacks;
} sphere;

static shape_point sphere_point(const void *context, int i, int j)
{
    const sphere *s = context;
    double latitude = pi * i / s->stacks;                      /* from the north pole */
    double longitude = 2 * pi * (j % s->sectors) / s->sectors; /* from +z towards +x */
    /* sin(pi) is not 0 in double precision: the south pole is one point only if it is made so */
    double radius = i == s->stacks ? 0.0 : sin(latitude);
    shape_point point = {{radius * sin(longitude), cos(latitude), radius * cos(longitude)}, {0}, {0}};
    for (int k = 0; k < 3; k++) {
        point.normal[k] = point.position[k];
    }
    return point;
}

static shape_point globe_point(const void *context, int i, int j)
{
    const sphere *s = context;
    shape_point point = sphere_point(context, i, j);
    /* a pole's point belongs to the sector that begins with it, at the south pole to the one that ends with it */
    const double at = i == 0 ? (j < s->sectors ? j : j - 1) + 0.5 : i == s->stacks ? (j > 0 ? j : 1) - 0.5 : j;
    point.texcoord[0] = at / s->sectors;
    point.texcoord[1] = (double)i / s->stacks;
    return point;
}

void shape_sphere(shape *mesh, int sectors, int stacks)
{
    sphere s = {sectors, stacks};
    shape_add(mesh, stacks, sectors, sphere_point, &s);
}

void shape_globe(shape *mesh, int sectors, int stacks)
{
    sphere s = {sectors, stacks};
    mesh->has_texcoords = 1;
    shape_add(mesh, stacks, sectors, globe_point, &s);
}
