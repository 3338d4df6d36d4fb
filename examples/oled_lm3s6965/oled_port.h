/* SPDX-License-Identifier: MIT */
/*
 * The board's way to its OLED: SSI 0, with D/C on a pin of its own.
 */
#ifndef EXAMPLES_OLED_LM3S6965_OLED_PORT_H
#define EXAMPLES_OLED_LM3S6965_OLED_PORT_H

#include "examples/panels/panel_port.h"

/* 50 MHz / 14: the SSD0323 takes 4 MHz at most. */
#define OLED_CLOCK_DIVIDE 14

void oled_port_begin(void);

extern const panel_port oled_port;

#endif
