/* SPDX-License-Identifier: MIT */
/*
 * A board for the tests of glint-panel: a GPIO chip of eight lines, an SPI device with a panel model behind it, buttons
 * that are pressed by a script. It stands behind libgpiod (fake_gpiod_v1.c, fake_gpiod_v2.c) and behind the calls of
 * the system (fake_system.c), which the linker puts in the place of the real ones (--wrap), and can refuse each of
 * them.
 */
#ifndef TESTS_LINUX_PANEL_FAKE_BOARD_H
#define TESTS_LINUX_PANEL_FAKE_BOARD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "tests/panel/panel.h"

#define FAKE_LINES 8
enum { FAKE_BUTTON_3 = 1, FAKE_BUTTON_2 = 2, FAKE_BUTTON = 3, FAKE_DC = 4, FAKE_RESET = 5, FAKE_BACKLIGHT = 6 };

typedef enum fake_pull { FAKE_NO_PULL, FAKE_PULL_UP, FAKE_PULL_DOWN } fake_pull;

typedef struct fake_line {
    const char *name;
    const char *consumer; /* who has it; NULL with `used`: nobody knows */
    bool used;
    bool output, level, active_low, edges;
    fake_pull pull;
    int request_error; /* errno of requests, 0: none */
} fake_line;

/* What happens while the program waits for buttons. */
typedef enum fake_happening { FAKE_EDGE, FAKE_SIGNAL, FAKE_STRAY_SIGNAL, FAKE_POLL_ERROR } fake_happening;

typedef struct fake_wait {
    fake_happening what;
    unsigned line;     /* FAKE_EDGE: of which line */
    bool level;        /* and its new level */
    unsigned after_ms; /* since the one before */
    int number;        /* FAKE_SIGNAL: which; FAKE_POLL_ERROR: errno */
} fake_wait;

typedef struct fake_board {
    uint64_t now_ns;

    /* GPIO */
    const char *chip_path; /* the only chip there is */
    int chip_error;
    unsigned chips_open, lines_held;
    fake_line lines[FAKE_LINES];
    unsigned sets, fail_set; /* the number of the set, from 1, that is refused; 0: none */
    unsigned fail_read;      /* the same of reads of edges */
    unsigned reads;

    /* SPI */
    const char *spi_path;
    int spi_error;
    unsigned files_open;
    unsigned long refused_setting; /* the ioctl that is refused, 0: none, */
    int refusal;                   /* with this errno */
    const char *buffer_parameter;  /* text of the module's parameter; NULL: not there */
    size_t takes_bytes;            /* longer transfers are refused with EMSGSIZE */
    unsigned messages, interrupt_message, fail_message, signal_message; /* numbers from 1; 0: none */
    int fail_error, signal_number;
    size_t longest_bytes;
    uint64_t bytes;
    unsigned slow_us; /* of real time that a transfer takes */
    unsigned torn;    /* transfers whose bytes changed under way */
    uint8_t answer;   /* to reads */

    /* the rest of the system */
    const char *group; /* of the devices; NULL: root's */
    const char *chips[3];
    const fake_wait *waits;
    unsigned wait_count, waited;
    int thread_error;
    unsigned allocations, fail_allocation;
    uint64_t longest_delay_ns;

    panel *panel; /* NULL: bytes go nowhere */
} fake_board;

extern fake_board the_board;

/* A board whose calls all succeed. Ends the panel of the one before. */
void fake_board_begin(void);
void fake_board_end(void);

/* For the fakes only. All but lock and unlock are called with the lock held. */
void fake_lock(void);
void fake_unlock(void);
void fake_level(unsigned line, bool level);
bool fake_next_edge(unsigned line, bool *pressed, uint64_t *at_ns);
int fake_line_named(const char *name);                                          /* -1: none */
int fake_request(unsigned line, const char *consumer, bool output, bool level); /* 0 or errno */
void fake_release(unsigned line);
int fake_event_file(unsigned line);

#endif
