/* SPDX-License-Identifier: MIT */
/*
 * Hard cases E, the part that edge functions and spans decide: both backends share them. docs/hard-cases.md has the
 * defined behaviour; hard.h the form of a test.
 *
 * GLINT_LONG=1 counts 10^8 pixels in E1 and E2.
 *
 * Budgets: none. Coverage is exact.
 */
#define PIXELS_DEFAULT 10000000L /* E1, E2 */
#define PIXELS_LONG 100000000L

#include "tests/hard/raster.h"

#define MESH_MOST 128

typedef struct mesh_case {
    int size_px, cells, grid; /* corners on multiples of `grid` sub-pixels */
} mesh_case;

static glint_point jittered(const mesh_case *mesh, int i, int k)
{
    const int32_t cell = mesh->size_px * 256 / mesh->cells, jitter = cell / 4 - 1;
    glint_point p = {i * cell, k * cell};
    if (i > 0 && i < mesh->cells) {
        p.x += hard_between(-jitter, jitter) / mesh->grid * mesh->grid;
    }
    if (k > 0 && k < mesh->cells) {
        p.y += hard_between(-jitter, jitter) / mesh->grid * mesh->grid;
    }
    return p;
}

/* kind: 0 Glint, 1 naive with the edges, 2 naive without. The winding changes from triangle to triangle. */
static void add_of_kind(raster *r, int kind, const glint_point *a, const glint_point *b, const glint_point *c)
{
    const bool turned = hard_random() & 1;
    const glint_point corner[3] = {*a, turned ? *c : *b, turned ? *b : *c};
    if (kind == 0) {
        (void)raster_add(r, corner);
    } else {
        (void)raster_add_naive(r, corner, kind == 1, 128);
    }
}

static void add_mesh(raster *r, const mesh_case *mesh, int kind)
{
    static glint_point corner[MESH_MOST + 1][MESH_MOST + 1];
    for (int k = 0; k <= mesh->cells; k++) {
        for (int i = 0; i <= mesh->cells; i++) {
            corner[k][i] = jittered(mesh, i, k);
        }
    }
    for (int k = 0; k < mesh->cells; k++) {
        for (int i = 0; i < mesh->cells; i++) {
            const glint_point *a = &corner[k][i], *b = &corner[k][i + 1], *c = &corner[k + 1][i + 1],
                              *d = &corner[k + 1][i];
            const bool falling = hard_random() & 1;
            add_of_kind(r, kind, a, b, falling ? c : d);
            add_of_kind(r, kind, falling ? a : b, c, d);
        }
    }
}

static void test_E1_shared_edge(void **state)
{
    (void)state;
    static const mesh_case cases[] = {{64, 16, 1}, {64, 16, 128}, {128, 128, 1}, {120, 120, 2}, {512, 32, 16}};
    static const mesh_case on_centres = {32, 8, 128};
    long naive[2], counted = 0;
    for (int kind = 1; kind <= 2; kind++) {
        raster r = raster_make(on_centres.size_px, on_centres.size_px);
        add_mesh(&r, &on_centres, kind);
        naive[kind - 1] = raster_not_once(&r);
        raster_free(&r);
    }
    assert_true(naive[0] > 10 && naive[1] > 10);
    const long wanted = is_long_run() ? PIXELS_LONG : PIXELS_DEFAULT;
    for (size_t round = 0; counted < wanted; round++) {
        const mesh_case *mesh = &cases[round % (sizeof cases / sizeof *cases)];
        raster r = raster_make(mesh->size_px, mesh->size_px);
        add_mesh(&r, mesh, 0);
        assert_int_equal(raster_not_once(&r), 0);
        counted += (long)mesh->size_px * mesh->size_px;
        raster_free(&r);
    }
    hard_pass("E1", "shared edge", text("of 1024 px %ld hit twice with >= 0, %ld missed with > 0", naive[0], naive[1]),
              text("each of %ld px of jittered meshes exactly once: 0 gaps, 0 overlaps", counted));
}

