/* SPDX-License-Identifier: MIT */
/*
 * Settles a pixel: which surface is seen, and which others might rightly be seen by a renderer that rounds its vertices
 * and its depth. The definition stands in reference.h.
 *
 * Why a sealed group must cover: moving each corner by up to e moves no point of the group's outline by more than e.
 * If the pixel's centre is further than that from the outline, the outline never sweeps over it, and the number of
 * times that the group winds around it stays the same; a triangle turned away winds the other way. Where that number is
 * above 0, some triangle of the group that faces the eye covers the pixel; where both sides are drawn, it does so for
 * any number but 0.
 */
#include <string.h>

#include "internal.h"

static bool is_opaque(const reference_detail *d, const meeting *m)
{
    return d->surfaces[d->triangles[m->triangle].object].transmission == 0.0;
}

static int gather(reference_detail *d, int x, int y)
{
    int32_t first = d->first[(size_t)y * (size_t)d->width + (size_t)x];
    int count = 0, k;
    for (int32_t m = first; m >= 0; m = d->meetings[m].next) {
        count += is_opaque(d, &d->meetings[m]);
    }
    k = count;
    for (int32_t m = first; m >= 0; m = d->meetings[m].next) {
        if (!is_opaque(d, &d->meetings[m])) {
            continue;
        }
        contender *c = &d->contenders[--k];
        memset(c, 0, sizeof *c);
        c->triangle = d->meetings[m].triangle;
        c->inside = d->meetings[m].inside != 0;
        c->near_edges = d->meetings[m].near_edges;
        c->group = k;
    }
    return count;
}

/* The nearest surface that is drawn at the centre; the first of equals. */
static int find_front(const reference_detail *d, int count, double x, double y)
{
    double nearest = 0.0;
    int front = -1;
    vector ray = view_ray(d, x, y);
    for (int k = 0; k < count; k++) {
        const triangle *t = &d->triangles[d->contenders[k].triangle];
        if (d->contenders[k].inside && t->front) {
            double inverse_z = dot(t->plane, ray) / t->height;
            if (inverse_z > nearest) {
                nearest = inverse_z;
                front = k;
            }
        }
    }
    return front;
}

static bool same_position(const int16_t a[3], const int16_t b[3])
{
    return memcmp(a, b, 3 * sizeof *a) == 0;
}

/* Neighbours along an edge that is near the pixel. */
static bool joined(const reference_detail *d, const contender *a, const contender *b)
{
    const triangle *t = &d->triangles[a->triangle], *u = &d->triangles[b->triangle];
    if (t->object != u->object) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3 && (a->near_edges >> i & 1); j++) {
            if ((b->near_edges >> j & 1) && same_position(t->model[i], u->model[(j + 1) % 3]) &&
                same_position(t->model[(i + 1) % 3], u->model[j])) {
                return true;
            }
        }
    }
    return false;
}

static void join_groups(contender *c, int count, int from, int to)
{
    for (int k = 0; k < count; k++) {
        if (c[k].group == from) {
            c[k].group = to;
        }
    }
}

static bool unsealed(const triangle *t, uint8_t near_edges)
{
    for (int i = 0; i <= NEAR_EDGE; i++) {
        if ((near_edges >> i & 1) && !t->sealed[i]) {
            return true;
        }
    }
    return false;
}

/* Groups the contenders and finds the groups that must cover the pixel. */
void contest_groups(const reference_detail *d, contender *c, int count)
{
    for (int a = 0; a < count; a++) {
        for (int b = a + 1; b < count && c[a].near_edges; b++) {
            if (c[b].near_edges && c[a].group != c[b].group && joined(d, &c[a], &c[b])) {
                join_groups(c, count, c[b].group, c[a].group);
            }
        }
    }
    for (int a = 0; a < count; a++) {
        bool open = false, both_sides = d->surfaces[d->triangles[c[a].triangle].object].sides != GLINT_FRONT_SIDE;
        int winding = 0;
        for (int b = 0; b < count; b++) {
            if (c[b].group == c[a].group) {
                const triangle *t = &d->triangles[c[b].triangle];
                open = open || unsealed(t, c[b].near_edges);
                winding += !c[b].inside ? 0 : t->away ? -1 : 1;
            }
        }
        c[a].must = (both_sides ? winding != 0 : winding > 0) && !open;
    }
}

void contest_depths(const reference_detail *d, contender *c, double x, double y)
{
    const triangle *t = &d->triangles[c->triangle];
    corner region[MEET_REGION_MAX + 1];
    int count = meet_region(t, x, y, d->options.edge_px, region);
    region[count++] = c->inside && t->height > 0.0 ? meet_hit(d, t, x, y) : meet_nearest(t, x, y);
    c->depth_low = HUGE_VAL;
    c->depth_high = 0.0;
    for (int k = 0; k < count; k++) {
        double depth = DEPTH_STEPS * d->near_z * region[k].inverse_z;
        c->depth_low = fmin(c->depth_low, depth);
        c->depth_high = fmax(c->depth_high, depth);
    }
}

int contest(reference_detail *d, int x, int y, int *front, uint8_t *mask, bool *background)
{
    contender *c = d->contenders;
    double cx = x + 0.5, cy = y + 0.5, sure = 0.0;
    int count = gather(d, x, y), candidates = 0, must_group = -1;
    bool edge = false, depth = false;
    *front = find_front(d, count, cx, cy);
    *mask = 0;
    *background = count == 0;
    if (count == 0) {
        return 0;
    }
    if (count == 1 && c[0].near_edges == 0) {
        c[0].candidate = c[0].must = true;
        if (d->has_layers) {
            contest_depths(d, &c[0], cx, cy);
        }
        return 1;
    }

    contest_groups(d, c, count);
    for (int k = 0; k < count; k++) {
        contest_depths(d, &c[k], cx, cy);
    }
    /* A group's far end is its farthest depth; the nearest group decides. */
    for (int k = 0; k < count; k++) {
        double far = HUGE_VAL;
        for (int m = 0; m < count && c[k].must; m++) {
            far = c[m].group == c[k].group ? fmin(far, c[m].depth_low) : far;
        }
        if (c[k].must) {
            sure = fmax(sure, far);
        }
    }
    *background = sure == 0.0;
    for (int k = 0; k < count; k++) {
        c[k].candidate = c[k].depth_high + d->options.depth_steps >= sure;
        if (c[k].candidate) {
            candidates++;
            edge = edge || c[k].near_edges != 0;
            if (c[k].must) {
                depth = depth || (must_group >= 0 && must_group != c[k].group);
                must_group = c[k].group;
            }
        }
    }
    if (candidates + *background > 1) {
        *mask = (uint8_t)((edge ? REFERENCE_EDGE : 0) | (depth ? REFERENCE_DEPTH : 0));
    }
    return count;
}
