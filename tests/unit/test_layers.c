/* SPDX-License-Identifier: MIT */
/*
 * Surfaces that let light through: pixels read back from every format, layers' dither, Schlick's power, the order of
 * spheres; and whole frames of boards whose colours have a closed form.
 */
#include "tests/unit/geometry_world.h"

#include <stdio.h>

#include "display/layer.h"
#include "effects/through.h"
#include "number/tables.h"
#include "tests/unit/board.h"

#define MEAN_STEPS (1.0 / 7) /* by which the mean over the dither's pattern may err, of the format's steps */
#define MIRRORED_ULP 0.51L
#define READ_ULP 0.503
#define ORDER_ROUNDS 400000

/* ----------------------------------------------------------------------------------------------------------- formats
 */

static const uint8_t formats[] = {GLINT_RGB888, GLINT_RGB565, GLINT_RGB565_SWAPPED,
                                  GLINT_GREY8,  GLINT_GREY4,  GLINT_MONO_PAGES};
#define FORMATS (sizeof formats / sizeof *formats)

static uint8_t band[8 * 24];

static glint_target target_of(uint8_t format, uint8_t dither)
{
    const glint_target target = {.pixels = band,
                                 .stride_bytes = format == GLINT_RGB888           ? 24
                                                 : format <= GLINT_RGB565_SWAPPED ? 16
                                                                                  : 8,
                                 .format = format,
                                 .dither = dither};
    return target;
}

/* Every level of every channel at every threshold: packing what was read back changes nothing. */
static void test_unpacking_is_the_inverse_of_packing(void **state)
{
    (void)state;
    for (size_t f = 0; f < FORMATS; f++) {
        for (uint32_t level = 0; level < 256; level++) {
            for (uint8_t dither = 0; dither < 2; dither++) {
                const glint_target target = target_of(formats[f], dither);
                uint8_t before[sizeof band];
                for (size_t i = 0; i < sizeof band; i++) {
                    band[i] = (uint8_t)(i % 3 == 0 ? level : i % 3 == 1 ? 255 - level : level * 7);
                }
                memcpy(before, band, sizeof band);
                for (int16_t i = 0; i < 64; i++) {
                    const int16_t x = (int16_t)(i % 8), y = (int16_t)(i / 8);
                    const glint_shade shade = glint_unpack(&target, x, y);
                    glint_pack(&target, x, y, &shade, 1);
                    for (uint32_t threshold = 256; threshold < 32768; threshold += 512) {
                        glint_pack_thresholded(&target, x, y, &shade, threshold);
                        assert_memory_equal(band, before, sizeof band);
                    }
                }
                assert_memory_equal(band, before, sizeof band);
            }
        }
    }
}

static void test_levels_read_back_to_half_a_unit(void **state)
{
    (void)state;
    const glint_target rgb888 = target_of(GLINT_RGB888, 0), rgb565 = target_of(GLINT_RGB565, 0);
    for (int level = 0; level < 256; level++) {
        memset(band, level, sizeof band);
        assert_true(fabs(glint_unpack(&rgb888, 1, 1).g_q15 - level * 32768 / 255.0) <= READ_ULP);
        const uint16_t pixel = (uint16_t)((level & 31) << 11 | (level & 63) << 5 | (level & 31));
        memcpy(band, &pixel, 2);
        assert_true(fabs(glint_unpack(&rgb565, 0, 0).r_q15 - (level & 31) * 32768 / 31.0) <= READ_ULP);
        assert_true(fabs(glint_unpack(&rgb565, 0, 0).g_q15 - (level & 63) * 32768 / 63.0) <= READ_ULP);
    }
}

/* A layer over one bit a pixel: the mean of the pattern is own + t behind. */
static void test_dithered_layers_keep_the_mean(void **state)
{
    double worst = 0;
    (void)state;
    const glint_target target = target_of(GLINT_MONO_PAGES, GLINT_DITHER_BAYER);
    for (uint32_t behind = 0; behind <= 32768; behind += 512) {
        for (uint32_t t = 0; t <= 32768; t += 1024) {
            for (uint32_t own = 0; own <= 32768 - t; own += 4096) {
                const glint_shade below = {(uint16_t)behind, (uint16_t)behind, (uint16_t)behind};
                const glint_shade above = {(uint16_t)own, (uint16_t)own, (uint16_t)own};
                const uint16_t through = (uint16_t)t;
                int set = 0;
                for (int16_t i = 0; i < 64; i++) {
                    const int16_t x = (int16_t)(i % 8), y = (int16_t)(i / 8);
                    glint_pack_fill(&target, x, y, &below, 1);
                    glint_pack_layer(&target, x, y, &above, &through, 1);
                    set += glint_unpack(&target, x, y).r_q15 != 0;
                }
                worst = fmax(worst, fabs(set / 64.0 - (own + t * (behind / 32768.0)) / 32768.0));
            }
        }
    }
    printf("mean over the pattern: off by at most %.4f of a step\n", worst);
    assert_true(worst <= MEAN_STEPS && worst > MEAN_STEPS / 2);
}

