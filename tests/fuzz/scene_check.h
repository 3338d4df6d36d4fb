/* SPDX-License-Identifier: MIT */
/*
 * Draws a scene made of bytes in both backends and their variants and checks what the headers promise of every call:
 *
 *   - an argument that is not valid gives an error, and nothing is written: neither memory nor report, and no flush;
 *   - a valid call gives 0, or what the flush function returned; each row is flushed once, in order;
 *   - a band's pixels stay as they are until its transfer has ended, however late that is told;
 *   - nothing past the end of the memory is written, nor read where AddressSanitizer is there to see it;
 *   - the counts of the report add up;
 *   - another band height, another number of buffers, another memory size: the same picture and the same counts.
 *
 * What is asked of several pictures of one scene is in scene_stages.h.
 */
#ifndef GLINT_TESTS_FUZZ_SCENE_CHECK_H
#define GLINT_TESTS_FUZZ_SCENE_CHECK_H

#include "tests/fuzz/scene_validity.h"

#include "tests/unit/backends.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FUZZ_POISON 1
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define FUZZ_POISON 1
#endif
#ifdef FUZZ_POISON
#include <sanitizer/asan_interface.h>
#else
#define ASAN_POISON_MEMORY_REGION(address, bytes_long) ((void)(address), (void)(bytes_long))
#define ASAN_UNPOISON_MEMORY_REGION(address, bytes_long) ((void)(address), (void)(bytes_long))
#endif

/* Numbers 0 and 1 are the backends; after them their variants, fixed and float in turn. */
enum { RENDERERS = 6 };

static const renderer renderers[RENDERERS] = {
    {"fixed", glint_fixed_render, glint_fixed_memory_bytes, glint_fixed_memory_least_bytes},
    {"float", glint_float_render, glint_float_memory_bytes, glint_float_memory_least_bytes},
    {"fixed phong", glint_fixed_phong_render, glint_fixed_phong_memory_bytes, glint_fixed_phong_memory_least_bytes},
    {"float phong", glint_float_phong_render, glint_float_phong_memory_bytes, glint_float_phong_memory_least_bytes},
    {"fixed diffuse", glint_fixed_diffuse_render, glint_fixed_diffuse_memory_bytes,
     glint_fixed_diffuse_memory_least_bytes},
    {"float diffuse", glint_float_diffuse_render, glint_float_diffuse_memory_bytes,
     glint_float_diffuse_memory_least_bytes},
};

enum { CANARY = 64, CANARY_BYTE = 0xa5, MOST_IN_FLIGHT = 2, NO_BAND = 65535 };

/* What varies between pictures that must be alike. */
typedef struct drawing {
    uint16_t band_px;
    uint8_t buffer_count;
    bool transfers;      /* the end of a transfer is told apart */
    bool late;           /* not from within flush, but when the library waits */
    uint8_t memory_kind; /* 0 full, 1 least, 2 between, 3 more, 4 one byte too little, 5 not aligned */
    uint16_t memory_part;
    uint16_t fail_at; /* the flush of this band returns an error; NO_BAND: none */
    int fail_with;
} drawing;

typedef struct screen {
    const glint_display *display;
    uint8_t *pixels; /* the whole frame, rows (pages) without gap */
    uint32_t row_bytes;
    uint16_t next_row, bands;
    bool ended, failed, late;
    uint16_t fail_at;
    int fail_with;
    glint_transfers transfers;
    glint_band flying[MOST_IN_FLIGHT];
    int flying_count;
} screen;

static inline void take_pixels(screen *s, const glint_band *band, bool again)
{
    const bool pages = s->display->format == GLINT_MONO_PAGES;
    const unsigned rows = pages ? (band->height_px + 7u) / 8 : band->height_px;
    const unsigned first = pages ? band->y_px / 8u : band->y_px;
    for (unsigned y = 0; y < rows; y++) {
        uint8_t *to = s->pixels + (size_t)(first + y) * s->row_bytes;
        const uint8_t *from = (const uint8_t *)band->pixels + (size_t)y * band->stride_bytes;
        if (again) {
            FUZZ_CHECK(memcmp(to, from, s->row_bytes) == 0, "row %u written while it was being sent", first + y);
        } else {
            memcpy(to, from, s->row_bytes);
        }
    }
}

