/* SPDX-License-Identifier: MIT */
/*
 * Pixel formats, rounding and dither: frames of known colours, read by an unpacker of the test's own (unpack.h).
 *
 * Budgets, in levels of the format:
 */
#define ROUNDING 0.5 /* a channel without dither: the nearest level, of the colour's own bits */
/* Luma is rounded to 1/65536 twice (the sum, and the Q15 of the colour in it) before it is brought to levels. */
#define LUMA_ROUNDING(greatest) (0.5 + (greatest) / 65536.0)
/* Mean over 8x8 pixels of the dither: its 64 thresholds are 1/64 level apart. */
#define DITHER_MEAN (1 / 64.0)

#include "tests/unit/backends.h"
#include "tests/unit/board.h"
#include "tests/unit/unpack.h"

#include <math.h>

#include "display/pack.h"
#include "examples/scenes/scenes.h"

/* The background and nothing else. */
static void draw_background(frame *f, int which, const glint_colour *colour, uint8_t format, uint8_t dither, int width,
                            int height)
{
    static const glint_camera camera = {.eye_q16 = {0, 0, 65536}, .field_of_view_turn16 = 8192, .near_q16 = 65536};
    const glint_scene scene = {.camera = &camera, .background = *colour};
    memset(f, 0, sizeof *f);
    f->display.width_px = (uint16_t)width;
    f->display.height_px = (uint16_t)height;
    f->display.format = format;
    f->display.dither = dither;
    assert_int_equal(frame_draw(f, &scene, which), 0);
}

static levels pixel_of(const frame *f, int x, int y)
{
    return unpack(f->pixels, (uint32_t)f->row_bytes, f->display.format, x, y);
}

/* Level without rounding: a channel, or the luma that <glint/display.h> defines. */
static double true_level(const glint_colour *c, uint8_t format, int k)
{
    const double rgb[3] = {c->r_q14 / 16384.0, c->g_q14 / 16384.0, c->b_q14 / 16384.0};
    const double luma = (77 * rgb[0] + 150 * rgb[1] + 29 * rgb[2]) / 256;
    const bool colour = format == GLINT_RGB888 || format == GLINT_RGB565 || format == GLINT_RGB565_SWAPPED;
    return unpack_greatest(format, k) * (!colour ? luma : k == 0 ? rgb[0] : k == 1 ? rgb[1] : rgb[2]);
}

static void expect_nearest(const frame *f, const glint_colour *c, int x, int y)
{
    const levels pixel = pixel_of(f, x, y);
    for (int k = 0; k < 3 && k < pixel.count; k++) {
        const double level = true_level(c, f->display.format, k);
        const double budget = pixel.count == 3 ? ROUNDING : LUMA_ROUNDING(unpack_greatest(f->display.format, 0));
        if (fabs(pixel.v[k] - level) > budget) {
            fail_msg("format %u, colour %d %d %d, channel %d: level %u, expected %.5f", f->display.format, c->r_q14,
                     c->g_q14, c->b_q14, k, pixel.v[k], level);
        }
    }
}

static void test_black_and_white_are_exact(void **state)
{
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        for (int n = 0; n < UNPACK_FORMATS * 4; n++) {
            frame f;
            const uint8_t format = (uint8_t)(n / 4), dither = n & 1;
            const bool white = n & 2;
            const glint_colour colour = board_grey(white ? 16384 : 0);
            draw_background(&f, which, &colour, format, dither, 17, 19);
            for (int i = 0; i < 17 * 19; i++) {
                const levels pixel = pixel_of(&f, i % 17, i / 17);
                for (int k = 0; k < 3 && k < pixel.count; k++) {
                    assert_int_equal(pixel.v[k], white ? unpack_greatest(format, k) : 0);
                }
            }
            frame_free(&f);
        }
    }
}

