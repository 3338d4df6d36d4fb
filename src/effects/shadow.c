/* SPDX-License-Identifier: MIT */
/*
 * The search for what throws shadows on a triangle, and the lines that bound these.
 */
#include "effects/shadow.h"

#include "effects/shadow_mask.h"
#include "effects/shadow_plane.h"

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
    plane own; /* turned to the light */
    coarse_plane coarse[4];
    glint_shadow_box before; /* what lies between the receiver and the light */
    int64_t eye;             /* of the eye over own, turned as it is: -normal.base */
    bool found;
} search;

typedef char glint_assert_shadow_search[sizeof(search) <= sizeof((glint_shadows *)0)->search ? 1 : -1];

#define COARSE_NORMAL_BITS 13

/* A plane's normal for sheared coordinates: along a it is normal.v / 2^29, and the others stay. Times a factor of
 * 1/2..1 of what it was, |v_a| / 2^29. */
static int64_t sheared_normal(const glint_shadows *shadows, const int32_t normal[3], int k)
{
    return k != shadows->along ? normal[k] : glint_shift_round64(product_sum(normal, shadows->shear), -29);
}

/*
 * A normal of 13 bits and coordinates of 16: a height is below 3 2^28. It errs by half a unit of the normal for each
 * unit of the way from the base, at most 3 2^16; and of each coordinate by a unit for its rounding and by two for the
 * shear's, for each unit of the normal.
 */
static void coarse_from(coarse_plane *out, const plane *p, const glint_shadows *shadows)
{
    int64_t n[3], at = 0;
    int32_t base[3];
    uint64_t any = 1;
    glint_shadow_shear(shadows, p->base, base);
    for (int k = 0; k < 3; k++) {
        n[k] = sheared_normal(shadows, p->normal, k) * ((int64_t)1 << shadows->coarse_bits[k]); /* < 2^48 */
        any |= magnitude64(n[k]);
    }
    const int shift = COARSE_NORMAL_BITS - bit_length64(any);
    for (int k = 0; k < 3; k++) {
        out->normal[k] = (int32_t)glint_shift_round64(n[k], shift);
        at += ((int64_t)out->normal[k] * base[k]) >> shadows->coarse_bits[k];
    }
    out->least = (int32_t)at - (((int32_t)3 << 15) + ((int32_t)9 << COARSE_NORMAL_BITS) + 4);
}

static int16_t within_s16(int32_t value)
{
    return (int16_t)(value > INT16_MAX ? INT16_MAX : value < INT16_MIN ? INT16_MIN : value);
}

/* A box of what lies between the receiver and the light. */
static void before_from(search *s, int32_t corner[3][3])
{
    const glint_shadows *const shadows = s->shadows;
    int32_t sheared[3][3], light[3];
    for (int i = 0; i < 3; i++) {
        glint_shadow_shear(shadows, corner[i], sheared[i]);
    }
    glint_shadow_shear(shadows, s->light->v, light);
    for (int k = 0; k < 3; k++) {
        /* rounding, here and of what casts: of coordinates, of the shear, and what heights allow for it */
        const int32_t margin = 2 + (4 * GLINT_SHADOW_NOISE >> shadows->coarse_bits[k]);
        int32_t low = s->light->directional ? sheared[0][k] : light[k], high = low;
        for (int i = 0; i < 3; i++) {
            low = sheared[i][k] < low ? sheared[i][k] : low;
            high = sheared[i][k] > high ? sheared[i][k] : high;
        }
        s->before.low[k] = within_s16((low >> shadows->coarse_bits[k]) - margin);
        s->before.high[k] = within_s16((high >> shadows->coarse_bits[k]) + margin);
        if (s->light->directional && light[k] > 0) {
            s->before.high[k] = INT16_MAX;
        } else if (s->light->directional && light[k] < 0) {
            s->before.low[k] = INT16_MIN;
        }
    }
}

static bool boxes_meet(const glint_shadow_box *a, const glint_shadow_box *b)
{
    return a->low[0] <= b->high[0] && b->low[0] <= a->high[0] && a->low[1] <= b->high[1] && b->low[1] <= a->high[1] &&
           a->low[2] <= b->high[2] && b->low[2] <= a->high[2];
}

