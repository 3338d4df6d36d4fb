/* SPDX-License-Identifier: MIT */
/*
 * The body of the scene fuzzer. Each input is a scene that is drawn three times over: as it is; tamed, so that cheap
 * shading serves it; and with effects. What scene_check.h asks of each call is asked of all, and of them together:
 *
 *   - a tolerance changes neither what is covered nor the fates of triangles, promises no more than was asked for where
 *     exact shading can keep that, and its picture is as near to the exact one as the two promises say;
 *   - a variant of a backend draws the same picture as the whole, or refuses the scene.
 */
#ifndef GLINT_TESTS_FUZZ_SCENE_STAGES_H
#define GLINT_TESTS_FUZZ_SCENE_STAGES_H

#include "tests/fuzz/scene_check.h"

/* What a tolerance, or another shading, must leave alone. */
static inline void expect_same_surfaces(const glint_report *a, const glint_report *b)
{
    FUZZ_CHECK(a->triangles == b->triangles && a->triangles_drawn == b->triangles_drawn &&
                   a->triangles_facing_away == b->triangles_facing_away &&
                   a->triangles_outside == b->triangles_outside && a->triangles_empty == b->triangles_empty &&
                   a->triangles_refused == b->triangles_refused && a->triangles_clipped == b->triangles_clipped,
               "shading changed the fate of a triangle");
    FUZZ_CHECK(a->pixels_shaded == b->pixels_shaded, "%u pixels, and %u in another shading", a->pixels_shaded,
               b->pixels_shaded);
}

/* How many times a surface's promise a pixel may be off, since what shows through a surface is off too: 1 + t + t^2 ...
 * of the greatest transmission t; 0 where that is much. */
static inline double layers_factor(const scene_case *c)
{
    double most = 0;
    for (uint16_t i = 0; i < c->scene.object_count; i++) {
        most = fmax(most, c->objects[i].material->transmission_q14 / 16384.0);
    }
    return most > 0.75 ? 0 : 1 / (1 - most);
}

/* What the exact tier may promise more with a tolerance than without, 1/256 code. Panels and balls are fewer point
 * lights then, which takes half of what the tolerance leaves beside rounding (lighting/plan_source.c); or more of them,
 * and each has its own rounding. */
static inline uint32_t sources_slack(const scene_case *c)
{
    uint32_t points = 0;
    for (uint16_t i = 0; i < c->scene.light_count && c->quality.tolerance != 0; i++) {
        const glint_light *light = &c->scene.lights[i];
        points += light->kind < GLINT_PANEL ? 0 : light->samples == 0 ? 16 : light->samples;
    }
    return points == 0 ? 0 : (c->quality.tolerance * 16u - 128) / 2 + 4 * points;
}

/* An exact picture, and one of the same scene within a tolerance or by q1 or q2. Each pixel of each is within what its
 * report promises of one true colour, so they are within the sum of one another. */
static inline void expect_promises_kept(const scene_case *c, int backend, uint8_t *const pixels[2],
                                        const glint_report report[2])
{
    const uint32_t asked = c->quality.tolerance * 16u, exact = report[0].promise_q8, other = report[1].promise_q8,
                   most = exact + sources_slack(c);
    FUZZ_CHECK(asked == 0 || other <= (asked > most ? asked : most), "%s: promises %u / 256 code, exact %u, asked %u",
               renderers[backend].name, other, exact, asked);
    if (c->display.format != GLINT_RGB888 || exact == UINT16_MAX || other == UINT16_MAX) {
        return;
    }
    const double factor = layers_factor(c);
    const uint32_t row_bytes = glint_row_bytes(c->display.format, c->display.width_px);
    for (uint32_t i = 0; i < row_bytes * c->display.height_px; i++) {
        const uint32_t apart = (uint32_t)abs(pixels[0][i] - pixels[1][i]);
        FUZZ_CHECK(factor == 0 || apart * 256 <= factor * (exact + other),
                   "%s: byte %u of row %u is %u, exact %u; promised: %u and %u / 256 code (tolerance %u, shading %u)",
                   renderers[backend].name, i % row_bytes, i / row_bytes, pixels[1][i], pixels[0][i], other, exact,
                   c->quality.tolerance, c->quality.shading);
    }
}

/* The scene as `quality` asks, and in other bands and memories. Pixels and report as of draw_and_check(). */
static inline uint8_t *check_drawings(scene_case *c, const glint_quality *quality, const drawing *how,
                                      const drawing others[3], int backend, glint_report *report)
{
    c->quality = *quality;
    uint8_t *pixels = draw_and_check(c, how, backend, report);
    for (int i = backend; pixels != NULL && i < 2 + backend; i++) {
        expect_alike(c, &others[i], backend, pixels, report);
    }
    return pixels;
}

