/* SPDX-License-Identifier: MIT */
/*
 * Coverage by spans against the reference's whole evaluation of the edge functions: the two sets of pixels are equal,
 * without tolerance. And the boxes, and that a mesh covers each pixel once.
 */
#include "tests/unit/numeric.h"

#include "raster/edges.h"
#include "tests/reference/reference.h"

#define GREATEST GLINT_MAX_SIZE_PX
#define CANARY 0x5a

typedef struct picture {
    int width, height;
    uint8_t *count; /* of each pixel */
} picture;

static void count_pixel(void *context, int x, int y)
{
    picture *p = context;
    p->count[y * p->width + x]++;
}

static uint8_t buffer[2][GREATEST * GREATEST + 16];

static picture blank(int which, int width, int height)
{
    const picture p = {width, height, buffer[which]};
    memset(p.count, 0, (size_t)width * (size_t)height);
    memset(p.count + width * height, CANARY, 16);
    return p;
}

static void expect_canary(const picture *p)
{
    for (int i = 0; i < 16; i++) {
        assert_int_equal(p->count[p->width * p->height + i], CANARY);
    }
}

/* Counts the pixels of rows y_first..y_last of the triangle. Each span must be within rows, columns and order. */
static long draw_rows(const glint_edges *edges, int y_first, int y_last, picture *p)
{
    glint_spans spans;
    int16_t y, x_first, x_last;
    int before = y_first - 1;
    long pixels = 0;
    glint_spans_begin(&spans, edges, (int16_t)y_first, (int16_t)y_last);
    while (glint_spans_next(&spans, &y, &x_first, &x_last)) {
        if (y <= before || y > y_last || x_first > x_last || x_first < edges->box.x_first ||
            x_last > edges->box.x_last) {
            fail_msg("span %d..%d of row %d", x_first, x_last, y);
        }
        for (int x = x_first; x <= x_last; x++) {
            count_pixel(p, x, y);
        }
        pixels += x_last - x_first + 1;
        before = y;
    }
    return pixels;
}

/* Sets up as the library does; false for a triangle that is not drawn. */
static bool set_up(glint_edges *edges, const glint_point corner[3], int width, int height)
{
    const int64_t area = glint_signed_area(corner);
    glint_box box;
    glint_bounding_box(&box, corner, (uint16_t)width, (uint16_t)height);
    if (area == 0 || box.x_first > box.x_last || box.y_first > box.y_last) {
        return false;
    }
    glint_edges_set_up(edges, corner, area > 0, box);
    assert_int_equal(edges->order[0], 0);
    assert_int_equal(edges->order[1], area > 0 ? 1 : 2);
    assert_int_equal(edges->order[2], area > 0 ? 2 : 1);
    return true;
}

static void fail_triangle(const glint_point corner[3], const picture *actual, const picture *expected)
{
    for (int i = 0; i < actual->width * actual->height; i++) {
        if (actual->count[i] != expected->count[i]) {
            fail_msg("(%d, %d) (%d, %d) (%d, %d) on %d x %d px: pixel (%d, %d) is covered %d times, not %d",
                     corner[0].x, corner[0].y, corner[1].x, corner[1].y, corner[2].x, corner[2].y, actual->width,
                     actual->height, i % actual->width, i / actual->width, actual->count[i], expected->count[i]);
        }
    }
}

/* The whole triangle, and a part of its rows. Returns the number of pixels. */
static long check_triangle(const glint_point corner[3], int width, int height)
{
    const int32_t xy[3][2] = {{corner[0].x, corner[0].y}, {corner[1].x, corner[1].y}, {corner[2].x, corner[2].y}};
    picture actual = blank(0, width, height), expected = blank(1, width, height);
    glint_edges edges;
    const long pixels = reference_cover(xy, width, height, count_pixel, &expected);
    assert_true(pixels >= 0);
    if (!set_up(&edges, corner, width, height)) {
        assert_int_equal(pixels, 0);
        return 0;
    }
    const long drawn = draw_rows(&edges, edges.box.y_first, edges.box.y_last, &actual);
    if (drawn != pixels || memcmp(actual.count, expected.count, (size_t)width * (size_t)height) != 0) {
        fail_triangle(corner, &actual, &expected);
    }
    expect_canary(&actual);
    /* rows in three parts, cut anywhere */
    const int first = edges.box.y_first, last = edges.box.y_last;
    const int cut = random_between(first, last), cut2 = random_between(cut, last);
    memset(actual.count, 0, (size_t)width * (size_t)height);
    (void)draw_rows(&edges, first, cut, &actual);
    (void)draw_rows(&edges, cut + 1, cut2, &actual);
    (void)draw_rows(&edges, cut2 + 1, last, &actual);
    if (memcmp(actual.count, expected.count, (size_t)width * (size_t)height) != 0) {
        fail_triangle(corner, &actual, &expected);
    }
    return pixels;
}

