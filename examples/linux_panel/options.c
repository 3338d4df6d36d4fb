/* SPDX-License-Identifier: MIT */
#include "options.h"

#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <glint/config.h>
#include <glint/quality.h>

const char options_usage[] =
    "usage: glint-panel [SCENE] --controller st7789|ili9341 --dc LINE [options]\n"
    "\n"
    "Draws a built-in scene (default: teapot; glint-render --list names them) on a panel at SPI and GPIO lines.\n"
    "A LINE is a number on the chip or a name, see gpioinfo. Ctrl-C, or SIGTERM, blanks the panel.\n"
    "\n"
    "  --controller WORD    st7789 or ili9341\n"
    "  --spi DEVICE         default /dev/spidev0.0\n"
    "  --chip CHIP          the GPIO chip of the lines; default gpiochip0\n"
    "  --dc LINE            data or command\n"
    "  --reset LINE         left out: the controller is reset by a command\n"
    "  --backlight LINE     high lights it\n"
    "  --button LINE        up to three, to ground: the first turns the model, the second switches the tolerance (1, "
    "4, 15\n"
    "                       codes, exact), the third turns back. One alone: held for half a second, it switches the\n"
    "                       tolerance. With buttons the model stands still between presses\n"
    "  --buttons-high       the buttons are to the supply, not to ground\n"
    "  --size WxH           pixels of the glass as mounted without rotation; default 240x320\n"
    "  --offset X,Y         its first pixel in the controller's memory, as mounted without rotation; default 0,0\n"
    "  --rotate DEGREES     0, 90, 180, 270: turns the picture clockwise\n"
    "  --speed HZ           clock of the SPI; default 32000000 for the st7789, 10000000 for the ili9341\n"
    "  --tolerance CODES    error allowed to the shading, 0.75..15.9375 codes of 1/255 (default 1), or the word exact\n"
    "  --frames N           ends after N frames and leaves the last; default: goes on until a signal comes\n"
    "  --fps                prints frames a second, and what drawing and sending take\n"
    "  --ask                asks the panel whether it is awake: needs its SDO wired to MISO\n"
    "  --dump FILE.ppm      writes what the panel should show, after each frame\n";

enum {
    OPTION_CONTROLLER = 256,
    OPTION_SPI,
    OPTION_CHIP,
    OPTION_DC,
    OPTION_RESET,
    OPTION_BACKLIGHT,
    OPTION_BUTTON,
    OPTION_BUTTONS_HIGH,
    OPTION_SIZE,
    OPTION_OFFSET,
    OPTION_ROTATE,
    OPTION_SPEED,
    OPTION_TOLERANCE,
    OPTION_FRAMES,
    OPTION_FPS,
    OPTION_ASK,
    OPTION_DUMP,
    OPTION_HELP
};

static const struct option option_table[] = {
    {"controller", required_argument, NULL, OPTION_CONTROLLER},
    {"spi", required_argument, NULL, OPTION_SPI},
    {"chip", required_argument, NULL, OPTION_CHIP},
    {"dc", required_argument, NULL, OPTION_DC},
    {"reset", required_argument, NULL, OPTION_RESET},
    {"backlight", required_argument, NULL, OPTION_BACKLIGHT},
    {"button", required_argument, NULL, OPTION_BUTTON},
    {"buttons-high", no_argument, NULL, OPTION_BUTTONS_HIGH},
    {"size", required_argument, NULL, OPTION_SIZE},
    {"offset", required_argument, NULL, OPTION_OFFSET},
    {"rotate", required_argument, NULL, OPTION_ROTATE},
    {"speed", required_argument, NULL, OPTION_SPEED},
    {"tolerance", required_argument, NULL, OPTION_TOLERANCE},
    {"frames", required_argument, NULL, OPTION_FRAMES},
    {"fps", no_argument, NULL, OPTION_FPS},
    {"ask", no_argument, NULL, OPTION_ASK},
    {"dump", required_argument, NULL, OPTION_DUMP},
    {"help", no_argument, NULL, OPTION_HELP},
    {NULL, 0, NULL, 0},
};

/* Decimal digits at *text up to the character `end`, which is passed over too unless it is the text's end. */
static bool read_number(const char **text, char end, unsigned long least, unsigned long most, unsigned long *out)
{
    char *after;
    if (**text < '0' || **text > '9') {
        return false; /* strtoul() would take a sign or a space */
    }
    errno = 0;
    *out = strtoul(*text, &after, 10);
    if (errno != 0 || *after != end || *out < least || *out > most) {
        return false;
    }
    *text = end == '\0' ? after : after + 1;
    return true;
}

static int parse_number(const char *name, const char *text, unsigned long least, unsigned long most, uint32_t *out,
                        failure *f)
{
    unsigned long number = 0;
    const char *at = text;
    if (!read_number(&at, '\0', least, most, &number)) {
        return fail_with(f, "--%s %s: expected a whole number, %lu..%lu", name, text, least, most);
    }
    *out = (uint32_t)number;
    return 0;
}

/* Two numbers with `between` between them. */
static bool read_pair(const char *text, char between, unsigned long least, uint16_t *first, uint16_t *second)
{
    unsigned long a = 0, b = 0;
    if (!read_number(&text, between, least, GLINT_MAX_SIZE_PX, &a) ||
        !read_number(&text, '\0', least, GLINT_MAX_SIZE_PX, &b)) {
        return false;
    }
    *first = (uint16_t)a;
    *second = (uint16_t)b;
    return true;
}

