/* SPDX-License-Identifier: MIT */
/*
 * The command line of glint-render: what it draws and reports for good arguments, and how it refuses bad ones. What
 * concerns tolerances is in test_render_tolerance.c.
 */
#include "render_cli.h"

#include "examples/scenes/scenes.h"

/* ----------------------------------------------------------------------------------------------------- good arguments
 */

static void list_names_every_scene(void **state)
{
    (void)state;
    outcome o = RUN("--list");
    const char *line = o.standard_output;
    assert_int_equal(o.status, 0);
    for (unsigned i = 0; i < demo_scene_count; i++) {
        char size[24];
        const size_t length = strlen(demo_scenes[i].name);
        assert_memory_equal(line, demo_scenes[i].name, length);
        assert_int_equal(line[length], ' ');
        (void)snprintf(size, sizeof size, " %ux%u ", (unsigned)demo_scenes[i].width_px,
                       (unsigned)demo_scenes[i].height_px);
        const char *end = strchr(line, '\n');
        assert_non_null(end);
        assert_non_null(strstr(line, size));
        assert_true(strstr(line, size) < end);
        assert_non_null(strstr(line, demo_scenes[i].title));
        line = end + 1;
    }
    assert_string_equal(line, "");
    free_outcome(&o);
}

static void help_tells_the_usage(void **state)
{
    (void)state;
    outcome o = RUN("--help");
    assert_int_equal(o.status, 0);
    assert_non_null(strstr(o.standard_output, "usage: glint-render SCENE -o FILE.ppm"));
    free_outcome(&o);
}

static void every_backend_shading_and_format_draws(void **state)
{
    static const char *const backends[] = {"fixed", "float"};
    static const char *const shadings[] = {"flat", "gouraud", "exact", "q1", "q2"};
    static const char *const formats[] = {"rgb888", "rgb565", "gray8", "gray4", "mono"};
    static const char *const dithers[] = {"none", "bayer"};
    (void)state;
    for (size_t b = 0; b < 2; b++) {
        for (size_t s = 0; s < sizeof shadings / sizeof shadings[0]; s++) {
            for (size_t f = 0; f < 5; f++) {
                for (size_t d = 0; d < 2; d++) {
                    char error[256];
                    picture p = {0};
                    assert_good(RUN("sphere-10x6", "-o", in_folder("a.ppm"), "--size", "50x37", "--backend",
                                    backends[b], "--shading", shadings[s], "--format", formats[f], "--dither",
                                    dithers[d]));
                    assert_int_equal(picture_read(in_folder("a.ppm"), &p, error, sizeof error), 0);
                    assert_int_equal(p.width, 50);
                    assert_int_equal(p.height, 37);
                    picture_free(&p);
                }
            }
        }
    }
}

/* Levels that a format can show: grey, of n bits. */
static void formats_show_their_levels_only(void **state)
{
    static const struct {
        const char *format;
        int levels;
    } greys[] = {{"gray8", 256}, {"gray4", 16}, {"mono", 2}};
    (void)state;
    for (size_t f = 0; f < sizeof greys / sizeof greys[0]; f++) {
        char error[256];
        picture p = {0};
        bool dark = false, light = false;
        assert_good(RUN("sphere-32x16", "-o", in_folder("levels.ppm"), "--size", "64x48", "--format", greys[f].format,
                        "--dither", "bayer"));
        assert_int_equal(picture_read(in_folder("levels.ppm"), &p, error, sizeof error), 0);
        for (int i = 0; i < p.width * p.height; i++) {
            const uint8_t *rgb = p.rgb + (size_t)i * 3;
            const int most = greys[f].levels - 1;
            const int level = (rgb[0] * most + 127) / 255;
            assert_int_equal(rgb[0], (level * 255 + most / 2) / most);
            assert_int_equal(rgb[0], rgb[1]);
            assert_int_equal(rgb[0], rgb[2]);
            dark = dark || rgb[0] < 64;
            light = light || rgb[0] > 128;
        }
        assert_true(dark && light); /* the picture shows something */
        picture_free(&p);
    }
}

static void picture_does_not_depend_on_band_memory_or_buffers(void **state)
{
    static const char *const bands[] = {"1", "7", "16", "47", "48"};
    static const char *const backends[] = {"fixed", "float"};
    (void)state;
    for (size_t b = 0; b < 2; b++) {
        assert_good(RUN("sphere-32x16", "-o", in_folder("whole.ppm"), "--size", "64x48", "--backend", backends[b]));
        for (size_t i = 0; i < sizeof bands / sizeof bands[0]; i++) {
            for (size_t buffers = 1; buffers <= 2; buffers++) {
                assert_good(RUN("sphere-32x16", "-o", in_folder("band.ppm"), "--size", "64x48", "--backend",
                                backends[b], "--band", bands[i], "--buffers", buffers == 1 ? "1" : "2"));
                assert_equal_pictures(in_folder("whole.ppm"), in_folder("band.ppm"));
            }
        }
    }
}

