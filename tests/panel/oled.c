/* SPDX-License-Identifier: MIT */
/*
 * The panel model's SSD0323 (128 x 80, 16 greys) and SSD1306 (128 x 64, mono), from Solomon Systech's data sheets
 * SSD0323 rev. 2.1 and SSD1306 rev. 1.1: command tables in chapter 9, AC characteristics in chapters 13 and 14.
 * Arguments of commands come with D/C low.
 *
 * What a row or column of the glass shows depends on how it is wired, so it is judged against a module that is upright
 * with certain settings (panel_glass): whatever differs from them turns or shifts the picture.
 *
 * Stricter than the sheets in one thing: an area that was addressed and then left before it was full is told of when
 * the next is addressed, since that is what a wrong count of bytes looks like from here.
 */
#include <stddef.h>
#include <string.h>

#include "tests/panel/internal.h"

#define COLUMNS 128

enum { SHOW_MEMORY, SHOW_ALL, SHOW_NONE };
enum { MODE_ROWS, MODE_COLUMNS, MODE_PAGE }; /* the SSD1306's order of addresses */

/* SSD0323, table 13: tcycle 250 ns, tCLKH and tCLKL 100 ns; SSD1306, table 13-4: 100 ns and 20 ns; both: reset low for
 * 3 us, and 3 us before what follows. */
const panel_limits panel_limits_ssd0323 = {250, 100, 100, 3 * PANEL_US, 3 * PANEL_US};
const panel_limits panel_limits_ssd1306 = {100, 20, 20, 3 * PANEL_US, 3 * PANEL_US};

/* clang-format off */
const panel_command panel_commands_ssd0323[] = {
    {0x15, 2, 2, "column address"}, {0x75, 2, 2, "row address"}, {0x81, 1, 1, "contrast"},
    {0x84, 0, 0, "quarter current"},
    {0x85, 0, 0, "half current"}, {0x86, 0, 0, "full current"}, {0xa0, 1, 1, "re-map"}, {0xa1, 1, 1, "start line"},
    {0xa2, 1, 1, "display offset"}, {0xa4, 0, 0, "normal display"}, {0xa5, 0, 0, "all on"}, {0xa6, 0, 0, "all off"},
    {0xa7, 0, 0, "inverse display"}, {0xa8, 1, 1, "multiplex ratio"}, {0xad, 1, 1, "DC-DC converter"},
    {0xae, 0, 0, "display off"}, {0xaf, 0, 0, "display on"}, {0xb0, 1, 1, "precharge compensation"},
    {0xb1, 1, 1, "phase length"}, {0xb2, 1, 1, "row period"}, {0xb3, 1, 1, "clock divide"},
    {0xb4, 1, 1, "precharge compensation level"}, {0xb8, 8, 8, "grey scale table"}, {0xbc, 1, 1, "precharge voltage"},
    {0xbe, 1, 1, "VCOMH"}, {0xbf, 1, 1, "segment low voltage"}, {0xe3, 0, 0, "NOP"},
    {0, 0, 0, NULL},
};

/* Those that carry their argument within (00, 10, 40, B0 and on) are taken apart by the code. */
const panel_command panel_commands_ssd1306[] = {
    {0x00, 0, 0, "column, low half"}, {0x10, 0, 0, "column, high half"}, {0x20, 1, 1, "addressing mode"},
    {0x21, 2, 2, "column address"}, {0x22, 2, 2, "page address"}, {0x26, 6, 6, "?scroll right"},
    {0x27, 6, 6, "?scroll left"}, {0x29, 5, 5, "?scroll up and right"}, {0x2a, 5, 5, "?scroll up and left"},
    {0x2e, 0, 0, "scroll off"}, {0x2f, 0, 0, "?scroll on"}, {0x40, 0, 0, "start line"}, {0x81, 1, 1, "contrast"},
    {0x8d, 1, 1, "charge pump"}, {0xa0, 0, 0, "segments as they are"}, {0xa1, 0, 0, "segments reversed"},
    {0xa3, 2, 2, "scroll area"}, {0xa4, 0, 0, "show memory"}, {0xa5, 0, 0, "all on"}, {0xa6, 0, 0, "normal display"},
    {0xa7, 0, 0, "inverse display"}, {0xa8, 1, 1, "multiplex ratio"}, {0xae, 0, 0, "display off"},
    {0xaf, 0, 0, "display on"}, {0xb0, 0, 0, "page"}, {0xc0, 0, 0, "COMs as they are"}, {0xc8, 0, 0, "COMs reversed"},
    {0xd3, 1, 1, "display offset"}, {0xd5, 1, 1, "clock divide"}, {0xd9, 1, 1, "precharge period"},
    {0xda, 1, 1, "COM pins"}, {0xdb, 1, 1, "VCOMH level"}, {0xe3, 0, 0, "NOP"},
    {0, 0, 0, NULL},
};
/* clang-format on */

