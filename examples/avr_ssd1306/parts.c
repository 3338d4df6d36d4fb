/* SPDX-License-Identifier: MIT */
/*
 * The parts of the library that this firmware links: its picture asks for highlights; the other two are quicker.
 */
#define GLINT_PARTS (GLINT_PART_SPECULAR | GLINT_PART_SPANS | GLINT_PART_LISTS)
#include <glint/fixed_parts.h>
