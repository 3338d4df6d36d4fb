/* SPDX-License-Identifier: MIT */
/*
 * See ssd1306.h. Commands are named as in the data sheet.
 */
#include "examples/panels/ssd1306.h"

#include <stddef.h>

enum command {
    SET_MEMORY_ADDRESSING_MODE = 0x20, /* 0: horizontal */
    SET_COLUMN_ADDRESS = 0x21,         /* first and last */
    SET_PAGE_ADDRESS = 0x22,           /* first and last */
    SET_DISPLAY_START_LINE_0 = 0x40,
    SET_CONTRAST = 0x81,
    CHARGE_PUMP_SETTING = 0x8D, /* 0x14: on */
    SET_SEGMENT_RE_MAP = 0xA0,  /* | 1: reversed */
    ENTIRE_DISPLAY_RESUME = 0xA4,
    SET_NORMAL_DISPLAY = 0xA6,
    SET_MULTIPLEX_RATIO = 0xA8, /* rows less 1 */
    SET_DISPLAY_OFF = 0xAE,
    SET_DISPLAY_ON = 0xAF,
    SET_COM_SCAN_DIRECTION = 0xC0, /* | 8: reversed */
    SET_DISPLAY_OFFSET = 0xD3,
    SET_CLOCK_DIVIDE = 0xD5,
    SET_PRECHARGE_PERIOD = 0xD9,
    SET_COM_PINS = 0xDA, /* 0x12: rows of the glass in turn on both sides of the chip; 0x02: one after the other */
    SET_VCOMH_LEVEL = 0xDB,
    NOP = 0xE3
};

/* Reset is low for 3 us at least, and commands are taken 3 us after it. */
#define RESET_US UINT32_C(10)

static int commands(const ssd1306 *panel, const uint8_t *bytes, uint32_t count)
{
    return panel->port->send_command(panel->port->context, bytes, count);
}

static int reset(const panel_port *port)
{
    if (port->set_reset == NULL) {
        return 0;
    }
    int error = port->set_reset(port->context, true); /* from wherever it was: the edge down is what counts */
    error = error ? error : port->set_reset(port->context, false);
    error = error ? error : port->delay_us(port->context, RESET_US);
    error = error ? error : port->set_reset(port->context, true);
    return error ? error : port->delay_us(port->context, RESET_US);
}

int ssd1306_begin(const ssd1306 *panel)
{
    const uint8_t height = panel->height_px ? panel->height_px : 64;
    const uint8_t reversed = panel->turned ? 0 : 1; /* nearly all modules have the chip below the glass */
    /* The NOP is for simavr, whose model takes the byte behind the start line for an argument. */
    const uint8_t set_up[] = {SET_DISPLAY_OFF,
                              SET_CLOCK_DIVIDE,
                              0x80,
                              SET_MULTIPLEX_RATIO,
                              (uint8_t)(height - 1),
                              SET_DISPLAY_OFFSET,
                              0,
                              SET_DISPLAY_START_LINE_0,
                              NOP,
                              CHARGE_PUMP_SETTING,
                              (uint8_t)(panel->external_supply ? 0x10 : 0x14),
                              SET_MEMORY_ADDRESSING_MODE,
                              0,
                              (uint8_t)(SET_SEGMENT_RE_MAP | reversed),
                              (uint8_t)(SET_COM_SCAN_DIRECTION | reversed << 3),
                              SET_COM_PINS,
                              (uint8_t)(height > 32 ? 0x12 : 0x02),
                              SET_CONTRAST,
                              (uint8_t)(panel->external_supply ? 0x9F : 0xCF),
                              SET_PRECHARGE_PERIOD,
                              (uint8_t)(panel->external_supply ? 0x22 : 0xF1),
                              SET_VCOMH_LEVEL,
                              0x20,
                              ENTIRE_DISPLAY_RESUME,
                              SET_NORMAL_DISPLAY};
    const int error = reset(panel->port);
    return error ? error : commands(panel, set_up, sizeof set_up);
}

int ssd1306_window(const ssd1306 *panel, uint8_t x_px, uint8_t y_px, uint8_t width_px, uint8_t height_px)
{
    const uint16_t x_end = (uint16_t)(x_px + width_px), y_end = (uint16_t)(y_px + height_px);
    if (width_px == 0 || height_px == 0 || y_px % 8 != 0 || height_px % 8 != 0 || x_end > SSD1306_WIDTH_PX ||
        y_end > SSD1306_MEMORY_HEIGHT_PX) {
        return SSD1306_ERROR_WINDOW;
    }
    const uint8_t window[] = {SET_COLUMN_ADDRESS,   x_px,
                              (uint8_t)(x_end - 1), SET_PAGE_ADDRESS,
                              (uint8_t)(y_px / 8),  (uint8_t)(y_end / 8 - 1)};
    return commands(panel, window, sizeof window);
}

int ssd1306_show(const ssd1306 *panel)
{
    const uint8_t on = SET_DISPLAY_ON;
    return commands(panel, &on, 1);
}

int ssd1306_end(const ssd1306 *panel)
{
    const uint8_t off = SET_DISPLAY_OFF;
    return commands(panel, &off, 1);
}
