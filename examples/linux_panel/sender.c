/* SPDX-License-Identifier: MIT */
#include "sender.h"

#include <signal.h>
#include <string.h>

#include "clock.h"

static void *run(void *context)
{
    sender *s = context;
    (void)pthread_mutex_lock(&s->lock);
    for (;;) {
        while (s->put == s->done && !s->ending) {
            (void)pthread_cond_wait(&s->changed, &s->lock);
        }
        if (s->put == s->done) {
            break;
        }
        const sender_job job = s->jobs[s->done % SENDER_SLOTS];
        if (s->result == 0 && job.bytes > 0) {
            failure why = {""};
            (void)pthread_mutex_unlock(&s->lock);
            const uint64_t start_ns = clock_ns();
            const int result = s->send(s->context, &job, &why);
            const uint64_t took_ns = clock_ns() - start_ns;
            (void)pthread_mutex_lock(&s->lock);
            s->result = result;
            s->failure = why;
            s->busy_ns += took_ns;
        }
        s->done++;
        (void)pthread_cond_broadcast(&s->changed);
    }
    (void)pthread_mutex_unlock(&s->lock);
    return NULL;
}

int sender_start(sender *s, sender_send send, void *context, failure *f)
{
    sigset_t all, before;
    memset(s, 0, sizeof *s);
    s->send = send;
    s->context = context;
    (void)pthread_mutex_init(&s->lock, NULL);
    (void)pthread_cond_init(&s->changed, NULL);
    (void)sigfillset(&all);
    (void)pthread_sigmask(SIG_SETMASK, &all,
                          &before); /* the new thread inherits it: signals go to the drawing thread */
    const int error = pthread_create(&s->thread, NULL, run, s);
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
    return error == 0 ? 0 : fail_with(f, "cannot start a thread: %s", strerror(error));
}

void sender_end(sender *s)
{
    (void)pthread_mutex_lock(&s->lock);
    s->ending = true;
    (void)pthread_cond_broadcast(&s->changed);
    (void)pthread_mutex_unlock(&s->lock);
    (void)pthread_join(s->thread, NULL);
    (void)pthread_cond_destroy(&s->changed);
    (void)pthread_mutex_destroy(&s->lock);
}

/* With the lock held. */
static int tell_failure(const sender *s, failure *f)
{
    if (s->result != 0) {
        *f = s->failure;
    }
    return s->result;
}

int sender_put(sender *s, const sender_job *job, failure *f)
{
    (void)pthread_mutex_lock(&s->lock);
    while (s->put - s->done == SENDER_SLOTS) {
        (void)pthread_cond_wait(&s->changed, &s->lock);
    }
    const int result = tell_failure(s, f);
    if (result == 0) {
        s->jobs[s->put % SENDER_SLOTS] = *job;
        s->put++;
        (void)pthread_cond_broadcast(&s->changed);
    }
    (void)pthread_mutex_unlock(&s->lock);
    return result;
}

unsigned sender_wait(sender *s)
{
    (void)pthread_mutex_lock(&s->lock);
    while (s->done == s->told && s->put != s->done) {
        (void)pthread_cond_wait(&s->changed, &s->lock);
    }
    const unsigned finished = s->done - s->told;
    s->told = s->done;
    (void)pthread_mutex_unlock(&s->lock);
    return finished;
}

int sender_took(sender *s, uint64_t *busy_ns, failure *f)
{
    (void)pthread_mutex_lock(&s->lock);
    *busy_ns = s->busy_ns;
    s->busy_ns = 0;
    const int result = tell_failure(s, f);
    (void)pthread_mutex_unlock(&s->lock);
    return result;
}