/* ----------------------------------------------------------------------------------------------------------- grazing
 */

static void test_mirrored_power(void **state)
{
    long double worst = 0;
    (void)state;
    for (int32_t cosine = -32775; cosine <= 32775; cosine++) {
        const long double rest = fmaxl(0, 1 - fabsl(cosine / 32768.0L));
        const long double exact = 32768 * rest * rest * rest * rest * rest;
        worst = fmaxl(worst, fabsl(glint_through_mirrored_q15(cosine) - exact));
    }
    assert_true(worst <= MIRRORED_ULP);
    assert_int_equal(glint_through_mirrored_q15(0), 32768);
    assert_int_equal(glint_through_mirrored_q15(32768), 0);
}

/* ------------------------------------------------------------------------------------------------------------- order
 */

static glint_bounds any_bounds(int most_bits)
{
    glint_bounds b;
    for (int k = 0; k < 3; k++) {
        b.centre_q16[k] = random_any_size(most_bits);
    }
    b.radius_q16 = random_any_size(most_bits);
    b.radius_q16 = b.radius_q16 < 0 ? -b.radius_q16 : b.radius_q16;
    return b;
}

/* Of two spheres apart, one that lies in front of the other on some ray has the smaller number. */
static void test_order_of_spheres(void **state)
{
    int tried = 0;
    (void)state;
    for (int i = 0; i < ORDER_ROUNDS; i++) {
        const int bits = random_between(8, 31);
        const glint_bounds a = any_bounds(bits), b = any_bounds(bits);
        int32_t eye[3];
        long double between[3], direction[3], square = 0;
        for (int k = 0; k < 3; k++) {
            eye[k] = random_any_size(bits < 30 ? bits : 30);
            between[k] = (long double)(a.centre_q16[k] - b.centre_q16[k]);
            square += between[k] * between[k];
            /* a ray through somewhere in a */
            direction[k] =
                (long double)(a.centre_q16[k] - eye[k]) + (2 * random_unit() - 1) * (long double)a.radius_q16;
        }
        const long double apart = sqrtl(square) - (long double)(a.radius_q16 + b.radius_q16);
        if (apart < 1e-4L * sqrtl(square) + 16 || dot(direction, direction) < 1) {
            continue;
        }
        (void)normalise(direction);
        long double enter[2];
        bool met = true;
        for (int n = 0; n < 2; n++) {
            const glint_bounds *s = n == 0 ? &a : &b;
            long double along = 0, away = 0;
            for (int k = 0; k < 3; k++) {
                along += direction[k] * (long double)(s->centre_q16[k] - eye[k]);
                away += (long double)(s->centre_q16[k] - eye[k]) * (long double)(s->centre_q16[k] - eye[k]);
            }
            const long double rest = (long double)s->radius_q16 * (long double)s->radius_q16 - (away - along * along);
            met = met && rest >= 0;
            enter[n] = met ? along + sqrtl(rest) : 0; /* where it leaves; behind the eye: not seen */
            met = met && enter[n] > 0;
        }
        if (!met) {
            continue;
        }
        tried++;
        const int32_t order_a = glint_through_order(&a, eye), order_b = glint_through_order(&b, eye);
        if ((enter[0] < enter[1]) != (order_a < order_b) && order_a != order_b) {
            fail_msg("spheres in the wrong order: %d, %d", (int)order_a, (int)order_b);
        }
    }
    printf("%d pairs of spheres on one ray\n", tried);
    assert_true(tried > 1000);
}

/* ------------------------------------------------------------------------------------------------------------ frames
 */

#define SHEETS 4

/* Boards behind each other that all face the eye and emit light; the last one is opaque. */
typedef struct sheets {
    board b;
    glint_material material[SHEETS];
    glint_object object[SHEETS];
} sheets;

static void sheets_set_up(sheets *s, int count)
{
    memset(s, 0, sizeof *s);
    board_set_up(&s->b);
    s->b.scene.light_count = 0;
    for (int i = 0; i < count; i++) {
        s->material[i].emission = board_grey(4000 + 3000 * i);
        s->object[i].mesh = &s->b.mesh;
        s->object[i].material = &s->material[i];
        s->object[i].place.origin_q16[2] = BOARD_Q16(-i); /* the first is the nearest */
        for (int k = 0; k < 3; k++) {
            s->object[i].place.linear_q16[k][k] = BOARD_Q16(2);
        }
        s->material[i].transmission_q14 = (uint16_t)(i + 1 < count ? 6000 + 2500 * i : 0);
    }
    s->b.scene.objects = s->object;
    s->b.scene.object_count = (uint16_t)count;
}