static void report_is_json_and_its_counts_agree(void **state)
{
    (void)state;
    for (unsigned i = 0; i < demo_scene_count; i++) {
        double triangles = 0;
        assert_good(RUN(demo_scenes[i].name, "-o", in_folder("r.ppm"), "--size", "60x40", "--band", "16", "--shading",
                        "exact", "--report", in_folder("r.json")));
        cJSON *report = read_report("r.json");
        assert_word(report, "scene", demo_scenes[i].name);
        assert_word(report, "backend", "fixed");
        assert_word(report, "shading", "exact");
        assert_word(report, "format", "rgb888");
        assert_word(report, "dither", "none");
        assert_true(number(report, "width_px") == 60 && number(report, "height_px") == 40);
        assert_true(number(report, "bands") == 3);

        for (int o = 0; o < demo_scenes[i].scene->object_count; o++) {
            triangles += demo_scenes[i].scene->objects[o].mesh->triangle_count;
        }
        assert_true(number(report, "triangles") == triangles);
        assert_true(triangles == number(report, "triangles_drawn") + number(report, "triangles_facing_away") +
                                     number(report, "triangles_outside") + number(report, "triangles_empty") +
                                     number(report, "triangles_refused"));
        assert_true(number(report, "triangles_clipped") <= number(report, "triangles_drawn"));
        assert_true(number(report, "triangles_drawn") > 0);
        assert_true(number(report, "pixels_shaded") > 0);
        assert_true(number(report, "pixels_specular") <= number(report, "pixels_shaded"));
        assert_true(number(report, "vertices_transformed") > 0);
        assert_true(number(report, "memory_used_bytes") > 0);
        assert_true(number(report, "memory_used_bytes") <= number(report, "memory_bytes"));
        cJSON_Delete(report);
    }
}

/* Too little memory is refused with the least that would do; exactly that does, more slowly, with the same picture. */
static void memory_least_is_told_and_is_enough(void **state)
{
    static const char *const backends[] = {"fixed", "float"}, *const scenes[] = {"sphere-32x16", "shadows-lamps"};
    (void)state;
    for (size_t i = 0; i < 4; i++) {
        const size_t b = i % 2;
        const char *const scene = scenes[i / 2];
        unsigned long least = 0;
        char least_text[24], below_text[24];

        assert_good(RUN(scene, "-o", in_folder("whole.ppm"), "--size", "64x48", "--band", "8", "--backend", backends[b],
                        "--report", in_folder("whole.json")));
        outcome o = RUN(scene, "-o", in_folder("none.ppm"), "--size", "64x48", "--band", "8", "--backend", backends[b],
                        "--memory", "4");
        assert_int_equal(o.status, 1);
        const char *told = strstr(o.standard_error, "at least ");
        assert_non_null(told);
        least = strtoul(told + strlen("at least "), NULL, 10);
        assert_true(least > 4);
        free_outcome(&o);
        assert_nothing_at("none.ppm");

        (void)snprintf(least_text, sizeof least_text, "%lu", least);
        (void)snprintf(below_text, sizeof below_text, "%lu", least - 1);
        assert_refused(RUN(scene, "-o", in_folder("none.ppm"), "--size", "64x48", "--band", "8", "--backend",
                           backends[b], "--memory", below_text),
                       1, "at least ");
        assert_nothing_at("none.ppm");
        assert_good(RUN(scene, "-o", in_folder("least.ppm"), "--size", "64x48", "--band", "8", "--backend", backends[b],
                        "--memory", least_text, "--report", in_folder("least.json")));
        assert_equal_pictures(in_folder("whole.ppm"), in_folder("least.ppm"));

        cJSON *whole = read_report("whole.json"), *small = read_report("least.json");
        assert_true(number(small, "memory_bytes") == (double)least);
        assert_true(number(small, "memory_bytes") < number(whole, "memory_bytes"));
        assert_true(number(small, "vertices_transformed") > number(whole, "vertices_transformed"));
        assert_true(number(small, "pixels_shaded") == number(whole, "pixels_shaded"));
        cJSON_Delete(whole);
        cJSON_Delete(small);
    }
}

