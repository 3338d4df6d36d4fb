/* SPDX-License-Identifier: MIT */
/*
 * Limits and compile-time conditions that hold for every header and source of Glint.
 */
#ifndef GLINT_CONFIG_H
#define GLINT_CONFIG_H

#define GLINT_VERSION_MAJOR 0
#define GLINT_VERSION_MINOR 1
#define GLINT_VERSION_PATCH 0

/* -ffast-math removes the comparisons that keep zero-length normals and vertices behind the camera out of a division.
 */
#ifdef __FAST_MATH__
#error "Glint does not work under -ffast-math: compile it without"
#endif

/* Greatest width and height of a display. The rasterizer's edge functions are exact in 32 bits for triangles whose
 * bounding box is at most 2896 px wide and high (docs/formats.md); the guard band takes the rest. */
#define GLINT_MAX_SIZE_PX 2048

/* Greatest specular exponent. At 1024 a highlight's half width at half height is 2.1 degrees. */
#define GLINT_MAX_EXPONENT 1024

/* Greatest number of lights: their sum is taken in 32 bits, with one saturation at the end. */
#define GLINT_MAX_LIGHTS 4096

/* Define as 0 where the library is compiled to leave out shadows and the flash that they take, 6 KB on a Cortex-M0+. A
 * scene that asks for them is refused then (GLINT_ERROR_NOT_BUILT). */
#ifndef GLINT_SHADOWS
#define GLINT_SHADOWS 1
#endif

/*
 * Marks constant data that stays in program memory. Only the AVR, whose flash is not in the data address space, needs
 * more than `const`: there the arrays that a glint_mesh points to MUST carry this mark, since the library reads them
 * with the flash load instruction. Elsewhere the mark is empty.
 */
#if defined(__AVR__)
#include <avr/pgmspace.h>
#define GLINT_FLASH PROGMEM
#else
#define GLINT_FLASH
#endif

#endif
