/* SPDX-License-Identifier: MIT */
/*
 * The program that runs on a target and counts its frames. It prints lines of words, which judge.c reads:
 *
 *     calibration KNOWN COUNTED                  instructions or cycles, and the steps that the counter took for them
 *     unit instructions|cycles
 *     cost SCENE BACKEND SHADING TOLERANCE FIRST SECOND HASH   steps of two frames alike; FNV-1a of a third, fixed only
 *     short SCENE BACKEND SHADING TOLERANCE USEFUL GIVEN   before the cost: bytes that the frame can use, and has
 *     memory SCENE BACKEND SHADING TOLERANCE LEAST FULL USED   before the cost: bytes that it takes at least, for all
 *                                                vertices and lists, and made use of (fixed only, else 0)
 *     left SCENE BACKEND SHADING TOLERANCE BYTES     not drawn: takes at least so much memory, and there is less
 *     failed SCENE BACKEND SHADING TOLERANCE ERROR   the negated glint_error: its text would take the AVR's RAM
 *     end
 *
 * A frame is one call of glint_fixed_render() or glint_float_render(), clears included, with a flush function that
 * returns at once. Limits: the counter's step is 40 instructions on QEMU's MPS2 boards; on the AVR its overflow
 * interrupt, every 65,536 cycles, counts as the frame's.
 */
#include "tests/target/platform.h"
#include "tests/target/selftest.h"
#include "tools/cost/calibrate.h"
#include "tools/cost/cases.h"

/* Empty: all cases. An emulator's script that wants one puts its first words here, "A fixed exact". */
extern const volatile char cost_chosen[COST_NAME_BYTES];
const volatile char cost_chosen[COST_NAME_BYTES] = "";

static int discard(void *context, const glint_band *band)
{
    (void)context;
    (void)band;
    return 0;
}

static void begin(const char *kind, const cost_case *c, int backend)
{
    report_begin(kind);
    report_word(c->scene);
    report_word(cost_backend_names[backend]);
    report_word(c->shading);
    report_word(c->tolerance);
}

/* cost_chosen holds the first words of the case's name, or none. */
static bool is_chosen(const cost_case *c, int backend)
{
    const char *const words[] = {c->scene, cost_backend_names[backend], c->shading, c->tolerance};
    const volatile char *chosen = cost_chosen;
    for (size_t i = 0; i < sizeof words / sizeof words[0] && *chosen; i++) {
        const char *word = words[i];
        while (*word && *word == *chosen) {
            word++;
            chosen++;
        }
        if (*word || (*chosen && *chosen++ != ' ')) {
            return false;
        }
    }
    return *chosen == '\0';
}

/* Steps of one frame; what the library returned is in *error. One copy of the code, or frames alike would not cost the
 * same. */
__attribute__((noinline)) static uint32_t frame(const cost_case *c, int backend, size_t bytes, int *error)
{
    const uint32_t start = platform_count();
    *error = cost_draw(c, backend, GLINT_RGB565, discard, NULL, cost_memory, bytes, NULL);
    return platform_count() - start;
}

static void count(const cost_case *c, int backend)
{
    const size_t useful = cost_frame_bytes(c, backend, GLINT_RGB565);
    const size_t least = cost_frame_least_bytes(c, backend, GLINT_RGB565);
    if (least == 0 || least > cost_memory_bytes) {
        begin("left", c, backend);
        report_decimal((uint32_t)least);
        report_end();
        return;
    }
    const size_t bytes = useful < cost_memory_bytes ? useful : cost_memory_bytes;
    if (bytes < useful) {
        begin("short", c, backend);
        report_decimal((uint32_t)useful);
        report_decimal((uint32_t)bytes);
        report_end();
    }
    uint64_t hash = HASH_START;
    uint32_t steps[2] = {0, 0};
    int error = 0;
    for (int i = 0; i < 2 && error == 0; i++) {
        steps[i] = frame(c, backend, bytes, &error);
    }
    if (error == 0) {
        glint_report report = {.memory_used_bytes = 0};
        if (backend == COST_FIXED) {
            error = cost_draw(c, backend, GLINT_RGB565, cost_hash_band, &hash, cost_memory, bytes, &report);
        }
        begin("memory", c, backend);
        report_decimal((uint32_t)least);
        report_decimal((uint32_t)cost_frame_full_bytes(c, backend, GLINT_RGB565));
        report_decimal(report.memory_used_bytes);
        report_end();
    }
    begin(error ? "failed" : "cost", c, backend);
    if (error) {
        report_decimal((uint32_t)-error);
    } else {
        report_decimal(steps[0]);
        report_decimal(steps[1]);
        report_hex(backend == COST_FIXED ? hash : 0, 16);
    }
    report_end();
}

int main(void)
{
    platform_begin();
    cost_calibrate();
    for (uint16_t i = 0; i < cost_case_count; i++) {
        for (int backend = 0; backend < COST_BACKENDS; backend++) {
            if ((cost_backends >> backend & 1) && is_chosen(&cost_cases[i], backend)) {
                count(&cost_cases[i], backend);
            }
        }
    }
    report_begin("end");
    report_end();
    platform_end();
    return 0;
}
