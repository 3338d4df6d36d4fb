/* SPDX-License-Identifier: MIT */
/*
 * How finished bands leave the library: order and counts, one and two buffers, transfers that end later (told from the
 * wait function, from within flush, or from a second thread in the place of an interrupt), and errors of the flush
 * function.
 *
 * The panel below stands for a display with DMA. It hashes a band's pixels when the transfer starts and when it ends:
 * equal hashes show that the library leaves a buffer alone while it is sent.
 */
#include "tests/unit/backends.h"
#include "tests/unit/board.h"

#include <limits.h>
#include <pthread.h>
#include <sched.h>

#define WIDTH 40
#define HEIGHT 37
#define ROW (WIDTH * 3)
#define MOST_UNDER_WAY 2

/* When a transfer ends. */
enum { AT_ONCE, WITHIN_FLUSH, WHEN_AWAITED, FROM_A_THREAD };

typedef struct transfer {
    const uint8_t *pixels;
    uint8_t *to;
    uint32_t bytes;
    uint64_t hash;
} transfer;

typedef struct panel {
    int mode;
    glint_transfers transfers;
    uint8_t picture[HEIGHT * ROW];
    uint16_t next_row;
    unsigned bands, lasts, waits;
    transfer queue[MOST_UNDER_WAY]; /* oldest first */
    unsigned under_way;
    unsigned overlapped; /* bands handed over while one before was still under way */
    unsigned most;       /* greatest number under way */
    unsigned torn;       /* transfers whose pixels changed under way, or whose buffer was handed over again */
    uint32_t finished;
    unsigned fail_at; /* the number of the band, from 1, that is refused with `error`; 0: none */
    int error;
    pthread_mutex_t lock;
    bool stop;
} panel;

static panel the_panel; /* too large for some stacks */
static uint32_t memory_words[8192];

static uint64_t hash_of(const uint8_t *bytes, uint32_t count)
{
    uint64_t hash = 0xcbf29ce484222325u; /* FNV-1a */
    for (uint32_t i = 0; i < count; i++) {
        hash = (hash ^ bytes[i]) * 0x100000001b3u;
    }
    return hash;
}

/* The oldest transfer arrives at the display. */
static void finish_one(panel *p)
{
    const transfer *t = &p->queue[0];
    p->torn += hash_of(t->pixels, t->bytes) != t->hash;
    memcpy(t->to, t->pixels, t->bytes);
    p->queue[0] = p->queue[1];
    p->under_way--;
    p->finished++;
    glint_flush_done(&p->transfers);
}

static void start(panel *p, const glint_band *band)
{
    const transfer t = {band->pixels, p->picture + band->y_px * ROW, band->bytes, hash_of(band->pixels, band->bytes)};
    p->overlapped += p->under_way > 0;
    for (unsigned i = 0; i < p->under_way; i++) {
        p->torn += p->queue[i].pixels == t.pixels;
    }
    if (p->under_way == MOST_UNDER_WAY) {
        p->most = MOST_UNDER_WAY + 1;
        return;
    }
    p->queue[p->under_way++] = t;
    p->most = p->under_way > p->most ? p->under_way : p->most;
}

static int panel_flush(void *context, const glint_band *band)
{
    panel *p = context;
    assert_true(band->height_px > 0);
    assert_int_equal(band->y_px, p->next_row);
    assert_int_equal(band->width_px, WIDTH);
    assert_int_equal(band->stride_bytes, ROW);
    assert_int_equal(band->bytes, band->height_px * ROW);
    p->next_row = (uint16_t)(p->next_row + band->height_px);
    assert_true(p->next_row <= HEIGHT);
    p->lasts += band->last;
    p->bands++;
    if (p->bands == p->fail_at) {
        return p->error;
    }
    if (p->mode == AT_ONCE) {
        memcpy(p->picture + band->y_px * ROW, band->pixels, band->bytes);
        return 0;
    }
    pthread_mutex_lock(&p->lock);
    start(p, band);
    if (p->mode == WITHIN_FLUSH) {
        finish_one(p);
    }
    pthread_mutex_unlock(&p->lock);
    return 0;
}

