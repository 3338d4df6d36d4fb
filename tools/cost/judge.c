/* SPDX-License-Identifier: MIT */
/*
 * Writes cost.csv from the reports of the targets (cost.c has their form):
 *
 *     cost-judge DETAILS TARGET REPORT ...  >cost.csv
 *
 * Columns:
 *     target      the processor; what ends in -cycles is counted in cycles, the rest in instructions
 *     unit        of `frame` and `per_pixel`
 *     scene, backend, shading, tolerance   as in cases.c; tolerance in codes, empty where the shading is forced
 *     frame       one call of glint_*_render(), clears included, flush empty
 *     per_pixel   that for each pixel of the display that the scene covers, overdrawn or not
 *     max_error   codes of 1/255: the greatest |code - 255 L| of plain pixels of the RGB888 picture, its rounding (0.5)
 *                 included; L: the model at each pixel in double precision (exact shading, whatever is counted)
 *     psnr_db     of the same pixels against round(255 L)
 *     promised    the error in codes that the library's report promised; empty where it promises none
 *
 * The file DETAILS has a row for each of these, to which its first columns belong (target, scene, backend, shading,
 * tolerance), and
 *     triangles   drawn: that face the eye and are on the display
 *     useful, given   bytes of memory that the frame can make use of, and that it got; empty where it got all
 *     covered     pixels of the display that the scene covers
 *
 * Errors are of frames drawn here, on the host. The fixed backend draws the same bits everywhere: the hash of each of
 * its frames, drawn on the target in RGB565, is compared with the host's. For float they are the host's alone.
 *
 * "cost-judge errors" prints the columns scene to tolerance and max_error to promised of all cases, counted or not.
 *
 * A row is written for a frame that was counted, and for no other. Ends with status 1, naming what is wrong: a frame
 * that failed or has another hash, a second frame that costs other than the first, a counter that is not calibrated, a
 * picture that errs by more than was promised. What a frame should cost is for goals.awk to tell.
 */
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <examples/scenes/scenes.h>
#include <glint/error.h>

#include "tests/reference/reference.h"
#include "tests/target/selftest.h"
#include "tools/cost/cases.h"

/* The sphere of scene A, as the renderers of peers.csv drew it. */
enum { YARDSTICK_LEAST = 43920, YARDSTICK_MOST = 45000 };

enum { WORD_BYTES = 64, LINE_BYTES = 512 };

/* What is known of a case's picture on the host. */
typedef struct measured {
    double max_codes, psnr_db;
    uint64_t hash; /* fixed backend, RGB565 */
    uint32_t covered, triangles;
    double promised; /* codes; negative: no promise */
} measured;

typedef struct report {
    const char *target;
    unsigned long step; /* instructions or cycles that a step of the counter stands for; 0: not calibrated */
    char unit[WORD_BYTES];
    char useful[WORD_BYTES], given[WORD_BYTES]; /* of the frame whose cost comes next; empty: it got all */
    bool ended;
} report;

static bool good = true;
static FILE *details;

