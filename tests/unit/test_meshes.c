/* SPDX-License-Identifier: MIT */
/*
 * The built-in meshes: counts, indices, orientation, closedness, normals, and the surfaces that they are meant to be.
 * Everything is derived from the 16-bit data alone, in exact integers where that decides.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <examples/meshes/meshes.h>

/* Each of three rounded components is off by at most half a unit. */
static const double greatest_rounding = 0.8660254037844387; /* sqrt(3) / 2 units */

typedef struct expected {
    const char *name;
    const glint_mesh *mesh;
    int triangles;
    int boundary_edges; /* with vertices of one position taken as one: 0 is a closed surface */
} expected;

/* The teapot's open ends: both ends of the handle and of the spout, each a ring of 2 * divisions edges. */
static const expected meshes[] = {
    {"sphere_10x6", &glint_mesh_sphere_10x6, 100, 0},
    {"sphere_24x12", &glint_mesh_sphere_24x12, 528, 0},
    {"sphere_32x16", &glint_mesh_sphere_32x16, 960, 0},
    {"sphere_64x32", &glint_mesh_sphere_64x32, 3968, 0},
    {"torus_knot", &glint_mesh_torus_knot, 2304, 0},
    {"torus_knot_small", &glint_mesh_torus_knot_small, 1280, 0},
    {"box", &glint_mesh_box, 12, 0},
    {"bowl", &glint_mesh_bowl, 480, 32},
    {"teapot", &glint_mesh_teapot, 3648, 4 * 2 * 8},
    {"teapot_small", &glint_mesh_teapot_small, 928, 4 * 2 * 4},
    {"plane", &glint_mesh_plane, 128, 4 * 8},
};
enum { MESH_COUNT = sizeof meshes / sizeof meshes[0] };

typedef struct vector {
    int64_t x, y, z;
} vector;

static vector position(const glint_mesh *m, int v)
{
    return (vector){m->positions[v][0], m->positions[v][1], m->positions[v][2]};
}

static vector normal(const glint_mesh *m, int v)
{
    return (vector){m->normals_q14[v][0], m->normals_q14[v][1], m->normals_q14[v][2]};
}

static vector minus(vector a, vector b)
{
    return (vector){a.x - b.x, a.y - b.y, a.z - b.z};
}

