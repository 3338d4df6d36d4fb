/* SPDX-License-Identifier: MIT */
/*
 * Makes of a backend's source an observing copy, which tells observe.c what it evaluates and how it draws each pixel.
 * The compiler reads this before src/backend/fixed.c or float.c (the Makefile names it with -include), and the names
 * that other files see are changed, so that a program can hold the library's own backends and these.
 */
#ifndef EXAMPLES_RENDER_OBSERVED_BACKEND_H
#define EXAMPLES_RENDER_OBSERVED_BACKEND_H

#include "observe.h"

/* The library's hooks; see src/number/integer.h. */
#define GLINT_OBSERVE(shade, promise_value)                                                                            \
    (observe_triangle(&(observed_triangle){                                                                            \
         .object = (shade)->object->number,                                                                            \
         .tier = (shade)->tier,                                                                                        \
         .promise_q8 = (uint16_t)(promise_value),                                                                      \
         .run = (shade)->run,                                                                                          \
         .report = (shade)->report,                                                                                    \
         .lights = (const char *)(const void *)(shade)->object->lit.lights,                                            \
         .crossing = (shade)->lights.crossing,                                                                         \
         .crossing_count =                                                                                             \
             (shade)->tier == GLINT_TIER_CURVED || (shade)->tier == GLINT_TIER_Q1 || (shade)->tier == GLINT_TIER_Q2    \
                 ? (shade)->lights.crossing_count                                                                      \
                 : 0,                                                                                                  \
         .texture = IS_TEXTURED(shade) ? (shade)->object->textured : NULL,                                             \
         .sky = (shade)->object->lit.has_sky && !(shade)->hidden && (shade)->tier == GLINT_TIER_EXACT,                 \
         .fog = (shade)->affected && (shade)->effects.fog != NULL,                                                     \
         .hidden = (shade)->hidden,                                                                                    \
         .layer = (shade)->affected && (shade)->effects.through != NULL,                                               \
         .wire = (shade)->affected && (shade)->effects.wire != NULL,                                                   \
     }),                                                                                                               \
     (shade)->run = observe_run)

#define GLINT_COUNT(event, ...) observed_##event(__VA_ARGS__)
#define observed_object(number) observe_object(number)
#define observed_light(state, number) observe_light((state), sizeof *(state), (number))
#define observed_copy(to, from) observe_light((to), sizeof *(to), observe_number(from))
#define observed_diffuse(state, times) observe_term((state), OBSERVED_DIFFUSE, (times))
#define observed_specular(state, times) observe_term((state), OBSERVED_SPECULAR, (times))
#define observed_gaps(state, gap_q28, count) observe_gaps((state), (gap_q28), (count))
#define observed_folded(state) observe_measured((state), OBSERVED_FOLDED)
#define observed_culled(state) observe_measured((state), OBSERVED_CULLED)
#define observed_set_up(shade)                                                                                         \
    observe_set_up((shade)->tier, (shade)->tier != GLINT_TIER_EXACT || (shade)->precise != PRECISE_NOT)
#define observed_shadow(state, tests) observe_shadow((state), (tests))
#define observed_mirror(times) observe_mirror(times)

#define glint_fixed_render observed_fixed_render
#define glint_fixed_memory_bytes observed_fixed_memory_bytes
#define glint_fixed_memory_least_bytes observed_fixed_memory_least_bytes
#define glint_float_render observed_float_render
#define glint_float_memory_bytes observed_float_memory_bytes
#define glint_float_memory_least_bytes observed_float_memory_least_bytes

#endif
