/* SPDX-License-Identifier: MIT */
/*
 * The panel model's ST7789 and ILI9341: the MIPI display command set with a memory of 240 x 320 pixels. From the data
 * sheets ST7789VW rev. 1.0 (9.1 system function commands, 8.4 serial interface, 7.4 timing) and ILI9341 V1.11 (8
 * commands, 7.1 serial interface, 18.3 timing); their tables of commands are in dcs_commands.c.
 *
 * Stricter than the sheets in one thing: a window that was opened for pixels and then left before it was full is told
 * of when the next is opened, since that is what a wrong pixel size looks like from here.
 */
#include <string.h>

#include "tests/panel/internal.h"

#define COLUMNS 240
#define ROWS 320

enum {
    SWRESET = 0x01,
    SLPIN = 0x10,
    SLPOUT = 0x11,
    INVOFF = 0x20,
    INVON = 0x21,
    DISPOFF = 0x28,
    DISPON = 0x29,
    CASET = 0x2a,
    RASET = 0x2b,
    RAMWR = 0x2c,
    VSCSAD = 0x37,
    MADCTL = 0x36,
    COLMOD = 0x3a,
    RAMWRC = 0x3c,
    RAMCTRL = 0xb0, /* ST7789: bit 3 of the second is the byte order */
    IFCTL = 0xf6    /* ILI9341: bit 5 of the third is the byte order */
};
enum { MADCTL_MY = 0x80, MADCTL_MX = 0x40, MADCTL_MV = 0x20, MADCTL_BGR = 0x08 };

#define SLEEP_CHANGE (120 * PANEL_MS)

static bool bit(uint8_t byte, uint8_t mask)
{
    return (byte & mask) != 0;
}

void dcs_reset(panel *p)
{
    dcs_state *d = &p->state.dcs;
    d->known = NULL;
    d->command = 0;
    d->madctl = 0;
    d->colmod = 0x66;
    d->x_first = d->y_first = 0;
    d->x_last = COLUMNS - 1;
    d->y_last = ROWS - 1;
    d->filled = d->window = 0;
    d->bit_count = 0;
    d->awake = d->on = d->inverted = false;
    d->sleep_changed_ns = p->now_ns > 0 ? p->now_ns + SLEEP_CHANGE : 0;
    d->sleep_why = "after reset";
}

/* Bits of a pixel, 0 if COLMOD has a value that the serial interface does not take. */
static uint8_t pixel_bits(const panel *p)
{
    switch (p->state.dcs.colmod & 7) {
    case 3:
        return p->kind == PANEL_ST7789 ? 12 : 0;
    case 5:
        return 16;
    case 6:
        return 24; /* 18 in three bytes, two low bits of each unused */
    default:
        return 0;
    }
}

/* What the host calls (x, y) is this place of the memory (ST7789 8.12, ILI9341 9.3): MV swaps, MX and MY mirror. */
static void place(const dcs_state *d, uint16_t x, uint16_t y, uint16_t *column, uint16_t *row)
{
    const bool swap = bit(d->madctl, MADCTL_MV);
    *column = swap ? y : x;
    *row = swap ? x : y;
    if (bit(d->madctl, MADCTL_MX)) {
        *column = (uint16_t)(COLUMNS - 1 - *column);
    }
    if (bit(d->madctl, MADCTL_MY)) {
        *row = (uint16_t)(ROWS - 1 - *row);
    }
}

/* The corner of the glass that the host calls its last column and row. */
static bool is_last_of_glass(const panel *p, uint16_t column, uint16_t row)
{
    const dcs_state *d = &p->state.dcs;
    const uint16_t last_column = (uint16_t)(p->glass.x_px + (bit(d->madctl, MADCTL_MX) ? 0 : p->width_px - 1));
    const uint16_t last_row = (uint16_t)(p->glass.y_px + (bit(d->madctl, MADCTL_MY) ? 0 : p->height_px - 1));
    return column == last_column && row == last_row;
}

static uint8_t eight_bits(uint32_t value, uint32_t most)
{
    return (uint8_t)(((value & most) * 255 + most / 2) / most);
}

