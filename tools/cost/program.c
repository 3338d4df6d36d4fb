/* SPDX-License-Identifier: MIT */
/*
 * What differs between the programs of a target, from the command line: how much memory the frames may take, and which
 * backends are counted (a bit for each).
 */
#include "tools/cost/cases.h"

#ifndef PROGRAM_MEMORY_BYTES
#define PROGRAM_MEMORY_BYTES 1048576
#endif
#ifndef PROGRAM_BACKENDS
#ifdef __AVR__
#define PROGRAM_BACKENDS (1 << COST_FIXED) /* both do not fit its 128 KB: see frames.c */
#else
#define PROGRAM_BACKENDS (1 << COST_FIXED | 1 << COST_FLOAT)
#endif
#endif

/* The AVR's uint32_t needs no alignment; the library asks for 4 bytes everywhere. */
__attribute__((aligned(4))) uint32_t cost_memory[PROGRAM_MEMORY_BYTES / sizeof(uint32_t)];
const size_t cost_memory_bytes = sizeof cost_memory;
const uint8_t cost_backends = PROGRAM_BACKENDS;
