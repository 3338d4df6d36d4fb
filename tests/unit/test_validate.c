/* SPDX-License-Identifier: MIT */
/*
 * Bad input: every error code, provoked by the smallest change to one valid scene, in both backends; and the limits,
 * accepted just inside and refused just outside. A refused call writes nothing: the working memory, the report and the
 * transfer counters keep their bytes and no band is sent.
 */
#include "tests/unit/test_validate_cases.h"

#include <limits.h>
#include <stdio.h>

typedef struct variation {
    const char *name;
    void (*change)(world *);
    int expected;
    bool seen_by_sizes;
} variation;

#define ROW_SEEN(what, change, expected) {#what, what, expected, true},
#define ROW(what, change, expected) {#what, what, expected, false},
static const variation variations[] = {NULL_CASES(ROW_SEEN) SIZE_CASES(ROW_SEEN) REFUSED_CASES(ROW)
                                           ACCEPTED_CASES(ROW)};
#define VARIATIONS (sizeof variations / sizeof *variations)

/* Draws the varied scene; false and a line of text for each thing that is not as it should be. */
static bool behaves(const variation *v, const renderer *be)
{
    world w, before;
    glint_report report;
    uint8_t *const memory = (uint8_t *)memory_words;
    set_up(&w);
    v->change(&w);
    const bool by_size = w.memory_kind != FULL_MEMORY;
    size_t bytes = sizeof memory_words - SPARE;
    if (by_size) {
        bytes = w.memory_kind == PLAIN_MEMORY
                    ? w.plain_bytes[be - backends]
                    : be->memory_least_bytes(&w.b.scene, &w.display) - (w.memory_kind == SHORT_MEMORY);
    }
    assert_true(bytes > 0 && bytes <= sizeof memory_words - SPARE);
    memset(memory, FRAME_CANARY_BYTE, sizeof memory_words);
    memset(&report, FRAME_CANARY_BYTE, sizeof report);
    memcpy(&before, &w, sizeof w); /* padding included */
    const int result = be->render(w.scene_argument, w.display_argument, w.quality_argument,
                                  w.no_memory ? NULL : memory + w.misaligned, bytes, &report);
    bool good = result == v->expected;
    if (!good) {
        printf("%s, %s: returned %d (%s), expected %d\n", v->name, be->name, result, glint_error_text(result),
               v->expected);
    }
    size_t written = 0, past_the_end = 0;
    for (size_t i = 0; i < sizeof memory_words; i++) {
        written += memory[i] != FRAME_CANARY_BYTE;
        past_the_end += i >= bytes && memory[i] != FRAME_CANARY_BYTE;
    }
    if (past_the_end) {
        printf("%s, %s: %zu bytes written behind the memory\n", v->name, be->name, past_the_end);
        good = false;
    }
    if (v->expected == GLINT_OK) {
        if (w.flushed == 0 || written == 0) {
            printf("%s, %s: accepted, but nothing drawn\n", v->name, be->name);
            good = false;
        }
        return good;
    }
    const uint8_t *const report_bytes = (const uint8_t *)&report;
    for (size_t i = 0; i < sizeof report; i++) {
        written += report_bytes[i] != FRAME_CANARY_BYTE;
    }
    if (written != 0 || w.flushed != 0 || memcmp(&before, &w, sizeof w) != 0) {
        printf("%s, %s: refused, but %zu bytes written and %u bands sent\n", v->name, be->name, written, w.flushed);
        good = false;
    }
    return good;
}

static void test_each_variation_gets_its_code(void **state)
{
    (void)state;
    unsigned wrong = 0;
    for (size_t i = 0; i < VARIATIONS; i++) {
        for (int b = 0; b < BACKENDS; b++) {
            wrong += !behaves(&variations[i], &backends[b]);
        }
    }
    assert_int_equal(wrong, 0);
}

/* `up` may have any length: only its direction counts. 1 degree off the view direction is not parallel to it. */
static void test_up_counts_by_direction_alone(void **state)
{
    (void)state;
    static const int16_t lengths[] = {1, 2, 100, 32767};
    unsigned wrong = 0;
    for (int b = 0; b < BACKENDS; b++) {
        for (size_t i = 0; i <= sizeof lengths / sizeof *lengths; i++) {
            world w;
            glint_report report;
            set_up(&w);
            /* looks along -y but for one part in 57; the last round leaves `up` at its default, (0, 1, 0) */
            w.b.camera.eye_q16[1] = 57 << 16;
            w.b.camera.eye_q16[2] = 1 << 16;
            set_up_vector(&w, 0, i < sizeof lengths / sizeof *lengths ? lengths[i] : 0, 0);
            const int result =
                backends[b].render(&w.b.scene, &w.display, &w.quality, memory_words, sizeof memory_words, &report);
            if (result != GLINT_OK) {
                printf("%s: up of (0, %d, 0) gave %d\n", backends[b].name, w.b.camera.up[1], result);
                wrong++;
            }
        }
    }
    assert_int_equal(wrong, 0);
}

static void test_sizes_are_0_for_bad_input(void **state)
{
    (void)state;
    for (size_t i = 0; i < VARIATIONS; i++) {
        const variation *v = &variations[i];
        for (int b = 0; b < BACKENDS; b++) {
            world w;
            set_up(&w);
            v->change(&w);
            const size_t full = backends[b].memory_bytes(w.scene_argument, w.display_argument);
            const size_t least = backends[b].memory_least_bytes(w.scene_argument, w.display_argument);
            if (v->seen_by_sizes ? full != 0 || least != 0
                                 : v->expected == GLINT_OK && (least == 0 || full < least || full % 4 != 0)) {
                fail_msg("%s, %s: sizes %zu and %zu", v->name, backends[b].name, full, least);
            }
        }
    }
}

static bool is_known(int code)
{
    return strcmp(glint_error_text(code), "unknown error") != 0;
}

/* Every code that has a sentence is provoked above, and the other way round. */
static void test_each_code_has_its_own_sentence(void **state)
{
    (void)state;
    for (int code = -200; code <= 200; code++) {
        assert_non_null(glint_error_text(code));
        assert_true(strlen(glint_error_text(code)) > 5);
        bool provoked = code == GLINT_ERROR_PART; /* by variants of the backends: see test_variants.c */
        for (size_t i = 0; i < VARIATIONS; i++) {
            provoked = provoked || variations[i].expected == code;
        }
        if (provoked != is_known(code)) {
            fail_msg("code %d: %s, but %s", code, glint_error_text(code), provoked ? "provoked" : "not provoked");
        }
        for (int other = -200; other < code; other++) {
            if (is_known(code) && strcmp(glint_error_text(code), glint_error_text(other)) == 0) {
                fail_msg("codes %d and %d: %s", code, other, glint_error_text(code));
            }
        }
    }
    assert_false(is_known(INT_MIN));
    assert_false(is_known(INT_MAX));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_each_variation_gets_its_code),
        cmocka_unit_test(test_up_counts_by_direction_alone),
        cmocka_unit_test(test_sizes_are_0_for_bad_input),
        cmocka_unit_test(test_each_code_has_its_own_sentence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