static void turn_is_in_degrees(void **state)
{
    char error[256];
    picture a = {0}, b = {0};
    (void)state;
    assert_good(RUN("teapot", "-o", in_folder("t0.ppm"), "--size", "64x48"));
    assert_good(RUN("teapot", "-o", in_folder("t360.ppm"), "--size", "64x48", "--turn", "360"));
    assert_equal_pictures(in_folder("t0.ppm"), in_folder("t360.ppm"));
    assert_good(RUN("teapot", "-o", in_folder("t90.ppm"), "--size", "64x48", "--turn", "90"));
    assert_good(RUN("teapot", "-o", in_folder("t-270.ppm"), "--size", "64x48", "--turn", "-270"));
    assert_equal_pictures(in_folder("t90.ppm"), in_folder("t-270.ppm"));
    assert_int_equal(picture_read(in_folder("t0.ppm"), &a, error, sizeof error), 0);
    assert_int_equal(picture_read(in_folder("t90.ppm"), &b, error, sizeof error), 0);
    assert_true(memcmp(a.rgb, b.rgb, (size_t)a.width * (size_t)a.height * 3) != 0);
    picture_free(&a);
    picture_free(&b);
}

static void reference_writes_picture_and_mask(void **state)
{
    char error[256];
    picture mask = {0};
    int contested = 0;
    (void)state;
    assert_good(RUN("sphere-10x6", "-o", in_folder("reference.ppm"), "--size", "64x48", "--backend", "reference",
                    "--edges", in_folder("mask.pgm")));
    assert_true(exists(in_folder("reference.ppm")));
    assert_int_equal(picture_read(in_folder("mask.pgm"), &mask, error, sizeof error), 0);
    assert_int_equal(mask.width, 64);
    assert_int_equal(mask.height, 48);
    for (int i = 0; i < mask.width * mask.height; i++) {
        const uint8_t code = mask.rgb[(size_t)i * 3];
        assert_true(code == 0 || code == 255);
        contested += code == 255;
    }
    assert_true(contested < mask.width * mask.height / 10); /* a few pixels on edges */
    picture_free(&mask);
}

static void png_by_its_ending(void **state)
{
    (void)state;
    if (!picture_has_png()) {
        assert_refused(RUN("teapot", "-o", in_folder("a.png")), 1, "libpng");
        assert_nothing_at("a.png");
        return;
    }
    assert_good(RUN("teapot", "-o", in_folder("a.png"), "--size", "40x30"));
    assert_good(RUN("teapot", "-o", in_folder("b.ppm"), "--size", "40x30"));
    assert_equal_pictures(in_folder("a.png"), in_folder("b.ppm"));
}

/* ------------------------------------------------------------------------------------------------------ bad arguments
 */