/* A fan from the raster's border to a hub, in `parts` triangles a side. */
static void add_fan(raster *r, int kind, glint_point hub, int32_t parts)
{
    const int32_t side = r->width * 256;
    for (int32_t i = 0; i < 4 * parts; i++) {
        glint_point rim[2];
        for (int end = 0; end < 2; end++) {
            const int32_t along = (i + end) % parts * side / parts, edge = (i + end) / parts % 4;
            rim[end].x = edge == 0 ? along : edge == 1 ? side : edge == 2 ? side - along : 0;
            rim[end].y = edge == 0 ? 0 : edge == 1 ? along : edge == 2 ? side : side - along;
        }
        add_of_kind(r, kind, &hub, &rim[0], &rim[1]);
    }
}

static void test_E2_vertex_on_a_sample_point(void **state)
{
    (void)state;
    enum { SIDE = 64 };
    const glint_point centre = {10 * 256 + 128, 17 * 256 + 128};
    long naive[2], counted = 0, hubs = 0;
    for (int kind = 1; kind <= 2; kind++) {
        raster r = raster_make(SIDE, SIDE);
        add_fan(&r, kind, centre, 6);
        naive[kind - 1] = r.count[17 * SIDE + 10];
        raster_free(&r);
    }
    assert_true(naive[0] == 24 && naive[1] == 0);
    const long wanted = is_long_run() ? PIXELS_LONG : PIXELS_DEFAULT;
    for (int round = 0; counted < wanted; round++) {
        raster r = raster_make(SIDE, SIDE);
        glint_point hub = {hard_between(0, SIDE * 256), hard_between(0, SIDE * 256)};
        if (round % 4 < 3) { /* on a sample point */
            hub.x = hub.x / 256 % SIDE * 256 + 128;
            hub.y = hub.y / 256 % SIDE * 256 + 128;
            hubs++;
        }
        add_fan(&r, 0, hub, hard_between(1, round % 8 == 0 ? 400 : 12));
        assert_int_equal(raster_not_once(&r), 0);
        counted += SIDE * SIDE;
        raster_free(&r);
    }
    hard_pass("E2", "vertex on a sample point, fan of n triangles",
              text("a hub of 24 triangles is hit %ld times with >= 0, %ld with > 0", naive[0], naive[1]),
              text("each of %ld px exactly once, %ld hubs of 4 to 1600 triangles on sample points", counted, hubs));
}

static void test_E7_far_off_screen(void **state)
{
    (void)state;
    /* Naive: the edge function in 32 bits of sub-pixels. */
    const glint_point far[3] = {{-9000 * 256, -7000 * 256}, {9500 * 256, -6500 * 256}, {100 * 256, 9000 * 256}};
    int naive = 0;
    for (int i = 0; i < 3; i++) {
        const int64_t exact = edge_at(&far[i], &far[(i + 1) % 3], 32 * 256 + 128, 32 * 256 + 128);
        const uint32_t wrapped = (uint32_t)exact;
        naive += (exact >= 0) != (wrapped < 0x80000000u);
    }
    assert_true(naive > 0);
    /* In the guard band all is exact. */
    long pixels = 0;
    const int32_t guard = GLINT_GUARD_PX * 256;
    for (int round = 0; round < 400; round++) {
        glint_point corner[3];
        raster a = raster_make(240, 180), b = raster_make(240, 180);
        for (int i = 0; i < 3; i++) {
            corner[i].x = 120 * 256 + (round % 2 ? hard_between(-guard, guard) : hard_random() & 1 ? guard : -guard);
            corner[i].y = 90 * 256 + (round % 4 < 2 ? hard_between(-guard, guard) : hard_random() & 1 ? guard : -guard);
        }
        pixels += raster_add(&a, corner);
        (void)raster_add_reference(&b, corner);
        assert_true(raster_same(&a, &b));
        raster_free(&a);
        raster_free(&b);
    }
    assert_true(pixels > 100000);
    /* Beyond it the vertex stage clips: a board of 32767 units right before the eye, 32 px a unit. */
    double worst = 0;
    for (int round = 0; round < 24; round++) {
        board b;
        board_set_up(&b);
        b.material.ambient = b.scene.ambient = board_grey(16384);
        b.scene.light_count = 0;
        b.mesh.fraction_bits = (int8_t)(round % 8);
        b.camera.near_q16 = 1 << 14;
        for (int i = 0; i < 4; i++) {
            b.positions[i][0] =
                (int16_t)hard_between(b.positions[i][0] < 0 ? -32768 : 20000, b.positions[i][0] < 0 ? -20000 : 32767);
            b.positions[i][1] = (int16_t)hard_between(-32768, 32767);
        }
        worst = worse_of(worst, expect_reference(&b.scene, 64, 48, GLINT_SHADING_EXACT, "far corners"));
    }
    hard_pass(
        "E7", "far off screen", text("%d of 3 edge functions have the wrong sign in 32 bits", naive),
        text("guard band of %d px exact (%ld px), the rest clipped: within %.2f codes", GLINT_GUARD_PX, pixels, worst));
}

