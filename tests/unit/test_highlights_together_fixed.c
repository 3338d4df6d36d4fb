/* SPDX-License-Identifier: MIT */
/*
 * What highlights of the fixed backend cost together, see test_highlights_together.h.
 */
#include "backend/fixed.c" /* it takes the place of the library's own copy */

#define UNIT_ONE 32768
#include "tests/unit/test_highlights_together.h"
