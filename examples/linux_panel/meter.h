/* SPDX-License-Identifier: MIT */
/*
 * Tells what frames take: a line for each frame that a press asked for, or a line a second.
 */
#ifndef EXAMPLES_LINUX_PANEL_METER_H
#define EXAMPLES_LINUX_PANEL_METER_H

#include <stdint.h>
#include <stdio.h>

#include "show.h"

/* Sums since the last line. Begins zeroed, but for `start_ns`: now. */
typedef struct meter {
    uint64_t start_ns, draw_ns, send_ns;
    uint32_t frames, bands, bands_sent;
} meter;

/* One frame: its turn, its tolerance, and what that costs. */
void meter_frame(FILE *out, uint32_t number, const view *v, const show_frame *frame);

/* Adds a frame; prints a line when a second has passed since the last one, or `last` is set. */
void meter_second(meter *m, FILE *out, const show_frame *frame, uint64_t now_ns, bool last);

#endif
