/* SPDX-License-Identifier: MIT */
/*
 * Surfaces that let light through, in the true order of their depths: each pixel shows what is behind, through all of
 * them. Which of them may be there or not, and which two may come either way, makes a pixel contested.
 */
#include <stdlib.h>
#include <string.h>

#include "internal.h"

/* Of the opaque surfaces that a pixel may show: the range of their depths, which the background has at 0. */
static void opaque_depths(const reference_detail *d, int opaque, int front, bool background, double *low, double *high)
{
    *low = background ? 0.0 : HUGE_VAL;
    *high = 0.0;
    for (int k = 0; k < opaque; k++) {
        const contender *c = &d->contenders[k];
        if (c->candidate || k == front) {
            *low = fmin(*low, c->depth_low);
            *high = fmax(*high, c->depth_high);
        }
    }
}

static corner layer_hit(const reference_detail *d, const contender *c, double x, double y)
{
    const triangle *t = &d->triangles[c->triangle];
    return c->inside && t->front ? meet_hit(d, t, x, y) : meet_nearest(t, x, y);
}

static int by_depth(const void *a, const void *b)
{
    const layer *p = a, *q = b;
    return p->depth != q->depth ? (p->depth < q->depth ? -1 : 1) : p->surface.triangle - q->surface.triangle;
}

/* The meetings of a pixel with layers, and whether they must cover it. Returns their number. */
static int gather(const reference_detail *d, int x, int y, contender *list)
{
    int count = 0;
    for (int32_t m = d->first[(size_t)y * (size_t)d->width + (size_t)x]; m >= 0; m = d->meetings[m].next) {
        const meeting *met = &d->meetings[m];
        if (d->surfaces[d->triangles[met->triangle].object].transmission > 0.0) {
            contender *c = &list[count];
            memset(c, 0, sizeof *c);
            c->triangle = met->triangle;
            c->inside = met->inside != 0;
            c->near_edges = met->near_edges;
            c->group = count++;
        }
    }
    contest_groups(d, list, count);
    return count;
}

/* Is the centre covered once by the contender's group, wherever rounding moves its corners to, and in one colour? That
 * is continuous over a group only where it follows the normals of the corners. */
static bool covers_once(const reference_detail *d, const contender *list, int count, const contender *c)
{
    int inside = 0;
    if (c->near_edges != 0 && d->shading != GLINT_SHADING_EXACT) {
        return false;
    }
    for (int k = 0; k < count; k++) {
        inside += list[k].group == c->group && list[k].inside;
    }
    return c->must && inside == 1;
}

int layers_at(const reference_detail *d, int x, int y, int opaque, int front, bool background, layer *list)
{
    double low, high, cx = x + 0.5, cy = y + 0.5, steps = d->options.depth_steps;
    int count = 0;
    opaque_depths(d, opaque, front, background, &low, &high);
    double seen = front >= 0 ? DEPTH_STEPS * d->near_z * layer_hit(d, &d->contenders[front], cx, cy).inverse_z : 0.0;
    contender *const all = d->contenders + d->contender_room;
    const int met = gather(d, x, y, all);
    for (int m = 0; m < met; m++) {
        const triangle *t = &d->triangles[all[m].triangle];
        const bool once = covers_once(d, all, met, &all[m]);
        if (once && !all[m].inside) {
            continue; /* its neighbour stands for both */
        }
        layer *l = &list[count];
        memset(l, 0, sizeof *l);
        l->surface = all[m];
        contest_depths(d, &l->surface, cx, cy);
        if (l->surface.depth_high + steps < low) {
            continue;
        }
        l->hit = layer_hit(d, &l->surface, cx, cy);
        l->depth = DEPTH_STEPS * d->near_z * l->hit.inverse_z;
        l->there = all[m].inside && t->front && l->depth > seen;
        l->doubtful = !once || l->surface.depth_low <= high + steps;
        count += l->there || l->doubtful;
    }
    qsort(list, (size_t)count, sizeof *list, by_depth);
    for (int k = 1; k < count; k++) {
        list[k].either_way = list[k].surface.depth_low <= list[k - 1].surface.depth_high + steps;
    }
    return count;
}

static void lay_over(double rgb[3], const double own[3], double through)
{
    for (int k = 0; k < 3; k++) {
        rgb[k] = fmin(1.0, own[k] + through * rgb[k]);
    }
}

bool layers_show(const reference_detail *d, const layer *list, int count, double rgb[3], double *rounding)
{
    bool doubt = false;
    for (int k = 0; k < count; k++) {
        const triangle *t = &d->triangles[list[k].surface.triangle];
        double own[3], through;
        wire_state wire = shade_wire(d, t, list[k].hit.x, list[k].hit.y);
        doubt = doubt || list[k].doubtful || list[k].either_way || wire == WIRE_DOUBTFUL ||
                shade_variants(d, t, &list[k].hit, NULL) > 1;
        if (list[k].there) {
            shade_layer(d, t, &list[k].hit, &list[k].hit, -1, wire == WIRE_ON, NULL, own, &through);
            lay_over(rgb, own, through);
            *rounding = (*rounding + 0.5) * through;
        }
    }
    return doubt;
}

/* One layer over a range of colours, which gets all that the layer may make of them. */
static void widen_by(const reference_detail *d, const layer *l, double x, double y, reference_candidate *range)
{
    const triangle *t = &d->triangles[l->surface.triangle];
    const reference_candidate before = *range;
    corner region[MEET_REGION_MAX + 1];
    int points = meet_region(t, x, y, d->options.edge_px, region), variants = shade_variants(d, t, &l->hit, NULL);
    wire_state wire = shade_wire(d, t, l->hit.x, l->hit.y);
    double texel[2][3];
    bool first = !l->doubtful;
    region[points++] = l->hit;
    bool textured = shade_texels(d, t, region, points, texel[0], texel[1]);
    for (int v = 0; v < variants * 2; v++) {
        bool on = v >= variants;
        for (int p = 0; p < points * (textured ? 2 : 1) && (wire == WIRE_DOUBTFUL || on == (wire == WIRE_ON)); p++) {
            double own[3], through, low[3], high[3];
            shade_layer(d, t, &region[p % points], &l->hit, variants > 1 ? v % variants : -1, on,
                        textured ? texel[p / points] : NULL, own, &through);
            memcpy(low, before.low, sizeof low);
            memcpy(high, before.high, sizeof high);
            lay_over(low, own, through);
            lay_over(high, own, through);
            for (int k = 0; k < 3; k++) {
                range->low[k] = first ? low[k] : fmin(range->low[k], low[k]);
                range->high[k] = first ? high[k] : fmax(range->high[k], high[k]);
            }
            first = false;
        }
    }
}

static void unite(reference_candidate *range, const reference_candidate *other)
{
    for (int k = 0; k < 3; k++) {
        range->low[k] = fmin(range->low[k], other->low[k]);
        range->high[k] = fmax(range->high[k], other->high[k]);
    }
}

void layers_range(const reference_detail *d, const layer *list, int count, int x, int y, reference_candidate *range)
{
    for (int k = 0; k < count; k++) {
        if (k + 1 < count && list[k + 1].either_way) {
            reference_candidate other = *range;
            widen_by(d, &list[k + 1], x + 0.5, y + 0.5, &other);
            widen_by(d, &list[k], x + 0.5, y + 0.5, &other);
            widen_by(d, &list[k], x + 0.5, y + 0.5, range);
            widen_by(d, &list[++k], x + 0.5, y + 0.5, range);
            unite(range, &other);
        } else {
            widen_by(d, &list[k], x + 0.5, y + 0.5, range);
        }
    }
}
