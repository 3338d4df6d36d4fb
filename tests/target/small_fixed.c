/* SPDX-License-Identifier: MIT */
/*
 * The fixed backend without the parts that a processor of little flash has no room for beside a test program: it takes
 * the place of the library's own. SMALL_PARTS from the command line says which it has.
 */
#ifndef SMALL_PARTS
#define SMALL_PARTS (PARTS_ALL & ~(PART_TIERS | PART_SKY | PART_SIDES | PART_FINISH)) /* not in the self-test */
#endif
#define BACKEND_PARTS SMALL_PARTS
#define BACKEND_NAME(name) glint_fixed_##name

#include "backend/fixed.inc"
