/* SPDX-License-Identifier: MIT */
/*
 * What the panel shows: a torus knot in gold, turning. Also compiled on the host, which draws the same bits.
 */
#ifndef EXAMPLES_PICO_ST7789_SCENE_H
#define EXAMPLES_PICO_ST7789_SCENE_H

#include <stdint.h>

#include <glint/display.h>
#include <glint/quality.h>
#include <glint/scene.h>

#define PANEL_WIDTH_PX 240
#define PANEL_HEIGHT_PX 240
#define PANEL_FORMAT GLINT_RGB565_SWAPPED

/* For GLINT_MEMORY_WORDS. */
#define GOLD_KNOT_VERTICES 1152
#define GOLD_KNOT_TRIANGLES 2304
#define GOLD_KNOT_OBJECTS 1
#define GOLD_KNOT_LIGHTS 2

extern const glint_scene gold_knot;
extern const glint_quality gold_knot_quality; /* within one code of the model, at each pixel */

#endif
