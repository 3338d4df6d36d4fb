/* SPDX-License-Identifier: MIT */
#include "buttons.h"

button_action buttons_edge(buttons *b, unsigned number, const gpio_edge *edge)
{
    static const button_action on_press[BUTTONS_MOST] = {BUTTON_TURN, BUTTON_TOLERANCE, BUTTON_TURN_BACK};
    const uint64_t since_ns = edge->at_ns - b->edge_ns[number];
    if (b->seen[number] && since_ns < BUTTONS_BOUNCE_NS) {
        return BUTTON_NOTHING;
    }
    const bool was_pressed = b->pressed[number];
    b->seen[number] = true;
    b->pressed[number] = edge->pressed;
    b->edge_ns[number] = edge->at_ns;
    if (edge->pressed) {
        return b->count > 1 ? on_press[number] : BUTTON_NOTHING;
    }
    if (b->count > 1 || !was_pressed) {
        return BUTTON_NOTHING;
    }
    return since_ns >= BUTTONS_LONG_PRESS_NS ? BUTTON_TOLERANCE : BUTTON_TURN;
}
