/* SPDX-License-Identifier: MIT */
#include "program.h"

#include <errno.h>
#include <string.h>

#include "clock.h"
#include "meter.h"
#include "show.h"
#include "stop.h"

#define PRESS_TURN16 4096 /* 1/16 turn */
#define FRAME_TURN16 512  /* a whole turn in 128 frames */

typedef struct board {
    gpio_chip *chip;
    gpio_line *dc, *reset, *backlight;
    gpio_line *buttons[BUTTONS_MOST];
    spi_device spi;
    bool spi_open;
} board;

/* -------------------------------------------------------------------------------------------------- lines and device
 */

static void release(board *b)
{
    for (unsigned i = 0; i < BUTTONS_MOST; i++) {
        gpio_release(b->buttons[i]);
    }
    gpio_release(b->backlight);
    gpio_release(b->reset);
    gpio_release(b->dc);
    gpio_chip_close(b->chip);
    if (b->spi_open) {
        spi_close(&b->spi);
    }
}

static bool output_is_there(gpio_chip *chip, const char *line, bool high, gpio_line **out, failure *f)
{
    *out = line == NULL ? NULL : gpio_output(chip, line, high, f);
    return line == NULL || *out != NULL;
}

static int acquire(board *b, const options *o, failure *f)
{
    memset(b, 0, sizeof *b);
    b->chip = gpio_chip_open(o->chip, f);
    if (b->chip == NULL || !output_is_there(b->chip, o->dc, false, &b->dc, f) ||
        !output_is_there(b->chip, o->reset, true, &b->reset, f) ||
        !output_is_there(b->chip, o->backlight, false, &b->backlight, f)) {
        return -1;
    }
    for (unsigned i = 0; i < o->button_count; i++) {
        b->buttons[i] = gpio_button(b->chip, o->buttons[i], !o->buttons_high, f);
        if (b->buttons[i] == NULL) {
            return -1;
        }
    }
    b->spi_open = spi_open(&b->spi, o->spi, o->speed_hz, f) == 0;
    return b->spi_open ? 0 : -1;
}

/* ------------------------------------------------------------------------------------------------------------- frames
 */

/* Waits for a press that means something. 0, SHOW_STOPPED, or -1 and why. */
static int wait_for_press(const board *b, buttons *state, button_action *action, failure *f)
{
    struct pollfd files[BUTTONS_MOST] = {{0}};
    for (unsigned i = 0; i < state->count; i++) {
        files[i] = (struct pollfd){.fd = gpio_button_fd(b->buttons[i]), .events = POLLIN};
    }
    *action = BUTTON_NOTHING;
    while (*action == BUTTON_NOTHING) {
        if (stop_poll(files, state->count) < 0) {
            if (stop_asked()) {
                return SHOW_STOPPED;
            }
            if (errno == EINTR) {
                continue;
            }
            return fail_with(f, "cannot wait for the buttons: %s", strerror(errno));
        }
        for (unsigned i = 0; i < state->count && *action == BUTTON_NOTHING; i++) {
            gpio_edge edge;
            if (files[i].revents == 0) {
                continue;
            }
            if (gpio_read_edge(b->buttons[i], &edge, f) != 0) {
                return -1;
            }
            *action = buttons_edge(state, i, &edge);
        }
    }
    return 0;
}

static void act(view *v, button_action action)
{
    switch (action) {
    case BUTTON_TURN:
        v->turn16 = (uint16_t)(v->turn16 + PRESS_TURN16);
        break;
    case BUTTON_TURN_BACK:
        v->turn16 = (uint16_t)(v->turn16 - PRESS_TURN16);
        break;
    case BUTTON_TOLERANCE:
        view_switch_tolerance(v);
        break;
    case BUTTON_NOTHING:
        break;
    }
}

/* Sets up the next frame. 0, SHOW_STOPPED, or -1 and why. */
static int next_frame(const board *b, buttons *state, view *v, failure *f)
{
    button_action action = BUTTON_NOTHING;
    if (state->count == 0) {
        v->turn16 = (uint16_t)(v->turn16 + FRAME_TURN16);
        return stop_asked() ? SHOW_STOPPED : 0;
    }
    const int result = wait_for_press(b, state, &action, f);
    act(v, action);
    return result;
}

/* 0 after the last frame, SHOW_STOPPED, or -1 and why. */
static int draw_frames(const board *b, const options *o, screen *on, show *s, FILE *out, failure *f)
{
    buttons state = {.count = o->button_count};
    meter speed = {.start_ns = clock_ns()};
    show_frame took;
    for (uint32_t number = 1;; number++) {
        const bool last = number == o->frames;
        int result = show_draw(s, &took, f);
        if (result == 0 && number == 1) {
            result = screen_show(on, f);
        }
        if (result != 0) {
            return result;
        }
        if (o->fps) {
            meter_second(&speed, out, &took, clock_ns(), last);
        }
        if (o->button_count != 0) {
            meter_frame(out, number, &s->view, &took);
        }
        result = last ? 0 : next_frame(b, &state, &s->view, f);
        if (last || result != 0) {
            return result;
        }
    }
}

static int draw(const board *b, const options *o, screen *on, FILE *out, failure *f)
{
    const bool on_its_side = o->glass.quarter_turns % 2 != 0;
    const uint16_t width_px = on_its_side ? o->glass.height_px : o->glass.width_px;
    const uint16_t height_px = on_its_side ? o->glass.width_px : o->glass.height_px;
    show s;
    int result = show_open(&s, on, o->demo, o->tolerance, width_px, height_px, o->dump, f);
    if (result == 0) {
        result = draw_frames(b, o, on, &s, out, f);
        show_close(&s);
    }
    return result;
}

int program_run(const options *o, FILE *out, failure *f)
{
    board b;
    stop_watch();
    if (acquire(&b, o, f) != 0) {
        release(&b);
        return -1;
    }
    screen on = {.spi = &b.spi, .dc = b.dc, .reset = b.reset, .backlight = b.backlight};
    screen_connect(&on, o->controller, &o->glass);
    int result = screen_begin(&on, f);
    if (result == 0 && o->ask) {
        result = screen_ask(&on, f);
    }
    if (result == 0) {
        result = draw(&b, o, &on, out, f);
    }
    if (result == SHOW_STOPPED) {
        result = screen_blank(&on, f);
    } else if (result != 0) {
        failure again; /* the first one tells more */
        (void)screen_blank(&on, &again);
    }
    release(&b);
    return result;
}
