/* SPDX-License-Identifier: MIT */
/*
 * GPIO lines through libgpiod 2.x.
 */
#include "gpio.h"

#include <errno.h>
#include <gpiod.h>
#include <stdlib.h>

#include "gpio_common.h"

struct gpio_line {
    struct gpiod_line_request *request;
    struct gpiod_edge_event_buffer *edges; /* of buttons */
    unsigned offset;
    const char *name; /* as the caller gave it */
};

static unsigned count_lines(const gpio_chip *chip)
{
    struct gpiod_chip_info *info = gpiod_chip_get_info(chip->chip);
    const unsigned lines = info == NULL ? 0 : (unsigned)gpiod_chip_info_get_num_lines(info);
    if (info != NULL) {
        gpiod_chip_info_free(info);
    }
    return lines;
}

static int find_line(const gpio_chip *chip, const char *name, unsigned *offset, failure *f)
{
    const unsigned lines = count_lines(chip);
    if (gpio_line_number(name, offset)) {
        return *offset < lines ? 0 : gpio_fail_no_line(f, chip, name, lines);
    }
    const int found = gpiod_chip_get_line_offset_from_name(chip->chip, name);
    if (found < 0) {
        return gpio_fail_no_line(f, chip, name, lines);
    }
    *offset = (unsigned)found;
    return 0;
}

static void fail_request(const gpio_chip *chip, const gpio_line *line, int error, failure *f)
{
    struct gpiod_line_info *info = gpiod_chip_get_line_info(chip->chip, line->offset);
    (void)gpio_fail_request(f, chip, line->name, error, info ? gpiod_line_info_get_consumer(info) : NULL);
    if (info != NULL) {
        gpiod_line_info_free(info);
    }
}

/* Requests the line with these settings, which are freed. */
static gpio_line *request(gpio_chip *chip, const char *name, struct gpiod_line_settings *settings, failure *f)
{
    struct gpiod_line_config *lines = gpiod_line_config_new();
    struct gpiod_request_config *config = gpiod_request_config_new();
    gpio_line *line = calloc(1, sizeof *line);
    if (settings == NULL || lines == NULL || config == NULL || line == NULL) {
        (void)fail_with(f, "out of memory");
    } else if (find_line(chip, name, &line->offset, f) == 0) {
        line->name = name;
        gpiod_request_config_set_consumer(config, GPIO_CONSUMER);
        if (gpiod_line_config_add_line_settings(lines, &line->offset, 1, settings) == 0) {
            line->request = gpiod_chip_request_lines(chip->chip, config, lines);
        }
        if (line->request == NULL) {
            fail_request(chip, line, errno, f);
        }
    }
    gpiod_line_settings_free(settings);
    gpiod_line_config_free(lines);
    gpiod_request_config_free(config);
    if (line != NULL && line->request == NULL) {
        free(line);
        line = NULL;
    }
    return line;
}

gpio_line *gpio_output(gpio_chip *chip, const char *line, bool high, failure *f)
{
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    if (settings != NULL) {
        (void)gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_OUTPUT);
        (void)gpiod_line_settings_set_output_value(settings,
                                                   high ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE);
    }
    return request(chip, line, settings, f);
}

gpio_line *gpio_button(gpio_chip *chip, const char *line, bool to_ground, failure *f)
{
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    if (settings != NULL) {
        (void)gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_INPUT);
        (void)gpiod_line_settings_set_edge_detection(settings, GPIOD_LINE_EDGE_BOTH);
        (void)gpiod_line_settings_set_bias(settings, to_ground ? GPIOD_LINE_BIAS_PULL_UP : GPIOD_LINE_BIAS_PULL_DOWN);
        gpiod_line_settings_set_active_low(settings, to_ground);
    }
    gpio_line *button = request(chip, line, settings, f);
    if (button == NULL) {
        return NULL;
    }
    button->edges = gpiod_edge_event_buffer_new(1);
    if (button->edges == NULL) {
        (void)fail_with(f, "out of memory");
        gpio_release(button);
        return NULL;
    }
    return button;
}

int gpio_set(gpio_line *line, bool high, failure *f)
{
    const enum gpiod_line_value value = high ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
    return gpiod_line_request_set_value(line->request, line->offset, value) == 0
               ? 0
               : gpio_fail_use(f, line->name, "set", errno);
}

int gpio_button_fd(const gpio_line *line)
{
    return gpiod_line_request_get_fd(line->request);
}

int gpio_read_edge(gpio_line *line, gpio_edge *out, failure *f)
{
    if (gpiod_line_request_read_edge_events(line->request, line->edges, 1) < 1) {
        return gpio_fail_use(f, line->name, "read", errno);
    }
    struct gpiod_edge_event *event = gpiod_edge_event_buffer_get_event(line->edges, 0);
    out->pressed = gpiod_edge_event_get_event_type(event) == GPIOD_EDGE_EVENT_RISING_EDGE;
    out->at_ns = gpiod_edge_event_get_timestamp_ns(event);
    return 0;
}

void gpio_release(gpio_line *line)
{
    if (line != NULL) {
        gpiod_line_request_release(line->request);
        gpiod_edge_event_buffer_free(line->edges);
        free(line);
    }
}
