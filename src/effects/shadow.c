/* SPDX-License-Identifier: MIT */
#include "effects/shadow.h"

#include <stddef.h>
#include <string.h>

/* ------------------------------------------------------------------------------------------------------------- set-up
 */

uint16_t glint_shadow_light_count(const glint_scene *scene)
{
    uint16_t count = 0;
    for (uint16_t i = 0; i < scene->light_count; i++) {
        count = (uint16_t)(count + scene->lights[i].casts_shadows);
    }
    return count;
}

/* Boxes of a mesh: of GLINT_SHADOW_LEAF triangles each, then of two of these, up to one of all. */
static uint32_t box_count(const glint_mesh *mesh)
{
    uint32_t level = (mesh->triangle_count + GLINT_SHADOW_LEAF - 1u) / GLINT_SHADOW_LEAF, count = level;
    while (level > 1) {
        level = (level + 1) / 2;
        count += level;
    }
    return count;
}

static uint32_t coarse_bytes(uint32_t vertices)
{
    return (vertices * 6 + 3) & ~(uint32_t)3;
}

static uint32_t mask_words(uint16_t width_px)
{
    return (width_px + 31u) / 32;
}

uint64_t glint_shadow_bytes(const glint_scene *scene, uint16_t width_px, uint16_t band_px)
{
    const uint64_t lights = glint_shadow_light_count(scene);
    uint64_t of_meshes = 0;
    for (uint16_t i = 0; i < scene->object_count; i++) {
        const glint_mesh *mesh = scene->objects[i].mesh;
        of_meshes += box_count(mesh) * (uint64_t)sizeof(glint_shadow_box) + coarse_bytes(mesh->vertex_count);
    }
    return lights == 0
               ? 0
               : scene->object_count * (uint64_t)sizeof(glint_shadow_object) +
                     lights * (sizeof(glint_shadow_light) + mask_words(width_px) * 4u * (uint64_t)band_px) + of_meshes;
}

/* A light as an object of one point: its position, or the tip of a vector along x. */
static const glint_mesh point_mesh = {NULL, NULL, NULL, 1, 0, GLINT_MAX_FRACTION_BITS};

static void light_transform(glint_transform *transform, const glint_light *light, const glint_view *view)
{
    glint_object point;
    memset(&point, 0, sizeof point);
    point.mesh = &point_mesh;
    for (int k = 0; k < 3; k++) {
        if (light->kind == GLINT_DIRECTIONAL) {
            point.place.linear_q16[k][0] = -(int32_t)light->direction[k] * (1 << 10);
            point.place.origin_q16[k] = view->eye_q16[k];
        } else {
            point.place.origin_q16[k] = light->position_q16[k];
        }
    }
    glint_transform_set_up(transform, view, &point);
}

static int16_t smaller(int16_t a, int16_t b)
{
    return a < b ? a : b;
}

/* The greatest component to 30 bits, where there are more, or where `up`. Returns by how much it was shifted down. */
static int vector_narrow(const int64_t in[3], bool up, int32_t out[3])
{
    const int bits = bit_length64(magnitude64(in[0]) | magnitude64(in[1]) | magnitude64(in[2]));
    const int down = bits > 29 || up ? bits - 29 : 0;
    for (int k = 0; k < 3; k++) {
        out[k] = (int32_t)glint_shift_round64(in[k], -down);
        GLINT_TRACE("shadow vector", out[k]);
    }
    return down;
}

static void light_set_up(glint_shadow_light *out, const glint_shadows *shadows, const glint_light *light,
                         const glint_view *view)
{
    glint_transform t;
    light_transform(&t, light, view);
    const int xy = shadows->xy_fraction - t.xy_fraction, z = shadows->z_fraction - t.z_fraction;
    out->directional = light->kind == GLINT_DIRECTIONAL;
    out->falls = false;
    if (out->directional) {
        const int most = xy > z ? xy : z;
        const int64_t v[3] = {glint_shift_round64((int64_t)t.x[0] * ((int64_t)1 << 30), xy - most),
                              glint_shift_round64((int64_t)t.y[0] * ((int64_t)1 << 30), xy - most),
                              glint_shift_round64((int64_t)t.z[0] * ((int64_t)1 << 30), z - most)};
        (void)vector_narrow(v, true, out->v);
    } else {
        out->v[0] = shift_round32(t.x[3], -xy);
        out->v[1] = shift_round32(t.y[3], -xy);
        out->v[2] = shift_round32(t.z[3], -z);
    }
}

