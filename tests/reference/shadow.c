/* SPDX-License-Identifier: MIT */
/*
 * Shadows by casting rays, as <glint/scene.h> defines them: from the surface's point to the light, against every
 * triangle that casts. A tree of boxes saves most of the triangles; what it leaves is met by the formula of T. Moeller
 * and B. Trumbore ("Fast, minimum storage ray/triangle intersection", Journal of Graphics Tools 2(1), 1997).
 */
#include <stdlib.h>

#include "internal.h"

#define LEAF 4

/* A hit counts beyond this part of the point's distance from the eye: what touches the surface is not above it. */
#define NEAREST 1e-6

/* Rays that pass an edge so closely hit both triangles that share it. */
#define EDGE 1e-9

/* A box over casters first..first + count, or over the two nodes that follow: the next one, and `other`. */
typedef struct shadow_node {
    double low[3], high[3];
    int32_t first, count, other;
} shadow_node;

struct shadow_tree {
    int32_t *casters;
    shadow_node *nodes;
    int32_t node_count;
};

static double component(vector v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

static double middle(const triangle *t, int axis)
{
    return component(t->world[0], axis) + component(t->world[1], axis) + component(t->world[2], axis);
}

/* Brings the smaller half of the middles along an axis to the front (C. A. R. Hoare's selection). */
static void halve(const reference_detail *d, int32_t *list, int32_t count, int axis)
{
    int32_t left = 0, right = count - 1, wanted = count / 2;
    while (left < right) {
        double pivot = middle(&d->triangles[list[wanted]], axis);
        int32_t i = left, j = right;
        while (i <= j) {
            while (middle(&d->triangles[list[i]], axis) < pivot) {
                i++;
            }
            while (middle(&d->triangles[list[j]], axis) > pivot) {
                j--;
            }
            if (i <= j) {
                int32_t swapped = list[i];
                list[i++] = list[j];
                list[j--] = swapped;
            }
        }
        left = j < wanted ? i : left;
        right = wanted < i ? j : right;
    }
}

static int32_t build(const reference_detail *d, struct shadow_tree *tree, int32_t first, int32_t count)
{
    int32_t number = tree->node_count++;
    shadow_node *node = &tree->nodes[number];
    int axis = 0;
    for (int k = 0; k < 3; k++) {
        node->low[k] = HUGE_VAL;
        node->high[k] = -HUGE_VAL;
        for (int32_t i = 0; i < 3 * count; i++) {
            double v = component(d->triangles[tree->casters[first + i / 3]].world[i % 3], k);
            node->low[k] = fmin(node->low[k], v);
            node->high[k] = fmax(node->high[k], v);
        }
        axis = node->high[k] - node->low[k] > node->high[axis] - node->low[axis] ? k : axis;
    }
    node->first = first;
    node->count = count;
    if (count > LEAF) {
        halve(d, tree->casters + first, count, axis);
        node->count = 0;
        build(d, tree, first, count / 2);
        node->other = build(d, tree, first + count / 2, count - count / 2);
    }
    return number;
}

int shadow_load(reference_detail *d)
{
    int32_t count = 0;
    bool any = false;
    for (int j = 0; j < d->lamp_count; j++) {
        any = any || d->lamps[j].casts;
    }
    d->shadows = calloc(1, sizeof *d->shadows);
    if (!d->shadows) {
        return -1;
    }
    d->shadows->casters = malloc(((size_t)d->triangle_count + 1) * sizeof(int32_t));
    d->shadows->nodes = malloc((2 * (size_t)d->triangle_count + 1) * sizeof(shadow_node));
    if (!d->shadows->casters || !d->shadows->nodes) {
        return -1;
    }
    for (int32_t i = 0; any && i < d->triangle_count; i++) {
        if (d->surfaces[d->triangles[i].object].casts) {
            d->shadows->casters[count++] = i;
        }
    }
    if (count > 0) {
        build(d, d->shadows, 0, count);
    }
    return 0;
}

void shadow_free(struct shadow_tree *tree)
{
    if (tree) {
        free(tree->casters);
        free(tree->nodes);
        free(tree);
    }
}

/* From `from` along `way`, for 0 < s < end. */
typedef struct shadow_ray {
    vector from, way;
    double begin, end;
} shadow_ray;

static bool meets_box(const shadow_node *n, const shadow_ray *r)
{
    double in = r->begin, out = r->end;
    for (int k = 0; k < 3; k++) {
        double from = component(r->from, k), way = component(r->way, k);
        if (way == 0.0) {
            if (from < n->low[k] || from > n->high[k]) {
                return false;
            }
            continue;
        }
        double a = (n->low[k] - from) / way, b = (n->high[k] - from) / way;
        in = fmax(in, fmin(a, b));
        out = fmin(out, fmax(a, b));
    }
    return in <= out + EDGE * (fabs(in) + fabs(out));
}

static bool meets_triangle(const triangle *t, const shadow_ray *r)
{
    vector ab = minus(t->world[1], t->world[0]), ac = minus(t->world[2], t->world[0]), p = cross(r->way, ac);
    double determinant = dot(ab, p);
    if (determinant == 0.0) {
        return false;
    }
    vector from = minus(r->from, t->world[0]), q = cross(from, ab);
    double u = dot(from, p) / determinant, v = dot(r->way, q) / determinant, s = dot(ac, q) / determinant;
    return u >= -EDGE && v >= -EDGE && u + v <= 1.0 + EDGE && s > r->begin && s < r->end;
}

static bool counts(const reference_detail *d, const triangle *caster, const triangle *on, vector way)
{
    return caster != on && (caster->object != on->object || d->surfaces[on->object].sides != GLINT_FRONT_SIDE ||
                            dot(caster->face, way) < 0.0);
}

bool shadow_hides(const reference_detail *d, const triangle *t, vector point, int light)
{
    const lamp *l = &d->lamps[light];
    int32_t stack[64], depth = 0;
    shadow_ray r = {point, l->has_place ? minus(l->position, point) : l->toward, 0.0, l->has_place ? 1.0 : HUGE_VAL};
    if (!l->casts || !d->surfaces[t->object].takes || d->shadows->node_count == 0 || length(r.way) == 0.0) {
        return false;
    }
    r.begin = NEAREST * length(minus(point, d->eye)) / length(r.way);
    stack[depth++] = 0;
    while (depth > 0) {
        int32_t number = stack[--depth];
        const shadow_node *n = &d->shadows->nodes[number];
        if (!meets_box(n, &r)) {
            continue;
        }
        for (int32_t i = 0; i < n->count; i++) {
            const triangle *caster = &d->triangles[d->shadows->casters[n->first + i]];
            if (counts(d, caster, t, r.way) && meets_triangle(caster, &r)) {
                return true;
            }
        }
        if (n->count == 0) {
            stack[depth++] = n->other;
            stack[depth++] = number + 1;
        }
    }
    return false;
}

/* The point of the triangle's plane that is seen at (x, y); false where there is none. */
static bool plane_point(const reference_detail *d, const triangle *t, double x, double y, vector *point)
{
    vector ray = view_ray(d, x, y);
    double slope = dot(t->plane, ray);
    if (!(slope > 0.0)) {
        return false;
    }
    vector v = times(t->height / slope, ray);
    *point = plus(d->eye, plus(plus(times(v.x, d->right), times(v.y, d->down)), times(v.z, d->forward)));
    return true;
}

/* Does the light's shadow begin or end within `radius` px? Eight directions are looked at. */
static bool changes_within(const reference_detail *d, const triangle *t, const corner *at, double radius, int light,
                           bool hidden)
{
    static const double way[8][2] = {{1, 0},  {0.7071, 0.7071},   {0, 1},  {-0.7071, 0.7071},
                                     {-1, 0}, {-0.7071, -0.7071}, {0, -1}, {0.7071, -0.7071}};
    for (int k = 0; k < 8; k++) {
        vector point;
        if (!plane_point(d, t, at->x + radius * way[k][0], at->y + radius * way[k][1], &point) ||
            shadow_hides(d, t, point, light) != hidden) {
            return true;
        }
    }
    return false;
}

bool shadow_contested(const reference_detail *d, const triangle *t, const corner *at, int light)
{
    const lamp *l = &d->lamps[light];
    vector point, s;
    if (!l->casts || !d->surfaces[t->object].takes || d->shadows->node_count == 0) {
        return false;
    }
    if (!plane_point(d, t, at->x, at->y, &point) || !lamp_toward(l, point, &s) ||
        fabs(dot(t->face, s)) < d->options.terminator) {
        return true;
    }
    bool hidden = shadow_hides(d, t, point, light);
    return changes_within(d, t, at, d->options.shadow_px, light, hidden) ||
           changes_within(d, t, at, d->options.shadow_px / 8.0, light, hidden) ||
           changes_within(d, t, at, d->options.shadow_px / 64.0, light, hidden);
}
