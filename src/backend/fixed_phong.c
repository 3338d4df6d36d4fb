/* SPDX-License-Identifier: MIT */
/*
 * The fixed backend with exact shading at each pixel alone.
 */
#define BACKEND_PARTS (PART_SPECULAR | PART_POINTS)
#define BACKEND_NAME(name) glint_fixed_phong_##name

#include "backend/fixed.inc"
