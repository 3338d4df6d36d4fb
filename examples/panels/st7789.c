/* SPDX-License-Identifier: MIT */
/*
 * See st7789.h. Commands are named as in the data sheet.
 */
#include "examples/panels/st7789.h"

#include <stddef.h>

enum command {
    SWRESET = 0x01,
    SLPIN = 0x10,
    SLPOUT = 0x11,
    INVOFF = 0x20,
    INVON = 0x21,
    DISPOFF = 0x28,
    DISPON = 0x29,
    CASET = 0x2A,
    RASET = 0x2B,
    RAMWR = 0x2C,
    MADCTL = 0x36,
    COLMOD = 0x3A
};

enum {
    MADCTL_MY = 1 << 7,  /* rows of the memory from the last */
    MADCTL_MX = 1 << 6,  /* columns of the memory from the last */
    MADCTL_MV = 1 << 5,  /* addresses of columns count rows of the memory */
    MADCTL_BGR = 1 << 3, /* the glass's order of colours */
    COLMOD_65K_16BIT = 0x55
};

/* A reset pulse is at least 10 us. After a reset in sleep, commands are taken after 5 ms; the state before is not
 * known, and out of sleep it takes 120 ms. After SLPOUT commands are taken after 5 ms, but SLPIN only after 120 ms, as
 * SLPOUT after SLPIN: waiting at once spares its callers the clock. */
#define RESET_PULSE_US UINT32_C(20)
#define RESET_WAIT_US UINT32_C(120000)
#define SLEEP_WAIT_US UINT32_C(120000)

static int command(const st7789 *panel, uint8_t code, const uint8_t *arguments, uint32_t count)
{
    const panel_port *port = panel->port;
    const int error = port->send_command(port->context, &code, 1);
    return error || count == 0 ? error : port->send_data(port->context, arguments, count);
}

static int wait_us(const st7789 *panel, uint32_t us)
{
    return panel->port->delay_us(panel->port->context, us);
}

static int reset(const st7789 *panel)
{
    const panel_port *port = panel->port;
    int error;
    if (port->set_reset == NULL) {
        error = command(panel, SWRESET, NULL, 0);
    } else {
        error = port->set_reset(port->context, false);
        error = error ? error : wait_us(panel, RESET_PULSE_US);
        error = error ? error : port->set_reset(port->context, true);
    }
    return error ? error : wait_us(panel, RESET_WAIT_US);
}

static uint16_t glass_width(const st7789 *panel)
{
    return panel->width_px ? panel->width_px : ST7789_MEMORY_WIDTH_PX;
}

static uint16_t glass_height(const st7789 *panel)
{
    return panel->height_px ? panel->height_px : ST7789_MEMORY_HEIGHT_PX;
}

/* Which way the memory is written in each rotation. Mirroring is of the memory's own columns and rows, also with MV. */
static uint8_t memory_access(const st7789 *panel)
{
    static const uint8_t turned[] = {0, MADCTL_MV | MADCTL_MX, MADCTL_MX | MADCTL_MY, MADCTL_MV | MADCTL_MY};
    return (uint8_t)(turned[panel->rotation & 3u] | (panel->bgr ? MADCTL_BGR : 0));
}

int st7789_begin(const st7789 *panel)
{
    if (panel->x_px + (uint32_t)glass_width(panel) > ST7789_MEMORY_WIDTH_PX ||
        panel->y_px + (uint32_t)glass_height(panel) > ST7789_MEMORY_HEIGHT_PX) {
        return ST7789_ERROR_GLASS;
    }
    const uint8_t pixels = COLMOD_65K_16BIT;
    const uint8_t access = memory_access(panel);
    int error = reset(panel);
    error = error ? error : command(panel, SLPOUT, NULL, 0);
    error = error ? error : wait_us(panel, SLEEP_WAIT_US);
    error = error ? error : command(panel, COLMOD, &pixels, 1);
    error = error ? error : command(panel, MADCTL, &access, 1);
    return error ? error : command(panel, panel->not_inverted ? INVOFF : INVON, NULL, 0);
}

/* First and last address of a range, big-endian. */
static int address_range(const st7789 *panel, uint8_t code, uint16_t first, uint16_t count)
{
    const uint16_t last = (uint16_t)(first + count - 1);
    const uint8_t bytes[4] = {(uint8_t)(first >> 8), (uint8_t)first, (uint8_t)(last >> 8), (uint8_t)last};
    return command(panel, code, bytes, sizeof bytes);
}

int st7789_window(const st7789 *panel, uint16_t x_px, uint16_t y_px, uint16_t width_px, uint16_t height_px)
{
    const uint8_t access = memory_access(panel);
    /* where the glass begins when its memory is counted from the other side */
    const uint16_t columns =
        access & MADCTL_MX ? (uint16_t)(ST7789_MEMORY_WIDTH_PX - panel->x_px - glass_width(panel)) : panel->x_px;
    const uint16_t rows =
        access & MADCTL_MY ? (uint16_t)(ST7789_MEMORY_HEIGHT_PX - panel->y_px - glass_height(panel)) : panel->y_px;
    const bool quarter = (access & MADCTL_MV) != 0;
    int error = address_range(panel, CASET, (uint16_t)(x_px + (quarter ? rows : columns)), width_px);
    error = error ? error : address_range(panel, RASET, (uint16_t)(y_px + (quarter ? columns : rows)), height_px);
    return error ? error : command(panel, RAMWR, NULL, 0);
}

int st7789_show(const st7789 *panel)
{
    return command(panel, DISPON, NULL, 0);
}

int st7789_end(const st7789 *panel)
{
    int error = command(panel, DISPOFF, NULL, 0);
    error = error ? error : command(panel, SLPIN, NULL, 0);
    return error ? error : wait_us(panel, SLEEP_WAIT_US);
}
