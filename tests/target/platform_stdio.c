/* SPDX-License-Identifier: MIT */
/*
 * Targets with an operating system: text by stdio. Nothing is counted: emulators of user programs do not tell.
 */
#include "tests/target/platform.h"

#include <stddef.h>
#include <stdio.h>

const char *const platform_count_unit = NULL;
const uint16_t platform_count_repeat = 1;
const uint8_t platform_empty_cost = 0;

void platform_begin(void)
{
}

void platform_write(const char *text)
{
    fputs(text, stdout);
}

void platform_end(void)
{
    fflush(stdout);
}

uint32_t platform_count(void)
{
    return 0;
}

uint32_t platform_known_loop(void)
{
    return 0;
}

void platform_stack_paint(void)
{
}

uint32_t platform_stack_used(void)
{
    return 0;
}