static void panel_wait(void *context)
{
    panel *p = context;
    p->waits++;
    pthread_mutex_lock(&p->lock);
    if (p->mode == WHEN_AWAITED) {
        assert_true(p->under_way > 0);
        finish_one(p);
    }
    pthread_mutex_unlock(&p->lock);
    sched_yield();
}

static void *panel_thread(void *context)
{
    panel *p = context;
    for (bool stop = false; !stop;) {
        sched_yield();
        pthread_mutex_lock(&p->lock);
        if (p->under_way > 0) {
            finish_one(p);
        }
        stop = p->stop;
        pthread_mutex_unlock(&p->lock);
    }
    return NULL;
}

/* A lit and coloured board that has an edge in the picture: every band differs. */
static void set_scene(board *b)
{
    board_set_up(b);
    b->object.place = glint_turn_x(9000);
    b->material.diffuse = board_grey(16384);
    b->material.specular.r_q14 = 9000;
    b->material.exponent_q4 = 8 * 16;
    b->scene.background.b_q14 = 12000;
}

static void panel_begin(panel *p, int mode)
{
    memset(p, 0, sizeof *p);
    p->mode = mode;
    pthread_mutex_init(&p->lock, NULL);
}

/* One frame; the panel's counters of rows and bands start anew. */
static int draw(panel *p, int which, uint16_t band_px, uint8_t buffers)
{
    board b;
    set_scene(&b);
    const glint_quality quality = {.shading = GLINT_SHADING_EXACT};
    const glint_display display = {.width_px = WIDTH,
                                   .height_px = HEIGHT,
                                   .band_px = band_px,
                                   .buffer_count = buffers,
                                   .flush = panel_flush,
                                   .context = p,
                                   .wait = p->mode == AT_ONCE ? NULL : panel_wait,
                                   .transfers = p->mode == AT_ONCE ? NULL : &p->transfers};
    p->next_row = 0;
    p->bands = p->lasts = 0;
    assert_true(backends[which].memory_bytes(&b.scene, &display) <= sizeof memory_words);
    return backends[which].render(&b.scene, &display, &quality, memory_words, sizeof memory_words, NULL);
}

static unsigned bands_of(uint16_t band_px)
{
    return band_px == 0 || band_px > HEIGHT ? 1 : (HEIGHT + band_px - 1u) / band_px;
}

static void expect_whole_frame(const panel *p, uint16_t band_px)
{
    assert_int_equal(p->next_row, HEIGHT);
    assert_int_equal(p->bands, bands_of(band_px));
    assert_int_equal(p->lasts, 1);
    assert_int_equal(p->under_way, 0);
    assert_int_equal(p->torn, 0);
}

/* The picture by a single band without transfers, drawn anew. */
static const uint8_t *expected_picture(int which)
{
    static panel single;
    panel_begin(&single, AT_ONCE);
    assert_int_equal(draw(&single, which, 0, 1), 0);
    expect_whole_frame(&single, 0);
    return single.picture;
}

static const uint16_t band_heights[] = {1, 2, 3, 7, 16, 18, 19, 36, 37, 38, 0};
#define BAND_HEIGHTS (sizeof band_heights / sizeof *band_heights)

static void test_bands_come_in_order(void **state)
{
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        const uint8_t *const expected = expected_picture(which);
        for (size_t i = 0; i < BAND_HEIGHTS; i++) {
            for (uint8_t buffers = 0; buffers <= 1; buffers++) {
                panel_begin(&the_panel, AT_ONCE);
                assert_int_equal(draw(&the_panel, which, band_heights[i], buffers), 0);
                expect_whole_frame(&the_panel, band_heights[i]);
                assert_memory_equal(the_panel.picture, expected, sizeof the_panel.picture);
            }
        }
    }
}