/* Components below 2^17 give products below 2^35: exact. */
static vector cross(vector a, vector b)
{
    return (vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static int64_t dot(vector a, vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* Twice the area vector of a triangle, by the library's definition of its face normal. */
static vector area(const glint_mesh *m, int triangle)
{
    const uint16_t *t = m->triangles[triangle];
    return cross(minus(position(m, t[1]), position(m, t[0])), minus(position(m, t[2]), position(m, t[0])));
}

static void test_counts_and_indices(void **state)
{
    (void)state;
    for (int n = 0; n < MESH_COUNT; n++) {
        const glint_mesh *m = meshes[n].mesh;
        assert_int_equal(m->triangle_count, meshes[n].triangles);
        assert_in_range(m->fraction_bits, 0, GLINT_MAX_FRACTION_BITS);
        char *used = calloc(m->vertex_count, 1);
        assert_non_null(used);
        for (int t = 0; t < m->triangle_count; t++) {
            for (int k = 0; k < 3; k++) {
                assert_true(m->triangles[t][k] < m->vertex_count);
                used[m->triangles[t][k]] = 1;
            }
        }
        for (int v = 0; v < m->vertex_count; v++) {
            assert_true(used[v]);
        }
        free(used);
    }
}

/* No triangle is empty, and each of its vertex normals is on the outer side of it. */
static void test_faces_agree_with_normals(void **state)
{
    (void)state;
    for (int n = 0; n < MESH_COUNT; n++) {
        const glint_mesh *m = meshes[n].mesh;
        for (int t = 0; t < m->triangle_count; t++) {
            vector face = area(m, t);
            assert_true(face.x != 0 || face.y != 0 || face.z != 0);
            for (int k = 0; k < 3; k++) {
                if (dot(face, normal(m, m->triangles[t][k])) <= 0) {
                    fail_msg("%s: the normal of corner %d of triangle %d points inwards", meshes[n].name, k, t);
                }
            }
        }
    }
}

static void test_normals_are_unit(void **state)
{
    (void)state;
    for (int n = 0; n < MESH_COUNT; n++) {
        const glint_mesh *m = meshes[n].mesh;
        for (int v = 0; v < m->vertex_count; v++) {
            double length = sqrt((double)dot(normal(m, v), normal(m, v)));
            if (fabs(length - 16384) > greatest_rounding) {
                fail_msg("%s: the normal of vertex %d is %.3f long, expected 16384", meshes[n].name, v, length);
            }
        }
    }
}

static int compare_edges(const void *a, const void *b)
{
    return memcmp(a, b, 2 * sizeof(uint16_t));
}

/* The first vertex with the same position. */
static uint16_t first_there(const glint_mesh *m, uint16_t v)
{
    for (uint16_t w = 0; w < v; w++) {
        if (memcmp(m->positions[w], m->positions[v], sizeof m->positions[w]) == 0) {
            return w;
        }
    }
    return v;
}

/*
 * Consistent orientation: no edge is walked twice in the same direction. Returns the edges whose reverse is missing,
 * and the number of edges (each counted once). by_position: take vertices of one position as one, across hard edges.
 */
static int boundary(const char *name, const glint_mesh *m, int by_position, int *edge_count)
{
    size_t count = 3 * (size_t)m->triangle_count;
    uint16_t(*edges)[2] = calloc(count, sizeof *edges);
    uint16_t *same = calloc(m->vertex_count, sizeof *same);
    assert_non_null(edges);
    assert_non_null(same);
    for (uint16_t v = 0; v < m->vertex_count; v++) {
        same[v] = by_position ? first_there(m, v) : v;
    }
    for (size_t e = 0; e < count; e++) {
        edges[e][0] = same[m->triangles[e / 3][e % 3]];
        edges[e][1] = same[m->triangles[e / 3][(e + 1) % 3]];
    }
    qsort(edges, count, sizeof *edges, compare_edges);
    int open = 0;
    for (size_t e = 0; e < count; e++) {
        if (e > 0 && compare_edges(edges[e - 1], edges[e]) == 0) {
            fail_msg("%s: edge %d-%d is walked twice in one direction", name, edges[e][0], edges[e][1]);
        }
        const uint16_t reverse[2] = {edges[e][1], edges[e][0]};
        open += bsearch(reverse, edges, count, sizeof *edges, compare_edges) == NULL;
    }
    *edge_count = ((int)count + open) / 2;
    free(edges);
    free(same);
    return open;
}

static void test_surfaces_are_closed(void **state)
{
    (void)state;
    int edges;
    for (int n = 0; n < MESH_COUNT; n++) {
        assert_int_equal(boundary(meshes[n].name, meshes[n].mesh, 1, &edges), meshes[n].boundary_edges);
    }
}

/* Seams and poles are welded: closed without looking at positions, with the Euler characteristic of the surface. */
static void test_seams_are_welded(void **state)
{
    (void)state;
    static const struct {
        const glint_mesh *mesh;
        int euler;
    } smooth[] = {{&glint_mesh_sphere_10x6, 2},
                  {&glint_mesh_sphere_32x16, 2},
                  {&glint_mesh_sphere_64x32, 2},
                  {&glint_mesh_torus_knot, 0}};
    for (int n = 0; n < 4; n++) {
        const glint_mesh *m = smooth[n].mesh;
        int edges;
        assert_int_equal(boundary("smooth mesh", m, 0, &edges), 0);
        assert_int_equal(m->vertex_count - edges + m->triangle_count, smooth[n].euler);
    }
}

static void test_spheres_are_unit_spheres(void **state)
{
    (void)state;
    static const glint_mesh *const spheres[] = {&glint_mesh_sphere_10x6, &glint_mesh_sphere_32x16,
                                                &glint_mesh_sphere_64x32};
    for (int n = 0; n < 3; n++) {
        const glint_mesh *m = spheres[n];
        int poles = 0;
        assert_int_equal(m->fraction_bits, 14);
        for (int v = 0; v < m->vertex_count; v++) {
            double radius = sqrt((double)dot(position(m, v), position(m, v)));
            assert_true(fabs(radius - 16384) <= greatest_rounding);
            assert_memory_equal(m->positions[v], m->normals_q14[v], sizeof m->positions[v]);
            poles += m->positions[v][0] == 0 && m->positions[v][2] == 0;
        }
        assert_int_equal(poles, 2);
    }
}

/* One tube radius back along the normal is the curve, and that lies on a torus of radii 1 and 0.5. */
static void test_knot_lies_about_a_torus(void **state)
{
    (void)state;
    const glint_mesh *m = &glint_mesh_torus_knot;
    const double unit = ldexp(1.0, -m->fraction_bits);
    for (int v = 0; v < m->vertex_count; v++) {
        double c[3];
        for (int k = 0; k < 3; k++) {
            c[k] = m->positions[v][k] * unit - 0.22 * m->normals_q14[v][k] / 16384;
        }
        double ring = sqrt(c[0] * c[0] + c[1] * c[1]) - 1.0;
        double radius = sqrt(ring * ring + c[2] * c[2]);
        /* the position's rounding and 0.22 of the normal's */
        assert_true(fabs(radius - 0.5) <= greatest_rounding * (unit + 0.22 / 16384));
    }
}

static const glint_mesh *const teapots[] = {&glint_mesh_teapot, &glint_mesh_teapot_small};

/* On the axis the teapot has the middle of its bottom and the top of its knob, each one vertex with a vertical normal.
 */
static void test_teapot_poles(void **state)
{
    (void)state;
    for (int n = 0; n < 2; n++) {
        const glint_mesh *m = teapots[n];
        int tops = 0, bottoms = 0;
        for (int v = 0; v < m->vertex_count; v++) {
            const int16_t *p = m->positions[v], *normal_q14 = m->normals_q14[v];
            if (p[0] == 0 && p[2] == 0) {
                int top = p[1] == lround(ldexp(3.15, m->fraction_bits));
                assert_true(top || p[1] == 0);
                tops += top;
                bottoms += !top;
                assert_int_equal(normal_q14[0], 0);
                assert_int_equal(normal_q14[1], top ? 16384 : -16384);
                assert_int_equal(normal_q14[2], 0);
            }
            assert_true(p[1] >= 0);
        }
        assert_int_equal(tops, 1);
        assert_int_equal(bottoms, 1);
    }
}

/* Bit for bit the same on both sides of the plane through handle and spout, normals included. */
static void test_teapot_is_symmetric(void **state)
{
    (void)state;
    for (int n = 0; n < 2; n++) {
        const glint_mesh *m = teapots[n];
        for (int v = 0; v < m->vertex_count; v++) {
            const int16_t *p = m->positions[v], *q = m->normals_q14[v];
            int found = 0;
            for (int w = 0; w < m->vertex_count && !found; w++) {
                const int16_t *r = m->positions[w], *s = m->normals_q14[w];
                found = p[0] == r[0] && p[1] == r[1] && p[2] == -r[2] && q[0] == s[0] && q[1] == s[1] && q[2] == -s[2];
            }
            assert_true(found);
        }
    }
}

static int root(const int *parent, int v)
{
    while (parent[v] != v) {
        v = parent[v];
    }
    return v;
}

/*
 * The teapot's parts by shared vertices: body with rim and bottom, lid, ledge between them, handle, spout. Orientation
 * is consistent within a part (test_surfaces_are_closed), so one sign decides it for the part: the flux of the position
 * about the part's middle through its faces, positive when they face outwards. The ledge is level and faces up.
 */
static void test_teapot_parts_face_outwards(void **state)
{
    (void)state;
    for (int n = 0; n < 2; n++) {
        const glint_mesh *m = teapots[n];
        int *parent = calloc(m->vertex_count, sizeof *parent);
        assert_non_null(parent);
        for (int v = 0; v < m->vertex_count; v++) {
            parent[v] = v;
        }
        for (int t = 0; t < m->triangle_count; t++) {
            for (int k = 1; k < 3; k++) {
                parent[root(parent, m->triangles[t][k])] = root(parent, m->triangles[t][0]);
            }
        }
        int parts = 0, level = 0;
        for (int part = 0; part < m->vertex_count; part++) {
            if (parent[part] != part) {
                continue;
            }
            double middle[3] = {0}, flux = 0;
            int vertices = 0, up = 0;
            for (int v = 0; v < m->vertex_count; v++) {
                if (root(parent, v) == part) {
                    vertices++;
                    up += m->normals_q14[v][1] == 16384;
                    for (int k = 0; k < 3; k++) {
                        middle[k] += m->positions[v][k];
                    }
                }
            }
            for (int t = 0; t < m->triangle_count; t++) {
                if (root(parent, m->triangles[t][0]) == part) {
                    vector a = area(m, t), p = position(m, m->triangles[t][0]);
                    flux += (double)a.x * ((double)p.x - middle[0] / vertices) +
                            (double)a.y * ((double)p.y - middle[1] / vertices) +
                            (double)a.z * ((double)p.z - middle[2] / vertices);
                }
            }
            parts++;
            if (up == vertices) {
                level++;
            } else {
                assert_true(flux > 0);
            }
        }
        assert_int_equal(parts, 5);
        assert_int_equal(level, 1);
        free(parent);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_counts_and_indices),      cmocka_unit_test(test_faces_agree_with_normals),
        cmocka_unit_test(test_normals_are_unit),        cmocka_unit_test(test_surfaces_are_closed),
        cmocka_unit_test(test_seams_are_welded),        cmocka_unit_test(test_spheres_are_unit_spheres),
        cmocka_unit_test(test_knot_lies_about_a_torus), cmocka_unit_test(test_teapot_poles),
        cmocka_unit_test(test_teapot_is_symmetric),     cmocka_unit_test(test_teapot_parts_face_outwards),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
