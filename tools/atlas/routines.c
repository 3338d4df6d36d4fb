/* SPDX-License-Identifier: MIT */
/*
 * The program that counts the variants of a routine on a target. It prints lines of words, which judge_routines.c
 * reads:
 *
 *     calibration KNOWN COUNTED, unit WORD     as tools/cost/calibrate.h
 *     calls REPEAT INPUTS EMPTY                each input so often; what a function that only returns true takes
 *     routine ROUTINE VARIANT STEPS WORST HASH steps of all calls, those of such a function taken off; the most that
 * the calls for one input took; FNV-1a over the results of all inputs, as bits result ROUTINE VARIANT HEX ... of an
 * input: the results of a variant in float, whose bits may be others than the host's, where the C library or its
 * rounding is another end
 */
#include <string.h>

#include "tests/target/platform.h"
#include "tests/target/selftest.h"
#include "tools/atlas/routines.h"
#include "tools/cost/calibrate.h"

enum { INPUTS = 32 };

static bool nothing(const routine_input *in, routine_result *out)
{
    (void)in;
    (void)out;
    return true;
}

static routine_function volatile called; /* so that both loops are the same code */

static uint32_t counted_calls(routine_function function, const routine_input *in, routine_result *out)
{
    called = function;
    const uint32_t start = platform_count();
    for (uint16_t i = 0; i < platform_count_repeat; i++) {
        (void)called(in, out);
    }
    return platform_count() - start;
}

static void begin(const char *kind, const routine_variant *variant)
{
    report_begin(kind);
    report_word(routine_names[variant->routine]);
    report_word(variant->name);
}

static void count(const routine_variant *variant)
{
    uint32_t state = ROUTINE_SEED, steps = 0, worst = 0;
    uint64_t hash = HASH_START;
    for (int i = 0; i < INPUTS; i++) {
        const routine_input in = routine_next(&state);
        routine_result out = {{0, 0, 0}};
        const uint32_t empty = counted_calls(nothing, &in, &out);
        const uint32_t full = counted_calls(variant->function, &in, &out);
        const uint32_t own = full > empty ? full - empty : 0;
        steps += own;
        worst = own > worst ? own : worst;
        if (variant->fraction_bits < 0) {
            begin("result", variant);
        }
        for (int k = 0; k < routine_width(variant); k++) {
            uint32_t bits;
            memcpy(&bits, variant->fraction_bits < 0 ? (void *)&out.real[k] : (void *)&out.fixed[k], sizeof bits);
            hash = hash_bytes(hash, bits, 4);
            if (variant->fraction_bits < 0) {
                report_hex(bits, 8);
            }
        }
        if (variant->fraction_bits < 0) {
            report_end();
        }
    }
    begin("routine", variant);
    report_decimal(steps);
    report_decimal(worst);
    report_hex(hash, 16);
    report_end();
}

int main(void)
{
    platform_begin();
    cost_calibrate();
    report_begin("calls");
    report_decimal(platform_count_repeat);
    report_decimal(INPUTS);
    report_decimal(platform_empty_cost);
    report_end();
    routine_begin();
    for (uint8_t i = 0; i < routine_variant_count; i++) {
        count(&routine_variants[i]);
    }
    report_begin("end");
    report_end();
    platform_end();
    return 0;
}
