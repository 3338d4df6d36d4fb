/* SPDX-License-Identifier: MIT */
/*
 * What a frame keeps in the caller's memory, and where.
 *
 *     drawing   of the frame, of one triangle  always
 *     objects   one state an object            always
 *     lights    one state an object and light  always; of an extended source as many as its samples allow
 *     mirrors   one for each object that mirrors the environment
 *     shadows   boxes, lights, a copy of an object,
 *               a bit a pixel of a band and light    where some light casts shadows: see effects/shadow.h
 *     reaches   one for each of these lights that is a spot light or attenuated
 *     texture   one, where an object has a texture
 *     buffers   one or two bands of pixels     always
 *     depth     16 bits a pixel of a band      always
 *     bands     2 bytes a band and a triangle  where there is room, more than one band, fewer than 65,535 triangles
 *     vertices  12 bytes a vertex              for as many objects, in order, as there is room
 *     tables    of a material, see ramp.h      the same, with a tolerance
 *     kept      triangles set up, see kept.inc what is left, where there are bands
 *
 * Each part begins on a multiple of 4 bytes. Those whose states hold pointers come first, so that they begin on a
 * multiple of 8 where pointers ask for it; the texture has room to see to that itself.
 */
#ifndef GLINT_MEMORY_H
#define GLINT_MEMORY_H

#include <stdbool.h>
#include <stdint.h>

/* Where each part begins, in bytes, as long as `least` is not GLINT_TOO_MUCH. */
typedef struct glint_needs {
    uint32_t objects, lights, mirrors, shadows, reaches, texture, buffers, depth;
    bool has_shadows, has_texture;
    uint32_t buffer;    /* bytes of one band of pixels */
    uint32_t stride;    /* bytes from row to row (page to page) */
    uint16_t height_px; /* rows that are drawn: the display's, or its area's */
    uint16_t band_px, band_count;
    uint16_t light_count; /* with the most point lights that extended sources may come to */
    uint16_t reach_count; /* of these, spot lights and attenuated ones */
    uint32_t bands;       /* bytes of the lists of triangles; 0: there are none */
    uint32_t least;       /* bytes without bands and vertices: where these begin */
    uint32_t full;        /* with these */
} glint_needs;

/* More than 32 bits can tell: such a scene is drawn by no memory. */
#define GLINT_TOO_MUCH UINT32_MAX

#endif
