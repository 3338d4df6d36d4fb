/* SPDX-License-Identifier: MIT */
/*
 * Tests of the reference's exact coverage: partitions of the plane, and another way to state the top-left rule.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/reference/reference.h"

#define GRID 12

static void count_pixel(void *context, int x, int y)
{
    int *counts = context;
    counts[y * GRID + x]++;
}

static void split_square_is_covered_once(void **state)
{
    (void)state;
    for (int offset = 0; offset < 512; offset += 64) { /* edges on, and beside, pixel centres */
        int32_t low = 256 + offset, high = 7 * 256 + offset;
        const int32_t a[3][2] = {{low, low}, {high, low}, {high, high}},
                      b[3][2] = {{low, low}, {low, high}, {high, high}};
        int counts[GRID * GRID] = {0};
        assert_int_equal(reference_cover(a, GRID, GRID, count_pixel, counts) +
                             reference_cover(b, GRID, GRID, count_pixel, counts),
                         36);
        for (int i = 0; i < GRID * GRID; i++) { /* left and top edges belong, right and bottom ones do not */
            int x = i % GRID * 256 + 128, y = i / GRID * 256 + 128;
            assert_int_equal(counts[i], x >= low && x < high && y >= low && y < high);
        }
    }
}

static void fan_around_a_centre_covers_it_once(void **state)
{
    static const int32_t rim[8][2] = {{128, 128},   {1408, 128},  {2688, 128}, {2688, 1408},
                                      {2688, 2688}, {1408, 2688}, {128, 2688}, {128, 1408}};
    int counts[GRID * GRID] = {0};
    (void)state;
    for (int i = 0; i < 8; i++) { /* every other one turned round */
        const int32_t *p = rim[i], *q = rim[(i + 1) % 8];
        const int32_t fan[3][2] = {
            {1408, 1408}, {i % 2 ? p[0] : q[0], i % 2 ? p[1] : q[1]}, {i % 2 ? q[0] : p[0], i % 2 ? q[1] : p[1]}};
        reference_cover(fan, GRID, GRID, count_pixel, counts);
    }
    for (int i = 0; i < GRID * GRID; i++) {
        assert_int_equal(counts[i], i % GRID < 10 && i / GRID < 10);
    }
}

/* Another way to the same rule: a centre on an edge belongs to the triangle when the point a little to the right, and
 * much less a little down, is inside. In units of 1/(256 * 2^20) px the products fit int64 here. */
static void coverage_agrees_with_a_moved_centre(void **state)
{
    uint32_t seed = 12345;
    long on_edges = 0;
    (void)state;
    for (int round = 0; round < 20000; round++) {
        int32_t t[3][2];
        int counts[GRID * GRID] = {0};
        int64_t area;
        for (int i = 0; i < 6; i++) {
            seed = seed * 1664525u + 1013904223u;
            t[i / 2][i % 2] = (int32_t)(seed >> 16) % 17 * 64 - 128; /* coarse, so that centres fall on edges */
        }
        area = (int64_t)(t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (int64_t)(t[1][1] - t[0][1]) * (t[2][0] - t[0][0]);
        reference_cover((const int32_t(*)[2])t, GRID, GRID, count_pixel, counts);
        for (int i = 0; i < GRID * GRID; i++) {
            int64_t x = ((int64_t)(i % GRID * 256 + 128) << 20) + 4096, y = ((int64_t)(i / GRID * 256 + 128) << 20) + 1;
            bool inside = area != 0;
            for (int k = 0; k < 3; k++) {
                const int32_t *a = t[k], *b = t[(k + 1) % 3];
                int64_t e = (b[0] - a[0]) * (y - ((int64_t)a[1] * (1 << 20))) -
                            (b[1] - a[1]) * (x - ((int64_t)a[0] * (1 << 20)));
                int64_t whole = (int64_t)(b[0] - a[0]) * (i / GRID * 256 + 128 - a[1]) -
                                (int64_t)(b[1] - a[1]) * (i % GRID * 256 + 128 - a[0]);
                assert_true(e != 0 || area == 0);
                inside = inside && (e > 0) == (area > 0);
                on_edges += whole == 0;
            }
            assert_int_equal(counts[i], inside);
        }
    }
    assert_true(on_edges > 10000);
}

static void coverage_keeps_to_its_range(void **state)
{
    const int32_t whole[3][2] = {{-REFERENCE_MAX_COORDINATE, -REFERENCE_MAX_COORDINATE},
                                 {REFERENCE_MAX_COORDINATE, -REFERENCE_MAX_COORDINATE},
                                 {-REFERENCE_MAX_COORDINATE, REFERENCE_MAX_COORDINATE}};
    const int32_t beyond[3][2] = {{REFERENCE_MAX_COORDINATE + 1, 0}, {0, 0}, {0, 1}};
    const int32_t flat[3][2] = {{0, 0}, {512, 512}, {1024, 1024}};
    (void)state;
    /* below the line x + y = 0: no centre of the picture is above it */
    assert_int_equal(reference_cover(whole, GRID, GRID, NULL, NULL), 0);
    assert_int_equal(reference_cover(beyond, GRID, GRID, NULL, NULL), -1);
    assert_int_equal(reference_cover(flat, GRID, GRID, NULL, NULL), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(split_square_is_covered_once),
        cmocka_unit_test(fan_around_a_centre_covers_it_once),
        cmocka_unit_test(coverage_agrees_with_a_moved_centre),
        cmocka_unit_test(coverage_keeps_to_its_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
