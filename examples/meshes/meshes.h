/* SPDX-License-Identifier: MIT */
/*
 * The built-in meshes: constant data made by tools/mesh/generate-mesh (tools/mesh/regenerate.sh has the commands). One
 * object file each, so that a program links only the meshes that it names. Each file's head states its vertex and
 * triangle counts and the quantisation error of its positions and normals.
 */
#ifndef EXAMPLES_MESHES_MESHES_H
#define EXAMPLES_MESHES_MESHES_H

#include <glint/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Unit sphere about the origin, poles on the y axis: SECTORS x STACKS. */
extern const glint_mesh glint_mesh_sphere_10x6;  /* 100 triangles */
extern const glint_mesh glint_mesh_sphere_24x12; /* 528 triangles */
extern const glint_mesh glint_mesh_sphere_32x16; /* 960 triangles */
extern const glint_mesh glint_mesh_sphere_64x32; /* 3,968 triangles */

/* The lower half of that sphere, open at the top. */
extern const glint_mesh glint_mesh_bowl; /* 480 triangles */

/* The Utah teapot: y is up, its base stands at y = 0 on the y axis, its spout points along +x. About 6.4 units from
 * handle to spout and 3.15 high. Handle and spout are open surfaces that run into the body, as published. */
extern const glint_mesh glint_mesh_teapot;       /* 3,648 triangles */
extern const glint_mesh glint_mesh_teapot_small; /* 928 triangles */

/* A tube of radius 0.22 along the (2,3) torus knot about the z axis, 1.72 about the origin. */
extern const glint_mesh glint_mesh_torus_knot;       /* 2,304 triangles */
extern const glint_mesh glint_mesh_torus_knot_small; /* 1,280 triangles */

/* The box from (-1,-1,-1) to (1,1,1), with hard edges. */
extern const glint_mesh glint_mesh_box;

/* The square from (-1,0,-1) to (1,0,1), facing up (+y), as a grid of 8 x 8 cells. */
extern const glint_mesh glint_mesh_plane;

/* The same sphere and square with texture coordinates: u along +x, or eastwards, v along +z, or from the north pole
 * down. The texture repeats 12 times along the square's sides. */
extern const glint_mesh glint_mesh_globe_32x16;                 /* 960 triangles */
extern const glint_mesh glint_mesh_floor_1, glint_mesh_floor_8; /* as one cell, and as a grid of 8 x 8 cells */

#ifdef __cplusplus
}
#endif

#endif
