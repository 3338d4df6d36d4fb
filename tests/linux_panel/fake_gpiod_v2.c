/* SPDX-License-Identifier: MIT */
/*
 * What the program calls of libgpiod 2, on the board of fake_board.h.
 */
#include <errno.h>
#include <gpiod.h>
#include <stddef.h>
#include <stdlib.h>

#include "tests/linux_panel/fake_gpiod.h"

struct gpiod_chip_info {
    char unused;
};
struct gpiod_line_info {
    unsigned number;
};
struct gpiod_line_settings {
    enum gpiod_line_direction direction;
    enum gpiod_line_edge edge;
    enum gpiod_line_bias bias;
    bool active_low, high;
};
struct gpiod_line_config {
    struct gpiod_line_settings settings;
    unsigned number;
};
struct gpiod_request_config {
    const char *consumer;
};
struct gpiod_line_request {
    unsigned number;
};
struct gpiod_edge_event {
    bool pressed;
    uint64_t at_ns;
};
struct gpiod_edge_event_buffer {
    struct gpiod_edge_event event;
};

/* ------------------------------------------------------------------------------------------------------- information
 */

static struct gpiod_chip_info the_info;
static struct gpiod_line_info line_info;

struct gpiod_chip_info *__wrap_gpiod_chip_get_info(struct gpiod_chip *chip)
{
    (void)chip;
    return &the_info;
}

void __wrap_gpiod_chip_info_free(struct gpiod_chip_info *info)
{
    (void)info;
}

size_t __wrap_gpiod_chip_info_get_num_lines(struct gpiod_chip_info *info)
{
    (void)info;
    return FAKE_LINES;
}

int __wrap_gpiod_chip_get_line_offset_from_name(struct gpiod_chip *chip, const char *name)
{
    (void)chip;
    const int number = fake_line_named(name);
    errno = number < 0 ? ENOENT : 0;
    return number;
}

struct gpiod_line_info *__wrap_gpiod_chip_get_line_info(struct gpiod_chip *chip, unsigned int offset)
{
    (void)chip;
    line_info.number = offset;
    return &line_info;
}

const char *__wrap_gpiod_line_info_get_consumer(struct gpiod_line_info *info)
{
    return the_board.lines[info->number].consumer;
}

void __wrap_gpiod_line_info_free(struct gpiod_line_info *info)
{
    (void)info;
}

/* ----------------------------------------------------------------------------------------------------------- settings
 */

struct gpiod_line_settings *__wrap_gpiod_line_settings_new(void)
{
    return calloc(1, sizeof(struct gpiod_line_settings));
}

void __wrap_gpiod_line_settings_free(struct gpiod_line_settings *settings)
{
    free(settings);
}

int __wrap_gpiod_line_settings_set_direction(struct gpiod_line_settings *settings, enum gpiod_line_direction direction)
{
    settings->direction = direction;
    return 0;
}

int __wrap_gpiod_line_settings_set_edge_detection(struct gpiod_line_settings *settings, enum gpiod_line_edge edge)
{
    settings->edge = edge;
    return 0;
}

int __wrap_gpiod_line_settings_set_bias(struct gpiod_line_settings *settings, enum gpiod_line_bias bias)
{
    settings->bias = bias;
    return 0;
}

void __wrap_gpiod_line_settings_set_active_low(struct gpiod_line_settings *settings, bool active_low)
{
    settings->active_low = active_low;
}

int __wrap_gpiod_line_settings_set_output_value(struct gpiod_line_settings *settings, enum gpiod_line_value value)
{
    settings->high = value == GPIOD_LINE_VALUE_ACTIVE;
    return 0;
}

struct gpiod_line_config *__wrap_gpiod_line_config_new(void)
{
    return calloc(1, sizeof(struct gpiod_line_config));
}

void __wrap_gpiod_line_config_free(struct gpiod_line_config *config)
{
    free(config);
}

