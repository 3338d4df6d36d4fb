/* SPDX-License-Identifier: MIT */
/*
 * Finds T-junctions: vertices inside the edge of another triangle of the mesh. There the two sides of the edge round to
 * different pixels, and the background may show through.
 *
 * In a closed mesh each edge is shared by two triangles. A T-junction leaves the long edge on one side and the two
 * short ones on the other each with one triangle; so only ends of such open edges, against open edges, need looking at.
 * A vertex counts as inside when it is within one step of the grid of the edge, as both have been rounded to the grid.
 *
 * Limits: within one mesh only; no search where vertices times edges exceed MAX_TESTS.
 */
#include "tools/import/internal.h"

#ifdef GLINT_HAVE_ASSIMP

#include <stdlib.h>
#include <string.h>

#define MAX_TESTS (1u << 26) /* a second or less */

static int compare_uint64(const void *a, const void *b)
{
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

static uint64_t key_of(const int16_t position[3])
{
    return (uint64_t)(uint16_t)position[0] << 32 | (uint64_t)(uint16_t)position[1] << 16 | (uint16_t)position[2];
}

static void position_from(uint64_t key, double position[3])
{
    for (int k = 0; k < 3; k++) {
        int32_t value = (int32_t)(key >> (32 - 16 * k) & 0xffff);
        position[k] = value > INT16_MAX ? value - 65536 : value;
    }
}

static size_t unique(uint64_t *keys, size_t count)
{
    qsort(keys, count, sizeof *keys, compare_uint64);
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        if (!kept || keys[kept - 1] != keys[i]) {
            keys[kept++] = keys[i];
        }
    }
    return kept;
}

static bool inside_edge(uint64_t point, uint64_t from, uint64_t to)
{
    double p[3], a[3], b[3], crossed[3];
    position_from(point, p);
    position_from(from, a);
    position_from(to, b);
    for (int k = 0; k < 3; k++) {
        p[k] -= a[k];
        b[k] -= a[k];
    }
    double along = dot3(p, b), square = dot3(b, b);
    if (along <= 0 || along >= square) {
        return false;
    }
    cross3(p, b, crossed);
    return dot3(crossed, crossed) <= square; /* distance <= 1 */
}

bool count_t_junctions(const int16_t (*positions)[3], size_t vertex_count, const uint32_t (*triangles)[3],
                       size_t triangle_count, uint64_t *result)
{
    *result = 0;
    uint64_t *points = malloc((vertex_count + 1) * sizeof *points);
    uint64_t *edges = malloc((3 * triangle_count + 1) * sizeof *edges);
    uint64_t *ends = malloc((6 * triangle_count + 1) * sizeof *ends);
    bool done = points && edges && ends;
    if (done) {
        for (size_t v = 0; v < vertex_count; v++) {
            points[v] = key_of(positions[v]);
        }
        size_t point_count = unique(points, vertex_count);
        for (size_t e = 0; e < 3 * triangle_count; e++) {
            uint64_t number[2];
            for (size_t k = 0; k < 2; k++) {
                uint64_t key = key_of(positions[triangles[e / 3][(e + k) % 3]]);
                uint64_t *found = bsearch(&key, points, point_count, sizeof *points, compare_uint64);
                number[k] = found ? (uint64_t)(found - points) : 0;
            }
            edges[e] = number[0] < number[1] ? number[0] << 32 | number[1] : number[1] << 32 | number[0];
        }
        qsort(edges, 3 * triangle_count, sizeof *edges, compare_uint64);
        size_t open = 0, end_count = 0;
        for (size_t e = 0, next; e < 3 * triangle_count; e = next) {
            for (next = e + 1; next < 3 * triangle_count && edges[next] == edges[e];) {
                next++;
            }
            if (next - e == 1) {
                edges[open++] = edges[e];
            }
        }
        for (size_t e = 0; e < open; e++) {
            ends[end_count++] = points[edges[e] >> 32];
            ends[end_count++] = points[edges[e] & UINT32_MAX];
        }
        end_count = unique(ends, end_count);
        done = open == 0 || end_count <= MAX_TESTS / open;
        for (size_t i = 0; done && i < end_count; i++) {
            for (size_t e = 0; e < open; e++) {
                if (inside_edge(ends[i], points[edges[e] >> 32], points[edges[e] & UINT32_MAX])) {
                    *result += 1;
                    break;
                }
            }
        }
    }
    free(points);
    free(edges);
    free(ends);
    return done;
}

#endif
