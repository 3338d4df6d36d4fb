/* SPDX-License-Identifier: MIT */
/*
 * Finds where triangles of one object close up against each other: an edge is sealed when a triangle that can be drawn
 * runs along it the other way. Edges are known by the positions of their ends, so that vertices doubled for the sake of
 * a normal still make a closed surface.
 */
#include <stdlib.h>
#include <string.h>

#include "internal.h"

typedef struct directed_edge {
    int32_t object;
    int16_t from[3], to[3];
} directed_edge;

static int compare_edges(const void *a, const void *b)
{
    const directed_edge *p = a, *q = b;
    if (p->object != q->object) {
        return p->object < q->object ? -1 : 1;
    }
    int order = memcmp(p->from, q->from, sizeof p->from);
    return order != 0 ? order : memcmp(p->to, q->to, sizeof p->to);
}

static directed_edge edge_of(const triangle *t, int from, int to)
{
    directed_edge e;
    memset(&e, 0, sizeof e);
    e.object = t->object;
    memcpy(e.from, t->model[from], sizeof e.from);
    memcpy(e.to, t->model[to], sizeof e.to);
    return e;
}

int seal_edges(reference_detail *d)
{
    size_t count = 0;
    directed_edge *edges = malloc(((size_t)d->triangle_count * 3 + 1) * sizeof *edges);
    if (!edges) {
        return -1;
    }
    for (int32_t i = 0; i < d->triangle_count; i++) {
        const triangle *t = &d->triangles[i];
        if (t->corner_count > 0 && (t->front || t->thin)) {
            for (int k = 0; k < 3; k++) {
                edges[count++] = edge_of(t, k, (k + 1) % 3);
            }
        }
    }
    qsort(edges, count, sizeof *edges, compare_edges);
    for (int32_t i = 0; i < d->triangle_count; i++) {
        triangle *t = &d->triangles[i];
        for (int k = 0; k < 3; k++) {
            directed_edge reverse = edge_of(t, (k + 1) % 3, k);
            t->sealed[k] = bsearch(&reverse, edges, count, sizeof *edges, compare_edges) != NULL;
        }
    }
    free(edges);
    return 0;
}
