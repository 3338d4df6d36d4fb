/* SPDX-License-Identifier: MIT */
/*
 * The panel model's bus: clock, data, select and D/C become bytes; reset and the times of everything are watched; I2C
 * frames are taken apart. 4-wire serial interface as in all four data sheets: a bit is taken on the rising edge of the
 * clock, the highest first; D/C belongs to a whole byte.
 */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/panel/internal.h"

#define VIOLATIONS_KEPT 1000
#define VIOLATION_CHARS 160

/* SSD1306 data sheet, 8.1.5: 0111 10 SA0 R/W#; table 13-5: a clock cycle of 2.5 us at least, nine a byte. */
#define I2C_ADDRESS_WRITE 0x78
#define I2C_ADDRESS_MASK 0xfc
#define I2C_BYTE_NS (9 * UINT64_C(2500))

void panel_violate(panel *p, const char *format, ...)
{
    p->violation_count++;
    if (p->violation_kept == VIOLATIONS_KEPT) {
        return;
    }
    char *text = malloc(VIOLATION_CHARS);
    if (text == NULL) {
        return; /* counted all the same */
    }
    const int head = snprintf(text, VIOLATION_CHARS, "%llu: ", (unsigned long long)p->now_ns);
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(text + head, (size_t)(VIOLATION_CHARS - head), format, arguments);
    va_end(arguments);
    p->violation[p->violation_kept++] = text;
}

const panel_command *panel_find(const panel_command *table, uint8_t code)
{
    for (; table->name; table++) {
        if (table->code == code) {
            return table;
        }
    }
    return NULL;
}

const char *panel_name(const panel_command *command)
{
    return command->name + (command->name[0] == '?');
}

static bool is_dcs(const panel *p)
{
    return p->kind == PANEL_ST7789 || p->kind == PANEL_ILI9341;
}

static void controller_reset(panel *p)
{
    p->bit_count = 0;
    (is_dcs(p) ? dcs_reset : oled_reset)(p);
}

static void controller_byte(panel *p, bool dc, uint8_t byte)
{
    if (!p->level[PANEL_RESET]) {
        panel_violate(p, "byte %02x while reset is low", byte);
        return;
    }
    if (p->now_ns < p->ready_ns) {
        panel_violate(p, "byte %02x %.3f ms too early %s", byte, (double)(p->ready_ns - p->now_ns) / 1e6, p->ready_why);
        p->ready_ns = 0; /* once for each wait that is cut short */
    }
    p->bytes++;
    (is_dcs(p) ? dcs_byte : oled_byte)(p, dc, byte);
}

panel_glass panel_usual_glass(enum panel_kind kind)
{
    panel_glass glass = {0};
    glass.inverted = kind == PANEL_ST7789;
    glass.bgr = kind == PANEL_ILI9341;
    glass.columns_reversed = kind == PANEL_SSD1306;
    glass.rows_reversed = kind == PANEL_SSD0323 || kind == PANEL_SSD1306;
    glass.row_offset = kind == PANEL_SSD0323 ? 76 : 0;
    return glass;
}

panel *panel_open(enum panel_kind kind, uint16_t width_px, uint16_t height_px)
{
    static const struct {
        uint16_t width_px, height_px;
        const panel_limits *limits;
    } controllers[] = {
        [PANEL_ST7789] = {240, 320, &panel_limits_st7789},
        [PANEL_ILI9341] = {240, 320, &panel_limits_ili9341},
        [PANEL_SSD0323] = {128, 80, &panel_limits_ssd0323},
        [PANEL_SSD1306] = {128, 64, &panel_limits_ssd1306},
    };
    if (width_px == 0 || height_px == 0 || width_px > controllers[kind].width_px ||
        height_px > controllers[kind].height_px) {
        return NULL;
    }
    panel *p = calloc(1, sizeof *p);
    if (p == NULL) {
        return NULL;
    }
    p->kind = kind;
    p->width_px = width_px;
    p->height_px = height_px;
    p->limits = controllers[kind].limits;
    p->glass = panel_usual_glass(kind);
    p->level[PANEL_RESET] = p->level[PANEL_CS] = true;
    p->rgb = calloc((size_t)width_px * height_px, 3);
    p->violation = calloc(VIOLATIONS_KEPT, sizeof *p->violation);
    if (p->rgb == NULL || p->violation == NULL) {
        panel_close(p);
        return NULL;
    }
    controller_reset(p);
    return p;
}

