/* SPDX-License-Identifier: MIT */
/*
 * The command line of glint-render: tolerances, forced shadings, the report of tiers, and the pictures of how each
 * pixel was shaded.
 */
#include "render_cli.h"

#include <math.h>

#include "examples/scenes/scenes.h"

enum { TIERS = 7 };
static const char *const tier_names[TIERS] = {"unlit", "flat", "gouraud", "curved", "q1", "q2", "exact"};
static const char *const backends[] = {"fixed", "float"};

/* ------------------------------------------------------------------------------------------------------------- reports
 */

static bool is_null(const cJSON *report, const char *key)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(report, key);
    assert_non_null(item);
    return cJSON_IsNull(item);
}

/* The counts at `key` by tier. Returns their sum. */
static double tiers_of(const cJSON *report, const char *key, double *counts)
{
    const cJSON *object = cJSON_GetObjectItemCaseSensitive(report, key);
    double sum = 0;
    assert_true(cJSON_IsObject(object));
    assert_int_equal(cJSON_GetArraySize(object), TIERS);
    for (int i = 0; i < TIERS; i++) {
        counts[i] = number(object, tier_names[i]);
        sum += counts[i];
    }
    return sum;
}

static void tolerance_is_rounded_to_sixteenths(void **state)
{
    static const struct {
        const char *text;
        double codes;
    } cases[] = {{"0.75", 0.75},        {"1", 1},  {"1.03", 1},      {"1.04", 1.0625},
                 {"01.50", 1.5},        {"4.", 4}, {"15.9", 15.875}, {"15.9375", 255. / 16},
                 {"15.9300", 255. / 16}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        assert_good(RUN("sphere-10x6", "-o", in_folder("a.ppm"), "--size", "40x30", "--tolerance", cases[i].text,
                        "--report", in_folder("a.json")));
        cJSON *report = read_report("a.json");
        assert_true(number(report, "tolerance_codes") == cases[i].codes);
        assert_true(number(report, "promise_codes") >= 0.5);
        assert_true(number(report, "promise_codes") <= cases[i].codes);
        assert_true(is_null(report, "shading"));
        cJSON_Delete(report);
    }
}

static void the_default_is_a_tolerance_of_one_code(void **state)
{
    char error[256];
    picture within = {0}, exact = {0};
    int differing = 0;
    (void)state;
    assert_good(RUN("sphere-32x16", "-o", in_folder("a.ppm"), "--report", in_folder("a.json")));
    assert_good(RUN("sphere-32x16", "-o", in_folder("b.ppm"), "--report", in_folder("b.json"), "--tolerance", "1"));
    assert_equal_pictures(in_folder("a.ppm"), in_folder("b.ppm"));
    char *told = read_text(in_folder("a.json")), *expected = read_text(in_folder("b.json"));
    assert_string_equal(told, expected);
    free(told);
    free(expected);

    assert_good(RUN("sphere-32x16", "-o", in_folder("b.ppm"), "--report", in_folder("b.json"), "--shading", "exact"));
    cJSON *report = read_report("b.json");
    assert_true(is_null(report, "tolerance_codes"));
    assert_word(report, "shading", "exact");
    cJSON_Delete(report);

    assert_int_equal(picture_read(in_folder("a.ppm"), &within, error, sizeof error), 0);
    assert_int_equal(picture_read(in_folder("b.ppm"), &exact, error, sizeof error), 0);
    for (int i = 0; i < within.width * within.height * 3; i++) {
        assert_true(abs(within.rgb[i] - exact.rgb[i]) <= 1); /* both within a code of the same real number */
        differing += within.rgb[i] != exact.rgb[i];
    }
    assert_true(differing > 0);
    picture_free(&within);
    picture_free(&exact);
}

static void counts_by_tier_add_up(void **state)
{
    (void)state;
    for (unsigned i = 0; i < demo_scene_count; i++) {
        double triangles[TIERS], pixels[TIERS];
        assert_good(RUN(demo_scenes[i].name, "-o", in_folder("a.ppm"), "--size", "60x40", "--band", "16", "--report",
                        in_folder("a.json")));
        cJSON *report = read_report("a.json");
        const double parts = tiers_of(report, "tier_triangles", triangles), drawn = number(report, "triangles_drawn"),
                     clipped = number(report, "triangles_clipped");
        assert_true(parts >= drawn);
        assert_true(clipped > 0 || parts == drawn);
        assert_true(tiers_of(report, "tier_pixels", pixels) == number(report, "pixels_shaded"));
        assert_true(number(report, "specular_triangles") <= parts);
        for (int tier = 0; tier < TIERS; tier++) {
            assert_true(triangles[tier] > 0 || pixels[tier] == 0);
        }
        const glint_scene *const scene = demo_scenes[i].scene;
        double most = 0;
        for (uint16_t k = 0; k < scene->light_count;
             k++) { /* extended sources are as many lights as they have samples */
            most += parts * (scene->lights[k].kind < GLINT_PANEL ? 1 : scene->lights[k].samples);
        }
        assert_true(number(report, "lights_folded") + number(report, "lights_culled") <= most);
        cJSON_Delete(report);
    }
}

