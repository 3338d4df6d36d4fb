/* SPDX-License-Identifier: MIT */
/*
 * Hard cases D: colours, codes and pixel formats. docs/hard-cases.md has the defined behaviour; hard.h the form of a
 * test.
 *
 * Budgets:
 */
#define PRODUCT 0.52    /* codes: products of colours alone: the rounding to a code, and twice 2^-16 */
#define DITHERED 0.07   /* D4, codes: mean of an 8x8 block against the colour: half a rank of 64 in a step of 1/31 */
#define MEAN_TINT 0.05  /* D6, codes: green against red and blue, over all greys */
#define BLOCK_TINT 0.10 /* D6, codes: the same in a dithered 8x8 block: half a rank each in steps of 1/31 and 1/63 */

#include "examples/scenes/scenes.h"
#include "tests/hard/hard.h"

#define SIDE 8

static void grey_scene(board *b, int q14)
{
    board_set_up(b);
    b->material.ambient = board_grey(q14);
    b->scene.ambient = board_grey(16384);
    b->scene.light_count = 0;
}

static frame draw_grey(const board *b, uint8_t format, uint8_t dither, int backend)
{
    frame f = {.display = {.width_px = SIDE, .height_px = SIDE, .format = format, .dither = dither}};
    assert_int_equal(frame_draw(&f, &b->scene, backend), 0);
    return f;
}

static uint16_t pixel_565(const frame *f, int pixel)
{
    uint16_t value;
    memcpy(&value, f->pixels + 2 * pixel, sizeof value);
    return value;
}

static void test_D1_many_lights(void **state)
{
    (void)state;
    static glint_light lights[GLINT_MAX_LIGHTS + 1];
    uint8_t naive = 0;
    board b;
    board_set_up(&b);
    for (int i = 0; i <= GLINT_MAX_LIGHTS; i++) {
        lights[i] = b.light[0];
        naive = (uint8_t)(naive + (i < 3 ? 100 : 0));
    }
    assert_int_equal(naive, 44);
    b.scene.lights = lights;
    b.scene.light_count = GLINT_MAX_LIGHTS;
    b.material.diffuse = b.material.specular = b.material.ambient = board_grey(16384);
    b.scene.ambient = board_grey(INT16_MAX);
    for (int level = 1; level <= 4; level *= 2) { /* 4096 lights of 1/16384 to 4/16384: a quarter to 1 */
        for (int i = 0; i < GLINT_MAX_LIGHTS; i++) {
            lights[i].colour = board_grey(level);
        }
        b.material.specular = b.material.ambient = board_grey(0);
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame f = draw_grey(&b, GLINT_RGB888, 0, backend);
            for (size_t i = 0; i < f.bytes; i++) {
                assert_true(fabs(f.pixels[i] - 255 * level / 4.0) <= HARD_CODES);
            }
            frame_free(&f);
        }
    }
    for (int i = 0; i <= GLINT_MAX_LIGHTS; i++) {
        lights[i].colour = board_grey(INT16_MAX);
    }
    b.material.diffuse = b.material.specular = b.material.ambient = board_grey(16384);
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame f = draw_grey(&b, GLINT_RGB888, 0, backend);
        for (size_t i = 0; i < f.bytes; i++) {
            assert_int_equal(f.pixels[i], 255);
        }
        frame_free(&f);
    }
    b.scene.light_count = GLINT_MAX_LIGHTS + 1;
    const glint_display display = {.width_px = SIDE, .height_px = SIDE};
    expect_refused(&b.scene, display, GLINT_ERROR_LIGHT_COUNT);
    hard_pass("D1", "many lights", text("three lights of 100 codes give %u in 8 bits", naive),
              "4096 lights of 2 + 2: 255; 4096 faint ones sum to 64, 128, 255; 4097 refused");
}

static void test_D2_saturated_colour(void **state)
{
    (void)state;
    board b;
    board_set_up(&b);
    b.material.diffuse = board_grey(16384);
    b.light[0].colour = (glint_colour){INT16_MAX, 16384, 8192};
    const uint8_t naive = (uint8_t)(INT16_MAX * 255 / 16384 & 255);
    assert_true(naive != 255);
    for (int n = 0; n < FRAME_BACKENDS * HARD_SHADINGS; n++) {
        frame f = board_draw(&b, (uint8_t)(n / FRAME_BACKENDS), n % FRAME_BACKENDS);
        for (int i = 0; i < BOARD_PX * BOARD_PX; i++) {
            assert_int_equal(f.pixels[3 * i], 255);
            assert_int_equal(f.pixels[3 * i + 1], 255);
            assert_int_equal(f.pixels[3 * i + 2], 128);
        }
        frame_free(&f);
    }
    hard_pass("D2", "saturated colour", text("(2, 1, 0.5) wraps to (%u, 255, 128)", naive),
              "not built yet: scaling by the largest channel; documented: each channel saturates, (255, 255, 128)");
}