void panel_close(panel *p)
{
    if (p == NULL) {
        return;
    }
    for (size_t i = 0; i < p->violation_kept; i++) {
        free(p->violation[i]);
    }
    free(p->violation);
    free(p->rgb);
    free(p);
}

void panel_set_glass(panel *p, const panel_glass *glass)
{
    p->glass = *glass;
}

static void advance(panel *p, uint64_t ns)
{
    if (ns < p->now_ns) {
        panel_violate(p, "time goes back to %llu", (unsigned long long)ns);
        return;
    }
    p->now_ns = ns;
}

static void reset_changed(panel *p, bool level)
{
    if (!level) {
        p->reset_fell_ns = p->now_ns;
        return;
    }
    if (p->now_ns - p->reset_fell_ns < p->limits->reset_pulse_ns) {
        panel_violate(p, "reset low for %.1f us only: too short to be taken for one",
                      (double)(p->now_ns - p->reset_fell_ns) / 1e3);
        return;
    }
    controller_reset(p);
    p->ready_ns = p->now_ns + p->limits->after_reset_ns;
    p->ready_why = "after reset";
}

static void too_fast(panel *p, const char *what, uint64_t is_ns, uint32_t least_ns)
{
    if (is_ns < least_ns && !p->sck_told) {
        panel_violate(p, "clock too fast: %s of %llu ns, %lu at least", what, (unsigned long long)is_ns,
                      (unsigned long)least_ns);
        p->sck_told = true; /* once a selection */
    }
}

static void clock_changed(panel *p, bool level)
{
    if (p->level[PANEL_CS]) {
        return;
    }
    if (!level) {
        if (p->sck_rose) {
            too_fast(p, "high", p->now_ns - p->sck_rose_ns, p->limits->clock_high_ns);
            p->sck_fell_ns = p->now_ns;
        }
        return;
    }
    if (p->sck_rose) {
        too_fast(p, "low", p->now_ns - p->sck_fell_ns, p->limits->clock_low_ns);
        too_fast(p, "cycle", p->now_ns - p->sck_rose_ns, p->limits->clock_cycle_ns);
    }
    p->sck_rose = true;
    p->sck_rose_ns = p->now_ns;
    p->bits = (uint8_t)(p->bits << 1 | (p->level[PANEL_MOSI] ? 1 : 0));
    if (++p->bit_count == 8) {
        p->bit_count = 0;
        controller_byte(p, p->level[PANEL_DC], p->bits);
    }
}

/* A read begins with dummy clocks and may end anywhere. */
static bool within_byte(const panel *p)
{
    return p->bit_count != 0 && !(is_dcs(p) && dcs_reading(p));
}

static void select_changed(panel *p, bool level)
{
    if (level && within_byte(p)) {
        panel_violate(p, "select raised after %u bits of a byte", p->bit_count);
    }
    p->bit_count = 0;
    p->sck_rose = p->sck_told = false;
}

void panel_line(panel *p, uint64_t ns, enum panel_signal signal, bool level)
{
    advance(p, ns);
    const bool changed = p->level[signal] != level;
    p->seen[signal] = true;
    p->level[signal] = level;
    if (!changed) {
        return;
    }
    switch (signal) {
    case PANEL_SCK:
        clock_changed(p, level);
        break;
    case PANEL_CS:
        select_changed(p, level);
        break;
    case PANEL_DC:
        if (!p->level[PANEL_CS] && within_byte(p)) {
            panel_violate(p, "D/C changes after %u bits of a byte", p->bit_count);
        }
        break;
    case PANEL_RESET:
        reset_changed(p, level);
        break;
    case PANEL_MOSI:
    case PANEL_BACKLIGHT:
        break;
    }
}