static void bad_command_lines_are_refused(void **state)
{
    static const struct {
        const char *arguments[8];
        const char *says;
    } cases[] = {
        {{NULL}, "expected a scene"},
        {{"-o"}, "-o: expected a file name"},
        {{"teapot"}, "expected -o FILE.ppm"},
        {{"teapot", "knot"}, "expected one scene"},
        {{"--colour", "red"}, "--colour: no such option"},
        {{"-x"}, "-x: no such option"},
        {{"--list", "teapot"}, "--list: expected nothing else"},
        {{"teapot", "--backend"}, "--backend: expected fixed, float or reference after it"},
        {{"teapot", "--backend", "double"}, "expected one of fixed, float, reference"},
        {{"teapot", "--shading", "phong"}, "expected one of exact, q2, q1, gouraud, flat"},
        {{"teapot", "--format", "grey8"}, "expected one of rgb888, rgb565, gray8, gray4, mono"},
        {{"teapot", "--dither", "yes"}, "expected one of none, bayer"},
        {{"teapot", "--size", "0x0"}, "expected WxH in pixels such as 320x240, each 1..2048"},
        {{"teapot", "--size", "5000x5000"}, "each 1..2048"},
        {{"teapot", "--size", "2049x1"}, "each 1..2048"},
        {{"teapot", "--size", "320"}, "expected WxH"},
        {{"teapot", "--size", "320x240x3"}, "expected WxH"},
        {{"teapot", "--size", "-320x240"}, "expected WxH"},
        {{"teapot", "--size", "99999999999999999999x1"}, "expected WxH"},
        {{"teapot", "--band", "0"}, "expected a whole number, 1..2048"},
        {{"teapot", "--band", "7.5"}, "expected a whole number"},
        {{"teapot", "--buffers", "3"}, "expected a whole number, 1..2"},
        {{"teapot", "--memory", "much"}, "expected a whole number"},
        {{"teapot", "--turn", "left"}, "expected an angle in degrees"},
        {{"teapot", "--turn", "nan"}, "expected an angle in degrees"},
        {{"teapot", "--turn", "1e300"}, "expected an angle in degrees"},
        {{"teapot", "--turn", "30", "--turn", "40"}, "--turn: expected it once"},
        {{"teapot", "-o", "a.jpg"}, "ends in .ppm or .png"},
        {{"teapot", "--report", "a.txt"}, "ends in .json"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        assert_refused(run(cases[i].arguments), 2, cases[i].says);
    }
}

/* Options that exclude each other, with an output that must not appear. */
static void contradictions_are_refused(void **state)
{
    static const struct {
        const char *arguments[6];
        const char *says;
    } cases[] = {
        {{"--backend", "reference", "--format", "rgb565"}, "expected --format rgb888"},
        {{"--backend", "reference", "--band", "16"}, "expected no --band"},
        {{"--backend", "reference", "--memory", "4000"}, "expected no --memory"},
        {{"--backend", "reference", "--buffers", "2"}, "expected no --buffers"},
        {{"--backend", "reference", "--dither", "bayer"}, "expected no --dither"},
        {{"--backend", "reference", "--report", "r.json"}, "expected no --report"},
        {{"--backend", "fixed", "--edges", "e.pgm"}, "expected --backend reference"},
        {{"--format", "mono", "--band", "7"}, "expected a multiple of 8"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const char *arguments[MAX_ARGUMENTS] = {"teapot", "-o", in_folder("contradiction.ppm")};
        for (int k = 0; k < 6; k++) {
            arguments[3 + k] = cases[i].arguments[k];
        }
        assert_refused(run(arguments), 2, cases[i].says);
        assert_nothing_at("contradiction.ppm");
        assert_false(exists("r.json") || exists("e.pgm"));
    }
}

static void unknown_scenes_point_to_the_list(void **state)
{
    (void)state;
    assert_refused(RUN("teapott", "-o", in_folder("s.ppm")), 2, "--list");
    assert_refused(RUN("", "-o", in_folder("s.ppm")), 2, "--list");
    assert_nothing_at("s.ppm");
}

/* With the importer the file is what is wrong, without it the message says what to install. */
static void files_that_cannot_be_read_are_named(void **state)
{
    (void)state;
    outcome o = RUN(in_folder("missing.obj"), "-o", in_folder("s.ppm"));
    assert_int_equal(o.status, 1);
    assert_true(strstr(o.standard_error, "missing.obj") != NULL || strstr(o.standard_error, "assimp") != NULL);
    free_outcome(&o);
    assert_nothing_at("s.ppm");
}

static void unwritable_outputs_leave_nothing(void **state)
{
    (void)state;
    assert_refused(RUN("sphere-10x6", "-o", in_folder("nowhere/a.ppm")), 1, "nowhere/a.ppm");
    assert_refused(RUN("sphere-10x6", "-o", in_folder("p.ppm"), "--report", in_folder("nowhere/r.json")), 1,
                   "nowhere/r.json");
    assert_nothing_at("p.ppm");
    assert_refused(RUN("sphere-10x6", "-o", in_folder("nowhere/a.ppm"), "--report", in_folder("q.json")), 1,
                   "nowhere/a.ppm");
    assert_nothing_at("q.json");
    assert_refused(
        RUN("sphere-10x6", "-o", in_folder("p.ppm"), "--backend", "reference", "--edges", in_folder("nowhere/e.pgm")),
        1, "nowhere/e.pgm");
    assert_nothing_at("p.ppm");
    if (exists("/dev/full")) {
        assert_refused(RUN("sphere-10x6", "-o", "/dev/full", "--size", "200x200"), 1, "/dev/full");
    }
}

/* --------------------------------------------------------------------------------------------------------- the program
 */

static int remove_folder(void **state)
{
    static const char *const names[] = {"a.ppm",    "b.ppm",         "a.png",      "band.ppm",  "levels.ppm",
                                        "r.ppm",    "r.json",        "whole.ppm",  "t0.ppm",    "t360.ppm",
                                        "t90.ppm",  "t-270.ppm",     "whole.json", "least.ppm", "least.json",
                                        "mask.pgm", "reference.ppm", NULL};
    (void)state;
    return remove_folder_with(names);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(list_names_every_scene),
        cmocka_unit_test(help_tells_the_usage),
        cmocka_unit_test(every_backend_shading_and_format_draws),
        cmocka_unit_test(formats_show_their_levels_only),
        cmocka_unit_test(picture_does_not_depend_on_band_memory_or_buffers),
        cmocka_unit_test(report_is_json_and_its_counts_agree),
        cmocka_unit_test(memory_least_is_told_and_is_enough),
        cmocka_unit_test(turn_is_in_degrees),
        cmocka_unit_test(reference_writes_picture_and_mask),
        cmocka_unit_test(png_by_its_ending),
        cmocka_unit_test(bad_command_lines_are_refused),
        cmocka_unit_test(contradictions_are_refused),
        cmocka_unit_test(unknown_scenes_point_to_the_list),
        cmocka_unit_test(files_that_cannot_be_read_are_named),
        cmocka_unit_test(unwritable_outputs_leave_nothing),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
