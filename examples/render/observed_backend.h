/* SPDX-License-Identifier: MIT */
/*
 * Makes of a backend's source an observing copy, which tells observe.c how it draws each pixel. The compiler reads this
 * before src/backend/fixed.c or float.c (the Makefile names it with -include), and the names that other files see are
 * changed, so that a program can hold the library's own backends and these.
 */
#ifndef EXAMPLES_RENDER_OBSERVED_BACKEND_H
#define EXAMPLES_RENDER_OBSERVED_BACKEND_H

#include "observe.h"

/* The library's hook; see src/number/integer.h. */
#define GLINT_OBSERVE(shade, promise)                                                                                  \
    (observe_triangle((shade)->tier, (uint16_t)(promise), (shade)->run), (shade)->run = observe_run)

#define glint_fixed_render observed_fixed_render
#define glint_fixed_memory_bytes observed_fixed_memory_bytes
#define glint_fixed_memory_least_bytes observed_fixed_memory_least_bytes
#define glint_float_render observed_float_render
#define glint_float_memory_bytes observed_float_memory_bytes
#define glint_float_memory_least_bytes observed_float_memory_least_bytes

#endif
