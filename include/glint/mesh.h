/* SPDX-License-Identifier: MIT */
/*
 * Triangle meshes as constant data in fixed formats.
 */
#ifndef GLINT_MESH_H
#define GLINT_MESH_H

#include <stdint.h>

#include <glint/config.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * A triangle mesh in model space (right-handed).
 *
 * Position: position[v][k] / 2^fraction_bits model units, k = x, y, z.
 * Normal:   normal_q14[v][k] / 2^14, the unit normal at vertex v. A length other than 1 is normalised on reading; a
 *           zero vector stands for the normal of whichever face uses it.
 * Triangle: three vertex indices, counter-clockwise seen from outside. The face normal is (b - a) x (c - a).
 * Texture:  texcoords[v] / 2^texcoord_bits are u and v of <glint/texture.h> at vertex v, -64..64 with 9 bits, -1..1
 * with
 *           15. Only where a material has a texture are they looked at.
 *
 * On the AVR the arrays are read from program memory: declare them GLINT_FLASH.
 */
typedef struct glint_mesh {
    const int16_t (*positions)[3];
    const int16_t (*normals_q14)[3];
    const uint16_t (*triangles)[3];
    uint16_t vertex_count;         /* 3..65535 */
    uint16_t triangle_count;       /* 1..65535 */
    int8_t fraction_bits;          /* 0..24; 0: a position is in whole model units */
    int8_t texcoord_bits;          /* 9..15, of texcoords */
    const int16_t (*texcoords)[2]; /* NULL: none */
} glint_mesh;

#define GLINT_MAX_FRACTION_BITS 24
#define GLINT_LEAST_TEXCOORD_BITS 9
#define GLINT_MAX_TEXCOORD_BITS 15

#ifdef __cplusplus
}
#endif

#endif