static void object_set_up(glint_shadow_object *out, const glint_shadows *shadows, const glint_transform *t,
                          const glint_object *object)
{
    for (int k = 0; k < 4; k++) {
        out->row[0][k] = shift_round32(t->x[k], t->xy_fraction - shadows->xy_fraction);
        out->row[1][k] = shift_round32(t->y[k], t->xy_fraction - shadows->xy_fraction);
        out->row[2][k] = shift_round32(t->z[k], t->z_fraction - shadows->z_fraction);
    }
    out->mesh = object->mesh;
    out->casts = (object->material->shadows & GLINT_CASTS_NO_SHADOW) == 0;
    out->own_front = object->material->sides != GLINT_FRONT_SIDE;
}

/* A vertex on the grid: |.| < 2^29. */
static void vertex_at(const glint_shadow_object *object, uint16_t vertex, int32_t out[3])
{
    int16_t p[3];
    for (int k = 0; k < 3; k++) {
        p[k] = flash_s16(&object->mesh->positions[vertex][k]);
    }
    for (int k = 0; k < 3; k++) {
        const int32_t *row = object->row[k];
        out[k] = multiply_q16(row[0], p[0]) + multiply_q16(row[1], p[1]) + multiply_q16(row[2], p[2]) + row[3];
        GLINT_TRACE("shadow position", out[k]);
    }
}

/* The box of a part of a mesh. */
static void box_clear(glint_shadow_box *box)
{
    for (int k = 0; k < 3; k++) {
        box->low[k] = INT16_MAX;
        box->high[k] = INT16_MIN;
    }
}

static void box_add(glint_shadow_box *box, const int16_t low[3], const int16_t high[3])
{
    for (int k = 0; k < 3; k++) {
        box->low[k] = low[k] < box->low[k] ? low[k] : box->low[k];
        box->high[k] = high[k] > box->high[k] ? high[k] : box->high[k];
    }
}

/* Coarse vertices, and the boxes over them. */
static void mesh_set_up(glint_shadow_object *object, const glint_shadows *shadows)
{
    const glint_mesh *mesh = object->mesh;
    for (uint16_t v = 0; v < mesh->vertex_count; v++) {
        int32_t fine[3];
        vertex_at(object, v, fine);
        for (int k = 0; k < 3; k++) {
            object->coarse[v][k] = (int16_t)(fine[k] >> shadows->coarse_bits[k]);
        }
    }
    uint32_t level = 0;
    for (uint16_t first = 0; first < mesh->triangle_count; level++) {
        const uint16_t left = (uint16_t)(mesh->triangle_count - first);
        const uint16_t count = left < GLINT_SHADOW_LEAF ? left : GLINT_SHADOW_LEAF;
        box_clear(&object->box[level]);
        for (uint16_t i = 0; i < 3 * count; i++) {
            const int16_t *at = object->coarse[flash_u16(&mesh->triangles[first + i / 3][i % 3])];
            box_add(&object->box[level], at, at);
        }
        if (left <= GLINT_SHADOW_LEAF) {
            level++;
            break;
        }
        first = (uint16_t)(first + count);
    }
    glint_shadow_box *from = object->box;
    while (level > 1) {
        glint_shadow_box *const to = from + level;
        for (uint32_t i = 0; i < level; i++) {
            if (i % 2 == 0) {
                to[i / 2] = from[i];
            } else {
                box_add(&to[i / 2], from[i].low, from[i].high);
            }
        }
        from = to;
        level = (level + 1) / 2;
    }
}

/* How far down coordinates are shifted to have 16 bits, and what rounding may make of a height then. */
static void coarse_set_up(glint_shadows *shadows)
{
    uint32_t any[3] = {0, 0, 0};
    for (uint16_t i = 0; i < shadows->object_count; i++) {
        for (uint16_t v = 0; v < shadows->objects[i].mesh->vertex_count; v++) {
            int32_t fine[3];
            vertex_at(&shadows->objects[i], v, fine);
            for (int k = 0; k < 3; k++) {
                any[k] |= magnitude32(fine[k]);
            }
        }
    }
    for (int k = 0; k < 3; k++) {
        const int bits = 32 - clz32(any[k] | 1);
        shadows->coarse_bits[k] = (uint8_t)(bits > 15 ? bits - 15 : 0);
    }
}