static inline void end_transfer(screen *s)
{
    take_pixels(s, &s->flying[0], true);
    s->flying[0] = s->flying[1];
    s->flying_count--;
    glint_flush_done(&s->transfers);
}

static inline int screen_flush(void *context, const glint_band *band)
{
    screen *s = context;
    const glint_display *d = s->display;
    const unsigned rows = d->format == GLINT_MONO_PAGES ? (band->height_px + 7u) / 8 : band->height_px;
    FUZZ_CHECK(!s->ended, "a band after the last");
    FUZZ_CHECK(band->y_px == s->next_row && band->height_px > 0, "row %u, expected %u", band->y_px, s->next_row);
    FUZZ_CHECK(band->y_px + band->height_px <= d->height_px, "below the display");
    FUZZ_CHECK(band->width_px == d->width_px && band->stride_bytes >= s->row_bytes, "stride %u", band->stride_bytes);
    FUZZ_CHECK(d->stride_bytes == 0 || band->stride_bytes == d->stride_bytes, "stride %u", band->stride_bytes);
    FUZZ_CHECK(band->bytes == rows * band->stride_bytes, "%u bytes", band->bytes);
    if (s->bands == s->fail_at) {
        s->ended = s->failed = true;
        return s->fail_with;
    }
    s->next_row = (uint16_t)(s->next_row + band->height_px);
    s->bands++;
    s->ended = band->last;
    FUZZ_CHECK(band->last == (s->next_row == d->height_px), "last told at row %u", s->next_row);
    take_pixels(s, band, false);
    if (d->transfers) {
        FUZZ_CHECK(s->flying_count < (d->buffer_count == 2 ? 2 : 1), "more transfers than buffers");
        s->flying[s->flying_count++] = *band;
        if (!s->late) {
            end_transfer(s);
        }
    }
    return 0;
}

static inline void screen_wait(void *context)
{
    screen *s = context;
    FUZZ_CHECK(s->flying_count > 0, "waits for nothing");
    end_transfer(s);
}

/* All counts; what pads the structure's end is no count. */
static inline bool same_report(const glint_report *a, const glint_report *b)
{
    const uint8_t *first = (const uint8_t *)a, *second = (const uint8_t *)b;
    return memcmp(first, second, offsetof(glint_report, promise_q8)) == 0 && a->promise_q8 == b->promise_q8;
}

static inline void check_tiers(const glint_report *r)
{
    uint32_t pixels = 0, parts = 0;
    for (int i = 0; i < GLINT_TIERS; i++) {
        pixels += r->tier_pixels[i];
        parts += r->tier_triangles[i];
        FUZZ_CHECK(r->tier_triangles[i] > 0 || r->tier_pixels[i] == 0, "pixels of no triangle, tier %d", i);
    }
    FUZZ_CHECK(pixels == r->pixels_shaded, "%u pixels in tiers, %u shaded", pixels, r->pixels_shaded);
    FUZZ_CHECK(parts >= r->triangles_drawn && (parts == r->triangles_drawn || r->triangles_clipped > 0),
               "%u parts of %u triangles in tiers", parts, r->triangles_drawn);
    FUZZ_CHECK(r->specular_triangles <= parts, "%u of %u specular", r->specular_triangles, parts);
}

