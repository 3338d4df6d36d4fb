/* SPDX-License-Identifier: MIT */
/*
 * The checking build's GLINT_TRACE(name, value): notes the least and greatest value that a named quantity takes. Given
 * to the compiler by -include, so that the library's sources stay free of it; there the macro is empty unless defined.
 *
 * Values are noted as int64_t. A quantity that is traced before it is narrowed is the proof that narrowing loses
 * nothing.
 */
#ifndef GLINT_TESTS_FUZZ_TRACE_H
#define GLINT_TESTS_FUZZ_TRACE_H

#include <stdint.h>

typedef struct traced_range {
    const char *name;
    struct traced_range *next; /* itself in the list when set; the last one points to itself */
    int64_t least, greatest;
    uint64_t count;
} traced_range;

extern traced_range *traced_ranges;

static inline void trace_value(traced_range *range, int64_t value)
{
    if (range->count++ == 0) {
        range->next = traced_ranges ? traced_ranges : range;
        traced_ranges = range;
        range->least = range->greatest = value;
    }
    range->least = value < range->least ? value : range->least;
    range->greatest = value > range->greatest ? value : range->greatest;
}

#define GLINT_TRACE(quantity, value)                                                                                   \
    do {                                                                                                               \
        static traced_range traced = {quantity, 0, 0, 0, 0};                                                           \
        trace_value(&traced, (int64_t)(value));                                                                        \
    } while (0)

#endif
