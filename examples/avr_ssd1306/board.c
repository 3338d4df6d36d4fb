/* SPDX-License-Identifier: MIT */
/*
 * See board.h. ATmega1284P data sheet: 14 (ports), 20 (USART). avr-libc brings the start-up code.
 */
#include "examples/avr_ssd1306/board.h"

#include <avr/io.h>

#include "examples/firmware/decimal.h"
#include "tests/target/stack_paint.h"

/* 38400 baud at 16 MHz: 16e6 / (16 x 26), off by 0.2 % */
#define UBRR_38400 25

#define BUTTON PD2 /* to ground */

/* From the linker: the first byte after .bss. */
extern uint8_t __heap_start;

void board_begin(void)
{
    stack_paint(&__heap_start);
    DDRB |= 1 << MARK_DRAWING | 1 << MARK_SENDING;
    PORTD |= 1 << BUTTON; /* pulled up */
    UBRR0 = UBRR_38400;
    UCSR0C = 1 << UCSZ01 | 1 << UCSZ00;
    UCSR0B = 1 << TXEN0;
}

void board_mark(uint8_t marks)
{
    PORTB = (uint8_t)((PORTB & ~(1 << MARK_DRAWING | 1 << MARK_SENDING)) | marks);
}

void board_wait_for_press(void)
{
    while (!(PIND & 1 << BUTTON)) {
    }
    while (PIND & 1 << BUTTON) {
    }
}

void board_text(const char *text)
{
    for (; *text; text++) {
        while (!(UCSR0A & 1 << UDRE0)) {
        }
        UDR0 = (uint8_t)*text;
    }
}

void board_value(const char *name, uint32_t value)
{
    char digits[DECIMAL_CHARS];
    board_text(name);
    board_text(" ");
    board_text(decimal(value, digits));
    board_text("\r\n");
}

uint16_t board_stack_used(void)
{
    return (uint16_t)stack_used(&__heap_start, (const volatile uint8_t *)RAMEND + 1);
}

uint16_t board_stack_size(void)
{
    return (uint16_t)(RAMEND + 1 - (uintptr_t)&__heap_start);
}