void glint_shadows_set_up(glint_shadows *shadows, const glint_scene *scene, const glint_view *view, uint8_t *memory,
                          uint16_t band_px)
{
    glint_transform t;
    shadows->object_count = scene->object_count;
    shadows->light_count = glint_shadow_light_count(scene);
    shadows->words = (uint16_t)mask_words(view->width_px);
    shadows->width_px = view->width_px;
    shadows->height_px = view->height_px;
    shadows->tests = 0;
    shadows->objects = (glint_shadow_object *)(void *)memory;
    shadows->lights = (glint_shadow_light *)(void *)(shadows->objects + shadows->object_count);
    uint8_t *free_part = (uint8_t *)(void *)(shadows->lights + shadows->light_count);

    /* the grid: the coarsest of all, and one bit less, so that differences have 30 bits */
    shadows->xy_fraction = shadows->z_fraction = INT16_MAX;
    for (uint16_t i = 0; i < scene->light_count; i++) {
        if (scene->lights[i].casts_shadows && scene->lights[i].kind != GLINT_DIRECTIONAL) {
            light_transform(&t, &scene->lights[i], view);
            shadows->xy_fraction = smaller(shadows->xy_fraction, (int16_t)(t.xy_fraction - 1));
            shadows->z_fraction = smaller(shadows->z_fraction, (int16_t)(t.z_fraction - 1));
        }
    }
    for (uint16_t i = 0; i < scene->object_count; i++) {
        glint_transform_set_up(&t, view, &scene->objects[i]);
        shadows->xy_fraction = smaller(shadows->xy_fraction, (int16_t)(t.xy_fraction - 1));
        shadows->z_fraction = smaller(shadows->z_fraction, (int16_t)(t.z_fraction - 1));
    }
    for (uint16_t i = 0; i < scene->object_count; i++) {
        glint_frame frame;
        glint_shadow_object *object = &shadows->objects[i];
        glint_transform_set_up(&t, view, &scene->objects[i]);
        glint_frame_set_up(&frame, view, &scene->objects[i]);
        object_set_up(object, shadows, &t, &scene->objects[i]);
        object->mirrored = frame.mirrored;
        object->box = (glint_shadow_box *)(void *)free_part;
        free_part += box_count(object->mesh) * sizeof(glint_shadow_box);
        object->coarse = (int16_t(*)[3])(void *)free_part;
        free_part += coarse_bytes(object->mesh->vertex_count);
    }
    coarse_set_up(shadows);
    for (uint16_t i = 0; i < scene->object_count; i++) {
        mesh_set_up(&shadows->objects[i], shadows);
    }
    uint32_t *mask = (uint32_t *)(void *)free_part;
    for (uint16_t i = 0, k = 0; i < scene->light_count; i++) {
        if (scene->lights[i].casts_shadows) {
            light_set_up(&shadows->lights[k], shadows, &scene->lights[i], view);
            shadows->lights[k++].mask = mask;
            mask += (uint32_t)shadows->words * band_px;
        }
    }
}

/* ------------------------------------------------------------------------------------------------------------- planes
 */

/* a b: whole, by four products of 16 bits where the processor has no wider ones. */
static int64_t product(int32_t a, int32_t b)
{
#if GLINT_WIDE_MULTIPLY
    return (int64_t)a * b;
#else
    const uint32_t low = (uint32_t)a * (uint32_t)b;
    return (int64_t)((uint64_t)(uint32_t)multiply_high_s32(a, b) << 32 | low);
#endif
}

static int64_t product_sum(const int32_t a[3], const int32_t b[3])
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

static uint32_t sum_of(const int32_t v[3])
{
    return magnitude32(v[0]) + magnitude32(v[1]) + magnitude32(v[2]);
}

/* Through `base`, along a and b, |.| < 2^30: their cross product is below 2^61. Returns by how much that was shifted
 * down; does not set what rounding makes. */
static int plane_along(plane *p, const int32_t base[3], const int32_t a[3], const int32_t b[3])
{
    int64_t n[3];
    p->turned = false;
    for (int k = 0; k < 3; k++) {
        const int i = k < 2 ? k + 1 : 0, j = k > 0 ? k - 1 : 2;
        n[k] = product(a[i], b[j]) - product(a[j], b[i]);
        p->base[k] = base[k];
    }
    return vector_narrow(n, false, p->normal);
}

