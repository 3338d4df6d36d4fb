/* SPDX-License-Identifier: MIT */
/*
 * Remembers the rows of pixels that the panel holds, to send only those that changed.
 */
#ifndef EXAMPLES_LINUX_PANEL_CHANGES_H
#define EXAMPLES_LINUX_PANEL_CHANGES_H

#include <stdbool.h>
#include <stdint.h>

#include <glint/display.h>

#include "sender.h"

typedef struct changes {
    uint8_t *rows; /* as sent last, height_px of row_bytes */
    bool *known;   /* whether a row has been sent at all */
    uint32_t row_bytes;
} changes;

/* 0; -1 without memory. */
int changes_open(changes *c, uint32_t row_bytes, uint16_t height_px);
void changes_close(changes *c); /* zeroed is fine */

/*
 * The rows of a band from the first to the last that differs from what the panel holds, as a job to send; they count as
 * held from now on. False if none does.
 */
bool changes_take(changes *c, const glint_band *band, sender_job *job);

#endif
