/* SPDX-License-Identifier: MIT */
/*
 * Every file of the fuzzers' corpora through the fuzzers' own checks, without libFuzzer: what a fuzzer has found once
 * stays found. A check that fails aborts the program and names the file.
 */
#include "tests/fuzz/import_check.h"
#include "tests/fuzz/scene_stages.h"

#include <dirent.h>
#include <setjmp.h>
#include <stdarg.h>

#include <cmocka.h>

#define MOST_BYTES 65536

static char folder[64];

typedef void (*check)(const uint8_t *data, size_t size);

/* Of the inputs seen by count_effects(): in how many an effect changes what is drawn. */
static unsigned effects_seen[EFFECTS], effects_refused;

/* Draws the scene with its effects, and without each of them in turn. */
static void count_effects(const uint8_t *data, size_t size)
{
    static scene_trial t;
    const drawing how = {.fail_at = NO_BAND, .buffer_count = 1};
    glint_report report;
    take_trial(data, size, &t);
    t.c.quality.shading = GLINT_SHADING_EXACT;
    t.c.quality.tolerance = 0;
    uint8_t *const before = draw_and_check(&t.c, &how, 0, &report);
    const uint16_t effects = scene_case_effects(&t.effects, &t.c);
    uint8_t *const with = before == NULL ? NULL : draw_and_check(&t.c, &how, 0, &report);
    effects_refused += before != NULL && with == NULL;
    const uint32_t rows =
        t.c.display.format == GLINT_MONO_PAGES ? (t.c.display.height_px + 7u) / 8 : t.c.display.height_px;
    const size_t size_bytes = (size_t)rows * glint_row_bytes(t.c.display.format, t.c.display.width_px);
    for (int effect = 0; effect < EFFECTS && with != NULL; effect++) {
        if (effects >> effect & 1) {
            scene_case less = t.c; /* objects point into t.c, so that is what is changed and put back */
            scene_case_without(&t.c, effect);
            uint8_t *const without = draw_and_check(&t.c, &how, 0, &report);
            effects_seen[effect] += without != NULL && memcmp(with, without, size_bytes) != 0;
            free(without);
            t.c = less;
        }
    }
    free(before);
    free(with);
    scene_case_free(&t.c);
}

static void print_effects(const char *of, unsigned count)
{
    print_message("of %u %s, drawn otherwise with", count, of);
    for (int effect = 0; effect < EFFECTS; effect++) {
        print_message(" %s %u%s", effect_name[effect], effects_seen[effect], effect + 1 < EFFECTS ? "," : "");
    }
    print_message("; refused for an effect %u\n", effects_refused);
}

static void check_import(const uint8_t *data, size_t size)
{
    check_import_bytes(folder, data, size);
}

/* Returns how many files there were. */
static unsigned replay(const char *corpus, check run)
{
    static uint8_t data[MOST_BYTES];
    unsigned count = 0;
    DIR *files = opendir(corpus);
    assert_non_null(files);
    for (const struct dirent *entry = readdir(files); entry != NULL; entry = readdir(files)) {
        char path[512];
        if (entry->d_name[0] == '.') {
            continue;
        }
        (void)snprintf(path, sizeof path, "%s/%s", corpus, entry->d_name);
        FILE *file = fopen(path, "rb");
        assert_non_null(file);
        const size_t size = fread(data, 1, sizeof data, file);
        assert_true(size < sizeof data);
        (void)fclose(file);
        (void)fprintf(stderr, "%s\n", path);
        run(data, size);
        count++;
    }
    (void)closedir(files);
    return count;
}

static void test_scene_corpus(void **state)
{
    (void)state;
    assert_true(replay("tests/fuzz/corpus-scene", check_scene_bytes) > 0);
}

static void test_import_corpus(void **state)
{
    (void)state;
    make_folder(folder, sizeof folder);
    assert_true(replay("tests/fuzz/corpus-import", check_import) > 0);
    (void)rmdir(folder);
}

