/* SPDX-License-Identifier: MIT */
/*
 * A choice of parts of a user's own: the file of two lines that <glint/parts.h> asks for.
 */
#define GLINT_PARTS (GLINT_PART_SPECULAR | GLINT_PART_FOG)
#include <glint/fixed_parts.h>
