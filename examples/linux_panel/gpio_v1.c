/* SPDX-License-Identifier: MIT */
/*
 * GPIO lines through libgpiod 1.6.
 */
#include "gpio.h"

#include <errno.h>
#include <gpiod.h>
#include <stdlib.h>

#include "gpio_common.h"

/* Lines belong to their chip: libgpiod frees them with it. */
struct gpio_line {
    struct gpiod_line *line;
    const char *name; /* as the caller gave it */
};

static struct gpiod_line *find_line(const gpio_chip *chip, const char *name, failure *f)
{
    const unsigned lines = gpiod_chip_num_lines(chip->chip);
    unsigned number = 0;
    const bool by_number = gpio_line_number(name, &number);
    struct gpiod_line *line = NULL;
    if (!by_number) {
        line = gpiod_chip_find_line(chip->chip, name);
    } else if (number < lines) {
        line = gpiod_chip_get_line(chip->chip, number);
    }
    if (line == NULL) {
        (void)gpio_fail_no_line(f, chip, name, lines);
    }
    return line;
}

static gpio_line *request(gpio_chip *chip, const char *name, int type, int flags, bool high, failure *f)
{
    const struct gpiod_line_request_config config = {.consumer = GPIO_CONSUMER, .request_type = type, .flags = flags};
    gpio_line *line = calloc(1, sizeof *line);
    if (line == NULL) {
        (void)fail_with(f, "out of memory");
        return NULL;
    }
    line->name = name;
    line->line = find_line(chip, name, f);
    if (line->line != NULL && gpiod_line_request(line->line, &config, high) == 0) {
        return line;
    }
    if (line->line != NULL) {
        const int error = errno;
        /* who has it may have changed since the line was looked up */
        const char *consumer = gpiod_line_update(line->line) == 0 ? gpiod_line_consumer(line->line) : NULL;
        (void)gpio_fail_request(f, chip, name, error, consumer);
    }
    free(line);
    return NULL;
}

gpio_line *gpio_output(gpio_chip *chip, const char *line, bool high, failure *f)
{
    return request(chip, line, GPIOD_LINE_REQUEST_DIRECTION_OUTPUT, 0, high, f);
}

gpio_line *gpio_button(gpio_chip *chip, const char *line, bool to_ground, failure *f)
{
    const int flags = to_ground ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW | GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP
                                : GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN;
    return request(chip, line, GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES, flags, false, f);
}

int gpio_set(gpio_line *line, bool high, failure *f)
{
    return gpiod_line_set_value(line->line, high) == 0 ? 0 : gpio_fail_use(f, line->name, "set", errno);
}

int gpio_button_fd(const gpio_line *line)
{
    return gpiod_line_event_get_fd(line->line);
}

int gpio_read_edge(gpio_line *line, gpio_edge *out, failure *f)
{
    struct gpiod_line_event event;
    if (gpiod_line_event_read(line->line, &event) != 0) {
        return gpio_fail_use(f, line->name, "read", errno);
    }
    out->pressed = event.event_type == GPIOD_LINE_EVENT_RISING_EDGE;
    out->at_ns = (uint64_t)event.ts.tv_sec * 1000000000u + (uint64_t)event.ts.tv_nsec;
    return 0;
}

void gpio_release(gpio_line *line)
{
    if (line != NULL) {
        gpiod_line_release(line->line);
        free(line);
    }
}
