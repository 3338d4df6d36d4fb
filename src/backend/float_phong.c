/* SPDX-License-Identifier: MIT */
/*
 * The float backend with exact shading at each pixel alone.
 */
#define GLINT_PARTS (GLINT_PART_SPECULAR | GLINT_PART_POINTS)
#define BACKEND_NAME(name) glint_float_phong_##name

#include "backend/float.inc"
