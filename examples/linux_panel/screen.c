/* SPDX-License-Identifier: MIT */
#include "screen.h"

#include <stddef.h>
#include <string.h>

#include "clock.h"

/* ----------------------------------------------------------------------------------------------------------- the port
 */

#define PORT_FAILED (-1) /* the sentence is in the screen's failure */

static int send_with_dc(void *context, bool data, const uint8_t *bytes, uint32_t count)
{
    screen *s = context;
    const int result = gpio_set(s->dc, data, s->failure);
    return result != 0 ? PORT_FAILED : spi_write(s->spi, bytes, count, s->failure);
}

static int send_command(void *context, const uint8_t *bytes, uint32_t count)
{
    return send_with_dc(context, false, bytes, count);
}

static int send_data(void *context, const uint8_t *bytes, uint32_t count)
{
    return send_with_dc(context, true, bytes, count);
}

static int set_reset(void *context, bool high)
{
    screen *s = context;
    return gpio_set(s->reset, high, s->failure);
}

static int delay_us(void *context, uint32_t us)
{
    (void)context;
    const uint64_t end_ns = clock_ns() + us * UINT64_C(1000);
    const struct timespec end = {.tv_sec = (time_t)(end_ns / 1000000000u), .tv_nsec = (long)(end_ns % 1000000000u)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &end, NULL) != 0) {
        /* a signal came: the delay is the controller's, it is kept */
    }
    return 0;
}

/* ---------------------------------------------------------------------------------------------------- the controllers
 */

struct screen_controller {
    const char *name;
    uint32_t speed_hz;
    int (*begin)(const screen *s);
    int (*window)(const screen *s, uint16_t y_px, uint16_t width_px, uint16_t height_px);
    int (*show)(const screen *s);
    int (*end)(const screen *s);
};

static int st7789_of_begin(const screen *s)
{
    return st7789_begin(&s->driver.st7789);
}

static int st7789_of_window(const screen *s, uint16_t y_px, uint16_t width_px, uint16_t height_px)
{
    return st7789_window(&s->driver.st7789, 0, y_px, width_px, height_px);
}

static int st7789_of_show(const screen *s)
{
    return st7789_show(&s->driver.st7789);
}

static int st7789_of_end(const screen *s)
{
    return st7789_end(&s->driver.st7789);
}

static int ili9341_of_begin(const screen *s)
{
    return ili9341_begin(&s->driver.ili9341);
}

static int ili9341_of_window(const screen *s, uint16_t y_px, uint16_t width_px, uint16_t height_px)
{
    return ili9341_window(&s->driver.ili9341, 0, y_px, width_px, height_px);
}

static int ili9341_of_show(const screen *s)
{
    return ili9341_show(&s->driver.ili9341);
}

static int ili9341_of_end(const screen *s)
{
    return ili9341_end(&s->driver.ili9341);
}

/* The data sheets' shortest clock cycles when writing: 16 ns and 100 ns; half of the former for wires on a breadboard.
 */
static const screen_controller controllers[] = {
    {"st7789", 32000000, st7789_of_begin, st7789_of_window, st7789_of_show, st7789_of_end},
    {"ili9341", 10000000, ili9341_of_begin, ili9341_of_window, ili9341_of_show, ili9341_of_end},
};

const screen_controller *screen_controller_named(const char *name)
{
    for (size_t i = 0; i < sizeof controllers / sizeof controllers[0]; i++) {
        if (strcmp(controllers[i].name, name) == 0) {
            return &controllers[i];
        }
    }
    return NULL;
}

uint32_t screen_default_speed_hz(const screen_controller *controller)
{
    return controller->speed_hz;
}

void screen_connect(screen *out, const screen_controller *controller, const screen_glass *glass)
{
    out->controller = controller;
    out->port = (panel_port){.send_command = send_command,
                             .send_data = send_data,
                             .set_reset = out->reset != NULL ? set_reset : NULL,
                             .delay_us = delay_us,
                             .context = out};
    if (controller->begin == ili9341_of_begin) {
        out->driver.ili9341 = (ili9341){.port = &out->port,
                                        .width_px = glass->width_px,
                                        .height_px = glass->height_px,
                                        .x_px = glass->x_px,
                                        .y_px = glass->y_px,
                                        .rotation = glass->quarter_turns};
    } else {
        out->driver.st7789 = (st7789){.port = &out->port,
                                      .width_px = glass->width_px,
                                      .height_px = glass->height_px,
                                      .x_px = glass->x_px,
                                      .y_px = glass->y_px,
                                      .rotation = glass->quarter_turns};
    }
}

/* ---------------------------------------------------------------------------------------------------------- the screen
 */

int screen_begin(screen *s, failure *f)
{
    s->failure = f;
    return s->controller->begin(s);
}

/* Read display power mode: one byte, the same in both controllers. Reading is slower than writing. */
#define RDDPM 0x0A
#define RDDPM_AWAKE 0x10 /* out of sleep */
#define READ_SPEED_HZ 1000000

int screen_ask(screen *s, failure *f)
{
    uint8_t answer = 0;
    if (gpio_set(s->dc, false, f) != 0 || spi_write_selected(s->spi, RDDPM, READ_SPEED_HZ, f) != 0 ||
        gpio_set(s->dc, true, f) != 0 || spi_read(s->spi, &answer, 1, READ_SPEED_HZ, f) != 0) {
        return -1;
    }
    if (answer == 0x00 || answer == 0xFF) {
        return fail_with(
            f,
            "the panel does not answer (MISO stays %s): check its power and ground, that SDO is wired to MISO, "
            "and the lines of clock, select, D/C and reset; many panels have no SDO: leave --ask out for them",
            answer == 0 ? "low" : "high");
    }
    if ((answer & RDDPM_AWAKE) == 0) {
        return fail_with(f,
                         "the panel answers, but that it sleeps (power mode 0x%02x): check the reset line, and that "
                         "--controller names the right one",
                         answer);
    }
    return 0;
}

int screen_send(screen *s, const uint8_t *pixels, uint32_t bytes, uint16_t y_px, uint16_t width_px, uint16_t height_px,
                failure *f)
{
    s->failure = f;
    const int result = s->controller->window(s, y_px, width_px, height_px);
    return result != 0 ? result : send_data(s, pixels, bytes);
}

int screen_show(screen *s, failure *f)
{
    s->failure = f;
    const int result = s->controller->show(s);
    return result != 0 || s->backlight == NULL ? result : gpio_set(s->backlight, true, f);
}

int screen_blank(screen *s, failure *f)
{
    const int dark = s->backlight == NULL ? 0 : gpio_set(s->backlight, false, f);
    s->failure = f;
    const int asleep = s->controller->end(s);
    return dark != 0 ? dark : asleep;
}
