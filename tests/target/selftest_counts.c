/* SPDX-License-Identifier: MIT */
/*
 * What a unit vector and a frame cost here, in instructions or cycles, first calibrated on a loop of known length.
 *
 * A routine is called in a loop of its own, and the same loop with a function that only returns is taken off: what
 * remains, plus what that function is known to take, is the routine from entry to return. Limit: the counter's step is
 * up to 63 instructions, spread over platform_count_repeat calls.
 */
#include "tests/target/selftest.h"

#include "number/fixed.h"
#include "tests/target/platform.h"

enum { VECTORS = 100 };

typedef bool (*unit_function)(const int32_t v[3], int32_t unit[3]);

static bool nothing(const int32_t v[3], int32_t unit[3])
{
    (void)v;
    (void)unit;
    return true;
}

static unit_function volatile called; /* so that both loops are the same code */

static uint32_t counted_calls(unit_function function, const int32_t v[3])
{
    int32_t unit[3];
    called = function;
    const uint32_t start = platform_count();
    for (uint16_t i = 0; i < platform_count_repeat; i++) {
        (void)called(v, unit);
    }
    return platform_count() - start;
}

/* Ten times what so many steps of the counter are, per call. */
static uint32_t known, steps;
static uint32_t tenths(uint32_t counted, uint16_t calls)
{
    return (uint32_t)(((uint64_t)counted * known * 10 + steps / 2) / steps / calls);
}

static void print(const char *name, uint32_t average, uint32_t worst)
{
    report_begin("count");
    report_word(name);
    report_decimal(average);
    report_decimal(worst);
    report_word(platform_count_unit);
    report_end();
}

/* Vectors as shading has them: interpolated normals and directions, whose greatest component has 10 to 30 bits. */
static void count_unit(void)
{
    uint32_t state = 2463534242, sum = 0, worst = 0;
    for (uint8_t i = 0; i < VECTORS; i++) {
        int32_t v[3];
        for (int k = 0; k < 3; k++) {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            v[k] = (int32_t)state >> (1 + i % 20);
        }
        const uint32_t empty = counted_calls(nothing, v);
        const uint32_t full = counted_calls(glint_unit_q15, v);
        const uint32_t one = tenths(full - empty, platform_count_repeat) + 10 * (uint32_t)platform_empty_cost;
        sum += one;
        worst = one > worst ? one : worst;
    }
    print("unit-q15", (sum + VECTORS / 2) / VECTORS, worst);
}

static void count_frame(const char *name, bool in_float)
{
    const uint32_t start = platform_count();
    selftest_draw_counted(in_float);
    const uint32_t frame = tenths(platform_count() - start, 1);
    print(name, frame, frame);
}

void selftest_counts(void)
{
    const uint32_t start = platform_count();
    known = platform_known_loop();
    steps = platform_count() - start;
    report_begin("calibration");
    report_decimal(known);
    report_decimal(steps);
    report_end();
    count_unit();
    count_frame("frame-fixed", false);
    if (SELFTEST_FLOAT_FRAMES) {
        count_frame("frame-float", true);
    }
}