static void test_D3_division_by_255(void **state)
{
    (void)state;
    const int naive = 255 * 255 >> 8;
    assert_int_equal(naive, 254);
    double worst = 0;
    for (int code = 0; code < 256; code++) {
        board b;
        grey_scene(&b, GLINT_Q14_FROM_CODE(code));
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame f = draw_grey(&b, GLINT_RGB888, 0, backend);
            for (size_t i = 0; i < f.bytes; i++) {
                assert_int_equal(f.pixels[i], code); /* times white: itself */
            }
            frame_free(&f);
            for (int other = 0; other < 256; other += 15) {
                b.scene.ambient = board_grey(GLINT_Q14_FROM_CODE(other));
                f = draw_grey(&b, GLINT_RGB888, 0, backend);
                const double exact = 255 * (b.material.ambient.r_q14 / 16384.0) * (b.scene.ambient.r_q14 / 16384.0);
                worst = worse_of(worst, fabs(f.pixels[0] - exact));
                frame_free(&f);
            }
            b.scene.ambient = board_grey(16384);
        }
    }
    assert_true(worst <= PRODUCT);
    hard_pass("D3", ">> 8 for / 255", text("white times white is %d", naive),
              text("every code times white is itself; products within %.3f codes, rounding included", worst));
}

static void test_D4_banding_in_rgb565(void **state)
{
    (void)state;
    double naive = 0, worst = 0;
    for (int q14 = 0; q14 <= 16384; q14 += 8) {
        board b;
        grey_scene(&b, q14);
        for (int n = 0; n < 2 * FRAME_BACKENDS; n++) {
            frame f = draw_grey(&b, GLINT_RGB565, n < FRAME_BACKENDS ? GLINT_DITHER_NONE : GLINT_DITHER_BAYER, n % 2);
            double mean = 0;
            for (int i = 0; i < SIDE * SIDE; i++) {
                mean += (pixel_565(&f, i) >> 11) * 255.0 / 31 / (SIDE * SIDE);
            }
            const double error = fabs(mean - 255 * q14 / 16384.0);
            naive = worse_of(naive, n < FRAME_BACKENDS ? error : 0);
            worst = worse_of(worst, n < FRAME_BACKENDS ? 0 : error);
            frame_free(&f);
        }
    }
    assert_true(naive > 4 && worst <= DITHERED);
    /* keyed to the display: the pattern repeats every 8 px, and bands do not shift it */
    board b;
    grey_scene(&b, 5555);
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame whole = {.display = {.width_px = 40, .height_px = 40, .format = GLINT_RGB565, .dither = 1}};
        assert_int_equal(frame_draw(&whole, &b.scene, backend), 0);
        for (int i = 0; i < 32 * 40; i++) {
            const int x = i % 32, y = i / 32 % 32;
            assert_int_equal(pixel_565(&whole, y * 40 + x), pixel_565(&whole, y * 40 + x + 8));
            assert_int_equal(pixel_565(&whole, y * 40 + x), pixel_565(&whole, (y + 8) * 40 + x));
        }
        for (uint16_t band = 1; band < 40; band++) {
            frame f = {.display = whole.display};
            f.display.band_px = band;
            assert_int_equal(frame_draw(&f, &b.scene, backend), 0);
            assert_memory_equal(f.pixels, whole.pixels, whole.bytes);
            frame_free(&f);
        }
        frame_free(&whole);
    }
    hard_pass("D4", "RGB565", text("without dither an area is up to %.1f codes off: bands", naive),
              text("8x8 means within %.2f codes; the pattern does not depend on the band height", worst));
}

static void test_D5_dither_on_black_and_white(void **state)
{
    (void)state;
    int naive = 0;
    for (int rank = 0; rank < 64; rank++) {
        naive += 0 * 31 + (rank + 1) / 64 > 0; /* thresholds (rank + 1) / 64 instead of (2 rank + 1) / 128 */
    }
    assert_int_equal(naive, 1);
    for (int white = 0; white < 2; white++) {
        board b;
        grey_scene(&b, white ? 16384 : 0);
        for (int format = GLINT_RGB888; format <= GLINT_MONO_PAGES; format++) {
            for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
                frame f = draw_grey(&b, (uint8_t)format, GLINT_DITHER_BAYER, backend);
                for (size_t i = 0; i < f.bytes; i++) {
                    assert_int_equal(f.pixels[i], white ? 255 : 0);
                }
                frame_free(&f);
            }
        }
    }
    hard_pass("D5", "dither on pure black or white", text("%d white px in every 64 of black", naive),
              "pure in all 6 formats");
}

