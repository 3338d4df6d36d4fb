/* SPDX-License-Identifier: MIT */
/*
 * Plans change no pixel of the fixed backend, see test_pruning.h.
 */
#include "tests/image/full_plan.h"

/* the copy of the backend beside the library's own */
#define glint_fixed_render full_render
#define glint_fixed_memory_bytes full_memory_bytes
#define glint_fixed_memory_least_bytes full_memory_least_bytes
#include "backend/fixed.c"
#undef glint_fixed_render
#undef glint_fixed_memory_bytes
#undef glint_fixed_memory_least_bytes

#define PRUNING_RENDER glint_fixed_render
#define PRUNING_FULL full_render
#include "tests/image/test_pruning.h"
