/* SPDX-License-Identifier: MIT */
/*
 * GPIO lines through libgpiod. gpio_v1.c is written against libgpiod 1.6, gpio_v2.c against 2.x; the program is linked
 * with one of them. gpio_common.c has what both share.
 *
 * A line is named by its number on the chip (all digits) or by its name ("GPIO25"). Each is requested on its own, so
 * that a failure names the line. Functions that can fail tell why in `f` and return NULL, or -1.
 */
#ifndef EXAMPLES_LINUX_PANEL_GPIO_H
#define EXAMPLES_LINUX_PANEL_GPIO_H

#include <stdbool.h>
#include <stdint.h>

#include "failure.h"

/* How our lines are named in what gpioinfo lists. */
#define GPIO_CONSUMER "glint-panel"

typedef struct gpio_chip gpio_chip;
typedef struct gpio_line gpio_line;

typedef struct gpio_edge {
    bool pressed;   /* the button went down; otherwise up */
    uint64_t at_ns; /* by the kernel's clock, of no known origin */
} gpio_edge;

/* "gpiochip0", "0" or "/dev/gpiochip0". */
gpio_chip *gpio_chip_open(const char *name, failure *f);
void gpio_chip_close(gpio_chip *chip); /* NULL is fine */

gpio_line *gpio_output(gpio_chip *chip, const char *line, bool high, failure *f);
int gpio_set(gpio_line *line, bool high, failure *f);

/* An input that tells of both edges; `to_ground`: pressed when low, with the pull-up resistor on; otherwise pressed
 * when high, with the pull-down resistor on. Chips without such resistors ignore that. */
gpio_line *gpio_button(gpio_chip *chip, const char *line, bool to_ground, failure *f);
int gpio_button_fd(const gpio_line *line); /* readable when there is an edge */
int gpio_read_edge(gpio_line *line, gpio_edge *out, failure *f);

void gpio_release(gpio_line *line); /* NULL is fine; before the chip is closed */

#endif
