/* SPDX-License-Identifier: MIT */
/*
 * Painting the stack: everything from its end to a little below the caller's frame. Included by the platforms without
 * an operating system, whose stack grows down towards `bottom`. Limit: bytes that a function reserves and does not
 * write at the very end of the stack go unseen.
 */
#ifndef TESTS_TARGET_STACK_PAINT_H
#define TESTS_TARGET_STACK_PAINT_H

#include <stdint.h>

#define STACK_PAINT 0xa5
#define STACK_MARGIN 64 /* of this function's own frame */

static inline void stack_paint(volatile uint8_t *bottom)
{
    const uintptr_t end = (uintptr_t)__builtin_frame_address(0) - STACK_MARGIN;
    for (volatile uint8_t *p = bottom; (uintptr_t)p < end; p++) {
        *p = STACK_PAINT;
    }
}

static inline uint32_t stack_used(const volatile uint8_t *bottom, const volatile uint8_t *top)
{
    const volatile uint8_t *p = bottom;
    while (p < top && *p == STACK_PAINT) {
        p++;
    }
    return (uint32_t)(top - p);
}

#endif
