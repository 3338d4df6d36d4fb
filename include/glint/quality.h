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
 * q1, q2:  as exact, with 1/|n| by a polynomial of first or second degree in 1 - |n|^2 (see tiers below); exact where
 * the triangle is beyond what they serve.
 */
enum {
    GLINT_SHADING_EXACT = 0,   /* the model at each pixel, with the perspective-correct, renormalised normal */
    GLINT_SHADING_GOURAUD = 1, /* the model at each corner, the colour linear on the screen between */
    GLINT_SHADING_FLAT = 2,    /* the model once a triangle, at its centroid with the face normal */
    GLINT_SHADING_Q1 = 3,
    GLINT_SHADING_Q2 = 4
};

/*
 * With a tolerance, each triangle is drawn by the cheapest tier whose greatest error stays within it; where no tier's
 * does (a bright highlight of a large exponent), by the exact one, and promise_q8 of the report is above the tolerance:
 *
 * unlit:   no light reaches it: one colour, the ambient term.
 * flat:    one colour.
 * Gouraud: colours linear over the triangle; the tier of that shading, never chosen by a tolerance.
 * curved:  each light's cosine a polynomial of second degree on the screen, clamped at each pixel; a highlight's one of
 *          third degree.
 * q1, q2:  each light's N.s linear on the screen, times 1/|N| by a polynomial of first or second degree in 1 - |N|^2.
 * exact:   N normalised at each pixel.
 *
 * The error counts against the model in real numbers with the perspective-correct, renormalised normal, in codes of
 * 1/255 of a channel before the display's own quantisation; 1/2 of it is the rounding to whole codes. Not counted is
 * what moving the surface by 2^-12 px changes, to which vertices are rounded. The formulas and the bounds are in
 * lighting/bound.h, and docs/proofs.md says which of them are proved and which are found by search.
 */
enum {
    GLINT_TIER_UNLIT = 0,
    GLINT_TIER_FLAT = 1,
    GLINT_TIER_GOURAUD = 2,
    GLINT_TIER_CURVED = 3,
    GLINT_TIER_Q1 = 4,
    GLINT_TIER_Q2 = 5,
    GLINT_TIER_EXACT = 6,
    GLINT_TIERS = 7
};

/* A tolerance in codes, a constant of 0.75..15.9; with the default shading only. */
#define GLINT_CODES(codes) ((uint8_t)((codes)*16))
#define GLINT_LEAST_TOLERANCE 12

typedef struct glint_quality {
    uint8_t shading;   /* GLINT_SHADING_EXACT ... */
    uint8_t tolerance; /* 1/16 code: GLINT_LEAST_TOLERANCE..255; 0: none, every triangle by `shading` */
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
    uint32_t pixels_specular;      /* of those: where a specular term is above 0 or, as far as is looked, may be */
    uint32_t bands;
    uint32_t memory_used_bytes;
    /* what shading came to; each part of a clipped triangle counts */
    uint32_t tier_triangles[GLINT_TIERS];
    uint32_t tier_pixels[GLINT_TIERS];
    uint32_t lights_folded;      /* sums over triangles: lights that share one interpolant, */
    uint32_t lights_culled;      /* and lights that do not reach any of it */
    uint32_t specular_triangles; /* on which a highlight may show */
    uint32_t shadow_triangles;   /* on which some shadow may fall */
    uint32_t shadow_tests;       /* shadows of single triangles that were filled in; again in each band */
    uint32_t pixels_shadowed;    /* of those shaded: in the shadow of a light */
    uint16_t promise_q8;         /* greatest error promised for a pixel, 1/256 code; 65535: none is promised */
} glint_report;

#ifdef __cplusplus
}
#endif

#endif
