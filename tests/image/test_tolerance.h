/* SPDX-License-Identifier: MIT */
/*
 * The tolerance against the double-precision reference: every plain pixel lies within what its own triangle promised,
 * and what was promised lies within the tolerance.
 *
 * A test file defines GLINT_OBSERVE, includes the backend's source, and then this. The hook puts observe_run() in the
 * place of what runs a triangle's pixels, so that for each pixel of the frame the tier and the promise of the triangle
 * that coloured it last are known.
 *
 * Asserted of a frame:
 *  - plain pixels (tests/reference/reference.h): |code - 255 L| <= promise in each channel; the background's is 1/2.
 *    What is promised excludes what moving the surface by MOVED_PX changes: a pixel beyond the promise of L at its
 *    centre must keep it of the same triangle's L within MOVED_PX of that (counted, printed, at most MOVED_SHARE of
 *    those without a texture);
 *    Where a surface lets light through, its t times the promise of what is behind is added (t times the format's
 *    coarseness too);
 *  - no promise (65535) is made only at the exact tier, for corner normals more than BENT_LEAST apart, told here from
 * the normals themselves; these pixels are counted and printed;
 *  - promise <= tolerance; above it only where the tier is exact, which is all that there is left (counted, printed);
 *  - so no error is above the tolerance, but at pixels counted as above;
 *  - promise <= report.promise_q8, and the report's counts of pixels are those seen.
 * Each frame is drawn in RGB888, and in RGB565, where other loops write the pixels: there what the format rounds more
 * than half a code is added to the promise, and nothing goes into the figures.
 *
 * Asserted over all frames: the median of observed over promised, over plain pixels of triangles below the exact tier,
 * is above LEAST_MEDIAN. A bound that is never nearly met would promise little and choose dear tiers.
 */
#ifndef GLINT_TESTS_IMAGE_TEST_TOLERANCE_H
#define GLINT_TESTS_IMAGE_TEST_TOLERANCE_H

#include "tests/image/frame.h"

#include <math.h>
#include <stdio.h>

#include "tests/reference/reference.h"

#define LEAST_MEDIAN 0.3
#define DOUBLE_ROUNDING 1e-9
#define MOVED_PX (1.0 / 4096)
#define BENT_LEAST 2.89  /* |n_i - n_j|^2, of 116.5 degrees: 117 but for the rounding of normals */
#define MOVED_SHARE 1e-5 /* of plain pixels */

#define MOST_PIXELS (320 * 240)
#define RATIO_STEPS 1000 /* of observed / promised = 0..1 */

/* ------------------------------------------------------------------------------------------------------- the observer
 */

typedef struct observed_pixel {
    double behind;       /* codes: what the promises of what shows through let it be off besides */
    double coarse;       /* how often the format's rounding counts, at most */
    uint16_t promise_q8; /* UINT16_MAX: none */
    bool bent;           /* two corner normals are more than BENT_LEAST apart; where there is no promise */
    bool textured;
    uint8_t tier; /* GLINT_TIERS: none, the background */
} observed_pixel;

static observed_pixel seen[MOST_PIXELS];
static int seen_width;
static uint32_t seen_pixels[GLINT_TIERS];
static uint16_t seen_promise_q8;
static bool seen_bent;
static shade_function seen_run;

static void observe_run(shade_state *shade, int16_t x, int16_t y, uint16_t count)
{
    for (uint16_t i = 0; i < count; i++) {
        observed_pixel *pixel = &seen[y * seen_width + x + i];
        const double through = shade->object->lit.through.t_q15 / 32768.0;
        const double behind = pixel->tier == GLINT_TIERS ? 0.5 : pixel->promise_q8 / 256.0 + pixel->behind;
        pixel->behind = through * behind;
        pixel->coarse = 1 + through * (pixel->tier == GLINT_TIERS ? 1 : pixel->coarse);
        pixel->promise_q8 = seen_promise_q8;
        pixel->bent = seen_bent;
        pixel->tier = shade->tier;
        pixel->textured = shade->texture != NULL;
    }
    seen_pixels[shade->tier] += count;
    seen_run(shade, x, y, count);
}

