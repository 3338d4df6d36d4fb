/* SPDX-License-Identifier: MIT */
/*
 * Writes the rows of routines.csv, without their heading, from the targets' reports (routines.c has their form) and,
 * for the target "host", from times taken here:
 *
 *     judge-routines TARGET REPORT ... host -
 *
 * Columns:
 *     target, unit       as in frames.csv; of the host nanoseconds, the least of some runs, call included
 *     routine, variant, origin, table_bytes   as in routines.h
 *     average, worst     of a call, from entry to return, over the inputs
 *     error_ulp          the greatest error in 2^-15, the last place of a Q15 number (1/128 code): of the reciprocal
 * root relative, of the others absolute, of a vector that of its worst component error_inputs       the number of
 * inputs that it was looked for in: many, here, where the target's results are the host's to the bit; else those that
 * the target printed
 *
 * A fixed-point variant whose results are not the host's is an error: status 1.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "tests/target/selftest.h"
#include "tools/atlas/routines.h"

enum { MANY_INPUTS = 1 << 18, TIMED_INPUTS = 1 << 12, TIMED_RUNS = 15, LINE_BYTES = 256, WORD_BYTES = 64 };

static int failed;

/* In 2^-15. */
static double error_of(const routine_variant *variant, const routine_input *in, const routine_result *out)
{
    const double one = ldexp(1.0, variant->fraction_bits);
    const int real = variant->fraction_bits < 0;
    double value[3] = {0}, truth[3] = {0}, worst = 0;
    for (int k = 0; k < routine_width(variant); k++) {
        value[k] = real ? (double)out->real[k] : out->fixed[k] / one;
    }
    switch (variant->routine) {
    case ROUTINE_ROOT: {
        const double x = real ? (double)in->x : ldexp(in->x_q30, -30);
        return fabs(value[0] * sqrt(x) - 1) * 32768;
    }
    case ROUTINE_UNIT: {
        double length = 0;
        for (int k = 0; k < 3; k++) {
            truth[k] = real ? (double)in->v_real[k] : in->v[k];
            length += truth[k] * truth[k];
        }
        for (int k = 0; k < 3; k++) {
            truth[k] /= sqrt(length);
        }
        break;
    }
    case ROUTINE_POWER:
        truth[0] = pow(1 - (real ? (double)in->gap : ldexp(in->gap_q31, -31)), ROUTINE_EXPONENT);
        break;
    default:
        truth[0] = strcmp(variant->origin, "libm") == 0 ? sin((double)in->angle_radians)
                                                        : sin(in->angle_turn16 * (acos(-1) / 32768));
        break;
    }
    for (int k = 0; k < routine_width(variant); k++) {
        worst = fmax(worst, fabs(value[k] - truth[k]) * 32768);
    }
    return worst;
}

/* Of many inputs, here; *hash is of the first `inputs` of them. */
static double error_here(const routine_variant *variant, unsigned long inputs, uint64_t *hash)
{
    uint32_t state = ROUTINE_SEED;
    double worst = 0;
    *hash = HASH_START;
    for (unsigned long i = 0; i < MANY_INPUTS; i++) {
        const routine_input in = routine_next(&state);
        routine_result out = {{0, 0, 0}};
        (void)variant->function(&in, &out);
        worst = fmax(worst, error_of(variant, &in, &out));
        for (int k = 0; k < routine_width(variant) && i < inputs; k++) {
            uint32_t bits;
            memcpy(&bits, variant->fraction_bits < 0 ? (void *)&out.real[k] : (void *)&out.fixed[k], sizeof bits);
            *hash = hash_bytes(*hash, bits, 4);
        }
    }
    return worst;
}

static void print_row(const char *target, const char *unit, const routine_variant *variant, double average,
                      double worst, double error, unsigned long inputs)
{
    printf("%s,%s,%s,%s,%s,%u,%.1f,", target, unit, routine_names[variant->routine], variant->name, variant->origin,
           variant->table_bytes, average);
    if (worst >= 0) {
        printf("%.1f", worst);
    }
    printf(",%.4g,%lu\n", error, inputs);
}

/* --------------------------------------------------------------------------------------------------------- the host */

/* Nanoseconds of a call, the least of some runs. What calls and loop take is not taken off: this processor does them
 * beside the routine. */
static double timed(routine_function function, const routine_input *inputs)
{
    static routine_function volatile called;
    double least = 1e30;
    called = function;
    for (int run = 0; run < TIMED_RUNS; run++) {
        struct timespec from, to;
        routine_result out;
        clock_gettime(CLOCK_MONOTONIC, &from);
        for (int i = 0; i < TIMED_INPUTS; i++) {
            (void)called(&inputs[i], &out);
        }
        clock_gettime(CLOCK_MONOTONIC, &to);
        least = fmin(least, (double)(to.tv_sec - from.tv_sec) * 1e9 + (double)(to.tv_nsec - from.tv_nsec));
    }
    return least / TIMED_INPUTS;
}

