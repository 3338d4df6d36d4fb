/* SPDX-License-Identifier: MIT */
/*
 * What the program calls of libgpiod 1.6, on the board of fake_board.h.
 */
#include <errno.h>
#include <gpiod.h>
#include <stddef.h>

#include "tests/linux_panel/fake_gpiod.h"

struct gpiod_line {
    unsigned number;
    const char *consumer; /* as of the last update */
};

static struct gpiod_line lines[FAKE_LINES];

unsigned int __wrap_gpiod_chip_num_lines(struct gpiod_chip *chip)
{
    (void)chip;
    return FAKE_LINES;
}

struct gpiod_line *__wrap_gpiod_chip_get_line(struct gpiod_chip *chip, unsigned int offset)
{
    (void)chip;
    if (offset >= FAKE_LINES) {
        errno = EINVAL;
        return NULL;
    }
    lines[offset].number = offset;
    return &lines[offset];
}

struct gpiod_line *__wrap_gpiod_chip_find_line(struct gpiod_chip *chip, const char *name)
{
    const int number = fake_line_named(name);
    if (number < 0) {
        errno = ENOENT;
        return NULL;
    }
    return __wrap_gpiod_chip_get_line(chip, (unsigned)number);
}

int __wrap_gpiod_line_update(struct gpiod_line *line)
{
    fake_lock();
    line->consumer = the_board.lines[line->number].consumer;
    fake_unlock();
    return 0;
}

const char *__wrap_gpiod_line_consumer(struct gpiod_line *line)
{
    return line->consumer;
}

int __wrap_gpiod_line_request(struct gpiod_line *line, const struct gpiod_line_request_config *config, int value)
{
    fake_lock();
    fake_line *l = &the_board.lines[line->number];
    const bool output = config->request_type == GPIOD_LINE_REQUEST_DIRECTION_OUTPUT;
    const int error = fake_request(line->number, config->consumer, output, value != 0);
    if (error == 0) {
        l->edges = config->request_type == GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES;
        l->active_low = (config->flags & GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW) != 0;
        l->pull = (config->flags & GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP) != 0     ? FAKE_PULL_UP
                  : (config->flags & GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN) != 0 ? FAKE_PULL_DOWN
                                                                                  : FAKE_NO_PULL;
    }
    fake_unlock();
    errno = error;
    return error == 0 ? 0 : -1;
}

int __wrap_gpiod_line_set_value(struct gpiod_line *line, int value)
{
    return fake_gpiod_set(line->number, value != 0);
}

int __wrap_gpiod_line_event_get_fd(struct gpiod_line *line)
{
    return fake_event_file(line->number);
}

int __wrap_gpiod_line_event_read(struct gpiod_line *line, struct gpiod_line_event *event)
{
    bool pressed = false;
    uint64_t at_ns = 0;
    if (fake_gpiod_read(line->number, &pressed, &at_ns) != 0) {
        return -1;
    }
    event->event_type = pressed ? GPIOD_LINE_EVENT_RISING_EDGE : GPIOD_LINE_EVENT_FALLING_EDGE;
    event->ts = (struct timespec){.tv_sec = (time_t)(at_ns / 1000000000u), .tv_nsec = (long)(at_ns % 1000000000u)};
    return 0;
}

void __wrap_gpiod_line_release(struct gpiod_line *line)
{
    fake_lock();
    fake_release(line->number);
    fake_unlock();
}
