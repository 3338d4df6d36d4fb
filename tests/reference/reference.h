/* SPDX-License-Identifier: MIT */
/*
 * The double-precision reference: draws a glint_scene by casting a ray through each pixel's centre, from the formulas
 * in <glint/scene.h> and <glint/quality.h> alone. It shares no code with the library: only the scene's bits.
 *
 * Method. Triangles are taken into view space in double precision. A ray meets a triangle where the three homogeneous
 * edge functions d . (P_j x P_k) have one sign (M. Olano and T. Greer, "Triangle scan conversion using 2D homogeneous
 * coordinates", Graphics Hardware 1997), which are also its perspective-correct barycentric coordinates; so nothing
 * has to be clipped, and neighbouring triangles leave no gap. The nearest surface beyond the near plane that turns its
 * outside to the eye is lit, with all sums and powers in double.
 *
 * Contested pixels. The library rounds vertices to 1/256 px and depth to 16 bits, so that at some pixels it may
 * rightly show another surface than the reference. With e = options.edge_px and N = options.depth_steps:
 *  - A triangle (cut at the near plane) MAY cover a pixel when the pixel's centre is in it, or within e of its edge.
 *    A triangle turned away counts when it is so thin (width <= 2e) that rounding could turn it around.
 *  - A set of triangles MUST cover a pixel when the set winds around the centre (more of its triangles that face the
 * eye hold it than of those turned away) and the centre is further than e from the outline of the set: a single
 * triangle, or triangles of one object that share (by position) every edge within e of the centre. So a crack between
 *    neighbours is never excused.
 *  - Its depth is 65519 near / Z; where it may cover the pixel it has a range of depths, found within e of the centre.
 *  - Candidates are the triangles that may cover the pixel, and whose nearest depth there is not more than N steps
 *    behind the far end of the nearest set that must cover it. The background is one where nothing must cover it.
 * A pixel with one candidate is plain. With more it is contested: REFERENCE_EDGE where a candidate's edge is the
 * reason, REFERENCE_DEPTH where two that must cover it are too close in depth to be told apart.
 * REFERENCE_TERMINATOR: for the surface seen there, a light has |n.s| < options.terminator and its specular term, which
 * the model ends abruptly at n.s = 0, would change the colour there by more than 1/1000 code. In Gouraud shading n and
 * s are those of a corner, in flat shading those of the centroid.
 * REFERENCE_TEXEL: the texture's colours within options.texel_px of the centre, which vertices are rounded by, and
 * within options.texels along u and v of those, change the pixel by more than 0.3 code: on the edge between two texels
 * (nearest), or in a steep or far reduced picture (bilinear). A candidate's texture is that of all points within e.
 *
 * Flat and Gouraud shading of a textured surface: the part that the texture multiplies and the rest are lit at the
 * centroid or the corners, clamped and interpolated each by itself; the texture is sampled at each pixel.
 *
 * REFERENCE_LAYER: a surface that lets light through may cover the pixel or not, or be in front of what else is there
 * or not, by the same e and N; its one candidate is the range of all the colours that this may give. Layers are laid
 * over each other in the order of their depths; where a renderer's order may differ is in <glint/scene.h>. What is said
 * above of candidates is of the opaque surfaces.
 *
 * REFERENCE_SHADOW: for the surface seen there, a light that would change the colour by more than 1/1000 code is hidden
 * at the centre and not at some point of the same plane that is seen within options.shadow_px, or the other way round;
 * or the light lies in that plane, |s.n_face| < options.terminator. Twenty-four points about the centre are looked at,
 * in eight directions, at 1, 1/8 and 1/64 of that distance.
 *
 * A shadow: a ray from the point to the light meets a triangle that casts, by the rules of glint_light in
 * <glint/scene.h>. It counts from a millionth of the point's distance to the eye on, so that surfaces that touch throw
 * no shadow on each other where they do.
 *
 * Gouraud shading of a triangle that the near plane cuts: the polygon that remains (Sutherland-Hodgman, started at
 * corner 0) has at its new corners the colour that is linear in space between the old corners; it is divided into
 * a fan from its first corner, and the colour is linear on the screen in each part.
 *
 * Where the header leaves a case open: a point light that stands on the surface point gives no light there; a normal
 * sum shorter than 1e-9 counts as zero; a zero face normal is replaced by the direction to the viewer.
 */
#ifndef GLINT_TESTS_REFERENCE_H
#define GLINT_TESTS_REFERENCE_H

#include <stddef.h>
#include <stdint.h>

#include <glint/quality.h>
#include <glint/scene.h>

/* Bits of a pixel's mask. */
enum {
    REFERENCE_EDGE = 1,
    REFERENCE_DEPTH = 2,
    REFERENCE_TERMINATOR = 4,
    REFERENCE_LAYER = 8,
    REFERENCE_TEXEL = 16,
    REFERENCE_SHADOW = 32
};

