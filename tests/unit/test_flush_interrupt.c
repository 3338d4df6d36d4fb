/* SPDX-License-Identifier: MIT */
/*
 * Transfers whose end an interrupt tells, while the library polls for want of a wait function. A timer's signal stands
 * for the interrupt of a DMA controller: it stops the one thread that there is, at any instruction, and tells the end
 * of the oldest transfer.
 */
#define _XOPEN_SOURCE 700 /* setitimer */

#include <signal.h>
#include <sys/time.h>

#include "tests/unit/backends.h"
#include "tests/unit/board.h"

#define WIDTH 40
#define HEIGHT 37
#define ROW (WIDTH * 3)
#define BANDS 19
#define BAND ((HEIGHT + BANDS - 1) / BANDS)
#define FRAMES 20
#define INTERRUPT_US 200
#define MOST_UNDER_WAY 2

typedef struct panel {
    glint_transfers transfers;
    uint8_t picture[HEIGHT * ROW];
    glint_band queue[MOST_UNDER_WAY]; /* oldest first */
    unsigned under_way, most;
    unsigned finished; /* transfers, each by an interrupt */
} panel;

static panel the_panel;
static uint32_t memory_words[8192];

/* The band leaves its buffer only now: a library that did not wait would have drawn over it. */
static void interrupt(int number)
{
    panel *p = &the_panel;
    (void)number;
    if (p->under_way == 0) {
        return;
    }
    memcpy(p->picture + (size_t)p->queue[0].y_px * ROW, p->queue[0].pixels, p->queue[0].bytes);
    p->queue[0] = p->queue[1];
    p->under_way--;
    p->finished++;
    glint_flush_done(&p->transfers);
}

static int start(void *context, const glint_band *band)
{
    panel *p = context;
    sigset_t timer, before;
    assert_int_equal(sigemptyset(&timer), 0);
    assert_int_equal(sigaddset(&timer, SIGALRM), 0);
    assert_int_equal(sigprocmask(SIG_BLOCK, &timer, &before), 0);
    assert_true(p->under_way < MOST_UNDER_WAY);
    p->queue[p->under_way++] = *band;
    p->most = p->under_way > p->most ? p->under_way : p->most;
    assert_int_equal(sigprocmask(SIG_SETMASK, &before, NULL), 0);
    return 0;
}

static int at_once(void *context, const glint_band *band)
{
    memcpy((uint8_t *)context + (size_t)band->y_px * ROW, band->pixels, band->bytes);
    return 0;
}

static int draw(const glint_display *display, int which)
{
    board b;
    const glint_quality quality = {.shading = GLINT_SHADING_EXACT};
    board_set_up(&b);
    b.object.place = glint_turn_x(9000);
    b.material.diffuse = board_grey(16384);
    b.material.specular.r_q14 = 9000;
    b.material.exponent_q4 = 8 * 16;
    b.scene.background.b_q14 = 12000;
    assert_true(backends[which].memory_bytes(&b.scene, display) <= sizeof memory_words);
    return backends[which].render(&b.scene, display, &quality, memory_words, sizeof memory_words, NULL);
}

static void set_timer(long microseconds)
{
    const struct itimerval timer = {{0, microseconds}, {0, microseconds}};
    assert_int_equal(setitimer(ITIMER_REAL, &timer, NULL), 0);
}

static void test_transfers_that_an_interrupt_ends(void **state)
{
    static uint8_t expected[HEIGHT * ROW];
    panel *p = &the_panel;
    struct sigaction action;
    (void)state;
    memset(&action, 0, sizeof action);
    action.sa_handler = interrupt;
    action.sa_flags = SA_RESTART;
    assert_int_equal(sigaction(SIGALRM, &action, NULL), 0);
    for (int n = 0; n < 2 * BACKENDS; n++) {
        const int which = n / 2;
        const uint8_t buffers = (uint8_t)(1 + n % 2);
        const glint_display plain = {.width_px = WIDTH, .height_px = HEIGHT, .flush = at_once, .context = expected};
        const glint_display display = {.width_px = WIDTH,
                                       .height_px = HEIGHT,
                                       .band_px = BAND,
                                       .buffer_count = buffers,
                                       .flush = start,
                                       .context = p,
                                       .wait = NULL,
                                       .transfers = &p->transfers};
        assert_int_equal(draw(&plain, which), 0);
        memset(p, 0, sizeof *p);
        set_timer(INTERRUPT_US);
        for (unsigned frame_number = 1; frame_number <= FRAMES; frame_number++) {
            memset(p->picture, 0, sizeof p->picture);
            assert_int_equal(draw(&display, which), 0);
            /* the last transfer of the frame has ended too, and none but an interrupt can have told so */
            assert_int_equal(p->under_way, 0);
            assert_int_equal(p->finished, frame_number * BANDS);
            assert_int_equal(p->transfers.started, p->transfers.finished);
            assert_memory_equal(p->picture, expected, sizeof expected);
        }
        set_timer(0);
        assert_true(p->most >= 1 && p->most <= buffers);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_transfers_that_an_interrupt_ends)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
