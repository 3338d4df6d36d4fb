/* SPDX-License-Identifier: MIT */
/*
 * Tests of the picture files and of glint-compare, which is run as a program: the one that GLINT_COMPARE names, or
 * build/glint-compare. Files go to a directory that GLINT_TEST_DIR names, or to build/. Needs POSIX
 * (popen(), mkdtemp()), that is -D_POSIX_C_SOURCE=200809L under -std=c99.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

#include "tools/picture/picture.h"

static char directory[256];

static const char *file_name(const char *name)
{
    static char names[8][400];
    static int next;
    next = (next + 1) % 8;
    snprintf(names[next], sizeof names[next], "%s/%s", directory, name);
    return names[next];
}

static void write_bytes(const char *name, const char *bytes, size_t count)
{
    FILE *file = fopen(file_name(name), "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, count, file), count);
    assert_int_equal(fclose(file), 0);
}

static int is_there(const char *name)
{
    struct stat status;
    return stat(file_name(name), &status) == 0;
}

/* A picture whose every value differs from its neighbours'. */
static picture make_picture(int width, int height)
{
    picture p;
    char error[200];
    assert_int_equal(picture_create(&p, width, height, error, sizeof error), 0);
    for (int i = 0; i < width * height * 3; i++) {
        p.rgb[i] = (uint8_t)(i * 37 + i / 7);
    }
    return p;
}

static void write_picture(const char *name, const picture *p)
{
    char error[300] = "";
    if (picture_write(file_name(name), p, error, sizeof error)) {
        fail_msg("%s", error);
    }
}

static void expect_same(const picture *a, const picture *b)
{
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    assert_memory_equal(a->rgb, b->rgb, (size_t)a->width * (size_t)a->height * 3);
}

static void pictures_come_back_as_written(void **state)
{
    static const char *const names[] = {"back.ppm", "back.png", "back.PNG"};
    picture p = make_picture(13, 7), q;
    char error[300] = "";
    (void)state;
    for (int i = 0; i < 3; i++) {
        if (i > 0 && !picture_has_png()) {
            assert_int_equal(picture_write(file_name(names[i]), &p, error, sizeof error), -1);
            assert_non_null(strstr(error, "libpng-dev"));
            assert_int_equal(picture_read(file_name(names[i]), &q, error, sizeof error), -1);
            assert_non_null(strstr(error, "libpng-dev"));
            continue;
        }
        write_picture(names[i], &p);
        assert_int_equal(picture_read(file_name(names[i]), &q, error, sizeof error), 0);
        expect_same(&p, &q);
        picture_free(&q);
    }
    assert_false(is_there("back.ppm.part"));
    picture_free(&p);
}

static void netpbm_headers_are_read(void **state)
{
    static const char grey[] = "P5 # grey\n#another comment\n 2\t1\r\n255\n\x07\xff";
    picture p;
    char error[300] = "";
    (void)state;
    write_bytes("grey.pgm", grey, sizeof grey - 1);
    assert_int_equal(picture_read(file_name("grey.pgm"), &p, error, sizeof error), 0);
    assert_int_equal(p.width, 2);
    assert_int_equal(p.height, 1);
    assert_memory_equal(p.rgb, "\x07\x07\x07\xff\xff\xff", 6);
    picture_free(&p);
}