/* A shading that is asked for is the only one, but for triangles beyond what q1 and q2 serve, which are exact, and
 * those that no light reaches, which these two leave unlit. */
static void shadings_force_their_tier(void **state)
{
    static const struct {
        const char *shading;
        int tier;
        bool promises;
    } cases[] = {{"flat", 1, false}, {"gouraud", 2, false}, {"q1", 4, true}, {"q2", 5, true}, {"exact", 6, true}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        double pixels[TIERS];
        assert_good(RUN("sphere-32x16", "-o", in_folder("a.ppm"), "--shading", cases[i].shading, "--report",
                        in_folder("a.json")));
        cJSON *report = read_report("a.json");
        assert_word(report, "shading", cases[i].shading);
        assert_true(is_null(report, "tolerance_codes"));
        assert_true(is_null(report, "promise_codes") == !cases[i].promises);
        tiers_of(report, "tier_pixels", pixels);
        assert_true(pixels[cases[i].tier] > 0);
        for (int tier = 0; tier < TIERS; tier++) {
            const bool leaves_some = cases[i].tier == 4 || cases[i].tier == 5;
            assert_true(tier == cases[i].tier || (leaves_some && (tier == 0 || tier == 6)) || pixels[tier] == 0);
        }
        cJSON_Delete(report);
    }
}

/* -------------------------------------------------------------------------------------------------- tiers and promises
 */

/* The legend of --help: what tier a colour stands for; TIERS for the background. */
static int tier_shown(const uint8_t *rgb)
{
    const int r = rgb[0], g = rgb[1], b = rgb[2];
    if (r == g && g == b) {
        return r == 0 ? TIERS : r < 128 ? 0 : 1;
    }
    if (b > r && b > g) {
        return 2;
    }
    if (g == b && g > r) {
        return 3;
    }
    if (r > 128 && g > 128 && b < 128) {
        return 5;
    }
    assert_true((g > r && g > b) || (r > g && r > b));
    return g > r ? 4 : 6;
}

/* Reads tiers.ppm and promise.pgm and counts the pixels of each tier, the background's last. */
static void read_observation(int width, int height, picture *tiers, picture *promise, double *counts)
{
    char error[256];
    assert_int_equal(picture_read(in_folder("tiers.ppm"), tiers, error, sizeof error), 0);
    assert_int_equal(picture_read(in_folder("promise.pgm"), promise, error, sizeof error), 0);
    assert_int_equal(tiers->width, width);
    assert_int_equal(tiers->height, height);
    assert_int_equal(promise->width, width);
    assert_int_equal(promise->height, height);
    for (int tier = 0; tier <= TIERS; tier++) {
        counts[tier] = 0;
    }
    for (int i = 0; i < width * height; i++) {
        const int tier = tier_shown(tiers->rgb + (size_t)i * 3);
        assert_true((tier == TIERS) == (promise->rgb[(size_t)i * 3] == 0));
        counts[tier]++;
    }
}