static void put_pixel(panel *p, uint32_t pixel, uint8_t bits)
{
    dcs_state *d = &p->state.dcs;
    const uint32_t width = (uint32_t)(d->x_last - d->x_first) + 1;
    if (d->filled == d->window) {
        if (!d->overrun) {
            panel_violate(p, "more pixels than the window of %lu holds", (unsigned long)d->window);
        }
        d->overrun = true;
        return;
    }
    uint16_t column = 0, row = 0;
    place(d, (uint16_t)(d->x_first + d->filled % width), (uint16_t)(d->y_first + d->filled / width), &column, &row);
    d->filled++;
    if (column >= COLUMNS || row >= ROWS) { /* MADCTL changed since CASET and RASET */
        if (!d->overrun) {
            panel_violate(p, "pixel at column %u, row %u, outside of the memory", column, row);
        }
        d->overrun = true;
        return;
    }
    uint8_t *rgb = d->memory[row][column];
    if (bits == 16) {
        rgb[0] = eight_bits(pixel >> 11, 31);
        rgb[1] = eight_bits(pixel >> 5, 63);
        rgb[2] = eight_bits(pixel, 31);
    } else {
        const uint8_t width_of_one = bits == 12 ? 4 : 8;
        for (int i = 0; i < 3; i++) {
            const uint32_t value = pixel >> (2 - i) * width_of_one;
            rgb[i] = bits == 12 ? eight_bits(value, 15) : eight_bits(value >> 2, 63);
        }
    }
    p->frames += is_last_of_glass(p, column, row);
}

static void pixel_byte(panel *p, uint8_t byte)
{
    dcs_state *d = &p->state.dcs;
    const uint8_t bits = pixel_bits(p);
    if (bits == 0) {
        return; /* told of at COLMOD */
    }
    d->bits = d->bits << 8 | byte;
    d->bit_count = (uint8_t)(d->bit_count + 8);
    while (d->bit_count >= bits) {
        d->bit_count = (uint8_t)(d->bit_count - bits);
        put_pixel(p, d->bits >> d->bit_count & ((UINT32_C(1) << bits) - 1), bits);
    }
}

/* What a command is worth once its arguments are there. */
static void set_window(panel *p, uint16_t *first, uint16_t *last, uint16_t most)
{
    const uint8_t *a = p->state.dcs.argument;
    *first = (uint16_t)(a[0] << 8 | a[1]);
    *last = (uint16_t)(a[2] << 8 | a[3]);
    if (*first > *last) {
        panel_violate(p, "window reversed: %u to %u", *first, *last);
        *last = *first;
    }
    if (*last > most) {
        panel_violate(p, "window from %u to %u, but the last is %u", *first, *last, most);
        *last = most;
        *first = *first > most ? most : *first;
    }
}

static void take_arguments(panel *p)
{
    dcs_state *d = &p->state.dcs;
    const uint8_t *a = d->argument;
    const bool swap = bit(d->madctl, MADCTL_MV);
    switch (d->command) {
    case CASET:
        set_window(p, &d->x_first, &d->x_last, swap ? ROWS - 1 : COLUMNS - 1);
        break;
    case RASET:
        set_window(p, &d->y_first, &d->y_last, swap ? COLUMNS - 1 : ROWS - 1);
        break;
    case MADCTL:
        d->madctl = a[0];
        break;
    case COLMOD:
        d->colmod = a[0];
        if (pixel_bits(p) == 0) {
            panel_violate(p, "COLMOD %02x: no pixel size of the serial interface", a[0]);
        }
        break;
    case VSCSAD:
        if (a[0] != 0 || a[1] != 0) {
            panel_violate(p, "scrolling: not modelled");
        }
        break;
    case RAMCTRL:
        if (p->kind == PANEL_ST7789 && (bit(a[0], 0x10) || bit(a[1], 0x08))) {
            panel_violate(p, "RAMCTRL %02x %02x: RGB interface or low byte first, not modelled", a[0], a[1]);
        }
        break;
    case IFCTL:
        if (p->kind == PANEL_ILI9341 && bit(a[2], 0x20)) {
            panel_violate(p, "IFCTL: low byte first, not modelled");
        }
        break;
    default:
        break;
    }
}

static bool writes_pixels(const dcs_state *d)
{
    return d->known && (d->command == RAMWR || d->command == RAMWRC);
}

bool dcs_reading(const panel *p)
{
    const panel_command *known = p->state.dcs.known;
    return known && known->arguments_most == 255 && !writes_pixels(&p->state.dcs);
}

/* The command before is over when the next comes. */
static void end_command(panel *p)
{
    dcs_state *d = &p->state.dcs;
    if (writes_pixels(d)) {
        if (d->bit_count >= 8) { /* half a byte is left over by an odd number of 12-bit pixels */
            panel_violate(p, "the write ends within a pixel of %u bits", pixel_bits(p));
        }
        d->bit_count = 0;
    } else if (d->known && d->argument_count < d->known->arguments_least) {
        panel_violate(p, "%s ends after %lu of %u arguments", panel_name(d->known), (unsigned long)d->argument_count,
                      d->known->arguments_least);
    }
}

