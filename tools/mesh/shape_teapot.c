/* SPDX-License-Identifier: MIT */
/*
 * The Utah teapot (M. E. Newell, "The utilization of procedure models in digital image synthesis", University of Utah,
 * 1975) from its published bicubic Bezier control points: the 32 patches over 306 points that are in common use, in
 * Blinn's proportions (height divided by 1.3) and with the bottom that others added.
 *
 * The published points have structure, which is what is stored here. Body, rim, bottom and lid are surfaces of
 * revolution: four quarters of one profile, with the inner points of each quarter circle at 0.56 of the radius (0.5625
 * on the knob). Handle and spout are rings mirrored in y = 0: two control points in that plane, and the same two again
 * half a width beside it. That restores all 306 points.
 *
 * The published data have z up; here (x, y, z) becomes (x, z, -y), a rotation: y is up, the base stands at y = 0, the
 * spout points along +x. Normals are the cross product of the patches' partial derivatives. Where a whole side of a
 * patch is one point (top of the knob, middle of the bottom), the derivative along that side vanishes, and its rate of
 * change across the patch takes its place: the normal's limit.
 *
 * Between the lid (radius 1.3) and the rim (1.4) the published data have a gap, through which a renderer that draws
 * only outsides shows the background. A flat ring is added here to close it. Otherwise the parts are as published:
 * handle and spout are open surfaces that run into the body, and there is no inside.
 */
#include "shape.h"

#include <math.h>

typedef struct patch {
    double control[4][4][3];
    int rows, columns; /* of the grid over it */
} patch;

/* Segments of a profile or a tube that bend more or less than the rest: rows of the grid for D divisions. */
typedef enum density { NORMAL, HALF, FINE, SINGLE } density;

static int rows_of(density d, int divisions)
{
    switch (d) {
    case HALF:
        return (divisions + 1) / 2;
    case FINE:
        return divisions + 2;
    case SINGLE:
        return 1;
    default:
        return divisions;
    }
}

/* Profile of a surface of revolution: radius, height, and the inner control points' distance as a share of the radius.
 */
typedef struct profile_point {
    double radius, height, round;
} profile_point;

static const profile_point body[] = {{1.4, 2.4, 0.56},  {1.3375, 2.53125, 0.56}, {1.4375, 2.53125, 0.56}, /* rim */
                                     {1.5, 2.4, 0.56},  {1.75, 1.875, 0.56},     {2.0, 1.35, 0.56},  /* upper body */
                                     {2.0, 0.9, 0.56},  {2.0, 0.45, 0.56},       {1.5, 0.225, 0.56}, /* lower body */
                                     {1.5, 0.15, 0.56}, {1.5, 0.075, 0.56},      {1.425, 0.0, 0.56},
                                     {0.0, 0.0, 0.56}};                                        /* bottom */
static const profile_point lid[] = {{0.0, 3.15, 0.56}, {0.8, 3.15, 0.5625}, {0.0, 2.85, 0.56}, /* knob */
                                    {0.2, 2.7, 0.56},  {0.4, 2.55, 0.56},   {1.3, 2.55, 0.56}, {1.3, 2.4, 0.56}};

/* Not in the published data: the ring between lid and rim, a straight line in the profile. */
static const profile_point ledge[] = {
    {1.3, 2.4, 0.56}, {1.3 + 0.1 / 3, 2.4, 0.56}, {1.4 - 0.1 / 3, 2.4, 0.56}, {1.4, 2.4, 0.56}};

/* The flat bottom and the narrow rim show less than the rest; the lip of the spout turns by more than half a circle. */
static const density body_rows[] = {HALF, NORMAL, NORMAL, HALF}, lid_rows[] = {NORMAL, NORMAL};
static const density ledge_rows[] = {SINGLE};
static const density handle_rows[] = {NORMAL, NORMAL}, spout_rows[] = {NORMAL, FINE};

/* One row of a handle's or spout's control points: the two in the plane y = 0, and half the width. */
typedef struct ring {
    double first_x, first_z, second_x, second_z, half_width;
} ring;

static const ring handle[] = {{-1.6, 2.025, -1.5, 2.25, 0.3}, {-2.3, 2.025, -2.5, 2.25, 0.3},
                              {-2.7, 2.025, -3.0, 2.25, 0.3}, {-2.7, 1.8, -3.0, 1.8, 0.3},
                              {-2.7, 1.575, -3.0, 1.35, 0.3}, {-2.5, 1.125, -2.65, 0.9375, 0.3},
                              {-2.0, 0.9, -1.9, 0.6, 0.3}};