/* Nothing of a sphere covers another part of it: each pixel that was shaded is seen. */
static void pictures_agree_with_the_report(void **state)
{
    static const char *const tolerances[] = {"0.75", "1", "4", "15.9"};
    bool shown[TIERS] = {false};
    (void)state;
    for (size_t b = 0; b < 2; b++) {
        for (size_t t = 0; t < 2 * sizeof tolerances / sizeof tolerances[0]; t++) {
            picture tiers = {0}, promise = {0};
            double counts[TIERS + 1], expected[TIERS];
            int most = 0;
            assert_good(RUN(t % 2 ? "sphere-32x16" : "sphere-10x6", "-o", in_folder("a.ppm"), "--backend", backends[b],
                            "--tolerance", tolerances[t / 2], "--size", "240x200", "--tiers", in_folder("tiers.ppm"),
                            "--promise", in_folder("promise.pgm"), "--report", in_folder("a.json")));
            cJSON *report = read_report("a.json");
            read_observation(240, 200, &tiers, &promise, counts);
            const double shaded = tiers_of(report, "tier_pixels", expected);
            assert_true(counts[TIERS] == 240 * 200 - shaded);
            for (int tier = 0; tier < TIERS; tier++) {
                assert_true(counts[tier] == expected[tier]);
                shown[tier] = shown[tier] || counts[tier] > 0;
            }
            for (int i = 0; i < 240 * 200; i++) {
                const int level = promise.rgb[(size_t)i * 3];
                assert_true(level == 0 || level >= 8); /* half a code is rounding */
                most = level > most ? level : most;
            }
            assert_true(most <= (int)ceil(number(report, "promise_codes") * 16));
            assert_true(most > 8);
            cJSON_Delete(report);
            picture_free(&tiers);
            picture_free(&promise);
        }
    }
    for (int tier = 0; tier < TIERS; tier++) {
        assert_true(shown[tier] || tier == 2); /* or some colour of the legend has not been tried; Gouraud below */
    }
}

/* Where surfaces hide each other, a pixel is shown once and may be shaded more often. */
static void hidden_pixels_are_not_shown(void **state)
{
    picture tiers = {0}, promise = {0};
    double counts[TIERS + 1], shaded[TIERS], seen = 0;
    (void)state;
    assert_good(RUN("torus-knot", "-o", in_folder("a.ppm"), "--size", "160x120", "--tiers", in_folder("tiers.ppm"),
                    "--promise", in_folder("promise.pgm"), "--report", in_folder("a.json")));
    cJSON *report = read_report("a.json");
    read_observation(160, 120, &tiers, &promise, counts);
    const double sum = tiers_of(report, "tier_pixels", shaded);
    for (int tier = 0; tier < TIERS; tier++) {
        assert_true(counts[tier] <= shaded[tier]);
        seen += counts[tier];
    }
    assert_true(seen > 0 && seen < sum);
    cJSON_Delete(report);
    picture_free(&tiers);
    picture_free(&promise);
}

/* One material, one light: exact shading promises the same everywhere. Without a promise all of it is white. */
static void promises_of_forced_shadings(void **state)
{
    static const char *const shadings[] = {"exact", "gouraud"};
    (void)state;
    for (size_t s = 0; s < 2; s++) {
        picture tiers = {0}, promise = {0};
        double counts[TIERS + 1];
        assert_good(RUN("sphere-32x16", "-o", in_folder("a.ppm"), "--shading", shadings[s], "--size", "64x48",
                        "--tiers", in_folder("tiers.ppm"), "--promise", in_folder("promise.pgm"), "--report",
                        in_folder("a.json")));
        cJSON *report = read_report("a.json");
        const int level = s == 0 ? (int)ceil(number(report, "promise_codes") * 16) : 255;
        read_observation(64, 48, &tiers, &promise, counts);
        assert_true(counts[s == 0 ? 6 : 2] == 64 * 48 - counts[TIERS]);
        for (int i = 0; i < 64 * 48; i++) {
            assert_true(promise.rgb[(size_t)i * 3] == 0 || promise.rgb[(size_t)i * 3] == level);
        }
        cJSON_Delete(report);
        picture_free(&tiers);
        picture_free(&promise);
    }
}

/* Each pixel against the reference, whose codes are rounded once more. */
static void each_pixel_keeps_its_promise(void **state)
{
    static const char *const scenes[] = {"teapot", "full-phong", "three-lights"};
    static const char *const tolerances[] = {"1", "4", "15.9"};
    (void)state;
    for (size_t s = 0; s < sizeof scenes / sizeof scenes[0]; s++) {
        char error[256];
        picture reference = {0}, mask = {0};
        int greatest = 0;
        assert_good(RUN(scenes[s], "-o", in_folder("reference.ppm"), "--size", "160x120", "--backend", "reference",
                        "--edges", in_folder("mask.pgm")));
        assert_int_equal(picture_read(in_folder("reference.ppm"), &reference, error, sizeof error), 0);
        assert_int_equal(picture_read(in_folder("mask.pgm"), &mask, error, sizeof error), 0);
        for (size_t k = 0; k < 6; k++) {
            picture drawn = {0}, promise = {0};
            assert_good(RUN(scenes[s], "-o", in_folder("a.ppm"), "--size", "160x120", "--backend", backends[k % 2],
                            "--tolerance", tolerances[k / 2], "--promise", in_folder("promise.pgm")));
            assert_int_equal(picture_read(in_folder("a.ppm"), &drawn, error, sizeof error), 0);
            assert_int_equal(picture_read(in_folder("promise.pgm"), &promise, error, sizeof error), 0);
            for (int i = 0; i < 160 * 120 * 3; i++) {
                const int off = abs(drawn.rgb[i] - reference.rgb[i]);
                if (mask.rgb[i] == 0) {
                    assert_true(off * 16 <= promise.rgb[i] + 8);
                    greatest = off > greatest ? off : greatest;
                }
            }
            picture_free(&drawn);
            picture_free(&promise);
        }
        assert_true(greatest > 4); /* the greatest tolerance was made use of */
        picture_free(&reference);
        picture_free(&mask);
    }
}