/* What rounding makes, for plane_height(). */
static void plane_noise(plane *p, const int32_t a[3], const int32_t b[3], int down)
{
    const uint64_t tilt = ((((uint64_t)sum_of(a) + sum_of(b)) * (2 * GLINT_SHADOW_NOISE)) >> down) + 1;
    p->tilt = tilt < (uint32_t)1 << 29 ? (uint32_t)tilt : (uint32_t)1 << 29;
    p->noise = (int64_t)sum_of(p->normal) * (2 * GLINT_SHADOW_NOISE);
}

/* normal.(v - base), < 2^62; and how much of it is rounding. */
static int64_t plane_height(const plane *p, const int32_t v[3], int64_t *noise)
{
    int32_t d[3];
    for (int k = 0; k < 3; k++) {
        d[k] = v[k] - p->base[k];
    }
    const uint32_t way = sum_of(d); /* < 3 2^30 */
    *noise = p->noise + (product((int32_t)(way >> 2), (int32_t)p->tilt) + p->tilt) * 4;
    return product_sum(p->normal, d);
}

static void plane_turn(plane *p)
{
    p->turned = !p->turned;
    for (int k = 0; k < 3; k++) {
        p->normal[k] = -p->normal[k];
    }
}

static void from_to(const int32_t a[3], const int32_t b[3], int32_t out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = b[k] - a[k];
    }
}

/* From a point towards the light. */
static void towards_light(const glint_shadow_light *light, const int32_t from[3], int32_t out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = light->directional ? light->v[k] : light->v[k] - from[k];
    }
}

static bool before(const int32_t a[3], const int32_t b[3])
{
    return a[0] != b[0] ? a[0] < b[0] : a[1] != b[1] ? a[1] < b[1] : a[2] < b[2];
}

/* The plane through the light and an edge, its normal along (b - a) x s. Neighbours get the same one, turned, to the
 * bit: it is made from the smaller end on. */
static void plane_of_edge(plane *p, const glint_shadow_light *light, const int32_t a[3], const int32_t b[3], bool noisy)
{
    int32_t edge[3], towards[3];
    const bool turn = before(b, a);
    from_to(turn ? b : a, turn ? a : b, edge);
    towards_light(light, turn ? b : a, towards);
    const int down = plane_along(p, turn ? b : a, edge, towards);
    if (noisy) {
        plane_noise(p, edge, towards, down);
    }
    if (turn) {
        plane_turn(p);
    }
}

/* A triangle's own plane. Returns n.s in sign, n along (b - a) x (c - a): 0 where the light is in that plane, but for
 * rounding. */
static int plane_of_face(plane *own, const glint_shadow_light *light, int32_t corner[3][3])
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
static void plane_of_side(plane *side, const glint_shadow_light *light, int32_t corner[3][3], int i, int facing,
                          bool noisy)
{
    plane_of_edge(side, light, corner[i], corner[i == 2 ? 0 : i + 1], noisy);
    if (facing > 0) { /* inside is against (b - a) x s for a triangle that faces the light */
        plane_turn(side);
    }
}

/* -------------------------------------------------------------------------------------------------------------- search
 */

/* What may throw a shadow on the receiver lies above its plane, as the light sees it, and within the planes through its
 * edges and the light. */
/* A plane in coarse coordinates: a point of which normal.p < least lies behind it, rounding considered. */
typedef struct coarse_plane {
    int32_t normal[3], least;
} coarse_plane;

typedef struct search {
    glint_shadows *shadows;
    glint_shadow_light *light;
    const glint_shadow_receiver *receiver;
    plane own, side[3]; /* own is turned to the light */
    coarse_plane coarse[4];
    int64_t eye; /* of the eye over own, turned as it is: -normal.base */
    bool found;
} search;

#define COARSE_NORMAL_BITS 13

/*
 * A normal of 13 bits and coordinates of 16: a height is below 3 2^28. It errs by half a unit of the normal for each
 * unit of the way from the base, at most 3 2^16, and by a unit of the way for each of the normal, at most 3 2^13.
 */
