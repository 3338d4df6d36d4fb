/* SPDX-License-Identifier: MIT */
/*
 * The fixed backend without the parts that a processor of little flash has no room for beside a test program: it takes
 * the place of the library's own. SMALL_PARTS from the command line says which it has.
 */
#ifndef SMALL_PARTS /* not in the self-test */
#define SMALL_PARTS (GLINT_PARTS_ALL & ~(GLINT_PART_TIERS | GLINT_PART_SKY | GLINT_PART_SIDES | PARTS_AFTER_SHADING))
#endif
#define GLINT_PARTS SMALL_PARTS
#define BACKEND_NAME(name) glint_fixed_##name

#include "backend/fixed.inc"
