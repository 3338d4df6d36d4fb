/* SPDX-License-Identifier: MIT */
/*
 * Extended light sources: the point lights that stand for one, and how far their mean is from the integral over it.
 *
 * Their numbers N are those of the rules below. On a panel they lie on a square grid turned so that seen from any side
 * they hide each other as little as may be: point i of N at the coordinates (i, g i) modulo N with g^2 = -1 modulo N, a
 * lattice rule (I. H. Sloan and S. Joe, "Lattice methods for multiple integration", Oxford 1994), which maps to itself
 * when turned by a right angle. So along either edge all N have different coordinates, equally far apart. On a ball
 * they lie on a spiral of equal steps along an axis, turned by the golden angle each (R. Swinbank and R. J. Purser,
 * "Fibonacci grids", Quarterly Journal of the Royal Meteorological Society 132, 2006). All have the same weight.
 *
 * What limits them is the model's clamp: at the terminator max(0, n.s) has a kink, and the specular term is cut off,
 * so that rules of a high order have no advantage. Errors by a kink fall with N^-1.2, about.
 */
#ifndef GLINT_LIGHTING_SOURCE_H
#define GLINT_LIGHTING_SOURCE_H

#include <stdbool.h>

#include <glint/scene.h>

#define GLINT_SOURCE_RULES 5 /* of 1, 5, 13, 29 and 53 points */

/* Does it stand for more than one point light? */
bool glint_source_extends(const glint_light *light);

/* A panel's half diagonal, the longer one, or a ball's radius, rounded up; 0 for other lights. Below 2^32. */
uint32_t glint_source_size_q16(const glint_light *light);

/* How many rules the light's `samples` allow, and the points of a rule, 0 and up. */
uint8_t glint_source_rules(const glint_light *light);
uint8_t glint_source_points(uint8_t rule);

/* The most point lights that one light may come to: 1 if it is not extended. */
uint8_t glint_source_most(const glint_light *light);

/*
 * Point light `number` of the `count` that stand for a source: `light` itself for a count of 1 without extent, else it
 * is written to `point`. Its position is off by at most 2 units of Q16 and 2^-22 of the extent. Its colour is that of
 * the whole; glint_source_part() divides it.
 */
const glint_light *glint_source_point(const glint_light *light, uint8_t count, uint8_t number, glint_light *point);

/* Part `number` of `count` parts of a whole up to 2^25, which add up to it and differ by at most 1. */
static inline uint32_t glint_source_part(uint32_t whole, uint8_t count, uint8_t number)
{
    return count == 1 ? whole : whole * ((uint32_t)number + 1) / count - whole * number / count;
}

/*
 * Bounds of the difference between a rule and the integral, as a part (Q16) of what the term is at most. `size_q16` is
 * the source's size over the distance of its centre from the lit point, rounded up: of a panel half its longer
 * diagonal, of a ball its radius; from 1 (65536) on the bound is 1. `fades`: it is attenuated. Found by search
 * (tests/unit/test_source_bounds.c), a fifth added.
 *
 * The specular one holds but for the gate at n.s = 0, which adds glint_source_gate_q16 of the greatest specular factor
 * there. Exponents below 1 have none, that is 1.
 */
uint32_t glint_source_diffuse_q16(const glint_light *light, uint8_t rule, uint32_t size_q16, bool fades);
uint32_t glint_source_specular_q16(const glint_light *light, uint8_t rule, uint32_t size_q16, uint16_t exponent_q4,
                                   bool fades);
uint32_t glint_source_gate_q16(uint8_t rule);

#endif
