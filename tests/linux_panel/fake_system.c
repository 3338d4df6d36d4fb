/* SPDX-License-Identifier: MIT */
/*
 * What the program calls of the system, on the board of fake_board.h. Time is the board's own: sending, and waiting,
 * make it pass.
 */
#define _GNU_SOURCE /* ppoll() */
#include <errno.h>
#include <fcntl.h>
#include <glob.h>
#include <grp.h>
#include <linux/spi/spidev.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "tests/linux_panel/fake_board.h"

#define SPI_FILE 8000

int __real_open(const char *path, int flags, ...);
int __real_close(int file);
FILE *__real_fopen(const char *path, const char *mode);
int __real_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *), void *context);
void *__real_calloc(size_t count, size_t bytes);
void *__real_malloc(size_t bytes);

/* ---------------------------------------------------------------------------------------------------------------- SPI
 */

int __wrap_open(const char *path, int flags, ...)
{
    if (strncmp(path, "/dev/", 5) != 0) {
        va_list arguments;
        va_start(arguments, flags);
        const mode_t mode = (flags & O_CREAT) != 0 ? (mode_t)va_arg(arguments, int) : 0;
        va_end(arguments);
        return __real_open(path, flags, mode);
    }
    if (the_board.spi_error != 0 || strcmp(path, the_board.spi_path) != 0) {
        errno = the_board.spi_error != 0 ? the_board.spi_error : ENOENT;
        return -1;
    }
    the_board.files_open++;
    return SPI_FILE;
}

int __wrap_close(int file)
{
    if (file != SPI_FILE) {
        return __real_close(file);
    }
    the_board.files_open--;
    return 0;
}

static void to_panel(const struct spi_ioc_transfer *one)
{
    const uint8_t *bytes = (const uint8_t *)(uintptr_t)one->tx_buf;
    const uint64_t byte_ns = UINT64_C(8000000000) / one->speed_hz;
    panel_line(the_board.panel, the_board.now_ns, PANEL_CS, false);
    for (uint32_t i = 0; i < one->len; i++) {
        the_board.now_ns += byte_ns;
        panel_byte(the_board.panel, the_board.now_ns, bytes == NULL ? 0 : bytes[i]);
    }
    the_board.now_ns += 1000;
    if (one->cs_change == 0) {
        panel_line(the_board.panel, the_board.now_ns, PANEL_CS, true);
    }
}

static uint32_t sum(const struct spi_ioc_transfer *one)
{
    const uint8_t *bytes = (const uint8_t *)(uintptr_t)one->tx_buf;
    uint32_t sum = 1;
    for (uint32_t i = 0; bytes != NULL && i < one->len; i++) {
        sum = sum * 31 + bytes[i];
    }
    return sum;
}

/* A slow transfer reads its bytes as it goes: they are to be the same at its end. */
static bool is_torn(const struct spi_ioc_transfer *one, unsigned slow_us)
{
    const struct timespec time = {.tv_nsec = slow_us * 1000L};
    const uint32_t before = sum(one);
    (void)nanosleep(&time, NULL);
    return sum(one) != before;
}

static int transfer(const struct spi_ioc_transfer *one)
{
    fake_board *b = &the_board;
    const unsigned number = ++b->messages;
    if (number == b->signal_message) {
        (void)kill(getpid(), b->signal_number); /* to the process: a thread that lets it in takes it */
    }
    if (number == b->interrupt_message || number == b->fail_message || one->len > b->takes_bytes) {
        errno = number == b->interrupt_message ? EINTR : number == b->fail_message ? b->fail_error : EMSGSIZE;
        return -1;
    }
    b->longest_bytes = one->len > b->longest_bytes ? one->len : b->longest_bytes;
    b->bytes += one->len;
    if (one->rx_buf != 0) {
        memset((void *)(uintptr_t)one->rx_buf, b->answer, one->len);
    } else if (b->panel != NULL) {
        to_panel(one);
    }
    return (int)one->len;
}

int __wrap_ioctl(int file, unsigned long request, ...)
{
    va_list arguments;
    va_start(arguments, request);
    const void *argument = va_arg(arguments, const void *);
    va_end(arguments);
    if (file != SPI_FILE) {
        errno = EBADF;
        return -1;
    }
    if (request == the_board.refused_setting) {
        errno = the_board.refusal;
        return -1;
    }
    if (request != SPI_IOC_MESSAGE(1)) {
        return 0;
    }
    const bool torn = the_board.slow_us != 0 && is_torn(argument, the_board.slow_us);
    fake_lock();
    the_board.torn += torn ? 1 : 0;
    const int result = transfer(argument);
    fake_unlock();
    return result;
}

