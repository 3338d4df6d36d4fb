/* SPDX-License-Identifier: MIT */
/*
 * Where pixel centres meet triangles: each triangle is tried at every pixel of its bounding box, with the homogeneous
 * edge functions for what is inside and with distances on the screen for what is near an edge.
 */
#include <stdlib.h>

#include "internal.h"

/* The point a fraction t of the way from a to b on the screen; all that a corner carries is linear there. */
static corner between(const corner *a, const corner *b, double t)
{
    corner c;
    c.x = (1.0 - t) * a->x + t * b->x;
    c.y = (1.0 - t) * a->y + t * b->y;
    c.inverse_z = (1.0 - t) * a->inverse_z + t * b->inverse_z;
    for (int i = 0; i < 3; i++) {
        c.share[i] = (1.0 - t) * a->share[i] + t * b->share[i];
        c.linear[i] = (1.0 - t) * a->linear[i] + t * b->linear[i];
    }
    return c;
}

static corner nearest_on_segment(const corner *a, const corner *b, double x, double y)
{
    double dx = b->x - a->x, dy = b->y - a->y, l2 = dx * dx + dy * dy;
    double t = l2 > 0.0 ? ((x - a->x) * dx + (y - a->y) * dy) / l2 : 0.0;
    return between(a, b, fmin(1.0, fmax(0.0, t)));
}

corner meet_nearest(const triangle *t, double x, double y)
{
    corner best = t->corners[0];
    double least = HUGE_VAL;
    for (int k = 0; k < t->corner_count; k++) {
        corner c = nearest_on_segment(&t->corners[k], &t->corners[(k + 1) % t->corner_count], x, y);
        double distance = hypot(c.x - x, c.y - y);
        if (distance < least) {
            least = distance;
            best = c;
        }
    }
    return best;
}