/* Of the whole triangle where this is a part of a clipped one. */
static bool is_bent(const shade_state *shade)
{
    double normal[3][3], widest = 0;
    for (int i = 0; i < 3; i++) {
        real n[3];
        double square = 0;
        corner_normal(shade->object, shade->vertex, i, n);
        for (int k = 0; k < 3; k++) {
            square += (double)n[k] * (double)n[k];
        }
        for (int k = 0; k < 3; k++) {
            normal[i][k] = (double)n[k] / sqrt(square);
        }
    }
    for (int i = 0; i < 3; i++) {
        double chord = 0;
        for (int k = 0; k < 3; k++) {
            const double way = normal[i][k] - normal[(i + 1) % 3][k];
            chord += way * way;
        }
        widest = fmax(widest, chord);
    }
    return widest > BENT_LEAST;
}

static void observe_triangle(shade_state *shade, uint16_t promise_q8)
{
    seen_bent = promise_q8 == UINT16_MAX && is_bent(shade);
    seen_promise_q8 = promise_q8;
    seen_run = shade->run;
    shade->run = observe_run;
}

static void observe_frame(int width, int height)
{
    assert_true(width * height <= MOST_PIXELS);
    for (int i = 0; i < width * height; i++) {
        seen[i].tier = GLINT_TIERS;
    }
    seen_width = width;
    memset(seen_pixels, 0, sizeof seen_pixels);
}

/* --------------------------------------------------------------------------------------------------------- the
 * settings */

typedef struct setting {
    const char *name;
    uint8_t shading, tolerance; /* tolerance 0: what is promised is not held against one */
} setting;

static const setting settings[] = {
    {"0.75", GLINT_SHADING_EXACT, GLINT_CODES(0.75)},
    {"1", GLINT_SHADING_EXACT, GLINT_CODES(1)},
    {"2", GLINT_SHADING_EXACT, GLINT_CODES(2)},
    {"4", GLINT_SHADING_EXACT, GLINT_CODES(4)},
    {"15.9", GLINT_SHADING_EXACT, GLINT_CODES(15.9)},
    {"q1", GLINT_SHADING_Q1, 0},
    {"q2", GLINT_SHADING_Q2, 0},
    {"exact", GLINT_SHADING_EXACT, 0},
};
enum { SETTINGS = sizeof settings / sizeof *settings };

/* --------------------------------------------------------------------------------------------------------------
 * figures */

/* Of observed / promised, at plain pixels below the exact tier. */
typedef struct ratios {
    uint32_t pixels, count[RATIO_STEPS + 1];
} ratios;

typedef struct figures {
    double greatest[GLINT_TIERS], ratio[GLINT_TIERS]; /* codes; observed / promised */
    double greatest_unpromised;
    uint32_t pixels[GLINT_TIERS]; /* plain ones under a promise */
    uint32_t above;               /* of the exact tier whose promise is above the tolerance */
    uint32_t moved;               /* that keep their promise within MOVED_PX only: without a texture, */
    uint32_t moved_texels;        /* and with one, which changes faster than light does */
    uint32_t unpromised;          /* without a promise, beside the others */
    uint32_t breaches;
    ratios ratios;
} figures;

static figures total[SETTINGS];
static unsigned frames_checked;

static double median(const ratios *r)
{
    uint32_t sum = 0;
    for (int i = 0; i <= RATIO_STEPS; i++) {
        sum += r->count[i];
        if (2 * (uint64_t)sum >= r->pixels) {
            return (double)i / RATIO_STEPS;
        }
    }
    return 0;
}

static void add_figures(figures *to, const figures *from)
{
    for (int tier = 0; tier < GLINT_TIERS; tier++) {
        to->greatest[tier] = fmax(to->greatest[tier], from->greatest[tier]);
        to->ratio[tier] = fmax(to->ratio[tier], from->ratio[tier]);
        to->pixels[tier] += from->pixels[tier];
    }
    to->above += from->above;
    to->moved += from->moved;
    to->moved_texels += from->moved_texels;
    to->unpromised += from->unpromised;
    to->greatest_unpromised = fmax(to->greatest_unpromised, from->greatest_unpromised);
    to->breaches += from->breaches;
    to->ratios.pixels += from->ratios.pixels;
    for (int i = 0; i <= RATIO_STEPS; i++) {
        to->ratios.count[i] += from->ratios.count[i];
    }
}