static void complain(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("cost-judge: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    good = false;
}

static void *allocate(size_t bytes)
{
    void *memory = calloc(bytes, 1);
    if (!memory) {
        fprintf(stderr, "cost-judge: out of memory\n");
        exit(2);
    }
    return memory;
}

/* ---------------------------------------------------------------------------------------------- pictures on the host
 */

static int take_rgb888(void *context, const glint_band *band)
{
    memcpy((uint8_t *)context + (size_t)band->y_px * band->stride_bytes, band->pixels, band->bytes);
    return 0;
}

static void draw(const cost_case *c, int backend, uint8_t format, glint_flush flush, void *context,
                 glint_report *counts)
{
    const size_t bytes = cost_frame_bytes(c, backend, format);
    void *memory = allocate(bytes);
    const int error = cost_draw(c, backend, format, flush, context, memory, bytes, counts);
    if (error) {
        complain("%s %s %s %s: the host cannot draw it: error %d", c->scene, cost_backend_names[backend], c->shading,
                 c->tolerance, error);
    }
    free(memory);
}

static bool same_view(const cost_case *a, const cost_case *b)
{
    return a->data == b->data && a->lights == b->lights && a->width_px == b->width_px && a->height_px == b->height_px;
}

/* The true picture of the case's scene; kept from one call to the next while the scene is the same. */
static const reference_image *reference_of(const cost_case *c)
{
    static const cost_case *last;
    static reference_image image;
    char error[200];
    if (last && same_view(c, last)) {
        return &image;
    }
    const glint_scene scene = cost_scene(c);
    reference_free(&image);
    if (reference_render(&scene, c->width_px, c->height_px, GLINT_SHADING_EXACT, &image, error, sizeof error) != 0) {
        fprintf(stderr, "cost-judge: %s: %s\n", c->scene, error);
        exit(2);
    }
    last = c;
    return &image;
}

static measured measure(const cost_case *c, int backend)
{
    const reference_image *image = reference_of(c);
    const size_t pixels = (size_t)c->width_px * c->height_px;
    uint8_t *rgb = allocate(pixels * 3);
    reference_verdict verdict;
    glint_report r = {.promise_q8 = UINT16_MAX};
    measured m = {.hash = HASH_START};
    draw(c, backend, GLINT_RGB888, take_rgb888, rgb, &r);
    reference_check(image, rgb, 1, &verdict);
    free(rgb);
    m.max_codes = verdict.max_codes;
    m.psnr_db = verdict.psnr_db;
    m.triangles = r.triangles_drawn;
    m.promised = r.promise_q8 == UINT16_MAX ? -1 : r.promise_q8 / 256.0;
    if (m.promised >= 0 && m.max_codes > m.promised) {
        complain("%s %s %s %s: the picture errs by %.3f codes, promised were %.3f", c->scene,
                 cost_backend_names[backend], c->shading, c->tolerance, m.max_codes, m.promised);
    }
    for (size_t i = 0; i < pixels; i++) {
        m.covered += image->triangle[i] >= 0;
    }
    if (c->data == &demo_sphere_32x16 && c->width_px == 240 &&
        (m.covered < YARDSTICK_LEAST || m.covered > YARDSTICK_MOST)) {
        complain("%s covers %lu pixels: it is not the yardstick that others were measured with", c->scene,
                 (unsigned long)m.covered);
    }
    if (backend == COST_FIXED) {
        draw(c, backend, GLINT_RGB565, cost_hash_band, &m.hash, NULL);
    }
    return m;
}

/* Measured when first asked for. */
static const measured *measured_of(const cost_case *c, int backend)
{
    static measured *all;
    static bool *known;
    if (!all) {
        all = allocate(sizeof *all * cost_case_count * COST_BACKENDS);
        known = allocate(sizeof *known * cost_case_count * COST_BACKENDS);
    }
    const size_t at = (size_t)(c - cost_cases) * COST_BACKENDS + (size_t)backend;
    if (!known[at]) {
        all[at] = measure(c, backend);
        known[at] = true;
    }
    return &all[at];
}

/* As in a row; empty where the shading is forced. */
static const char *codes_of(const cost_case *c)
{
    return strcmp(c->tolerance, "-") == 0 ? "" : c->tolerance;
}

/* The last columns of a row. */
static void print_errors(const measured *m)
{
    printf("%.2f,%.1f,", m->max_codes, m->psnr_db);
    if (m->promised >= 0) {
        printf("%.2f", m->promised);
    }
    putchar('\n');
}

static void tell_errors(void)
{
    puts("scene,backend,shading,tolerance,max_error,psnr_db,promised");
    for (uint16_t i = 0; i < cost_case_count; i++) {
        const cost_case *c = &cost_cases[i];
        for (int backend = 0; backend < COST_BACKENDS; backend++) {
            printf("%s,%s,%s,%s,", c->scene, cost_backend_names[backend], c->shading, codes_of(c));
            print_errors(measured_of(c, backend));
        }
    }
}

/* --------------------------------------------------------------------------------------------------------- reports */

static const cost_case *case_named(const char *scene, const char *shading, const char *tolerance)
{
    for (uint16_t i = 0; i < cost_case_count; i++) {
        const cost_case *c = &cost_cases[i];
        if (strcmp(c->scene, scene) == 0 && strcmp(c->shading, shading) == 0 && strcmp(c->tolerance, tolerance) == 0) {
            return c;
        }
    }
    return NULL;
}

/* A step of the counter is a whole number of instructions or cycles; what the calibration is off by is the call of the
 * loop and, on the AVR, the counter's interrupt. */
static void read_calibration(report *r, char **words)
{
    const unsigned long known = strtoul(words[1], NULL, 10), steps = strtoul(words[2], NULL, 10);
    const double ratio = steps ? (double)known / (double)steps : 0;
    r->step = (unsigned long)(ratio + 0.5);
    if (r->step == 0 || fabs(ratio / (double)r->step - 1) > 0.002) {
        complain("%s: a loop of %lu took %lu steps of the counter, which makes no whole number of each", r->target,
                 known, steps);
        r->step = 0;
    }
}

/* Steps by which two frames alike may differ: one of a counter that counts several instructions; on the AVR an
 * interrupt of its counter more or less. */
static unsigned long apart_at_most(const report *r)
{
    return r->step > 1 ? 1 : strncmp(r->target, "avr", 3) == 0 ? 50 : 0;
}

/* cost SCENE BACKEND SHADING TOLERANCE FIRST SECOND HASH */
static void read_cost(const report *r, char **words)
{
    const char *scene = words[1], *backend_name = words[2], *shading = words[3], *tolerance = words[4];
    const unsigned long first = strtoul(words[5], NULL, 10), second = strtoul(words[6], NULL, 10);
    const unsigned long long hash = strtoull(words[7], NULL, 16);
    const cost_case *c = case_named(scene, shading, tolerance);
    if (!c || r->step == 0) {
        complain("%s: %s %s %s: %s", r->target, scene, shading, tolerance, c ? "not calibrated" : "no such case");
        return;
    }
    const int backend = strcmp(backend_name, cost_backend_names[COST_FIXED]) == 0 ? COST_FIXED : COST_FLOAT;
    const measured *m = measured_of(c, backend);
    if (backend == COST_FIXED && m->hash != hash) {
        complain("%s: %s %s %s: another picture than the host's: hash %016llx, not %016llx", r->target, scene, shading,
                 tolerance, hash, (unsigned long long)m->hash);
        return;
    }
    const unsigned long apart = first > second ? first - second : second - first;
    if (apart > apart_at_most(r)) {
        complain("%s: %s %s %s: the first frame took %lu steps, the second %lu", r->target, scene, backend_name,
                 shading, first, second);
        return;
    }
    const double frame = (double)second * (double)r->step;
    const char *codes = codes_of(c);
    printf("%s,%s,%s,%s,%s,%s,%.0f,%.1f,", r->target, r->unit, scene, backend_name, shading, codes, frame,
           frame / m->covered);
    print_errors(m);
    fprintf(details, "%s,%s,%s,%s,%s,%lu,%s,%s,%lu\n", r->target, scene, backend_name, shading, codes,
            (unsigned long)m->triangles, r->useful, r->given, (unsigned long)m->covered);
}

static void read_line(report *r, char *line)
{
    enum { MOST_WORDS = 10 };
    char *words[MOST_WORDS] = {NULL};
    int count = 0;
    if (strncmp(line, "left ", 5) == 0) {
        fprintf(stderr, "%s: left out for want of memory: %s bytes at least\n", r->target, line + 5);
        return;
    }
    for (char *word = strtok(line, " "); word && count < MOST_WORDS; word = strtok(NULL, " ")) {
        words[count++] = word;
    }
    if (count == 3 && strcmp(words[0], "calibration") == 0) {
        read_calibration(r, words);
    } else if (count == 2 && strcmp(words[0], "unit") == 0) {
        snprintf(r->unit, sizeof r->unit, "%s", words[1]);
    } else if (count == 7 && strcmp(words[0], "short") == 0) {
        snprintf(r->useful, sizeof r->useful, "%s", words[5]);
        snprintf(r->given, sizeof r->given, "%s", words[6]);
    } else if (count == 6 && strcmp(words[0], "failed") == 0) {
        complain("%s: %s %s %s %s: %s", r->target, words[1], words[2], words[3], words[4],
                 glint_error_text(-(int)strtol(words[5], NULL, 10)));
    } else if (count == 8 && strcmp(words[0], "cost") == 0) {
        read_cost(r, words);
        r->useful[0] = r->given[0] = '\0';
    } else if (count == 1 && strcmp(words[0], "end") == 0) {
        r->ended = true;
    } else if (count > 0 && strcmp(words[0], "cost") == 0) {
        complain("%s: not a line of a frame: %d words", r->target, count);
    }
}

static void read_report(const char *target, const char *file)
{
    char line[LINE_BYTES];
    report r = {.target = target};
    FILE *in = fopen(file, "r");
    if (!in) {
        complain("%s: cannot read %s", target, file);
        return;
    }
    while (fgets(line, sizeof line, in)) {
        line[strcspn(line, "\n")] = '\0';
        read_line(&r, line);
    }
    fclose(in);
    if (!r.ended) {
        complain("%s: %s does not come to its end", target, file);
    }
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "errors") == 0) {
        tell_errors();
        return good && fflush(stdout) == 0 ? 0 : 1;
    }
    if (argc < 4 || argc % 2 == 1) {
        fprintf(stderr, "usage: cost-judge DETAILS TARGET REPORT ...  >cost.csv\n       cost-judge errors\n");
        return 2;
    }
    details = fopen(argv[1], "w");
    if (!details) {
        fprintf(stderr, "cost-judge: cannot write %s\n", argv[1]);
        return 2;
    }
    puts("target,unit,scene,backend,shading,tolerance,frame,per_pixel,max_error,psnr_db,promised");
    fputs("target,scene,backend,shading,tolerance,triangles,useful,given,covered\n", details);
    for (int i = 2; i < argc; i += 2) {
        read_report(argv[i], argv[i + 1]);
    }
    if (fclose(details) != 0 || fflush(stdout) != 0) {
        complain("cannot write to the end");
    }
    return good ? 0 : 1;
}
