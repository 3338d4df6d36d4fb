/* SPDX-License-Identifier: MIT */
#ifndef EXAMPLES_LINUX_PANEL_CLOCK_H
#define EXAMPLES_LINUX_PANEL_CLOCK_H

#include <stdint.h>
#include <time.h>

/* Nanoseconds that never go back, of no known origin. */
static inline uint64_t clock_ns(void)
{
    struct timespec now;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
}

#endif