static const ring spout[] = {{1.7, 1.425, 1.7, 0.6, 0.66},       {2.6, 1.425, 3.1, 0.825, 0.66},
                             {2.3, 2.1, 2.4, 2.025, 0.25},       {2.7, 2.4, 3.3, 2.4, 0.25},
                             {2.8, 2.475, 3.525, 2.49375, 0.25}, {2.9, 2.475, 3.45, 2.5125, 0.15},
                             {2.8, 2.4, 3.2, 2.4, 0.15}};

/* Values of the four Bernstein polynomials at t, and their derivatives. */
static void bernstein(double t, double value[4], double slope[4])
{
    double s = 1.0 - t;
    value[0] = s * s * s;
    value[1] = 3 * s * s * t;
    value[2] = 3 * s * t * t;
    value[3] = t * t * t;
    slope[0] = -3 * s * s;
    slope[1] = 3 * s * s - 6 * s * t;
    slope[2] = 6 * s * t - 3 * t * t;
    slope[3] = 3 * t * t;
}

static void tensor(const patch *p, const double u[4], const double v[4], double out[3])
{
    out[0] = out[1] = out[2] = 0.0;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            for (int k = 0; k < 3; k++) {
                out[k] += u[i] * v[j] * p->control[i][j][k];
            }
        }
    }
}

static shape_point patch_point(const void *context, int i, int j)
{
    const patch *p = context;
    double u[4], v[4], du[4], dv[4];
    bernstein((double)i / p->rows, u, du);
    bernstein((double)j / p->columns, v, dv);

    double position[3], along_u[3], along_v[3], normal[3];
    tensor(p, u, v, position);
    tensor(p, du, v, along_u);
    tensor(p, u, dv, along_v);
    if (sqrt(shape_dot(along_v, along_v)) < 1e-9) { /* a side in one point: only ever the rows i = 0 and i = rows */
        double side = i == 0 ? 1.0 : -1.0;          /* the way into the patch */
        tensor(p, du, dv, along_v);
        for (int k = 0; k < 3; k++) {
            along_v[k] *= side;
        }
    }
    shape_cross(along_u, along_v, normal);
    shape_normalise(normal);

    shape_point point = {{position[0], position[2], -position[1]}, {normal[0], normal[2], -normal[1]}, {0}};
    return point;
}

/* Rows down the profile, columns counter-clockwise seen from above: their cross product points outwards. */
static void add_revolution(shape *mesh, const profile_point *profile, const density *rows, int segments, int divisions)
{
    static const double quarter[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int segment = 0; segment < segments; segment++) {
        for (int turn = 0; turn < 4; turn++) {
            const double *x = quarter[turn], *y = quarter[(turn + 1) % 4];
            patch p;
            p.rows = rows_of(rows[segment], divisions);
            p.columns = divisions;
            for (int i = 0; i < 4; i++) {
                const profile_point *at = &profile[3 * segment + i];
                const double on[4][2] = {{1, 0}, {1, at->round}, {at->round, 1}, {0, 1}};
                for (int j = 0; j < 4; j++) {
                    for (int k = 0; k < 2; k++) {
                        p.control[i][j][k] = at->radius * (on[j][0] * x[k] + on[j][1] * y[k]);
                    }
                    p.control[i][j][2] = at->height;
                }
            }
            shape_add(mesh, p.rows, p.columns, patch_point, &p);
        }
    }
}

/* Rows along the tube, columns from the first to the second point over +y and back over -y: outwards for both tubes. */
static void add_tube(shape *mesh, const ring *rings, const density *rows, int segments, int divisions)
{
    for (int segment = 0; segment < segments; segment++) {
        for (int back = 0; back < 2; back++) {
            patch p;
            p.rows = rows_of(rows[segment], divisions);
            p.columns = divisions;
            for (int i = 0; i < 4; i++) {
                const ring *r = &rings[3 * segment + i];
                for (int j = 0; j < 4; j++) {
                    int second = (j >= 2) != back;
                    double width = j == 0 || j == 3 ? 0.0 : r->half_width;
                    p.control[i][j][0] = second ? r->second_x : r->first_x;
                    p.control[i][j][1] = back ? -width : width;
                    p.control[i][j][2] = second ? r->second_z : r->first_z;
                }
            }
            shape_add(mesh, p.rows, p.columns, patch_point, &p);
        }
    }
}

void shape_teapot(shape *mesh, int divisions)
{
    add_revolution(mesh, body, body_rows, 4, divisions);
    add_revolution(mesh, lid, lid_rows, 2, divisions);
    add_revolution(mesh, ledge, ledge_rows, 1, divisions);
    add_tube(mesh, handle, handle_rows, 2, divisions);
    add_tube(mesh, spout, spout_rows, 2, divisions);
}
