/* SPDX-License-Identifier: MIT */
/*
 * Driver of the SSD0323 OLED controller: 16 greys, two pixels a byte with the left one high (GLINT_GREY4), sent into a
 * window of its memory of 128 x 80 pixels.
 *
 * Source: Solomon Systech SSD0323 data sheet, revision 2.1: command table in chapter 9. It knows nothing of the board:
 * see panel_port.h; arguments of commands are sent as commands, too. Every call returns 0, or the port's error, after
 * which the panel is to be begun again; ssd0323_window() also SSD0323_ERROR_WINDOW.
 *
 *     ssd0323_begin(&panel);                    dark
 *     ssd0323_window(&panel, 0, 0, 128, 64);    then its pixels with port->send_data()
 *     ssd0323_show(&panel);                     the first picture is there: light
 */
#ifndef EXAMPLES_PANELS_SSD0323_H
#define EXAMPLES_PANELS_SSD0323_H

#include <stdbool.h>
#include <stdint.h>

#include "examples/panels/panel_port.h"

#define SSD0323_WIDTH_PX 128
#define SSD0323_MEMORY_HEIGHT_PX 80

/* From ssd0323_window(): not within the memory, or not on whole bytes. A board's errors are to be other numbers. */
#define SSD0323_ERROR_WINDOW 323

typedef struct ssd0323 {
    const panel_port *port;
    uint8_t height_px;      /* rows of the glass: 16..80; 0: 64 */
    uint8_t display_offset; /* COM line that the glass's first row is wired to, as the module's maker says */
    bool turned;            /* upside down, for a panel mounted so */
} ssd0323;

/* Resets the controller if the board can, and sets it up; the display stays off. */
int ssd0323_begin(const ssd0323 *panel);

/* Opens the window that the next data fill, row by row, again from its start when it is full; x and width even. */
int ssd0323_window(const ssd0323 *panel, uint8_t x_px, uint8_t y_px, uint8_t width_px, uint8_t height_px);

/* Turns the display on, with what its memory holds. */
int ssd0323_show(const ssd0323 *panel);

/* Turns the display off. */
int ssd0323_end(const ssd0323 *panel);

#endif
