/* SPDX-License-Identifier: MIT */
/*
 * The float backend with the parts of tests/target/small_fixed.c, SMALL_PARTS from the command line, for the program
 * that counts it on a processor whose flash does not hold both: it takes the place of the library's own.
 */
#include "backend/parts.h"

#ifndef SMALL_PARTS
#define SMALL_PARTS GLINT_PARTS_ALL
#endif
#undef GLINT_PARTS
#define GLINT_PARTS SMALL_PARTS
#define BACKEND_NAME(name) glint_float_##name

#include "backend/float.inc"