static void test_E8_edge_in_the_other_direction(void **state)
{
    (void)state;
    long naive = 0, rows = 0, counted = 0;
    for (int round = 0; round < 20000; round++) {
        /* Naive: x along the edge in 16.16, stepped from the top and from the bottom. */
        const int32_t height = hard_between(2, 200), width = hard_between(-3000, 3000);
        const int32_t slope = (int32_t)((int64_t)width * 65536 / height), end = (int32_t)((uint32_t)width << 16);
        for (int32_t y = 0; y <= height; y++) {
            naive += (slope * y) >> 16 != (end - slope * (height - y)) >> 16;
            rows++;
        }
    }
    assert_true(naive > 10000);
    for (int round = 0; round < 4000; round++) {
        glint_point p[4];
        raster r = raster_make(48, 48), whole = raster_make(48, 48);
        for (int i = 0; i < 4; i++) { /* a quadrilateral with a corner on each side: always convex */
            const int32_t along = hard_between(1, 48 * 256 - 1), far = i == 1 || i == 2 ? 48 * 256 : 0;
            p[i].x = i % 2 == 0 ? along : far;
            p[i].y = i % 2 == 0 ? far : along;
        }
        const glint_point down[3] = {p[0], p[1], p[2]}, up[3] = {p[2], p[0], p[3]}; /* p0 to p2, and p2 to p0 */
        counted += raster_add(&r, down) + raster_add(&r, up);
        const glint_point other[3] = {p[1], p[2], p[3]}, rest[3] = {p[1], p[3], p[0]};
        (void)raster_add_reference(&whole, other);
        (void)raster_add_reference(&whole, rest);
        assert_true(raster_same(&r, &whole));
        raster_free(&r);
        raster_free(&whole);
    }
    hard_pass("E8", "edge walked in the other direction",
              text("16.16 slopes from either end: another pixel in %ld of %ld rows", naive, rows),
              text("both directions of 4000 edges agree: %ld px, each once", counted));
}

static void test_E9_negative_coordinates(void **state)
{
    (void)state;
    int naive = 0;
    for (int32_t c = -4096; c < 0; c++) {
        naive += (c + 127) / 256 != (int32_t)floor((c + 127) / 256.0); /* truncation towards 0 */
    }
    assert_true(naive > 3000);
    long counted = 0;
    enum { SIDE = 96, SHIFT = 40 };
    for (int round = 0; round < 3000; round++) {
        glint_point here[3], there[3];
        raster a = raster_make(SIDE, SIDE), b = raster_make(SIDE, SIDE);
        for (int i = 0; i < 3; i++) {
            here[i].x = hard_between(0, SIDE * 256);
            here[i].y = hard_between(0, SIDE * 256);
            there[i].x = here[i].x - SHIFT * 256;
            there[i].y = here[i].y - SHIFT * 256;
        }
        (void)raster_add(&a, here);
        (void)raster_add(&b, there);
        for (int y = 0; y + SHIFT < SIDE; y++) {
            for (int x = 0; x + SHIFT < SIDE; x++) {
                assert_int_equal(b.count[y * SIDE + x], a.count[(y + SHIFT) * SIDE + x + SHIFT]);
                counted += b.count[y * SIDE + x];
            }
        }
        raster_free(&a);
        raster_free(&b);
    }
    assert_true(counted > 100000);
    /* snapping and the vertex stage: mirrored triangles to both sides of the display's corner */
    for (int32_t c = -100000; c < 100000; c += 7) {
        const glint_screen_vertex v = {c, c - 4096, 0}, shifted = {c + 40 * 4096, c + 39 * 4096, 0};
        assert_int_equal(glint_snap(&v).x + 40 * 256, glint_snap(&shifted).x);
        assert_int_equal(glint_snap(&v).y + 40 * 256, glint_snap(&shifted).y);
    }
    hard_pass("E9", "negative coordinates", text("%d of 4096 pixel numbers wrong by truncation", naive),
              text("floor: a shift by 40 px into the negative changes nothing at %ld px", counted));
}

