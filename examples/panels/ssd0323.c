/* SPDX-License-Identifier: MIT */
/*
 * See ssd0323.h. Commands are named as in the data sheet.
 */
#include "examples/panels/ssd0323.h"

#include <stddef.h>

enum command {
    SET_COLUMN_ADDRESS = 0x15, /* first and last, in bytes */
    SET_ROW_ADDRESS = 0x75,    /* first and last */
    SET_CONTRAST_CURRENT = 0x81,
    SET_CURRENT_RANGE_HALF = 0x85,
    SET_RE_MAP = 0xA0,
    SET_DISPLAY_START_LINE = 0xA1,
    SET_DISPLAY_OFFSET = 0xA2,
    SET_NORMAL_DISPLAY = 0xA4,
    SET_MULTIPLEX_RATIO = 0xA8, /* rows less 1 */
    SET_DC_DC_CONVERTER = 0xAD,
    SET_DISPLAY_OFF = 0xAE,
    SET_DISPLAY_ON = 0xAF,
    SET_PHASE_LENGTH = 0xB1,
    SET_ROW_PERIOD = 0xB2,
    SET_CLOCK_DIVIDE = 0xB3,
    SET_GRAY_SCALE_TABLE = 0xB8, /* eight bytes */
    SET_PRECHARGE_VOLTAGE = 0xBC,
    SET_VCOMH = 0xBE,
    SET_SEGMENT_LOW_VOLTAGE = 0xBF
};

enum re_map {
    COLUMN_ADDRESS_RE_MAP = 1 << 0,
    NIBBLE_RE_MAP = 1 << 1, /* the high half of a byte is the left pixel */
    COM_RE_MAP = 1 << 4,
    COM_SPLIT = 1 << 6 /* even rows of the glass on one side of the chip, odd ones on the other */
};

/* Reset is low for 3 us at least, and commands are taken 3 us after it. */
#define RESET_US UINT32_C(10)

/* Contrast, timing and voltages as the makers of 128x64 glasses ask for: what is seen does not depend on them. */
static const uint8_t set_up[] = {SET_CONTRAST_CURRENT,
                                 0x40,
                                 SET_CURRENT_RANGE_HALF,
                                 SET_DISPLAY_START_LINE,
                                 0,
                                 SET_NORMAL_DISPLAY,
                                 SET_PHASE_LENGTH,
                                 0x22,
                                 SET_ROW_PERIOD,
                                 0x46,
                                 SET_CLOCK_DIVIDE,
                                 0xF1,
                                 SET_SEGMENT_LOW_VOLTAGE,
                                 0x0D,
                                 SET_VCOMH,
                                 0x02,
                                 SET_PRECHARGE_VOLTAGE,
                                 0x10,
                                 SET_GRAY_SCALE_TABLE,
                                 0x01,
                                 0x11,
                                 0x22,
                                 0x32,
                                 0x43,
                                 0x54,
                                 0x65,
                                 0x76,
                                 SET_DC_DC_CONVERTER,
                                 0x03};

static int commands(const ssd0323 *panel, const uint8_t *bytes, uint32_t count)
{
    return panel->port->send_command(panel->port->context, bytes, count);
}

static int reset(const panel_port *port)
{
    if (port->set_reset == NULL) {
        return 0;
    }
    int error = port->set_reset(port->context, false);
    error = error ? error : port->delay_us(port->context, RESET_US);
    error = error ? error : port->set_reset(port->context, true);
    return error ? error : port->delay_us(port->context, RESET_US);
}

int ssd0323_begin(const ssd0323 *panel)
{
    const uint8_t height = panel->height_px ? panel->height_px : 64;
    const uint8_t upright = COM_SPLIT | NIBBLE_RE_MAP | COM_RE_MAP;
    const uint8_t wiring[] = {SET_DISPLAY_OFF,
                              SET_RE_MAP,
                              (uint8_t)(panel->turned ? upright ^ (COM_RE_MAP | COLUMN_ADDRESS_RE_MAP) : upright),
                              SET_DISPLAY_OFFSET,
                              panel->display_offset,
                              SET_MULTIPLEX_RATIO,
                              (uint8_t)(height - 1)};
    int error = reset(panel->port);
    error = error ? error : commands(panel, wiring, sizeof wiring);
    return error ? error : commands(panel, set_up, sizeof set_up);
}

int ssd0323_window(const ssd0323 *panel, uint8_t x_px, uint8_t y_px, uint8_t width_px, uint8_t height_px)
{
    const uint16_t x_end = (uint16_t)(x_px + width_px), y_end = (uint16_t)(y_px + height_px);
    if (width_px == 0 || height_px == 0 || x_px % 2 != 0 || width_px % 2 != 0 || x_end > SSD0323_WIDTH_PX ||
        y_end > SSD0323_MEMORY_HEIGHT_PX) {
        return SSD0323_ERROR_WINDOW;
    }
    const uint8_t window[] = {SET_COLUMN_ADDRESS,  (uint8_t)(x_px / 2), (uint8_t)(x_end / 2 - 1), SET_ROW_ADDRESS, y_px,
                              (uint8_t)(y_end - 1)};
    return commands(panel, window, sizeof window);
}

int ssd0323_show(const ssd0323 *panel)
{
    const uint8_t on = SET_DISPLAY_ON;
    return commands(panel, &on, 1);
}

int ssd0323_end(const ssd0323 *panel)
{
    const uint8_t off = SET_DISPLAY_OFF;
    return commands(panel, &off, 1);
}