static void test_D6_greys_in_565_bits(void **state)
{
    (void)state;
    double naive = 0, mean = 0, block = 0;
    for (int code = 0; code < 256; code++) { /* cut off, then shifted up again: white is (248, 252, 248) */
        naive += ((code >> 2 << 2) - (code >> 3 << 3)) / 256.0;
    }
    assert_true(naive > 1.5);
    for (int code = 0; code < 256; code++) {
        board b;
        grey_scene(&b, GLINT_Q14_FROM_CODE(code));
        for (int n = 0; n < 2 * FRAME_BACKENDS; n++) {
            frame f = draw_grey(&b, GLINT_RGB565, n < FRAME_BACKENDS ? GLINT_DITHER_NONE : GLINT_DITHER_BAYER, n % 2);
            double tint = 0;
            for (int i = 0; i < SIDE * SIDE; i++) {
                const uint16_t p = pixel_565(&f, i);
                assert_int_equal(p >> 11, p & 31); /* red and blue alike */
                tint += ((p >> 5 & 63) * 255.0 / 63 - (p & 31) * 255.0 / 31) / (SIDE * SIDE);
            }
            mean += n < FRAME_BACKENDS ? tint / 512 : 0;
            block = n < FRAME_BACKENDS ? block : worse_of(block, fabs(tint));
            frame_free(&f);
        }
    }
    assert_true(fabs(mean) <= MEAN_TINT && block <= BLOCK_TINT);
    hard_pass(
        "D6", "greys in 5-6-5 bits", text("green tint of %.2f codes on average, 4 on white", naive),
        text("one rounding for all channels: %.3f on average, at most %.2f in a dithered block", fabs(mean), block));
}

static void test_D7_reflectance_above_one(void **state)
{
    (void)state;
    const uint8_t naive = (uint8_t)(300 & 255);
    assert_int_equal(naive, 44);
    const glint_display display = {.width_px = SIDE, .height_px = SIDE};
    for (int k = 0; k < 9; k++) {
        board b;
        board_set_up(&b);
        glint_colour *const colour = k / 3 == 0   ? &b.material.ambient
                                     : k / 3 == 1 ? &b.material.diffuse
                                                  : &b.material.specular;
        int16_t *const channel = k % 3 == 0 ? &colour->r_q14 : k % 3 == 1 ? &colour->g_q14 : &colour->b_q14;
        *channel = 16384;
        frame f = draw_grey(&b, GLINT_RGB888, 0, k % 2);
        frame_free(&f);
        *channel = 16385;
        expect_refused(&b.scene, display, GLINT_ERROR_REFLECTANCE);
    }
    board b;
    board_set_up(&b);
    b.scene.background.g_q14 = 16385;
    expect_refused(&b.scene, display, GLINT_ERROR_BACKGROUND);
    hard_pass("D7", "reflectance or albedo above 1", text("300 codes wrap to %u", naive),
              "refused above exactly 1, in each term and channel, and the background");
}

static void test_D8_byte_swapped_displays(void **state)
{
    (void)state;
    const uint16_t red = 0xf800, naive = (uint16_t)(red << 8 | red >> 8);
    assert_true((naive >> 11) == 0 && (naive & 0x7ff) != 0); /* red shows as green and blue */
    long pixels = 0;
    for (uint16_t scene = 0; scene < demo_scene_count; scene++) {
        for (int n = 0; n < 2 * FRAME_BACKENDS; n++) {
            frame f = {.display = {.width_px = 61, .height_px = 47, .band_px = 10, .format = GLINT_RGB565}};
            f.display.dither = (uint8_t)(n / 2);
            frame g = {.display = f.display};
            g.display.format = GLINT_RGB565_SWAPPED;
            assert_int_equal(frame_draw(&f, demo_scenes[scene].scene, n % 2), 0);
            assert_int_equal(frame_draw(&g, demo_scenes[scene].scene, n % 2), 0);
            for (size_t i = 0; i < f.bytes; i += 2) {
                assert_true(f.pixels[i] == g.pixels[i + 1] && f.pixels[i + 1] == g.pixels[i]);
                pixels++;
            }
            frame_free(&f);
            frame_free(&g);
        }
    }
    hard_pass("D8", "byte-swapped displays", text("red 0xf800 sent as 0x%04x: no red at all", naive),
              text("a pixel format: the same bytes swapped at %ld px, no pass over the buffer", pixels));
}

static void test_D9_declared_mode(void **state)
{
    (void)state;
    const double encoded = 1.055 * pow(0.5, 1 / 2.4) - 0.055; /* sRGB of half the light */
    const int naive = (int)lround(255 * encoded);
    assert_true(abs(naive - 128) > 50);
    board b;
    board_set_up(&b);
    b.material.diffuse = board_grey(16384);
    b.light[0].colour = board_grey(8192);
    expect_all(&b, 128, "half the light");
    char header[16384];
    FILE *file = fopen("include/glint/scene.h", "r");
    assert_non_null(file);
    header[fread(header, 1, sizeof header - 1, file)] = '\0';
    (void)fclose(file);
    assert_non_null(strstr(header, "display codes"));
    assert_non_null(strstr(header, "no gamma conversion"));
    hard_pass("D9", "lighting in sRGB or linear space", text("half the light is 128 or %d, as one takes it", naive),
              "declared in scene.h: display codes, no gamma conversion; half the light is 128");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        hard_test(test_D1_many_lights),
        hard_test(test_D2_saturated_colour),
        hard_test(test_D3_division_by_255),
        hard_test(test_D4_banding_in_rgb565),
        hard_test(test_D5_dither_on_black_and_white),
        hard_test(test_D6_greys_in_565_bits),
        hard_test(test_D7_reflectance_above_one),
        hard_test(test_D8_byte_swapped_displays),
        hard_test(test_D9_declared_mode),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