static int parse_rotation(const char *text, uint8_t *quarter_turns, failure *f)
{
    uint32_t degrees = 0;
    if (parse_number("rotate", text, 0, 270, &degrees, f) != 0 || degrees % 90 != 0) {
        return fail_with(f, "--rotate %s: expected 0, 90, 180 or 270 degrees", text);
    }
    *quarter_turns = (uint8_t)(degrees / 90);
    return 0;
}

#define TOLERANCE_UNITS 16 /* in a code */

static int parse_tolerance(const char *text, uint8_t *out, failure *f)
{
    const double least = (double)GLINT_LEAST_TOLERANCE / TOLERANCE_UNITS, most = (double)UINT8_MAX / TOLERANCE_UNITS;
    char *end;
    if (strcmp(text, "exact") == 0) {
        *out = 0;
        return 0;
    }
    const double codes = strtod(text, &end);
    if (end == text || *end != '\0' || text[strspn(text, "0123456789.")] != '\0' || !(codes >= least) ||
        !(codes <= most)) {
        return fail_with(f, "--tolerance %s: expected codes of 1/255 of a channel, %g..%g, or the word exact", text,
                         least, most);
    }
    *out = (uint8_t)lround(codes * TOLERANCE_UNITS);
    return 0;
}

static int parse_button(const char *text, options *o, failure *f)
{
    if (o->button_count == BUTTONS_MOST) {
        return fail_with(f, "--button %s: there are %d already, more have no meaning", text, BUTTONS_MOST);
    }
    o->buttons[o->button_count++] = text;
    return 0;
}

static int parse_option(int option, const char *value, options *o, failure *f)
{
    switch (option) {
    case OPTION_CONTROLLER:
        o->controller = screen_controller_named(value);
        return o->controller != NULL ? 0 : fail_with(f, "--controller %s: expected st7789 or ili9341", value);
    case OPTION_SPI:
        o->spi = value;
        return 0;
    case OPTION_CHIP:
        o->chip = value;
        return 0;
    case OPTION_DC:
        o->dc = value;
        return 0;
    case OPTION_RESET:
        o->reset = value;
        return 0;
    case OPTION_BACKLIGHT:
        o->backlight = value;
        return 0;
    case OPTION_BUTTON:
        return parse_button(value, o, f);
    case OPTION_BUTTONS_HIGH:
        o->buttons_high = true;
        return 0;
    case OPTION_SIZE:
        return read_pair(value, 'x', 1, &o->glass.width_px, &o->glass.height_px)
                   ? 0
                   : fail_with(f, "--size %s: expected WxH in pixels such as 240x240", value);
    case OPTION_OFFSET:
        return read_pair(value, ',', 0, &o->glass.x_px, &o->glass.y_px)
                   ? 0
                   : fail_with(f, "--offset %s: expected X,Y in pixels such as 0,80", value);
    case OPTION_ROTATE:
        return parse_rotation(value, &o->glass.quarter_turns, f);
    case OPTION_SPEED:
        return parse_number("speed", value, 1000, 200000000, &o->speed_hz, f);
    case OPTION_TOLERANCE:
        return parse_tolerance(value, &o->tolerance, f);
    case OPTION_FRAMES:
        return parse_number("frames", value, 1, UINT32_MAX, &o->frames, f);
    case OPTION_FPS:
        o->fps = true;
        return 0;
    case OPTION_ASK:
        o->ask = true;
        return 0;
    case OPTION_DUMP:
        o->dump = value;
        return 0;
    default:
        o->help = true;
        return 0;
    }
}

/* What can be told only with all of them read. */
static int check(const options *o, failure *f)
{
    if (o->controller == NULL) {
        return fail_with(f, "--controller is missing: st7789 or ili9341");
    }
    if (o->dc == NULL) {
        return fail_with(f, "--dc is missing: the line that is wired to the panel's D/C (also called RS)");
    }
    if (o->glass.x_px + o->glass.width_px > ST7789_MEMORY_WIDTH_PX ||
        o->glass.y_px + o->glass.height_px > ST7789_MEMORY_HEIGHT_PX) {
        return fail_with(
            f,
            "--size and --offset reach beyond the controller's memory, %dx%d; for a picture that lies on its "
            "side give the size as mounted without rotation, and --rotate 90",
            ST7789_MEMORY_WIDTH_PX, ST7789_MEMORY_HEIGHT_PX);
    }
    return 0;
}

int options_parse(int count, char **arguments, options *out, failure *f)
{
    const char *scene = "teapot";
    int option;
    *out = (options){.spi = "/dev/spidev0.0",
                     .chip = "gpiochip0",
                     .glass = {.width_px = ST7789_MEMORY_WIDTH_PX, .height_px = ST7789_MEMORY_HEIGHT_PX},
                     .tolerance = GLINT_CODES(1)};
    opterr = 0;
    optind = 0; /* from the start, with whatever an earlier call left */
    while ((option = getopt_long(count, arguments, ":", option_table, NULL)) != -1) {
        if (option == ':') {
            return fail_with(f, "%s: a value is missing", arguments[optind - 1]);
        }
        if (option == '?') {
            return fail_with(f, "%s: no such option", arguments[optind - 1]);
        }
        if (parse_option(option, optarg, out, f) != 0) {
            return -1;
        }
    }
    if (out->help) {
        return 0;
    }
    if (optind < count) {
        scene = arguments[optind++];
    }
    if (optind < count) {
        return fail_with(f, "%s: only one scene is drawn", arguments[optind]);
    }
    out->demo = demo_scene_named(scene);
    if (out->demo == NULL) {
        return fail_with(f, "%s: no built-in scene of this name (glint-render --list names them)", scene);
    }
    if (check(out, f) != 0) {
        return -1;
    }
    if (out->speed_hz == 0) {
        out->speed_hz = screen_default_speed_hz(out->controller);
    }
    return 0;
}
