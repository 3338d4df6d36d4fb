/* SPDX-License-Identifier: MIT */
/*
 * The edges of a triangle's mesh, drawn over it: pixels whose centres are near to the line through an edge.
 *
 * With E the edge function of snapped corners (raster/edges.h), the distance of a pixel's centre is E / |d| sub-pixels,
 * d the edge. What is stepped from pixel to pixel is floor(E / 256), exactly, modulo 2^32; it is below 2^31 in
 * magnitude within the triangle. The border of the line is off by at most 1.1 / |d|: 1/232 px at an edge of one pixel,
 * less at a longer one (tests/unit/test_wire.c).
 */
#ifndef GLINT_EFFECTS_WIRE_H
#define GLINT_EFFECTS_WIRE_H

#include <glint/scene.h>

#include "display/pack.h"
#include "raster/edges.h"

typedef struct glint_wire {
    uint16_t width_q4; /* 1/16 px; 0: none, and nothing else is set */
    glint_shade colour;
} glint_wire;

typedef struct glint_wire_line {
    uint32_t value, step_x, step_y; /* floor(E / 256) at pixel (0, 0), a pixel farther right and down, modulo 2^32 */
    uint32_t limit;                 /* |E / 256| below this is on the line; at most 2^28 */
} glint_wire_line;

void glint_wire_set_up(glint_wire *wire, const glint_material *material);

/* The line through two corners. False where they are the same. */
bool glint_wire_line_set_up(glint_wire_line *line, const glint_point *from, const glint_point *to, uint16_t width_q4);

/* Bit i is set where pixel (x + i, y) is on the line, for i below `count`, at most 16. */
uint16_t glint_wire_row(const glint_wire_line *line, int16_t x, int16_t y, uint16_t count);

#endif
