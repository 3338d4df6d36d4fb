/* SPDX-License-Identifier: MIT */
/*
 * A second thread that sends a band while the next one is drawn.
 *
 * The drawing thread puts jobs, at most SENDER_SLOTS that are not yet done, and asks how many have been done since it
 * last asked. Glint's counters of transfers are thus touched by the drawing thread alone, without a data race.
 */
#ifndef EXAMPLES_LINUX_PANEL_SENDER_H
#define EXAMPLES_LINUX_PANEL_SENDER_H

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

#include "failure.h"

#define SENDER_SLOTS 2

typedef struct sender_job {
    const uint8_t *pixels;    /* stay as they are until the job is done */
    uint32_t bytes;           /* 0: nothing to send, done in its turn */
    uint16_t y_px, height_px; /* whole rows of the picture */
} sender_job;

/* Sends one job; 0, or -1 and why. */
typedef int (*sender_send)(void *context, const sender_job *job, failure *f);

typedef struct sender {
    sender_send send;
    void *context;
    pthread_t thread;
    pthread_mutex_t lock; /* of all below */
    pthread_cond_t changed;
    sender_job jobs[SENDER_SLOTS];
    unsigned put, done; /* counts of jobs; they may wrap around */
    unsigned told;      /* of those done: that the drawing thread knows of */
    uint64_t busy_ns;   /* spent in `send` */
    bool ending;
    int result;      /* of the first send that failed, 0 before; then nothing is sent any more */
    failure failure; /* why */
} sender;

/* 0, or -1 and why. The thread takes no signals. */
int sender_start(sender *s, sender_send send, void *context, failure *f);

/* Ends the thread when everything put has been sent. */
void sender_end(sender *s);

/* Hands over a job; waits while the slots are full. Returns 0, or -1 and why if an earlier job failed. */
int sender_put(sender *s, const sender_job *job, failure *f);

/* Jobs done since the last call, of which at least one is waited for if any is under way. */
unsigned sender_wait(sender *s);

/* Nanoseconds spent sending since the last call. 0 or -1 and why, as sender_put(). */
int sender_took(sender *s, uint64_t *busy_ns, failure *f);

#endif
