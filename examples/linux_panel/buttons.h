/* SPDX-License-Identifier: MIT */
/*
 * What presses of buttons mean. With two buttons or more, the first turns the model, the second switches the tolerance,
 * the third turns the model back, each when it goes down. With one, a short press turns the model and a long one
 * switches the tolerance, when it goes up.
 */
#ifndef EXAMPLES_LINUX_PANEL_BUTTONS_H
#define EXAMPLES_LINUX_PANEL_BUTTONS_H

#include <stdbool.h>
#include <stdint.h>

#include "gpio.h"

#define BUTTONS_MOST 3
#define BUTTONS_BOUNCE_NS 20000000u /* an edge so soon after the one before is the contact's bouncing */
#define BUTTONS_LONG_PRESS_NS 500000000u

typedef enum button_action { BUTTON_NOTHING, BUTTON_TURN, BUTTON_TOLERANCE, BUTTON_TURN_BACK } button_action;

/* Begins zeroed, but for `count`. */
typedef struct buttons {
    unsigned count;
    bool seen[BUTTONS_MOST]; /* an edge of it */
    bool pressed[BUTTONS_MOST];
    uint64_t edge_ns[BUTTONS_MOST]; /* of the last edge that counted */
} buttons;

button_action buttons_edge(buttons *b, unsigned number, const gpio_edge *edge);

#endif
