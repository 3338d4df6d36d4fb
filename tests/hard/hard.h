/* SPDX-License-Identifier: MIT */
/*
 * What the tests of the hard cases share. A test runs a naive version of a few lines where that is cheap, and asserts
 * that it fails, so that the test is known to bite; asserts what Glint does; and prints one line that
 * tools/hard-cases.sh gathers:
 *
 *     HARD|<id>|<case>|<naive: what was measured>|<Glint: what was measured>|pass
 *
 * The line comes last, so a test that fails prints none. A text that begins with "not built yet:" tells what the row
 * asks for beyond today's library; "skip" in place of "pass" that a tool was missing, which the text names.
 */
#ifndef GLINT_TESTS_HARD_H
#define GLINT_TESTS_HARD_H

#include "tests/unit/board.h"

#include <math.h>
#include <stdio.h>

#include "tests/reference/reference.h"

/* Budgets of pictures against the reference, as in tests/image/test_reference_match.c. */
#define HARD_CODES 1.0    /* greatest |code - 255 L| of a plain pixel, final rounding (0.5) included */
#define HARD_ABOVE 0u     /* plain pixels more than a code away */
#define HARD_UNMATCHED 0u /* contested pixels that agree with nothing that may be seen there */

#define HARD_CENTRE ((BOARD_PX / 2) * BOARD_PX + BOARD_PX / 2)
#define HARD_SHADINGS 3
#define HARD_SEED 20240607u

#if defined(__GNUC__)
#define HARD_PRINTF __attribute__((format(printf, 1, 2)))
#else
#define HARD_PRINTF
#endif

/* A formatted text; four at a time. */
HARD_PRINTF static inline const char *text(const char *format, ...)
{
    static char buffers[4][400];
    static int next;
    va_list arguments;
    next = (next + 1) % 4;
    va_start(arguments, format);
    (void)vsnprintf(buffers[next], sizeof buffers[next], format, arguments);
    va_end(arguments);
    return buffers[next];
}

static inline void hard_line(const char *id, const char *what, const char *naive, const char *glint, const char *result)
{
    assert_null(strchr(naive, '|')); /* it parts the fields */
    assert_null(strchr(glint, '|'));
    printf("HARD|%s|%s|%s|%s|%s\n", id, what, naive, glint, result);
    (void)fflush(stdout);
}

static inline void hard_pass(const char *id, const char *what, const char *naive, const char *glint)
{
    hard_line(id, what, naive, glint, "pass");
}

/* xorshift64* (S. Vigna, 2016); the seed is fixed. */
static uint64_t hard_random_state = HARD_SEED;

static inline int hard_seed(void **state)
{
    (void)state;
    hard_random_state = HARD_SEED;
    return 0;
}

static inline uint32_t hard_random(void)
{
    hard_random_state ^= hard_random_state >> 12;
    hard_random_state ^= hard_random_state << 25;
    hard_random_state ^= hard_random_state >> 27;
    return (uint32_t)((hard_random_state * 2685821657736338717u) >> 32);
}

/* low..high, both included. */
static inline int32_t hard_between(int32_t low, int32_t high)
{
    return (int32_t)(low + (int64_t)((hard_random() * ((uint64_t)((int64_t)high - low) + 1)) >> 32));
}

#define hard_test(function) cmocka_unit_test_setup(function, hard_seed)

static inline double worse_of(double a, double b)
{
    return b > a ? b : a;
}

static inline double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void unit3(double v[3])
{
    const double length = sqrt(dot3(v, v));
    for (int k = 0; k < 3; k++) {
        v[k] /= length;
    }
}

/* What the tests of compiled programs run with. */
static inline const char *setting(const char *name, const char *otherwise)
{
    const char *value = getenv(name);
    return value && *value ? value : otherwise;
}

/* GLINT_LONG=1: the long run of the tests that count pixels. */
static inline int is_long_run(void)
{
    return strcmp(setting("GLINT_LONG", "0"), "1") == 0;
}

/* A whole frame; it must succeed. */
static inline frame hard_draw(const glint_scene *scene, uint16_t width, uint16_t height, uint8_t format,
                              uint8_t shading, int backend)
{
    frame f = {.display = {.width_px = width, .height_px = height, .format = format}, .shading = shading};
    assert_int_equal(frame_draw(&f, scene, backend), 0);
    return f;
}

static inline frame board_draw(const board *b, uint8_t shading, int backend)
{
    frame f = hard_draw(&b->scene, BOARD_PX, BOARD_PX, GLINT_RGB888, shading, backend);
    assert_int_equal(f.report.pixels_shaded, BOARD_PX * BOARD_PX);
    return f;
}

/* The cheapest tiers within one code. */
static inline frame board_draw_within(const board *b, int backend)
{
    frame f = {.display = {.width_px = BOARD_PX, .height_px = BOARD_PX}, .tolerance = GLINT_CODES(1)};
    assert_int_equal(frame_draw(&f, &b->scene, backend), 0);
    assert_int_equal(f.report.pixels_shaded, BOARD_PX * BOARD_PX);
    return f;
}

