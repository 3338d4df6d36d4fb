/* SPDX-License-Identifier: MIT */
/*
 * The float backend with exact shading at each pixel, diffuse and ambient, under directional lights.
 */
#define GLINT_PARTS 0u
#define BACKEND_NAME(name) glint_float_diffuse_##name

#include "backend/float.inc"
