/* SPDX-License-Identifier: MIT */
/*
 * What the fakes of both versions of libgpiod share; each returns 0, or -1 with errno. Included after gpiod.h.
 */
#ifndef TESTS_LINUX_PANEL_FAKE_GPIOD_H
#define TESTS_LINUX_PANEL_FAKE_GPIOD_H

#include "tests/linux_panel/fake_board.h"

int fake_gpiod_set(unsigned line, bool level);
int fake_gpiod_read(unsigned line, bool *pressed, uint64_t *at_ns);

#endif