static bool is_grey(const panel *p)
{
    return p->kind == PANEL_SSD0323;
}

static uint8_t rows_of(const panel *p)
{
    return is_grey(p) ? 80 : 64;
}

void oled_reset(panel *p)
{
    oled_state *o = &p->state.oled;
    uint8_t memory[sizeof o->memory];
    memcpy(memory, o->memory, sizeof memory); /* a reset leaves it as it is */
    memset(o, 0, sizeof *o);
    memcpy(o->memory, memory, sizeof memory);
    o->column_last = is_grey(p) ? 63 : 127;
    o->row_last = is_grey(p) ? 79 : 7;
    o->multiplex = (uint8_t)(rows_of(p) - 1);
    o->mode = is_grey(p) ? MODE_ROWS : MODE_PAGE;
    o->split = !is_grey(p);
}

/* ------------------------------------------------------------------------------------------------------------ memory
 */

static void tell_left(panel *p)
{
    oled_state *o = &p->state.oled;
    const unsigned area = (o->column_last - o->column_first + 1u) * (o->row_last - o->row_first + 1u);
    if (o->mode != MODE_PAGE && o->written % area != 0) {
        panel_violate(p, "the area of %u bytes was left after %lu", area, (unsigned long)o->written);
    }
    o->written = 0;
}

static void count_frame(panel *p)
{
    const oled_state *o = &p->state.oled;
    const uint8_t last_column = (uint8_t)((is_grey(p) ? (p->width_px + 1u) / 2 : p->width_px) - 1u);
    const uint8_t last_row = (uint8_t)((is_grey(p) ? p->height_px : (p->height_px + 7u) / 8) - 1u);
    p->frames += o->column == last_column && o->row == last_row;
}

/* The next of the addresses from first to last; true when it starts again. */
static bool next(uint8_t *address, uint8_t first, uint8_t last)
{
    *address = *address == last ? first : (uint8_t)(*address + 1);
    return *address == first;
}

static void data_byte(panel *p, uint8_t byte)
{
    oled_state *o = &p->state.oled;
    if (o->known) {
        panel_violate(p, "data %02x within the command %s", byte, panel_name(o->known));
        o->known = NULL;
    }
    o->memory[o->row][o->column] =
        is_grey(p) && !o->nibbles_swapped ? (uint8_t)(byte << 4 | byte >> 4) : byte; /* kept left pixel high */
    count_frame(p);
    o->written++;
    if (o->mode == MODE_PAGE) {
        (void)next(&o->column, 0, COLUMNS - 1);
    } else if (o->mode == MODE_COLUMNS) {
        if (next(&o->row, o->row_first, o->row_last)) {
            (void)next(&o->column, o->column_first, o->column_last);
        }
    } else if (next(&o->column, o->column_first, o->column_last)) {
        (void)next(&o->row, o->row_first, o->row_last);
    }
}

/* ---------------------------------------------------------------------------------------------------------- commands
 */

static void set_range(panel *p, uint8_t *first, uint8_t *last, uint8_t *now, uint8_t most)
{
    const uint8_t *a = p->state.oled.argument;
    tell_left(p);
    if (a[0] > a[1]) {
        panel_violate(p, "%s reversed: %u to %u", panel_name(p->state.oled.known), a[0], a[1]);
        return;
    }
    if (a[1] > most) {
        panel_violate(p, "%s from %u to %u, but the last is %u", panel_name(p->state.oled.known), a[0], a[1], most);
        return;
    }
    *first = *now = a[0];
    *last = a[1];
}

