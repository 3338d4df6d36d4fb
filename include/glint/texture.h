/* SPDX-License-Identifier: MIT */
/*
 * Textures: a picture that colours what a surface reflects.
 *
 * Where a material has a texture, its ambient and diffuse reflectance are multiplied, channel by channel, by the
 * texture's colour T at the surface point; specular reflection, a mirror's and emission are not:
 *
 *     L = e + T (r_a I_a(n) + sum_j I_j a_j b_j r_d max(0, n.s_j)) + sum_j I_j a_j b_j r_s max(0, r_j.c)^alpha
 *         + r_m E(r)
 *
 * Coordinates. (u, v) runs from (0, 0) at the outer corner of the first texel of the first row to (1, 1) at the outer
 * corner of the last texel of the last row: u along the rows, v from row to row, downwards where the first row is the
 * top one (as in glTF; OBJ counts v upwards, which the importer turns round). The texel in column i of row j covers
 * [i / width, (i + 1) / width) x [j / height, (j + 1) / height), and its centre is at ((i + 1/2) / width, (j + 1/2) /
 * height). Between a triangle's corners (u, v) is linear on the surface, that is perspective-correct on the display.
 *
 * Filters. Nearest: the texel that holds (u, v), i = floor(u width), j = floor(v height). Bilinear: the four texels
 * whose centres surround (u, v), weighted by 1 minus the distance along each axis, in texels (P. S. Heckbert, "Survey
 * of texture mapping", IEEE Computer Graphics and Applications 6(11), 1986). Neither averages over the pixel: a texture
 * that is shown far below its size glitters, so keep one texel or less to a pixel.
 *
 * Beyond the edges. Repeat: i and j are taken modulo width and height, so that the picture tiles. Clamp: i and j are
 * limited to the picture, so that its edge goes on. Both filters do so with each texel that they take.
 *
 * Colour. A channel of 5 or 6 bits is k / 31 or k / 63.
 */
#ifndef GLINT_TEXTURE_H
#define GLINT_TEXTURE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How a texel is stored. */
enum {
    GLINT_TEXTURE_RGB565 = 0,  /* uint16_t: red in bits 15..11, green 10..5, blue 4..0 */
    GLINT_TEXTURE_PALETTE8 = 1 /* uint8_t: a number into `palette` */
};

enum { GLINT_NEAREST = 0, GLINT_BILINEAR = 1 };

enum { GLINT_REPEAT = 0, GLINT_CLAMP = 1 };

#define GLINT_MAX_TEXTURE_PX 1024
#define GLINT_MAX_PALETTE 256

/* On the AVR texels and palette are read from program memory: declare them GLINT_FLASH. */
typedef struct glint_texture {
    const void *texels;           /* width_px height_px of them, row by row without gap: uint16_t or uint8_t */
    const uint16_t *palette;      /* GLINT_TEXTURE_PALETTE8: colours in RGB565 */
    uint16_t palette_count;       /* GLINT_TEXTURE_PALETTE8: 1..256; a texel beyond the last colour has the last one */
    uint16_t width_px, height_px; /* 1..1024, any size */
    uint8_t format;               /* GLINT_TEXTURE_RGB565 (default) or GLINT_TEXTURE_PALETTE8 */
    uint8_t filter;               /* GLINT_NEAREST (default) or GLINT_BILINEAR */
    uint8_t wrap_u, wrap_v;       /* GLINT_REPEAT (default) or GLINT_CLAMP */
} glint_texture;

#ifdef __cplusplus
}
#endif

#endif
