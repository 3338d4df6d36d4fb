/* SPDX-License-Identifier: MIT */
/*
 * Quantising, welding and printing a mesh. See mesh_writer.h. The output depends on nothing but the shape: no dates, no
 * paths. Rounding is to nearest, halves away from zero, so that a shape that is symmetric stays so.
 */
#include "mesh_writer.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <glint/mesh.h>

static const double degrees_per_radian = 57.29577951308232;
static const double weld_degrees = 1.0;

typedef struct quantised {
    int16_t position[3];
    int16_t normal_q14[3];
    int16_t texcoord[2];
} quantised;

typedef struct built {
    quantised *vertices;
    uint16_t (*triangles)[3];
    size_t vertex_count, triangle_count;
    int fraction_bits, texcoord_bits;
    double position_error; /* model units, greatest distance */
    double normal_error;   /* degrees */
    double weld_error;     /* degrees between normals that became one */
} built;

/* Accurate for small angles, where the arc cosine is not. */
static double degrees_between(const double a[3], const double b[3])
{
    double cross[3];
    shape_cross(a, b, cross);
    return atan2(sqrt(shape_dot(cross, cross)), shape_dot(a, b)) * degrees_per_radian;
}

/* The greatest shift at which every coordinate, rounded, fits int16. */
static int choose_fraction_bits(const shape *mesh)
{
    double greatest = 0.0;
    for (size_t v = 0; v < mesh->point_count; v++) {
        for (int k = 0; k < 3; k++) {
            greatest = fmax(greatest, fabs(mesh->points[v].position[k]));
        }
    }
    int bits = GLINT_MAX_FRACTION_BITS;
    while (bits > 0 && floor(ldexp(greatest, bits) + 0.5) > INT16_MAX) {
        bits--;
    }
    return bits;
}

/* The same for texture coordinates. */
static int choose_texcoord_bits(const shape *mesh)
{
    double greatest = 0.0;
    for (size_t v = 0; v < mesh->point_count; v++) {
        greatest = fmax(greatest, fmax(fabs(mesh->points[v].texcoord[0]), fabs(mesh->points[v].texcoord[1])));
    }
    int bits = GLINT_MAX_TEXCOORD_BITS;
    while (bits > GLINT_LEAST_TEXCOORD_BITS && floor(ldexp(greatest, bits) + 0.5) > INT16_MAX) {
        bits--;
    }
    return bits;
}

/*
 * value * 2^bits to the nearest whole number, halves away from zero. What differs only in the last places of double
 * precision (the two sides of a mirror plane, the mathematics library of another system) rounds to the same: the value
 * is first rounded to 2^-20 of a unit.
 */
static int16_t rounded(double value, int bits)
{
    return (int16_t)lround(ldexp(round(ldexp(value, bits + 20)), -20));
}

static quantised quantise(const shape_point *point, built *mesh)
{
    quantised q;
    double off[3], back[3];
    for (int k = 0; k < 3; k++) {
        q.position[k] = rounded(point->position[k], mesh->fraction_bits);
        q.normal_q14[k] = rounded(point->normal[k], 14);
        off[k] = ldexp((double)q.position[k], -mesh->fraction_bits) - point->position[k];
        back[k] = q.normal_q14[k];
    }
    for (int k = 0; k < 2; k++) {
        q.texcoord[k] = rounded(point->texcoord[k], mesh->texcoord_bits);
    }
    mesh->position_error = fmax(mesh->position_error, sqrt(shape_dot(off, off)));
    mesh->normal_error = fmax(mesh->normal_error, degrees_between(back, point->normal));
    return q;
}

/* Fills `vertices` and, for each point of the shape, the vertex that it became. Quadratic; meshes here are small. */
static void weld(const shape *from, built *mesh, uint32_t *vertex_of, uint32_t *first_point)
{
    for (size_t p = 0; p < from->point_count; p++) {
        quantised q = quantise(&from->points[p], mesh);
        size_t v = 0;
        double apart = 0.0;
        for (; v < mesh->vertex_count; v++) {
            if (memcmp(q.position, mesh->vertices[v].position, sizeof q.position) == 0 &&
                memcmp(q.texcoord, mesh->vertices[v].texcoord, sizeof q.texcoord) == 0) {
                apart = degrees_between(from->points[p].normal, from->points[first_point[v]].normal);
                if (apart <= weld_degrees) {
                    break;
                }
            }
        }
        if (v == mesh->vertex_count) {
            mesh->vertices[v] = q;
            first_point[v] = (uint32_t)p;
            mesh->vertex_count++;
        } else {
            mesh->weld_error = fmax(mesh->weld_error, apart);
        }
        vertex_of[p] = (uint32_t)v;
    }
}

