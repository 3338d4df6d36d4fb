/* SPDX-License-Identifier: MIT */
/*
 * Judges a report of the self-test (selftest.h has its form) and prints its row of the table:
 *
 *     check-selftest --head
 *     check-selftest HOST_REPORT REPORT TARGET EMULATOR
 *     check-selftest --foot
 *
 * Fixed backend: each `kernel` and `frame` line equals the host's. Float backend: at pixels that the double-precision
 * reference calls plain, every channel is within MOST_CODES of the host's fixed picture and of the reference; at
 * contested pixels (tests/reference/reference.h) it is one of the surfaces that meet there. Float number routines:
 * within the errors that number/real.h states, against libm in double.
 *
 * Ends with status 0 if all holds, 1 with messages that name each line or picture that does not, 2 if it cannot judge.
 */
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/reference/reference.h"
#include "tests/target/selftest.h"

/* Either backend is within 0.62 code of the reference before it is rounded (README.md), so two codes differ by 1. */
#define MOST_CODES 1
/* number/real.h */
#define INVERSE_ROOT_LOG2 (-23.29)
#define POWER_BOUND 2e-7

enum { LINE_BYTES = 1024, MOST_LINES = 64, WORD_BYTES = 64, MOST_PIXELS = 48 * 32 };

typedef struct picture {
    uint8_t rgb[MOST_PIXELS * 3];
    size_t pixels; /* how many were there */
} picture;

typedef struct cost {
    bool known;
    unsigned long average, worst; /* tenths */
} cost;

enum { COST_UNIT, COST_FIXED, COST_FLOAT, COSTS };
static const char *const cost_name[COSTS] = {"unit-q15", "frame-fixed", "frame-float"};

typedef struct report {
    const char *file;
    char exact[MOST_LINES][LINE_BYTES / 8]; /* kernel and frame lines */
    int exact_count;
    uint64_t kernel_hash, frame_hash; /* over those lines' hashes */
    picture fixed[SELFTEST_PICTURES], real[SELFTEST_PICTURES];
    double root_error, power_error; /* relative; absolute */
    int root_count, power_count;
    cost costs[COSTS];
    char unit[WORD_BYTES];
    unsigned long stack_fixed, stack_float;
    unsigned int_bits, pointer_bits;
    char order[WORD_BYTES];
    bool ended;
    bool without_float_frames, without_textures; /* as the target says */
} report;

static const char *target_name = "check-selftest";
static bool good = true;

static void complain(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "%s: ", target_name);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    good = false;
}

static double float_of(unsigned long bits)
{
    const uint32_t word = (uint32_t)bits;
    float value;
    memcpy(&value, &word, sizeof value);
    return (double)value;
}

static bool is_textured(const char *line)
{
    return strncmp(line, "frame floor-", 12) == 0;
}

static void read_exact(report *r, const char *line)
{
    unsigned long long hash;
    char kind[WORD_BYTES], name[WORD_BYTES];
    if (r->exact_count == MOST_LINES || strlen(line) >= sizeof r->exact[0] ||
        sscanf(line, "%63s %63s %16llx", kind, name, &hash) != 3) {
        complain("%s: not a line of a hash: %s", r->file, line);
        return;
    }
    strcpy(r->exact[r->exact_count++], line);
    uint64_t *total = strcmp(kind, "kernel") == 0 ? &r->kernel_hash : &r->frame_hash;
    for (int i = 0; i < 8 && !is_textured(line); i++) { /* which not all targets have */
        *total = (*total ^ ((hash >> (8 * i)) & 0xff)) * UINT64_C(0x100000001b3);
    }
}

