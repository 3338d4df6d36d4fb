/* SPDX-License-Identifier: MIT */
/*
 * The command line of glint-render. Each option is one row of a table: its name, what it takes, and the function that
 * reads it. An option that the chosen backend would have to ignore is refused, so that a picture is never taken for
 * something that it is not.
 */
#include "options.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include <glint/config.h>
#include <glint/display.h>
#include <glint/quality.h>

#include "without.h"

const char options_usage[] =
    "usage: glint-render SCENE -o FILE.ppm [options]\n"
    "       glint-render SCENE --explain [options]\n"
    "       glint-render --list\n"
    "\n"
    "SCENE is a built-in scene (--list names them) or a model file (.obj, .gltf, .glb, .dae).\n"
    "The picture shows what the display would: pixels are drawn in its format and read back.\n"
    "\n"
    "  -o FILE            the picture, PPM; PNG when FILE ends in .png\n"
    "  --backend WORD     fixed (default), float, or reference (double precision, the tests' yardstick)\n"
    "  --tolerance CODES  shades each triangle as cheaply as this error allows, in codes of 1/255 of a channel,\n"
    "                     0.75..15.9375, to the nearest 1/16 (default: 1)\n"
    "  --shading WORD     shades every triangle in this way: exact, q2, q1, gouraud, flat\n"
    "  --size WxH         pixels, each 1..2048 (default: the scene's own size; 320x240 for a file)\n"
    "  --format WORD      rgb888 (default), rgb565, gray8, gray4, mono\n"
    "  --dither WORD      none (default), bayer\n"
    "  --band ROWS        rows in a band, 1..2048 (default: the whole frame)\n"
    "  --buffers N        1 (default), or 2: a band is drawn while the one before is sent\n"
    "  --memory BYTES     working memory (default: as much as the library can make use of)\n"
    "  --turn DEGREES     turns the objects about the vertical\n"
    "  --without WORDS    draws the scene without effects that it has, named with commas between:\n"
    "                     " WITHOUT_NAMES_1 "\n"
    "                     " WITHOUT_NAMES_2 "\n"
    "  --report FILE      counts of the frame, as JSON\n"
    "  --explain          prints which terms of the model each object needs under each light, why not the others,\n"
    "                     and what was evaluated; -o may be left out with it\n"
    "  --tiers FILE       how each pixel was shaded, PPM or PNG: unlit dark grey, flat light grey, gouraud blue,\n"
    "                     curved cyan, q1 green, q2 yellow, exact red; background black\n"
    "  --promise FILE     the error promised for each pixel, PGM or PNG: 1/16 code a level of grey, rounded up;\n"
    "                     white: 15.9375 codes or more, or none promised; background black\n"
    "  --edges FILE.pgm   contested pixels, for glint-compare --apart (reference only)\n"
    "\n"
    "The reference is always exact unless --shading says gouraud or flat: tolerances are held against it.\n";

/* ----------------------------------------------------------------------------------------------------------- messages
 */

typedef struct message {
    char *text;
    size_t bytes;
} message;

/* Always -1, so that a parser can return it. */
static int fail(const message *m, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(m->text, m->bytes, format, arguments);
    va_end(arguments);
    return -1;
}

/* -------------------------------------------------------------------------------------------------------------- words
 */

typedef struct word {
    const char *text;
    uint8_t value;
} word;

/* Each list ends with a NULL text. The first word is the default. */
static const word backend_words[] = {
    {"fixed", BACKEND_FIXED}, {"float", BACKEND_FLOAT}, {"reference", BACKEND_REFERENCE}, {NULL, 0}};
static const word shading_words[] = {{"exact", GLINT_SHADING_EXACT}, {"q2", GLINT_SHADING_Q2},
                                     {"q1", GLINT_SHADING_Q1},       {"gouraud", GLINT_SHADING_GOURAUD},
                                     {"flat", GLINT_SHADING_FLAT},   {NULL, 0}};
static const word tier_words[] = {{"unlit", GLINT_TIER_UNLIT},     {"flat", GLINT_TIER_FLAT},
                                  {"gouraud", GLINT_TIER_GOURAUD}, {"curved", GLINT_TIER_CURVED},
                                  {"q1", GLINT_TIER_Q1},           {"q2", GLINT_TIER_Q2},
                                  {"exact", GLINT_TIER_EXACT},     {NULL, 0}};
static const word format_words[] = {{"rgb888", GLINT_RGB888}, {"rgb565", GLINT_RGB565},   {"gray8", GLINT_GREY8},
                                    {"gray4", GLINT_GREY4},   {"mono", GLINT_MONO_PAGES}, {NULL, 0}};
static const word dither_words[] = {{"none", GLINT_DITHER_NONE}, {"bayer", GLINT_DITHER_BAYER}, {NULL, 0}};