static void observing_changes_nothing(void **state)
{
    static const char *const formats[] = {"rgb888", "rgb565", "gray4", "mono"};
    (void)state;
    for (size_t k = 0; k < 8; k++) {
        const char *backend = backends[k / 4], *format = formats[k % 4];
        assert_good(RUN("teapot", "-o", in_folder("a.ppm"), "--size", "80x60", "--backend", backend, "--format", format,
                        "--report", in_folder("a.json")));
        assert_good(RUN("teapot", "-o", in_folder("b.ppm"), "--size", "80x60", "--backend", backend, "--format", format,
                        "--report", in_folder("b.json"), "--tiers", in_folder("tiers.ppm")));
        assert_equal_pictures(in_folder("a.ppm"), in_folder("b.ppm"));
        char *plain = read_text(in_folder("a.json")), *observed = read_text(in_folder("b.json"));
        assert_string_equal(plain, observed);
        free(plain);
        free(observed);

        /* and what is observed does not depend on bands and buffers */
        assert_good(RUN("teapot", "-o", in_folder("b.ppm"), "--size", "80x60", "--backend", backend, "--format", format,
                        "--band", "8", "--buffers", "2", "--tiers", in_folder("b-tiers.ppm")));
        assert_equal_pictures(in_folder("a.ppm"), in_folder("b.ppm"));
        assert_equal_pictures(in_folder("tiers.ppm"), in_folder("b-tiers.ppm"));
    }
}

static void pictures_are_png_by_their_ending(void **state)
{
    (void)state;
    if (!picture_has_png()) {
        assert_refused(RUN("teapot", "-o", in_folder("a.ppm"), "--tiers", in_folder("tiers.png")), 1, "libpng");
        assert_refused(RUN("teapot", "-o", in_folder("a.ppm"), "--promise", in_folder("promise.PNG")), 1, "libpng");
        return;
    }
    assert_good(RUN("teapot", "-o", in_folder("a.ppm"), "--size", "80x60", "--tiers", in_folder("tiers.png"),
                    "--promise", in_folder("promise.PNG")));
    assert_good(RUN("teapot", "-o", in_folder("a.ppm"), "--size", "80x60", "--tiers", in_folder("tiers.ppm"),
                    "--promise", in_folder("promise.pgm")));
    assert_equal_pictures(in_folder("tiers.png"), in_folder("tiers.ppm"));
    (void)rename(in_folder("promise.PNG"), in_folder("promise.png"));
    assert_equal_pictures(in_folder("promise.png"), in_folder("promise.pgm"));
}

/* ------------------------------------------------------------------------------------------------------ bad arguments
 */

static void bad_tolerances_are_refused(void **state)
{
    static const char *const bad[] = {
        "0",   "0.74", "0.749999", "15.95", "16", "256",    "-1", "+1",   "",    "none", "nan",
        "inf", "1e0",  "0x2",      " 1",    "1 ", "1codes", ".",  "1.1.", "1,5", "1/16", "99999999999999999999",
        NULL};
    (void)state;
    for (size_t i = 0; bad[i] != NULL; i++) {
        assert_refused(RUN("teapot", "-o", in_folder("none.ppm"), "--tolerance", bad[i]), 2, "0.75..15.9375");
        assert_nothing_at("none.ppm");
    }
    assert_refused(RUN("teapot", "-o", in_folder("none.ppm"), "--tolerance"), 2, "expected a number of codes after it");
}