static void read_pixels(report *r, const char *line)
{
    char name[WORD_BYTES], backend[WORD_BYTES];
    unsigned row, column;
    int start, i = 0;
    if (sscanf(line, "pixels %63s %63s %u %u %n", name, backend, &row, &column, &start) != 4) {
        complain("%s: not a row of pixels: %s", r->file, line);
        return;
    }
    while (i < SELFTEST_PICTURES && strcmp(selftest_pictures[i].name, name) != 0) {
        i++;
    }
    const char *digits = line + start;
    const size_t bytes = strlen(digits) / 2;
    if (i == SELFTEST_PICTURES || row >= selftest_pictures[i].height_px || bytes == 0 || bytes % 3 != 0 ||
        column + bytes / 3 > selftest_pictures[i].width_px) {
        complain("%s: no picture has these pixels: %s", r->file, line);
        return;
    }
    picture *to = strcmp(backend, "fixed") == 0 ? &r->fixed[i] : &r->real[i];
    uint8_t *rgb = to->rgb + 3 * ((size_t)row * selftest_pictures[i].width_px + column);
    for (size_t k = 0; k < bytes; k++) {
        unsigned code;
        if (sscanf(digits + 2 * k, "%2x", &code) != 1) {
            complain("%s: not hexadecimal: %s", r->file, line);
            return;
        }
        rgb[k] = (uint8_t)code;
    }
    to->pixels += bytes / 3;
}

/* Anything but a number counts as the greatest error. */
static double greater(double a, double b)
{
    return b <= a ? a : b == b ? b : HUGE_VAL;
}

static void read_real(report *r, const char *line)
{
    unsigned long a, b, c;
    if (sscanf(line, "real inverse-root %lx %lx", &a, &b) == 2) {
        r->root_error = greater(r->root_error, fabs(float_of(b) * sqrt(float_of(a)) - 1));
        r->root_count++;
    } else if (sscanf(line, "real power %lx %lx %lx", &a, &b, &c) == 3) {
        r->power_error = greater(r->power_error, fabs(float_of(c) - pow(1 - float_of(a), float_of(b))));
        r->power_count++;
    } else {
        complain("%s: not a float result: %s", r->file, line);
    }
}

static void read_count(report *r, const char *line)
{
    char name[WORD_BYTES];
    unsigned long average, worst;
    if (sscanf(line, "count %63s %lu %lu %63s", name, &average, &worst, r->unit) != 4) {
        complain("%s: not a count: %s", r->file, line);
        return;
    }
    for (int i = 0; i < COSTS; i++) {
        if (strcmp(name, cost_name[i]) == 0) {
            const cost is = {true, average, worst};
            r->costs[i] = is;
        }
    }
}

static void read_line(report *r, const char *line)
{
    if (strncmp(line, "kernel ", 7) == 0 || strncmp(line, "frame ", 6) == 0) {
        read_exact(r, line);
    } else if (strncmp(line, "pixels ", 7) == 0) {
        read_pixels(r, line);
    } else if (strncmp(line, "real ", 5) == 0) {
        read_real(r, line);
    } else if (strncmp(line, "count ", 6) == 0) {
        read_count(r, line);
    } else if (strncmp(line, "failed ", 7) == 0) {
        complain("%s", line);
    } else if (strcmp(line, "float-frames none") == 0) {
        r->without_float_frames = true;
    } else if (strcmp(line, "textured-frames none") == 0) {
        r->without_textures = true;
    } else if (strcmp(line, "end") == 0) {
        r->ended = true;
    } else {
        /* the rest is told, not judged; other lines are the emulator's own */
        (void)sscanf(line, "target %u %u %63s", &r->int_bits, &r->pointer_bits, r->order);
        (void)sscanf(line, "stack fixed %lu", &r->stack_fixed);
        (void)sscanf(line, "stack float %lu", &r->stack_float);
    }
}

static report *read_report(const char *file)
{
    char line[LINE_BYTES];
    report *r = calloc(1, sizeof *r);
    FILE *in = fopen(file, "r");
    if (!r || !in) {
        fprintf(stderr, "cannot read %s: run the self-test first (make targets)\n", file);
        exit(2);
    }
    r->file = file;
    r->kernel_hash = r->frame_hash = HASH_START;
    while (fgets(line, sizeof line, in)) {
        line[strcspn(line, "\n")] = '\0';
        read_line(r, line);
    }
    fclose(in);
    if (!r->ended) {
        complain("%s does not come to its end", file);
    }
    return r;
}

