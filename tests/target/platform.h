/* SPDX-License-Identifier: MIT */
/*
 * What the self-test needs of a target: lines of text out, a counter, the stack's depth, an end. One platform_*.c file
 * each: Cortex-M by semihosting, RISC-V and AVR by UART, systems with stdio.
 */
#ifndef TESTS_TARGET_PLATFORM_H
#define TESTS_TARGET_PLATFORM_H

#include <stdint.h>

/* Makes ready the output and the counter. Call first. */
void platform_begin(void);

/* Writes text, which carries its own line ends. */
void platform_write(const char *text);

/* Ends the emulation; does not return where there is nothing to return to. */
void platform_end(void);

/*
 * A counter modulo 2^32 that steps with what the emulator counts. Its steps may be of any size: platform_known_loop()
 * says how many of its units they are. To be read at least once every 2^24 steps.
 */
uint32_t platform_count(void);

/* Takes exactly the returned number of instructions (cycles on the AVR), but for reading the counter around it. */
uint32_t platform_known_loop(void);

/* "instructions" or "cycles"; NULL: nothing is counted here. */
extern const char *const platform_count_unit;

/* Calls to count together so that the counter's step does not show. */
extern const uint16_t platform_count_repeat;

/* What `return true;` takes as a whole function, in the counter's unit. */
extern const uint8_t platform_empty_cost;

/* Fills the free stack with a pattern; tells how many bytes from its top have been written to since. 0: not known. */
void platform_stack_paint(void);
uint32_t platform_stack_used(void);

#endif
