/* SPDX-License-Identifier: MIT */
/*
 * glint-panel-decode: reads what a driver sent to a panel (a stream of events as tests/panel/panel.h defines it) from
 * stdin, writes the picture that the panel shows, and prints all that its data sheet forbids.
 */
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/panel/panel.h"
#include "tools/picture/picture.h"

static const char usage[] =
    "usage: glint-panel-decode --controller st7789|ili9341|ssd0323|ssd1306 --size WxH [options] < events\n"
    "  --offset X,Y     where in the controller's memory the glass begins (0,0)\n"
    "  --glass WORDS    how the glass is wired, instead of what is usual for the controller: of rgb or bgr, normal or\n"
    "                   inverted, with commas between\n"
    "  --turned D       turn the picture as the panel is mounted: 90, 180 or 270 degrees clockwise\n"
    "  -o FILE          write the picture: .ppm, or .png where libpng was there\n"
    "  --frame N        the picture when N frames have been sent, counted at the last pixel of the glass\n"
    "  --at NS          the picture at this time; without these two: at the end\n"
    "Prints violations, then the frames and bytes sent. Status 0, 1 with violations, 2 for wrong arguments or input.\n";

typedef struct options {
    int kind;
    unsigned width_px, height_px;
    panel_glass glass;
    unsigned turned;
    const char *output;
    uint32_t frame; /* 0: none */
    bool has_at;
    uint64_t at_ns;
} options;

__attribute__((noreturn)) static void fail(const char *what, const char *which)
{
    (void)fprintf(stderr, "glint-panel-decode: %s%s%s\n", what, which ? ": " : "", which ? which : "");
    exit(2);
}

static int kind_named(const char *name)
{
    static const char *const names[] = {[PANEL_ST7789] = "st7789",
                                        [PANEL_ILI9341] = "ili9341",
                                        [PANEL_SSD0323] = "ssd0323",
                                        [PANEL_SSD1306] = "ssd1306"};
    for (int i = 0; i <= PANEL_SSD1306; i++) {
        if (strcmp(name, names[i]) == 0) {
            return i;
        }
    }
    fail("unknown controller", name);
}

static uint64_t number(const char *text, uint64_t most)
{
    char *end = NULL;
    errno = 0;
    const unsigned long long value = strtoull(text, &end, 10);
    if (text[0] < '0' || text[0] > '9' || *end != '\0' || errno != 0 || value > most) {
        fail("not a number in range", text);
    }
    return value;
}

/* "12x34" or "12,34" */
static void pair(const char *text, char between, unsigned *first, unsigned *second)
{
    char a[8], b[8];
    const char *middle = strchr(text, between);
    if (middle == NULL || (size_t)(middle - text) >= sizeof a || strlen(middle + 1) >= sizeof b) {
        fail("not two numbers", text);
    }
    memcpy(a, text, (size_t)(middle - text));
    a[middle - text] = '\0';
    memcpy(b, middle + 1, strlen(middle + 1) + 1);
    *first = (unsigned)number(a, 65535);
    *second = (unsigned)number(b, 65535);
}

static void wire_glass(panel_glass *glass, const char *words)
{
    char copy[64];
    if (strlen(words) >= sizeof copy) {
        fail("unknown glass", words);
    }
    memcpy(copy, words, strlen(words) + 1);
    for (const char *word = strtok(copy, ","); word; word = strtok(NULL, ",")) {
        if (strcmp(word, "rgb") == 0 || strcmp(word, "bgr") == 0) {
            glass->bgr = word[0] == 'b';
        } else if (strcmp(word, "normal") == 0 || strcmp(word, "inverted") == 0) {
            glass->inverted = word[0] == 'i';
        } else {
            fail("unknown glass", word);
        }
    }
}

static options parse(int count, char **arguments)
{
    options o = {.kind = -1};
    unsigned x = 0, y = 0;
    const char *glass = NULL;
    for (int i = 1; i < count; i++) {
        const char *name = arguments[i];
        if (strcmp(name, "--help") == 0) {
            (void)fputs(usage, stdout);
            exit(0);
        }
        const char *value = i + 1 < count ? arguments[++i] : NULL;
        if (value == NULL) {
            fail("unknown option, or no value for it", name);
        } else if (strcmp(name, "--controller") == 0) {
            o.kind = kind_named(value);
        } else if (strcmp(name, "--size") == 0) {
            pair(value, 'x', &o.width_px, &o.height_px);
        } else if (strcmp(name, "--offset") == 0) {
            pair(value, ',', &x, &y);
        } else if (strcmp(name, "--glass") == 0) {
            glass = value;
        } else if (strcmp(name, "--turned") == 0) {
            o.turned = (unsigned)number(value, 270);
        } else if (strcmp(name, "-o") == 0) {
            o.output = value;
        } else if (strcmp(name, "--frame") == 0) {
            o.frame = (uint32_t)number(value, UINT32_MAX);
        } else if (strcmp(name, "--at") == 0) {
            o.has_at = true;
            o.at_ns = number(value, UINT64_MAX);
        } else {
            fail("unknown option", name);
        }
    }
    if (o.kind < 0 || o.width_px == 0 || o.turned % 90 != 0) {
        (void)fputs(usage, stderr);
        exit(2);
    }
    o.glass = panel_usual_glass((enum panel_kind)o.kind);
    o.glass.x_px = (uint16_t)x;
    o.glass.y_px = (uint16_t)y;
    if (glass) {
        wire_glass(&o.glass, glass);
    }
    return o;
}

