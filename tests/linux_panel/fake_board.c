/* SPDX-License-Identifier: MIT */
#include "tests/linux_panel/fake_board.h"

#include <errno.h>
#include <pthread.h>
#include <string.h>

#define EVENT_FILE 9000

fake_board the_board;
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

void fake_board_begin(void)
{
    static const char *const names[FAKE_LINES] = {"SCK", "KEY3", "KEY2", "KEY1", "DC", "RESET", "BACKLIGHT", NULL};
    fake_board_end();
    memset(&the_board, 0, sizeof the_board);
    the_board.chip_path = "/dev/gpiochip0";
    the_board.spi_path = "/dev/spidev0.0";
    the_board.takes_bytes = 4096;
    the_board.buffer_parameter = "4096\n";
    the_board.chips[0] = "/dev/gpiochip0";
    the_board.chips[1] = "/dev/gpiochip1";
    the_board.now_ns = 1000000000;
    for (unsigned i = 0; i < FAKE_LINES; i++) {
        the_board.lines[i].name = names[i];
    }
    the_board.lines[0].used = true;
    the_board.lines[0].consumer = "spi0 SCK";
}

void fake_board_end(void)
{
    panel_close(the_board.panel);
    the_board.panel = NULL;
}

void fake_lock(void)
{
    (void)pthread_mutex_lock(&lock);
}

void fake_unlock(void)
{
    (void)pthread_mutex_unlock(&lock);
}

void fake_level(unsigned line, bool level)
{
    the_board.lines[line].level = level;
    the_board.now_ns += 1000;
    if (the_board.panel == NULL) {
        return;
    }
    if (line == FAKE_DC) {
        panel_line(the_board.panel, the_board.now_ns, PANEL_DC, level);
    } else if (line == FAKE_RESET) {
        panel_line(the_board.panel, the_board.now_ns, PANEL_RESET, level);
    } else if (line == FAKE_BACKLIGHT) {
        panel_line(the_board.panel, the_board.now_ns, PANEL_BACKLIGHT, level);
    }
}

bool fake_next_edge(unsigned line, bool *pressed, uint64_t *at_ns)
{
    const fake_line *l = &the_board.lines[line];
    if (++the_board.reads == the_board.fail_read) {
        return false;
    }
    *pressed = l->level != l->active_low;
    *at_ns = the_board.now_ns;
    return true;
}

int fake_line_named(const char *name)
{
    for (int i = 0; i < FAKE_LINES; i++) {
        if (the_board.lines[i].name != NULL && strcmp(the_board.lines[i].name, name) == 0) {
            return i;
        }
    }
    return -1;
}

int fake_request(unsigned line, const char *consumer, bool output, bool level)
{
    fake_line *l = &the_board.lines[line];
    if (l->request_error != 0) {
        return l->request_error;
    }
    if (l->used) {
        return EBUSY;
    }
    l->used = true;
    l->consumer = consumer;
    l->output = output;
    the_board.lines_held++;
    if (output) {
        fake_level(line, level);
    }
    return 0;
}

void fake_release(unsigned line)
{
    the_board.lines[line].used = false;
    the_board.lines[line].consumer = NULL;
    the_board.lines_held--;
}

int fake_event_file(unsigned line)
{
    return EVENT_FILE + (int)line;
}