void panel_byte(panel *p, uint64_t ns, uint8_t byte)
{
    advance(p, ns);
    if (!p->seen[PANEL_CS]) {
        p->level[PANEL_CS] = false; /* a panel that is always selected */
    }
    if (!p->level[PANEL_CS]) {
        controller_byte(p, p->level[PANEL_DC], byte);
    }
}

/* ------------------------------------------------------------------------------------------------------------- I2C */

void panel_i2c_start(panel *p, uint64_t ns)
{
    advance(p, ns);
    if (p->kind != PANEL_SSD1306) {
        panel_violate(p, "I2C to a controller that has none");
    }
    p->i2c = I2C_ADDRESS; /* a repeated start is fine */
    p->i2c_timed = false;
}

void panel_i2c_byte(panel *p, uint64_t ns, uint8_t byte)
{
    advance(p, ns);
    if (p->i2c_timed && ns - p->i2c_byte_ns < I2C_BYTE_NS && p->i2c != I2C_OTHER) {
        panel_violate(p, "I2C byte %02x %.1f us after the one before, %.1f at least", byte,
                      (double)(ns - p->i2c_byte_ns) / 1e3, (double)I2C_BYTE_NS / 1e3);
    }
    p->i2c_timed = true;
    p->i2c_byte_ns = ns;
    switch (p->i2c) {
    case I2C_IDLE:
        panel_violate(p, "I2C byte %02x without a start", byte);
        break;
    case I2C_ADDRESS:
        p->i2c = (byte & I2C_ADDRESS_MASK) == I2C_ADDRESS_WRITE ? I2C_CONTROL : I2C_OTHER;
        if (p->i2c == I2C_CONTROL && (byte & 1)) {
            panel_violate(p, "I2C read: not modelled");
            p->i2c = I2C_OTHER;
        }
        break;
    case I2C_CONTROL:
        if (byte & 0x3f) {
            panel_violate(p, "I2C control byte %02x: bits 5..0 must be 0", byte);
        }
        p->i2c_dc = (byte & 0x40) != 0;
        p->i2c = byte & 0x80 ? I2C_ONE : I2C_REST;
        break;
    case I2C_ONE:
        p->i2c = I2C_CONTROL;
        controller_byte(p, p->i2c_dc, byte);
        break;
    case I2C_REST:
        controller_byte(p, p->i2c_dc, byte);
        break;
    case I2C_OTHER:
        break;
    }
}

void panel_i2c_stop(panel *p, uint64_t ns)
{
    advance(p, ns);
    if (p->i2c == I2C_IDLE) {
        panel_violate(p, "I2C stop without a start");
    } else if (p->i2c == I2C_ONE) {
        panel_violate(p, "I2C stop after a control byte that announces another");
    }
    p->i2c = I2C_IDLE;
}

/* ------------------------------------------------------------------------------------------------------- what is seen
 */

void panel_end(panel *p, uint64_t ns)
{
    advance(p, ns);
    if (!p->level[PANEL_CS] && within_byte(p)) {
        panel_violate(p, "the stream ends after %u bits of a byte", p->bit_count);
    }
    (is_dcs(p) ? dcs_end : oled_end)(p);
}

size_t panel_violations(const panel *p)
{
    return p->violation_count;
}

const char *panel_violation(const panel *p, size_t number)
{
    return number < p->violation_kept ? p->violation[number] : "(more than are kept)";
}

const uint8_t *panel_picture(panel *p)
{
    memset(p->rgb, 0, (size_t)p->width_px * p->height_px * 3);
    if (!p->seen[PANEL_BACKLIGHT] || p->level[PANEL_BACKLIGHT]) {
        (is_dcs(p) ? dcs_picture : oled_picture)(p, p->rgb);
    }
    return p->rgb;
}

uint32_t panel_frames(const panel *p)
{
    return p->frames;
}

uint64_t panel_bytes(const panel *p)
{
    return p->bytes;
}