static void test_E10_pixel_centres(void **state)
{
    (void)state;
    long naive = 0, counted = 0;
    for (int round = 0; round < 3000; round++) {
        glint_point corner[3];
        raster a = raster_make(20, 20), b = raster_make(20, 20), n = raster_make(20, 20);
        const int32_t grid = round % 3 == 0 ? 128 : round % 3 == 1 ? 256 : 1;
        for (int i = 0; i < 3; i++) {
            corner[i].x = hard_between(-1000, 21 * 256) / grid * grid;
            corner[i].y = hard_between(-1000, 21 * 256) / grid * grid;
        }
        counted += raster_add(&a, corner);
        (void)raster_add_reference(&b, corner);
        (void)raster_add_naive(&n, corner, true, 0); /* at the pixel's corner */
        assert_true(raster_same(&a, &b));
        naive += !raster_same(&n, &b);
        raster_free(&a);
        raster_free(&b);
        raster_free(&n);
    }
    assert_true(naive > 2000);
    hard_pass("E10", "pixel centres", text("sampled at pixel corners, %ld of 3000 triangles are another shape", naive),
              text("equal to exact rational coverage: 3000 triangles, %ld px", counted));
}

static void test_E12_larger_than_the_screen(void **state)
{
    (void)state;
    const int64_t exact = (int64_t)(2880 * 256) * (2880 * 256);
    const uint32_t naive = (uint32_t)exact;
    assert_true((int64_t)naive != exact);
    static const int sizes[] = {1, 64, 240, 1024, 2048};
    long counted = 0;
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        const int32_t centre = sizes[s] * 128, guard = GLINT_GUARD_PX * 256;
        /* corners of the guard band: two triangles make its square, the display is in the middle */
        const glint_point square[4] = {{centre - guard, centre - guard},
                                       {centre + guard, centre - guard},
                                       {centre + guard, centre + guard},
                                       {centre - guard, centre + guard}};
        for (int way = 0; way < 2; way++) {
            raster r = raster_make(sizes[s], sizes[s]);
            for (int half = 0; half < 2; half++) {
                const glint_point corner[3] = {square[way], square[way + 1 + half], square[(way + 2 + half) % 4]};
                raster b = raster_make(sizes[s], sizes[s]);
                const long pixels = raster_add(&r, corner);
                assert_int_equal(pixels, raster_add_reference(&b, corner));
                counted += pixels;
                raster_free(&b);
            }
            assert_int_equal(raster_not_once(&r), 0);
            raster_free(&r);
        }
    }
    hard_pass("E12", "triangle larger than the screen",
              text("an area of %lld is %u in 32 bits", (long long)exact, naive),
              text("exact in displays of 1 to 2048 px: %ld px, each once", counted));
}

static void test_E15_tall_triangle(void **state)
{
    (void)state;
    enum { WIDE = 64, TALL = 2048 };
    long naive = 0, counted = 0;
    double drift = 0;
    for (int round = 0; round < 60; round++) {
        const glint_point corner[3] = {{hard_between(0, WIDE * 256), hard_between(0, 300)},
                                       {hard_between(0, WIDE * 256), TALL * 256 - hard_between(0, 300)},
                                       {hard_between(0, WIDE * 256), hard_between(0, TALL * 256)}};
        raster a = raster_make(WIDE, TALL), b = raster_make(WIDE, TALL);
        counted += raster_add(&a, corner);
        (void)raster_add_reference(&b, corner);
        assert_true(raster_same(&a, &b));
        /* Naive: x of the long edge in 24.8 px, stepped from row to row. */
        const int32_t slope_q8 = (int32_t)((int64_t)(corner[1].x - corner[0].x) * 256 / (corner[1].y - corner[0].y));
        for (int32_t y = 0, x_q8 = corner[0].x; y < TALL - 2; y++, x_q8 += slope_q8) {
            const double exact =
                corner[0].x + (double)(corner[1].x - corner[0].x) * y * 256 / (corner[1].y - corner[0].y);
            naive += fabs(x_q8 - exact) > 256;
            drift = worse_of(drift, fabs(x_q8 - exact) / 256);
        }
        raster_free(&a);
        raster_free(&b);
    }
    assert_true(naive > 1000 && drift > 2);
    hard_pass("E15", "tall triangle", text("an edge stepped in 24.8 drifts by up to %.1f px over 2048 rows", drift),
              text("exact in each of 2048 rows: 60 triangles, %ld px", counted));
}