static void damaged_files_are_refused(void **state)
{
    static const struct {
        const char *bytes, *says;
    } cases[] = {
        {"", "P6"},
        {"P", "P6"},
        {"P3\n1 1\n255\n1 2 3\n", "P6"},
        {"P6", "a width"},
        {"P6\n1", "a width"},
        {"P6\n1 1 255", "a width"},
        {"P6\nx 1\n255\nabc", "a width"},
        {"P6\n-1 1\n255\nabc", "a width"},
        {"P6\n1 1\n# no end", "a width"},
        {"P6\n0 1\n255\n", "0 x 1"},
        {"P6\n1 16385\n255\nabc", "16385"},
        {"P6\n99999999999999999999 1\n255\nabc", "16384"},
        {"P6\n1 1\n65535\nabcdef", "65535"},
        {"P6\n1 1\n1\nabc", "maxval"},
        {"P6\n2 1\n255\nabcde", "6 bytes"},
        {"P6\n16384 16384\n255\nabc", "cut short"},
        {"P5\n2 1\n255\na", "2 bytes"},
        {"P6\n1 1\n255\nabcd", "after the picture"},
    };
    char error[300];
    picture p;
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        write_bytes("damaged.ppm", cases[i].bytes, strlen(cases[i].bytes));
        error[0] = '\0';
        assert_int_equal(picture_read(file_name("damaged.ppm"), &p, error, sizeof error), -1);
        assert_null(p.rgb);
        if (!strstr(error, cases[i].says)) {
            fail_msg("case %d: \"%s\" does not say \"%s\"", (int)i, error, cases[i].says);
        }
    }
    assert_int_equal(picture_read(file_name("not there.ppm"), &p, error, sizeof error), -1);
    assert_int_equal(picture_read(directory, &p, error, sizeof error), -1);
    assert_int_equal(picture_read(file_name("not there.ppm"), &p, NULL, 0), -1);
}

static void damaged_png_is_refused(void **state)
{
    char error[300] = "", bytes[2000];
    picture p = make_picture(13, 7);
    (void)state;
    if (!picture_has_png()) {
        picture_free(&p);
        skip();
    }
    write_picture("whole.png", &p);
    picture_free(&p);
    FILE *file = fopen(file_name("whole.png"), "rb");
    assert_non_null(file);
    size_t count = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    for (size_t cut = 0; cut + 12 < count; cut += 9) { /* the last 12 bytes only say that it ends */
        write_bytes("cut.png", bytes, cut);
        assert_int_equal(picture_read(file_name("cut.png"), &p, error, sizeof error), -1);
        assert_null(p.rgb);
    }
}

static void absurd_sizes_are_refused(void **state)
{
    static const int sizes[][2] = {{0, 1}, {1, 0}, {-1, 1}, {PICTURE_MAX_SIZE_PX + 1, 1}, {1, PICTURE_MAX_SIZE_PX + 1}};
    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        picture p;
        char error[300] = "";
        assert_int_equal(picture_create(&p, sizes[i][0], sizes[i][1], error, sizeof error), -1);
        assert_null(p.rgb);
        assert_non_null(strstr(error, "expected"));
    }
}

static void unwritable_outputs_are_errors(void **state)
{
    picture p = make_picture(200, 200);
    char error[300] = "";
    (void)state;
    assert_int_equal(picture_write(file_name("no such directory/x.ppm"), &p, error, sizeof error), -1);
    assert_non_null(strstr(error, "expected"));
    assert_int_equal(picture_write(directory, &p, error, sizeof error), -1); /* a directory is in the way */
    char part[300];
    snprintf(part, sizeof part, "%s.part", directory);
    assert_int_equal(access(part, F_OK), -1);
    if (access("/dev/full", W_OK) == 0) {
        assert_int_equal(picture_write("/dev/full", &p, error, sizeof error), -1);
        assert_non_null(strstr(error, "could not be written"));
    }
    struct stat status;
    assert_int_equal(picture_write("/dev/null", &p, error, sizeof error), 0);
    assert_int_equal(stat("/dev/null", &status), 0);
    assert_true(S_ISCHR(status.st_mode));
    picture_free(&p);
}

/* Runs glint-compare with the files' directory as its working directory. Returns its exit code; `out` is what it
 * printed, on stderr when `errors` is set. */
