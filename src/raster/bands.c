/* SPDX-License-Identifier: MIT */
#include "raster/bands.h"

void glint_bands_clear(glint_bands *bands, uint16_t count)
{
    for (uint16_t i = 0; i < count; i++) {
        bands->first[i] = GLINT_NO_TRIANGLE;
    }
    bands->active = GLINT_NO_TRIANGLE;
}

void glint_bands_add(glint_bands *bands, uint16_t band, uint16_t triangle)
{
    bands->next[triangle] = bands->first[band];
    bands->first[band] = triangle;
}

void glint_bands_enter(glint_bands *bands, uint16_t band)
{
    /* GLINT_NO_TRIANGLE is greater than every number, so it ends either list by the one comparison */
    uint16_t *link = &bands->active;
    uint16_t entering = bands->first[band];
    while (entering != GLINT_NO_TRIANGLE) {
        if (*link > entering) {
            const uint16_t after = *link;
            *link = entering;
            entering = bands->next[entering];
            bands->next[*link] = after;
        }
        link = &bands->next[*link];
    }
}