/* Coverage of 8 x 8 px as one bit a pixel. */
static void mark_bit(void *context, int x, int y)
{
    *(uint64_t *)context |= (uint64_t)1 << (8 * y + x);
}

static uint64_t spans_of(const glint_point corner[3])
{
    uint64_t bits = 0;
    glint_edges edges;
    glint_spans spans;
    int16_t y, first, last;
    const int64_t area = glint_signed_area(corner);
    glint_box box;
    glint_bounding_box(&box, corner, 8, 8);
    if (area == 0 || box.x_first > box.x_last || box.y_first > box.y_last) {
        return 0;
    }
    glint_edges_set_up(&edges, corner, area > 0, box);
    glint_spans_begin(&spans, &edges, box.y_first, box.y_last);
    while (glint_spans_next(&spans, &y, &first, &last)) {
        for (int16_t x = first; x <= last; x++) {
            mark_bit(&bits, x, y);
        }
    }
    return bits;
}

/* Vertices on half pixels, 17 x 17 of them. No symmetry is made use of: a fill rule is none under reflection, and the
 * rest is done in seconds. Each triangle is set up in all orders of its vertices. */
static void test_E16_all_triangles_on_a_small_grid(void **state)
{
    (void)state;
    enum { STEPS = 17, POINTS = STEPS * STEPS };
    static const uint8_t orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    long triangles = 0, naive = 0;
    for (int a = 0; a < POINTS; a++) {
        for (int b = a; b < POINTS; b++) {
            for (int c = b; c < POINTS; c++) {
                const int index[3] = {a, b, c};
                glint_point p[3];
                for (int i = 0; i < 3; i++) {
                    p[i].x = index[i] % STEPS * 128;
                    p[i].y = index[i] / STEPS * 128;
                }
                const int32_t corners[3][2] = {{p[0].x, p[0].y}, {p[1].x, p[1].y}, {p[2].x, p[2].y}};
                uint64_t exact = 0;
                assert_true(reference_cover(corners, 8, 8, mark_bit, &exact) >= 0);
                for (int order = 0; order < 6; order++) {
                    const glint_point turned[3] = {p[orders[order][0]], p[orders[order][1]], p[orders[order][2]]};
                    if (spans_of(turned) != exact) {
                        fail_msg("(%d %d) (%d %d) (%d %d) order %d", p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y,
                                 order);
                    }
                }
                if (triangles % 997 == 0) {
                    raster r = raster_make(8, 8);
                    uint64_t bits = 0;
                    (void)raster_add_naive(&r, p, true, 128);
                    for (int i = 0; i < 64; i++) {
                        bits |= (uint64_t)(r.count[i] & 1) << i;
                    }
                    naive += bits != exact;
                    raster_free(&r);
                }
                triangles++;
            }
        }
    }
    assert_true(triangles == (long)POINTS * (POINTS + 1) * (POINTS + 2) / 6 && naive > 100);
    hard_pass("E16", "all triangles on an 8x8 px grid at one sub-pixel bit",
              text("without a fill rule %ld of %ld sampled triangles are wrong", naive, (triangles + 996) / 997),
              text("equal to exact rational coverage: all %ld triangles, 6 orders of vertices each", triangles));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        hard_test(test_E1_shared_edge),
        hard_test(test_E2_vertex_on_a_sample_point),
        hard_test(test_E7_far_off_screen),
        hard_test(test_E8_edge_in_the_other_direction),
        hard_test(test_E9_negative_coordinates),
        hard_test(test_E10_pixel_centres),
        hard_test(test_E12_larger_than_the_screen),
        hard_test(test_E15_tall_triangle),
        hard_test(test_E16_all_triangles_on_a_small_grid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