static void sleep_change(panel *p, bool awake, const char *why)
{
    dcs_state *d = &p->state.dcs;
    if (d->awake == awake) {
        return; /* has no effect */
    }
    d->awake = awake;
    d->sleep_changed_ns = p->now_ns + SLEEP_CHANGE;
    d->sleep_why = why;
    p->ready_ns = p->now_ns + 5 * PANEL_MS;
    p->ready_why = why;
}

static void begin_command(panel *p, uint8_t code)
{
    dcs_state *d = &p->state.dcs;
    d->command = code;
    d->argument_count = 0;
    d->known = panel_find(p->kind == PANEL_ST7789 ? panel_commands_st7789 : panel_commands_ili9341, code);
    if (d->known == NULL) {
        panel_violate(p, "unknown command %02x", code);
        return;
    }
    if (d->known->name[0] == '?') {
        panel_violate(p, "%s: not modelled", panel_name(d->known));
    }
    if ((code == SWRESET || code == SLPIN || code == SLPOUT) && p->now_ns < d->sleep_changed_ns) {
        panel_violate(p, "%s %.3f ms too early %s", panel_name(d->known),
                      (double)(d->sleep_changed_ns - p->now_ns) / 1e6, d->sleep_why);
    }
    if ((code == CASET || code == RASET || code == RAMWR) && d->filled != 0 && d->filled != d->window) {
        panel_violate(p, "the window before was left after %lu of %lu pixels: is COLMOD right?",
                      (unsigned long)d->filled, (unsigned long)d->window);
        d->filled = d->window;
    }
    switch (code) {
    case SWRESET:
        dcs_reset(p);
        d->sleep_changed_ns = p->now_ns + SLEEP_CHANGE;
        p->ready_ns = p->now_ns + 5 * PANEL_MS;
        p->ready_why = d->sleep_why = "after the software reset";
        break;
    case SLPIN:
        sleep_change(p, false, "after SLPIN");
        break;
    case SLPOUT:
        sleep_change(p, true, "after SLPOUT");
        break;
    case INVOFF:
    case INVON:
        d->inverted = code == INVON;
        break;
    case DISPOFF:
    case DISPON:
        d->on = code == DISPON;
        break;
    case RAMWR:
        d->filled = 0;
        d->window = ((uint32_t)(d->x_last - d->x_first) + 1) * ((uint32_t)(d->y_last - d->y_first) + 1);
        d->overrun = false;
        break;
    default:
        break;
    }
}

void dcs_byte(panel *p, bool dc, uint8_t byte)
{
    dcs_state *d = &p->state.dcs;
    if (!dc) {
        end_command(p);
        begin_command(p, byte);
        return;
    }
    if (writes_pixels(d)) {
        pixel_byte(p, byte);
        return;
    }
    if (d->known == NULL) {
        if (d->argument_count++ == 0 && d->command == 0) {
            panel_violate(p, "data %02x before any command", byte);
        }
        return;
    }
    if (d->known->arguments_most == 255) {
        return; /* what is clocked out while the controller answers */
    }
    if (d->argument_count == d->known->arguments_most) {
        panel_violate(p, "%s takes %u arguments, here is another: %02x", panel_name(d->known), d->known->arguments_most,
                      byte);
        return;
    }
    if (d->argument_count < sizeof d->argument) { /* the rest are tables of colours */
        d->argument[d->argument_count] = byte;
    }
    d->argument_count++;
    if (d->argument_count == d->known->arguments_least) {
        take_arguments(p);
    }
}

void dcs_end(panel *p)
{
    end_command(p);
}

void dcs_picture(const panel *p, uint8_t *rgb)
{
    const dcs_state *d = &p->state.dcs;
    if (!d->awake || !d->on) {
        return;
    }
    const uint8_t flip = d->inverted != p->glass.inverted ? 0xff : 0;
    const bool swap = bit(d->madctl, MADCTL_BGR) != p->glass.bgr;
    for (unsigned y = 0; y < p->height_px; y++) {
        for (unsigned x = 0; x < p->width_px; x++, rgb += 3) {
            const unsigned row = y + p->glass.y_px, column = x + p->glass.x_px;
            if (row >= ROWS || column >= COLUMNS) {
                continue; /* the glass hangs over the memory: stays black */
            }
            const uint8_t *from = d->memory[row][column];
            rgb[0] = from[swap ? 2 : 0] ^ flip;
            rgb[1] = from[1] ^ flip;
            rgb[2] = from[swap ? 0 : 2] ^ flip;
        }
    }
}