static inline void check_report(const glint_report *r, const scene_case *c, const screen *s, size_t memory_bytes,
                                int backend)
{
    uint32_t triangles = 0, vertices = 0;
    for (uint16_t i = 0; i < c->scene.object_count; i++) {
        triangles += c->objects[i].mesh->triangle_count;
        vertices += c->objects[i].mesh->vertex_count;
    }
    FUZZ_CHECK(r->triangles == triangles, "%u of %u triangles", r->triangles, triangles);
    FUZZ_CHECK(r->triangles_drawn + r->triangles_facing_away + r->triangles_outside + r->triangles_empty +
                       r->triangles_refused ==
                   triangles,
               "fates of %u triangles do not add up", triangles);
    FUZZ_CHECK(r->triangles_clipped <= r->triangles_drawn, "%u clipped", r->triangles_clipped);
    FUZZ_CHECK(r->triangles_refused == 0 || backend % 2 == 1, "the fixed backend refused");
    FUZZ_CHECK(r->triangles_drawn > 0 || r->pixels_shaded == 0, "%u pixels of no triangle", r->pixels_shaded);
    FUZZ_CHECK(r->pixels_specular <= r->pixels_shaded, "%u specular", r->pixels_specular);
    const bool corners = c->quality.shading == GLINT_SHADING_GOURAUD || c->quality.shading == GLINT_SHADING_FLAT;
    FUZZ_CHECK(!corners || r->pixels_specular == 0, "specular counted");
    /* what the fog hides altogether is one colour in any shading, and but for rounding exact */
    const bool foggy = c->scene.fog.end_q16 != 0 && r->promise_q8 <= 129;
    FUZZ_CHECK(!corners || r->triangles_drawn == 0 || foggy || r->promise_q8 == UINT16_MAX, "promises %u",
               r->promise_q8);
    check_tiers(r);
    FUZZ_CHECK(r->bands == s->bands, "%u bands, saw %u", r->bands, s->bands);
    FUZZ_CHECK(r->memory_used_bytes <= memory_bytes, "%u bytes used", r->memory_used_bytes);
    FUZZ_CHECK(memory_bytes < renderers[backend].memory_bytes(&c->scene, s->display) ||
                   r->vertices_transformed == vertices,
               "%u vertices transformed of %u", r->vertices_transformed, vertices);
}

static inline size_t memory_for(const drawing *how, const scene_case *c, size_t least, size_t full)
{
    switch (how->memory_kind) {
    case 1:
        return least;
    case 2:
        return least + (full - least) * how->memory_part / 65535;
    case 3:
        /* with a tolerance, ramps and tables of highlights lie there: of all objects, or of some */
        return full + how->memory_part % (c->quality.tolerance ? (CASE_OBJECTS + 1) * GLINT_RAMP_WORDS * 4u : 1024u);
    case 4:
        return least - 1;
    default:
        return full;
    }
}

/* Draws once. Returns the pixels (to be freed) and the report where the call succeeded, otherwise NULL. Variants have
 * no report: it is left as it was. */
