/* SPDX-License-Identifier: MIT */
/*
 * The box from (-1,-1,-1) to (1,1,1): six faces with the face's normal at their own four corners, hence hard edges.
 */
#include "shape.h"

typedef struct face {
    int axis;    /* of the normal: 0 x, 1 y, 2 z */
    double sign; /* of the normal along that axis */
} face;

static shape_point face_point(const void *context, int i, int j)
{
    const face *f = context;
    /* with axes (axis, next, next but one) right-handed, rows along the next and columns along the one after face +axis
     */
    shape_point point = {{0}, {0}, {0}};
    point.normal[f->axis] = f->sign;
    point.position[f->axis] = f->sign;
    point.position[(f->axis + 1) % 3] = f->sign * (2 * i - 1);
    point.position[(f->axis + 2) % 3] = 2 * j - 1;
    return point;
}

void shape_box(shape *mesh)
{
    for (int n = 0; n < 6; n++) {
        face f = {n / 2, n % 2 ? -1.0 : 1.0};
        shape_add(mesh, 1, 1, face_point, &f);
    }
}
