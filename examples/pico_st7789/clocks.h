/* SPDX-License-Identifier: MIT */
/*
 * The clocks of a Raspberry Pi Pico, and time.
 */
#ifndef EXAMPLES_PICO_ST7789_CLOCKS_H
#define EXAMPLES_PICO_ST7789_CLOCKS_H

#include <stdint.h>

#define CLK_REF_HZ UINT32_C(12000000) /* the board's crystal */
#define CLK_SYS_HZ UINT32_C(125000000)
#define CLK_PERI_HZ CLK_SYS_HZ

/* Positive: the library's are negative. */
enum { CLOCKS_ERROR_CRYSTAL = 1, CLOCKS_ERROR_PLL = 2, CLOCKS_ERROR_SWITCH = 3, CLOCKS_ERROR_RESET = 4 };

/* From the ring oscillator that the chip starts with to the crystal and the PLL; then the timer runs. Returns 0, or an
 * error when one of them does not come up: the chip then still runs, at the clock it had. */
int clocks_begin(void);

/* Takes blocks (RESETS_...) out of reset. Returns 0 or CLOCKS_ERROR_RESET. */
int clocks_release(uint32_t blocks);

/* Microseconds since clocks_begin(); wraps after 71 minutes, so that only differences count. */
uint32_t time_us(void);

/* At least so long. */
void delay_us(uint32_t us);

#endif
