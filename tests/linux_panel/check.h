/* SPDX-License-Identifier: MIT */
#ifndef TESTS_LINUX_PANEL_CHECK_H
#define TESTS_LINUX_PANEL_CHECK_H

#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <setjmp.h>

#include <cmocka.h>

/* The text holds this part. */
#define assert_says(text, part)                                                                                        \
    do {                                                                                                               \
        if (strstr(text, part) == NULL) {                                                                              \
            fail_msg("\"%s\" does not say \"%s\"", text, part);                                                        \
        }                                                                                                              \
    } while (0)

#endif
