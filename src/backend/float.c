/* SPDX-License-Identifier: MIT */
/*
 * The float backend with all its parts.
 */
#define GLINT_PARTS GLINT_PARTS_ALL
#define BACKEND_NAME(name) glint_float_##name

#include "backend/float.inc"
