/* SPDX-License-Identifier: MIT */
/*
 * AVR ATmega1284P: UART 0 for text, timer 1 at the processor's clock as the counter, its overflows counted by an
 * interrupt. Sleep with interrupts off ends the emulation. avr-libc brings the start-up code.
 */
#include "tests/target/platform.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

#include "tests/target/stack_paint.h"

/* From the linker: the first byte after .bss. */
extern uint8_t __heap_start;

const char *const platform_count_unit = "cycles";
const uint16_t platform_count_repeat = 1;
const uint8_t platform_empty_cost = 5; /* ldi, ret */

static volatile uint16_t overflows;

ISR(TIMER1_OVF_vect)
{
    overflows++;
}

void platform_begin(void)
{
    UBRR0 = 0; /* as fast as it goes: eight cycles a bit */
    UCSR0A = 1 << U2X0;
    UCSR0B = 1 << TXEN0;
    TCCR1A = 0;
    TCCR1B = 1 << CS10;
    TIMSK1 = 1 << TOIE1;
    sei();
}

void platform_write(const char *text)
{
    while (*text) {
        while (!(UCSR0A & 1 << UDRE0)) {
        }
        UDR0 = (uint8_t)*text++;
    }
}

void platform_end(void)
{
    while (!(UCSR0A & 1 << UDRE0)) {
    }
    cli();
    sleep_mode();
}

uint32_t platform_count(void)
{
    cli();
    const uint16_t low = TCNT1;
    uint16_t high = overflows;
    if (TIFR1 & 1 << TOV1 && low < 0x8000) {
        high++; /* the interrupt is still to come */
    }
    sei();
    return (uint32_t)high << 16 | low;
}

/* sbiw takes 2 cycles, brne 2 when taken and 1 at the end. 15000 rounds stay within one overflow of the timer. */
uint32_t platform_known_loop(void)
{
    uint16_t rounds = 15000;
    __asm volatile("1: sbiw %0, 1\n\tbrne 1b" : "+w"(rounds));
    return 4 * UINT32_C(15000) - 1;
}

void platform_stack_paint(void)
{
    stack_paint(&__heap_start);
}

uint32_t platform_stack_used(void)
{
    return stack_used(&__heap_start, (const volatile uint8_t *)RAMEND + 1);
}
