/* SPDX-License-Identifier: MIT */
/*
 * Both backends behind one set of names, so that a test loops over them.
 */
#ifndef GLINT_TESTS_UNIT_BACKENDS_H
#define GLINT_TESTS_UNIT_BACKENDS_H

#include <stddef.h>
#include <stdint.h>

#include <glint/glint.h>

typedef struct renderer {
    const char *name;
    int (*render)(const glint_scene *, const glint_display *, const glint_quality *, void *, size_t, glint_report *);
    size_t (*memory_bytes)(const glint_scene *, const glint_display *);
    size_t (*memory_least_bytes)(const glint_scene *, const glint_display *);
} renderer;

enum { BACKENDS = 2 };

static const renderer backends[BACKENDS] = {
    {"fixed", glint_fixed_render, glint_fixed_memory_bytes, glint_fixed_memory_least_bytes},
    {"float", glint_float_render, glint_float_memory_bytes, glint_float_memory_least_bytes},
};

/* A number from 0 to 2^24 - 1: a linear congruential generator with the constants of D. E. Knuth's MMIX. */
static inline uint32_t random_u24(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(*state >> 40);
}

#endif