static void coarse_from(coarse_plane *out, const plane *p, const uint8_t down[3])
{
    int64_t n[3], at = 0;
    uint64_t any = 1;
    for (int k = 0; k < 3; k++) {
        n[k] = (int64_t)p->normal[k] * ((int64_t)1 << down[k]); /* < 2^45 */
        any |= magnitude64(n[k]);
    }
    const int shift = COARSE_NORMAL_BITS - bit_length64(any);
    for (int k = 0; k < 3; k++) {
        out->normal[k] = (int32_t)glint_shift_round64(n[k], shift);
        at += ((int64_t)out->normal[k] * p->base[k]) >> down[k];
    }
    out->least = (int32_t)at - (((int32_t)3 << 15) + ((int32_t)3 << COARSE_NORMAL_BITS) + 4);
}

static bool box_may_cast(const search *s, const glint_shadow_box *box)
{
    for (int i = 0; i < 4; i++) {
        const int32_t *n = s->coarse[i].normal;
        if (n[0] * (n[0] > 0 ? box->high[0] : box->low[0]) + n[1] * (n[1] > 0 ? box->high[1] : box->low[1]) +
                n[2] * (n[2] > 0 ? box->high[2] : box->low[2]) <
            s->coarse[i].least) {
            return false;
        }
    }
    return true;
}

static int32_t coarse_height(const int32_t n[3], const int16_t v[3])
{
    return n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
}

static bool coarse_may_cast(const search *s, const glint_shadow_object *object, const uint16_t vertex[3])
{
    const int16_t *const a = object->coarse[vertex[0]], *const b = object->coarse[vertex[1]],
                         *const c = object->coarse[vertex[2]];
    for (int i = 0; i < 4; i++) {
        const int32_t *n = s->coarse[i].normal, least = s->coarse[i].least;
        if (coarse_height(n, a) < least && coarse_height(n, b) < least && coarse_height(n, c) < least) {
            return false;
        }
    }
    return true;
}

static bool triangle_may_cast(const search *s, int32_t v[3][3])
{
    int64_t noise[3], height[3];
    for (int k = 0; k < 3; k++) {
        height[k] = plane_height(&s->own, v[k], &noise[k]);
    }
    if (height[0] <= noise[0] && height[1] <= noise[1] && height[2] <= noise[2]) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            height[k] = plane_height(&s->side[i], v[k], &noise[k]);
        }
        if (height[0] < -noise[0] && height[1] < -noise[1] && height[2] < -noise[2]) {
            return false;
        }
    }
    return true;
}

/* --------------------------------------------------------------------------------------------------------------- lines
 */

/* Pixels of a box on the inner side of a line: value + x step_x + y step_y >= 0 at (x, y) from the box's first one;
 * below 2^30 over the box. */
typedef struct line {
    int32_t value, step_x, step_y;
} line;

/*
 * Where a plane cuts the receiver's, on the screen, its inner side the plane's positive one. A plane that has been
 * turned gives the negative numbers, to the bit: the shadows of neighbours share the pixels on their line, and leave no
 * gap.
 */
static void line_of(line *out, const search *s, const plane *p)
{
    const glint_shadows *shadows = s->shadows;
    const glint_box *box = s->receiver->box;
    int64_t l[3];
    int32_t normal[3];
    for (int k = 0; k < 3; k++) {
        normal[k] = p->turned ? -p->normal[k] : p->normal[k];
    }
    const int64_t at = -product_sum(normal, p->base); /* < 2^61 */
    /* (e m - d n) sign(e), e and d to 30 bits */
    const int long_bits = bit_length64(magnitude64(at) | magnitude64(s->eye));
    const int down = long_bits > 30 ? long_bits - 30 : 0;
    const int32_t d = (int32_t)glint_shift_round64(at, -down), e = (int32_t)glint_shift_round64(s->eye, -down);
    int bits = 0;
    for (int k = 0; k < 3; k++) {
        l[k] = product(e, normal[k]) - product(d, s->own.normal[k]); /* <= 2 2^60 */
        /* a ray has components of half pixels from the display's middle, 12 bits, and of twice the grid's ratio */
        const int with =
            bit_length64(magnitude64(l[k])) + (k < 2 ? 13 : shadows->z_fraction - shadows->xy_fraction + 1);
        bits = with > bits || k == 0 ? with : bits;
    }
    const int up = 58 - bits;
    const int64_t x = glint_shift_round64(l[0], up), y = glint_shift_round64(l[1], up);
    const int64_t z = glint_shift_round64(l[2], up + shadows->z_fraction - shadows->xy_fraction + 1);
    const int64_t value = x * (2 * box->x_first + 1 - (int32_t)shadows->width_px) +
                          y * (2 * box->y_first + 1 - (int32_t)shadows->height_px) + z;
    const uint64_t most = magnitude64(value) + 2 * magnitude64(x) * (uint64_t)(box->x_last - box->x_first + 1) +
                          2 * magnitude64(y) * (uint64_t)(box->y_last - box->y_first + 1);
    const int narrow = 29 - bit_length64(most);
    const int32_t sign = (s->eye < 0) != p->turned ? -1 : 1;
    out->value = (int32_t)glint_shift_round64(value, narrow) * sign;
    out->step_x = (int32_t)glint_shift_round64(2 * x, narrow) * sign;
    out->step_y = (int32_t)glint_shift_round64(2 * y, narrow) * sign;
}

