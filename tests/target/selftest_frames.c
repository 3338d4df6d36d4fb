/* SPDX-License-Identifier: MIT */
/*
 * Small frames: in the fixed backend every pixel format, shading, several heights of a band and the least memory,
 * hashed; and pictures in both backends, printed for check.c.
 *
 * Limits: what fits 16 KB of RAM with the stack.
 */
#include "tests/target/selftest.h"

#include <stddef.h>
#include <string.h>

#include <examples/scenes/scenes.h>
#include <glint/glint.h>

#include "tests/target/platform.h"

/* The largest: a whole frame of 48 x 32 RGB888 with 52 vertices. */
static uint32_t memory[GLINT_MEMORY_WORDS(48, 32, 32, GLINT_RGB888, 1, 52, 100, 1, 1)];

typedef int (*renderer)(const glint_scene *, const glint_display *, const glint_quality *, void *, size_t,
                        glint_report *);
typedef size_t (*measurer)(const glint_scene *, const glint_display *);

typedef struct frame_case {
    const char *name;
    const glint_scene *scene;
    uint16_t width_px, height_px, band_px;
    uint8_t format, dither, shading;
    bool least_memory;
} frame_case;

/* Formats of 16 bits in the processor's byte order or against it are hashed by value, so both count as high byte first
 * on the display. */
static const frame_case cases[] = {
    {"sphere-rgb565-bayer", &demo_sphere_10x6, 48, 32, 7, GLINT_RGB565, GLINT_DITHER_BAYER, GLINT_SHADING_EXACT, false},
    {"sphere-rgb565-swapped", &demo_sphere_10x6, 32, 24, 5, GLINT_RGB565_SWAPPED, GLINT_DITHER_NONE,
     GLINT_SHADING_EXACT, true},
    {"sphere-grey4-gouraud", &demo_sphere_10x6, 33, 25, 9, GLINT_GREY4, GLINT_DITHER_BAYER, GLINT_SHADING_GOURAUD,
     false},
    {"sphere-mono-bayer", &demo_sphere_10x6, 48, 32, 8, GLINT_MONO_PAGES, GLINT_DITHER_BAYER, GLINT_SHADING_EXACT,
     false},
    {"room-grey8", &selftest_room, 32, 24, 8, GLINT_GREY8, GLINT_DITHER_NONE, GLINT_SHADING_EXACT, true},
#if SELFTEST_SHADOWS
    {"shadows-grey8", &selftest_shadows, 32, 24, 6, GLINT_GREY8, GLINT_DITHER_NONE, GLINT_SHADING_EXACT, true},
#endif
    {"room-mono-flat", &selftest_room, 48, 32, 16, GLINT_MONO_PAGES, GLINT_DITHER_NONE, GLINT_SHADING_FLAT, false},
};

typedef struct sink {
    uint64_t hash;
    const char *name, *backend; /* name NULL: the pixels are not printed */
    uint8_t format;
} sink;

enum { PIECE_PX = 24 };

static void print_row(const sink *to, uint16_t y_px, const uint8_t *row, uint16_t width_px)
{
    for (uint16_t x = 0; x < width_px; x = (uint16_t)(x + PIECE_PX)) {
        const uint16_t count = width_px - x < PIECE_PX ? (uint16_t)(width_px - x) : PIECE_PX;
        report_begin("pixels");
        report_word(to->name);
        report_word(to->backend);
        report_decimal(y_px);
        report_decimal(x);
        report_bytes(row + (size_t)x * 3, (uint16_t)(count * 3));
        report_end();
    }
}

static void failed(const char *name, int error)
{
    report_begin("failed");
    report_word(name);
    report_decimal((uint32_t)-error);
    report_end();
}