/* Along the shear, what is in the box needs no look at the planes of the receiver's sides. */
static bool box_may_cast(const search *s, const glint_shadow_box *box)
{
    const int planes = s->light->sheared ? 1 : 4;
    if (!boxes_meet(&s->before, box)) {
        return false;
    }
    for (int i = 0; i < planes; i++) {
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

/* Does a triangle lie beside the box, by one coordinate? */
static bool lies_beside(const glint_shadow_box *box, const int16_t a[3], const int16_t b[3], const int16_t c[3])
{
    for (int k = 0; k < 3; k++) {
        if ((a[k] < box->low[k] && b[k] < box->low[k] && c[k] < box->low[k]) ||
            (a[k] > box->high[k] && b[k] > box->high[k] && c[k] > box->high[k])) {
            return true;
        }
    }
    return false;
}

static bool coarse_may_cast(const search *s, const glint_shadow_object *object, const uint16_t vertex[3])
{
    const int16_t *const a = object->coarse[vertex[0]], *const b = object->coarse[vertex[1]],
                         *const c = object->coarse[vertex[2]];
    if (lies_beside(&s->before, a, b, c)) {
        return false;
    }
    for (int i = 0; i < 4; i++) {
        const int32_t *n = s->coarse[i].normal, least = s->coarse[i].least;
        if (coarse_height(n, a) < least && coarse_height(n, b) < least && coarse_height(n, c) < least) {
            return false;
        }
    }
    return true;
}

/*
 * Twice the area of a triangle as the light sees it, along which coarse coordinates are sheared: above 0 where the
 * triangle turns its outside to it, but for a mirrored one. 0 where rounding may have its sign: by 2 units of each
 * coordinate's difference, or of more than 2^14 units.
 */
static int32_t area_in_light(const search *s, const glint_shadow_object *object, const uint16_t vertex[3])
{
    const int a = s->shadows->along, b = a < 2 ? a + 1 : 0, c = b < 2 ? b + 1 : 0;
    const int16_t *const p = object->coarse[vertex[0]], *const q = object->coarse[vertex[1]],
                         *const r = object->coarse[vertex[2]];
    const int32_t qb = (int32_t)q[b] - p[b], qc = (int32_t)q[c] - p[c];
    const int32_t rb = (int32_t)r[b] - p[b], rc = (int32_t)r[c] - p[c];
    const uint32_t any = magnitude32(qb) | magnitude32(qc) | magnitude32(rb) | magnitude32(rc);
    const uint8_t *const bits = s->shadows->coarse_bits;
    if (any >= (uint32_t)1 << 14 || bits[b] < 3 || bits[c] < 3) { /* the shear's own error counts below 3 bits */
        return 0;
    }
    const int32_t area = qb * rc - qc * rb;
    const uint32_t error = 2 * (magnitude32(qb) + magnitude32(qc) + magnitude32(rb) + magnitude32(rc)) + 8;
    return magnitude32(area) <= error ? 0 : s->light->v[a] > 0 ? area : -area;
}

/* Of a surface that shows its outside alone, triangles that turn it to the light throw no shadow on others of it. */
static bool own_front_at_once(const search *s, const glint_shadow_object *object, const uint16_t vertex[3])
{
    if (object->own_front || !s->light->sheared) {
        return false;
    }
    const int32_t area = area_in_light(s, object, vertex);
    return object->mirrored ? area < 0 : area > 0;
}

/* Does some of it lie above the receiver's plane? */
static bool stands_out(const search *s, int32_t v[3][3])
{
    for (int k = 0; k < 3; k++) {
        int64_t noise;
        if (plane_height(&s->own, v[k], &noise) > noise) {
            return true;
        }
    }
    return false;
}

/*
 * Where a plane cuts the receiver's, on the screen, its inner side the plane's positive one. A plane that has been
 * turned gives the negative numbers, to the bit: the shadows of neighbours share the pixels on their line, and leave no
 * gap.
 */
static void line_of(glint_shadow_line *out, const search *s, const plane *p)
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

static bool line_meets(const glint_shadow_line *l, const glint_box *box)
{
    return l->value + positive_part(l->step_x) * (int32_t)(box->x_last - box->x_first) +
               positive_part(l->step_y) * (int32_t)(box->y_last - box->y_first) >=
           0;
}

static void cast_triangle(search *s, uint16_t number, uint16_t triangle)
{
    const glint_shadow_object *object = &s->shadows->objects[number];
    const bool own = number == s->receiver->object;
    uint16_t vertex[3];
    int32_t v[3][3];
    glint_shadow_line l[4];
    for (int i = 0; i < 3; i++) {
        vertex[i] = flash_u16(&object->mesh->triangles[triangle][i]);
    }
    if (!coarse_may_cast(s, object, vertex) || (own && own_front_at_once(s, object, vertex))) {
        return;
    }
    if (own && vertex[0] == s->receiver->vertex[0] && vertex[1] == s->receiver->vertex[1] &&
        vertex[2] == s->receiver->vertex[2]) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        glint_shadow_vertex(object, vertex[i], v[i]);
    }
    if (!stands_out(s, v)) {
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
            plane_of_side(&bound, s->light, v, i, facing);
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
        glint_shadow_clear(s->shadows, s->light->mask, s->receiver->box);
    }
    s->shadows->tests++;
    glint_shadow_fill(s->shadows, s->light->mask, s->receiver->box, l);
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
    count[0] = (uint16_t)(((uint32_t)triangles + GLINT_SHADOW_LEAF - 1) / GLINT_SHADOW_LEAF);
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
    search *const s = (search *)(void *)shadows->search;
    int32_t corner[3][3];
    s->shadows = shadows;
    s->light = &shadows->lights[light];
    s->receiver = receiver;
    s->found = false;
    for (int i = 0; i < 3; i++) {
        glint_shadow_vertex(on, receiver->vertex[i], corner[i]);
    }
    const int facing = plane_of_face(&s->own, s->light, corner);
    if (facing == 0) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        plane side;
        plane_of_side(&side, s->light, corner, i, facing);
        coarse_from(&s->coarse[i + 1], &side, shadows);
    }
    if (facing < 0) {
        plane_turn(&s->own);
    }
    s->eye = -product_sum(s->own.normal, s->own.base);
    if (s->eye == 0) {
        return false; /* seen from the side: there are no pixels of it */
    }
    coarse_from(&s->coarse[0], &s->own, shadows);
    before_from(s, corner);
    for (uint16_t i = 0; i < shadows->object_count; i++) {
        if (shadows->objects[i].casts) {
            cast_object(s, i);
        }
    }
    s->light->falls = s->found;
    return s->found;
}