static int compare(const char *arguments, int errors, char *out, size_t out_bytes)
{
    char command[1500];
    size_t got;
    int status;
    snprintf(command, sizeof command, "cd '%s' && \"$GLINT_COMPARE\" %s %s", directory, arguments,
             errors ? "2>&1 >/dev/null" : "2>/dev/null");
    FILE *pipe = popen(command, "r"); /* NOLINT(cert-env33-c): the shell gives the directory and the redirection */
    assert_non_null(pipe);
    got = fread(out, 1, out_bytes - 1, pipe);
    out[got] = '\0';
    status = pclose(pipe);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void expect_line(const char *arguments, int code, const char *line)
{
    char out[1000];
    assert_int_equal(compare(arguments, 0, out, sizeof out), code);
    assert_string_equal(out, line);
}

static void compare_prints_one_line(void **state)
{
    picture p = make_picture(10, 10), q = make_picture(10, 10), mask = make_picture(10, 10);
    (void)state;
    memset(p.rgb, 100, 300);
    memset(q.rgb, 100, 300);
    memset(mask.rgb, 0, 300);
    write_picture("a.ppm", &p);
    expect_line("a.ppm a.ppm", 0, "max=0 mean=0.0000 psnr=inf differing=0 pixels=100\n");
    expect_line("--max 0 a.ppm a.ppm", 0, "max=0 mean=0.0000 psnr=inf differing=0 pixels=100\n");
    q.rgb[0] = 103;
    q.rgb[1] = 99;
    q.rgb[299] = 98; /* squares 9 + 1 + 4 over 300: 20 log10(255) - 10 log10(14 / 300) = 61.44 */
    write_picture("b.ppm", &q);
    expect_line("a.ppm b.ppm", 0, "max=3 mean=0.0200 psnr=61.44 differing=2 pixels=100\n");
    expect_line("b.ppm a.ppm --max 3", 0, "max=3 mean=0.0200 psnr=61.44 differing=2 pixels=100\n");
    expect_line("b.ppm --max 2.5 a.ppm", 1, "max=3 mean=0.0200 psnr=61.44 differing=2 pixels=100\n");
    mask.rgb[2] = 1;
    write_picture("mask.ppm", &mask);
    expect_line("a.ppm b.ppm --apart mask.ppm --max 2", 0,
                "max=2 mean=0.0067 psnr=66.84 differing=1 pixels=99 apart=1 apart_share=1.0000%\n");
    memset(mask.rgb, 255, 300);
    write_picture("mask.ppm", &mask);
    expect_line("a.ppm b.ppm --apart mask.ppm --max 0", 0,
                "max=0 mean=0.0000 psnr=inf differing=0 pixels=0 apart=100 apart_share=100.0000%\n");
    picture_free(&p);
    picture_free(&q);
    picture_free(&mask);
}

static void compare_writes_the_difference(void **state)
{
    picture p = make_picture(2, 1), q = make_picture(2, 1), d;
    char error[300] = "", out[1000];
    (void)state;
    memcpy(p.rgb, "\x10\x10\x10\x10\x10\x10", 6);
    memcpy(q.rgb, "\x10\x11\x0e\x20\x00\x10", 6);
    write_picture("a.ppm", &p);
    write_picture("b.ppm", &q);
    assert_int_equal(compare("a.ppm b.ppm --picture d.ppm", 0, out, sizeof out), 0);
    assert_int_equal(picture_read(file_name("d.ppm"), &d, error, sizeof error), 0);
    assert_memory_equal(d.rgb, "\x00\x20\x40\xff\xff\x00", 6);
    picture_free(&d);
    assert_int_equal(compare("a.ppm b.ppm --picture d.ppm --amplify 3 --max 0", 0, out, sizeof out), 1);
    assert_int_equal(picture_read(file_name("d.ppm"), &d, error, sizeof error), 0);
    assert_memory_equal(d.rgb, "\x00\x03\x06\x30\x30\x00", 6);
    picture_free(&d);
    picture_free(&p);
    picture_free(&q);
}

static void compare_refuses_what_it_cannot_use(void **state)
{
    static const struct {
        const char *arguments, *says;
    } cases[] = {
        {"", "two pictures were expected"},
        {"a.ppm", "two pictures were expected"},
        {"a.ppm a.ppm a.ppm", "one too many"},
        {"a.ppm a.ppm --maximum 3", "--maximum"},
        {"a.ppm a.ppm --max", "a value was expected after --max"},
        {"a.ppm a.ppm --max three", "not three"},
        {"a.ppm a.ppm --max 3x", "not 3x"},
        {"a.ppm a.ppm --max -1", "0 to 255"},
        {"a.ppm a.ppm --max nan", "0 to 255"},
        {"a.ppm a.ppm --max 1 --max 2", "twice"},
        {"a.ppm a.ppm --apart a.ppm --apart a.ppm", "twice"},
        {"a.ppm a.ppm --amplify 3", "--picture FILE was expected"},
        {"a.ppm a.ppm --amplify 0 --picture d.ppm", "1 to 255"},
        {"a.ppm other.ppm", "one size"},
        {"a.ppm a.ppm --apart other.ppm", "one size"},
        {"a.ppm none.ppm", "none.ppm"},
        {"none.ppm a.ppm", "none.ppm"},
        {"a.ppm a.ppm --apart none.ppm", "none.ppm"},
        {"a.ppm a.ppm --picture none/d.ppm", "can be written"},
    };
    picture p = make_picture(3, 2), other = make_picture(2, 3);
    char out[3000];
    (void)state;
    write_picture("a.ppm", &p);
    write_picture("other.ppm", &other);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int code = compare(cases[i].arguments, 1, out, sizeof out);
        if (code != 2 || !strstr(out, cases[i].says)) {
            fail_msg("glint-compare %s: exit %d, \"%s\" does not say \"%s\"", cases[i].arguments, code, out,
                     cases[i].says);
        }
        compare(cases[i].arguments, 0, out, sizeof out);
        assert_string_equal(out, ""); /* no figures beside the message */
    }
    picture_free(&p);
    picture_free(&other);
}