/* Twice the area vector of a triangle of quantised vertices; exact in int64_t: each term is below 2^34. */
static void area_vector(const built *mesh, const uint32_t t[3], double out[3])
{
    int64_t e[2][3];
    for (int k = 0; k < 3; k++) {
        e[0][k] = (int64_t)mesh->vertices[t[1]].position[k] - mesh->vertices[t[0]].position[k];
        e[1][k] = (int64_t)mesh->vertices[t[2]].position[k] - mesh->vertices[t[0]].position[k];
    }
    for (int k = 0; k < 3; k++) {
        int m = (k + 1) % 3, n = (k + 2) % 3;
        out[k] = (double)(e[0][m] * e[1][n] - e[0][n] * e[1][m]);
    }
}

/* Vertices of one position: one vertex, or two that differ in their texture coordinates or normals. */
static int same_place(const built *mesh, uint32_t a, uint32_t b)
{
    return memcmp(mesh->vertices[a].position, mesh->vertices[b].position, sizeof mesh->vertices[a].position) == 0;
}

/* Takes over the triangles that still have three corners. Returns 0, or 1 with a message. */
static int take_triangles(const shape *from, built *mesh, const uint32_t *vertex_of)
{
    for (size_t n = 0; n < from->triangle_count; n++) {
        uint32_t t[3];
        for (int k = 0; k < 3; k++) {
            t[k] = vertex_of[from->triangles[n][k]];
        }
        if (same_place(mesh, t[0], t[1]) || same_place(mesh, t[1], t[2]) || same_place(mesh, t[2], t[0])) {
            continue;
        }
        double area[3];
        area_vector(mesh, t, area);
        if (shape_dot(area, area) <= 0.0) {
            fprintf(stderr, "generate-mesh: a triangle has no area in 16-bit positions; ask for fewer divisions\n");
            return 1;
        }
        for (int k = 0; k < 3; k++) {
            const double normal[3] = {mesh->vertices[t[k]].normal_q14[0], mesh->vertices[t[k]].normal_q14[1],
                                      mesh->vertices[t[k]].normal_q14[2]};
            if (shape_dot(area, normal) <= 0.0) {
                fprintf(stderr, "generate-mesh: a vertex normal points away from its face; ask for more divisions\n");
                return 1;
            }
        }
        if (mesh->triangle_count == UINT16_MAX) {
            fprintf(stderr, "generate-mesh: more than %d triangles; ask for fewer divisions\n", UINT16_MAX);
            return 1;
        }
        for (int k = 0; k < 3; k++) {
            mesh->triangles[mesh->triangle_count][k] = (uint16_t)t[k];
        }
        mesh->triangle_count++;
    }
    return 0;
}

static void print_int16s(FILE *out, const char *name, const char *what, const quantised *vertices, size_t count,
                         size_t offset, int width)
{
    fprintf(out, "\nstatic const int16_t %s_%s[][%d] GLINT_FLASH = {\n", name, what, width);
    for (size_t v = 0; v < count; v++) {
        int16_t x[3];
        memcpy(x, (const char *)&vertices[v] + offset, (size_t)width * sizeof x[0]);
        fprintf(out, "%s{%d, %d", v % 4 == 0 ? "    " : " ", x[0], x[1]);
        if (width == 3) {
            fprintf(out, ", %d", x[2]);
        }
        fprintf(out, "},%s", v % 4 == 3 || v + 1 == count ? "\n" : "");
    }
    fprintf(out, "};\n");
}