/* The bytes themselves, written out by hand. */
static void test_bytes_of_known_colours(void **state)
{
    (void)state;
    const uint16_t probe = 1;
    const bool little_endian = *(const uint8_t *)&probe == 1;
    for (int which = 0; which < BACKENDS; which++) {
        frame f;
        const glint_colour primary[3] = {{16384, 0, 0}, {0, 16384, 0}, {0, 0, 16384}}, white = GLINT_WHITE;
        static const uint8_t upper[3] = {0xf8, 0x07, 0x00}, lower[3] = {0x00, 0xe0, 0x1f};
        static const uint8_t luma[3] = {77, 149, 29}; /* 255 / 256 of 77, 150 and 29: 76.7, 149.4, 28.9 */
        for (int c = 0; c < 3; c++) {
            draw_background(&f, which, &primary[c], GLINT_RGB888, 0, 2, 1);
            const uint8_t rgb[6] = {c == 0 ? 255 : 0, c == 1 ? 255 : 0, c == 2 ? 255 : 0,
                                    c == 0 ? 255 : 0, c == 1 ? 255 : 0, c == 2 ? 255 : 0};
            assert_memory_equal(f.pixels, rgb, 6);
            frame_free(&f);
            for (int swapped = 0; swapped < 2; swapped++) {
                draw_background(&f, which, &primary[c], swapped ? GLINT_RGB565_SWAPPED : GLINT_RGB565, 0, 1, 1);
                const int first_is_upper = little_endian ? swapped : !swapped;
                assert_int_equal(f.pixels[0], first_is_upper ? upper[c] : lower[c]);
                assert_int_equal(f.pixels[1], first_is_upper ? lower[c] : upper[c]);
                frame_free(&f);
            }
            draw_background(&f, which, &primary[c], GLINT_GREY8, 0, 1, 1);
            assert_int_equal(f.pixels[0], luma[c]);
            frame_free(&f);
        }
        /* 10 rows are a page of 8 and one of 2, the topmost in bit 0 */
        draw_background(&f, which, &white, GLINT_MONO_PAGES, 0, 3, 10);
        for (int x = 0; x < 3; x++) {
            assert_int_equal(f.pixels[x], 0xff);
            assert_int_equal(f.pixels[3 + x] & 0x03, 0x03);
        }
        frame_free(&f);
    }
}

static void test_every_grey_rounds_to_nearest(void **state)
{
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        for (uint8_t format = 0; format < (uint8_t)UNPACK_FORMATS; format++) {
            for (int q14 = 0; q14 <= 16384; q14++) {
                frame f;
                const glint_colour colour = board_grey(q14);
                draw_background(&f, which, &colour, format, GLINT_DITHER_NONE, 1, 1);
                expect_nearest(&f, &colour, 0, 0);
                frame_free(&f);
            }
        }
        for (int code = 0; code < 256; code++) {
            frame f;
            const glint_colour colour = GLINT_GREY(code);
            draw_background(&f, which, &colour, GLINT_RGB888, GLINT_DITHER_NONE, 1, 1);
            assert_int_equal(f.pixels[0], code);
            assert_int_equal(f.pixels[1], code);
            assert_int_equal(f.pixels[2], code);
            frame_free(&f);
            draw_background(&f, which, &colour, GLINT_GREY8, GLINT_DITHER_NONE, 1, 1);
            assert_int_equal(f.pixels[0], code);
            frame_free(&f);
        }
    }
}

static void test_colours_round_to_nearest(void **state)
{
    (void)state;
    uint64_t seed = 1;
    for (int n = 0; n < 5000; n++) {
        const glint_colour colour = {(int16_t)(random_u24(&seed) % 16385), (int16_t)(random_u24(&seed) % 16385),
                                     (int16_t)(random_u24(&seed) % 16385)};
        for (int which = 0; which < BACKENDS; which++) {
            for (uint8_t format = 0; format < (uint8_t)UNPACK_FORMATS; format++) {
                frame f;
                draw_background(&f, which, &colour, format, GLINT_DITHER_NONE, 1, 1);
                expect_nearest(&f, &colour, 0, 0);
                frame_free(&f);
            }
        }
    }
}

/* The sums over 8x8 pixels; each pixel is one of the two levels around the true one. */
static void test_dither_keeps_the_mean(void **state)
{
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        for (uint8_t format = 0; format < (uint8_t)UNPACK_FORMATS; format++) {
            for (int q14 = 0; q14 <= 16384; q14 += 16) {
                frame f;
                const glint_colour colour = {(int16_t)q14, (int16_t)(16384 - q14), (int16_t)(q14 / 3)};
                int sum[3] = {0, 0, 0};
                draw_background(&f, which, &colour, format, GLINT_DITHER_BAYER, 24, 16);
                for (int i = 0; i < 64; i++) {
                    const levels pixel = pixel_of(&f, 8 + i % 8, 8 + i / 8), same = pixel_of(&f, i % 8, i / 8);
                    assert_memory_equal(&pixel, &same, sizeof pixel);
                    for (int k = 0; k < 3 && k < pixel.count; k++) {
                        const double level = true_level(&colour, format, k);
                        assert_true(fabs(pixel.v[k] - level) < 1 + DITHER_MEAN);
                        sum[k] += pixel.v[k];
                    }
                }
                const int count = pixel_of(&f, 0, 0).count;
                for (int k = 0; k < 3 && k < count; k++) {
                    const double level = true_level(&colour, format, k);
                    if (fabs(sum[k] / 64.0 - level) > DITHER_MEAN) {
                        fail_msg("format %u, q14 %d, channel %d: mean %.5f, expected %.5f", format, q14, k,
                                 sum[k] / 64.0, level);
                    }
                }
                frame_free(&f);
            }
        }
    }
}

