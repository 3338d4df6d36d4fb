/* SPDX-License-Identifier: MIT */
/*
 * The yardstick scenes and how each is shaded: a line a case, counted on every target that has the memory, in both
 * backends.
 *
 *   A           sphere of 960 triangles, tinted highlight, 240 x 240: about 248 triangles face the eye
 *   A-bands16   the same in bands of 16 rows
 *   A-8-lights  the same under eight white lights of an eighth each
 *   B           A, flat
 *   C           the sphere of 100 triangles: mostly filling
 *   teapot, knot   the scenes of these names in examples/scenes, at the size they are designed for
 *   room, point-light   of these names there too: directional and point lights, triangles across the near plane; a
 *               point light so close that its direction turns within a triangle
 *   shadows-sun   of this name there too: what shadows are dear for, many small triangles that all cast
 *   A-60x60     A at a quarter of its size: the same triangles on a sixteenth of the pixels
 *   A-1x1       A on one pixel: hardly a triangle is left to set up
 *   A-96x64, C-96x64   A and C on a small panel, in bands of 8 rows: what an AVR with 16 KB of RAM can hold; of its
 *               128 KB of flash A's mesh takes the 12 KB that the program needs, so there it is C alone
 */
#include "tools/cost/cases.h"

#include <examples/scenes/parts.h>

#include "tools/cost/shadings.h"

#define OWN_LIGHTS NULL, 0
#define EIGHT_LIGHTS eight, LENGTH_OF(eight)

#ifndef __AVR__
/* All in front of the sphere, so that each lights most of what is seen: four 29 degrees off the view direction, four
 * 66 degrees off it. */
static const glint_light eight[] = {
    {.kind = GLINT_DIRECTIONAL, .direction = {4, 4, -10}, .colour = COLOUR(125, 125, 125)},
    {.kind = GLINT_DIRECTIONAL, .direction = {4, -4, -10}, .colour = COLOUR(125, 125, 125)},
    {.kind = GLINT_DIRECTIONAL, .direction = {-4, 4, -10}, .colour = COLOUR(125, 125, 125)},
    {.kind = GLINT_DIRECTIONAL, .direction = {-4, -4, -10}, .colour = COLOUR(125, 125, 125)},
    {.kind = GLINT_DIRECTIONAL, .direction = {9, 0, -4}, .colour = COLOUR(125, 125, 125)},
    {.kind = GLINT_DIRECTIONAL, .direction = {-9, 0, -4}, .colour = COLOUR(125, 125, 125)},
    {.kind = GLINT_DIRECTIONAL, .direction = {0, 9, -4}, .colour = COLOUR(125, 125, 125)},
    {.kind = GLINT_DIRECTIONAL, .direction = {0, -9, -4}, .colour = COLOUR(125, 125, 125)},
};
#endif

/* clang-format off */
const cost_case cost_cases[] = {
#ifndef __AVR__
    {"A", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 0, EXACT},
    {"A", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 0, GOURAUD},
    {"A", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 0, Q1},
    {"A", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 0, Q2},
    {"A", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 0, WITHIN(0.75)},
    {"A", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 0, WITHIN(1)},
    {"A", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 0, WITHIN(2)},
    {"A", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 0, WITHIN(4)},
    {"A", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 0, WITHIN(8)},
    {"A-60x60", &demo_sphere_32x16, OWN_LIGHTS, 60, 60, 0, EXACT},
    {"A-60x60", &demo_sphere_32x16, OWN_LIGHTS, 60, 60, 0, WITHIN(1)},
    {"A-1x1", &demo_sphere_32x16, OWN_LIGHTS, 1, 1, 0, EXACT},
    {"A-1x1", &demo_sphere_32x16, OWN_LIGHTS, 1, 1, 0, WITHIN(1)},
    {"A-bands16", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 16, EXACT},
    {"A-bands16", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 16, GOURAUD},
    {"A-bands16", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 16, WITHIN(1)},
    {"A-8-lights", &demo_sphere_32x16, EIGHT_LIGHTS, 240, 240, 0, EXACT},
    {"A-8-lights", &demo_sphere_32x16, EIGHT_LIGHTS, 240, 240, 0, GOURAUD},
    {"A-8-lights", &demo_sphere_32x16, EIGHT_LIGHTS, 240, 240, 0, WITHIN(1)},
    {"B", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 0, FLAT},
    {"B", &demo_sphere_32x16, OWN_LIGHTS, 240, 240, 0, WITHIN(1)},
    {"C", &demo_sphere_10x6, OWN_LIGHTS, 240, 240, 0, EXACT},
    {"C", &demo_sphere_10x6, OWN_LIGHTS, 240, 240, 0, GOURAUD},
    {"C", &demo_sphere_10x6, OWN_LIGHTS, 240, 240, 0, FLAT},
    {"C", &demo_sphere_10x6, OWN_LIGHTS, 240, 240, 0, WITHIN(1)},
    {"teapot", &demo_teapot, OWN_LIGHTS, 320, 240, 0, EXACT},
    {"teapot", &demo_teapot, OWN_LIGHTS, 320, 240, 0, GOURAUD},
    {"teapot", &demo_teapot, OWN_LIGHTS, 320, 240, 0, FLAT},
    {"teapot", &demo_teapot, OWN_LIGHTS, 320, 240, 0, WITHIN(1)},
    {"knot", &demo_torus_knot, OWN_LIGHTS, 240, 240, 0, EXACT},
    {"knot", &demo_torus_knot, OWN_LIGHTS, 240, 240, 0, GOURAUD},
    {"knot", &demo_torus_knot, OWN_LIGHTS, 240, 240, 0, FLAT},
    {"knot", &demo_torus_knot, OWN_LIGHTS, 240, 240, 0, WITHIN(1)},
    {"room", &demo_room, OWN_LIGHTS, 320, 240, 0, EXACT},
    {"room", &demo_room, OWN_LIGHTS, 320, 240, 0, GOURAUD},
    {"room", &demo_room, OWN_LIGHTS, 320, 240, 0, WITHIN(1)},
    {"point-light", &demo_point_light, OWN_LIGHTS, 320, 240, 0, EXACT},
    {"point-light", &demo_point_light, OWN_LIGHTS, 320, 240, 0, GOURAUD},
    {"point-light", &demo_point_light, OWN_LIGHTS, 320, 240, 0, WITHIN(1)},
    {"shadows-sun", &demo_shadows_sun, OWN_LIGHTS, 320, 240, 0, WITHIN(1)},
    {"A-96x64", &demo_sphere_32x16, OWN_LIGHTS, 96, 64, 8, EXACT},
    {"A-96x64", &demo_sphere_32x16, OWN_LIGHTS, 96, 64, 8, GOURAUD},
    {"A-96x64", &demo_sphere_32x16, OWN_LIGHTS, 96, 64, 8, FLAT},
    {"A-96x64", &demo_sphere_32x16, OWN_LIGHTS, 96, 64, 8, WITHIN(1)},
#endif
    {"C-96x64", &demo_sphere_10x6, OWN_LIGHTS, 96, 64, 8, EXACT},
    {"C-96x64", &demo_sphere_10x6, OWN_LIGHTS, 96, 64, 8, GOURAUD},
    {"C-96x64", &demo_sphere_10x6, OWN_LIGHTS, 96, 64, 8, FLAT},
    {"C-96x64", &demo_sphere_10x6, OWN_LIGHTS, 96, 64, 8, WITHIN(1)},
};
/* clang-format on */

const uint16_t cost_case_count = LENGTH_OF(cost_cases);