static void test_transfers_that_end_when_awaited(void **state)
{
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        const uint8_t *const expected = expected_picture(which);
        for (size_t i = 0; i < BAND_HEIGHTS; i++) {
            const unsigned bands = bands_of(band_heights[i]);
            for (uint8_t buffers = 1; buffers <= 2; buffers++) {
                panel_begin(&the_panel, WHEN_AWAITED);
                assert_int_equal(draw(&the_panel, which, band_heights[i], buffers), 0);
                expect_whole_frame(&the_panel, band_heights[i]);
                assert_memory_equal(the_panel.picture, expected, sizeof the_panel.picture);
                /* nothing ends unless it is awaited: each band but the first is drawn while the one before is sent */
                assert_int_equal(the_panel.overlapped, buffers == 2 ? bands - 1 : 0);
                assert_int_equal(the_panel.most, buffers == 2 && bands > 1 ? 2 : 1);
                assert_int_equal(the_panel.waits, bands);
            }
        }
    }
}

static void test_transfers_that_end_within_flush(void **state)
{
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        const uint8_t *const expected = expected_picture(which);
        for (uint8_t buffers = 1; buffers <= 2; buffers++) {
            panel_begin(&the_panel, WITHIN_FLUSH);
            assert_int_equal(draw(&the_panel, which, 3, buffers), 0);
            expect_whole_frame(&the_panel, 3);
            assert_memory_equal(the_panel.picture, expected, sizeof the_panel.picture);
            assert_int_equal(the_panel.waits, 0);
        }
    }
}

/* Without a wait function the library polls; the thread ends the transfers whenever the system lets it run. */
static void test_transfers_that_a_thread_ends(void **state)
{
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        const uint8_t *const expected = expected_picture(which);
        for (uint8_t buffers = 1; buffers <= 2; buffers++) {
            pthread_t thread;
            panel_begin(&the_panel, FROM_A_THREAD);
            assert_int_equal(pthread_create(&thread, NULL, panel_thread, &the_panel), 0);
            for (int frame_number = 0; frame_number < 20; frame_number++) {
                assert_int_equal(draw(&the_panel, which, 2, buffers), 0);
                expect_whole_frame(&the_panel, 2);
                assert_memory_equal(the_panel.picture, expected, sizeof the_panel.picture);
                memset(the_panel.picture, 0, sizeof the_panel.picture);
            }
            pthread_mutex_lock(&the_panel.lock);
            the_panel.stop = true;
            pthread_mutex_unlock(&the_panel.lock);
            assert_int_equal(pthread_join(thread, NULL), 0);
            assert_true(the_panel.most <= buffers);
        }
    }
}

/* The counters have 8 bits; a frame may start at any count, so each start is passed and both wrap many times. */
static void test_counters_wrap(void **state)
{
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        for (uint8_t buffers = 1; buffers <= 2; buffers++) {
            const uint8_t *const expected = expected_picture(which);
            panel_begin(&the_panel, WHEN_AWAITED);
            for (unsigned frame_number = 0; frame_number < 300; frame_number++) {
                memset(the_panel.picture, 0, sizeof the_panel.picture);
                assert_int_equal(draw(&the_panel, which, 6, buffers), 0); /* 7 bands: coprime to 256 */
                expect_whole_frame(&the_panel, 6);
                assert_memory_equal(the_panel.picture, expected, sizeof the_panel.picture);
            }
            assert_int_equal(the_panel.finished, 300 * 7);
            assert_int_equal(the_panel.transfers.started, (uint8_t)(300 * 7));
            assert_int_equal(the_panel.transfers.finished, (uint8_t)(300 * 7));
        }
    }
}

