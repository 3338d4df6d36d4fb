/* SPDX-License-Identifier: MIT */
/*
 * Hard shadows as coverage: which pixels of a triangle lie in the shadow of which light.
 *
 * A point p lies in the shadow that a triangle C throws when p is inside of the three planes through the light and C's
 * edges, and beyond C's own plane as seen from the light (the shadow volume of F. C. Crow, "Shadow algorithms for
 * computer graphics", SIGGRAPH 1977, of one triangle). Each of these four is a linear inequality m.p + d > 0. On a
 * receiving triangle with the plane n.p + e = 0, a point seen along a ray r at depth w is p = w r, and 1/w = -(n.r)/e.
 * So
 *     (m.p + d) |e| / w = sign(e) (e m - d n).r,
 * which is linear in the pixel: the shadow of C on the receiver is what four straight lines on the screen enclose.
 * Nothing is clipped, projected or divided, the planes of eye, light and display need no care, and the lines are filled
 * row by row as the edges of triangles are (raster/edges.h), into one bit a pixel of the band for each light.
 *
 * All of it is integer arithmetic that both backends share. Positions are (f X, f Y, Z) of the view, f the focal length
 * in px, on one grid for the whole scene: 29 bits for its farthest corner. Set-up of a casting triangle takes 64-bit
 * products; a row takes steps and comparisons of 32 bits.
 *
 * Errors. A coordinate errs by at most GLINT_SHADOW_NOISE units of the grid, 2^-26 of the scene's extent, which moves a
 * shadow's edge by so much over the sine of the angle at which the light grazes the receiver; and a line errs by 2^-5
 * px at most from its 31 bits. Neighbours get the same line between their shadows, to the bit, and no light leaks
 * through. Heights over the receiver's plane within the noise are none, so that neighbours in one plane, and what
 * touches, throw no shadow on each other. tests/image/test_shadows.c holds this to ray casting.
 */
#ifndef GLINT_EFFECTS_SHADOW_H
#define GLINT_EFFECTS_SHADOW_H

#include <stdbool.h>
#include <stdint.h>

#include <glint/memory.h>
#include <glint/scene.h>

#include "geometry/view.h"
#include "raster/edges.h"

/* Units of the grid that a coordinate may be off: rows of a glint_transform are rounded, scaled and rounded, and
 * shifted (2, 1.5 and 1.25 units), and each of three products is rounded down (3). */
#define GLINT_SHADOW_NOISE 8

/* Triangles of a mesh, in its order, that share a box; boxes over two such, and so on, make a tree in that order. */
#define GLINT_SHADOW_LEAF 8

/*
 * In coarse coordinates, of 16 bits and rounded down: to look through a mesh takes products of 32 bits. They are
 * sheared along the first directional light that casts, so that what lies before a triangle, as that light sees it, has
 * the triangle's coordinates but for one: boxes and rectangles tell most of it. With v the direction to the light and a
 * its greatest component, the others b are p_b |v_a| / 2^29 -+ p_a v_b / 2^29, and p_a stays. For other lights, and
 * where there is no such light, these are coordinates like any others.
 */
typedef struct glint_shadow_box {
    int16_t low[3], high[3];
} glint_shadow_box;

typedef struct glint_shadow_object {
    const glint_mesh *mesh;
    int32_t row[3][4]; /* a coordinate: (row[0] x + row[1] y + row[2] z) / 2^16 + row[3] */
    glint_shadow_box *box;
    int16_t (*coarse)[3];            /* of each vertex */
    bool casts, own_front, mirrored; /* own_front: its outsides cast on itself, too */
} glint_shadow_object;

typedef struct glint_shadow_light {
    int32_t v[3]; /* position, or the direction towards it */
    bool directional;
    bool sheared;   /* along this one coarse coordinates are sheared */
    bool falls;     /* on the triangle that is being drawn there are shadows of this light */
    uint32_t *mask; /* rows of `words`: bit x % 32 of word x / 32, from the band's first row on */
} glint_shadow_light;

typedef struct glint_shadows {
    glint_shadow_object *objects;
    glint_shadow_light *lights;
    uint16_t object_count, light_count, words;
    uint16_t width_px, height_px;
    int16_t xy_fraction, z_fraction; /* of the grid: f X 2^xy_fraction, Z 2^z_fraction */
    uint8_t coarse_bits[3];          /* by which a sheared coordinate is shifted down to 16 bits */
    uint8_t along;                   /* coordinate a, */
    int32_t shear[3];                /* v, with v_a above 0; 29 bits */
    int16_t y_first, y_last;         /* the band being drawn */
    uint64_t search[24];             /* what is being looked for, here to leave the stack alone: see shadow.c */
    uint32_t tests;                  /* casting triangles whose shadows were filled in */
} glint_shadows;

/* The triangle that shadows fall on: the box of its pixels, and its place in the scene. */
typedef struct glint_shadow_receiver {
    uint16_t object;
    const uint16_t *vertex;
    const glint_box *box;
} glint_shadow_receiver;

/* The bounds that <glint/memory.h> promises to static memory. */
typedef char glint_assert_shadow_light_bytes[sizeof(glint_shadow_light) <= GLINT_SHADOW_LIGHT_BYTES ? 1 : -1];
typedef char glint_assert_shadow_object_bytes[sizeof(glint_shadow_object) <= GLINT_SHADOW_OBJECT_BYTES ? 1 : -1];
typedef char glint_assert_shadow_box_bytes[sizeof(glint_shadow_box) <= GLINT_SHADOW_BOX_BYTES ? 1 : -1];

/* How many lights of a scene cast shadows. */
uint16_t glint_shadow_light_count(const glint_scene *scene);

/* Bytes for masks, lights, objects, their coarse vertices and boxes, all multiples of 4; 0 if no light casts shadows.
 */
uint64_t glint_shadow_bytes(const glint_scene *scene, uint16_t width_px, uint16_t band_px);

/* Sets all up for a frame, in that many bytes at `memory`. */
void glint_shadows_set_up(glint_shadows *shadows, const glint_scene *scene, const glint_view *view, uint8_t *memory,
                          uint16_t band_px);

/* The shear of a point on the grid: |.| < 2^30; it errs by 2 units. */
void glint_shadow_shear(const glint_shadows *shadows, const int32_t p[3], int32_t out[3]);

/* A vertex on the grid: |.| < 2^29. */
void glint_shadow_vertex(const glint_shadow_object *object, uint16_t vertex, int32_t out[3]);

/*
 * Looks for the shadows of light number `light` that may fall on the triangle, and fills in those that do in the band's
 * rows of its box. Returns whether there may be any; that does not depend on the band. Bits of pixels that do not
 * belong to the triangle mean nothing.
 */
bool glint_shadow_fall(glint_shadows *shadows, const glint_shadow_receiver *receiver, uint16_t light);

/* Is the pixel in the light's shadow? It lies on a triangle for which glint_shadow_fall() has said yes. */
static inline bool glint_shadow_at(const glint_shadows *shadows, const glint_shadow_light *light, int16_t x, int16_t y)
{
    const uint32_t word = light->mask[(uint32_t)(y - shadows->y_first) * shadows->words + ((uint16_t)x >> 5)];
    return (word >> ((uint16_t)x & 31) & 1) != 0;
}

#endif
