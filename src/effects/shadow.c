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

static uint16_t cluster_count(const glint_mesh *mesh)
{
    return (uint16_t)((mesh->triangle_count + GLINT_SHADOW_CLUSTER - 1u) / GLINT_SHADOW_CLUSTER);
}

static uint32_t mask_words(uint16_t width_px)
{
    return (width_px + 31u) / 32;
}

uint64_t glint_shadow_bytes(const glint_scene *scene, uint16_t width_px, uint16_t band_px)
{
    const uint64_t lights = glint_shadow_light_count(scene);
    uint64_t clusters = 0;
    for (uint16_t i = 0; i < scene->object_count; i++) {
        clusters += cluster_count(scene->objects[i].mesh);
    }
    return lights == 0 ? 0
                       : scene->object_count * (uint64_t)sizeof(glint_shadow_object) +
                             lights * (sizeof(glint_shadow_light) + mask_words(width_px) * 4u * (uint64_t)band_px) +
                             clusters * sizeof(glint_shadow_box);
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

static void triangle_at(const glint_shadow_object *object, uint16_t triangle, uint16_t vertex[3], int32_t v[3][3])
{
    for (int i = 0; i < 3; i++) {
        vertex[i] = flash_u16(&object->mesh->triangles[triangle][i]);
        vertex_at(object, vertex[i], v[i]);
    }
}

typedef struct extent {
    int32_t low[3], high[3];
} extent;

static void extent_clear(extent *e)
{
    for (int k = 0; k < 3; k++) {
        e->low[k] = INT32_MAX;
        e->high[k] = INT32_MIN;
    }
}

static void extent_add(extent *e, const int32_t low[3], const int32_t high[3])
{
    for (int k = 0; k < 3; k++) {
        e->low[k] = low[k] < e->low[k] ? low[k] : e->low[k];
        e->high[k] = high[k] > e->high[k] ? high[k] : e->high[k];
    }
}

static void box_from(glint_shadow_box *box, const extent *e)
{
    for (int k = 0; k < 3; k++) {
        box->centre[k] = (e->low[k] + e->high[k]) / 2; /* < 2^29; each below 2^29, so the sum fits */
        box->half[k] = (e->high[k] - e->low[k]) / 2 + 2;
    }
}

/* The boxes of an object; clusters from `cluster` on. Returns their end. */
static glint_shadow_box *boxes_set_up(glint_shadow_object *object, glint_shadow_box *cluster)
{
    extent whole;
    extent_clear(&whole);
    object->cluster = cluster;
    for (uint16_t first = 0, c = 0; c < cluster_count(object->mesh); c++) {
        const uint16_t left = (uint16_t)(object->mesh->triangle_count - first);
        extent part;
        extent_clear(&part);
        for (uint16_t i = 0; i < left && i < GLINT_SHADOW_CLUSTER; i++) {
            uint16_t vertex[3];
            int32_t v[3][3];
            triangle_at(object, (uint16_t)(first + i), vertex, v);
            for (int k = 0; k < 3; k++) {
                extent_add(&part, v[k], v[k]);
            }
        }
        box_from(cluster++, &part);
        extent_add(&whole, part.low, part.high);
        first = (uint16_t)(first + GLINT_SHADOW_CLUSTER);
    }
    box_from(&object->box, &whole);
    return cluster;
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
    glint_shadow_box *cluster = (glint_shadow_box *)(void *)(shadows->lights + shadows->light_count);

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
        cluster = boxes_set_up(object, cluster);
    }
    uint32_t *mask = (uint32_t *)(void *)cluster;
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

/* normal.(p - base) = 0; |normal| < 2^30. */
typedef struct plane {
    int32_t normal[3], base[3];
    int64_t noise;  /* what rounding of base and p makes of normal.(p - base), */
    uint32_t tilt;  /* and that of the normal, for each unit of p - base */
    bool turned;    /* the normal is the negative of what it was made as */
} plane;

static uint32_t sum_of(const int32_t v[3])
{
    return magnitude32(v[0]) + magnitude32(v[1]) + magnitude32(v[2]);
}

/* Through `base`, along a and b, |.| < 2^30: their cross product is below 2^61. */
static void plane_along(plane *p, const int32_t base[3], const int32_t a[3], const int32_t b[3])
{
    int64_t n[3];
    p->turned = false;
    for (int k = 0; k < 3; k++) {
        const int i = k < 2 ? k + 1 : 0, j = k > 0 ? k - 1 : 2;
        n[k] = (int64_t)a[i] * b[j] - (int64_t)a[j] * b[i];
        p->base[k] = base[k];
    }
    const int down = vector_narrow(n, false, p->normal);
    const uint64_t tilt = ((((uint64_t)sum_of(a) + sum_of(b)) * (2 * GLINT_SHADOW_NOISE)) >> down) + 1;
    p->tilt = tilt < (uint32_t)1 << 29 ? (uint32_t)tilt : (uint32_t)1 << 29;
    p->noise = (int64_t)sum_of(p->normal) * (2 * GLINT_SHADOW_NOISE);
}

/* normal.(v - base), < 2^62; and how much of it is rounding. */
static int64_t plane_height(const plane *p, const int32_t v[3], int64_t *noise)
{
    int32_t d[3];
    int64_t height = 0;
    for (int k = 0; k < 3; k++) {
        d[k] = v[k] - p->base[k];
        height += (int64_t)p->normal[k] * d[k];
    }
    *noise = p->noise + (int64_t)sum_of(d) * p->tilt;
    return height;
}

/* What a box adds to its centre's height on either side. */
static int64_t plane_support(const plane *p, const glint_shadow_box *box)
{
    int64_t support = 0;
    for (int k = 0; k < 3; k++) {
        support += (int64_t)magnitude32(p->normal[k]) * box->half[k];
    }
    return support;
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
static void plane_of_edge(plane *p, const glint_shadow_light *light, const int32_t a[3], const int32_t b[3])
{
    int32_t edge[3], towards[3];
    const bool turn = before(b, a);
    from_to(turn ? b : a, turn ? a : b, edge);
    towards_light(light, turn ? b : a, towards);
    plane_along(p, turn ? b : a, edge, towards);
    if (turn) {
        plane_turn(p);
    }
}

/* Planes through the corners of a triangle and the light. Returns n.s in sign, n along (b - a) x (c - a): 0 where the
 * light is in the triangle's plane, but for rounding. Then nothing else is set. */
static int planes_of(const glint_shadow_light *light, int32_t corner[3][3], plane *own, plane side[3])
{
    int32_t ab[3], ac[3], towards[3];
    int64_t across = 0;
    from_to(corner[0], corner[1], ab);
    from_to(corner[0], corner[2], ac);
    towards_light(light, corner[0], towards);
    plane_along(own, corner[0], ab, ac);
    for (int k = 0; k < 3; k++) {
        across += (int64_t)own->normal[k] * towards[k];
    }
    if ((int64_t)magnitude64(across) <= own->noise + (int64_t)sum_of(towards) * own->tilt) {
        return 0;
    }
    for (int i = 0; i < 3; i++) {
        plane_of_edge(&side[i], light, corner[i], corner[i == 2 ? 0 : i + 1]);
        if (across > 0) { /* inside is against (b - a) x s for a triangle that faces the light */
            plane_turn(&side[i]);
        }
    }
    return across > 0 ? 1 : -1;
}

/* -------------------------------------------------------------------------------------------------------------- search
 */

/* What may throw a shadow on the receiver lies above its plane, as the light sees it, and within the planes through its
 * edges and the light. */
typedef struct search {
    glint_shadows *shadows;
    glint_shadow_light *light;
    const glint_shadow_receiver *receiver;
    plane own, side[3]; /* own is turned to the light */
    int64_t eye;        /* of the eye over own, turned as it is: -normal.base */
    bool found;
} search;

static bool box_may_cast(const search *s, const glint_shadow_box *box)
{
    int64_t noise;
    int64_t height = plane_height(&s->own, box->centre, &noise) + plane_support(&s->own, box);
    if (height <= noise) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        height = plane_height(&s->side[i], box->centre, &noise) + plane_support(&s->side[i], box);
        if (height < -noise) {
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
 * Where a plane cuts the receiver's, on the screen, its inner side the plane's positive one. A plane that has been turned
 * gives the negative numbers, to the bit: the shadows of neighbours share the pixels on their line, and leave no gap.
 */
static void line_of(line *out, const search *s, const plane *p)
{
    const glint_shadows *shadows = s->shadows;
    const glint_box *box = s->receiver->box;
    int64_t at = 0, l[3];
    int32_t normal[3];
    for (int k = 0; k < 3; k++) {
        normal[k] = p->turned ? -p->normal[k] : p->normal[k];
        at -= (int64_t)normal[k] * p->base[k]; /* < 2^61 */
    }
    /* (e m - d n) sign(e), e and d to 31 bits */
    const int long_bits = bit_length64(magnitude64(at) | magnitude64(s->eye));
    const int down = long_bits > 31 ? long_bits - 31 : 0;
    const int64_t d = glint_shift_round64(at, -down), e = glint_shift_round64(s->eye, -down);
    int bits = 0;
    for (int k = 0; k < 3; k++) {
        l[k] = e * normal[k] - d * s->own.normal[k]; /* <= 2 2^61 */
        l[k] >>= 1;
        /* a ray has components of half pixels from the display's middle, 12 bits, and of twice the grid's ratio */
        const int with = bit_length64(magnitude64(l[k])) + (k < 2 ? 13 : shadows->z_fraction - shadows->xy_fraction + 1);
        bits = with > bits || k == 0 ? with : bits;
    }
    const int up = 58 - bits;
    const int64_t x = glint_shift_round64(l[0], up), y = glint_shift_round64(l[1], up);
    const int64_t z = glint_shift_round64(l[2], up + shadows->z_fraction - shadows->xy_fraction + 1);
    const int64_t value =
        x * (2 * box->x_first + 1 - (int32_t)shadows->width_px) + y * (2 * box->y_first + 1 - (int32_t)shadows->height_px) + z;
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
        side[i].value = (uint32_t)l[i].value + (uint32_t)l[i].step_x * (uint32_t)begin +
                        (uint32_t)l[i].step_y * (uint32_t)rows;
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
    plane bound[4];
    line l[4];
    triangle_at(object, triangle, vertex, v);
    if (own && vertex[0] == s->receiver->vertex[0] && vertex[1] == s->receiver->vertex[1] &&
        vertex[2] == s->receiver->vertex[2]) {
        return;
    }
    if (!triangle_may_cast(s, v)) {
        return;
    }
    const int facing = planes_of(s->light, v, &bound[3], bound);
    if (facing == 0 || (own && !object->own_front && (facing > 0) != object->mirrored)) {
        return;
    }
    if (facing > 0) { /* beyond it as seen from the light */
        plane_turn(&bound[3]);
    }
    for (int i = 0; i < 4; i++) {
        line_of(&l[i], s, &bound[i]);
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
    const int facing = planes_of(s.light, corner, &s.own, s.side);
    if (facing == 0) {
        return false;
    }
    if (facing < 0) {
        plane_turn(&s.own);
    }
    s.eye = 0;
    for (int k = 0; k < 3; k++) {
        s.eye -= (int64_t)s.own.normal[k] * s.own.base[k];
    }
    if (s.eye == 0) {
        return false; /* seen from the side: there are no pixels of it */
    }
    for (uint16_t i = 0; i < shadows->object_count; i++) {
        const glint_shadow_object *object = &shadows->objects[i];
        if (!object->casts || !box_may_cast(&s, &object->box)) {
            continue;
        }
        for (uint16_t c = 0, triangle = 0; c < cluster_count(object->mesh); c++) {
            const uint16_t left = (uint16_t)(object->mesh->triangle_count - triangle);
            const uint16_t count = left < GLINT_SHADOW_CLUSTER ? left : GLINT_SHADOW_CLUSTER;
            const bool may = box_may_cast(&s, &object->cluster[c]);
            for (uint16_t t = 0; may && t < count; t++) {
                cast_triangle(&s, i, (uint16_t)(triangle + t));
            }
            triangle = (uint16_t)(triangle + count);
        }
    }
    s.light->falls = s.found;
    return s.found;
}
