/* SPDX-License-Identifier: MIT */
#include "effects/texture.h"

#include <stddef.h>

#include "geometry/view.h"
#include "number/fixed.h"

/* Bits of C, and of the gradients' fraction. */
#define RANGE_BITS 28
#define GRADIENT_BITS 48

/* Beyond this ratio of the corners' inverse depths, a pixel that lies outside of the unsnapped triangle, by at most
 * 2^-8 of a coordinate, may have Q below the least corner's or P above a half of Q. */
#define STEEP 64

void glint_texcoord_of(const glint_mesh *mesh, uint16_t vertex, int32_t texcoord_q22[2])
{
    const int32_t unit = (int32_t)1 << (GLINT_TEXCOORD_BITS - mesh->texcoord_bits);
    for (int k = 0; k < 2; k++) {
        texcoord_q22[k] = flash_s16(&mesh->texcoords[vertex][k]) * unit;
    }
}

/* A gradient, Q30 within 4 units or so, to Q48. numerator: what it is of 1/area, in Q12; the rest that its rounding
 * left of that is at most 2^3 area, so that 64 bits hold it although they do not hold what it is the rest of. */
static int64_t refine(int32_t gradient_q30, int32_t numerator_q12, int64_t area, uint32_t r, int bits)
{
    const int64_t rest =
        (int64_t)(((uint64_t)(int64_t)numerator_q12 << 42) - (uint64_t)(int64_t)gradient_q30 * (uint64_t)area);
    /* over area = upper 2^(bits - 32), with 1 / upper = r / 2^62 */
    const int down = bits - 28;
    const int64_t short_rest = down > 0 ? rest >> down : rest * ((int64_t)1 << -down); /* < 2^31 */
    GLINT_TRACE("gradient's rest", short_rest);
    return (int64_t)gradient_q30 * ((int64_t)1 << 18) + ((short_rest * (int64_t)r) >> 40);
}

/* d g / 2^32 for |d| <= 2^46, |g| <= 2^48, modulo 2^64: 4 units too little at most. */
static uint64_t times_gradient(int64_t d_q16, int64_t gradient_q48)
{
    const int64_t d_high = d_q16 >> 16, d_low = d_q16 & 0xffff;
    const int64_t g_high = gradient_q48 >> 18, g_low = gradient_q48 & 0x3ffff;
    return ((uint64_t)(d_high * g_high) << 2) + (uint64_t)((d_high * g_low) >> 16) + (uint64_t)((d_low * g_high) >> 14);
}

/* step way / 2^12, modulo 2^64. */
static uint64_t step_fine(uint64_t step, int32_t way)
{
    const int64_t part = way & (GLINT_FINE - 1);
    return step * (uint64_t)(int64_t)(way >> GLINT_FINE_BITS) + (uint64_t)(((int64_t)step >> GLINT_FINE_BITS) * part) +
           (((step & (uint64_t)(GLINT_FINE - 1)) * (uint64_t)part) >> GLINT_FINE_BITS);
}

typedef struct fine_gradients {
    int64_t x_q48[2], y_q48[2];
    int32_t way_x, way_y; /* from corner 0 to the centre of pixel (0, 0), 1/4096 px */
} fine_gradients;

static void refine_gradients(fine_gradients *fine, const glint_gradients *gradients)
{
    const glint_screen_vertex *const a = gradients->corner[0];
    const int64_t area = gradients->area > 0 ? gradients->area : 1; /* it is above 0 but for slivers */
    int bits;
    const uint32_t r = glint_reciprocal_q31(normalize64((uint64_t)area, &bits));
    for (int i = 0; i < 2; i++) {
        /* the edge opposite corner 1 runs from 2 to 0, that opposite corner 2 from 0 to 1 */
        const glint_screen_vertex *const from = gradients->corner[i == 0 ? 2 : 0];
        const glint_screen_vertex *const to = gradients->corner[i == 0 ? 0 : 1];
        fine->x_q48[i] = refine(gradients->x[i], from->y - to->y, area, r, bits);
        fine->y_q48[i] = refine(gradients->y[i], to->x - from->x, area, r, bits);
        GLINT_TRACE("gradient q48", fine->x_q48[i]);
        GLINT_TRACE("gradient q48", fine->y_q48[i]);
    }
    fine->way_x = GLINT_FINE / 2 - a->x;
    fine->way_y = GLINT_FINE / 2 - a->y;
}

