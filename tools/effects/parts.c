/* SPDX-License-Identifier: MIT */
/*
 * A backend with GLINT_PARTS from the command line, as EFFECT_IN_FLOAT is: what <glint/parts.h> tells a user to write.
 */
#if EFFECT_IN_FLOAT
#include <glint/float_parts.h>
#else
#include <glint/fixed_parts.h>
#endif
