/* SPDX-License-Identifier: MIT */
/*
 * Drawing a scene into one whole frame in memory, for the image tests.
 *
 * The working memory and the frame are allocated to the byte, with canaries past their ends that frame_free() checks.
 */
#ifndef GLINT_TESTS_IMAGE_FRAME_H
#define GLINT_TESTS_IMAGE_FRAME_H

#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <setjmp.h>

#include <cmocka.h>

#include <glint/glint.h>

enum { FRAME_FIXED = 0, FRAME_FLOAT = 1, FRAME_BACKENDS = 2 };

static const char *const frame_backend_name[FRAME_BACKENDS] = {"fixed", "float"};

#define FRAME_CANARY 64
#define FRAME_CANARY_BYTE 0xa5

typedef struct frame {
    glint_display
        display; /* what the caller sets: size, band, format, dither, buffers, stride; the rest is filled in */
    uint8_t shading, tolerance;
    size_t memory_bytes; /* 0: all that the backend can make use of; 1: the least */
    /* results */
    uint8_t *pixels; /* rows (pages) of row_bytes, the whole frame */
    size_t row_bytes, bytes;
    glint_report report;
    uint16_t bands_seen, next_row;
    size_t memory_given;
    glint_transfers transfers;
} frame;

static inline int frame_flush(void *context, const glint_band *band)
{
    frame *f = context;
    const uint8_t *row = band->pixels;
    const unsigned rows = f->display.format == GLINT_MONO_PAGES ? (band->height_px + 7u) / 8 : band->height_px;
    const unsigned first = f->display.format == GLINT_MONO_PAGES ? band->y_px / 8u : band->y_px;
    assert_int_equal(band->y_px, f->next_row);
    assert_int_equal(band->width_px, f->display.width_px);
    assert_int_equal(band->bytes, rows * band->stride_bytes);
    for (unsigned y = 0; y < rows; y++) {
        memcpy(f->pixels + (first + y) * f->row_bytes, row + y * band->stride_bytes, f->row_bytes);
    }
    f->next_row = (uint16_t)(f->next_row + band->height_px);
    f->bands_seen++;
    const unsigned end =
        f->display.area_height_px ? f->display.area_y_px + f->display.area_height_px : f->display.height_px;
    assert_int_equal(band->last, f->next_row == end);
    if (f->display.transfers) {
        glint_flush_done(f->display.transfers);
    }
    return 0;
}

/* Draws; returns what the library returned. */
static inline int frame_draw(frame *f, const glint_scene *scene, int backend)
{
    const glint_quality quality = {.shading = f->shading, .tolerance = f->tolerance};
    f->display.flush = frame_flush;
    f->display.context = f;
    f->display.transfers = f->display.buffer_count == 2 ? &f->transfers : NULL;
    f->row_bytes = glint_row_bytes(f->display.format, f->display.width_px);
    const size_t rows = f->display.format == GLINT_MONO_PAGES ? (f->display.height_px + 7u) / 8 : f->display.height_px;
    f->bytes = rows * f->row_bytes;
    f->pixels = malloc(f->bytes + FRAME_CANARY);
    assert_non_null(f->pixels);
    memset(f->pixels, FRAME_CANARY_BYTE, f->bytes + FRAME_CANARY);

    const size_t full = backend == FRAME_FIXED ? glint_fixed_memory_bytes(scene, &f->display)
                                               : glint_float_memory_bytes(scene, &f->display);
    const size_t least = backend == FRAME_FIXED ? glint_fixed_memory_least_bytes(scene, &f->display)
                                                : glint_float_memory_least_bytes(scene, &f->display);
    const bool tiers = f->tolerance != 0 || f->shading >= GLINT_SHADING_Q1;
    const size_t tables = tiers ? (size_t)scene->object_count * GLINT_RAMP_WORDS * 4 : 0;
    const size_t bytes = f->memory_bytes == 0 ? full + tables : f->memory_bytes == 1 ? least : f->memory_bytes;
    uint8_t *memory = malloc(bytes + FRAME_CANARY);
    assert_non_null(memory);
    memset(memory, FRAME_CANARY_BYTE, bytes + FRAME_CANARY);
    f->memory_given = bytes;
    f->next_row = f->display.area_y_px;
    f->bands_seen = 0;
    const int result = backend == FRAME_FIXED
                           ? glint_fixed_render(scene, &f->display, &quality, memory, bytes, &f->report)
                           : glint_float_render(scene, &f->display, &quality, memory, bytes, &f->report);
    for (size_t i = 0; i < FRAME_CANARY; i++) {
        assert_int_equal(memory[bytes + i], FRAME_CANARY_BYTE);
        assert_int_equal(f->pixels[f->bytes + i], FRAME_CANARY_BYTE);
    }
    free(memory);
    return result;
}

static inline void frame_free(frame *f)
{
    free(f->pixels);
    f->pixels = NULL;
}

/* FNV-1a, 64 bits: G. Fowler, L. C. Noll, K.-P. Vo. */
static inline uint64_t frame_hash(const frame *f)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < f->bytes; i++) {
        hash = (hash ^ f->pixels[i]) * 0x100000001b3u;
    }
    return hash;
}

#endif