static void tell_host(void)
{
    static routine_input inputs[TIMED_INPUTS];
    uint32_t state = ROUTINE_SEED;
    for (int i = 0; i < TIMED_INPUTS; i++) {
        inputs[i] = routine_next(&state);
    }
    for (uint8_t i = 0; i < routine_variant_count; i++) {
        uint64_t hash;
        const double error = error_here(&routine_variants[i], 0, &hash);
        print_row("host", "ns", &routine_variants[i], timed(routine_variants[i].function, inputs), -1, error,
                  MANY_INPUTS);
    }
}

/* ---------------------------------------------------------------------------------------------------------- reports */

typedef struct report {
    const char *target;
    char unit[WORD_BYTES];
    double step; /* instructions or cycles of a step of the counter */
    unsigned long repeat, inputs, empty;
    uint32_t state;       /* of the inputs of the variant whose results are read */
    double printed_error; /* the worst of them */
    bool ended;
} report;

static const routine_variant *variant_named(const char *routine, const char *name)
{
    for (uint8_t i = 0; i < routine_variant_count; i++) {
        const routine_variant *variant = &routine_variants[i];
        if (strcmp(routine_names[variant->routine], routine) == 0 && strcmp(variant->name, name) == 0) {
            return variant;
        }
    }
    return NULL;
}

static void read_result(report *r, char **words, int count)
{
    const routine_variant *variant = variant_named(words[1], words[2]);
    const routine_input in = routine_next(&r->state);
    routine_result out = {{0, 0, 0}};
    for (int k = 0; variant && k < routine_width(variant) && 3 + k < count; k++) {
        const uint32_t bits = (uint32_t)strtoul(words[3 + k], NULL, 16);
        memcpy(&out.real[k], &bits, sizeof bits);
    }
    if (variant) {
        r->printed_error = fmax(r->printed_error, error_of(variant, &in, &out));
    }
}

static void read_routine(report *r, char **words)
{
    const routine_variant *variant = variant_named(words[1], words[2]);
    const double calls = (double)r->repeat * (double)r->inputs;
    uint64_t hash;
    if (!variant || r->step <= 0 || calls <= 0) {
        fprintf(stderr, "judge-routines: %s: %s %s: %s\n", r->target, words[1], words[2],
                variant ? "not calibrated" : "no such variant");
        failed = 1;
        return;
    }
    double error = error_here(variant, r->inputs, &hash);
    unsigned long inputs = MANY_INPUTS;
    if (hash != strtoull(words[5], NULL, 16)) {
        if (variant->fraction_bits >= 0) {
            fprintf(stderr, "judge-routines: %s: %s %s: other results than the host's\n", r->target, words[1],
                    words[2]);
            failed = 1;
            return;
        }
        error = r->printed_error;
        inputs = r->inputs;
    }
    print_row(r->target, r->unit, variant, strtod(words[3], NULL) * r->step / calls + (double)r->empty,
              strtod(words[4], NULL) * r->step / (double)r->repeat + (double)r->empty, error, inputs);
    r->printed_error = 0;
    r->state = ROUTINE_SEED;
}

static void read_line(report *r, char *line)
{
    enum { MOST_WORDS = 8 };
    char *words[MOST_WORDS] = {NULL};
    int count = 0;
    for (char *word = strtok(line, " \r\n"); word && count < MOST_WORDS; word = strtok(NULL, " \r\n")) {
        words[count++] = word;
    }
    if (count == 3 && strcmp(words[0], "calibration") == 0) {
        r->step = floor(strtod(words[1], NULL) / strtod(words[2], NULL) + 0.5);
    } else if (count == 2 && strcmp(words[0], "unit") == 0) {
        snprintf(r->unit, sizeof r->unit, "%s", words[1]);
    } else if (count == 4 && strcmp(words[0], "calls") == 0) {
        r->repeat = strtoul(words[1], NULL, 10);
        r->inputs = strtoul(words[2], NULL, 10);
        r->empty = strtoul(words[3], NULL, 10);
    } else if (count >= 4 && strcmp(words[0], "result") == 0) {
        read_result(r, words, count);
    } else if (count == 6 && strcmp(words[0], "routine") == 0) {
        read_routine(r, words);
    } else if (count == 1 && strcmp(words[0], "end") == 0) {
        r->ended = true;
    }
}

static void read_report(const char *target, const char *file)
{
    char line[LINE_BYTES];
    report r = {.target = target, .state = ROUTINE_SEED};
    FILE *in = fopen(file, "r");
    while (in && fgets(line, sizeof line, in)) {
        read_line(&r, line);
    }
    if (in) {
        fclose(in);
    }
    if (!r.ended) {
        fprintf(stderr, "judge-routines: %s: %s does not come to its end\n", target, file);
        failed = 1;
    }
}

int main(int argc, char **argv)
{
    if (argc < 3 || argc % 2 == 0) {
        fprintf(stderr, "usage: judge-routines TARGET REPORT ... host -\n");
        return 2;
    }
    routine_begin();
    for (int i = 1; i < argc; i += 2) {
        if (strcmp(argv[i], "host") == 0) {
            tell_host();
        } else {
            read_report(argv[i], argv[i + 1]);
        }
    }
    return failed;
}