static const char *word_of(const word *words, int value)
{
    for (; words->text != NULL; words++) {
        if (words->value == value) {
            return words->text;
        }
    }
    return "unknown";
}

const char *options_backend_word(int backend)
{
    return word_of(backend_words, backend);
}

const char *options_shading_word(uint8_t shading)
{
    return word_of(shading_words, shading);
}

const char *options_tier_word(uint8_t tier)
{
    return word_of(tier_words, tier);
}

const char *options_format_word(uint8_t format)
{
    return word_of(format_words, format);
}

const char *options_dither_word(uint8_t dither)
{
    return word_of(dither_words, dither);
}

static int parse_word(const word *words, const char *option, const char *text, uint8_t *out, const message *m)
{
    char expected[128] = "";
    for (const word *w = words; w->text != NULL; w++) {
        if (strcmp(w->text, text) == 0) {
            *out = w->value;
            return 0;
        }
        const size_t used = strlen(expected);
        (void)snprintf(expected + used, sizeof expected - used, "%s%s", used == 0 ? "" : ", ", w->text);
    }
    return fail(m, "%s %s: expected one of %s", option, text, expected);
}

/* ------------------------------------------------------------------------------------------------------------ numbers
 */

/* Reads decimal digits at *text and moves past them. Returns false when there are none or the value is above `most`. */
static bool read_number(const char **text, unsigned long most, unsigned long *out)
{
    char *end;
    if (**text < '0' || **text > '9') {
        return false; /* strtoul() would take a sign or a space */
    }
    errno = 0;
    *out = strtoul(*text, &end, 10);
    *text = end;
    return errno == 0 && *out <= most;
}

static int parse_number(const char *option, const char *text, unsigned long least, unsigned long most,
                        unsigned long *out, const message *m)
{
    const char *at = text;
    if (!read_number(&at, most, out) || *at != '\0' || *out < least) {
        return fail(m, "%s %s: expected a whole number, %lu..%lu", option, text, least, most);
    }
    return 0;
}

static int parse_size(const char *option, const char *text, options *o, const message *m)
{
    const char *at = text;
    unsigned long width = 0, height = 0;
    const bool good = read_number(&at, GLINT_MAX_SIZE_PX, &width) && *at++ == 'x' &&
                      read_number(&at, GLINT_MAX_SIZE_PX, &height) && *at == '\0' && width > 0 && height > 0;
    if (!good) {
        return fail(m, "%s %s: expected WxH in pixels such as 320x240, each 1..%d", option, text, GLINT_MAX_SIZE_PX);
    }
    o->width_px = (uint16_t)width;
    o->height_px = (uint16_t)height;
    return 0;
}

#define MAX_TURN_DEGREES 1e6

static int parse_turn(const char *option, const char *text, options *o, const message *m)
{
    char *end;
    const double degrees = strtod(text, &end);
    if (end == text || *end != '\0' || !(fabs(degrees) <= MAX_TURN_DEGREES)) {
        return fail(m, "%s %s: expected an angle in degrees such as 30 or -7.5", option, text);
    }
    const double turns = degrees / 360;
    /* In 0..65536 after rounding; 65536 is a whole turn, 0. */
    o->turn16 = (uint16_t)((uint32_t)lround((turns - floor(turns)) * 65536) & 65535u);
    return 0;
}

#define TOLERANCE_UNITS 16 /* in a code */
#define DEFAULT_TOLERANCE (1 * TOLERANCE_UNITS)

static int parse_tolerance(const char *option, const char *text, options *o, const message *m)
{
    const double least = (double)GLINT_LEAST_TOLERANCE / TOLERANCE_UNITS, most = (double)UINT8_MAX / TOLERANCE_UNITS;
    char *end;
    const double codes = strtod(text, &end);
    /* of what strtod() takes, decimals only: no sign, no exponent, no words */
    if (end == text || text[strspn(text, "0123456789.")] != '\0' || *end != '\0' || codes < least || codes > most) {
        return fail(m, "%s %s: expected codes of 1/255 of a channel such as 1 or 2.5, %g..%g", option, text, least,
                    most);
    }
    o->tolerance = (uint8_t)lround(codes * TOLERANCE_UNITS);
    return 0;
}

/* Whether the name of a file has an ending, and another than those of a list that NULL ends. */
static bool has_other_ending(const char *path, const char *const *endings)
{
    const char *slash = strrchr(path, '/');
    const char *dot = strrchr(slash == NULL ? path : slash, '.');
    if (dot == NULL) {
        return false;
    }
    for (; *endings != NULL; endings++) {
        if (strcasecmp(dot, *endings) == 0) {
            return false;
        }
    }
    return true;
}