/* A coordinate of a display of size_px: within the guard band, of one of several kinds. */
static int32_t random_coordinate(int size_px, int kind)
{
    const int32_t centre = size_px * (GLINT_SUBPIXEL / 2), guard = GLINT_GUARD_PX * GLINT_SUBPIXEL;
    switch (kind) {
    case 0: /* on the display, on any sub-pixel */
        return random_between(0, size_px * GLINT_SUBPIXEL);
    case 1: /* on pixel centres */
        return random_between(-1, size_px) * GLINT_SUBPIXEL + GLINT_SUBPIXEL / 2;
    case 2: /* on lines between pixels */
        return random_between(-1, size_px + 1) * GLINT_SUBPIXEL;
    case 3: /* at the ends of the guard band */
        return random_u32() & 1 ? centre - guard + random_between(0, 2) : centre + guard - random_between(0, 2);
    default: /* anywhere in it */
        return random_between(centre - guard, centre + guard);
    }
}

static void check_random_triangles(int width, int height, int rounds)
{
    long pixels = 0;
    for (int round = 0; round < rounds; round++) {
        glint_point corner[3];
        const int kind = round % 7;
        for (int i = 0; i < 3; i++) {
            const int of_corner = kind < 5 ? kind : random_between(0, 4);
            corner[i].x = random_coordinate(width, of_corner);
            corner[i].y = random_coordinate(height, kind == 6 ? random_between(0, 4) : of_corner);
        }
        if (round % 3 == 1) { /* a sliver: the third corner beside the edge of the other two */
            const double t = (double)random_unit();
            corner[2].x = (int32_t)lround(corner[0].x + t * (corner[1].x - corner[0].x)) + random_between(-1, 1);
            corner[2].y = (int32_t)lround(corner[0].y + t * (corner[1].y - corner[0].y)) + random_between(-1, 1);
        } else if (round % 3 == 2) { /* small */
            for (int i = 1; i < 3; i++) {
                corner[i].x = corner[0].x + random_between(-700, 700);
                corner[i].y = corner[0].y + random_between(-700, 700);
            }
            if (kind == 3 || kind == 4) {
                continue; /* out of the guard band */
            }
        }
        if (round % 11 == 0) {
            corner[1].y = corner[0].y; /* a horizontal edge */
        } else if (round % 11 == 1) {
            corner[2].x = corner[1].x; /* an upright one */
        }
        pixels += check_triangle(corner, width, height);
    }
    print_message("    %d x %d: %ld pixels\n", width, height, pixels);
    assert_true(pixels > 0);
}

static void spans_are_the_exact_coverage(void **state)
{
    (void)state;
    check_random_triangles(1, 1, 60000);
    check_random_triangles(1, 64, 20000);
    check_random_triangles(5, 3, 60000);
    check_random_triangles(16, 16, 40000);
    check_random_triangles(64, 48, 10000);
    check_random_triangles(320, 240, 700);
    check_random_triangles(2048, 7, 1000);
    check_random_triangles(7, 2048, 1000);
    check_random_triangles(2048, 2048, 24);
}

/* The extreme triangles: corners in the corners of the guard band, where the edge functions are greatest. */
static void spans_are_exact_at_the_guard_band(void **state)
{
    static const int sizes[3] = {1, 240, 2048};
    long pixels = 0;
    (void)state;
    for (int s = 0; s < 3; s++) {
        const int32_t centre = sizes[s] * (GLINT_SUBPIXEL / 2), guard = GLINT_GUARD_PX * GLINT_SUBPIXEL;
        for (int code = 0; code < 64; code++) {
            glint_point corner[3];
            for (int i = 0; i < 3; i++) {
                corner[i].x = centre + (code >> (2 * i) & 1 ? guard : -guard);
                corner[i].y = centre + (code >> (2 * i + 1) & 1 ? guard : -guard);
            }
            pixels += check_triangle(corner, sizes[s], sizes[s]);
        }
    }
    /* 24 of the 64 have an area, each half of the band's square; who owns the diagonal tips the balance */
    assert_true(pixels > 23 * 2048 * 2048 / 2);
}

