/* SPDX-License-Identifier: MIT */
/*
 * Handing bands to the display, with one or two buffers in turn.
 *
 * `started` and `finished` of glint_transfers have one writer each, so a byte counter is safe to share with an
 * interrupt on every processor. They may wrap: at most two transfers are under way.
 */
#ifndef GLINT_DISPLAY_FLUSH_H
#define GLINT_DISPLAY_FLUSH_H

#include <glint/display.h>

/* Waits until fewer than `count` transfers are under way. */
void glint_flush_wait(const glint_display *display, int8_t count);

/* Waits until no transfer is under way, and leaves the counters equal. */
void glint_flush_finish(const glint_display *display);

/* Calls the display's flush function; returns what it returned. */
int glint_flush_band(const glint_display *display, const glint_band *band);

#endif
