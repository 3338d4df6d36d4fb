/* SPDX-License-Identifier: MIT */
/*
 * Event streams as text, see panel.h.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/panel/panel.h"

/* A byte of two hexadecimal digits and nothing behind. */
static bool hex_byte(const char *text, uint8_t *byte)
{
    if (strlen(text) != 2 || strspn(text, "0123456789abcdefABCDEF") != 2) {
        return false;
    }
    *byte = (uint8_t)strtoul(text, NULL, 16);
    return true;
}

static bool i2c_event(panel *p, uint64_t ns, const char *what)
{
    uint8_t byte = 0;
    if (strcmp(what, "start") == 0) {
        panel_i2c_start(p, ns);
    } else if (strcmp(what, "stop") == 0) {
        panel_i2c_stop(p, ns);
    } else if (hex_byte(what, &byte)) {
        panel_i2c_byte(p, ns, byte);
    } else {
        return false;
    }
    return true;
}

bool panel_event(panel *p, const char *line)
{
    static const char *const signals[] = {
        [PANEL_SCK] = "sck", [PANEL_MOSI] = "mosi",   [PANEL_CS] = "cs",
        [PANEL_DC] = "dc",   [PANEL_RESET] = "reset", [PANEL_BACKLIGHT] = "backlight",
    };
    char kind[12] = "", value[8] = "", more = 0;
    char *rest = NULL;
    if (line[0] == '#' || line[strspn(line, " \t\r")] == '\0') {
        return true;
    }
    const uint64_t ns = strtoull(line, &rest, 10);
    if (line[0] < '0' || line[0] > '9' || sscanf(rest, " %11s %7s %c", kind, value, &more) != 2) {
        return false;
    }
    if (strcmp(kind, "byte") == 0) {
        uint8_t byte = 0;
        if (!hex_byte(value, &byte)) {
            return false;
        }
        panel_byte(p, ns, byte);
        return true;
    }
    if (strcmp(kind, "i2c") == 0) {
        return i2c_event(p, ns, value);
    }
    for (int i = PANEL_SCK; i <= PANEL_BACKLIGHT; i++) {
        if (strcmp(kind, signals[i]) == 0 && (strcmp(value, "0") == 0 || strcmp(value, "1") == 0)) {
            panel_line(p, ns, (enum panel_signal)i, value[0] == '1');
            return true;
        }
    }
    return false;
}