/* The plane through three values in Q16, |v| <= 2^46. */
static void plane_set_up(glint_texture_plane *plane, const fine_gradients *fine, const int64_t v_q16[3])
{
    const int64_t d1 = v_q16[1] - v_q16[0], d2 = v_q16[2] - v_q16[0];
    GLINT_TRACE("texture plane's difference q16", d1);
    GLINT_TRACE("texture plane's difference q16", d2);
    plane->step_x = times_gradient(d1, fine->x_q48[0]) + times_gradient(d2, fine->x_q48[1]);
    plane->step_y = times_gradient(d1, fine->y_q48[0]) + times_gradient(d2, fine->y_q48[1]);
    plane->value =
        ((uint64_t)v_q16[0] << 16) + step_fine(plane->step_x, fine->way_x) + step_fine(plane->step_y, fine->way_y);
}

/* The corners' range, and C of each corner. Returns half the range, Q22. */
static uint32_t axis_range(glint_texture_axis *axis, const int32_t t_q22[3], int32_t c[3])
{
    int32_t low = t_q22[0], high = low;
    for (int i = 1; i < 3; i++) {
        low = t_q22[i] < low ? t_q22[i] : low;
        high = t_q22[i] > high ? t_q22[i] : high;
    }
    axis->middle_q22 = low + ((high - low) >> 1);
    const uint32_t half = (uint32_t)(high - axis->middle_q22); /* 0..2^28 */
    const int down = clz32(half | 1) - (32 - RANGE_BITS);
    axis->down = (uint8_t)(down > 0 ? down : 0); /* -1 for half = 2^28, which has 29 bits and is the limit */
    axis->half = ((int32_t)1 << axis->down) >> 1;
    for (int i = 0; i < 3; i++) {
        c[i] = (t_q22[i] - axis->middle_q22) * ((int32_t)1 << axis->down);
    }
    axis->low = (low - axis->middle_q22) * ((int32_t)1 << axis->down);
    axis->high = (int32_t)half * ((int32_t)1 << axis->down);
    return half;
}

/* See glint_texture_map_set_up(): 1/65536 texel. `zeros` are those before the least inverse depth, which errs by a
 * unit. */
static uint32_t axis_error(uint32_t half_q22, uint32_t size_px, int zeros, bool clipped)
{
    const uint32_t range_px = (uint32_t)(((uint64_t)half_q22 * size_px) >> (GLINT_TEXCOORD_BITS - 1)); /* <= 2^17 */
    const uint64_t of_depth = ((uint64_t)range_px << 16) >> (31 - zeros);
    const uint32_t most = (uint32_t)1 << 30;
    const uint32_t of_clipping = clipped ? (size_px >> 5) + (range_px >> 6) + 2 : 0;
    /* 2^-13 texel is 8; 2^-23 of the texture; 2^-26 of half the range */
    return 8 + (size_px >> 7) + 1 + (range_px >> 10) + 1 + of_clipping + (uint32_t)(of_depth < most ? of_depth : most);
}

