/* SPDX-License-Identifier: MIT */
/*
 * Parts of a backend that a program may do without. Each variant of a backend, a file of this folder, is the same
 * bodies compiled with BACKEND_PARTS as a constant: what a part does stands behind HAS(part), so that the compiler
 * leaves it out, and the linker takes only the variants that a program calls. A scene that asks for a part that its
 * variant has not is refused, never drawn otherwise. Validation, plan and memory are bodies of the variants too.
 * PART_SPANS and PART_LISTS change no picture: they cost flash and save time.
 */
#ifndef GLINT_BACKEND_PARTS_H
#define GLINT_BACKEND_PARTS_H

#define PART_SPECULAR 1u /* the specular term */
#define PART_POINTS 2u   /* point lights */
#define PART_CORNERS 4u  /* Gouraud and flat shading */
#define PART_TIERS 8u    /* tolerances, and the shadings q1 and q2 */
#define PART_REACH 16u   /* spot lights, attenuation */
#define PART_EXTENTS 32u /* panels and balls of light */
#define PART_SKY 64u     /* ambient light by the normal */
#define PART_MIRRORS 128u
#define PART_SIDES 256u  /* surfaces of which the inside is shown */
#define PART_FINISH 512u /* what comes between shading and packing: fog, transmission, edges of the mesh */
#define PART_TEXTURES 1024u
#define PART_SHADOWS 2048u
#define PART_REPORT 4096u /* glint_report: what a frame took, and the error promised */
#define PART_SPANS 8192u  /* rows of triangles by their ends, quicker than pixel by pixel */
#define PART_LISTS 16384u /* triangles sorted into bands once a frame, quicker than looking at each in each band */
#define PARTS_ALL 32767u

#ifndef BACKEND_PARTS
#define BACKEND_PARTS PARTS_ALL
#endif

#define HAS(part) ((BACKEND_PARTS & (part)) != 0)

#if HAS(PART_REACH | PART_EXTENTS) && !HAS(PART_POINTS)
#error "PART_REACH and PART_EXTENTS ask for PART_POINTS"
#endif
#if HAS(PART_TIERS | PART_FINISH) && !HAS(PART_SPANS)
#error "PART_TIERS and PART_FINISH ask for PART_SPANS"
#endif

#endif
