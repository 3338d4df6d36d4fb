/* SPDX-License-Identifier: MIT */
#include <errno.h>
#include <gpiod.h>
#include <stddef.h>
#include <string.h>

#include "tests/linux_panel/fake_gpiod.h"

struct gpiod_chip {
    char unused;
};

static struct gpiod_chip the_chip;

struct gpiod_chip *__wrap_gpiod_chip_open(const char *path)
{
    if (the_board.chip_error != 0 || strcmp(path, the_board.chip_path) != 0) {
        errno = the_board.chip_error != 0 ? the_board.chip_error : ENOENT;
        return NULL;
    }
    the_board.chips_open++;
    return &the_chip;
}

void __wrap_gpiod_chip_close(struct gpiod_chip *chip)
{
    (void)chip;
    the_board.chips_open--;
}

int fake_gpiod_set(unsigned line, bool level)
{
    fake_lock();
    const bool refused = ++the_board.sets == the_board.fail_set;
    if (!refused) {
        fake_level(line, level);
    }
    fake_unlock();
    errno = EIO;
    return refused ? -1 : 0;
}

int fake_gpiod_read(unsigned line, bool *pressed, uint64_t *at_ns)
{
    fake_lock();
    const bool good = fake_next_edge(line, pressed, at_ns);
    fake_unlock();
    errno = ENODEV;
    return good ? 0 : -1;
}
