/* SPDX-License-Identifier: MIT */
/*
 * What gpio_v1.c and gpio_v2.c share: chips, how lines are named, and what is said when one is not to be had.
 */
#ifndef EXAMPLES_LINUX_PANEL_GPIO_COMMON_H
#define EXAMPLES_LINUX_PANEL_GPIO_COMMON_H

#include "failure.h"
#include "gpio.h"
#include <stdbool.h>

struct gpio_chip {
    struct gpiod_chip *chip;
    char path[64];
};

/* Whether `line` is a number, and which. */
bool gpio_line_number(const char *line, unsigned *number);

/* Each returns -1. `error` is errno of the call that failed, `consumer` who has the line (NULL: not known). */
int gpio_fail_no_line(failure *f, const gpio_chip *chip, const char *line, unsigned lines);
int gpio_fail_request(failure *f, const gpio_chip *chip, const char *line, int error, const char *consumer);
int gpio_fail_use(failure *f, const char *line, const char *what, int error);

#endif
