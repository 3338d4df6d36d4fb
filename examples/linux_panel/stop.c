/* SPDX-License-Identifier: MIT */
#define _GNU_SOURCE /* ppoll() */
#include "stop.h"

#include <errno.h>
#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t asked;

static void note(int number)
{
    (void)number;
    asked = 1;
}

void stop_watch(void)
{
    const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action = {.sa_handler = note};
    (void)sigemptyset(&action.sa_mask);
    asked = 0;
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        (void)sigaction(numbers[i], &action, NULL); /* without SA_RESTART: it is to end a wait */
    }
}

bool stop_asked(void)
{
    return asked != 0;
}

int stop_poll(struct pollfd *files, nfds_t count)
{
    sigset_t ours, before;
    (void)sigemptyset(&ours);
    (void)sigaddset(&ours, SIGINT);
    (void)sigaddset(&ours, SIGTERM);
    (void)sigaddset(&ours, SIGHUP);
    (void)pthread_sigmask(SIG_BLOCK, &ours, &before);
    int result = -1;
    int error = EINTR;
    if (!stop_asked()) {
        result = ppoll(files, count, NULL, &before); /* lets the signals in while it waits only */
        error = errno;
    }
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
    errno = error;
    return result;
}
