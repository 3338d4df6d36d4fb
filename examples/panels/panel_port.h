/* SPDX-License-Identifier: MIT */
/*
 * What the driver of a panel's controller needs from the board: bytes sent as a command or as data, the reset line and
 * a delay. Drivers (ssd0323.c, ssd1306.c, st7789.c, ili9341.c) know the controller and nothing of the board; boards
 * know their registers or devices and nothing of the controller.
 *
 * Every call returns 0, or an error of the board's own that the driver returns at once and unchanged.
 */
#ifndef EXAMPLES_PANELS_PANEL_PORT_H
#define EXAMPLES_PANELS_PANEL_PORT_H

#include <stdbool.h>
#include <stdint.h>

typedef struct panel_port {
    /* Sends bytes with D/C low (over I2C: behind control byte 0x00). They have been taken when it returns. */
    int (*send_command)(void *context, const uint8_t *bytes, uint32_t count);
    /* Sends bytes with D/C high (over I2C: behind control byte 0x40): arguments of ST7789 and ILI9341 commands, and
     * pixels. They have been taken when it returns. */
    int (*send_data)(void *context, const uint8_t *bytes, uint32_t count);
    /* Sets the level of the reset line, which is active low. NULL where the board has none: a driver then uses the
     * controller's software reset if it has one. */
    int (*set_reset)(void *context, bool high);
    /* Waits at least so long. Everything sent before has left the board when the time begins. */
    int (*delay_us)(void *context, uint32_t us);
    void *context; /* handed to each of them */
} panel_port;

#endif