/* Half of the levels' way: an 8x8 ordered dither has as many pixels up as down in every 2x2 pixels. */
static void test_dither_is_dispersed(void **state)
{
    (void)state;
    const glint_colour half = board_grey(8192);
    for (int which = 0; which < BACKENDS; which++) {
        frame f;
        draw_background(&f, which, &half, GLINT_MONO_PAGES, GLINT_DITHER_BAYER, 16, 16);
        for (int y = 0; y < 16; y += 2) {
            for (int x = 0; x < 16; x += 2) {
                assert_int_equal(pixel_of(&f, x, y).v[0] + pixel_of(&f, x + 1, y).v[0] + pixel_of(&f, x, y + 1).v[0] +
                                     pixel_of(&f, x + 1, y + 1).v[0],
                                 2);
            }
        }
        frame_free(&f);
    }
}

static void test_dither_is_keyed_to_the_display(void **state)
{
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        for (uint8_t format = 0; format < (uint8_t)UNPACK_FORMATS; format++) {
            frame whole = {.display = {.width_px = 45, .height_px = 43, .format = format, .dither = 1}};
            assert_int_equal(frame_draw(&whole, &demo_three_lights, which), 0);
            for (uint16_t band_px = 1; band_px <= 43; band_px++) {
                if (format == GLINT_MONO_PAGES && band_px % 8 != 0) {
                    continue;
                }
                frame f = {.display = whole.display};
                f.display.band_px = band_px;
                assert_int_equal(frame_draw(&f, &demo_three_lights, which), 0);
                assert_memory_equal(f.pixels, whole.pixels, whole.bytes);
                frame_free(&f);
            }
            frame_free(&whole);
        }
    }
}

/* A surface whose colour is the background's cannot be seen against it: both ways to a pixel pack alike. */
static void test_surface_and_background_pack_alike(void **state)
{
    (void)state;
    board b;
    board_set_up(&b);
    b.scene.light_count = 0;
    b.material.ambient = board_grey(16384);
    b.camera.target_q16[0] = BOARD_Q16(9.5); /* the board's edge goes through the picture */
    for (int n = 0; n < 40 * UNPACK_FORMATS; n++) {
        const glint_colour colour = {(int16_t)(n * 60), (int16_t)(n * 25 + 4000), (int16_t)(16384 - n * 55)};
        for (int which = 0; which < BACKENDS; which++) {
            frame f = {.display = {.width_px = 37, .height_px = 13, .format = (uint8_t)(n % UNPACK_FORMATS)}};
            frame empty;
            f.display.dither = n / UNPACK_FORMATS % 2 ? GLINT_DITHER_BAYER : GLINT_DITHER_NONE;
            b.scene.ambient = b.scene.background = colour;
            assert_int_equal(frame_draw(&f, &b.scene, which), 0);
            assert_in_range(f.report.pixels_shaded, 37, 36 * 13);
            draw_background(&empty, which, &colour, f.display.format, f.display.dither, 37, 13);
            for (int i = 0; i < 37 * 13; i++) {
                const levels pixel = pixel_of(&f, i % 37, i / 37), same = pixel_of(&empty, i % 37, i / 37);
                assert_memory_equal(&pixel, &same, sizeof pixel);
            }
            frame_free(&empty);
            frame_free(&f);
        }
    }
}

/* The levels that a channel may have whose RGB888 code is known: of any value that rounds to that code. */
static void expect_same_picture(const frame *f, const frame *rgb)
{
    const uint8_t format = f->display.format;
    for (int i = 0; i < f->display.width_px * f->display.height_px; i++) {
        const int x = i % f->display.width_px, y = i / f->display.width_px;
        const levels pixel = pixel_of(f, x, y), code = pixel_of(rgb, x, y);
        const double luma = (77 * code.v[0] + 150 * code.v[1] + 29 * code.v[2]) / 256.0;
        for (int k = 0; k < 3 && k < pixel.count; k++) {
            const double scale = unpack_greatest(format, k) / 255.0;
            const double level = (pixel.count == 3 ? code.v[k] : luma) * scale;
            if (fabs(pixel.v[k] - level) > LUMA_ROUNDING(unpack_greatest(format, k)) + 0.5 * scale) {
                fail_msg("format %u, %ux%u, pixel %d %d: level %u, from RGB888 %.3f", format, f->display.width_px,
                         f->display.height_px, x, y, pixel.v[k], level);
            }
        }
    }
}

