/* SPDX-License-Identifier: MIT */
/*
 * Driver of the SSD1306 OLED controller: mono, 128 columns of pages of 8 rows (GLINT_MONO_PAGES), sent into a window of
 * its memory of 8 pages.
 *
 * Source: Solomon Systech SSD1306 data sheet, revision 1.1, and its application note on the charge pump. It knows
 * nothing of the board: see panel_port.h; arguments of commands are sent as commands, too. Every call returns 0, or the
 * port's error, after which the panel is to be begun again; ssd1306_window() also SSD1306_ERROR_WINDOW.
 *
 *     ssd1306_begin(&panel);                    dark
 *     ssd1306_window(&panel, 0, 0, 128, 64);    then its pixels with port->send_data()
 *     ssd1306_show(&panel);                     the first picture is there: light
 */
#ifndef EXAMPLES_PANELS_SSD1306_H
#define EXAMPLES_PANELS_SSD1306_H

#include <stdbool.h>
#include <stdint.h>

#include "examples/panels/panel_port.h"

#define SSD1306_WIDTH_PX 128
#define SSD1306_MEMORY_HEIGHT_PX 64

/* From ssd1306_window(): not within the memory, or not on whole pages. A board's errors are to be other numbers. */
#define SSD1306_ERROR_WINDOW 1306

typedef struct ssd1306 {
    const panel_port *port;
    uint8_t height_px;    /* rows of the glass: 64 (0 means 64), or 32 as on small modules */
    bool external_supply; /* the module feeds the glass itself; otherwise the controller's charge pump does */
    bool turned;          /* upside down, for a panel mounted so */
} ssd1306;

/* Resets the controller if the board can, and sets it up; the display stays off. */
int ssd1306_begin(const ssd1306 *panel);

/* Opens the window that the next data fill, page by page, again from its start when it is full; y and height are whole
 * pages of 8 rows. */
int ssd1306_window(const ssd1306 *panel, uint8_t x_px, uint8_t y_px, uint8_t width_px, uint8_t height_px);

/* Turns the display on, with what its memory holds. */
int ssd1306_show(const ssd1306 *panel);

/* Turns the display off: a sleep of a few microamperes. */
int ssd1306_end(const ssd1306 *panel);

#endif
