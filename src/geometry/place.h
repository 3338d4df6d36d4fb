/* SPDX-License-Identifier: MIT */
#ifndef GLINT_GEOMETRY_PLACE_H
#define GLINT_GEOMETRY_PLACE_H

#include <glint/place.h>

/* The linear part of a place, with the all-zero default read as the identity. */
void glint_linear_of(const glint_place *place, int32_t linear_q16[3][3]);

#endif
