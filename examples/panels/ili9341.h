/* SPDX-License-Identifier: MIT */
/*
 * Driver of the ILI9341 panel controller: 16-bit pixels, high byte first (GLINT_RGB565_SWAPPED on a little-endian
 * processor, GLINT_RGB565 on a big-endian one), sent into a window of its memory of 240 x 320 pixels.
 *
 * Source: ILI Technology ILI9341 data sheet, version 1.11: commands in chapter 8, reset in 15.4. It knows nothing of
 * the board: see panel_port.h. Every call returns 0, or the port's error, after which the panel is to be begun again;
 * ili9341_begin() also ILI9341_ERROR_GLASS. They are called as those of st7789.h.
 */
#ifndef EXAMPLES_PANELS_ILI9341_H
#define EXAMPLES_PANELS_ILI9341_H

#include <stdbool.h>
#include <stdint.h>

#include "examples/panels/panel_port.h"
#include "examples/panels/st7789.h"

#define ILI9341_MEMORY_WIDTH_PX ST7789_MEMORY_WIDTH_PX
#define ILI9341_MEMORY_HEIGHT_PX ST7789_MEMORY_HEIGHT_PX
#define ILI9341_ERROR_GLASS ST7789_ERROR_GLASS

typedef struct ili9341 {
    const panel_port *port;
    uint16_t width_px, height_px; /* of the glass as mounted without rotation; 0: all of the controller's memory */
    uint16_t x_px, y_px;          /* of the glass's first pixel in that memory, as mounted without rotation */
    uint8_t rotation;             /* ST7789_UPRIGHT ... */
    bool rgb;                     /* the glass's colour filters come in the order red, green, blue; usual is BGR */
    bool inverted;                /* an IPS panel, dark without voltage; usual are TN panels */
} ili9341;

/* Resets and wakes the controller, sets format and orientation; the display stays off. Takes a quarter of a second. */
int ili9341_begin(const ili9341 *panel);

/* Opens the window of the picture's pixels that the next data fill, row by row, again from its start when it is full.
 */
int ili9341_window(const ili9341 *panel, uint16_t x_px, uint16_t y_px, uint16_t width_px, uint16_t height_px);

/* Turns the display on, with what its memory holds. */
int ili9341_show(const ili9341 *panel);

/* Turns the display off and puts the controller to sleep. */
int ili9341_end(const ili9341 *panel);

#endif
