/* SPDX-License-Identifier: MIT */
/*
 * glint-panel: draws on an SPI panel of a Linux board, through libgpiod and spidev. See README.md.
 */
#include <stdio.h>

#include "failure.h"
#include "options.h"
#include "program.h"

enum { STATUS_GOOD = 0, STATUS_FAILED = 1, STATUS_USAGE = 2 };

int main(int argc, char **argv)
{
    failure why = {""};
    options o;
    if (options_parse(argc, argv, &o, &why) != 0) {
        (void)fprintf(stderr, "glint-panel: %s\n(glint-panel --help tells more)\n", why.text);
        return STATUS_USAGE;
    }
    if (o.help) {
        (void)fputs(options_usage, stdout);
        return STATUS_GOOD;
    }
    if (program_run(&o, stdout, &why) != 0) {
        (void)fprintf(stderr, "glint-panel: %s\n", why.text);
        return STATUS_FAILED;
    }
    return STATUS_GOOD;
}
