/* SPDX-License-Identifier: MIT */
/*
 * glint-panel-decode: its status and words, and which picture it writes. The environment variable GLINT_BUILD names the
 * folder where it is (default: build).
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

#include "tools/picture/picture.h"

static char folder[] = "build/panel-decode-XXXXXX";
static char output[4096];

/* An ST7789's glass of 2x3: blue at its upper left, red at its lower right, which ends the frame; then off. */
static const char events[] =
    "# asleep until 1 ms\n"
    "1000000 dc 0\n1000000 byte 11\n"
    "200000000 byte 21\n200000000 byte 29\n200000000 byte 3a\n200000000 dc 1\n200000000 byte 55\n"
    "200000000 dc 0\n200000000 byte 2a\n200000000 dc 1\n"
    "200000000 byte 00\n200000000 byte 00\n200000000 byte 00\n200000000 byte 01\n"
    "200000000 dc 0\n200000000 byte 2b\n200000000 dc 1\n"
    "200000000 byte 00\n200000000 byte 00\n200000000 byte 00\n200000000 byte 02\n"
    "200000000 dc 0\n200000000 byte 2c\n200000000 dc 1\n"
    "300000000 byte 00\n300000000 byte 1f\n"
    "300000000 byte 00\n300000000 byte 00\n300000000 byte 00\n300000000 byte 00\n"
    "300000000 byte 00\n300000000 byte 00\n300000000 byte 00\n300000000 byte 00\n"
    "400000000 byte f8\n400000000 byte 00\n"
    "500000000 dc 0\n500000000 byte 28\n";

static const char *path_of(const char *name)
{
    static char path[128];
    (void)snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

/* Runs it on a stream; the status of its exit, its words in `output`. */
static int decode(const char *stream, const char *arguments)
{
    char command[512];
    const char *build = getenv("GLINT_BUILD");
    FILE *file = fopen(path_of("events"), "w");
    assert_non_null(file);
    assert_true(fputs(stream, file) >= 0);
    assert_int_equal(fclose(file), 0);
    assert_true(snprintf(command, sizeof command, "%s/glint-panel-decode %s < %s/events 2>&1", build ? build : "build",
                         arguments, folder) < (int)sizeof command);
    FILE *pipe = popen(command, "r");
    assert_non_null(pipe);
    const size_t length = fread(output, 1, sizeof output - 1, pipe);
    output[length] = '\0';
    const int status = pclose(pipe);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

/* As above with the picture written; expects its size. */
static picture decode_picture(const char *more, int width, int height)
{
    char arguments[256];
    (void)snprintf(arguments, sizeof arguments, "--controller st7789 --size 2x3 %s -o %s/out.ppm", more, folder);
    assert_int_equal(decode(events, arguments), 0);
    picture p;
    assert_int_equal(picture_read(path_of("out.ppm"), &p, NULL, 0), 0);
    assert_int_equal(p.width, width);
    assert_int_equal(p.height, height);
    return p;
}

static void assert_rgb(const picture *p, int x, int y, unsigned rgb)
{
    const uint8_t *at = p->rgb + ((size_t)y * (size_t)p->width + (size_t)x) * 3;
    assert_int_equal((unsigned)at[0] << 16 | (unsigned)at[1] << 8 | at[2], rgb);
}

static void the_picture_is_that_of_the_time_asked_for(void **state)
{
    (void)state;
    picture p = decode_picture("", 2, 3);
    assert_rgb(&p, 0, 0, 0); /* off at the end */
    picture_free(&p);
    assert_non_null(strstr(output, "violations 0\nframes 1\nbytes 29\n"));
    p = decode_picture("--at 300000000", 2, 3);
    assert_rgb(&p, 0, 0, 0x0000ff);
    assert_rgb(&p, 1, 2, 0);
    picture_free(&p);
    p = decode_picture("--frame 1", 2, 3);
    assert_rgb(&p, 0, 0, 0x0000ff);
    assert_rgb(&p, 1, 2, 0xff0000);
    picture_free(&p);
}

static void the_picture_is_turned(void **state)
{
    (void)state;
    picture p = decode_picture("--frame 1 --turned 90", 3, 2);
    assert_rgb(&p, 2, 0, 0x0000ff);
    assert_rgb(&p, 0, 1, 0xff0000);
    picture_free(&p);
    p = decode_picture("--frame 1 --turned 180", 2, 3);
    assert_rgb(&p, 1, 2, 0x0000ff);
    picture_free(&p);
    p = decode_picture("--frame 1 --turned 270", 3, 2);
    assert_rgb(&p, 0, 1, 0x0000ff);
    assert_rgb(&p, 2, 0, 0xff0000);
    picture_free(&p);
}

static void the_glass_is_as_told(void **state)
{
    (void)state;
    picture p = decode_picture("--frame 1 --glass bgr,normal", 2, 3);
    assert_rgb(&p, 0, 0, 0x00ffff); /* blue, inverted, as blue-green-red */
    picture_free(&p);
    p = decode_picture("--frame 1 --offset 1,2 --size 1x1", 1, 1);
    assert_rgb(&p, 0, 0, 0xff0000);
    picture_free(&p);
}

static void violations_are_told(void **state)
{
    (void)state;
    assert_int_equal(decode("1 dc 0\n1 byte 02\n", "--controller st7789 --size 2x3"), 1);
    assert_non_null(strstr(output, "violation 1: unknown command 02\nviolations 1\n"));
}

static void mistakes_of_the_caller_are_told(void **state)
{
    (void)state;
    static const char *const wrong[] = {
        "",
        "--controller st7788 --size 2x3",
        "--controller st7789",
        "--controller st7789 --size 2",
        "--controller st7789 --size 241x3",
        "--controller st7789 --size 2x3 --turned 45",
        "--controller st7789 --size 2x3 --glass square",
        "--controller st7789 --size 2x3 --frame",
        "--controller st7789 --size 2x3 --frame 2",
        "--controller st7789 --size 2x3 --at soon",
        "--controller st7789 --size 2x3 --colour",
        "--controller st7789 --size 2x3 -o build/no/such/folder.ppm",
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_int_equal(decode(events, wrong[i]), 2);
        assert_true(strlen(output) > 10);
    }
    assert_int_equal(decode("1 tick 1\n", "--controller st7789 --size 2x3"), 2);
    assert_non_null(strstr(output, "line 1 is no event: 1 tick 1"));
    assert_int_equal(decode("", "--help"), 0);
}

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) == NULL;
}

static int remove_folder(void **state)
{
    (void)state;
    (void)remove(path_of("events"));
    (void)remove(path_of("out.ppm"));
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_picture_is_that_of_the_time_asked_for),
        cmocka_unit_test(the_picture_is_turned),
        cmocka_unit_test(the_glass_is_as_told),
        cmocka_unit_test(violations_are_told),
        cmocka_unit_test(mistakes_of_the_caller_are_told),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
