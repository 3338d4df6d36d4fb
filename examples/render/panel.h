/* SPDX-License-Identifier: MIT */
/*
 * A display panel in memory: takes bands in the library's pixel formats and shows them as 8-bit RGB.
 */
#ifndef EXAMPLES_RENDER_PANEL_H
#define EXAMPLES_RENDER_PANEL_H

#include <stdint.h>

#include <glint/display.h>

enum { PANEL_MAX_PENDING = 2 };

typedef struct panel {
    uint8_t *rgb; /* width_px x height_px x 3 bytes, rows from the top without gap */
    uint16_t width_px, height_px;
    uint8_t format;

    /* With two buffers the panel reads a band as late as it may, as a slow transfer would. */
    glint_transfers transfers;
    glint_band pending[PANEL_MAX_PENDING];
    int pending_count;
} panel;

/* What panel_flush() returns when a band does not fit the panel, or more bands are under way than there are buffers. */
enum { PANEL_ERROR_BAND = 1 };

/*
 * The display that a panel is: its size, format, flush function and context. The panel must outlive it.
 * buffer_count 1: a band is taken at once. 2: it is taken when the library waits for its buffer, or by panel_finish().
 */
glint_display panel_display(panel *p, uint16_t band_px, uint8_t dither, uint8_t buffer_count);

/* Takes what is still pending. */
void panel_finish(panel *p);

#endif
