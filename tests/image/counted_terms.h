/* SPDX-License-Identifier: MIT */
/*
 * Counts, by object, how often a backend finds n.s and r.c of lights: to be included before its source. See GLINT_COUNT
 * in src/number/integer.h.
 */
#ifndef GLINT_TESTS_IMAGE_COUNTED_TERMS_H
#define GLINT_TESTS_IMAGE_COUNTED_TERMS_H

#include <stdint.h>

#define COUNTED_OBJECTS 64

static struct {
    uint32_t diffuse, specular;
} counted[COUNTED_OBJECTS];
static uint16_t counted_object;

static inline uint32_t counted_gaps(const uint32_t *gap_q28, uint16_t count)
{
    uint32_t found = 0;
    for (uint16_t i = 0; i < count; i++) {
        found += gap_q28[i] != UINT32_MAX;
    }
    return found;
}

#define GLINT_COUNT(event, ...) count_##event(__VA_ARGS__)
#define count_object(number) (counted_object = (number))
#define count_light(light, number) ((void)0)
#define count_copy(to, from) ((void)0)
#define count_diffuse(light, times) (counted[counted_object].diffuse += (times))
#define count_specular(light, times) (counted[counted_object].specular += (times))
#define count_gaps(light, gap_q28, count) (counted[counted_object].specular += counted_gaps(gap_q28, count))
#define count_folded(light) ((void)0)
#define count_culled(light) ((void)0)
#define count_set_up(shade) ((void)0)
#define count_shadow(light, tests) ((void)0)
#define count_mirror(times) ((void)0)

#endif