static bool line_meets(const line *l, const glint_box *box)
{
    return l->value + positive_part(l->step_x) * (int32_t)(box->x_last - box->x_first) +
               positive_part(l->step_y) * (int32_t)(box->y_last - box->y_first) >=
           0;
}

/* Sets bits first..last of a row. */
static void fill_row(uint32_t *row, int first, int last)
{
    const int from = first >> 5, to = last >> 5;
    const uint32_t head = 0xffffffffu << (first & 31), tail = 0xffffffffu >> (31 - (last & 31));
    if (from == to) {
        row[from] |= head & tail;
        return;
    }
    row[from] |= head;
    for (int i = from + 1; i < to; i++) {
        row[i] = 0xffffffffu;
    }
    row[to] |= tail;
}

/* Fills what four lines enclose in the band's rows of the box. */
static void fill(const glint_shadows *shadows, uint32_t *mask, const glint_box *box, const line l[4])
{
    const int columns = box->x_last - box->x_first + 1;
    const int16_t y_first = box->y_first > shadows->y_first ? box->y_first : shadows->y_first;
    const int16_t y_last = box->y_last < shadows->y_last ? box->y_last : shadows->y_last;
    glint_side side[4];
    for (int i = 0; i < 4; i++) {
        const int32_t begin = l[i].step_x < 0 ? columns - 1 : 0, rows = (int32_t)y_first - box->y_first;
        side[i].value =
            (uint32_t)l[i].value + (uint32_t)l[i].step_x * (uint32_t)begin + (uint32_t)l[i].step_y * (uint32_t)rows;
        side[i].inwards = magnitude32(l[i].step_x);
        side[i].down = (uint32_t)l[i].step_y;
        side[i].inset = 0;
    }
    for (int16_t y = y_first; y <= y_last; y++) {
        int left = 0, right = 0;
        for (int i = 0; i < 4; i++) {
            if (l[i].step_x == 0) { /* all of the row, or nothing */
                left = (int32_t)side[i].value < 0 ? columns : left;
                side[i].value += side[i].down;
                continue;
            }
            const int inset = glint_side_move(&side[i], columns);
            int *const end = l[i].step_x > 0 ? &left : &right;
            *end = inset > *end ? inset : *end;
        }
        if (left + right < columns) {
            fill_row(mask + (uint32_t)(y - shadows->y_first) * shadows->words, box->x_first + left,
                     box->x_last - right);
        }
    }
}

/* Clears the band's rows of the box, and what shares words with it: no other triangle's bits are needed any more. */
static void clear(const glint_shadows *shadows, uint32_t *mask, const glint_box *box)
{
    const int from = box->x_first >> 5, to = box->x_last >> 5;
    for (int16_t y = box->y_first; y <= box->y_last && y <= shadows->y_last; y++) {
        if (y >= shadows->y_first) {
            uint32_t *const row = mask + (uint32_t)(y - shadows->y_first) * shadows->words;
            for (int i = from; i <= to; i++) {
                row[i] = 0;
            }
        }
    }
}

/* ----------------------------------------------------------------------------------------------------------- triangles
 */

