/* SPDX-License-Identifier: MIT */
/*
 * What main.c needs to know of picture.c for the sizes of its buffers.
 */
#ifndef EXAMPLES_PICO_ST7789_PICTURE_SIZE_H
#define EXAMPLES_PICO_ST7789_PICTURE_SIZE_H

#include <glint/glint.h>

#define PICTURE_WIDTH_PX 240
#define PICTURE_HEIGHT_PX 240
#define PICTURE_BAND_PX 6
#define PICTURE_BUFFERS 2
#define PICTURE_FORMAT GLINT_RGB565_SWAPPED

#define PICTURE_VERTICES 640 /* glint_mesh_torus_knot_small */
#define PICTURE_TRIANGLES 1280
#define PICTURE_OBJECTS 1
#define PICTURE_LIGHTS 2

#endif
