/* SPDX-License-Identifier: MIT */
/*
 * What the parts of the panel model share: the bus in front (panel.c) hands whole bytes with their D/C to one of the
 * controllers behind (dcs.c for ST7789 and ILI9341, oled.c for SSD0323 and SSD1306).
 */
#ifndef TESTS_PANEL_INTERNAL_H
#define TESTS_PANEL_INTERNAL_H

#include "tests/panel/panel.h"

#define PANEL_US UINT64_C(1000)
#define PANEL_MS UINT64_C(1000000)

/* A command of a data sheet. */
typedef struct panel_command {
    uint8_t code;
    uint8_t arguments_least, arguments_most; /* 255 at most: it reads, whatever is clocked meanwhile */
    const char *name;                        /* with a "?" in front: what it shows is not modelled */
} panel_command;

/* Limits of a controller's serial interface, from the table of AC characteristics. */
typedef struct panel_limits {
    uint32_t clock_cycle_ns, clock_high_ns, clock_low_ns;
    uint64_t reset_pulse_ns; /* RESX low at least */
    uint64_t after_reset_ns; /* from its rise to the first command */
} panel_limits;

/* State of an ST7789 or ILI9341 (MIPI DCS). */
typedef struct dcs_state {
    uint8_t command;
    const panel_command *known; /* NULL before the first, and after an unknown one */
    uint8_t argument[16];
    uint32_t argument_count;
    uint8_t madctl, colmod;
    uint16_t x_first, x_last, y_first, y_last; /* CASET, RASET */
    uint32_t filled, window;                   /* pixels written of the window that RAMWR opened */
    bool overrun;                              /* told of in this write */
    uint32_t bits;                             /* of a pixel not complete yet, the last in the low bits */
    uint8_t bit_count;
    bool awake, on, inverted;
    uint64_t sleep_changed_ns; /* no SLPIN, SLPOUT or SWRESET before */
    const char *sleep_why;
    uint8_t memory[320][240][3];
} dcs_state;

/* State of an SSD0323 or SSD1306. */
typedef struct oled_state {
    const panel_command *known;
    uint8_t argument[8];
    uint8_t command, argument_count;
    uint8_t column_first, column_last, row_first, row_last, column, row; /* row: a page of the SSD1306 */
    uint32_t written;                                                    /* bytes since the window was set */
    uint8_t mode;                                                        /* SSD1306: 0 rows, 1 columns, 2 page */
    bool by_columns;
    bool columns_reversed, rows_reversed, split, nibbles_swapped;
    uint8_t start_line, offset, multiplex;
    uint8_t show; /* SHOW_... */
    bool inverted, on;
    uint8_t memory[80][128]; /* SSD0323: two pixels a byte in 64 columns; SSD1306: 8 pages */
} oled_state;

struct panel {
    enum panel_kind kind;
    uint16_t width_px, height_px;
    panel_glass glass;
    const panel_limits *limits;

    uint64_t now_ns;
    bool level[PANEL_BACKLIGHT + 1], seen[PANEL_BACKLIGHT + 1];
    uint64_t reset_fell_ns, sck_rose_ns, sck_fell_ns;
    bool sck_rose, sck_told; /* since select fell */
    uint8_t bits, bit_count;
    uint64_t ready_ns; /* no byte before */
    const char *ready_why;

    enum { I2C_IDLE, I2C_ADDRESS, I2C_CONTROL, I2C_ONE, I2C_REST, I2C_OTHER } i2c;
    bool i2c_dc;
    uint64_t i2c_byte_ns;
    bool i2c_timed; /* a byte came since the start */

    union {
        dcs_state dcs;
        oled_state oled;
    } state;
    uint32_t frames;
    uint64_t bytes;
    uint8_t *rgb;
    char **violation;
    size_t violation_count, violation_kept;
};

/* Adds "<now>: text" to the violations. */
void panel_violate(panel *p, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The command with this code in a table that ends with a NULL name; NULL if there is none. */
const panel_command *panel_find(const panel_command *table, uint8_t code);
const char *panel_name(const panel_command *command); /* without its "?" */

extern const panel_limits panel_limits_st7789, panel_limits_ili9341, panel_limits_ssd0323, panel_limits_ssd1306;
extern const panel_command panel_commands_st7789[], panel_commands_ili9341[], panel_commands_ssd0323[],
    panel_commands_ssd1306[];

void dcs_reset(panel *p);
void dcs_byte(panel *p, bool dc, uint8_t byte);
void dcs_end(panel *p);
bool dcs_reading(const panel *p);
void dcs_picture(const panel *p, uint8_t *rgb);

void oled_reset(panel *p);
void oled_byte(panel *p, bool dc, uint8_t byte);
void oled_end(panel *p);
void oled_picture(const panel *p, uint8_t *rgb);

#endif