/* The pixel (x, y) of the picture turned clockwise, from one that is width x height. */
static const uint8_t *turned_pixel(const uint8_t *rgb, const options *o, unsigned x, unsigned y)
{
    const unsigned width = o->width_px, height = o->height_px;
    unsigned from_x = x, from_y = y;
    if (o->turned == 90) {
        from_x = y;
        from_y = height - 1 - x;
    } else if (o->turned == 180) {
        from_x = width - 1 - x;
        from_y = height - 1 - y;
    } else if (o->turned == 270) {
        from_x = width - 1 - y;
        from_y = x;
    }
    return rgb + ((size_t)from_y * width + from_x) * 3;
}

static void keep_picture(panel *p, const options *o, uint8_t *kept)
{
    const uint8_t *rgb = panel_picture(p);
    const bool lies = o->turned % 180 != 0;
    const unsigned width = lies ? o->height_px : o->width_px, height = lies ? o->width_px : o->height_px;
    for (unsigned y = 0; y < height; y++) {
        for (unsigned x = 0; x < width; x++, kept += 3) {
            memcpy(kept, turned_pixel(rgb, o, x, y), 3);
        }
    }
}

/* Whether the picture asked for is the one before this line's event. */
static bool is_due(const panel *p, const options *o, const char *line)
{
    if (o->frame) {
        return panel_frames(p) >= o->frame;
    }
    return o->has_at && line[0] >= '0' && line[0] <= '9' && strtoull(line, NULL, 10) > o->at_ns;
}

static void read_events(panel *p, const options *o, uint8_t *kept)
{
    char line[128];
    unsigned long number_of_line = 0;
    uint64_t ns = 0;
    bool have = false;
    while (fgets(line, (int)sizeof line, stdin)) {
        number_of_line++;
        line[strcspn(line, "\n")] = '\0';
        if (!have && is_due(p, o, line)) {
            keep_picture(p, o, kept);
            have = true;
        }
        if (!panel_event(p, line)) {
            (void)fprintf(stderr, "glint-panel-decode: line %lu is no event: %s\n", number_of_line, line);
            exit(2);
        }
        if (line[0] >= '0' && line[0] <= '9') {
            ns = strtoull(line, NULL, 10);
        }
    }
    panel_end(p, ns);
    if (o->frame > panel_frames(p)) {
        (void)fprintf(stderr, "glint-panel-decode: %lu frames were sent, not %lu\n", (unsigned long)panel_frames(p),
                      (unsigned long)o->frame);
        exit(2);
    }
    if (!have) {
        keep_picture(p, o, kept);
    }
}

int main(int count, char **arguments)
{
    const options o = parse(count, arguments);
    panel *p = panel_open((enum panel_kind)o.kind, (uint16_t)o.width_px, (uint16_t)o.height_px);
    if (p == NULL) {
        fail("the glass is larger than the controller's memory", NULL);
    }
    panel_set_glass(p, &o.glass);
    picture out;
    char error[256];
    const bool lies = o.turned % 180 != 0;
    if (picture_create(&out, (int)(lies ? o.height_px : o.width_px), (int)(lies ? o.width_px : o.height_px), error,
                       sizeof error)) {
        fail(error, NULL);
    }
    read_events(p, &o, out.rgb);
    if (o.output && picture_write(o.output, &out, error, sizeof error)) {
        fail(error, NULL);
    }
    for (size_t i = 0; i < panel_violations(p) && i < 1000; i++) {
        printf("violation %s\n", panel_violation(p, i));
    }
    printf("violations %lu\nframes %lu\nbytes %llu\n", (unsigned long)panel_violations(p),
           (unsigned long)panel_frames(p), (unsigned long long)panel_bytes(p));
    const int status = panel_violations(p) ? 1 : 0;
    picture_free(&out);
    panel_close(p);
    return status;
}