/* The lines of hashes, in their order. */
static bool equal_bits(const report *host, const report *r)
{
    bool equal = true;
    int count = 0;
    for (int i = 0; i < host->exact_count; i++) {
        if (r->without_textures && is_textured(host->exact[i])) {
            continue;
        }
        if (count < r->exact_count && strcmp(host->exact[i], r->exact[count]) != 0) {
            complain("differs:  %s\n    host has  %s", r->exact[count], host->exact[i]);
            equal = false;
        }
        count++;
    }
    if (count != r->exact_count || count == 0) {
        complain("%d lines of hashes; the host has %d", r->exact_count, count);
        equal = false;
    }
    return equal;
}

typedef struct float_verdict {
    int greatest; /* codes, plain pixels */
    unsigned plain, differing, contested, contested_differing;
} float_verdict;

static int difference(const uint8_t a[3], const uint8_t b[3])
{
    int greatest = 0;
    for (int k = 0; k < 3; k++) {
        const int d = abs(a[k] - b[k]);
        greatest = d > greatest ? d : greatest;
    }
    return greatest;
}

static void judge_picture(int i, const report *host, const report *r, float_verdict *sum)
{
    const selftest_picture *p = &selftest_pictures[i];
    reference_image image;
    reference_verdict verdict;
    char error[200];
    const size_t pixels = (size_t)p->width_px * p->height_px;
    if (host->fixed[i].pixels != pixels || r->real[i].pixels != pixels) {
        complain("%s: %lu pixels in float and %lu of the host's in fixed, not %lu", p->name,
                 (unsigned long)r->real[i].pixels, (unsigned long)host->fixed[i].pixels, (unsigned long)pixels);
        return;
    }
    if (reference_render(p->scene, p->width_px, p->height_px, p->shading, &image, error, sizeof error) != 0) {
        complain("%s: the reference cannot draw it: %s", p->name, error);
        return;
    }
    int greatest = 0;
    for (size_t k = 0; k < pixels; k++) {
        const int d = difference(&host->fixed[i].rgb[3 * k], &r->real[i].rgb[3 * k]);
        if (image.mask[k]) {
            sum->contested++;
            sum->contested_differing += d != 0;
            continue;
        }
        sum->plain++;
        sum->differing += d != 0;
        greatest = d > greatest ? d : greatest;
    }
    if (greatest > MOST_CODES) {
        complain("%s: float is %d codes from the host's fixed picture at a plain pixel, at most %d may be", p->name,
                 greatest, MOST_CODES);
    }
    sum->greatest = greatest > sum->greatest ? greatest : sum->greatest;
    reference_check(&image, r->real[i].rgb, MOST_CODES, &verdict);
    if (verdict.above_unexplained || verdict.unmatched) {
        complain("%s: float is off the reference at %lu plain and %lu contested pixels", p->name,
                 (unsigned long)verdict.above_unexplained, (unsigned long)verdict.unmatched);
    }
    reference_free(&image);
}

static void judge_real(const report *host, const report *r)
{
    if (r->root_count == 0 || r->power_count == 0 || r->root_count != host->root_count ||
        r->power_count != host->power_count) {
        complain("%d and %d float results; the host has %d and %d", r->root_count, r->power_count, host->root_count,
                 host->power_count);
    }
    if (r->root_error > exp2(INVERSE_ROOT_LOG2)) {
        complain("glint_inverse_root: relative error 2^%.2f, at most 2^%.2f is stated", log2(r->root_error),
                 INVERSE_ROOT_LOG2);
    }
    if (r->power_error > POWER_BOUND) {
        complain("glint_power: error %.2g, at most %.2g is stated", r->power_error, POWER_BOUND);
    }
}

static const char *in_thousands(const cost *c, char text[WORD_BYTES])
{
    snprintf(text, WORD_BYTES, "%lu k", c->average / 10000);
    return c->known ? text : "-";
}

