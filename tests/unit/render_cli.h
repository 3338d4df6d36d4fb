/* SPDX-License-Identifier: MIT */
/*
 * What the tests of glint-render's command line share: running it, its reports and pictures. They run the program
 * itself, which the environment variable GLINT_RENDER names (default: build/glint-render), in a folder of their own
 * under build/.
 */
#ifndef GLINT_TESTS_UNIT_RENDER_CLI_H
#define GLINT_TESTS_UNIT_RENDER_CLI_H

#include <fcntl.h>
#include <setjmp.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

#include <cjson/cJSON.h>

#include "tools/picture/picture.h"

extern char **environ;

enum { MAX_ARGUMENTS = 24, OUTPUT_BYTES = 1 << 16, PATH_BYTES = 256 };

static char folder[] = "build/glint-render-XXXXXX";

/* A path in the test's folder, in one of a few buffers, so that several can be used in one call. */
static inline const char *in_folder(const char *name)
{
    static char paths[8][PATH_BYTES];
    static unsigned next;
    char *path = paths[next++ % 8];
    assert_true(snprintf(path, PATH_BYTES, "%s/%s", folder, name) < PATH_BYTES);
    return path;
}

/* ------------------------------------------------------------------------------------------------------ running it */

typedef struct outcome {
    int status; /* of the exit; -1 when the program did not end by itself */
    char *standard_output, *standard_error;
} outcome;

static inline char *read_text(const char *path)
{
    FILE *file = fopen(path, "rb");
    char *text = calloc(1, OUTPUT_BYTES);
    assert_non_null(text);
    if (file != NULL) {
        (void)!fread(text, 1, OUTPUT_BYTES - 1, file);
        (void)fclose(file);
    }
    return text;
}

/* arguments: without the program's name, ended by NULL. */
static inline outcome run(const char *const *arguments)
{
    const char *program = getenv("GLINT_RENDER");
    char *argv[MAX_ARGUMENTS + 2] = {NULL};
    const char *output_path = in_folder("stdout"), *error_path = in_folder("stderr");
    posix_spawn_file_actions_t actions;
    pid_t child = 0;
    int status = 0;

    argv[0] = (char *)(uintptr_t)(program != NULL ? program : "build/glint-render");
    for (int i = 0; arguments[i] != NULL; i++) {
        assert_true(i < MAX_ARGUMENTS);
        argv[i + 1] = (char *)(uintptr_t)arguments[i]; /* posix_spawn() takes no const, and changes nothing */
    }
    assert_int_equal(posix_spawn_file_actions_init(&actions), 0);
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    assert_int_equal(posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output_path, flags, 0600), 0);
    assert_int_equal(posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, error_path, flags, 0600), 0);
    assert_int_equal(posix_spawn(&child, argv[0], &actions, NULL, argv, environ), 0);
    assert_int_equal(posix_spawn_file_actions_destroy(&actions), 0);
    assert_int_equal(waitpid(child, &status, 0), child);
    return (outcome){.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
                     .standard_output = read_text(output_path),
                     .standard_error = read_text(error_path)};
}

static inline void free_outcome(outcome *o)
{
    free(o->standard_output);
    free(o->standard_error);
}

#define RUN(...) run((const char *const[]){__VA_ARGS__, NULL})

/* The program ends with `status` and says on standard error something that holds `text`. */
static inline void assert_refused(outcome o, int status, const char *text)
{
    if (o.status != status || strstr(o.standard_error, text) == NULL) {
        print_error("expected status %d and a message with \"%s\"; got status %d and: %s\n", status, text, o.status,
                    o.standard_error);
    }
    assert_int_equal(o.status, status);
    assert_non_null(strstr(o.standard_error, text));
    assert_string_equal(o.standard_output, "");
    free_outcome(&o);
}

static inline void assert_good(outcome o)
{
    if (o.status != 0) {
        print_error("status %d: %s\n", o.status, o.standard_error);
    }
    assert_int_equal(o.status, 0);
    assert_string_equal(o.standard_error, "");
    free_outcome(&o);
}

static inline bool exists(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0;
}

/* Neither the file nor what it is written into before it is complete. */
static inline void assert_nothing_at(const char *name)
{
    char part[PATH_BYTES];
    assert_true(snprintf(part, sizeof part, "%s.part", name) < PATH_BYTES);
    assert_false(exists(in_folder(name)));
    assert_false(exists(in_folder(part)));
}

/* Two pictures of one size: are all pixels equal? */
static inline bool are_equal_pictures(const char *path_a, const char *path_b)
{
    char error[256] = "";
    picture a = {0}, b = {0};
    assert_int_equal(picture_read(path_a, &a, error, sizeof error), 0);
    assert_int_equal(picture_read(path_b, &b, error, sizeof error), 0);
    assert_int_equal(a.width, b.width);
    assert_int_equal(a.height, b.height);
    const bool equal = memcmp(a.rgb, b.rgb, (size_t)a.width * (size_t)a.height * 3) == 0;
    picture_free(&a);
    picture_free(&b);
    return equal;
}

static inline void assert_equal_pictures(const char *path_a, const char *path_b)
{
    assert_true(are_equal_pictures(path_a, path_b));
}

static inline void assert_different_pictures(const char *path_a, const char *path_b)
{
    assert_false(are_equal_pictures(path_a, path_b));
}

/* The number at `key` of a report. */
static inline double number(const cJSON *report, const char *key)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(report, key);
    if (!cJSON_IsNumber(item)) {
        fail_msg("no number \"%s\" in the report", key);
    }
    return item->valuedouble;
}

static inline cJSON *read_report(const char *name)
{
    char *text = read_text(in_folder(name));
    cJSON *report = cJSON_Parse(text);
    assert_non_null(report);
    free(text);
    return report;
}

static inline void assert_word(const cJSON *report, const char *key, const char *expected)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(report, key);
    assert_true(cJSON_IsString(item));
    assert_string_equal(item->valuestring, expected);
}

/* ---------------------------------------------------------------------------------------------------------- the folder
 */

static inline int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) == NULL;
}

/* names: of the files that the tests write, ended by NULL. Fails if a test left a file that it should not have. */
static inline int remove_folder_with(const char *const *names)
{
    (void)remove(in_folder("stdout"));
    (void)remove(in_folder("stderr"));
    for (; *names != NULL; names++) {
        (void)remove(in_folder(*names));
    }
    return rmdir(folder);
}

#endif
