/* SPDX-License-Identifier: MIT */
/*
 * Glint: lights and draws triangle meshes with the Phong reflectance model on small displays.
 *
 * A frame takes const data in and one call:
 *
 *   1. Describe the scene (scene.h): meshes, materials, lights and a camera in fixed formats. Meshes are usually
 * constant data that a tool has written; a light or an object's place may change from frame to frame.
 *   2. Describe the display (display.h): its size, its pixel format, the height of a band, and a flush function that
 * sends a finished band of pixels.
 *   3. Give memory: GLINT_MEMORY_WORDS below at compile time, or glint_fixed_memory_bytes() at run time.
 *   4. Call glint_fixed_render() or glint_float_render(). Both read the same scene. 0 means that every band has been
 * sent.
 *
 * Conventions
 *   world       right-handed, any unit of length
 *   rotation    counter-clockwise seen from the tip of the axis; angles in 1/65536 turn
 *   triangles   counter-clockwise seen from outside
 *   display     pixel (0, 0) top left, x right, y down; a pixel is sampled at its centre, (x + 1/2, y + 1/2)
 *   fill rule   a centre on an edge belongs to the triangle whose left or horizontal top edge it is
 *   depth       near / Z in 16 bits, greater is nearer; where equal, the triangle drawn first stays
 *   Q-format    a name that ends in _qN holds a real number times 2^N: 16384 in a _q14 is 1
 *
 * README.md has a complete program, docs/formats.md every quantity's format, range and unit.
 */
#ifndef GLINT_GLINT_H
#define GLINT_GLINT_H

#include <glint/config.h>
#include <glint/display.h>
#include <glint/error.h>
#include <glint/fixed.h>
#include <glint/float.h>
#include <glint/memory.h>
#include <glint/mesh.h>
#include <glint/parts.h>
#include <glint/place.h>
#include <glint/plan.h>
#include <glint/quality.h>
#include <glint/scene.h>
#include <glint/texture.h>

#endif