/* All triangles with corners on half pixels of a display of 4 x 4 px: on centres, on grid lines, on its border. */
static void every_triangle_of_a_small_grid_is_exact(void **state)
{
    enum { SIDE = 9 };
    long pixels = 0;
    (void)state;
    for (int a = 0; a < SIDE * SIDE; a++) {
        for (int b = 0; b < SIDE * SIDE; b++) {
            for (int c = 0; c < SIDE * SIDE; c++) {
                const glint_point corner[3] = {{a % SIDE * 128, a / SIDE * 128},
                                               {b % SIDE * 128, b / SIDE * 128},
                                               {c % SIDE * 128, c / SIDE * 128}};
                pixels += check_triangle(corner, 4, 4);
            }
        }
    }
    print_message("    %ld pixels\n", pixels);
    assert_true(pixels > 0);
}

typedef struct mesh_case {
    int size_px, cells, grid; /* corners on multiples of `grid` sub-pixels */
} mesh_case;

static glint_point mesh_corner(const mesh_case *mesh, int i, int k)
{
    const int32_t cell = mesh->size_px * GLINT_SUBPIXEL / mesh->cells, jitter = cell / 4 - 1;
    glint_point p = {i * cell, k * cell};
    if (i > 0 && i < mesh->cells) {
        p.x += random_between(-jitter, jitter) / mesh->grid * mesh->grid;
    }
    if (k > 0 && k < mesh->cells) {
        p.y += random_between(-jitter, jitter) / mesh->grid * mesh->grid;
    }
    return p;
}

static void draw_of_mesh(const glint_point *a, const glint_point *b, const glint_point *c, picture *p)
{
    const bool turned = random_u32() & 1;
    const glint_point corner[3] = {*a, turned ? *c : *b, turned ? *b : *c};
    glint_edges edges;
    if (set_up(&edges, corner, p->width, p->height)) {
        (void)draw_rows(&edges, edges.box.y_first, edges.box.y_last, p);
    }
}

static void meshes_cover_each_pixel_once(void **state)
{
    static const mesh_case cases[4] = {{64, 16, 1}, {64, 16, 128}, {96, 96, 1}, {60, 120, 2}};
    (void)state;
    for (int round = 0; round < 400; round++) {
        const mesh_case *mesh = &cases[round % 4];
        glint_point corner[121][121];
        picture p = blank(0, mesh->size_px, mesh->size_px);
        for (int k = 0; k <= mesh->cells; k++) {
            for (int i = 0; i <= mesh->cells; i++) {
                corner[k][i] = mesh_corner(mesh, i, k);
            }
        }
        for (int k = 0; k < mesh->cells; k++) {
            for (int i = 0; i < mesh->cells; i++) {
                const glint_point *a = &corner[k][i], *b = &corner[k][i + 1], *c = &corner[k + 1][i + 1],
                                  *d = &corner[k + 1][i];
                const bool falling = random_u32() & 1;
                draw_of_mesh(a, b, falling ? c : d, &p);
                draw_of_mesh(falling ? a : b, c, d, &p);
            }
        }
        for (int i = 0; i < mesh->size_px * mesh->size_px; i++) {
            assert_int_equal(p.count[i], 1);
        }
    }
}

/* Triangles from the display's border to one point of it: slivers of all directions that share their edges. */
static void fans_cover_each_pixel_once(void **state)
{
    (void)state;
    for (int round = 0; round < 300; round++) {
        const int size = 40;
        const int32_t side = size * GLINT_SUBPIXEL, parts = random_between(1, 400);
        glint_point hub = {random_between(0, side), random_between(0, side)};
        picture p = blank(0, size, size);
        if (round & 1) {
            hub.x = hub.x / 128 * 128;
            hub.y = hub.y / 128 * 128;
        }
        for (int32_t i = 0; i < 4 * parts; i++) {
            glint_point rim[2];
            for (int end = 0; end < 2; end++) {
                const int32_t along = (i + end) % parts * side / parts, edge = (i + end) / parts % 4;
                rim[end].x = edge == 0 ? along : edge == 1 ? side : edge == 2 ? side - along : 0;
                rim[end].y = edge == 0 ? 0 : edge == 1 ? along : edge == 2 ? side : side - along;
            }
            draw_of_mesh(&hub, &rim[0], &rim[1], &p);
        }
        for (int i = 0; i < size * size; i++) {
            assert_int_equal(p.count[i], 1);
        }
    }
}

