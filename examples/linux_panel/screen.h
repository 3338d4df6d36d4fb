/* SPDX-License-Identifier: MIT */
/*
 * The panel on this board: a controller's driver (examples/panels) over an SPI device and GPIO lines.
 */
#ifndef EXAMPLES_LINUX_PANEL_SCREEN_H
#define EXAMPLES_LINUX_PANEL_SCREEN_H

#include <stdbool.h>
#include <stdint.h>

#include "examples/panels/ili9341.h"
#include "examples/panels/st7789.h"

#include "failure.h"
#include "gpio.h"
#include "spi.h"

typedef struct screen_controller screen_controller;

typedef struct screen {
    const screen_controller *controller;
    spi_device *spi;
    gpio_line *dc, *reset, *backlight; /* reset and backlight: NULL where there is none */
    panel_port port;
    union {
        st7789 st7789;
        ili9341 ili9341;
    } driver;
    failure *failure; /* of the call under way */
} screen;

/* How the glass lies: its size and first pixel as mounted without rotation, quarter turns clockwise. It
 * lies within the controller's memory of 240x320. */
typedef struct screen_glass {
    uint16_t width_px, height_px, x_px, y_px;
    uint8_t quarter_turns;
} screen_glass;

/* "st7789", "ili9341"; NULL if there is none of this name. */
const screen_controller *screen_controller_named(const char *name);
uint32_t screen_default_speed_hz(const screen_controller *controller);

/* Fills in *out; the lines and the device are to stay as they are, out->backlight low. */
void screen_connect(screen *out, const screen_controller *controller, const screen_glass *glass);

/* The calls below return 0, or -1 and why. */

/* Resets and wakes the controller; it stays dark. */
int screen_begin(screen *s, failure *f);

/*
 * Asks whether the controller is awake, which takes its SDO wired to MISO. Fails if there is no answer, or if it says
 * that it sleeps.
 */
int screen_ask(screen *s, failure *f);

/* Sends rows y_px .. y_px + height_px - 1 of the picture, each `width_px` long. */
int screen_send(screen *s, const uint8_t *pixels, uint32_t bytes, uint16_t y_px, uint16_t width_px, uint16_t height_px,
                failure *f);

/* Lights up, with what has been sent. */
int screen_show(screen *s, failure *f);

/* Blanks: backlight off, display off, controller asleep. Tries all of it whatever fails. */
int screen_blank(screen *s, failure *f);

#endif
