/* SPDX-License-Identifier: MIT */
/*
 * The lists of triangles by band against a naive search: in each band just the triangles that reach into it, in the
 * order of the scene. And the depth test's runs against a loop over single pixels.
 */
#include "tests/unit/numeric.h"

#include "raster/bands.h"
#include "raster/depth.h"

#define MOST_TRIANGLES 65535
#define MOST_BANDS 2048
#define CANARY 0xa5a5

typedef struct extent {
    uint16_t first, last; /* bands; first > last: not drawn, in no list */
} extent;

static extent extents[MOST_TRIANGLES];
static uint16_t first_of[MOST_BANDS + 1], next_of[MOST_TRIANGLES + 1];

static void choose_extents(int triangles, int bands, int tallest)
{
    for (int i = 0; i < triangles; i++) {
        const int first = random_between(0, bands - 1), last = first + random_between(0, tallest - 1);
        extents[i].first = (uint16_t)first;
        extents[i].last = (uint16_t)(last < bands ? last : bands - 1);
        if (random_between(0, 4) == 0) {
            extents[i].first = (uint16_t)bands;
            extents[i].last = 0;
        }
    }
}

/* Walks the active list as the renderer does: each triangle is met, and dropped in the band where it ends. */
static void expect_band(glint_bands *lists, int triangles, int band)
{
    uint16_t *link = &lists->active;
    for (int expected = 0; expected < triangles; expected++) {
        if (extents[expected].first > band || extents[expected].last < band) {
            continue;
        }
        const uint16_t number = *link;
        if (number != expected) {
            fail_msg("band %d: triangle %u, expected %d", band, number, expected);
        }
        if (extents[number].last == band) {
            *link = lists->next[number];
        } else {
            link = &lists->next[number];
        }
    }
    assert_int_equal(*link, GLINT_NO_TRIANGLE);
}

static void check_frame(int triangles, int bands, int tallest)
{
    glint_bands lists = {first_of, next_of, 0};
    choose_extents(triangles, bands, tallest);
    memset(first_of, 0, sizeof first_of);
    first_of[bands] = next_of[triangles] = CANARY;
    glint_bands_clear(&lists, (uint16_t)bands);
    for (int i = triangles - 1; i >= 0; i--) {
        if (extents[i].first <= extents[i].last) {
            glint_bands_add(&lists, extents[i].first, (uint16_t)i);
        }
    }
    for (int band = 0; band < bands; band++) {
        glint_bands_enter(&lists, (uint16_t)band);
        expect_band(&lists, triangles, band);
    }
    assert_int_equal(lists.active, GLINT_NO_TRIANGLE);
    assert_int_equal(first_of[bands], CANARY);
    assert_int_equal(next_of[triangles], CANARY);
}

static void bands_list_what_a_search_finds(void **state)
{
    (void)state;
    for (int round = 0; round < 20000; round++) {
        const int bands = random_between(1, 20);
        check_frame(random_between(1, 60), bands, random_between(1, bands));
    }
    for (int round = 0; round < 30; round++) {
        check_frame(random_between(500, 3000), random_between(50, 200), random_between(1, 200));
    }
}

static void bands_take_the_greatest_numbers(void **state)
{
    (void)state;
    check_frame(MOST_TRIANGLES, 16, 16);
    check_frame(MOST_TRIANGLES, 1, 1);
    check_frame(1, MOST_BANDS, MOST_BANDS);
    check_frame(2000, MOST_BANDS, 300);
}

static void empty_bands_list_nothing(void **state)
{
    glint_bands lists = {first_of, next_of, 0};
    (void)state;
    glint_bands_clear(&lists, 8);
    for (uint16_t band = 0; band < 8; band++) {
        glint_bands_enter(&lists, band);
        assert_int_equal(lists.active, GLINT_NO_TRIANGLE);
    }
}

#define ROW 64

/* Pixel by pixel: greater passes, equal does not. */
static void expect_runs(uint16_t *row, uint32_t depth, uint32_t step, int16_t x, int16_t x_last)
{
    uint16_t expected[ROW];
    bool passed[ROW] = {false}, found[ROW] = {false};
    uint16_t *at = row + x, *const end = row + x_last + 1;
    uint32_t value = depth;
    memcpy(expected, row, sizeof expected);
    for (int i = x; i <= x_last; i++, value += step) {
        passed[i] = (uint16_t)(value >> GLINT_DEPTH_SHIFT) > expected[i];
        expected[i] = passed[i] ? (uint16_t)(value >> GLINT_DEPTH_SHIFT) : expected[i];
    }
    /* by turns a run that passes, maybe empty, and one that does not */
    for (bool passes = true; at != end; passes = !passes) {
        const uint32_t here = depth + (uint32_t)(at - row - x) * step;
        const uint32_t left = (uint32_t)(end - at);
        uint16_t *const stop =
            at + (passes ? glint_depth_write(at, left, here, step) : glint_depth_skip(at, left, here, step));
        assert_true(stop >= at && stop <= end);
        assert_true(passes || stop > at);
        for (; at != stop; at++) {
            found[at - row] = passes;
        }
    }
    assert_memory_equal(row, expected, sizeof expected);
    assert_memory_equal(found, passed, sizeof passed);
}

static void depth_runs_are_the_pixels_that_pass(void **state)
{
    (void)state;
    for (int round = 0; round < 200000; round++) {
        uint16_t row[ROW];
        const int16_t x = (int16_t)random_between(0, ROW - 1), x_last = (int16_t)random_between(x, ROW - 1);
        /* a plane from one depth at x to another at x_last, so that it stays within the 30 bits */
        const int32_t from = random_between(GLINT_DEPTH_BIAS, GLINT_DEPTH_BIAS + GLINT_DEPTH_SPAN);
        const int32_t to = random_between(GLINT_DEPTH_BIAS, GLINT_DEPTH_BIAS + GLINT_DEPTH_SPAN);
        const int32_t step = round % 5 ? (to - from) / ROW : 0;
        for (int i = 0; i < ROW; i++) {
            const int32_t there = (from + (i - x) * step) >> GLINT_DEPTH_SHIFT; /* equal, one off, or anything */
            row[i] = (uint16_t)(round & 1 ? there + random_between(-1, 1) : random_between(0, 65535));
        }
        expect_runs(row, (uint32_t)from, (uint32_t)step, x, x_last);
        memset(row, 0, sizeof row);
        expect_runs(row, (uint32_t)from, (uint32_t)step, x, x_last); /* nothing there: all pass in one run */
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(bands_list_what_a_search_finds),
        numeric_test(bands_take_the_greatest_numbers),
        numeric_test(empty_bands_list_nothing),
        numeric_test(depth_runs_are_the_pixels_that_pass),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
