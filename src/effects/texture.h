/* SPDX-License-Identifier: MIT */
/*
 * Where a pixel lies in a texture, and what colour the texture has there. Integers, compiled once for both backends: a
 * texel is an address, so both have to find the same one.
 *
 * u / w, v / w and 1 / w are linear on the screen (P. S. Heckbert and H. P. Moreton, "Interpolation for polygon texture
 * mapping and shading", 1991), and one reciprocal a pixel gives u and v. What has to be kept small is not the error of
 * such a plane by itself but what it means in texels, of which a triangle may show 1024 and more, with the depth of its
 * corners far apart. Hence planes of 64 bits, added to from pixel to pixel:
 *
 * - C = u less the middle of the corners' range, brought to 28 bits and sign; w_i = a corner's inverse depth, the
 *   greatest brought to 30 bits. P = C w / 2^30 is then at most a quarter of Q = w, and C = 2^30 P / Q.
 * - The gradients of the barycentric coordinates are those of raster/gradients.h, refined to 48 bits. One relative
 *   error of all of them, the reciprocal's, is as if the triangle were larger by 2^-28.3.
 *
 * Error of a coordinate against that of the corners' weights and texture coordinates: 2^-23 of the texture, for its
 * rounding to 22 bits, and 2^-26 of half the corners' range: relative to C 2^-28.3 for the reciprocal, and of
 * the range, whose C has 27 bits at least, 2^-27 and 2^-28 for rounding down the product and P. Tests:
 * tests/unit/test_texture.c.
 */
#ifndef GLINT_EFFECTS_TEXTURE_H
#define GLINT_EFFECTS_TEXTURE_H

#include <stdbool.h>
#include <stdint.h>

#include <glint/mesh.h>
#include <glint/texture.h>

#include "raster/gradients.h"

/* A texture coordinate in the library: 22 fractional bits, so that times 1024 texels it has 32. */
#define GLINT_TEXCOORD_BITS 22

/* Linear on the screen: 32 bits and 32 of a fraction, modulo 2^64. value is at pixel (0, 0). */
typedef struct glint_texture_plane {
    uint64_t value, step_x, step_y;
} glint_texture_plane;

/* u or v over a triangle. */
typedef struct glint_texture_axis {
    glint_texture_plane plane; /* P */
    int32_t corner[3];         /* P at the corners in clockwise order, for slivers */
    int32_t low, high;         /* of C at the corners */
    int32_t middle_q22;
    int32_t half; /* rounds what `down` shifts out */
    uint8_t down; /* C has so many bits more than Q22 */
} glint_texture_axis;

typedef struct glint_texture_map {
    const glint_texture *texture;
    const glint_gradients *gradients;
    glint_texture_plane inverse; /* Q */
    int32_t weight[3];           /* Q at the corners, for slivers */
    int32_t least;               /* of them */
    bool steep;                  /* depths are so far apart that a pixel on an edge may be beyond the corners' range */
    glint_texture_axis axis[2];
    uint32_t error_q16; /* of u and v together, 1/65536 texel */
} glint_texture_map;

/* The colour of a texture, Q15 a channel: 0..32768. */
typedef struct glint_texel {
    uint16_t q15[3];
} glint_texel;

/* Texture coordinates of a vertex in Q22: |.| <= 2^28. */
void glint_texcoord_of(const glint_mesh *mesh, uint16_t vertex, int32_t texcoord_q22[2]);

/*
 * Sets up the map of a triangle. `texcoord_q22` are its corners', |.| <= 2^28, in the order of the mesh, `order` the
 * clockwise one of `gradients`, which has to stay. error_q16 is what a coordinate may be off: the errors above, 2^-13
 * texel for the filter's weights, what the rounding of the corners' inverse depths comes to, and where clipping made
 * corners 2^-21 of the texture and 2^-22 of the range.
 */
void glint_texture_map_set_up(glint_texture_map *map, const glint_texture *texture, const glint_gradients *gradients,
                              int32_t texcoord_q22[3][2], const uint8_t order[3], bool clipped);

/* Texture coordinates at `count` pixels of a row, Q22. The value of a pixel does not depend on where the row starts. */
void glint_texture_coordinates(const glint_texture_map *map, int16_t x, int16_t y, uint16_t count,
                               int32_t texcoord_q22[][2]);

/*
 * The colour at a texture coordinate, |.| < 2^31, by the texture's filter. Error of a channel: 1/2 unit of Q15 for
 * nearest, 1.1 units for bilinear of the colour at the same coordinate with the weights, which are rounded to 13 bits.
 */
void glint_texture_sample(const glint_texture *texture, const int32_t texcoord_q22[2], glint_texel *texel);

/* What the errors of coordinates can change of light of this brightness, both in 1/256 code. Nearest: nothing but on
 * the texels' edges, of which nothing is promised. */
uint32_t glint_texture_error_q8(const glint_texture_map *map, uint32_t bright_q8);

#endif