static void cast_triangle(search *s, uint16_t number, uint16_t triangle)
{
    const glint_shadow_object *object = &s->shadows->objects[number];
    const bool own = number == s->receiver->object;
    uint16_t vertex[3];
    int32_t v[3][3];
    line l[4];
    for (int i = 0; i < 3; i++) {
        vertex[i] = flash_u16(&object->mesh->triangles[triangle][i]);
    }
    if (!coarse_may_cast(s, object, vertex)) {
        return;
    }
    if (own && vertex[0] == s->receiver->vertex[0] && vertex[1] == s->receiver->vertex[1] &&
        vertex[2] == s->receiver->vertex[2]) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        vertex_at(object, vertex[i], v[i]);
    }
    if (!triangle_may_cast(s, v)) {
        return;
    }
    plane bound;
    const int facing = plane_of_face(&bound, s->light, v);
    if (facing == 0 || (own && !object->own_front && (facing > 0) != object->mirrored)) {
        return;
    }
    if (facing > 0) { /* beyond it as seen from the light */
        plane_turn(&bound);
    }
    for (int i = 3; i >= 0; i--) {
        if (i < 3) {
            plane_of_side(&bound, s->light, v, i, facing, false);
        }
        line_of(&l[i], s, &bound);
        if (i == 3) { /* where it stands on the receiver, it is not beyond itself */
            l[i].value -= ((int32_t)(magnitude32(l[i].step_x) + magnitude32(l[i].step_y)) >> 12) + 2;
        }
        if (!line_meets(&l[i], s->receiver->box)) {
            return;
        }
    }
    if (!s->found) {
        s->found = true;
        clear(s->shadows, s->light->mask, s->receiver->box);
    }
    s->shadows->tests++;
    fill(s->shadows, s->light->mask, s->receiver->box, l);
}

#define MOST_LEVELS 16

/* Down the boxes of an object wherever they may cast. */
static void cast_object(search *s, uint16_t number)
{
    const glint_shadow_object *object = &s->shadows->objects[number];
    const uint16_t triangles = object->mesh->triangle_count;
    const glint_shadow_box *first[MOST_LEVELS];
    uint16_t count[MOST_LEVELS], i = 0;
    int top = 0;
    first[0] = object->box;
    count[0] = (uint16_t)((triangles + GLINT_SHADOW_LEAF - 1u) / GLINT_SHADOW_LEAF);
    for (; count[top] > 1; top++) {
        first[top + 1] = first[top] + count[top];
        count[top + 1] = (uint16_t)((count[top] + 1u) / 2);
    }
    for (int level = top; level <= top;) {
        if (box_may_cast(s, &first[level][i])) {
            if (level > 0) {
                level--;
                i = (uint16_t)(i * 2);
                continue;
            }
            for (uint32_t t = (uint32_t)i * GLINT_SHADOW_LEAF;
                 t < ((uint32_t)i + 1) * GLINT_SHADOW_LEAF && t < triangles; t++) {
                cast_triangle(s, number, (uint16_t)t);
            }
        }
        /* to the right neighbour, or up until there is one */
        while (level <= top && ((i & 1) != 0 || i + 1u >= count[level])) {
            level++;
            i >>= 1;
        }
        i++;
    }
}

bool glint_shadow_fall(glint_shadows *shadows, const glint_shadow_receiver *receiver, uint16_t light)
{
    const glint_shadow_object *on = &shadows->objects[receiver->object];
    search s;
    int32_t corner[3][3];
    s.shadows = shadows;
    s.light = &shadows->lights[light];
    s.receiver = receiver;
    s.found = false;
    for (int i = 0; i < 3; i++) {
        vertex_at(on, receiver->vertex[i], corner[i]);
    }
    const int facing = plane_of_face(&s.own, s.light, corner);
    if (facing == 0) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        plane_of_side(&s.side[i], s.light, corner, i, facing, true);
    }
    if (facing < 0) {
        plane_turn(&s.own);
    }
    s.eye = -product_sum(s.own.normal, s.own.base);
    if (s.eye == 0) {
        return false; /* seen from the side: there are no pixels of it */
    }
    coarse_from(&s.coarse[0], &s.own, shadows->coarse_bits);
    for (int i = 0; i < 3; i++) {
        coarse_from(&s.coarse[i + 1], &s.side[i], shadows->coarse_bits);
    }
    for (uint16_t i = 0; i < shadows->object_count; i++) {
        if (shadows->objects[i].casts) {
            cast_object(&s, i);
        }
    }
    s.light->falls = s.found;
    return s.found;
}
