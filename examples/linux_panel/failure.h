/* SPDX-License-Identifier: MIT */
/*
 * What went wrong, as a sentence for the person at the terminal: what failed, and what to do about it.
 */
#ifndef EXAMPLES_LINUX_PANEL_FAILURE_H
#define EXAMPLES_LINUX_PANEL_FAILURE_H

#include <stddef.h>

typedef struct failure {
    char text[512]; /* empty: nothing failed */
} failure;

/* Writes the sentence; always -1, so that a function can return it. */
int fail_with(failure *f, const char *format, ...) __attribute__((format(printf, 2, 3)));

/*
 * The device at `path` could not be opened for want of permission. Names the group to join, if the device belongs to
 * one that is not root's.
 */
int fail_permission(failure *f, const char *path);

#endif
