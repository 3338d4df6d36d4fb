/* SPDX-License-Identifier: MIT */
/*
 * The fixed backend with all its parts.
 */
#define GLINT_PARTS GLINT_PARTS_ALL
#define BACKEND_NAME(name) glint_fixed_##name

#include "backend/fixed.inc"
