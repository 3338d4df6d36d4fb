/* SPDX-License-Identifier: MIT */
/*
 * The command line of glint-panel.
 */
#ifndef EXAMPLES_LINUX_PANEL_OPTIONS_H
#define EXAMPLES_LINUX_PANEL_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "examples/scenes/scenes.h"

#include "buttons.h"
#include "failure.h"
#include "screen.h"

typedef struct options {
    bool help;
    const demo_scene *demo;
    const screen_controller *controller;
    const char *spi, *chip;
    const char *dc, *reset, *backlight; /* lines; reset and backlight: NULL where there is none */
    const char *buttons[BUTTONS_MOST];
    unsigned button_count;
    bool buttons_high; /* they connect to the supply, not to ground */
    screen_glass glass;
    uint32_t speed_hz;
    uint32_t frames; /* 0: until a signal comes */
    uint8_t tolerance;
    bool fps, ask;
    const char *dump;
} options;

/* 0, or -1 and what was expected. */
int options_parse(int count, char **arguments, options *out, failure *f);

extern const char options_usage[];

#endif
