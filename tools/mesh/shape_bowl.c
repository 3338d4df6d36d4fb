/* SPDX-License-Identifier: MIT */
/*
 * The lower half of the unit sphere about the origin, open at the top: a surface of which both sides can be seen.
 * sectors * (2 * stacks - 1) triangles, sectors * stacks + 1 vertices.
 */
#include "shape.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

typedef struct bowl {
    int sectors, stacks;
} bowl;

static shape_point bowl_point(const void *context, int i, int j)
{
    const bowl *b = context;
    double below = pi / 2 * i / b->stacks;                     /* from the rim */
    double longitude = 2 * pi * (j % b->sectors) / b->sectors; /* from +z towards +x */
    /* the foot is one point, and the rim level, only if they are made so */
    double radius = i == b->stacks ? 0.0 : cos(below), y = i == 0 ? 0.0 : -sin(below);
    shape_point point = {{radius * sin(longitude), y, radius * cos(longitude)}, {0}, {0}};
    for (int k = 0; k < 3; k++) {
        point.normal[k] = point.position[k];
    }
    return point;
}

void shape_bowl(shape *mesh, int sectors, int stacks)
{
    bowl b = {sectors, stacks};
    shape_add(mesh, stacks, sectors, bowl_point, &b);
}
