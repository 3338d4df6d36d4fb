/* SPDX-License-Identifier: MIT */
/*
 * The checking build's GLINT_TRACE(quantity, value): notes the least and greatest value that a named quantity takes.
 * Given to the compiler by -include; in every other build number/integer.h makes the macro nothing.
 *
 * Values are noted as int64_t, so a quantity is traced before it is narrowed. Each place of the source that traces is
 * in a list that the linker gathers (the section glint_traced), so that one which is never reached is known too. ELF.
 */
#ifndef GLINT_TESTS_FUZZ_TRACE_H
#define GLINT_TESTS_FUZZ_TRACE_H

#include <stdint.h>

typedef struct traced_range {
    const char *quantity, *file;
    int line;
    int64_t least, greatest; /* least > greatest: never reached */
} traced_range;

static inline void trace_value(traced_range *range, int64_t value)
{
    range->least = value < range->least ? value : range->least;
    range->greatest = value > range->greatest ? value : range->greatest;
}

#define GLINT_TRACE(quantity, value)                                                                                   \
    do {                                                                                                               \
        static traced_range traced_here = {quantity, __FILE__, __LINE__, INT64_MAX, INT64_MIN};                        \
        static traced_range *traced_listed __attribute__((section("glint_traced"), used)) = &traced_here;              \
        trace_value(&traced_here, (int64_t)(value));                                                                   \
    } while (0)

#endif
