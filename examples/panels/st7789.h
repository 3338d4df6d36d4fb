/* SPDX-License-Identifier: MIT */
/*
 * Driver of the ST7789 panel controller: 16-bit pixels, high byte first (GLINT_RGB565_SWAPPED on a little-endian
 * processor, GLINT_RGB565 on a big-endian one), sent into a window of its memory of 240 x 320 pixels.
 *
 * Source: Sitronix ST7789V data sheet: its command table, and the timing of reset and sleep. It knows nothing of the
 * board: see panel_port.h. Every call returns 0, or the port's error, after which the panel is to be begun again;
 * st7789_begin() also ST7789_ERROR_GLASS.
 *
 *     st7789_begin(&panel);                     asleep until now, dark
 *     st7789_window(&panel, 0, 0, 240, 240);    then its pixels with port->send_data(), or by DMA
 *     st7789_show(&panel);                      the first picture is there: light
 */
#ifndef EXAMPLES_PANELS_ST7789_H
#define EXAMPLES_PANELS_ST7789_H

#include <stdbool.h>
#include <stdint.h>

#include "examples/panels/panel_port.h"

#define ST7789_MEMORY_WIDTH_PX 240
#define ST7789_MEMORY_HEIGHT_PX 320

/* From st7789_begin(): the glass reaches beyond the controller's memory. A board's errors are to be other numbers. */
#define ST7789_ERROR_GLASS (-7789)

/* How the picture lies on the glass, turned clockwise; with quarter turns its width is the glass's height. */
enum { ST7789_UPRIGHT = 0, ST7789_TURNED_90 = 1, ST7789_TURNED_180 = 2, ST7789_TURNED_270 = 3 };

typedef struct st7789 {
    const panel_port *port;
    uint16_t width_px, height_px; /* of the glass as mounted without rotation; 0: all of the controller's memory */
    uint16_t x_px, y_px;          /* of the glass's first pixel in that memory, as mounted without rotation */
    uint8_t rotation;             /* ST7789_UPRIGHT ... */
    bool bgr;                     /* the glass's colour filters come in the order blue, green, red */
    bool not_inverted;            /* a TN panel, bright without voltage; IPS panels are dark: they want INVON */
} st7789;

/* Resets and wakes the controller, sets format and orientation; the display stays off. Takes a quarter of a second. */
int st7789_begin(const st7789 *panel);

/* Opens the window of the picture's pixels that the next data fill, row by row, again from the start when full. */
int st7789_window(const st7789 *panel, uint16_t x_px, uint16_t y_px, uint16_t width_px, uint16_t height_px);

/* Turns the display on, with what its memory holds. */
int st7789_show(const st7789 *panel);

/* Turns the display off and puts the controller to sleep. */
int st7789_end(const st7789 *panel);

#endif