/* The code of the red channel at the board's centre. */
static inline int board_centre(const board *b, uint8_t shading, int backend)
{
    frame f = board_draw(b, shading, backend);
    const int code = f.pixels[3 * HARD_CENTRE];
    frame_free(&f);
    return code;
}

/* The centre's code in both backends and the given shading: within half a code and a little of 255 times the level. */
static inline void expect_centre(const board *b, uint8_t shading, double level, const char *what)
{
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        const int code = board_centre(b, shading, backend);
        if (!(fabs(code - 255 * level) <= HARD_CODES)) {
            fail_msg("%s, %s, shading %d: code %d, expected %.3f", what, frame_backend_name[backend], shading, code,
                     255 * level);
        }
    }
}

/* Every byte of the picture is this code, in both backends and all shadings; at tolerance 1 it is within a code. */
static inline void expect_all(const board *b, int code, const char *what)
{
    for (int n = 0; n < FRAME_BACKENDS * HARD_SHADINGS; n++) {
        frame f = board_draw(b, (uint8_t)(n / FRAME_BACKENDS), n % FRAME_BACKENDS);
        for (size_t i = 0; i < f.bytes; i++) {
            if (f.pixels[i] != code) {
                fail_msg("%s, %s, shading %d, byte %zu: %u, expected %d", what, frame_backend_name[n % FRAME_BACKENDS],
                         n / FRAME_BACKENDS, i, f.pixels[i], code);
            }
        }
        frame_free(&f);
    }
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame f = board_draw_within(b, backend);
        for (size_t i = 0; i < f.bytes; i++) {
            if (abs(f.pixels[i] - code) > 1) {
                fail_msg("%s, %s, tolerance 1, byte %zu: %u, expected %d", what, frame_backend_name[backend], i,
                         f.pixels[i], code);
            }
        }
        frame_free(&f);
    }
}

/* The same picture, byte for byte, in both backends and all shadings. */
static inline void expect_same_pictures(const glint_scene *a, const glint_scene *b, uint16_t width, uint16_t height)
{
    for (int n = 0; n < FRAME_BACKENDS * HARD_SHADINGS; n++) {
        frame first = hard_draw(a, width, height, GLINT_RGB888, (uint8_t)(n / FRAME_BACKENDS), n % FRAME_BACKENDS);
        frame second = hard_draw(b, width, height, GLINT_RGB888, (uint8_t)(n / FRAME_BACKENDS), n % FRAME_BACKENDS);
        assert_memory_equal(first.pixels, second.pixels, first.bytes);
        frame_free(&first);
        frame_free(&second);
    }
}

/* Both backends against the reference; returns the greatest error of a plain pixel in codes. */
static inline double expect_reference(const glint_scene *scene, uint16_t width, uint16_t height, uint8_t shading,
                                      const char *what)
{
    reference_image image;
    char error[200];
    double worst = 0;
    if (reference_render(scene, width, height, shading, &image, error, sizeof error) != 0) {
        fail_msg("%s: %s", what, error);
    }
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        reference_verdict verdict;
        frame f = hard_draw(scene, width, height, GLINT_RGB888, shading, backend);
        reference_check(&image, f.pixels, HARD_CODES, &verdict);
        if (verdict.max_codes > HARD_CODES || verdict.above > HARD_ABOVE || verdict.unmatched > HARD_UNMATCHED) {
            fail_msg("%s, %s: max %.3f codes at %d, %d; %u above; %u contested unmatched, first at %d, %d", what,
                     frame_backend_name[backend], verdict.max_codes, verdict.worst_x, verdict.worst_y, verdict.above,
                     verdict.unmatched, verdict.unmatched_x, verdict.unmatched_y);
        }
        worst = worse_of(worst, verdict.max_codes);
        frame_free(&f);
    }
    reference_free(&image);
    return worst;
}

/* An error in both backends, before anything is written. */
static inline void expect_refused(const glint_scene *scene, glint_display display, int error)
{
    static const glint_quality quality = {.shading = GLINT_SHADING_EXACT};
    static uint32_t memory[65536];
    frame f = {.display = display};
    display.flush = frame_flush;
    display.context = &f;
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        memset(memory, FRAME_CANARY_BYTE, sizeof memory);
        const int result = backend == FRAME_FIXED
                               ? glint_fixed_render(scene, &display, &quality, memory, sizeof memory, &f.report)
                               : glint_float_render(scene, &display, &quality, memory, sizeof memory, &f.report);
        assert_int_equal(result, error);
        assert_int_equal(f.bands_seen, 0);
        for (size_t i = 0; i < sizeof memory; i++) {
            assert_int_equal(((const uint8_t *)memory)[i], FRAME_CANARY_BYTE);
        }
    }
}

#endif