static void check_most(panel *p, uint8_t least, uint8_t most)
{
    const uint8_t value = p->state.oled.argument[0];
    if (value < least || value > most) {
        panel_violate(p, "%s %u, but it goes from %u to %u", panel_name(p->state.oled.known), value, least, most);
    }
}

/* What both have under the same code. */
static bool run_common(panel *p, uint8_t command)
{
    oled_state *o = &p->state.oled;
    switch (command) {
    case 0xa8:
        check_most(p, 15, (uint8_t)(rows_of(p) - 1));
        o->multiplex = o->argument[0];
        return true;
    case 0xae:
    case 0xaf:
        o->on = command == 0xaf;
        return true;
    default:
        return false;
    }
}

static void run_ssd0323(panel *p, uint8_t command)
{
    oled_state *o = &p->state.oled;
    const uint8_t value = o->argument[0];
    switch (command) {
    case 0x15:
        set_range(p, &o->column_first, &o->column_last, &o->column, 63);
        break;
    case 0x75:
        set_range(p, &o->row_first, &o->row_last, &o->row, 79);
        break;
    case 0xa0:
        o->columns_reversed = value & 0x01;
        o->nibbles_swapped = (value & 0x02) != 0;
        o->mode = value & 0x04 ? MODE_COLUMNS : MODE_ROWS;
        o->rows_reversed = (value & 0x10) != 0;
        o->split = (value & 0x40) != 0;
        if (value & 0xa8) {
            panel_violate(p, "re-map %02x: bits 7, 5 and 3 must be 0", value);
        }
        break;
    case 0xa1:
        check_most(p, 0, 79);
        o->start_line = value;
        break;
    case 0xa2:
        check_most(p, 0, 79);
        o->offset = value;
        break;
    case 0xa4:
    case 0xa7:
        o->show = SHOW_MEMORY;
        o->inverted = command == 0xa7;
        break;
    case 0xa5:
    case 0xa6:
        o->show = command == 0xa5 ? SHOW_ALL : SHOW_NONE;
        break;
    default:
        break;
    }
}

static void page_mode_only(panel *p)
{
    if (p->state.oled.mode != MODE_PAGE) {
        panel_violate(p, "%s: for the page addressing mode only", panel_name(p->state.oled.known));
    }
}

static void run_ssd1306(panel *p, uint8_t command, uint8_t within)
{
    oled_state *o = &p->state.oled;
    const uint8_t value = o->argument[0];
    switch (command) {
    case 0x00:
        page_mode_only(p);
        o->column = (uint8_t)((o->column & 0x70) | within);
        break;
    case 0x10:
        page_mode_only(p);
        o->column = (uint8_t)((o->column & 0x0f) | (within & 7) << 4);
        break;
    case 0x20:
        check_most(p, 0, 2);
        o->mode = value & 3;
        break;
    case 0x21:
        set_range(p, &o->column_first, &o->column_last, &o->column, 127);
        break;
    case 0x22:
        set_range(p, &o->row_first, &o->row_last, &o->row, 7);
        break;
    case 0x40:
        o->start_line = within;
        break;
    case 0xa0:
    case 0xa1:
        o->columns_reversed = command == 0xa1;
        break;
    case 0xa4:
    case 0xa5:
        o->show = command == 0xa5 ? SHOW_ALL : SHOW_MEMORY;
        break;
    case 0xa6:
    case 0xa7:
        o->inverted = command == 0xa7;
        break;
    case 0xb0:
        page_mode_only(p);
        o->row = within;
        break;
    case 0xc0:
    case 0xc8:
        o->rows_reversed = command == 0xc8;
        break;
    case 0xd3:
        check_most(p, 0, 63);
        o->offset = value & 63;
        break;
    case 0xda:
        if ((value & ~0x30) != 0x02) {
            panel_violate(p, "COM pins %02x: only bits 5 and 4 are free, bit 1 must be 1", value);
        }
        o->split = (value & 0x10) != 0;
        break;
    default:
        break;
    }
}

