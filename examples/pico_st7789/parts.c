/* SPDX-License-Identifier: MIT */
/*
 * The parts of the library that this firmware links: its picture asks for a tolerance and for highlights.
 */
#define GLINT_PARTS (GLINT_PART_SPECULAR | GLINT_PART_TIERS | GLINT_PART_SPANS | GLINT_PART_LISTS)
#include <glint/fixed_parts.h>