void glint_texture_map_set_up(glint_texture_map *map, const glint_texture *texture, const glint_gradients *gradients,
                              int32_t texcoord_q22[3][2], const uint8_t order[3], bool clipped)
{
    fine_gradients fine = {{0, 0}, {0, 0}, 0, 0}; /* of a sliver there are none */
    int64_t value_q16[3];
    int32_t c[3];
    uint32_t any = 1, least = UINT32_MAX;
    map->texture = texture;
    map->gradients = gradients;
    map->error_q16 = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t depth = gradients->corner[i]->depth_q30 - GLINT_DEPTH_BIAS;
        const uint32_t inverse = depth > 0 ? (uint32_t)depth : 1;
        any |= inverse;
        least = inverse < least ? inverse : least;
    }
    const int up = clz32(any) - 2;
    map->least = (int32_t)(least << up);
    map->steep = (uint32_t)map->least < ((uint32_t)1 << 30) / STEEP;
    for (int i = 0; i < 3; i++) {
        const int32_t depth = gradients->corner[i]->depth_q30 - GLINT_DEPTH_BIAS;
        map->weight[i] = (int32_t)((depth > 0 ? (uint32_t)depth : 1) << up);
        value_q16[i] = (int64_t)map->weight[i] * 65536;
    }
    if (!gradients->sliver) {
        refine_gradients(&fine, gradients);
        plane_set_up(&map->inverse, &fine, value_q16);
    }
    for (int k = 0; k < 2; k++) {
        glint_texture_axis *const axis = &map->axis[k];
        const int32_t t_q22[3] = {texcoord_q22[order[0]][k], texcoord_q22[order[1]][k], texcoord_q22[order[2]][k]};
        const uint32_t half_q22 = axis_range(axis, t_q22, c);
        for (int i = 0; i < 3; i++) {
            const int64_t product = (int64_t)map->weight[i] * c[i]; /* <= 2^58 */
            GLINT_TRACE("weighted texture coordinate", product);
            value_q16[i] = product >> 14;
            axis->corner[i] = (int32_t)(product >> 30);
        }
        if (!gradients->sliver) {
            plane_set_up(&axis->plane, &fine, value_q16);
        }
        map->error_q16 += axis_error(half_q22, k == 0 ? texture->width_px : texture->height_px, clz32(least), clipped);
    }
}

uint32_t glint_texture_error_q8(const glint_texture_map *map, uint32_t bright_q8)
{
    if (map->texture->filter == GLINT_NEAREST) {
        return 0;
    }
    /* a texel's step changes the light by all of it at most, along each axis */
    return (uint32_t)(((uint64_t)bright_q8 * map->error_q16) >> 16) + 1;
}

/* value n for n < 2^12, modulo 2^64. */
static uint64_t times_px(uint64_t value, uint32_t n)
{
    const uint32_t high = (uint32_t)(value >> 32), low = (uint32_t)value;
    return ((uint64_t)(high * n) << 32) + ((uint64_t)((low >> 16) * n) << 16) + (low & 0xffff) * n;
}

static uint64_t plane_at(const glint_texture_plane *plane, int16_t x, int16_t y)
{
    return plane->value + times_px(plane->step_x, (uint16_t)x) + times_px(plane->step_y, (uint16_t)y);
}

/* The upper 32 bits of value 2^up, up < 32. */
static inline uint32_t upper_of(uint64_t value, int up)
{
    const uint32_t high = (uint32_t)(value >> 32), low = (uint32_t)value;
    return high << up | low >> 1 >> (31 - up);
}

static int32_t limited(int32_t value, int32_t low, int32_t high)
{
    return value < low ? low : value > high ? high : value;
}

/* C = 2^30 P / Q, to Q22. p and q are P and Q with `up` bits more, so that q has 32: |p| < 2^31, r = 2^62 / q. */
static inline int32_t axis_coordinate(const glint_texture_axis *axis, uint32_t p, uint32_t r)
{
    const int32_t c = limited(multiply_high_s32_u31((int32_t)p, r), axis->low, axis->high);
    const int32_t t_q22 = axis->middle_q22 + ((c + axis->half) >> axis->down);
    GLINT_TRACE("texture coordinate q22", t_q22);
    return t_q22;
}

/* Brings P and Q of a pixel outside of the unsnapped triangle back to what corners can have. */
static void within_corners(const glint_texture_map *map, uint64_t *q, uint64_t p[2])
{
    const int64_t least = (int64_t)((uint64_t)(uint32_t)map->least << 32);
    if ((int64_t)*q < least) {
        *q = (uint64_t)least;
    }
    const int64_t most = (int64_t)(*q >> 2);
    for (int k = 0; k < 2; k++) {
        const int64_t v = (int64_t)p[k];
        p[k] = (uint64_t)(v < -most ? -most : v > most ? most : v);
    }
}

