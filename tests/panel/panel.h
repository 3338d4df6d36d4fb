/* SPDX-License-Identifier: MIT */
/*
 * A panel as its data sheet describes it: listens to what a driver sends, with the times, keeps the controller's
 * memory, shows what a person would see on the glass, and tells of everything that the data sheet forbids. Written from
 * the data sheets (named in the files of the controllers); shares no code with the drivers.
 *
 *     panel *p = panel_open(PANEL_ST7789, 240, 240);
 *     panel_line(p, 0, PANEL_RESET, false); ...             or panel_byte(), panel_i2c_*(), or panel_event() with a
 * text panel_end(p, now_ns); for (size_t i = 0; i < panel_violations(p); i++) puts(panel_violation(p, i)); const
 * uint8_t *rgb = panel_picture(p); panel_close(p);
 *
 * Times are in ns and never go back. Lines before their first event: reset high (a power-on reset is long over), select
 * high, but low as soon as bytes come without any event of select; clock, data, D/C and backlight low.
 */
#ifndef TESTS_PANEL_PANEL_H
#define TESTS_PANEL_PANEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct panel panel;

enum panel_kind { PANEL_ST7789, PANEL_ILI9341, PANEL_SSD0323, PANEL_SSD1306 };
enum panel_signal { PANEL_SCK, PANEL_MOSI, PANEL_CS, PANEL_DC, PANEL_RESET, PANEL_BACKLIGHT };

/*
 * How the glass is wired to the controller, which differs between modules. panel_open() takes what is usual:
 *   ST7789   RGB, inverted: an IPS panel, whose colours are right with INVON
 *   ILI9341  BGR, not inverted: its colours are right with the BGR bit of MADCTL
 *   SSD0323  the EK-LM3S6965 board's: upright with COM remap, COM split and a display offset of 76
 *   SSD1306  upright with segment remap (A1) and COM scan from the end (C8), as nearly every module
 */
typedef struct panel_glass {
    uint16_t x_px, y_px;   /* where in the controller's memory the glass begins, as written without rotation */
    bool bgr;              /* colour filters in the order blue, green, red */
    bool inverted;         /* dark where the controller drives light */
    bool columns_reversed; /* OLEDs: upright only with the column or segment remap */
    bool rows_reversed;    /* OLEDs: upright only with the COM scan direction reversed */
    uint8_t row_offset;    /* OLEDs: upright only with this display offset */
} panel_glass;

/* A panel of `width_px` x `height_px` as it is mounted without rotation. NULL without memory, or if the controller's
 * own is smaller: 240x320, 128x80, 128x64. */
panel *panel_open(enum panel_kind kind, uint16_t width_px, uint16_t height_px);
void panel_close(panel *p); /* NULL is fine */

panel_glass panel_usual_glass(enum panel_kind kind);
void panel_set_glass(panel *p, const panel_glass *glass);

/* A line's new level. */
void panel_line(panel *p, uint64_t ns, enum panel_signal signal, bool level);

/* A whole byte at the present levels of select and D/C, from transports that show no clock: its speed is not judged. */
void panel_byte(panel *p, uint64_t ns, uint8_t byte);

/* I2C (SSD1306): conditions and bytes; the first byte after a start is the address. */
void panel_i2c_start(panel *p, uint64_t ns);
void panel_i2c_byte(panel *p, uint64_t ns, uint8_t byte);
void panel_i2c_stop(panel *p, uint64_t ns);

/*
 * One line of an event stream, without its newline; empty lines and those that begin with # are passed over:
 *     <ns> sck|mosi|cs|dc|reset|backlight 0|1
 *     <ns> byte <hex>
 *     <ns> i2c start|stop|<hex>
 * Returns false, and does nothing, if it is none of these.
 */
bool panel_event(panel *p, const char *line);

/* No more events: what is then unfinished is told of. */
void panel_end(panel *p, uint64_t ns);

/* What was forbidden, in order; a text is "<ns>: what". At most 1000 are kept, all are counted. */
size_t panel_violations(const panel *p);
const char *panel_violation(const panel *p, size_t number);

/*
 * What is seen on the glass now: RGB888, width_px x height_px of panel_open(), black while the display is off, asleep
 * or (once a backlight event came) without backlight. A rotation by MADCTL shows as on the glass: the picture lies on
 * its side until the panel is turned. Valid until the next call.
 */
const uint8_t *panel_picture(panel *p);

/* Writes of pixels that ended on the last of the glass (bottom right as the driver counts): frames sent. */
uint32_t panel_frames(const panel *p);

/* Bytes that the controller took: commands and their arguments, and pixels. */
uint64_t panel_bytes(const panel *p);

#endif
