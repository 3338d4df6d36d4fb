/* SPDX-License-Identifier: MIT */
/*
 * For the tests of the panel model: a panel with a clock of its own, and what it says.
 */
#ifndef TESTS_UNIT_PANEL_STREAM_H
#define TESTS_UNIT_PANEL_STREAM_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "tests/panel/panel.h"

#define US UINT64_C(1000)
#define MS UINT64_C(1000000)

static panel *p;
static uint64_t now; /* ns */

static inline void open_panel(enum panel_kind kind, uint16_t width_px, uint16_t height_px)
{
    now = 1000 * MS;
    p = panel_open(kind, width_px, height_px);
    assert_non_null(p);
    panel_line(p, now, PANEL_CS, false);
}

static inline int close_panel(void **state)
{
    (void)state;
    panel_close(p);
    p = NULL;
    return 0;
}

static inline void wait_ns(uint64_t ns)
{
    now += ns;
}

static inline void command(uint8_t code)
{
    panel_line(p, now, PANEL_DC, false);
    panel_byte(p, now, code);
}

static inline void data(uint8_t byte)
{
    panel_line(p, now, PANEL_DC, true);
    panel_byte(p, now, byte);
}

/* A command with `count` arguments as data. */
static inline void command_with(uint8_t code, int count, ...)
{
    va_list arguments;
    va_start(arguments, count);
    command(code);
    for (int i = 0; i < count; i++) {
        data((uint8_t)va_arg(arguments, int));
    }
    va_end(arguments);
}

/* Nothing forbidden up to now. */
static inline void assert_clean(void)
{
    if (panel_violations(p) != 0) {
        fail_msg("unexpected: %s", panel_violation(p, 0));
    }
}

/* Exactly one thing forbidden, and its text has these words. */
static inline void assert_refused(const char *words)
{
    if (panel_violations(p) != 1 || strstr(panel_violation(p, 0), words) == NULL) {
        fail_msg("expected one violation with '%s', got %lu: %s", words, (unsigned long)panel_violations(p),
                 panel_violations(p) ? panel_violation(p, 0) : "none");
    }
}

static inline void assert_pixel(unsigned x, unsigned y, unsigned width, uint8_t r, uint8_t g, uint8_t b)
{
    const uint8_t *rgb = panel_picture(p) + ((size_t)y * width + x) * 3;
    if (rgb[0] != r || rgb[1] != g || rgb[2] != b) {
        fail_msg("pixel (%u, %u) is %u %u %u, expected %u %u %u", x, y, rgb[0], rgb[1], rgb[2], r, g, b);
    }
}

#endif
