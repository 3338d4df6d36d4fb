/* SPDX-License-Identifier: MIT */
/*
 * Extended light sources: the mean of point lights over a panel or a ball, by <glint/scene.h>, as an integral.
 *
 * Only the part of the source above the surface's horizon n.s = 0 gives light, and there the integrand is smooth. So a
 * panel is cut at the horizon (Sutherland and Hodgman) and what is left, in triangles, goes to Gauss' rule in both
 * directions. A ball is taken in slices across n: the area of a slice of a sphere is proportional to its thickness
 * (Archimedes), so the horizon is the end of the range of n.w, for Gauss' rule again, and around a slice the integrand
 * is periodic, for the trapezoidal rule. tests/unit/test_reference_area.c holds both to sums over a million points.
 */
#include "internal.h"

#define PI 3.14159265358979323846
#define NODES_MAX 64
#define CORNERS_MAX 5

typedef struct rule {
    int count;
    double at[NODES_MAX], weight[NODES_MAX]; /* on 0..1 */
} rule;

/* Zeros of Legendre's polynomial by Newton's method. */
static void gauss(rule *r, int count)
{
    r->count = count;
    for (int i = 0; i < count; i++) {
        double x = cos(PI * (i + 0.75) / (count + 0.5)), slope = 1.0;
        for (int round = 0; round < 20; round++) {
            double before = 1.0, now = x;
            for (int k = 2; k <= count; k++) {
                double next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
                before = now;
                now = next;
            }
            slope = count * (x * now - before) / (x * x - 1.0);
            x -= now / slope;
        }
        r->at[i] = (1.0 - x) / 2.0;
        r->weight[i] = 1.0 / ((1.0 - x * x) * slope * slope);
    }
}

/* What is integrated: a surface point and what it is lit by. */
typedef struct spot_seen {
    const lamp *l;
    const surface *f;
    vector point, normal, c;
    area_mean sum;
} spot_seen;

static void add(spot_seen *at, vector source, double weight)
{
    lamp one = *at->l;
    vector s = minus(source, at->point);
    if (length(s) == 0.0) {
        return;
    }
    s = unit(s);
    double ns = dot(at->normal, s);
    if (ns <= 0.0) {
        return;
    }
    one.position = source;
    weight *= lamp_factor(&one, at->point, s);
    at->sum.diffuse += weight * ns;
    at->sum.specular += weight * shade_highlight(at->f, at->normal, s, at->c);
}

static vector on_panel(const lamp *l, double a, double b)
{
    return plus(l->position, plus(times(a, l->edge[0]), times(b, l->edge[1])));
}

/* The corners of the panel's part above the horizon. */
static int visible_part(const spot_seen *at, double part[CORNERS_MAX][2])
{
    static const double square[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
    int count = 0;
    for (int i = 0; i < 4; i++) {
        const double *p = square[i], *q = square[(i + 1) % 4];
        double here = dot(at->normal, minus(on_panel(at->l, p[0], p[1]), at->point));
        double there = dot(at->normal, minus(on_panel(at->l, q[0], q[1]), at->point));
        if (here > 0.0) {
            part[count][0] = p[0];
            part[count++][1] = p[1];
        }
        if ((here > 0.0) != (there > 0.0)) {
            double along = here / (here - there);
            part[count][0] = p[0] + along * (q[0] - p[0]);
            part[count++][1] = p[1] + along * (q[1] - p[1]);
        }
    }
    return count;
}

static void add_panel(spot_seen *at, const rule *r)
{
    double v[CORNERS_MAX][2];
    int count = visible_part(at, v);
    for (int t = 2; t < count; t++) {
        double e[2][2];
        for (int k = 0; k < 2; k++) {
            e[0][k] = v[t - 1][k] - v[0][k];
            e[1][k] = v[t][k] - v[t - 1][k];
        }
        double twice = fabs(e[0][0] * e[1][1] - e[0][1] * e[1][0]);
        for (int i = 0; i < r->count; i++) {
            for (int j = 0; j < r->count; j++) {
                double x = r->at[i], y = r->at[j] * x;
                vector p = on_panel(at->l, v[0][0] + x * e[0][0] + y * e[1][0], v[0][1] + x * e[0][1] + y * e[1][1]);
                add(at, p, r->weight[i] * r->weight[j] * x * twice / 4.0);
            }
        }
    }
}

static void add_ball(spot_seen *at, const rule *r)
{
    const lamp *l = at->l;
    vector n = at->normal, other = fabs(n.x) < 0.7 ? vector_of(1.0, 0.0, 0.0) : vector_of(0.0, 1.0, 0.0);
    vector u = unit(cross(n, other)), v = cross(n, u);
    double low = fmax(-1.0, -dot(n, minus(l->position, at->point)) / l->radius);
    for (int i = 0; i < r->count && low < 1.0; i++) {
        double z = low + (1.0 - low) * r->at[i], across = sqrt(fmax(0.0, 1.0 - z * z));
        for (int j = 0; j < 2 * r->count; j++) {
            double angle = PI * (j + 0.5) / r->count;
            vector w = plus(times(z, n), plus(times(across * cos(angle), u), times(across * sin(angle), v)));
            add(at, plus(l->position, times(l->radius, w)), r->weight[i] * (1.0 - low) / 2.0 / (2 * r->count));
        }
    }
}

/* How fine: finer where the source looks large, highlights are narrow, or attenuation is not smooth. */
static int nodes_for(const spot_seen *at, double size)
{
    double away = length(minus(at->l->position, at->point));
    double near = fmax(at->l->is_ball ? fabs(away - size) : away - size, 0.05 * size);
    bool fades = at->l->range > 0.0 || at->l->k[0] > 0.0 || at->l->k[1] > 0.0 || at->l->k[2] > 0.0;
    double count = 7.0 + 2.0 * size / near * (1.0 + sqrt(at->f->exponent));
    return (int)fmin(48.0, fades ? 2.0 * count : count);
}

area_mean area_light(const lamp *l, const surface *f, vector point, vector normal, vector c)
{
    spot_seen at = {l, f, point, normal, c, {0.0, 0.0}};
    double size = l->is_ball ? l->radius : length(l->edge[0]) + length(l->edge[1]);
    static rule rules[NODES_MAX + 1];
    rule *r = &rules[nodes_for(&at, size)];
    if (r->count == 0) {
        gauss(r, (int)(r - rules));
    }
    if (l->is_ball) {
        add_ball(&at, r);
    } else {
        add_panel(&at, r);
    }
    return at.sum;
}