#define ROW "%-9s %-25s %3s %-6s  %-16s %-16s  %-5s  %5s %-11s %6s %8s  %13s %8s %9s %-6s %11s\n"

static void head(void)
{
    printf(ROW, "", "", "", "", "fixed backend", "", "same", "float", "pixels", "1/root", "", "unit-q15", "frame",
           "frame", "", "stack bytes");
    printf(ROW, "target", "emulator", "int", "endian", "number kernel", "frames", "bits?", "codes", "differing",
           "error", "power", "mean / worst", "fixed", "float", "count", "fixed/float");
}

static void foot(void)
{
    printf("float: greatest difference from the host's fixed pictures over %d pictures, plain pixels; differing pixels "
           "of these + of contested ones.\n"
           "1/root, power: greatest relative and absolute error of the float routines (stated: 2^%.2f, %.0g).\n"
           "unit-q15: a call of glint_unit_q15; frame: sphere-10x6, 48 x 32 RGB565, exact shading, bands of 8. Counted "
           "in instructions, on the AVR in cycles.\n",
           SELFTEST_PICTURES, INVERSE_ROOT_LOG2, POWER_BOUND);
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "--head") == 0) {
        head();
        return 0;
    }
    if (argc == 2 && strcmp(argv[1], "--foot") == 0) {
        foot();
        return 0;
    }
    if (argc != 5) {
        fprintf(stderr, "usage: check-selftest --head | --foot | HOST_REPORT REPORT TARGET EMULATOR\n");
        return 2;
    }
    target_name = argv[3];
    report *host = read_report(argv[1]), *r = read_report(argv[2]);
    float_verdict floats = {0, 0, 0, 0, 0};
    const bool equal = equal_bits(host, r);
    for (int i = 0; i < SELFTEST_PICTURES && !r->without_float_frames; i++) {
        judge_picture(i, host, r, &floats);
    }
    judge_real(host, r);

    char bits[WORD_BYTES], kernel[WORD_BYTES], frames[WORD_BYTES], codes[WORD_BYTES], pixels[WORD_BYTES];
    char root[WORD_BYTES], power[WORD_BYTES], unit[WORD_BYTES] = "-", fixed[WORD_BYTES], real[WORD_BYTES];
    char stack[WORD_BYTES] = "-";
    snprintf(bits, sizeof bits, "%u", r->int_bits);
    snprintf(kernel, sizeof kernel, "%016llx", (unsigned long long)r->kernel_hash);
    snprintf(frames, sizeof frames, "%016llx", (unsigned long long)r->frame_hash);
    if (r->without_float_frames) {
        snprintf(codes, sizeof codes, "-");
    } else {
        snprintf(codes, sizeof codes, "%d", floats.greatest);
    }
    snprintf(pixels, sizeof pixels, "%u + %u", floats.differing, floats.contested_differing);
    snprintf(root, sizeof root, "2^%.1f", log2(r->root_error));
    snprintf(power, sizeof power, "%.2g", r->power_error);
    if (r->costs[COST_UNIT].known) {
        snprintf(unit, sizeof unit, "%.1f / %.1f", (double)r->costs[COST_UNIT].average / 10,
                 (double)r->costs[COST_UNIT].worst / 10);
    }
    if (r->stack_fixed) {
        snprintf(stack, sizeof stack, "%lu/%lu", r->stack_fixed, r->stack_float);
    }
    printf(ROW, argv[3], argv[4], bits, r->order, kernel, frames, equal ? "yes" : "NO", codes, pixels, root, power,
           unit, in_thousands(&r->costs[COST_FIXED], fixed), in_thousands(&r->costs[COST_FLOAT], real),
           !r->unit[0]                      ? "-"
           : strcmp(r->unit, "cycles") == 0 ? "cycles"
                                            : "instr.",
           stack);
    fflush(stdout);
    free(host);
    free(r);
    return good ? 0 : 1;
}