/* The variants of a backend: the same picture as the whole one's, or refused. */
static inline void check_variants(scene_case *c, const drawing *how, int backend, const uint8_t *pixels)
{
    const uint32_t row_bytes = glint_row_bytes(c->display.format, c->display.width_px);
    const uint32_t rows =
        c->display.format == GLINT_MONO_PAGES ? (c->display.height_px + 7u) / 8 : c->display.height_px;
    for (int variant = backend + BACKENDS; variant < RENDERERS; variant += BACKENDS) {
        glint_report report = {0};
        uint8_t *const mine = draw_and_check(c, how, variant, &report);
        /* what the whole refuses for a field of a part that the variant has not, that may draw */
        FUZZ_CHECK(mine == NULL || pixels == NULL || memcmp(mine, pixels, (size_t)rows * row_bytes) == 0,
                   "%s: another picture", renderers[variant].name);
        free(mine);
    }
}

static inline void check_qualities(scene_case *c, const glint_quality *quality, const drawing *how,
                                   const drawing others[3], int backend)
{
    const drawing plain = {.fail_at = NO_BAND, .buffer_count = 1, .band_px = how->band_px};
    glint_report report[2];
    uint8_t *pixels[2];
    c->quality.shading = GLINT_SHADING_EXACT;
    c->quality.tolerance = 0;
    pixels[0] = draw_and_check(c, &plain, backend, &report[0]);
    check_variants(c, &plain, backend, pixels[0]);
    pixels[1] = check_drawings(c, quality, how, others, backend, &report[1]);
    if (pixels[0] != NULL && pixels[1] != NULL) {
        expect_same_surfaces(&report[0], &report[1]);
        expect_promises_kept(c, backend, pixels, report);
    }
    free(pixels[0]);
    free(pixels[1]);
}

/* All that an input means but the effects, which are still to be taken. */
typedef struct scene_trial {
    scene_case c;
    drawing how, others[3];
    glint_quality first, second, third;
    taming tame;
    bytes effects;
    uint8_t reversed[MOST_FROM_END];
    uint8_t effect_fault;
} scene_trial;

static inline void take_trial(const uint8_t *data, size_t size, scene_trial *t)
{
    bytes b = bytes_from(data, size);
    memset(&t->how, 0, sizeof t->how);
    t->how.fail_at = NO_BAND;
    const uint8_t call = take_u8(&b), fault = take_u8(&b);
    t->how.memory_kind = (uint8_t)(call % 16 < 6 ? call % 16 : 0);
    t->how.memory_part = take_u16(&b);
    t->how.transfers = call & 16;
    t->how.late = t->how.transfers && call & 32;
    t->how.fail_with = take_between(&b, -100, 100);
    if (call >= 224 && t->how.fail_with != 0) {
        t->how.fail_at = (uint8_t)take_between(&b, 0, 3);
    }
    scene_case_take(&b, &t->c);
    t->how.band_px = t->c.display.band_px;
    t->how.buffer_count = t->c.display.buffer_count;
    t->how.transfers = t->how.transfers || (t->how.buffer_count == 2 && !(t->c.wild && take_rarely(&b, 4)));
    t->how.late = t->how.late && t->how.transfers;
    for (int i = 0; i < 3; i++) {
        take_drawing(&b, &t->c.display, &t->others[i]);
    }
    if (fault >= 224) {
        scene_case_break(&t->c, (uint8_t)(fault - 224));
    }
    t->first = t->c.quality;
    t->second = take_quality(&b);
    t->tame = take_taming(&b);
    t->effects = bytes_from_end(data, size, t->reversed);
    t->effect_fault = take_u8(&t->effects);
    t->third = take_quality(&t->effects);
}

/* The body of the fuzzer. */
static inline void check_scene_bytes(const uint8_t *data, size_t size)
{
    static scene_trial t;
    take_trial(data, size, &t);
    for (int backend = 0; backend < BACKENDS; backend++) {
        glint_report report;
        free(check_drawings(&t.c, &t.first, &t.how, t.others, backend, &report));
    }
    scene_case_tame(&t.c, &t.tame);
    for (int backend = 0; backend < BACKENDS; backend++) {
        check_qualities(&t.c, &t.second, &t.how, t.others, backend);
    }
    (void)scene_case_effects(&t.effects, &t.c);
    if (t.effect_fault >= 224) {
        scene_case_break_effect(&t.c, (uint8_t)(t.effect_fault - 224));
    }
    for (int backend = 0; backend < BACKENDS; backend++) {
        check_qualities(&t.c, &t.third, &t.how, t.others, backend);
    }
    scene_case_free(&t.c);
}

#endif