FILE *__wrap_fopen(const char *path, const char *mode)
{
    if (strncmp(path, "/sys/", 5) != 0) {
        return __real_fopen(path, mode);
    }
    if (the_board.buffer_parameter == NULL) {
        errno = ENOENT;
        return NULL;
    }
    FILE *file = tmpfile();
    if (file != NULL) {
        (void)fputs(the_board.buffer_parameter, file);
        rewind(file);
    }
    return file;
}

/* ------------------------------------------------------------------------------------------------ devices and groups
 */

int __wrap_stat(const char *path, struct stat *out)
{
    (void)path;
    memset(out, 0, sizeof *out);
    out->st_mode = S_IFCHR | 0660;
    out->st_gid = the_board.group != NULL ? 997 : 0;
    return 0;
}

struct group *__wrap_getgrgid(gid_t number)
{
    static struct group group;
    static char name[32];
    if (number == 0 || the_board.group == NULL) {
        return NULL;
    }
    (void)snprintf(name, sizeof name, "%s", the_board.group);
    group.gr_name = name;
    return &group;
}

int __wrap_glob(const char *pattern, int flags, int (*on_error)(const char *, int), glob_t *out)
{
    static char *paths[3];
    (void)pattern;
    (void)flags;
    (void)on_error;
    memset(out, 0, sizeof *out);
    for (; out->gl_pathc < 3 && the_board.chips[out->gl_pathc] != NULL; out->gl_pathc++) {
        paths[out->gl_pathc] = (char *)(uintptr_t)the_board.chips[out->gl_pathc];
    }
    out->gl_pathv = paths;
    return out->gl_pathc > 0 ? 0 : GLOB_NOMATCH;
}

void __wrap_globfree(glob_t *found)
{
    (void)found;
}

/* --------------------------------------------------------------------------------------------------- time and waiting
 */

int __wrap_clock_gettime(clockid_t clock, struct timespec *out)
{
    (void)clock;
    fake_lock();
    the_board.now_ns += 100;
    out->tv_sec = (time_t)(the_board.now_ns / 1000000000u);
    out->tv_nsec = (long)(the_board.now_ns % 1000000000u);
    fake_unlock();
    return 0;
}

int __wrap_clock_nanosleep(clockid_t clock, int flags, const struct timespec *until, struct timespec *left)
{
    static bool interrupted;
    (void)clock;
    (void)flags;
    (void)left;
    interrupted = !interrupted;
    if (interrupted) {
        return EINTR; /* every other one ends too early: the program has to wait on */
    }
    const uint64_t end_ns = (uint64_t)until->tv_sec * 1000000000u + (uint64_t)until->tv_nsec;
    fake_lock();
    if (end_ns > the_board.now_ns) {
        const uint64_t delay_ns = end_ns - the_board.now_ns;
        the_board.longest_delay_ns = delay_ns > the_board.longest_delay_ns ? delay_ns : the_board.longest_delay_ns;
        the_board.now_ns = end_ns;
    }
    fake_unlock();
    return 0;
}

static int edge(const fake_wait *wait, struct pollfd *files, nfds_t count)
{
    fake_lock();
    the_board.now_ns += wait->after_ms * UINT64_C(1000000);
    the_board.lines[wait->line].level = wait->level;
    const int file = fake_event_file(wait->line);
    fake_unlock();
    for (nfds_t i = 0; i < count; i++) {
        files[i].revents = files[i].fd == file ? POLLIN : 0;
    }
    return 1;
}

int __wrap_ppoll(struct pollfd *files, nfds_t count, const struct timespec *limit, const sigset_t *mask)
{
    sigset_t before;
    (void)limit;
    if (the_board.waited == the_board.wait_count) {
        errno = EDEADLK; /* it would wait for ever */
        return -1;
    }
    const fake_wait *wait = &the_board.waits[the_board.waited++];
    switch (wait->what) {
    case FAKE_EDGE:
        return edge(wait, files, count);
    case FAKE_SIGNAL:
        (void)pthread_sigmask(SIG_SETMASK, mask, &before);
        (void)raise(wait->number);
        (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
        errno = EINTR;
        return -1;
    case FAKE_STRAY_SIGNAL:
        errno = EINTR;
        return -1;
    default:
        errno = wait->number;
        return -1;
    }
}

int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *), void *context)
{
    return the_board.thread_error != 0 ? the_board.thread_error
                                       : __real_pthread_create(thread, attributes, run, context);
}

/* ------------------------------------------------------------------------------------------------------------- memory
 */

static bool has_none(void)
{
    return ++the_board.allocations == the_board.fail_allocation;
}

void *__wrap_calloc(size_t count, size_t bytes)
{
    return has_none() ? NULL : __real_calloc(count, bytes);
}

void *__wrap_malloc(size_t bytes)
{
    return has_none() ? NULL : __real_malloc(bytes);
}
