/* SPDX-License-Identifier: MIT */
/*
 * A tube along the (p, q) torus knot: p turns about the z axis while it turns q times about the ring.
 *
 *     C(t) = ((R + r cos qt) cos pt, (R + r cos qt) sin pt, r sin qt),   R = 1, r = 0.5, tube radius 0.22
 *
 * The curve lies on a torus, whose unit normal N(t) = (cos qt cos pt, cos qt sin pt, sin qt) is perpendicular to the
 * tangent T everywhere and comes back to itself after one round. {N, T x N} is therefore a frame without a seam, in
 * closed form; a Frenet frame would do as well only while the curvature is not 0, a transported one would not close.
 * For any frame perpendicular to T the tube's true normal is the radial direction within the frame.
 */
#include "shape.h"

#include <math.h>

static const double pi = 3.14159265358979323846;
static const double ring_radius = 1.0, knot_radius = 0.5, tube_radius = 0.22;

typedef struct knot {
    int p, q, segments, sides;
} knot;

static shape_point knot_point(const void *context, int i, int j)
{
    const knot *k = context;
    double t = 2 * pi * (j % k->segments) / k->segments;
    double around = 2 * pi * (i % k->sides) / k->sides;
    double cp = cos(k->p * t), sp = sin(k->p * t), cq = cos(k->q * t), sq = sin(k->q * t);
    double out = ring_radius + knot_radius * cq;

    double centre[3] = {out * cp, out * sp, knot_radius * sq};
    double tangent[3] = {-knot_radius * k->q * sq * cp - out * k->p * sp,
                         -knot_radius * k->q * sq * sp + out * k->p * cp, knot_radius * k->q * cq};
    double normal[3] = {cq * cp, cq * sp, sq}, side[3];
    shape_normalise(tangent);
    shape_cross(tangent, normal, side);

    shape_point point = {{0}, {0}, {0}};
    for (int c = 0; c < 3; c++) {
        point.normal[c] = cos(around) * normal[c] + sin(around) * side[c];
        point.position[c] = centre[c] + tube_radius * point.normal[c];
    }
    return point;
}

void shape_torus_knot(shape *mesh, int p, int q, int segments, int sides)
{
    knot k = {p, q, segments, sides};
    shape_add(mesh, sides, segments, knot_point, &k);
}