static inline uint8_t *draw_and_check(scene_case *c, const drawing *how, int backend, glint_report *report)
{
    const renderer *r = &renderers[backend];
    glint_display display = c->display;
    screen s = {.display = &display, .late = how->late, .fail_at = how->fail_at, .fail_with = how->fail_with};
    display.band_px = how->band_px;
    display.buffer_count = how->buffer_count;
    display.flush = c->null & NULL_FLUSH ? NULL : screen_flush;
    display.context = &s;
    display.transfers = how->transfers ? &s.transfers : NULL;
    display.wait = how->late ? screen_wait : NULL;
    scene_case asked = *c; /* only display differs: objects still point into *c */
    asked.display = display;
    validity expected = scene_case_validity(&asked);
    if (backend >= BACKENDS && expected == INVALID && c->null == 0) {
        expected = EITHER; /* a variant does not read the fields of parts that it has not */
    } else if (expected != INVALID && backend >= BACKENDS && !variant_has_all(c, backend < 2 * BACKENDS)) {
        expected = INVALID;
    }

    const glint_scene *scene = c->null & NULL_SCENE ? NULL : &c->scene;
    const glint_display *on = c->null & NULL_DISPLAY ? NULL : &display;
    const size_t full = r->memory_bytes(scene, on), least = r->memory_least_bytes(scene, on);
    FUZZ_CHECK(least <= full && (least > 0) == (full > 0), "least %zu, full %zu", least, full);
    FUZZ_CHECK(expected != VALID || least > 0, "no size for a valid scene");
    if (least > ((size_t)1 << 22)) {
        return NULL; /* a stride near its limit: too slow here */
    }
    const size_t given = least == 0 ? 256 : memory_for(how, c, least, full);
    const size_t shift = how->memory_kind == 5 ? 1 + how->memory_part % 3u : 0;
    if (least > 0 && (how->memory_kind == 4 || shift > 0)) {
        expected = INVALID;
    }
    s.row_bytes = glint_row_bytes(display.format, display.width_px);
    s.pixels = malloc((size_t)s.row_bytes * display.height_px + 1);
    uint8_t *block = malloc(shift + given + CANARY), *memory = block + shift;
    FUZZ_CHECK(s.pixels != NULL && block != NULL, "out of memory");
    memset(block, CANARY_BYTE, shift + given + CANARY);
    const bool reports = backend < BACKENDS;
    if (reports) {
        memset(report, CANARY_BYTE, sizeof *report);
    }
    const glint_report untouched = *report;

    ASAN_POISON_MEMORY_REGION(memory + given, CANARY);
    const int result = r->render(scene, on, c->null & NULL_QUALITY ? NULL : &c->quality,
                                 c->null & NULL_MEMORY ? NULL : memory, given, reports ? report : NULL);
    ASAN_UNPOISON_MEMORY_REGION(memory + given, CANARY);

    for (size_t i = 0; i < CANARY; i++) {
        FUZZ_CHECK(memory[given + i] == CANARY_BYTE, "wrote %zu bytes past the memory", i);
    }
    FUZZ_CHECK(s.flying_count == 0, "returned with a transfer under way");
    if (s.failed) {
        FUZZ_CHECK(expected != INVALID && result == how->fail_with, "%d instead of the flush's %d", result,
                   how->fail_with);
    } else if (result == 0) {
        FUZZ_CHECK(expected != INVALID, "%s: an invalid call succeeded", r->name);
        FUZZ_CHECK(s.next_row == display.height_px, "%u rows of %u", s.next_row, display.height_px);
        if (reports) {
            check_report(report, c, &s, given, backend);
        }
    } else {
        FUZZ_CHECK(expected != VALID, "a valid call failed: %d, %s", result, glint_error_text(result));
        FUZZ_CHECK(result < 0 && strcmp(glint_error_text(result), "unknown error") != 0, "error %d", result);
        FUZZ_CHECK(s.bands == 0 && s.next_row == 0, "flushed in spite of error %d", result);
        FUZZ_CHECK(same_report(report, &untouched), "report written in spite of error %d", result);
        for (size_t i = 0; i < given; i++) {
            FUZZ_CHECK(memory[i] == CANARY_BYTE, "memory written in spite of error %d", result);
        }
    }
    free(block);
    if (result != 0) {
        free(s.pixels);
        s.pixels = NULL;
    }
    return s.pixels;
}

static inline void take_drawing(bytes *b, const glint_display *display, drawing *how)
{
    const uint8_t kind = take_u8(b);
    how->band_px = (uint16_t)take_between(b, kind & 1 ? 0 : 1, display->height_px);
    if (display->format == GLINT_MONO_PAGES) {
        how->band_px = (uint16_t)(how->band_px & ~7);
    }
    how->buffer_count = (uint8_t)(kind & 2 ? 2 : 1);
    how->transfers = (kind & 6) != 0;
    how->late = how->transfers && kind & 8;
    how->memory_kind = kind >> 4 & 3;
    how->memory_part = take_u16(b);
    how->fail_at = NO_BAND;
}

static inline void expect_alike(scene_case *c, const drawing *how, int backend, const uint8_t *pixels,
                                const glint_report *report)
{
    glint_report other = *report;
    uint8_t *again = draw_and_check(c, how, backend, &other);
    FUZZ_CHECK(again != NULL, "failed with band %u, memory %u", how->band_px, how->memory_kind);
    const uint32_t row_bytes = glint_row_bytes(c->display.format, c->display.width_px);
    const uint32_t rows =
        c->display.format == GLINT_MONO_PAGES ? (c->display.height_px + 7u) / 8 : c->display.height_px;
    for (uint32_t i = 0; i < rows * row_bytes; i++) {
        FUZZ_CHECK(pixels[i] == again[i], "%s: byte %u of row %u differs with band %u, memory %u %u",
                   renderers[backend].name, i % row_bytes, i / row_bytes, how->band_px, how->memory_kind,
                   how->memory_part);
    }
    other.bands = report->bands;
    other.memory_used_bytes = report->memory_used_bytes;
    other.vertices_transformed = report->vertices_transformed;
    other.shadow_tests = report->shadow_tests;
    FUZZ_CHECK(same_report(&other, report), "%s: other counts with band %u, memory %u", renderers[backend].name,
               how->band_px, how->memory_kind);
    free(again);
}

#endif
