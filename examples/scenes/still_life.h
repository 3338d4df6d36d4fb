/* SPDX-License-Identifier: MIT */
/*
 * The still life that several scenes of the gallery share: a teapot, a sphere and a knot on a floor.
 */
#ifndef EXAMPLES_SCENES_STILL_LIFE_H
#define EXAMPLES_SCENES_STILL_LIFE_H

#include <examples/scenes/parts.h>

/* Initialisers of the camera and of the four objects, whose materials are named. */
#define STILL_LIFE_CAMERA                                                                                              \
    {                                                                                                                  \
        .eye_q16 = POINT(0, 6200, 11800), .target_q16 = POINT(0, 1000, 0), .field_of_view_turn16 = DEGREES_TURN16(29), \
        .near_q16 = MILLI_Q16(8600)                                                                                    \
    }

/* The knot stands on its edge: 0.9 of its radius of 1.72 above the floor. */
#define STILL_LIFE_OBJECTS(teapot, sphere, knot, floor)                                                                \
    {                                                                                                                  \
        {&glint_mesh_teapot, &(teapot), PLACE_TURNED(15, -8, 17, 900, -1300, 0, -700)},                                \
            {&glint_mesh_sphere_32x16, &(sphere), PLACE_SCALED(850, 850, 850, 1350, 850, 2500)},                       \
            {&glint_mesh_torus_knot, &(knot), PLACE_TURNED(4, -3, 5, 900, 2900, 1560, -1200)},                         \
            {&glint_mesh_plane, &(floor), PLACE_SCALED(9000, 1000, 4200, 0, 0, 0)},                                    \
    }

#endif
