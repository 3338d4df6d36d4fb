/* SPDX-License-Identifier: MIT */
/*
 * Times the frames of the case table on the machine that it runs on. The report has the lines of tools/cost/cost.c,
 * whose judge reads it, with nanoseconds for steps, and before each cost
 *
 *     memory SCENE BACKEND SHADING TOLERANCE LEAST FULL USED         as there
 *     spread SCENE BACKEND SHADING TOLERANCE LEAST LOWER UPPER MOST  of FRAMES frames alike: the ends and the quartiles
 *
 * The cost is the median. A computer's frames differ: by what else it does, by its caches, by its clock.
 */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <glint/error.h>

#include "tests/target/selftest.h"
#include "tools/cost/cases.h"

enum { FRAMES = 21, QUARTER = FRAMES / 4, HALF = FRAMES / 2 };

static int discard(void *context, const glint_band *band)
{
    (void)context;
    (void)band;
    return 0;
}

static uint32_t nanoseconds(const struct timespec *from, const struct timespec *to)
{
    const int64_t ns = (int64_t)(to->tv_sec - from->tv_sec) * 1000000000 + (to->tv_nsec - from->tv_nsec);
    return ns < 0 ? 0 : ns > UINT32_MAX ? UINT32_MAX : (uint32_t)ns;
}

static int in_order(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

static void begin(const char *kind, const cost_case *c, int backend)
{
    report_begin(kind);
    report_word(c->scene);
    report_word(cost_backend_names[backend]);
    report_word(c->shading);
    report_word(c->tolerance);
}

static int tell(const cost_case *c, int backend)
{
    const size_t bytes = cost_frame_bytes(c, backend, GLINT_RGB565);
    void *memory = malloc(bytes);
    uint32_t times[FRAMES];
    uint64_t hash = HASH_START;
    glint_report report = {.memory_used_bytes = 0};
    int error = memory == NULL ? GLINT_ERROR_MEMORY_SIZE : GLINT_OK;
    for (int i = 0; i < FRAMES && error == GLINT_OK; i++) {
        struct timespec from, to;
        clock_gettime(CLOCK_MONOTONIC, &from);
        error = cost_draw(c, backend, GLINT_RGB565, discard, NULL, memory, bytes, NULL);
        clock_gettime(CLOCK_MONOTONIC, &to);
        times[i] = nanoseconds(&from, &to);
    }
    if (error == GLINT_OK) {
        error = cost_draw(c, backend, GLINT_RGB565, cost_hash_band, &hash, memory, bytes, &report);
    }
    free(memory);
    if (error != GLINT_OK) {
        begin("failed", c, backend);
        report_decimal((uint32_t)-error);
        report_end();
        return 1;
    }
    qsort(times, FRAMES, sizeof times[0], in_order);
    begin("memory", c, backend);
    report_decimal((uint32_t)cost_frame_least_bytes(c, backend, GLINT_RGB565));
    report_decimal((uint32_t)cost_frame_full_bytes(c, backend, GLINT_RGB565));
    report_decimal(backend == COST_FIXED ? report.memory_used_bytes : 0);
    report_end();
    begin("spread", c, backend);
    report_decimal(times[0]);
    report_decimal(times[QUARTER]);
    report_decimal(times[FRAMES - 1 - QUARTER]);
    report_decimal(times[FRAMES - 1]);
    report_end();
    begin("cost", c, backend);
    report_decimal(times[HALF]);
    report_decimal(times[HALF]);
    report_hex(backend == COST_FIXED ? hash : 0, 16);
    report_end();
    return 0;
}

int main(void)
{
    int failed = 0;
    puts("calibration 1 1\nunit ns");
    for (uint16_t i = 0; i < cost_case_count; i++) {
        for (int backend = 0; backend < COST_BACKENDS; backend++) {
            failed |= tell(&cost_cases[i], backend);
        }
    }
    puts("end");
    return failed;
}
