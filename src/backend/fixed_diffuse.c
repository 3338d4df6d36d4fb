/* SPDX-License-Identifier: MIT */
/*
 * The fixed backend with exact shading at each pixel, diffuse and ambient, under directional lights.
 */
#define GLINT_PARTS 0u
#define BACKEND_NAME(name) glint_fixed_diffuse_##name

#include "backend/fixed.inc"
