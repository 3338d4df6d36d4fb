/* SPDX-License-Identifier: MIT */
/*
 * What the caller asks of the shading, and the report of what a frame took.
 */
#ifndef GLINT_QUALITY_H
#define GLINT_QUALITY_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * How the colour of a triangle's pixels is found. With N_i the unit normals at the corners and b_i the
 * perspective-correct barycentric coordinates of the surface point at the pixel's centre:
 *
 * exact:   the model at that point with n = sum b_i N_i, normalised; where the sum is zero, the face normal.
 * Gouraud: the model at each corner with its own normal, clamped to 0..1, then interpolated linearly on the screen
 * (without perspective correction). flat:    the model at the triangle's centroid (mean of the three corners, before
 * clipping) with the face normal.
 */
enum {
    GLINT_SHADING_EXACT = 0,   /* the model at each pixel, with the perspective-correct, renormalised normal */
    GLINT_SHADING_GOURAUD = 1, /* the model at each corner, the colour linear on the screen between */
    GLINT_SHADING_FLAT = 2     /* the model once a triangle, at its centroid with the face normal */
};

typedef struct glint_quality {
    uint8_t shading; /* GLINT_SHADING_EXACT ... */
} glint_quality;

/* Counts over one frame. A triangle counts once in `triangles` and once in one of the five that follow. */
typedef struct glint_report {
    uint32_t triangles;       /* in the scene's objects */
    uint32_t triangles_drawn; /* set up and scanned, clipped ones included */
    uint32_t triangles_facing_away;
    uint32_t triangles_outside;    /* beyond the display's edges or behind the near plane */
    uint32_t triangles_empty;      /* without area after snapping */
    uint32_t triangles_refused;    /* coordinates that are not finite (float backend) */
    uint32_t triangles_clipped;    /* of those drawn: cut at the near plane or the guard band */
    uint32_t vertices_transformed; /* more than the scene has when the memory could not hold them */
    uint32_t pixels_shaded;        /* that passed the depth test */
    uint32_t pixels_specular;      /* of those: with a specular term evaluated (exact shading) */
    uint32_t bands;
    uint32_t memory_used_bytes;
} glint_report;

#ifdef __cplusplus
}
#endif

#endif
