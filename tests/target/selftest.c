/* SPDX-License-Identifier: MIT */
/*
 * The self-test that runs on every target, emulated or not: the number routines and a set of small frames, in both
 * backends. It prints what came out (selftest.h) and judges nothing: check.c compares with the host's report.
 */
#include "tests/target/selftest.h"

#include <limits.h>
#include <string.h>

#include "tests/target/platform.h"

int main(void)
{
    const uint16_t one = 1;
    uint8_t first;
    memcpy(&first, &one, 1);

    platform_begin();
    report_begin("target");
    report_decimal(sizeof(int) * CHAR_BIT);
    report_decimal(sizeof(void *) * CHAR_BIT);
    report_word(first ? "little" : "big");
    report_end();
    selftest_numbers();
    selftest_frames();
    if (platform_count_unit) {
        selftest_counts();
    }
    report_begin("end");
    report_end();
    platform_end();
    return 0;
}
