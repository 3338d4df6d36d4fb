/* SPDX-License-Identifier: MIT */
#include "gpio_common.h"

#include <errno.h>
#include <glob.h>
#include <gpiod.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool all_digits(const char *text)
{
    return *text != '\0' && text[strspn(text, "0123456789")] == '\0';
}

bool gpio_line_number(const char *line, unsigned *number)
{
    if (!all_digits(line)) {
        return false;
    }
    const unsigned long value = strtoul(line, NULL, 10);
    *number = value < UINT_MAX ? (unsigned)value : UINT_MAX;
    return true;
}

/* The chips that this machine has, for a person who named another one. */
static void list_chips(char *text, size_t bytes)
{
    glob_t found;
    size_t used = 0;
    text[0] = '\0';
    if (glob("/dev/gpiochip*", 0, NULL, &found) == 0) {
        for (size_t i = 0; i < found.gl_pathc && used < bytes; i++) {
            used += (size_t)snprintf(text + used, bytes - used, " %s", found.gl_pathv[i] + strlen("/dev/"));
        }
        globfree(&found);
    }
}

static int fail_chip(failure *f, const char *path, int error)
{
    char chips[128];
    switch (error) {
    case EACCES:
    case EPERM:
        return fail_permission(f, path);
    case ENOENT:
    case ENODEV:
    case ENXIO:
    case ENOTTY:
        list_chips(chips, sizeof chips);
        if (chips[0] == '\0') {
            return fail_with(f,
                             "%s: no such GPIO chip, nor any other: this kernel has no GPIO character devices "
                             "(CONFIG_GPIO_CDEV), or no driver for the board's chip",
                             path);
        }
        return fail_with(f, "%s: no such GPIO chip; give --chip one of:%s (gpiodetect tells what they are)", path,
                         chips);
    default:
        return fail_with(f, "%s: cannot open the GPIO chip: %s", path, strerror(error));
    }
}

gpio_chip *gpio_chip_open(const char *name, failure *f)
{
    gpio_chip *chip = calloc(1, sizeof *chip);
    if (chip == NULL) {
        (void)fail_with(f, "out of memory");
        return NULL;
    }
    const char *folder = strchr(name, '/') != NULL ? "" : all_digits(name) ? "/dev/gpiochip" : "/dev/";
    (void)snprintf(chip->path, sizeof chip->path, "%s%s", folder,
                   name); /* cut if too long: then there is no such chip */
    chip->chip = gpiod_chip_open(chip->path);
    if (chip->chip == NULL) {
        (void)fail_chip(f, chip->path, errno);
        free(chip);
        return NULL;
    }
    return chip;
}

void gpio_chip_close(gpio_chip *chip)
{
    if (chip != NULL) {
        gpiod_chip_close(chip->chip);
        free(chip);
    }
}

int gpio_fail_no_line(failure *f, const gpio_chip *chip, const char *line, unsigned lines)
{
    unsigned number = 0;
    if (gpio_line_number(line, &number)) {
        return fail_with(f, "line %s: %s has lines 0..%u only; `gpioinfo` lists them with their names", line,
                         chip->path, lines - 1);
    }
    return fail_with(f, "line \"%s\": no line of %s has this name; `gpioinfo` lists them; a number does as well", line,
                     chip->path);
}

int gpio_fail_request(failure *f, const gpio_chip *chip, const char *line, int error, const char *consumer)
{
    switch (error) {
    case EBUSY:
        if (consumer == NULL || *consumer == '\0') {
            return fail_with(
                f,
                "line %s of %s is in use by the kernel or a program that gives no name: choose another line, "
                "or free it (see `gpioinfo` and the board's device tree overlays)",
                line, chip->path);
        }
        if (strcmp(consumer, GPIO_CONSUMER) == 0) {
            return fail_with(f,
                             "line %s of %s is in use by another " GPIO_CONSUMER
                             ": end that one first, or do not give a "
                             "line twice",
                             line, chip->path);
        }
        return fail_with(f,
                         "line %s of %s is in use by \"%s\": end that, or choose another line (`gpioinfo` lists them)",
                         line, chip->path, consumer);
    case EACCES:
    case EPERM:
        return fail_with(f, "line %s of %s: no permission to use it: the kernel reserves it; choose another line", line,
                         chip->path);
    default:
        return fail_with(f, "line %s of %s: the request failed: %s", line, chip->path, strerror(error));
    }
}

int gpio_fail_use(failure *f, const char *line, const char *what, int error)
{
    return fail_with(f, "line %s: cannot %s it: %s; was its chip unplugged?", line, what, strerror(error));
}
