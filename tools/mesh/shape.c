/* SPDX-License-Identifier: MIT */
/*
 * Collecting the points and triangles of a mesh. See shape.h.
 */
#include "shape.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Room for `more` further elements; ends the program when there is no memory, which leaves nothing to clean up. */
static void *grown(void *array, size_t element, size_t count, size_t more, size_t *room)
{
    if (count + more <= *room) {
        return array;
    }
    size_t wanted = (count + more) * 2;
    void *larger = realloc(array, wanted * element);
    if (larger == NULL) {
        fprintf(stderr, "generate-mesh: out of memory\n");
        exit(1);
    }
    *room = wanted;
    return larger;
}

double shape_normalise(double v[3])
{
    double length = sqrt(shape_dot(v, v));
    if (length > 0.0) {
        for (int k = 0; k < 3; k++) {
            v[k] /= length;
        }
    }
    return length;
}

void shape_add(shape *mesh, int rows, int columns, shape_surface *surface, const void *context)
{
    size_t wide = (size_t)columns + 1;
    size_t points = ((size_t)rows + 1) * wide, triangles = 2 * (size_t)rows * (size_t)columns;
    mesh->points = grown(mesh->points, sizeof *mesh->points, mesh->point_count, points, &mesh->point_room);
    mesh->triangles =
        grown(mesh->triangles, sizeof *mesh->triangles, mesh->triangle_count, triangles, &mesh->triangle_room);

    uint32_t first = (uint32_t)mesh->point_count;
    for (int i = 0; i <= rows; i++) {
        for (int j = 0; j <= columns; j++) {
            mesh->points[mesh->point_count++] = surface(context, i, j);
        }
    }
    for (int i = 0; i < rows; i++) {
        for (int j = 0; j < columns; j++) {
            uint32_t a = first + (uint32_t)i * (uint32_t)wide + (uint32_t)j;
            uint32_t b = a + (uint32_t)wide;
            const uint32_t two[2][3] = {{a, b, b + 1}, {a, b + 1, a + 1}};
            for (int t = 0; t < 2; t++) {
                for (int k = 0; k < 3; k++) {
                    mesh->triangles[mesh->triangle_count][k] = two[t][k];
                }
                mesh->triangle_count++;
            }
        }
    }
}

void shape_free(shape *mesh)
{
    free(mesh->points);
    free(mesh->triangles);
    *mesh = (shape){0};
}