static double greatest_of(const figures *f)
{
    double greatest = 0;
    for (int tier = 0; tier < GLINT_TIERS; tier++) {
        greatest = fmax(greatest, f->greatest[tier]);
    }
    return greatest;
}

static uint32_t below_exact(const figures *f)
{
    uint32_t sum = 0;
    for (int tier = 0; tier < GLINT_TIER_EXACT; tier++) {
        sum += f->pixels[tier];
    }
    return sum;
}

/* ---------------------------------------------------------------------------------------------------------- one frame
 */

/* A pixel's channels in codes of 1/255, and by how much more than half a code its format rounds. */
typedef struct shown {
    double code[3], coarse[3];
} shown;

static shown shown_at(const frame *f, int i)
{
    shown out = {{0}, {0}};
    if (f->display.format == GLINT_RGB565) {
        static const int shift[3] = {11, 5, 0}, greatest[3] = {31, 63, 31};
        uint16_t word;
        memcpy(&word, f->pixels + 2 * i, sizeof word);
        for (int k = 0; k < 3; k++) {
            out.code[k] = 255.0 * (word >> shift[k] & greatest[k]) / greatest[k];
            out.coarse[k] = (127.5 / greatest[k] - 0.5) * (seen[i].tier == GLINT_TIERS ? 1 : seen[i].coarse);
        }
    } else {
        for (int k = 0; k < 3; k++) {
            out.code[k] = f->pixels[3 * i + k];
        }
    }
    return out;
}

/* Greatest |code - 255 L| of the channels, what the format rounds beyond half a code left out. */
static double error_of(const reference_image *image, const frame *f, int i)
{
    const shown pixel = shown_at(f, i);
    double error = 0;
    for (int k = 0; k < 3; k++) {
        error = fmax(error, fabs(pixel.code[k] - 255 * image->rgb[3 * i + k]) - pixel.coarse[k]);
    }
    return error;
}

/* What a frame's pixels break, and the worst of them. */
enum breach_kind { BREACH_PROMISE, BREACH_TOLERANCE, BREACH_BACKGROUND, BREACH_NO_PROMISE, BREACH_KINDS };

typedef struct breach {
    uint32_t pixels;
    int worst;     /* number of the pixel */
    double excess; /* codes */
} breach;

static void note_breach(breach *b, int pixel, double excess)
{
    if (b->pixels == 0 || excess > b->excess) {
        b->worst = pixel;
        b->excess = excess;
    }
    b->pixels++;
}

/* All that is needed to look at it again. */
static uint32_t show_breaches(const char *scene, int backend, const setting *how, const reference_image *image,
                              const frame *f, const breach breaches[BREACH_KINDS])
{
    static const char *const kinds[BREACH_KINDS] = {"promise broken", "promise above the tolerance", "background",
                                                    "no promise"};
    uint32_t sum = 0;
    for (int kind = 0; kind < BREACH_KINDS; kind++) {
        const breach *b = &breaches[kind];
        const observed_pixel *pixel = &seen[b->worst];
        sum += b->pixels;
        if (b->pixels > 0) {
            print_message(
                "BREACH %s %s %s%s: %s at %u pixels, worst %d,%d by %.4f: tier %d promise %.4f observed %.4f\n", scene,
                frame_backend_name[backend], how->name, f->display.format == GLINT_RGB565 ? " rgb565" : "", kinds[kind],
                b->pixels, b->worst % image->width, b->worst / image->width, b->excess, pixel->tier,
                pixel->promise_q8 / 256.0, error_of(image, f, b->worst));
        }
    }
    return sum;
}

/* The reference of one scene; `near` is drawn when it is first asked for. */
typedef struct references {
    const glint_scene *scene;
    reference_image image, near; /* contested within 1/256 px; within MOVED_PX */
} references;

