/* SPDX-License-Identifier: MIT */
#include "changes.h"

#include <stdlib.h>
#include <string.h>

int changes_open(changes *c, uint32_t row_bytes, uint16_t height_px)
{
    c->row_bytes = row_bytes;
    c->rows = calloc(height_px, row_bytes);
    c->known = calloc(height_px, sizeof *c->known);
    return c->rows != NULL && c->known != NULL ? 0 : -1;
}

void changes_close(changes *c)
{
    free(c->rows);
    free(c->known);
    memset(c, 0, sizeof *c);
}

static bool differs(const changes *c, unsigned y_px, const uint8_t *row)
{
    return !c->known[y_px] || memcmp(c->rows + (size_t)y_px * c->row_bytes, row, c->row_bytes) != 0;
}

bool changes_take(changes *c, const glint_band *band, sender_job *job)
{
    const uint8_t *pixels = band->pixels;
    unsigned first = 0, end = band->height_px;
    while (first < end && !differs(c, band->y_px + first, pixels + (size_t)first * c->row_bytes)) {
        first++;
    }
    while (end > first && !differs(c, band->y_px + end - 1, pixels + (size_t)(end - 1) * c->row_bytes)) {
        end--;
    }
    if (first == end) {
        return false;
    }
    *job = (sender_job){.pixels = pixels + (size_t)first * c->row_bytes,
                        .bytes = (end - first) * c->row_bytes,
                        .y_px = (uint16_t)(band->y_px + first),
                        .height_px = (uint16_t)(end - first)};
    memcpy(c->rows + (size_t)job->y_px * c->row_bytes, job->pixels, job->bytes);
    memset(c->known + job->y_px, true, job->height_px);
    return true;
}
