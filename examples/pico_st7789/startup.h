/* SPDX-License-Identifier: MIT */
/*
 * What the program takes of the chip.
 */
#ifndef EXAMPLES_PICO_ST7789_STARTUP_H
#define EXAMPLES_PICO_ST7789_STARTUP_H

#include <stdint.h>

/* The deepest that the stack has been since the reset. Words that a function reserves and never writes go unseen. */
uint32_t stack_used_bytes(void);

/* Of the flash, the second stage included; of the RAM, all that is kept for the stack included. */
uint32_t flash_used_bytes(void);
uint32_t ram_used_bytes(void);

/* Lights the board's LED and stays there: faults, and what main() can't go on from. May be called at any time. */
__attribute__((noreturn)) void stop(void);

#endif