static void contradictions_are_refused(void **state)
{
    static const struct {
        const char *arguments[6];
        const char *says;
    } cases[] = {
        {{"--tolerance", "1", "--shading", "exact"}, "expected no --shading"},
        {{"--shading", "q2", "--tolerance", "4"}, "expected no --shading"},
        {{"--backend", "reference", "--tolerance", "1"}, "expected no --tolerance"},
        {{"--backend", "reference", "--shading", "q1"}, "expected --shading exact, gouraud or flat"},
        {{"--backend", "reference", "--shading", "q2"}, "expected --shading exact, gouraud or flat"},
        {{"--backend", "reference", "--tiers", "t.ppm"}, "expected no --tiers"},
        {{"--backend", "reference", "--promise", "p.pgm"}, "expected no --promise"},
        {{"--tiers", "t.jpg"}, "ends in .ppm or .png"},
        {{"--promise", "p.ppm"}, "ends in .pgm or .png"},
        {{"--tiers", "t.png", "--promise", "t.png"}, "another file for each"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const char *arguments[MAX_ARGUMENTS] = {"teapot", "-o", in_folder("none.ppm")};
        for (int k = 0; k < 6; k++) {
            arguments[3 + k] = cases[i].arguments[k];
        }
        assert_refused(run(arguments), 2, cases[i].says);
        assert_nothing_at("none.ppm");
        assert_false(exists("t.ppm") || exists("p.pgm") || exists("t.png"));
    }
    assert_refused(RUN("teapot", "-o", in_folder("none.png"), "--tiers", in_folder("none.png")), 2,
                   "another file for each");
    assert_refused(RUN("teapot", "-o", in_folder("none.png"), "--promise", in_folder("none.png")), 2,
                   "another file for each");
    assert_nothing_at("none.png");
}

/* remove_folder() finds what is left under any other name. */
static void unwritable_outputs_leave_nothing(void **state)
{
    static const char *const endings[] = {"pgm", "ppm", "png"};
    (void)state;
    for (int i = 0; i < (picture_has_png() ? 3 : 2); i++) {
        char name[PATH_BYTES];
        const char *option = i == 0 ? "--promise" : "--tiers";
        assert_true(snprintf(name, sizeof name, "nowhere/x.%s", endings[i]) < PATH_BYTES);
        assert_refused(RUN("sphere-10x6", "-o", in_folder("none.ppm"), option, in_folder(name)), 1, name);
        assert_nothing_at("none.ppm");
    }
    /* the picture itself fails last: what was complete before goes */
    assert_refused(RUN("sphere-10x6", "-o", in_folder("nowhere/a.ppm"), "--tiers", in_folder("none.ppm"), "--promise",
                       in_folder("none.pgm"), "--report", in_folder("none.json")),
                   1, "nowhere/a.ppm");
    assert_nothing_at("none.ppm");
    assert_nothing_at("none.pgm");
    assert_nothing_at("none.json");
    if (picture_has_png()) {
        assert_refused(RUN("sphere-10x6", "-o", in_folder("nowhere/a.ppm"), "--tiers", in_folder("none.png")), 1,
                       "nowhere/a.ppm");
        assert_nothing_at("none.png");
        assert_false(exists(in_folder("none.png.part.png")));
    }
    if (exists("/dev/full")) {
        assert_refused(RUN("sphere-10x6", "-o", in_folder("none.ppm"), "--size", "200x200", "--tiers", "/dev/full"), 1,
                       "/dev/full");
        assert_refused(RUN("sphere-10x6", "-o", in_folder("none.ppm"), "--size", "200x200", "--promise", "/dev/full"),
                       1, "/dev/full");
        assert_nothing_at("none.ppm");
    }
}

static int remove_folder(void **state)
{
    static const char *const names[] = {"a.ppm",       "b.ppm",       "a.json",        "b.json",
                                        "tiers.ppm",   "b-tiers.ppm", "tiers.png",     "promise.pgm",
                                        "promise.png", "mask.pgm",    "reference.ppm", NULL};
    (void)state;
    return remove_folder_with(names);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tolerance_is_rounded_to_sixteenths),
        cmocka_unit_test(the_default_is_a_tolerance_of_one_code),
        cmocka_unit_test(counts_by_tier_add_up),
        cmocka_unit_test(shadings_force_their_tier),
        cmocka_unit_test(pictures_agree_with_the_report),
        cmocka_unit_test(hidden_pixels_are_not_shown),
        cmocka_unit_test(promises_of_forced_shadings),
        cmocka_unit_test(each_pixel_keeps_its_promise),
        cmocka_unit_test(observing_changes_nothing),
        cmocka_unit_test(pictures_are_png_by_their_ending),
        cmocka_unit_test(bad_tolerances_are_refused),
        cmocka_unit_test(contradictions_are_refused),
        cmocka_unit_test(unwritable_outputs_leave_nothing),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
