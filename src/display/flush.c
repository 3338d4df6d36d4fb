/* SPDX-License-Identifier: MIT */
#include "display/flush.h"

#include <stddef.h>

void glint_flush_done(glint_transfers *transfers)
{
    transfers->finished = (uint8_t)(transfers->finished + 1);
}

/* Below 0 when a flush function told the end of a transfer and then returned an error. */
static int8_t under_way(const glint_transfers *transfers)
{
    return (int8_t)(uint8_t)(transfers->started - transfers->finished);
}

void glint_flush_wait(const glint_display *display, int8_t count)
{
    const glint_transfers *transfers = display->transfers;
    if (transfers == NULL) {
        return;
    }
    while (under_way(transfers) >= count) {
        if (display->wait) {
            display->wait(display->context);
        }
    }
}

void glint_flush_finish(const glint_display *display)
{
    glint_flush_wait(display, 1);
    if (display->transfers && under_way(display->transfers) < 0) {
        display->transfers->started = display->transfers->finished;
    }
}

int glint_flush_band(const glint_display *display, const glint_band *band)
{
    glint_transfers *transfers = display->transfers;
    if (transfers) {
        /* before the call: the end may be told from within it */
        transfers->started = (uint8_t)(transfers->started + 1);
    }
    const int result = display->flush(display->context, band);
    if (result != 0 && transfers) {
        transfers->started = (uint8_t)(transfers->started - 1); /* it did not start: nobody will tell its end */
    }
    return result;
}