/* The seeds as scenes, so that the checks are known to meet pictures, errors and everything between. */
static void test_what_the_bytes_make(void **state)
{
    (void)state;
    enum { TRIALS = 4000 };
    unsigned valid = 0, drawn = 0, clipped = 0, specular = 0, invalid = 0, refused = 0, tiers[GLINT_TIERS] = {0};
    uint64_t random = 7;
    for (unsigned i = 0; i < TRIALS; i++) {
        static scene_case c;
        uint8_t data[8];
        glint_report report;
        const drawing how = {.fail_at = NO_BAND, .buffer_count = 1};
        for (int k = 0; k < 8; k++) {
            data[k] = (uint8_t)random_u24(&random);
        }
        bytes b = bytes_from(data, sizeof data);
        scene_case_take(&b, &c);
        uint8_t *pixels = draw_and_check(&c, &how, 0, &report);
        invalid += pixels == NULL; /* draw_and_check() has found that rightly refused */
        if (pixels != NULL) {
            valid++;
            drawn += report.pixels_shaded > 0;
            clipped += report.triangles_clipped > 0;
            specular += report.pixels_specular > 0;
        }
        /* the second drawing of a valid scene */
        c.quality = take_quality(&b);
        const taming tame = take_taming(&b);
        scene_case_tame(&c, &tame);
        uint8_t *within = pixels != NULL ? draw_and_check(&c, &how, 0, &report) : NULL;
        refused += pixels != NULL && within == NULL;
        for (int tier = 0; within != NULL && tier < GLINT_TIERS; tier++) {
            tiers[tier] += report.tier_pixels[tier] > 0;
        }
        free(within);
        free(pixels);
        scene_case_free(&c);
    }
    print_message("of %u inputs: %u valid, %u with pixels, %u with clipping, %u with highlights; %u invalid\n",
                  (unsigned)TRIALS, valid, drawn, clipped, specular, invalid);
    print_message(
        "with a tolerance or a tier: %u refused; %u with pixels of tier unlit, %u flat, %u Gouraud, %u curved, %u q1, "
        "%u q2, %u exact\n",
        refused, tiers[0], tiers[1], tiers[2], tiers[3], tiers[4], tiers[5], tiers[6]);
    assert_true(refused > TRIALS / 100);
    for (int tier = 0; tier < GLINT_TIERS; tier++) {
        assert_true(tiers[tier] > TRIALS / 1000 || tier == GLINT_TIER_GOURAUD); /* which no tolerance chooses */
    }
    assert_true(valid > TRIALS / 2 && invalid > TRIALS / 50);
    assert_true(drawn > TRIALS / 5 && clipped > TRIALS / 10 && specular > TRIALS / 50);
}

/* The committed inputs reach each effect, and random ones do. */
static void test_effects_are_reached(void **state)
{
    (void)state;
    enum { TRIALS = 4000 };
    memset(effects_seen, 0, sizeof effects_seen);
    effects_refused = 0;
    const unsigned files = replay("tests/fuzz/corpus-scene", count_effects);
    print_effects("inputs of the corpus", files);
    for (int effect = 0; effect < EFFECTS; effect++) {
        assert_true(effects_seen[effect] > 1);
        effects_seen[effect] = 0;
    }
    effects_refused = 0;
    uint64_t random = 7;
    for (unsigned i = 0; i < TRIALS; i++) {
        uint8_t data[24];
        for (size_t k = 0; k < sizeof data; k++) {
            data[k] = (uint8_t)random_u24(&random);
        }
        count_effects(data, sizeof data);
    }
    print_effects("random inputs", TRIALS);
    for (int effect = 0; effect < EFFECTS; effect++) {
        assert_true(effects_seen[effect] > TRIALS / 400);
    }
    assert_true(effects_refused > TRIALS / 50);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scene_corpus),
        cmocka_unit_test(test_import_corpus),
        cmocka_unit_test(test_what_the_bytes_make),
        cmocka_unit_test(test_effects_are_reached),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
