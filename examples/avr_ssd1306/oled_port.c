/* SPDX-License-Identifier: MIT */
/*
 * See oled_port.h. ATmega1284P data sheet: 22 (2-wire serial interface), table 22-3 (status codes). SSD1306 data sheet:
 * 8.1.5 (I2C: address, control byte).
 */
#include "examples/avr_ssd1306/oled_port.h"

#include <avr/io.h>
#include <util/delay_basic.h>

#include "examples/avr_ssd1306/board.h"

#define RESET PB2

#define ADDRESS_WRITE 0x78 /* SA0 low; the few modules with SA0 high have 0x7A */
#define CONTROL_COMMANDS 0x00
#define CONTROL_DATA 0x40

/* SCL = 16 MHz / (16 + 2 TWBR) with prescaler 1 */
#define TWBR_400_KHZ ((BOARD_CLOCK_HZ / 400000 - 16) / 2)

enum status {
    STATUS_MASK = 0xF8,
    START_SENT = 0x08,
    REPEATED_START_SENT = 0x10,
    ADDRESS_ACKNOWLEDGED = 0x18,
    DATA_ACKNOWLEDGED = 0x28
};

/* A byte takes 360 cycles; a turn of the loop at least 8. The panel never stretches the clock. */
#define TURNS 1000

void oled_port_begin(void)
{
    DDRB |= 1 << RESET;
    PORTC |= 1 << PC0 | 1 << PC1; /* weak pull-ups beside the module's own */
    TWBR = TWBR_400_KHZ;
    TWSR = 0;
}

/* Lets the interface do its next step. */
static int step(uint8_t control)
{
    TWCR = (uint8_t)(1 << TWINT | 1 << TWEN | control);
    for (uint16_t turns = 0; !(TWCR & 1 << TWINT); turns++) {
        if (turns == TURNS) {
            return OLED_ERROR_BUS;
        }
    }
    return 0;
}

/* A byte that the panel has to acknowledge. simavr 1.6 has the code of data for the address, too. */
static int put(uint8_t byte, int error_otherwise)
{
    TWDR = byte;
    const int error = step(0);
    const uint8_t status = TWSR & STATUS_MASK;
    return error || status == ADDRESS_ACKNOWLEDGED || status == DATA_ACKNOWLEDGED ? error : error_otherwise;
}

static int start(void)
{
    const int error = step(1 << TWSTA);
    const uint8_t status = TWSR & STATUS_MASK;
    return error || status == START_SENT || status == REPEATED_START_SENT ? error : OLED_ERROR_BUS;
}

/* The interface clears TWSTO when the stop is on the bus. */
static int stop(void)
{
    TWCR = 1 << TWINT | 1 << TWEN | 1 << TWSTO;
    for (uint16_t turns = 0; TWCR & 1 << TWSTO; turns++) {
        if (turns == TURNS) {
            return OLED_ERROR_BUS;
        }
    }
    return 0;
}

static int send(uint8_t control, const uint8_t *bytes, uint32_t count)
{
    int error = start();
    error = error ? error : put(ADDRESS_WRITE, OLED_ERROR_ABSENT);
    error = error ? error : put(control, OLED_ERROR_REFUSED);
    for (uint32_t i = 0; i < count && error == 0; i++) {
        error = put(bytes[i], OLED_ERROR_REFUSED);
    }
    const int stop_error = stop();
    return error ? error : stop_error;
}

static int send_command(void *context, const uint8_t *bytes, uint32_t count)
{
    (void)context;
    return send(CONTROL_COMMANDS, bytes, count);
}

static int send_data(void *context, const uint8_t *bytes, uint32_t count)
{
    (void)context;
    return send(CONTROL_DATA, bytes, count);
}

static int set_reset(void *context, bool high)
{
    (void)context;
    PORTB = (uint8_t)(high ? PORTB | 1 << RESET : PORTB & ~(1 << RESET));
    return 0;
}

static int delay_us(void *context, uint32_t us)
{
    (void)context;
    for (; us > 0; us--) {
        _delay_loop_2(BOARD_CLOCK_HZ / 1000000 / 4); /* four cycles a turn */
    }
    return 0;
}

const panel_port oled_port = {
    .send_command = send_command, .send_data = send_data, .set_reset = set_reset, .delay_us = delay_us};