static void test_an_error_of_flush_ends_the_frame(void **state)
{
    (void)state;
    static const int errors[] = {1, 7, -1, -12, -70, 1000000, -1000000, INT_MAX, INT_MIN};
    static const int modes[] = {AT_ONCE, WITHIN_FLUSH, WHEN_AWAITED};
    for (int which = 0; which < BACKENDS; which++) {
        for (size_t m = 0; m < sizeof modes / sizeof *modes; m++) {
            for (unsigned at = 1; at <= 5; at++) { /* the first, between, the last of 5 bands */
                for (size_t e = 0; e < sizeof errors / sizeof *errors; e++) {
                    panel *const p = &the_panel;
                    panel_begin(p, modes[m]);
                    p->fail_at = at;
                    p->error = errors[e];
                    assert_int_equal(draw(p, which, 8, p->mode == AT_ONCE ? 1 : 2), errors[e]);
                    assert_int_equal(p->bands, at);
                    assert_int_equal(p->under_way, 0);
                    assert_int_equal(p->torn, 0);
                    assert_int_equal(p->finished, p->mode == AT_ONCE ? 0 : at - 1);
                    /* and the next frame goes through with the same counters */
                    p->fail_at = 0;
                    assert_int_equal(draw(p, which, 8, p->mode == AT_ONCE ? 1 : 2), 0);
                    expect_whole_frame(p, 8);
                    assert_memory_equal(p->picture, expected_picture(which), sizeof p->picture);
                }
            }
        }
    }
}

/* A single band of two buffers needs no second one, and the first of 2 bands is not awaited. */
static void test_first_bands_wait_for_nothing(void **state)
{
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        for (uint16_t band_px = 19; band_px <= HEIGHT; band_px = (uint16_t)(band_px + 18)) {
            panel_begin(&the_panel, WHEN_AWAITED);
            the_panel.fail_at = bands_of(band_px);
            the_panel.error = 5;
            assert_int_equal(draw(&the_panel, which, band_px, 2), 5);
            /* what was awaited is only what was still under way when the frame ended */
            assert_int_equal(the_panel.waits, bands_of(band_px) - 1);
        }
    }
}

static int tell_and_refuse(void *context, const glint_band *band)
{
    (void)band;
    glint_flush_done(context);
    return 7;
}

/* A flush function that tells the end and then returns an error breaks its contract; the frame still returns (it once
 * waited for ever), and the counters agree for the next one. */
static void test_an_end_told_before_an_error(void **state)
{
    (void)state;
    static const glint_camera camera = {.eye_q16 = {0, 0, 65536}, .field_of_view_turn16 = 8192, .near_q16 = 65536};
    const glint_scene scene = {.camera = &camera};
    const glint_quality quality = {.shading = GLINT_SHADING_EXACT};
    glint_transfers transfers = {0, 0};
    const glint_display display = {.width_px = 8,
                                   .height_px = 8,
                                   .band_px = 2,
                                   .flush = tell_and_refuse,
                                   .context = &transfers,
                                   .transfers = &transfers};
    for (int round = 0; round < 300; round++) {
        assert_int_equal(glint_fixed_render(&scene, &display, &quality, memory_words, sizeof memory_words, NULL), 7);
        assert_int_equal(transfers.started, transfers.finished);
        assert_int_equal(glint_float_render(&scene, &display, &quality, memory_words, sizeof memory_words, NULL), 7);
        assert_int_equal(transfers.started, transfers.finished);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bands_come_in_order),
        cmocka_unit_test(test_transfers_that_end_when_awaited),
        cmocka_unit_test(test_transfers_that_end_within_flush),
        cmocka_unit_test(test_transfers_that_a_thread_ends),
        cmocka_unit_test(test_counters_wrap),
        cmocka_unit_test(test_an_error_of_flush_ends_the_frame),
        cmocka_unit_test(test_first_bands_wait_for_nothing),
        cmocka_unit_test(test_an_end_told_before_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
