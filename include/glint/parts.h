/* SPDX-License-Identifier: MIT */
/*
 * Parts of a backend: what a program names it links, what it does not name it does not: no code, no table.
 *
 * The prebuilt library has three choices of each backend: glint_fixed_render() with all parts,
 * glint_fixed_phong_render() and glint_fixed_diffuse_render() (see <glint/fixed.h>). For another choice, a file of two
 * lines in the program's own sources compiles the backend with the parts that it names; the rest comes from the
 * library:
 *
 *     #define GLINT_PARTS (GLINT_PART_SPECULAR | GLINT_PART_TEXTURES)
 *     #include <glint/fixed_parts.h>
 *
 * That file then holds glint_fixed_parts_render(), glint_fixed_parts_memory_bytes() and
 * glint_fixed_parts_memory_least_bytes(), which <glint/fixed.h> declares (<glint/float_parts.h> the same of float).
 * They draw the pixels of glint_fixed_render(), bit for bit; a scene or quality that asks for a part which was not
 * named is refused with GLINT_ERROR_PART before anything is written.
 *
 * Always there: ambient light, diffuse reflection, emission, directional lights, exact shading at each pixel.
 * GLINT_PART_SPANS and GLINT_PART_LISTS are worth naming where flash allows.
 */
#ifndef GLINT_PARTS_H
#define GLINT_PARTS_H

#define GLINT_PART_SPECULAR 0x1u /* specular reflection, Phong's and Blinn's */
#define GLINT_PART_POINTS 0x2u   /* point lights */
#define GLINT_PART_CORNERS 0x4u  /* Gouraud and flat shading */
#define GLINT_PART_TIERS 0x8u    /* tolerances, and the shadings q1 and q2 */
#define GLINT_PART_REACH 0x10u   /* spot lights and attenuation; brings GLINT_PART_POINTS */
#define GLINT_PART_EXTENTS 0x20u /* panels and balls of light; brings GLINT_PART_POINTS */
#define GLINT_PART_SKY 0x40u     /* ambient light by the normal: sky and ground */
#define GLINT_PART_MIRRORS 0x80u /* the environment mirrored */
#define GLINT_PART_SIDES 0x100u  /* surfaces of which the inside is shown */
#define GLINT_PART_FOG 0x200u
#define GLINT_PART_TRANSMISSION 0x400u
#define GLINT_PART_WIRE 0x800u /* edges of the mesh */
#define GLINT_PART_TEXTURES 0x1000u
#define GLINT_PART_SHADOWS 0x2000u
#define GLINT_PART_REPORT 0x4000u /* glint_report: what a frame took, and the error promised */
#define GLINT_PARTS_ALL 0x1ffffu

/* These change no picture, they cost flash and save time: */
#define GLINT_PART_SPANS 0x8000u  /* rows of triangles by their ends; brought by tiers, fog, transmission and wire */
#define GLINT_PART_LISTS 0x10000u /* triangles sorted into bands once a frame, not looked at again in each band */

#endif