bool options_is_png(const char *path)
{
    static const char ending[] = ".png";
    const size_t length = strlen(path), of_ending = sizeof ending - 1;
    return length >= of_ending && strcasecmp(path + length - of_ending, ending) == 0;
}

static int parse_path(const char *option, const char *text, const char *const *endings, const char *expected,
                      const char **out, const message *m)
{
    if (*text == '\0' || has_other_ending(text, endings)) {
        return fail(m, "%s %s: expected a file name that ends in %s", option, text, expected);
    }
    *out = text;
    return 0;
}

/* ------------------------------------------------------------------------------------------------------------ options
 */

enum {
    OPTION_OUTPUT,
    OPTION_BACKEND,
    OPTION_TOLERANCE,
    OPTION_SHADING,
    OPTION_SIZE,
    OPTION_FORMAT,
    OPTION_DITHER,
    OPTION_BAND,
    OPTION_BUFFERS,
    OPTION_MEMORY,
    OPTION_TURN,
    OPTION_WITHOUT,
    OPTION_REPORT,
    OPTION_EXPLAIN,
    OPTION_TIERS,
    OPTION_PROMISE,
    OPTION_EDGES,
    OPTION_LIST,
    OPTION_HELP,
    OPTION_COUNT
};

static const struct {
    const char *name, *value; /* value: what it takes, NULL for nothing */
} option_table[OPTION_COUNT] = {
    [OPTION_OUTPUT] = {"-o", "a file name"},
    [OPTION_BACKEND] = {"--backend", "fixed, float or reference"},
    [OPTION_TOLERANCE] = {"--tolerance", "a number of codes"},
    [OPTION_SHADING] = {"--shading", "exact, q2, q1, gouraud or flat"},
    [OPTION_SIZE] = {"--size", "WxH in pixels"},
    [OPTION_FORMAT] = {"--format", "rgb888, rgb565, gray8, gray4 or mono"},
    [OPTION_DITHER] = {"--dither", "none or bayer"},
    [OPTION_BAND] = {"--band", "a number of rows"},
    [OPTION_BUFFERS] = {"--buffers", "1 or 2"},
    [OPTION_MEMORY] = {"--memory", "a number of bytes"},
    [OPTION_TURN] = {"--turn", "an angle in degrees"},
    [OPTION_WITHOUT] = {"--without", "names of effects"},
    [OPTION_REPORT] = {"--report", "a file name"},
    [OPTION_EXPLAIN] = {"--explain", NULL},
    [OPTION_TIERS] = {"--tiers", "a file name"},
    [OPTION_PROMISE] = {"--promise", "a file name"},
    [OPTION_EDGES] = {"--edges", "a file name"},
    [OPTION_LIST] = {"--list", NULL},
    [OPTION_HELP] = {"--help", NULL},
};

#define MAX_MEMORY_BYTES 0x40000000ul

static int parse_option(int option, const char *value, options *o, const message *m)
{
    static const char *const picture_endings[] = {".ppm", ".png", NULL};
    static const char *const grey_endings[] = {".pgm", ".png", NULL};
    static const char *const report_endings[] = {".json", NULL};
    static const char *const edges_endings[] = {".pgm", NULL};
    const char *name = option_table[option].name;
    unsigned long number = 0;
    uint8_t backend = BACKEND_FIXED;
    int result = 0;

    switch (option) {
    case OPTION_OUTPUT:
        return parse_path(name, value, picture_endings, ".ppm or .png", &o->output, m);
    case OPTION_BACKEND:
        result = parse_word(backend_words, name, value, &backend, m);
        o->backend = backend;
        return result;
    case OPTION_TOLERANCE:
        return parse_tolerance(name, value, o, m);
    case OPTION_SHADING:
        return parse_word(shading_words, name, value, &o->shading, m);
    case OPTION_SIZE:
        return parse_size(name, value, o, m);
    case OPTION_FORMAT:
        return parse_word(format_words, name, value, &o->format, m);
    case OPTION_DITHER:
        return parse_word(dither_words, name, value, &o->dither, m);
    case OPTION_BAND:
        result = parse_number(name, value, 1, GLINT_MAX_SIZE_PX, &number, m);
        o->band_px = (uint16_t)number;
        return result;
    case OPTION_BUFFERS:
        result = parse_number(name, value, 1, 2, &number, m);
        o->buffer_count = (uint8_t)number;
        return result;
    case OPTION_MEMORY:
        result = parse_number(name, value, 1, MAX_MEMORY_BYTES, &number, m);
        o->memory_bytes = (size_t)number;
        return result;
    case OPTION_TURN:
        return parse_turn(name, value, o, m);
    case OPTION_WITHOUT:
        return without_parse(value, &o->without, m->text, m->bytes);
    case OPTION_REPORT:
        return parse_path(name, value, report_endings, ".json", &o->report, m);
    case OPTION_TIERS:
        return parse_path(name, value, picture_endings, ".ppm or .png", &o->tiers, m);
    case OPTION_PROMISE:
        return parse_path(name, value, grey_endings, ".pgm or .png", &o->promise, m);
    case OPTION_EDGES:
        return parse_path(name, value, edges_endings, ".pgm", &o->edges, m);
    case OPTION_EXPLAIN:
        o->explain = true;
        return 0;
    case OPTION_LIST:
        o->list = true;
        return 0;
    default:
        o->help = true;
        return 0;
    }
}