static void coordinates_of_sliver(const glint_texture_map *map, int16_t x, int16_t y, int32_t texcoord_q22[2])
{
    int32_t weight_q30[2];
    glint_gradients_weights(map->gradients, x, y, weight_q30);
    int64_t value[3];
    for (int i = 0; i < 3; i++) {
        const int32_t *const v = i < 2 ? map->axis[i].corner : map->weight;
        /* < 2^61 */
        value[i] = (int64_t)v[0] * (((int32_t)1 << 30) - weight_q30[0] - weight_q30[1]) +
                   (int64_t)v[1] * weight_q30[0] + (int64_t)v[2] * weight_q30[1];
    }
    int bits;
    const uint32_t r = glint_reciprocal_q31(normalize64(value[2] > 0 ? (uint64_t)value[2] : 1, &bits));
    for (int k = 0; k < 2; k++) {
        const int32_t p = (int32_t)(bits > 32 ? value[k] >> (bits - 32) : (int64_t)((uint64_t)value[k] << (32 - bits)));
        texcoord_q22[k] = axis_coordinate(&map->axis[k], (uint32_t)p, r);
    }
}

void glint_texture_coordinates(const glint_texture_map *map, int16_t x, int16_t y, uint16_t count,
                               int32_t texcoord_q22[][2])
{
    if (map->gradients->sliver) {
        for (uint16_t i = 0; i < count; i++) {
            coordinates_of_sliver(map, (int16_t)(x + (int16_t)i), y, texcoord_q22[i]);
        }
        return;
    }
    uint64_t row[3] = {plane_at(&map->axis[0].plane, x, y), plane_at(&map->axis[1].plane, x, y),
                       plane_at(&map->inverse, x, y)};
    for (uint16_t i = 0; i < count; i++) {
        uint64_t q = row[2], p[2] = {row[0], row[1]};
        if (map->steep) {
            within_corners(map, &q, p);
        }
        const int up = clz32((uint32_t)(q >> 32)) & 31;
        const uint32_t r = glint_reciprocal_q31(upper_of(q, up));
        texcoord_q22[i][0] = axis_coordinate(&map->axis[0], upper_of(p[0], up), r);
        texcoord_q22[i][1] = axis_coordinate(&map->axis[1], upper_of(p[1], up), r);
        row[0] += map->axis[0].plane.step_x;
        row[1] += map->axis[1].plane.step_x;
        row[2] += map->inverse.step_x;
    }
}

/* ---- texels ---- */

#define ONE_Q22 ((int32_t)1 << GLINT_TEXCOORD_BITS)

/* A coordinate within the texture, in texels with 22 fractional bits: below 2^32 for 1024 of them. */
static uint32_t position_of(int32_t t_q22, uint8_t wrap, uint16_t size_px)
{
    const int32_t within =
        wrap == GLINT_CLAMP ? limited(t_q22, 0, ONE_Q22 - 1) : (int32_t)((uint32_t)t_q22 & (uint32_t)(ONE_Q22 - 1));
    GLINT_TRACE("position in a texture q22", (int64_t)within * size_px);
    return (uint32_t)within * size_px;
}

/* The colour of a texel in RGB565. */
static uint16_t fetch(const glint_texture *texture, uint32_t column, uint32_t row)
{
    const size_t at = (size_t)row * texture->width_px + (size_t)column;
    if (texture->format == GLINT_TEXTURE_RGB565) {
        return flash_u16((const uint16_t *)texture->texels + at);
    }
    const uint16_t number = flash_u8((const uint8_t *)texture->texels + at),
                   last = (uint16_t)(texture->palette_count - 1);
    return flash_u16(&texture->palette[number < last ? number : last]);
}

/* Red, green, blue in 5, 6, 5 bits. */
static inline void channels_of(uint16_t rgb565, uint32_t k[3])
{
    k[0] = rgb565 >> 11;
    k[1] = rgb565 >> 5 & 63;
    k[2] = rgb565 & 31;
}