/* Makes the directory and the absolute name of the program, since the tests run it from the directory. */
static int prepare(void **state)
{
    static char program[1000], here[500];
    const char *base = getenv("GLINT_TEST_DIR"), *given = getenv("GLINT_COMPARE");
    (void)state;
    snprintf(directory, sizeof directory, "%s/picture-test-XXXXXX", base ? base : "build");
    if (!mkdtemp(directory) || !getcwd(here, sizeof here)) {
        print_error("a directory where %s can be made was expected\n", directory);
        return -1;
    }
    given = given ? given : "build/glint-compare";
    snprintf(program, sizeof program, "%s%s%s", given[0] == '/' ? "" : here, given[0] == '/' ? "" : "/", given);
    if (access(program, X_OK) != 0) {
        print_error("the program %s was expected; GLINT_COMPARE names another\n", program);
        return -1;
    }
    return setenv("GLINT_COMPARE", program, 1);
}

static int clean_up(void **state)
{
    static const char *const names[] = {"back.ppm", "back.png", "back.PNG", "grey.pgm", "damaged.ppm", "whole.png",
                                        "cut.png",  "a.ppm",    "b.ppm",    "d.ppm",    "mask.ppm",    "other.ppm"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        remove(file_name(names[i]));
    }
    return rmdir(directory); /* fails when a test left a file that is not named here, such as a .part */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_come_back_as_written),
        cmocka_unit_test(netpbm_headers_are_read),
        cmocka_unit_test(damaged_files_are_refused),
        cmocka_unit_test(damaged_png_is_refused),
        cmocka_unit_test(absurd_sizes_are_refused),
        cmocka_unit_test(unwritable_outputs_are_errors),
        cmocka_unit_test(compare_prints_one_line),
        cmocka_unit_test(compare_writes_the_difference),
        cmocka_unit_test(compare_refuses_what_it_cannot_use),
    };
    return cmocka_run_group_tests(tests, prepare, clean_up);
}
