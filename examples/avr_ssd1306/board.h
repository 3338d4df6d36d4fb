/* SPDX-License-Identifier: MIT */
/*
 * The ATmega1284P and what hangs on it but the panel: a UART for text, two marks for a logic analyser, a button.
 */
#ifndef EXAMPLES_AVR_SSD1306_BOARD_H
#define EXAMPLES_AVR_SSD1306_BOARD_H

#include <stdint.h>

/* A crystal of 16 MHz. */
#define BOARD_CLOCK_HZ UINT32_C(16000000)

/* The marks: pins of port B that are high while the library draws, and while the panel is sent something. */
#define MARK_DRAWING 0
#define MARK_SENDING 1

void board_begin(void);

/* Sets the marks: bits 1 << MARK_..., the others low. */
void board_mark(uint8_t marks);

/* Waits until the button has been up, and then down. */
void board_wait_for_press(void);

/* To the UART, 38400 baud, 8 bits. */
void board_text(const char *text);
void board_value(const char *name, uint32_t value); /* "name value", a line */

/* Most of the stack that was used since board_begin(), and all that it has, in bytes. */
uint16_t board_stack_used(void);
uint16_t board_stack_size(void);

#endif
