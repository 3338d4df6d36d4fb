/* SPDX-License-Identifier: MIT */
/*
 * The panel on the processor's two-wire interface: I2C at 400 kHz, the most that the SSD1306 takes, and a reset line.
 */
#ifndef EXAMPLES_AVR_SSD1306_OLED_PORT_H
#define EXAMPLES_AVR_SSD1306_OLED_PORT_H

#include "examples/panels/panel_port.h"

/* Nothing answers at the panel's address; the bus is held by another, or shorted; a byte was not acknowledged. */
enum { OLED_ERROR_ABSENT = 1, OLED_ERROR_BUS = 2, OLED_ERROR_REFUSED = 3 };

void oled_port_begin(void);

extern const panel_port oled_port;

#endif
