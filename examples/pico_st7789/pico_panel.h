/* SPDX-License-Identifier: MIT */
/*
 * The wires to the panel: SPI0 in mode 3, with pixels fed to it by DMA channel 0. README.md has the pins.
 *
 * Mode 3, because the SPI block then sends one byte behind the other; in mode 0 it rests between
 * them. Panels without a select line want mode 3 as well.
 */
#ifndef EXAMPLES_PICO_ST7789_PICO_PANEL_H
#define EXAMPLES_PICO_ST7789_PICO_PANEL_H

#include <stdbool.h>
#include <stdint.h>

#include "examples/panels/panel_port.h"

/* The DMA could not read the pixels or write to SPI0. The transfer has ended, the band is not whole. */
enum { PICO_PANEL_ERROR_DMA = 10 };

/* For the panel's driver. Its calls wait for a transfer under way, and return PICO_PANEL_ERROR_DMA if one has failed.
 */
extern const panel_port pico_panel_port;

/* Pins, SPI0 at `spi_hz` or the next speed below, at most 62.5 MHz, and DMA. Returns 0 or CLOCKS_ERROR_RESET. */
int pico_panel_begin(uint32_t spi_hz);

/* Another speed, between transfers. */
void pico_panel_set_speed(uint32_t spi_hz);

/* Starts to send pixels, behind the command that takes them, as soon as the transfer before has ended, and returns.
 * They stay as they are until done(context) is called, from an interrupt; `done` may be NULL. Returns 0, or
 * PICO_PANEL_ERROR_DMA once after a transfer has failed; nothing is started then. */
int pico_panel_send(const void *pixels, uint32_t bytes, void (*done)(void *context), void *context);

/* Sleeps until the transfer under way has ended, if there is one. */
void pico_panel_wait(void);

void pico_panel_backlight(bool on);

/* For the vector table. */
void pico_panel_interrupt(void);

#endif