/* The greatest pixel number of -1..size - 1 whose centre is not after a coordinate, tried one by one. */
static int last_centre(int64_t subpixels, int size)
{
    int pixel = size - 1;
    while (pixel >= 0 && (int64_t)pixel * 256 + 128 > subpixels) {
        pixel--;
    }
    return pixel;
}

static void last_pixel_is_the_last_centre(void **state)
{
    static const int32_t special[] = {INT32_MIN, INT32_MIN + 1, INT32_MAX, INT32_MAX - 1, -1, 0, 1, 127, 128, 129};
    static const uint16_t sizes[4] = {1, 2, 240, 2048};
    (void)state;
    for (int s = 0; s < 4; s++) {
        for (size_t i = 0; i < sizeof special / sizeof *special; i++) {
            assert_int_equal(glint_last_pixel(special[i], sizes[s]), last_centre(special[i], sizes[s]));
        }
        for (int32_t c = -1000; c<sizes[s] * 256 + 1000; c += sizes[s]> 1000 ? 61 : 1) {
            assert_int_equal(glint_last_pixel(c, sizes[s]), last_centre(c, sizes[s]));
        }
    }
}

static void boxes_hold_the_centres_in_the_bounds(void **state)
{
    (void)state;
    for (int round = 0; round < 300000; round++) {
        const int size[2] = {random_between(1, round & 1 ? 4 : 64), random_between(1, 64)};
        int32_t xy[2][3];
        glint_point corner[3];
        for (int i = 0; i < 3; i++) {
            corner[i].x = xy[0][i] = random_coordinate(size[0], round % 5);
            corner[i].y = xy[1][i] = random_coordinate(size[1], round / 5 % 5);
        }
        glint_box box;
        glint_bounding_box(&box, corner, (uint16_t)size[0], (uint16_t)size[1]);
        const int16_t first[2] = {box.x_first, box.y_first}, last[2] = {box.x_last, box.y_last};
        for (int axis = 0; axis < 2; axis++) {
            int32_t low = xy[axis][0], high = low;
            for (int i = 1; i < 3; i++) {
                low = xy[axis][i] < low ? xy[axis][i] : low;
                high = xy[axis][i] > high ? xy[axis][i] : high;
            }
            int expected = 0;
            while (expected < size[axis] && expected * 256 + 128 < low) {
                expected++;
            }
            assert_int_equal(first[axis], expected);
            /* columns to the last centre at or before the corners, rows to the last centre before them */
            assert_int_equal(last[axis], last_centre(axis == 0 ? high : high - 1, size[axis]));
        }
    }
}

static void areas_are_exact_and_signed_clockwise(void **state)
{
    const glint_point clockwise[3] = {{0, 0}, {256, 0}, {0, 256}}; /* right, then down */
    (void)state;
    assert_true(glint_signed_area(clockwise) == 65536);
    for (int round = 0; round < 1000000; round++) {
        glint_point p[3];
        for (int i = 0; i < 3; i++) {
            p[i].x = random_coordinate(2048, 3 + (round & 1));
            p[i].y = random_coordinate(2048, 3 + (round & 1));
        }
        const wide area = (wide)(p[1].x - p[0].x) * (p[2].y - p[0].y) - (wide)(p[1].y - p[0].y) * (p[2].x - p[0].x);
        assert_true((wide)glint_signed_area(p) == area);
    }
}

static void snapping_rounds_to_nearest(void **state)
{
    (void)state;
    for (int32_t c = -100000; c < 100000; c++) {
        const glint_screen_vertex v = {c, -c, 0};
        const glint_point p = glint_snap(&v);
        assert_int_equal(p.x, (int32_t)floor(c / 16.0 + 0.5));
        assert_int_equal(p.y, (int32_t)floor(-c / 16.0 + 0.5));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(spans_are_the_exact_coverage),
        numeric_test(spans_are_exact_at_the_guard_band),
        numeric_test(every_triangle_of_a_small_grid_is_exact),
        numeric_test(meshes_cover_each_pixel_once),
        numeric_test(fans_cover_each_pixel_once),
        numeric_test(last_pixel_is_the_last_centre),
        numeric_test(boxes_hold_the_centres_in_the_bounds),
        numeric_test(areas_are_exact_and_signed_clockwise),
        numeric_test(snapping_rounds_to_nearest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