static int find_option(const char *argument)
{
    int option = 0;
    while (option < OPTION_COUNT && strcmp(option_table[option].name, argument) != 0) {
        option++;
    }
    return option;
}

static bool same_file(const char *a, const char *b)
{
    return a != NULL && b != NULL && strcmp(a, b) == 0;
}

/* given: which options were on the command line. */
static int check_together(const options *o, const bool *given, const message *m)
{
    static const int display_only[] = {OPTION_DITHER,  OPTION_BAND,  OPTION_BUFFERS, OPTION_MEMORY,   OPTION_REPORT,
                                       OPTION_EXPLAIN, OPTION_TIERS, OPTION_PROMISE, OPTION_TOLERANCE};

    if (o->scene == NULL) {
        return fail(m, "expected a scene: the name of a built-in one (--list has them) or a model file");
    }
    if (o->output == NULL && !o->explain) {
        return fail(m, "expected -o FILE.ppm, the picture to write");
    }
    if (given[OPTION_SHADING] && given[OPTION_TOLERANCE]) {
        return fail(m, "--tolerance lets the library choose each triangle's shading: expected no --shading with it");
    }
    if (same_file(o->output, o->tiers) || same_file(o->output, o->promise) || same_file(o->tiers, o->promise)) {
        return fail(m, "-o, --tiers, --promise: expected another file for each");
    }
    if (o->backend != BACKEND_REFERENCE) {
        if (o->edges != NULL) {
            return fail(m, "--edges is what the reference finds: expected --backend reference with it");
        }
        return 0;
    }
    if (o->format != GLINT_RGB888) {
        return fail(m, "--backend reference draws for no display: expected --format rgb888 or no --format");
    }
    if (o->shading == GLINT_SHADING_Q1 || o->shading == GLINT_SHADING_Q2) {
        return fail(m, "--backend reference approximates nothing: expected --shading exact, gouraud or flat with it");
    }
    for (size_t i = 0; i < sizeof display_only / sizeof display_only[0]; i++) {
        if (given[display_only[i]]) {
            return fail(m, "--backend reference draws the whole picture in double precision: expected no %s with it",
                        option_table[display_only[i]].name);
        }
    }
    return 0;
}

int options_parse(int count, char **arguments, options *out, char *error, size_t error_bytes)
{
    const message m = {error, error_bytes};
    bool given[OPTION_COUNT] = {false};

    *out = (options){.buffer_count = 1};
    for (int i = 1; i < count; i++) {
        const char *argument = arguments[i], *value = "";
        if (argument[0] != '-' || argument[1] == '\0') {
            if (out->scene != NULL) {
                return fail(&m, "%s: expected one scene, and %s is one already", argument, out->scene);
            }
            out->scene = argument;
            continue;
        }
        const int option = find_option(argument);
        if (option == OPTION_COUNT) {
            return fail(&m, "%s: no such option; --help lists them", argument);
        }
        if (given[option]) {
            return fail(&m, "%s: expected it once", argument);
        }
        given[option] = true;
        if (option_table[option].value != NULL) {
            if (i + 1 == count) {
                return fail(&m, "%s: expected %s after it", argument, option_table[option].value);
            }
            value = arguments[++i];
        }
        if (parse_option(option, value, out, &m) != 0) {
            return -1;
        }
    }
    if (out->help) {
        return 0;
    }
    if (out->list) {
        return count == 2 ? 0 : fail(&m, "--list: expected nothing else with it");
    }
    if (!given[OPTION_TOLERANCE] && !given[OPTION_SHADING] && out->backend != BACKEND_REFERENCE) {
        out->tolerance = DEFAULT_TOLERANCE;
    }
    return check_together(out, given, &m);
}

int options_check_height(const options *o, uint16_t height_px, char *error, size_t error_bytes)
{
    const message m = {error, error_bytes};
    if (o->format == GLINT_MONO_PAGES && o->band_px < height_px && o->band_px % 8 != 0) {
        return fail(&m, "--band %u: expected a multiple of 8 with --format mono, whose bytes hold 8 rows",
                    (unsigned)o->band_px);
    }
    return 0;
}