static void print_source(FILE *out, const built *mesh, int has_texcoords, const char *name, const char *command)
{
    fprintf(out, "/* SPDX-License-Identifier: MIT */ /* made by: %s */\n", command);
    fprintf(out,
            "/*\n * %zu vertices, %zu triangles. Worst quantisation error: positions %.2e model units, normals %.4f "
            "degrees.\n",
            mesh->vertex_count, mesh->triangle_count, mesh->position_error, mesh->normal_error);
    fprintf(out, " */\n#include <glint/mesh.h>\n\n/* clang-format off */\n");
    print_int16s(out, name, "positions", mesh->vertices, mesh->vertex_count, offsetof(quantised, position), 3);
    print_int16s(out, name, "normals_q14", mesh->vertices, mesh->vertex_count, offsetof(quantised, normal_q14), 3);
    if (has_texcoords) {
        print_int16s(out, name, "texcoords", mesh->vertices, mesh->vertex_count, offsetof(quantised, texcoord), 2);
    }
    fprintf(out, "\nstatic const uint16_t %s_triangles[][3] GLINT_FLASH = {\n", name);
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        fprintf(out, "%s{%u, %u, %u},%s", t % 6 == 0 ? "    " : " ", mesh->triangles[t][0], mesh->triangles[t][1],
                mesh->triangles[t][2], t % 6 == 5 || t + 1 == mesh->triangle_count ? "\n" : "");
    }
    fprintf(out, "};\n\nconst glint_mesh %s = {\n", name);
    fprintf(out, "    .positions = %s_positions,\n    .normals_q14 = %s_normals_q14,\n    .triangles = %s_triangles,\n",
            name, name, name);
    fprintf(out, "    .vertex_count = %zu,\n    .triangle_count = %zu,\n    .fraction_bits = %d,\n", mesh->vertex_count,
            mesh->triangle_count, mesh->fraction_bits);
    if (has_texcoords) {
        fprintf(out, "    .texcoord_bits = %d,\n    .texcoords = %s_texcoords,\n", mesh->texcoord_bits, name);
    }
    fprintf(out, "};\n");
}

int mesh_write(FILE *out, const shape *from, const char *name, const char *command)
{
    /* the writer drops far fewer triangles than half (those at poles), and welding this many would take minutes */
    if (from->triangle_count > 2 * (size_t)UINT16_MAX) {
        fprintf(stderr, "generate-mesh: %zu triangles, at most %d are possible; ask for fewer divisions\n",
                from->triangle_count, UINT16_MAX);
        return 1;
    }
    built mesh = {0};
    uint32_t *vertex_of = calloc(from->point_count, sizeof *vertex_of);
    uint32_t *first_point = calloc(from->point_count, sizeof *first_point);
    mesh.vertices = calloc(from->point_count, sizeof *mesh.vertices);
    mesh.triangles = calloc(from->triangle_count, sizeof *mesh.triangles);
    int failed = 1;
    if (vertex_of == NULL || first_point == NULL || mesh.vertices == NULL || mesh.triangles == NULL) {
        fprintf(stderr, "generate-mesh: out of memory\n");
        goto done;
    }
    mesh.fraction_bits = choose_fraction_bits(from);
    mesh.texcoord_bits = choose_texcoord_bits(from);
    weld(from, &mesh, vertex_of, first_point);
    if (mesh.vertex_count > UINT16_MAX) {
        fprintf(stderr, "generate-mesh: %zu vertices, at most %d fit 16-bit indices; ask for fewer divisions\n",
                mesh.vertex_count, UINT16_MAX);
        goto done;
    }
    if (take_triangles(from, &mesh, vertex_of) != 0) {
        goto done;
    }
    print_source(out, &mesh, from->has_texcoords, name, command);
    if (fflush(out) != 0 || ferror(out)) {
        fprintf(stderr, "generate-mesh: cannot write the output\n");
        goto done;
    }
    fprintf(stderr,
            "%s: %zu vertices, %zu triangles, fraction_bits %d; positions within %.2e, normals within %.4f degrees; "
            "welded normals agree within %.4f degrees\n",
            name, mesh.vertex_count, mesh.triangle_count, mesh.fraction_bits, mesh.position_error, mesh.normal_error,
            mesh.weld_error);
    failed = 0;
done:
    free(vertex_of);
    free(first_point);
    free(mesh.vertices);
    free(mesh.triangles);
    return failed;
}