/* Zero fields mean the stated defaults; a negative one means zero. */
typedef struct reference_options {
    double edge_px;     /* e: default 1/256 px */
    double depth_steps; /* N: default 2 */
    double terminator;  /* default 1e-4 */
    double texel_px;    /* default 1/4096 px */
    double texels;      /* default 1/4096 texel */
    double shadow_px;   /* default 1 px */
} reference_options;

typedef struct reference_detail reference_detail;

typedef struct reference_image {
    int width, height;
    double *rgb;              /* 3 a pixel, 0..1, rows from the top: L of the model, unrounded */
    int32_t *triangle;        /* number in drawing order (over all objects), -1: background; the nearest one */
    double *depth;            /* Z in world units; 0 for the background */
    uint8_t *mask;            /* REFERENCE_EDGE ... ; 0: plain */
    double *rounding;         /* codes by which the rounding of pixels seen through a surface may move this one */
    reference_detail *detail; /* what reference_candidates() needs */
} reference_image;

/*
 * Draws. shading: GLINT_SHADING_EXACT ... . Returns 0, or -1 with a sentence in `error` (NULL when error_bytes is 0):
 * for what it cannot work with (NULL pointers, an index out of range, sizes below 1, no memory). It does not validate
 * the scene otherwise. The image keeps no pointer into the scene.
 */
int reference_render(const glint_scene *scene, int width, int height, int shading, reference_image *out, char *error,
                     size_t error_bytes);
int reference_render_with(const glint_scene *scene, int width, int height, int shading,
                          const reference_options *options, reference_image *out, char *error, size_t error_bytes);

/* Frees what the image holds and zeroes it. */
void reference_free(reference_image *image);

/*
 * A colour that the pixel may rightly have. low and high bound the triangle's own colours within e of the pixel's
 * centre (its corners there, and the centre or the point nearest to it), since rounding its corners moves its surface
 * by up to e: nearly equal, except on triangles so thin that their colour changes within 1/256 px.
 */
typedef struct reference_candidate {
    int32_t triangle; /* -1: background */
    double low[3], high[3];
} reference_candidate;

/* The candidates of any pixel, contested or not, the surface that the reference shows first. A triangle appears more
 * than once where a specular term may or may not be there. Returns how many there are; at most `max` are written. */
int reference_candidates(const reference_image *image, int x, int y, reference_candidate *out, int max);

/* round(255 L) of every pixel, 3 bytes each: the reference as a picture. */
void reference_codes(const reference_image *image, uint8_t *rgb8);

/* The mask as a picture, 3 bytes a pixel: 255 in red, green, blue for edge, depth, terminator or texel; 128 in green
 * and blue for shadow. */
void reference_mask_codes(const reference_image *image, uint8_t *rgb8);

typedef struct reference_verdict {
    uint32_t pixels;

    /* plain pixels, all three channels */
    double max_codes, mean_codes; /* of |actual - 255 L|, L not rounded: 0.5 is the least that rounding leaves */
    double psnr_db;               /* of actual against round(255 L), 20 log10(255 / rms); INFINITY when equal */
    uint32_t differing;           /* pixels with a channel where actual != round(255 L) */
    uint32_t above;               /* pixels with a channel where |actual - round(255 L)| > the limit */
    uint32_t above_unexplained;   /* of those: outside the colours of the surface within e, limit and 0.5 added */
    int worst_x, worst_y;         /* where max_codes is; -1 when all pixels are contested */

    /* contested pixels */
    uint32_t contested, contested_edge, contested_depth, contested_terminator, contested_texel, contested_shadow;
    double contested_share; /* of all pixels, 0..1, but those that are so for shadows only */
    double shadow_share;    /* those */
    uint32_t unmatched;     /* that agree with no candidate: a channel is outside of low..high by more than the limit
                             * and 0.5 (for the rounding to a whole code) */
    int unmatched_x, unmatched_y; /* the first of them; -1 when there is none */
} reference_verdict;

/* Compares a picture of the same size, 3 bytes a pixel (red, green, blue), rows from the top without gap. */
void reference_check(const reference_image *image, const uint8_t *rgb8, double max_codes, reference_verdict *verdict);

/*
 * Exact coverage of a triangle whose corners lie on the sub-pixel grid, x, y in 1/256 px, y down, of either winding:
 * pixel (i, j) is covered when its centre (256 i + 128, 256 j + 128) is inside, or on a left or a top edge (an edge
 * with the inside on its right, or a level one with the inside below). The three edge functions are evaluated whole
 * for each pixel in int64; nothing is stepped. Only pixels within 0 <= i < width, 0 <= j < height are found.
 *
 * covered: called for each covered pixel, rows from the top; may be NULL. Returns the number of pixels, or -1 when a
 * coordinate is beyond +-REFERENCE_MAX_COORDINATE, where the products might not fit. No area: 0.
 */
#define REFERENCE_MAX_COORDINATE (1 << 29)
typedef void (*reference_covered)(void *context, int x, int y);
long reference_cover(const int32_t corners[3][2], int width, int height, reference_covered covered, void *context);

#endif