int __wrap_gpiod_line_config_add_line_settings(struct gpiod_line_config *config, const unsigned int *offsets,
                                               size_t count, struct gpiod_line_settings *settings)
{
    if (count != 1) {
        errno = EINVAL;
        return -1;
    }
    config->settings = *settings;
    config->number = offsets[0];
    return 0;
}

struct gpiod_request_config *__wrap_gpiod_request_config_new(void)
{
    return calloc(1, sizeof(struct gpiod_request_config));
}

void __wrap_gpiod_request_config_free(struct gpiod_request_config *config)
{
    free(config);
}

void __wrap_gpiod_request_config_set_consumer(struct gpiod_request_config *config, const char *consumer)
{
    config->consumer = consumer;
}

/* ----------------------------------------------------------------------------------------------------------- requests
 */

struct gpiod_line_request *__wrap_gpiod_chip_request_lines(struct gpiod_chip *chip, struct gpiod_request_config *config,
                                                           struct gpiod_line_config *lines)
{
    (void)chip;
    const struct gpiod_line_settings *settings = &lines->settings;
    struct gpiod_line_request *request = calloc(1, sizeof *request);
    if (request == NULL) {
        errno = ENOMEM;
        return NULL;
    }
    request->number = lines->number;
    fake_lock();
    fake_line *l = &the_board.lines[lines->number];
    const bool output = settings->direction == GPIOD_LINE_DIRECTION_OUTPUT;
    const int error = fake_request(lines->number, config->consumer, output, settings->high);
    if (error == 0) {
        l->edges = settings->edge == GPIOD_LINE_EDGE_BOTH;
        l->active_low = settings->active_low;
        l->pull = settings->bias == GPIOD_LINE_BIAS_PULL_UP     ? FAKE_PULL_UP
                  : settings->bias == GPIOD_LINE_BIAS_PULL_DOWN ? FAKE_PULL_DOWN
                                                                : FAKE_NO_PULL;
    }
    fake_unlock();
    if (error != 0) {
        free(request);
        errno = error;
        return NULL;
    }
    return request;
}

void __wrap_gpiod_line_request_release(struct gpiod_line_request *request)
{
    fake_lock();
    fake_release(request->number);
    fake_unlock();
    free(request);
}

int __wrap_gpiod_line_request_set_value(struct gpiod_line_request *request, unsigned int offset,
                                        enum gpiod_line_value value)
{
    if (offset != request->number) {
        errno = EINVAL;
        return -1;
    }
    return fake_gpiod_set(offset, value == GPIOD_LINE_VALUE_ACTIVE);
}

int __wrap_gpiod_line_request_get_fd(struct gpiod_line_request *request)
{
    return fake_event_file(request->number);
}

struct gpiod_edge_event_buffer *__wrap_gpiod_edge_event_buffer_new(size_t capacity)
{
    return capacity == 1 ? calloc(1, sizeof(struct gpiod_edge_event_buffer)) : NULL;
}

void __wrap_gpiod_edge_event_buffer_free(struct gpiod_edge_event_buffer *buffer)
{
    free(buffer);
}

int __wrap_gpiod_line_request_read_edge_events(struct gpiod_line_request *request,
                                               struct gpiod_edge_event_buffer *buffer, size_t most)
{
    (void)most;
    return fake_gpiod_read(request->number, &buffer->event.pressed, &buffer->event.at_ns) == 0 ? 1 : -1;
}

struct gpiod_edge_event *__wrap_gpiod_edge_event_buffer_get_event(struct gpiod_edge_event_buffer *buffer,
                                                                  unsigned long index)
{
    return index == 0 ? &buffer->event : NULL;
}

enum gpiod_edge_event_type __wrap_gpiod_edge_event_get_event_type(struct gpiod_edge_event *event)
{
    return event->pressed ? GPIOD_EDGE_EVENT_RISING_EDGE : GPIOD_EDGE_EVENT_FALLING_EDGE;
}

uint64_t __wrap_gpiod_edge_event_get_timestamp_ns(struct gpiod_edge_event *event)
{
    return event->at_ns;
}
