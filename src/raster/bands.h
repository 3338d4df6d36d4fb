/* SPDX-License-Identifier: MIT */
/*
 * Sorting of triangles into bands, once a frame: a list for each band of the triangles that begin in it, and one list
 * of those that are being drawn, kept in the order of the scene. Two bytes a triangle and a band.
 */
#ifndef GLINT_RASTER_BANDS_H
#define GLINT_RASTER_BANDS_H

#include <stdbool.h>
#include <stdint.h>

#define GLINT_NO_TRIANGLE 0xffffu

/* Triangles are numbered through the scene's objects, 0..65534. */
typedef struct glint_bands {
    uint16_t *first; /* [band]: first of the list of triangles that begin in this band */
    uint16_t *next;  /* [triangle] */
    uint16_t active; /* head of the list of triangles to draw in the current band */
} glint_bands;

/* Empties the lists of `count` bands. */
void glint_bands_clear(glint_bands *bands, uint16_t count);

/* Adds a triangle to the band in which it begins. Call with triangles in falling order, so that lists rise. */
void glint_bands_add(glint_bands *bands, uint16_t band, uint16_t triangle);

/* Merges the triangles that begin in `band` into the active list. */
void glint_bands_enter(glint_bands *bands, uint16_t band);

#endif