/* One scene in all formats at sizes with every remainder of 8, a pixel wide and high included. */
static void test_formats_show_the_same_picture(void **state)
{
    (void)state;
    static const uint16_t sizes[][2] = {{1, 1},  {1, 40},  {40, 1},   {2, 9},    {3, 10},   {4, 11},     {5, 12},
                                        {6, 13}, {7, 14},  {8, 15},   {9, 16},   {10, 7},   {15, 17},    {16, 5},
                                        {17, 3}, {61, 47}, {64, 128}, {2048, 1}, {1, 2048}, {2047, 130}, {33, 8}};
    for (int which = 0; which < BACKENDS; which++) {
        uint32_t seen = 0;
        for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
            frame rgb = {.display = {.width_px = sizes[s][0], .height_px = sizes[s][1]}};
            assert_int_equal(frame_draw(&rgb, &demo_room, which), 0);
            seen += rgb.report.pixels_shaded;
            for (uint8_t format = 1; format < (uint8_t)UNPACK_FORMATS; format++) {
                frame f = {.display = rgb.display};
                f.display.format = format;
                f.display.band_px = (uint16_t)(8 * (s % 4));
                assert_int_equal(frame_draw(&f, &demo_room, which), 0);
                expect_same_picture(&f, &rgb);
                frame_free(&f);
            }
            frame_free(&rgb);
        }
        assert_true(seen > 100000);
    }
}

/* frame_flush() takes the pixels of each row and leaves the gap; here the gap is looked at as well. */
typedef struct gap_check {
    frame *whole;
    uint32_t rows;
} gap_check;

static int gap_flush(void *context, const glint_band *band)
{
    gap_check *check = context;
    const frame *const f = check->whole;
    const bool pages = f->display.format == GLINT_MONO_PAGES;
    const uint32_t rows = pages ? (band->height_px + 7u) / 8 : band->height_px;
    const uint8_t *const pixels = band->pixels;
    assert_int_equal(band->bytes, rows * band->stride_bytes);
    for (uint32_t y = 0; y < rows; y++) {
        const uint8_t *const row = pixels + y * band->stride_bytes;
        for (int x = 0; !pages && x < f->display.width_px; x++) {
            const levels pixel = unpack(row, 0, f->display.format, x, 0);
            const levels expected = pixel_of(f, x, (int)check->rows);
            assert_memory_equal(&pixel, &expected, sizeof pixel);
        }
        if (pages) {
            assert_memory_equal(row, f->pixels + check->rows * f->row_bytes, f->row_bytes);
        }
        for (size_t i = f->row_bytes; i < band->stride_bytes; i++) {
            if (row[i] != FRAME_CANARY_BYTE && !(pages && row[i] == 0)) {
                fail_msg("byte %zu behind row %u was written", i - f->row_bytes, (unsigned)y);
            }
        }
        check->rows++;
    }
    return 0;
}

/* Rows farther apart than they are long: the gap keeps its bytes (pages: or is cleared), and the picture is the same.
 */
static void test_stride_leaves_gaps(void **state)
{
    (void)state;
    static const uint32_t more[] = {1, 2, 3, 4, 5, 13, 200};
    for (int n = 0; n < 7 * UNPACK_FORMATS * BACKENDS; n++) {
        const renderer *const be = &backends[n % 2];
        const uint8_t format = (uint8_t)(n / 2 % UNPACK_FORMATS);
        frame whole = {.display = {.width_px = 21, .height_px = 27, .format = format}};
        assert_int_equal(frame_draw(&whole, &demo_room, n % 2), 0);
        gap_check check = {&whole, 0};
        glint_display display = whole.display;
        display.flush = gap_flush;
        display.context = &check;
        display.band_px = 8;
        const bool halves = format == GLINT_RGB565 || format == GLINT_RGB565_SWAPPED; /* want an even stride */
        display.stride_bytes = (uint32_t)whole.row_bytes + more[n / 2 / UNPACK_FORMATS] * (halves ? 2 : 1);
        const size_t bytes = be->memory_bytes(&demo_room, &display);
        uint8_t *const memory = malloc(bytes + FRAME_CANARY);
        assert_non_null(memory);
        memset(memory, FRAME_CANARY_BYTE, bytes + FRAME_CANARY);
        const glint_quality quality = {.shading = GLINT_SHADING_EXACT};
        assert_int_equal(be->render(&demo_room, &display, &quality, memory, bytes, NULL), 0);
        assert_int_equal(check.rows, format == GLINT_MONO_PAGES ? 4 : 27);
        for (int i = 0; i < FRAME_CANARY; i++) {
            assert_int_equal(memory[bytes + (size_t)i], FRAME_CANARY_BYTE);
        }
        free(memory);
        frame_free(&whole);
    }
}

