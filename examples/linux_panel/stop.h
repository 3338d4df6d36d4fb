/* SPDX-License-Identifier: MIT */
/*
 * Signals that ask the program to end: SIGINT, SIGTERM, SIGHUP. They are noted, and looked at between bands and while
 * waiting; what is being sent to the panel is finished, so that the panel can be blanked with commands it understands.
 */
#ifndef EXAMPLES_LINUX_PANEL_STOP_H
#define EXAMPLES_LINUX_PANEL_STOP_H

#include <poll.h>
#include <stdbool.h>

/* From now on signals are noted. Before the second thread is started. */
void stop_watch(void);

/* Whether one has come since. */
bool stop_asked(void);

/* poll() without a time limit; a signal ends it with -1 and EINTR, also one that came just before the call. */
int stop_poll(struct pollfd *files, nfds_t count);

#endif
