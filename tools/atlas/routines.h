/* SPDX-License-Identifier: MIT */
/*
 * Ways to compute the four routines that shading and set-up stand on, the library's and others (variants.c). routines.c
 * counts them on a target, judge_routines.c says how far they are off.
 */
#ifndef TOOLS_ATLAS_ROUTINES_H
#define TOOLS_ATLAS_ROUTINES_H

#include <stdbool.h>
#include <stdint.h>

enum { ROUTINE_ROOT, ROUTINE_UNIT, ROUTINE_POWER, ROUTINE_SINE, ROUTINES };
extern const char *const routine_names[ROUTINES];

/* The exponent of the power: a power of two, so that squarings serve as well. */
enum { ROUTINE_EXPONENT = 32 };

/* The same numbers in fixed point and in float, each rounded to what it holds. */
typedef struct routine_input {
    uint32_t x_q30; /* root: 1/sqrt(x), 1 <= x < 4 */
    float x;
    int32_t v[3]; /* unit vector */
    float v_real[3];
    uint32_t gap_q31; /* power: (1 - gap)^32, 0 <= gap <= 0.3 */
    float gap;
    uint16_t angle_turn16; /* sine */
    float angle_radians;
} routine_input;

typedef union routine_result {
    int32_t fixed[3];
    float real[3];
} routine_result;

/* Always true: so that what is called has an empty counterpart, see platform_empty_cost. */
typedef bool (*routine_function)(const routine_input *in, routine_result *out);

typedef struct routine_variant {
    const char *name;   /* words with '-' between them */
    const char *origin; /* library; atlas: in variants.c alone; libm: of the target's C library */
    routine_function function;
    uint16_t table_bytes;
    uint8_t routine;
    int8_t fraction_bits; /* of `fixed`; negative: the result is `real` */
} routine_variant;

extern const routine_variant routine_variants[];
extern const uint8_t routine_variant_count;

/* Makes the tables of the atlas's own variants. Call first. */
void routine_begin(void);

/* The next of a series that is the same everywhere; *state begins as ROUTINE_SEED. */
#define ROUTINE_SEED UINT32_C(2463534242)
routine_input routine_next(uint32_t *state);

/* How many numbers a result has. */
static inline int routine_width(const routine_variant *variant)
{
    return variant->routine == ROUTINE_UNIT ? 3 : 1;
}

#endif