static void run(panel *p, uint8_t within)
{
    const uint8_t command = p->state.oled.command;
    if (run_common(p, command)) {
        return;
    }
    if (is_grey(p)) {
        run_ssd0323(p, command);
    } else {
        run_ssd1306(p, command, within);
    }
}

/* The SSD1306's commands that carry a number within: what is left is the number. */
static uint8_t number_within(uint8_t *code)
{
    uint8_t mask = 0;
    if (*code < 0x20) {
        mask = 0x0f;
    } else if (*code >= 0x40 && *code < 0x80) {
        mask = 0x3f;
    } else if (*code >= 0xb0 && *code < 0xb8) {
        mask = 0x07;
    }
    const uint8_t number = *code & mask;
    *code = (uint8_t)(*code - number);
    return number;
}

static void command_byte(panel *p, uint8_t byte)
{
    oled_state *o = &p->state.oled;
    uint8_t within = 0;
    if (o->known) {
        o->argument[o->argument_count++] = byte;
    } else {
        o->command = byte;
        within = is_grey(p) ? 0 : number_within(&o->command);
        o->argument_count = 0;
        o->known = panel_find(is_grey(p) ? panel_commands_ssd0323 : panel_commands_ssd1306, o->command);
        if (o->known == NULL) {
            panel_violate(p, "unknown command %02x", byte);
            return;
        }
        if (o->known->name[0] == '?') {
            panel_violate(p, "%s: not modelled", panel_name(o->known));
        }
    }
    if (o->argument_count == o->known->arguments_most) {
        run(p, within);
        o->known = NULL;
    }
}

void oled_byte(panel *p, bool dc, uint8_t byte)
{
    if (dc) {
        data_byte(p, byte);
    } else {
        command_byte(p, byte);
    }
}

void oled_end(panel *p)
{
    const oled_state *o = &p->state.oled;
    if (o->known) {
        panel_violate(p, "the stream ends within the command %s", panel_name(o->known));
    }
    tell_left(p);
}

/* ----------------------------------------------------------------------------------------------------------- the glass
 */

/* The row of the memory that row y of the glass shows; false if it is not driven. */
static bool shown_row(const panel *p, unsigned y, unsigned *row)
{
    const oled_state *o = &p->state.oled;
    const unsigned rows = rows_of(p);
    unsigned line = o->rows_reversed == p->glass.rows_reversed ? y : p->height_px - 1u - y;
    if (line > o->multiplex) {
        return false;
    }
    if (!o->split) { /* the glass has its even rows on one side of the chip and its odd ones on the other */
        line = line / 2 + (line % 2 ? (p->height_px + 1u) / 2 : 0);
    }
    *row = (line + o->start_line + o->offset + rows - p->glass.row_offset) % rows;
    return true;
}

void oled_picture(const panel *p, uint8_t *rgb)
{
    const oled_state *o = &p->state.oled;
    for (unsigned y = 0; y < p->height_px && o->on; y++) {
        unsigned row = 0;
        const bool driven = shown_row(p, y, &row);
        for (unsigned x = 0; x < p->width_px; x++) {
            const unsigned from = o->columns_reversed == p->glass.columns_reversed ? x : p->width_px - 1u - x;
            const unsigned column = from + p->glass.x_px;
            unsigned grey = 0;
            if (driven && column < COLUMNS && o->show == SHOW_MEMORY) {
                grey = is_grey(p) ? (unsigned)o->memory[row][column / 2] >> (column % 2 ? 0 : 4) & 15
                                  : ((unsigned)o->memory[row / 8][column] >> row % 8 & 1) * 15;
                grey = o->inverted ? 15 - grey : grey;
            } else if (driven && o->show == SHOW_ALL) {
                grey = 15;
            }
            memset(rgb + ((size_t)y * p->width_px + x) * 3, (int)(grey * 17), 3);
        }
    }
}
