/* SPDX-License-Identifier: MIT */
/*
 * Planes through the light and the corners of a triangle, for shadows: made once for each two triangles, one of which
 * may throw a shadow on the other.
 */
#ifndef GLINT_EFFECTS_SHADOW_PLANE_H
#define GLINT_EFFECTS_SHADOW_PLANE_H

#include "effects/shadow.h"

/* The greatest component to 29 bits, where there are more, or where `up`. Returns by how much it was shifted down. */
static inline int shadow_narrow(const int64_t in[3], bool up, int32_t out[3])
{
    const int bits = bit_length64(magnitude64(in[0]) | magnitude64(in[1]) | magnitude64(in[2]));
    const int down = bits > 29 || up ? bits - 29 : 0;
    for (int k = 0; k < 3; k++) {
        out[k] = (int32_t)glint_shift_round64(in[k], -down);
        GLINT_TRACE("shadow vector", out[k]);
    }
    return down;
}

/* a b: whole, by four products of 16 bits where the processor has no wider ones. */
static inline int64_t product(int32_t a, int32_t b)
{
#if GLINT_WIDE_MULTIPLY
    return (int64_t)a * b;
#else
    const uint32_t low = (uint32_t)a * (uint32_t)b;
    return (int64_t)((uint64_t)(uint32_t)multiply_high_s32(a, b) << 32 | low);
#endif
}

static inline int64_t product_sum(const int32_t a[3], const int32_t b[3])
{
    return product(a[0], b[0]) + product(a[1], b[1]) + product(a[2], b[2]);
}

/* normal.(p - base) = 0; |normal| < 2^30. */
typedef struct plane {
    int32_t normal[3], base[3];
    int64_t noise; /* what rounding of base and p makes of normal.(p - base), */
    uint32_t tilt; /* and that of the normal, for each unit of p - base */
    bool turned;   /* the normal is the negative of what it was made as */
} plane;

static inline uint32_t sum_of(const int32_t v[3])
{
    return magnitude32(v[0]) + magnitude32(v[1]) + magnitude32(v[2]);
}

/* Through `base`, along a and b, |.| < 2^30: their cross product is below 2^61. Returns by how much that was shifted
 * down; does not set what rounding makes. */
static inline int plane_along(plane *p, const int32_t base[3], const int32_t a[3], const int32_t b[3])
{
    int64_t n[3];
    p->turned = false;
    for (int k = 0; k < 3; k++) {
        const int i = k < 2 ? k + 1 : 0, j = k > 0 ? k - 1 : 2;
        n[k] = product(a[i], b[j]) - product(a[j], b[i]);
        p->base[k] = base[k];
    }
    return shadow_narrow(n, false, p->normal);
}

/* What rounding makes, for plane_height(). */
static inline void plane_noise(plane *p, const int32_t a[3], const int32_t b[3], int down)
{
    const uint64_t tilt = ((((uint64_t)sum_of(a) + sum_of(b)) * (2 * GLINT_SHADOW_NOISE)) >> down) + 1;
    p->tilt = tilt < (uint32_t)1 << 29 ? (uint32_t)tilt : (uint32_t)1 << 29;
    p->noise = (int64_t)sum_of(p->normal) * (2 * GLINT_SHADOW_NOISE);
}

/* normal.(v - base), < 2^62; and how much of it is rounding. */
static inline int64_t plane_height(const plane *p, const int32_t v[3], int64_t *noise)
{
    int32_t d[3];
    for (int k = 0; k < 3; k++) {
        d[k] = v[k] - p->base[k];
    }
    const uint32_t way = sum_of(d); /* < 3 2^30 */
    *noise = p->noise + (product((int32_t)(way >> 2), (int32_t)p->tilt) + p->tilt) * 4;
    const int64_t height = product_sum(p->normal, d);
    GLINT_TRACE("shadow height", height);
    return height;
}

static inline void plane_turn(plane *p)
{
    p->turned = !p->turned;
    for (int k = 0; k < 3; k++) {
        p->normal[k] = -p->normal[k];
    }
}

static inline void from_to(const int32_t a[3], const int32_t b[3], int32_t out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = b[k] - a[k];
    }
}

/* From a point towards the light. */
static inline void towards_light(const glint_shadow_light *light, const int32_t from[3], int32_t out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = light->directional ? light->v[k] : light->v[k] - from[k];
    }
}

static inline bool before(const int32_t a[3], const int32_t b[3])
{
    return a[0] != b[0] ? a[0] < b[0] : a[1] != b[1] ? a[1] < b[1] : a[2] < b[2];
}

/* The plane through the light and an edge, its normal along (b - a) x s. Neighbours get the same one, turned, to the
 * bit: it is made from the smaller end on. */
static inline void plane_of_edge(plane *p, const glint_shadow_light *light, const int32_t a[3], const int32_t b[3])
{
    int32_t edge[3], towards[3];
    const bool turn = before(b, a);
    from_to(turn ? b : a, turn ? a : b, edge);
    towards_light(light, turn ? b : a, towards);
    (void)plane_along(p, turn ? b : a, edge, towards);
    if (turn) {
        plane_turn(p);
    }
}

/* A triangle's own plane. Returns n.s in sign, n along (b - a) x (c - a): 0 where the light is in that plane, but for
 * rounding. */
static inline int plane_of_face(plane *own, const glint_shadow_light *light, int32_t corner[3][3])
{
    int32_t ab[3], ac[3], towards[3];
    from_to(corner[0], corner[1], ab);
    from_to(corner[0], corner[2], ac);
    towards_light(light, corner[0], towards);
    plane_noise(own, ab, ac, plane_along(own, corner[0], ab, ac));
    const int64_t across = product_sum(own->normal, towards);
    const uint32_t way = sum_of(towards);
    const int64_t noise = own->noise + (product((int32_t)(way >> 2), (int32_t)own->tilt) + own->tilt) * 4;
    return (int64_t)magnitude64(across) <= noise ? 0 : across > 0 ? 1 : -1;
}

/* The plane through the light and edge i of a triangle, its positive side towards the third corner. */
static inline void plane_of_side(plane *side, const glint_shadow_light *light, int32_t corner[3][3], int i, int facing)
{
    plane_of_edge(side, light, corner[i], corner[i == 2 ? 0 : i + 1]);
    if (facing > 0) { /* inside is against (b - a) x s for a triangle that faces the light */
        plane_turn(side);
    }
}

#endif
