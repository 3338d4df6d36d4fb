/* SPDX-License-Identifier: MIT */
#include "tools/cost/calibrate.h"

#include "tests/target/platform.h"
#include "tests/target/selftest.h"

/* Rounds of platform_known_loop(), so that one step of the counter more or less does not show. */
enum { ROUNDS = 20 };

void cost_calibrate(void)
{
    uint32_t known = 0, empty = platform_count();
    empty = platform_count() - empty;
    const uint32_t start = platform_count();
    for (int i = 0; i < ROUNDS; i++) {
        known += platform_known_loop();
    }
    const uint32_t steps = platform_count() - start;
    report_begin("calibration");
    report_decimal(known);
    report_decimal(steps - empty);
    report_end();
    report_begin("unit");
    report_word(platform_count_unit);
    report_end();
}
