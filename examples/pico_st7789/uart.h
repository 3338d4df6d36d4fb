/* SPDX-License-Identifier: MIT */
/*
 * Text to the UART, 115200 baud, 8 bits, no parity, 1 stop bit, on GP0. It takes its time only when more than the 32
 * bytes of the transmit FIFO wait.
 */
#ifndef EXAMPLES_PICO_ST7789_UART_H
#define EXAMPLES_PICO_ST7789_UART_H

#include <stdint.h>

int uart_begin(void); /* returns 0 or CLOCKS_ERROR_RESET */

void uart_text(const char *text);

/* "name value", and the end of the line. */
void uart_value(const char *name, uint32_t value);

#endif