/* The half byte that an odd number of 4-bit pixels leaves holds 0, whatever the memory (0xa5 here) held before. */
static void test_left_over_half_byte(void **state)
{
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        for (int width = 1; width < 8; width += 2) {
            frame f;
            const glint_colour colour = board_grey(16384);
            draw_background(&f, which, &colour, GLINT_GREY4, GLINT_DITHER_NONE, width, 3);
            for (size_t y = 0; y < 3; y++) {
                assert_int_equal(f.pixels[y * f.row_bytes + f.row_bytes - 1], 0xf0);
            }
            frame_free(&f);
        }
    }
}

/* Clears by words, whole or row by row: each pixel of each width is written, and nothing between or behind rows. */
static void test_clears_write_what_they_should(void **state)
{
    (void)state;
    const glint_shade shade = {20000, 9000, 31000};
    for (int n = 0; n < 80 * 6 * 3; n++) {
        const uint16_t width = (uint16_t)(n % 80 + 1), rows = (uint16_t)(n / 80 % 6 + 1);
        const uint32_t stride = (uint32_t)width * 2 + (uint32_t)(n / 480) * 2;
        uint32_t words[6 * 84 / 2 + 1];
        uint16_t *const pixels = (uint16_t *)(void *)words;
        const glint_target target = {.pixels = (uint8_t *)words, .stride_bytes = stride, .format = GLINT_RGB565};
        memset(words, FRAME_CANARY_BYTE, sizeof words);
        glint_pack_clear(&target, width, rows, &shade);
        for (uint32_t i = 0; i < sizeof words / 2; i++) {
            const bool inside = i / (stride / 2) < rows && i % (stride / 2) < width;
            assert_int_equal(pixels[i],
                             inside ? glint_pack_pixel(&target, &shade) : FRAME_CANARY_BYTE << 8 | FRAME_CANARY_BYTE);
        }
    }
    for (uint32_t count = 0; count < 100; count++) {
        uint32_t words[101];
        memset(words, FRAME_CANARY_BYTE, sizeof words);
        glint_fill_words(words, 0x12345678, count);
        for (uint32_t i = 0; i < 101; i++) {
            assert_true(words[i] == (i < count ? 0x12345678 : FRAME_CANARY_BYTE * 0x01010101u));
        }
    }
}

static void test_row_bytes(void **state)
{
    (void)state;
    for (uint16_t width = 1; width <= 2048; width++) {
        assert_int_equal(glint_row_bytes(GLINT_RGB888, width), 3 * width);
        assert_int_equal(glint_row_bytes(GLINT_RGB565, width), 2 * width);
        assert_int_equal(glint_row_bytes(GLINT_RGB565_SWAPPED, width), 2 * width);
        assert_int_equal(glint_row_bytes(GLINT_GREY8, width), width);
        assert_int_equal(glint_row_bytes(GLINT_GREY4, width), width / 2 + width % 2);
        assert_int_equal(glint_row_bytes(GLINT_MONO_PAGES, width), width);
        for (int format = UNPACK_FORMATS; format < 256; format++) {
            assert_int_equal(glint_row_bytes((uint8_t)format, width), 0);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_black_and_white_are_exact),
        cmocka_unit_test(test_bytes_of_known_colours),
        cmocka_unit_test(test_every_grey_rounds_to_nearest),
        cmocka_unit_test(test_colours_round_to_nearest),
        cmocka_unit_test(test_dither_keeps_the_mean),
        cmocka_unit_test(test_dither_is_dispersed),
        cmocka_unit_test(test_dither_is_keyed_to_the_display),
        cmocka_unit_test(test_surface_and_background_pack_alike),
        cmocka_unit_test(test_formats_show_the_same_picture),
        cmocka_unit_test(test_stride_leaves_gaps),
        cmocka_unit_test(test_left_over_half_byte),
        cmocka_unit_test(test_clears_write_what_they_should),
        cmocka_unit_test(test_row_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