/* Is the pixel within its promise of a colour that its triangle has within MOVED_PX? */
static bool kept_nearby(references *r, const frame *f, int pixel, double promise)
{
    static const reference_options options = {.edge_px = MOVED_PX};
    const shown at = shown_at(f, pixel);
    reference_candidate list[8];
    char error[200];
    if (r->near.rgb == NULL && reference_render_with(r->scene, r->image.width, r->image.height, GLINT_SHADING_EXACT,
                                                     &options, &r->near, error, sizeof error) != 0) {
        fail_msg("%s", error);
    }
    const int count = reference_candidates(&r->near, pixel % r->image.width, pixel / r->image.width, list, 8);
    for (int i = 0; i < count && i < 8; i++) {
        bool kept = list[i].triangle == r->image.triangle[pixel];
        for (int k = 0; k < 3; k++) {
            const double most = promise + at.coarse[k];
            kept = kept && at.code[k] >= 255 * list[i].low[k] - most && at.code[k] <= 255 * list[i].high[k] + most;
        }
        if (kept) {
            return true;
        }
    }
    return false;
}

static void check_pixels(const char *scene, references *r, const frame *f, int backend, const setting *how,
                         figures *sum)
{
    const reference_image *image = &r->image;
    breach breaches[BREACH_KINDS] = {{.pixels = 0}};
    for (int i = 0; i < image->width * image->height; i++) {
        const observed_pixel *pixel = &seen[i];
        if (image->mask[i] != 0) {
            continue;
        }
        const double error = error_of(image, f, i);
        if (pixel->tier == GLINT_TIERS) {
            if (error > 0.5 + DOUBLE_ROUNDING) {
                note_breach(&breaches[BREACH_BACKGROUND], i, error - 0.5);
            }
            continue;
        }
        const double own = pixel->promise_q8 / 256.0, promise = own + pixel->behind, ratio = error / promise;
        const bool exact = pixel->tier == GLINT_TIER_EXACT;
        if (pixel->promise_q8 == UINT16_MAX) {
            sum->unpromised++;
            sum->greatest_unpromised = fmax(sum->greatest_unpromised, error);
            if (!exact || !pixel->bent) {
                note_breach(&breaches[BREACH_NO_PROMISE], i, error);
            }
            continue;
        }
        sum->pixels[pixel->tier]++;
        if (error > promise && kept_nearby(r, f, i, promise)) {
            sum->moved += !pixel->textured;
            sum->moved_texels += pixel->textured;
            continue;
        }
        sum->greatest[pixel->tier] = fmax(sum->greatest[pixel->tier], error);
        sum->ratio[pixel->tier] = fmax(sum->ratio[pixel->tier], ratio);
        if (error > promise) {
            note_breach(&breaches[BREACH_PROMISE], i, error - promise);
        }
        if (how->tolerance != 0 && own > how->tolerance / 16.0) {
            sum->above += exact;
            if (!exact) {
                note_breach(&breaches[BREACH_TOLERANCE], i, own - how->tolerance / 16.0);
            }
        }
        if (!exact) {
            sum->ratios.count[ratio < 1 ? (int)(ratio * RATIO_STEPS) : RATIO_STEPS]++;
            sum->ratios.pixels++;
        }
    }
    sum->breaches = show_breaches(scene, backend, how, image, f, breaches);
}

/* The report's counts are those of the observer, and no promise is above the one that it gives for the frame. */
static void check_report(const frame *f, const observed_pixel *pixels)
{
    uint32_t shaded = 0;
    for (int tier = 0; tier < GLINT_TIERS; tier++) {
        assert_int_equal(f->report.tier_pixels[tier], seen_pixels[tier]);
        shaded += seen_pixels[tier];
    }
    assert_int_equal(f->report.pixels_shaded, shaded);
    for (int i = 0; i < f->display.width_px * f->display.height_px; i++) {
        if (pixels[i].tier != GLINT_TIERS) {
            assert_in_range(pixels[i].promise_q8, 1, f->report.promise_q8);
        }
    }
}

/* A tolerance is that of each surface; what is seen through one adds to it. */
static bool lets_through(const glint_scene *scene)
{
    for (uint16_t i = 0; i < scene->object_count; i++) {
        if (scene->objects[i].material->transmission_q14 != 0) {
            return true;
        }
    }
    return false;
}

