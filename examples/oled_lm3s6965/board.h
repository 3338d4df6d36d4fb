/* SPDX-License-Identifier: MIT */
/*
 * The EK-LM3S6965 board but for its panel: clock, counter, UART, select button. Nothing here waits for ever but the
 * UART for its own bytes to leave.
 */
#ifndef EXAMPLES_OLED_LM3S6965_BOARD_H
#define EXAMPLES_OLED_LM3S6965_BOARD_H

#include <stdbool.h>
#include <stdint.h>

#define BOARD_CLOCK_HZ UINT32_C(50000000)

/* The board's errors, beside the library's, which are below 0. */
enum { BOARD_ERROR_PLL = 1, BOARD_ERROR_SSI = 2 };

/* The processor at 50 MHz from the 8 MHz crystal and the PLL, the counter and the UART running. */
int board_begin(void);

/* Clock cycles since board_begin(), modulo 2^32. Correct if it is called every 0.33 s, or delays are waited for. */
uint32_t board_cycles(void);

void board_delay_us(uint32_t us);

/* The select button, active low. */
bool board_button_pressed(void);

/* To the UART, 115200 baud, 8 bits: the board's USB serial port. */
void board_text(const char *text);
void board_value(const char *name, uint32_t value); /* "name value", a line */

#endif
