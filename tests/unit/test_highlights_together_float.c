/* SPDX-License-Identifier: MIT */
/*
 * What highlights of the float backend cost together, see test_highlights_together.h.
 */
#include "backend/float.c" /* it takes the place of the library's own copy */

#define UNIT_ONE 1
#include "tests/unit/test_highlights_together.h"