static figures check_frame(const char *name, references *r, uint16_t width, uint16_t height, int backend,
                           const setting *how, uint8_t format)
{
    figures sum = {.breaches = 0};
    frame f = {.display = {.width_px = width, .height_px = height, .format = format},
               .shading = how->shading,
               .tolerance = how->tolerance};
    observe_frame(width, height);
    assert_int_equal(frame_draw(&f, r->scene, backend), 0);
    check_report(&f, seen);
    check_pixels(name, r, &f, backend, how, &sum);
    if (how->tolerance != 0 && sum.above == 0 && !lets_through(r->scene)) {
        assert_true(sum.breaches > 0 || greatest_of(&sum) <= how->tolerance / 16.0);
    }
    frame_free(&f);
    frames_checked++;
    return sum;
}

/* One scene with every setting; adds to `total`. Returns the number of breaches. */
static uint32_t check_scene(const char *name, const glint_scene *scene, uint16_t width, uint16_t height, int backend,
                            bool print)
{
    references reference = {.scene = scene};
    char error[200];
    double greatest[SETTINGS];
    uint32_t breaches = 0, above = 0, plain = 0, cheap = 0;
    figures of_scene = {.breaches = 0};
    if (reference_render(scene, width, height, GLINT_SHADING_EXACT, &reference.image, error, sizeof error) != 0) {
        fail_msg("%s: %s", name, error);
    }
    for (int i = 0; i < SETTINGS; i++) {
        const setting *how = &settings[i];
        const figures sum = check_frame(name, &reference, width, height, backend, how, GLINT_RGB888);
        breaches += check_frame(name, &reference, width, height, backend, how, GLINT_RGB565).breaches;
        add_figures(&total[i], &sum);
        add_figures(&of_scene, &sum);
        breaches += sum.breaches;
        above += sum.above;
        cheap += below_exact(&sum);
        plain += below_exact(&sum) + sum.pixels[GLINT_TIER_EXACT];
        greatest[i] = greatest_of(&sum);
    }
    if (print) {
        print_message("%-26s max", name);
        for (int i = 0; i < SETTINGS; i++) {
            print_message(" %s=%.2f", settings[i].name, greatest[i]);
        }
        print_message("; median=%.2f cheap=%.0f%% above=%u\n", median(&of_scene.ratios),
                      100.0 * cheap / (plain ? plain : 1), above);
    }
    reference_free(&reference.image);
    reference_free(&reference.near);
    return breaches;
}

/* ---------------------------------------------------------------------------------------------------------- all frames
 */

static void print_totals(void)
{
    static const char *const tiers[GLINT_TIERS] = {"unlit", "flat", "gouraud", "curved", "q1", "q2", "exact"};
    for (int i = 0; i < SETTINGS; i++) {
        print_message("%-6s pixels, greatest error, greatest observed/promised:", settings[i].name);
        for (int tier = 0; tier < GLINT_TIERS; tier++) {
            if (total[i].pixels[tier] > 0) {
                print_message(" %s %u %.2f %.2f;", tiers[tier], total[i].pixels[tier], total[i].greatest[tier],
                              total[i].ratio[tier]);
            }
        }
        print_message(" median %.3f above %u moved %u and %u textured unpromised %u %.2f\n", median(&total[i].ratios),
                      total[i].above, total[i].moved, total[i].moved_texels, total[i].unpromised,
                      total[i].greatest_unpromised);
    }
}

/* Over all that was checked before. */
static void check_medians(void)
{
    figures all = {.breaches = 0};
    print_totals();
    for (int i = 0; i < SETTINGS; i++) {
        add_figures(&all, &total[i]);
    }
    print_message("%u frames, median of observed/promised below the exact tier %.3f over %u pixels\n", frames_checked,
                  median(&all.ratios), all.ratios.pixels);
    assert_true(all.ratios.pixels > 100000);
    assert_true(median(&all.ratios) > LEAST_MEDIAN);
    uint32_t plain = 0;
    for (int tier = 0; tier < GLINT_TIERS; tier++) {
        plain += all.pixels[tier];
    }
    assert_true(all.moved <= MOVED_SHARE * plain);
    /* each tier has been put to the test, and each tolerance drew some pixels below the exact tier */
    for (int tier = 0; tier < GLINT_TIERS; tier++) {
        assert_true(tier == GLINT_TIER_GOURAUD || all.pixels[tier] > 1000); /* which no tolerance chooses */
    }
    for (int i = 0; settings[i].tolerance != 0; i++) {
        assert_true(below_exact(&total[i]) > 1000);
    }
}

#endif
