/* SPDX-License-Identifier: MIT */
/*
 * See uart.h. RP2040 data sheet: 4.2.
 */
#include "examples/pico_st7789/uart.h"

#include "examples/firmware/decimal.h"
#include "examples/pico_st7789/clocks.h"
#include "examples/pico_st7789/rp2040.h"

#define UART_TX_PIN 0u
#define BAUD UINT32_C(115200)

/* clk_peri / (16 x baud) in 1/64: 67 52/64, within 0.01 % */
#define DIVISOR_64 ((CLK_PERI_HZ * 8 / BAUD + 1) / 2)

int uart_begin(void)
{
    const int error = clocks_release(RESETS_UART0 | RESETS_IO_BANK0 | RESETS_PADS_BANK0);
    if (error) {
        return error;
    }
    UART0_UARTIBRD = DIVISOR_64 / 64;
    UART0_UARTFBRD = DIVISOR_64 % 64;
    UART0_UARTLCR_H = UARTLCR_H_WLEN_8 | UARTLCR_H_FEN; /* takes the divisor over, too */
    UART0_UARTCR = UARTCR_UARTEN | UARTCR_TXE;
    GPIO_CTRL(UART_TX_PIN) = GPIO_CTRL_FUNCSEL_UART;
    return 0;
}

static void put(char byte)
{
    while (UART0_UARTFR & UARTFR_TXFF) {
    }
    UART0_UARTDR = (uint8_t)byte;
}

void uart_text(const char *text)
{
    while (*text) {
        put(*text++);
    }
}

void uart_value(const char *name, uint32_t value)
{
    char text[DECIMAL_CHARS];
    uart_text(name);
    put(' ');
    uart_text(decimal(value, text));
    uart_text("\r\n");
}
