/* SPDX-License-Identifier: MIT */
/*
 * The built-in textures: constant data made by tools/generate-textures.c. One object file each, so that a program links
 * only the textures that it names.
 */
#ifndef EXAMPLES_TEXTURES_TEXTURES_H
#define EXAMPLES_TEXTURES_TEXTURES_H

#include <glint/config.h>
#include <glint/texture.h>

#ifdef __cplusplus
extern "C" {
#endif

extern const glint_texture glint_texture_tiles;  /* 32 x 32, 8 colours, nearest: 1 KB */
extern const glint_texture glint_texture_planks; /* 64 x 64 in RGB565, bilinear: 8 KB */
extern const glint_texture glint_texture_globe;  /* 128 x 64, 12 colours, bilinear, clamped at the poles: 8 KB */

#ifdef __cplusplus
}
#endif

#endif