static double area(const corner *a, const corner *b, double x, double y)
{
    return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

/* Weights of Gouraud shading: linear within the part of the polygon's fan that holds the point. */
static void linear_weights(const triangle *t, corner *c)
{
    double best = -HUGE_VAL;
    for (int k = 1; k + 1 < t->corner_count; k++) {
        const corner *p[3] = {&t->corners[0], &t->corners[k], &t->corners[k + 1]};
        double whole = area(p[0], p[1], p[2]->x, p[2]->y), w[3], least = HUGE_VAL;
        for (int i = 0; i < 3; i++) {
            w[i] = whole != 0.0 ? area(p[(i + 1) % 3], p[(i + 2) % 3], c->x, c->y) / whole : 1.0 / 3.0;
            least = fmin(least, w[i]);
        }
        if (least > best) {
            best = least;
            for (int m = 0; m < 3; m++) {
                c->linear[m] = w[0] * p[0]->linear[m] + w[1] * p[1]->linear[m] + w[2] * p[2]->linear[m];
            }
        }
    }
}

corner meet_hit(const reference_detail *d, const triangle *t, double x, double y)
{
    vector ray = view_ray(d, x, y);
    double e[3], sum = 0.0;
    corner c;
    for (int i = 0; i < 3; i++) {
        e[i] = fmax(0.0, dot(t->edge[i], ray));
        sum += e[i];
    }
    c.x = x;
    c.y = y;
    c.inverse_z = dot(t->plane, ray) / t->height;
    for (int i = 0; i < 3; i++) {
        c.share[i] = (sum > 0.0 ? e[i] / sum : 1.0 / 3.0) * c.inverse_z;
    }
    linear_weights(t, &c);
    return c;
}

/* One side of the square: keeps what has sign * coordinate <= limit. */
static int cut(corner polygon[], int count, bool vertical, double sign, double limit)
{
    corner out[MEET_REGION_MAX];
    int n = 0;
    for (int k = 0; k < count; k++) {
        const corner *a = &polygon[k], *b = &polygon[(k + 1) % count];
        double u = limit - sign * (vertical ? a->y : a->x), v = limit - sign * (vertical ? b->y : b->x);
        if (u >= 0.0) {
            out[n++] = *a;
        }
        if ((u >= 0.0) != (v >= 0.0)) {
            out[n++] = between(a, b, u / (u - v));
        }
    }
    for (int k = 0; k < n; k++) {
        polygon[k] = out[k];
    }
    return n;
}

int meet_region(const triangle *t, double x, double y, double e, corner region[MEET_REGION_MAX])
{
    int total = 0;
    for (int k = 1; k + 1 < t->corner_count; k++) {
        corner part[MEET_REGION_MAX] = {t->corners[0], t->corners[k], t->corners[k + 1]};
        int count = cut(part, 3, false, 1.0, x + e);
        count = cut(part, count, false, -1.0, e - x);
        count = cut(part, count, true, 1.0, y + e);
        count = cut(part, count, true, -1.0, e - y);
        for (int i = 0; i < count; i++) {
            region[total++] = part[i];
        }
    }
    return total;
}

static bool ray_inside(const reference_detail *d, const triangle *t, double x, double y)
{
    vector ray = view_ray(d, x, y);
    for (int i = 0; i < 3; i++) {
        if (dot(t->edge[i], ray) < 0.0) {
            return false;
        }
    }
    double slope = dot(t->plane, ray);
    return slope > 0.0 && t->height / slope > d->near_z;
}

/* Whether a centre is in or near the triangle; the edges within e of it. */
static bool try_pixel(const reference_detail *d, const triangle *t, double x, double y, meeting *m)
{
    double e = d->options.edge_px, distance[POLYGON_MAX];
    bool close = t->thin;
    for (int k = 0; k < t->corner_count; k++) {
        distance[k] = t->line[k][0] * x + t->line[k][1] * y + t->line[k][2];
        if (distance[k] < -e) {
            return false;
        }
        close = close || distance[k] <= e;
    }
    m->near_edges = 0;
    m->inside = 1;
    if (!close) {
        return true;
    }
    for (int k = 0; k < t->corner_count; k++) {
        if (distance[k] <= e) {
            corner c = nearest_on_segment(&t->corners[k], &t->corners[(k + 1) % t->corner_count], x, y);
            if (hypot(c.x - x, c.y - y) <= e) {
                m->near_edges = (uint8_t)(m->near_edges | 1u << t->label[k]);
            }
        }
    }
    m->inside = ray_inside(d, t, x, y);
    return m->inside || m->near_edges != 0;
}

static int add_meeting(reference_detail *d, size_t pixel, meeting m)
{
    if (d->meeting_count == d->meeting_room) {
        int32_t room = d->meeting_room > 0 ? d->meeting_room * 2 : 4096;
        meeting *grown = d->meeting_room <= INT32_MAX / 2 ? realloc(d->meetings, (size_t)room * sizeof *grown) : NULL;
        if (!grown) {
            return -1;
        }
        d->meetings = grown;
        d->meeting_room = room;
    }
    m.next = d->first[pixel];
    d->meetings[d->meeting_count] = m;
    d->first[pixel] = d->meeting_count++;
    return 0;
}

/* First and last pixel whose centre lies within low..high, cut to the picture. */
static void pixel_range(double low, double high, int size, int *first, int *last)
{
    *first = (int)fmax(0.0, ceil(fmin(low, (double)size + 1.0) - 0.5));
    *last = (int)fmin((double)size - 1.0, floor(fmax(high, -1.0) - 0.5));
}

static int meet_triangle(reference_detail *d, int32_t number)
{
    const triangle *t = &d->triangles[number];
    double e = d->options.edge_px, low_x = HUGE_VAL, low_y = HUGE_VAL, high_x = -HUGE_VAL, high_y = -HUGE_VAL;
    int x0, x1, y0, y1;
    meeting m = {number, -1, 0, 0};
    for (int k = 0; k < t->corner_count; k++) {
        low_x = fmin(low_x, t->corners[k].x);
        low_y = fmin(low_y, t->corners[k].y);
        high_x = fmax(high_x, t->corners[k].x);
        high_y = fmax(high_y, t->corners[k].y);
    }
    pixel_range(low_x - e, high_x + e, d->width, &x0, &x1);
    pixel_range(low_y - e, high_y + e, d->height, &y0, &y1);
    for (int y = y0; y <= y1; y++) {
        for (int x = x0; x <= x1; x++) {
            if (try_pixel(d, t, x + 0.5, y + 0.5, &m) && add_meeting(d, (size_t)y * (size_t)d->width + (size_t)x, m)) {
                return -1;
            }
        }
    }
    return 0;
}

int meet_all(reference_detail *d)
{
    size_t pixels = (size_t)d->width * (size_t)d->height;
    d->first = malloc(pixels * sizeof *d->first);
    if (!d->first) {
        return -1;
    }
    for (size_t i = 0; i < pixels; i++) {
        d->first[i] = -1;
    }
    for (int32_t i = 0; i < d->triangle_count; i++) {
        const triangle *t = &d->triangles[i];
        if (t->corner_count > 0 && (t->front || t->thin) && meet_triangle(d, i)) {
            return -1;
        }
    }
    for (size_t i = 0; i < pixels; i++) {
        int count = 0;
        for (int32_t m = d->first[i]; m >= 0; m = d->meetings[m].next) {
            count++;
        }
        d->contender_room = count > d->contender_room ? count : d->contender_room;
    }
    d->contenders = malloc(((size_t)d->contender_room * 2 + 1) * sizeof *d->contenders);
    d->layers = malloc(((size_t)d->contender_room + 1) * sizeof *d->layers);
    return d->contenders && d->layers ? 0 : -1;
}