static int take(void *context, const glint_band *band)
{
    sink *to = context;
    const uint8_t *pixels = band->pixels;
    if (to->format == GLINT_RGB565 || to->format == GLINT_RGB565_SWAPPED) {
        for (uint32_t i = 0; i < band->bytes; i += 2) {
            uint16_t value;
            memcpy(&value, pixels + i, sizeof value);
            if (to->format == GLINT_RGB565_SWAPPED) {
                value = (uint16_t)(value << 8 | value >> 8);
            }
            to->hash = hash_bytes(to->hash, value, 2);
        }
        return 0;
    }
    for (uint32_t i = 0; i < band->bytes; i++) {
        to->hash = hash_bytes(to->hash, pixels[i], 1);
    }
    for (uint16_t y = 0; to->name && y < band->height_px; y++) {
        print_row(to, (uint16_t)(band->y_px + y), pixels + (size_t)y * (size_t)band->stride_bytes, band->width_px);
    }
    return 0;
}

static int discard(void *context, const glint_band *band)
{
    (void)context;
    (void)band;
    return 0;
}

/* Draws with the memory that the case asks for and no more. False, told, if it fails. */
static bool draw(const frame_case *c, glint_flush flush, sink *to, renderer render, measurer bytes)
{
    const glint_display display = {.width_px = c->width_px,
                                   .height_px = c->height_px,
                                   .band_px = c->band_px,
                                   .format = c->format,
                                   .dither = c->dither,
                                   .flush = flush,
                                   .context = to};
    const glint_quality quality = {.shading = c->shading};
    const size_t needed = bytes(c->scene, &display);
    const int error = needed == 0 || needed > sizeof memory
                          ? GLINT_ERROR_MEMORY_SIZE
                          : render(c->scene, &display, &quality, memory, needed, NULL);
    if (error) {
        failed(c->name, error);
    }
    return error == 0;
}

static frame_case case_of(const selftest_picture *picture)
{
    const frame_case c = {.name = picture->name,
                          .scene = picture->scene,
                          .width_px = picture->width_px,
                          .height_px = picture->height_px,
                          .band_px = picture->band_px,
                          .format = GLINT_RGB888,
                          .shading = picture->shading};
    return c;
}

static void fixed_frame(const frame_case *c, bool printed)
{
    sink to = {HASH_START, printed ? c->name : NULL, "fixed", c->format};
    if (draw(c, take, &to, glint_fixed_render,
             c->least_memory ? glint_fixed_memory_least_bytes : glint_fixed_memory_bytes)) {
        report_begin("frame");
        report_word(c->name);
        report_hex(to.hash, 16);
        report_end();
    }
}

static void stack(const char *backend)
{
    report_begin("stack");
    report_word(backend);
    report_decimal(platform_stack_used());
    report_end();
}

void selftest_frames(void)
{
    platform_stack_paint();
    for (uint8_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fixed_frame(&cases[i], false);
    }
    for (uint8_t i = 0; i < SELFTEST_PICTURES; i++) {
        const frame_case c = case_of(&selftest_pictures[i]);
        fixed_frame(&c, true);
    }
    stack("fixed");
#if !SELFTEST_TEXTURES
    report_begin("textured-frames");
    report_word("none");
    report_end();
#endif
#if SELFTEST_FLOAT_FRAMES
    platform_stack_paint();
    for (uint8_t i = 0; i < SELFTEST_PICTURES; i++) {
        const frame_case c = case_of(&selftest_pictures[i]);
        sink to = {HASH_START, c.name, "float", c.format};
        (void)draw(&c, take, &to, glint_float_render, glint_float_memory_bytes);
    }
    stack("float");
#else
    report_begin("float-frames");
    report_word("none");
    report_end();
#endif
}

void selftest_draw_counted(bool in_float)
{
    static const frame_case counted = {"counted",         &demo_sphere_10x6,   48,   32, 8, GLINT_RGB565_SWAPPED,
                                       GLINT_DITHER_NONE, GLINT_SHADING_EXACT, false};
#if SELFTEST_FLOAT_FRAMES
    if (in_float) {
        (void)draw(&counted, discard, NULL, glint_float_render, glint_float_memory_bytes);
        return;
    }
#endif
    (void)in_float;
    (void)draw(&counted, discard, NULL, glint_fixed_render, glint_fixed_memory_bytes);
}