static void draw(frame *f, const glint_scene *scene, int backend, uint16_t band_px, size_t memory_bytes)
{
    memset(f, 0, sizeof *f);
    f->display.width_px = f->display.height_px = BOARD_PX;
    f->display.band_px = band_px;
    f->memory_bytes = memory_bytes;
    assert_int_equal(frame_draw(f, scene, backend), 0);
}

/* However the scene lists them, with lists or without: each pixel is the same, so that no edge is covered twice. */
static void test_sheets_lie_over_each_other(void **state)
{
    static sheets s;
    (void)state;
    for (int turn = 0; turn < SHEETS * FRAME_BACKENDS * 3; turn++) {
        const int backend = turn % 2, first = turn / 2 % SHEETS;
        const uint16_t band_px = (uint16_t)(turn / 8 == 0 ? 0 : 5);
        double expected = 0;
        frame f;
        sheets_set_up(&s, SHEETS);
        for (int i = SHEETS; i-- > 0;) {
            const double t = s.material[i].transmission_q14 / 16384.0, e = s.material[i].emission.r_q14 / 16384.0;
            expected = floor(255 * fmin(1, (1 - t) * e + t * expected) + 0.5) / 255;
        }
        glint_object turned[SHEETS];
        for (int i = 0; i < SHEETS; i++) {
            turned[i] = s.object[(i + first) % SHEETS];
        }
        s.b.scene.objects = turned;
        for (int i = 0; i < SHEETS; i++) {
            s.material[i].sides = (uint8_t)(turn / 8 == 2 ? GLINT_TWO_SIDED : GLINT_FRONT_SIDE);
        }
        draw(&f, &s.b.scene, backend, band_px, turn / 8 == 1);
        for (int i = 0; i < BOARD_PX * BOARD_PX * 3; i++) {
            assert_int_equal(f.pixels[i], lrint(255 * expected));
        }
        assert_int_equal(f.report.pixels_shaded, SHEETS * BOARD_PX * BOARD_PX);
        frame_free(&f);
    }
}

/* All of the light through: nothing is left but what grazes. */
static void test_all_through_is_invisible(void **state)
{
    static sheets s;
    (void)state;
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame with, without;
        sheets_set_up(&s, 2);
        s.material[0].transmission_q14 = 16384;
        draw(&with, &s.b.scene, backend, 0, 0);
        s.b.scene.objects = &s.object[1];
        s.b.scene.object_count = 1;
        draw(&without, &s.b.scene, backend, 0, 0);
        assert_memory_equal(with.pixels, without.pixels, with.bytes);
        frame_free(&with);
        frame_free(&without);
    }
}

/* A layer behind what is opaque, and one that the depth test refuses, change nothing. */
static void test_hidden_layers_do_not_show(void **state)
{
    static sheets s;
    (void)state;
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame f;
        sheets_set_up(&s, 3);
        s.material[0].transmission_q14 = 0;
        s.material[2].transmission_q14 = 8000;
        draw(&f, &s.b.scene, backend, 7, 0);
        const double shown = 255 * s.material[0].emission.r_q14 / 16384.0;
        for (int i = 0; i < BOARD_PX * BOARD_PX * 3; i++) {
            assert_true(fabs(f.pixels[i] - shown) <= 0.51);
        }
        assert_int_equal(f.report.pixels_shaded, BOARD_PX * BOARD_PX);
        frame_free(&f);
    }
}

/* Lists have room for both passes of an object, and no more than that. */
static void test_memory_of_two_passes(void **state)
{
    static sheets s;
    const glint_display display = {.width_px = BOARD_PX, .height_px = BOARD_PX, .band_px = 8};
    size_t bytes[3];
    (void)state;
    for (int n = 0; n < 3; n++) {
        sheets_set_up(&s, 2);
        s.material[0].transmission_q14 = (uint16_t)(n > 0 ? 8000 : 0);
        s.material[0].sides = (uint8_t)(n > 1 ? GLINT_EACH_SIDE : GLINT_FRONT_SIDE);
        bytes[n] = glint_fixed_memory_bytes(&s.b.scene, &display);
    }
    assert_int_equal(bytes[0], bytes[1]);
    assert_int_equal(bytes[2] - bytes[1], 4); /* two triangles once more, 2 bytes each */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_unpacking_is_the_inverse_of_packing),
        cmocka_unit_test(test_levels_read_back_to_half_a_unit),
        cmocka_unit_test(test_dithered_layers_keep_the_mean),
        cmocka_unit_test(test_mirrored_power),
        cmocka_unit_test(test_order_of_spheres),
        cmocka_unit_test(test_sheets_lie_over_each_other),
        cmocka_unit_test(test_all_through_is_invisible),
        cmocka_unit_test(test_hidden_layers_do_not_show),
        cmocka_unit_test(test_memory_of_two_passes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