/* One texel's colour. 2^15 / 31 = 33825.03 / 32, 2^15 / 63 = 33288.13 / 64: 0 stays 0, the greatest becomes 32768. */
static void texel_from(uint16_t rgb565, glint_texel *texel)
{
    uint32_t k[3];
    channels_of(rgb565, k);
    texel->q15[0] = (uint16_t)((k[0] * 33825u + 16) >> 5);
    texel->q15[1] = (uint16_t)((k[1] * 33288u + 32) >> 6);
    texel->q15[2] = (uint16_t)((k[2] * 33825u + 16) >> 5);
}

/* The two texels whose centres surround a position along an axis, and the weight of the second, Q13. */
typedef struct pair {
    uint32_t first, second, weight_q13;
} pair;

static pair pair_of(uint32_t position, uint8_t wrap, uint16_t size_px)
{
    const uint32_t half = (uint32_t)1 << (GLINT_TEXCOORD_BITS - 1), last = size_px - 1u;
    const uint32_t beyond = wrap == GLINT_CLAMP ? 0 : last; /* what stands before the first */
    const uint32_t from = position - half;                  /* modulo 2^32 below the first centre */
    const bool before = position < half;
    pair p;
    p.first = before ? beyond : from >> GLINT_TEXCOORD_BITS;
    p.second = before ? 0 : p.first < last ? p.first + 1 : last - beyond;
    p.weight_q13 = ((from & (uint32_t)(ONE_Q22 - 1)) + (1 << 8)) >> 9;
    return p;
}

/* a + weight (b - a), with 13 bits more than a and b; modulo 2^32. */
static inline uint32_t between(uint32_t a, uint32_t b, uint32_t weight_q13)
{
    return (a << 13) + weight_q13 * (b - a);
}

static void sample_bilinear(const glint_texture *texture, const uint32_t position[2], glint_texel *texel)
{
    const pair u = pair_of(position[0], texture->wrap_u, texture->width_px);
    const pair v = pair_of(position[1], texture->wrap_v, texture->height_px);
    const uint16_t c00 = fetch(texture, u.first, v.first), c10 = fetch(texture, u.second, v.first);
    const uint16_t c01 = fetch(texture, u.first, v.second), c11 = fetch(texture, u.second, v.second);
    if (c00 == c10 && c00 == c01 && c00 == c11) { /* as in most of a picture of few colours */
        texel_from(c00, texel);
        return;
    }
    uint32_t k00[3], k10[3], k01[3], k11[3];
    channels_of(c00, k00);
    channels_of(c10, k10);
    channels_of(c01, k01);
    channels_of(c11, k11);
    for (int c = 0; c < 3; c++) {
        const uint32_t k_q26 = between(between(k00[c], k10[c], u.weight_q13), between(k01[c], k11[c], u.weight_q13),
                                       v.weight_q13); /* at most 63 2^26 < 2^32 - 2^15 */
        const uint32_t k_q10 = (k_q26 + ((uint32_t)1 << 15)) >> 16;
        /* 2^5 / 31 = 33825.03 / 2^15, 2^5 / 63 = 33288.13 / 2^16; k below 2^15 and 2^16 */
        texel->q15[c] = (uint16_t)(c == 1 ? (k_q10 * 33288u + (1u << 15)) >> 16 : (k_q10 * 33825u + (1u << 14)) >> 15);
    }
}

void glint_texture_sample(const glint_texture *texture, const int32_t texcoord_q22[2], glint_texel *texel)
{
    const uint32_t position[2] = {position_of(texcoord_q22[0], texture->wrap_u, texture->width_px),
                                  position_of(texcoord_q22[1], texture->wrap_v, texture->height_px)};
    if (texture->filter == GLINT_NEAREST) {
        texel_from(fetch(texture, position[0] >> GLINT_TEXCOORD_BITS, position[1] >> GLINT_TEXCOORD_BITS), texel);
    } else {
        sample_bilinear(texture, position, texel);
    }
    GLINT_TRACE("texture's colour q15", texel->q15[0]);
    GLINT_TRACE("texture's colour q15", texel->q15[1]);
    GLINT_TRACE("texture's colour q15", texel->q15[2]);
}
