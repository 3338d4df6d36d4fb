/* SPDX-License-Identifier: MIT */
/*
 * generate-mesh: prints the C source of a built-in mesh on standard output and its figures on standard error. Run it
 * without arguments for its usage; regenerate.sh has the commands that made examples/meshes/.
 */
#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mesh_writer.h"

/* A number of a command: what it is called in the usage and the least that makes sense. */
typedef struct number {
    const char *name;
    int least;
} number;

typedef struct command {
    const char *name;
    int count;
    number numbers[4];
} command;

static const command commands[] = {
    {"sphere", 2, {{"SECTORS", 3}, {"STACKS", 2}}},
    {"bowl", 2, {{"SECTORS", 3}, {"STACKS", 1}}},
    {"globe", 2, {{"SECTORS", 3}, {"STACKS", 2}}},
    {"teapot", 1, {{"DIVISIONS", 4}}},
    {"torus-knot", 4, {{"P", 1}, {"Q", 1}, {"SEGMENTS", 3}, {"SIDES", 3}}},
    {"box", 0, {{NULL, 0}}},
    {"plane", 1, {{"CELLS", 1}}},
    {"floor", 2, {{"CELLS", 1}, {"REPEATS", 1}}},
};
enum { COMMAND_COUNT = sizeof commands / sizeof commands[0] };

static int usage(void)
{
    fprintf(stderr,
            "usage: generate-mesh SHAPE [NUMBER...] NAME > NAME.c, where NAME is a C identifier and SHAPE one of\n");
    for (int c = 0; c < COMMAND_COUNT; c++) {
        fprintf(stderr, "    %s", commands[c].name);
        for (int n = 0; n < commands[c].count; n++) {
            fprintf(stderr, " %s", commands[c].numbers[n].name);
        }
        fprintf(stderr, "\n");
    }
    return 2;
}

/* Returns 0 and the value, or 2 with a message. */
static int read_number(const char *text, const number *expected, int *value)
{
    char *end;
    errno = 0;
    long n = strtol(text, &end, 10);
    if (!isdigit((unsigned char)text[0]) || *end != '\0' || errno != 0 || n < expected->least ||
        n > SHAPE_MAX_DIVISIONS) {
        fprintf(stderr, "generate-mesh: %s is '%s', expected a whole number from %d to %d\n", expected->name, text,
                expected->least, SHAPE_MAX_DIVISIONS);
        return 2;
    }
    *value = (int)n;
    return 0;
}

static int is_identifier(const char *text)
{
    if (!isalpha((unsigned char)text[0]) && text[0] != '_') {
        return 0;
    }
    for (; *text != '\0'; text++) {
        if (!isalnum((unsigned char)*text) && *text != '_') {
            return 0;
        }
    }
    return 1;
}

static int common_divisor(int a, int b)
{
    return b == 0 ? a : common_divisor(b, a % b);
}

static int make(const command *c, const int numbers[4], shape *mesh)
{
    if (strcmp(c->name, "sphere") == 0) {
        shape_sphere(mesh, numbers[0], numbers[1]);
    } else if (strcmp(c->name, "bowl") == 0) {
        shape_bowl(mesh, numbers[0], numbers[1]);
    } else if (strcmp(c->name, "globe") == 0) {
        shape_globe(mesh, numbers[0], numbers[1]);
    } else if (strcmp(c->name, "floor") == 0) {
        if (numbers[1] > 63) {
            fprintf(stderr, "generate-mesh: REPEATS is %d, expected 1 to 63, for texture coordinates of 9 bits\n",
                    numbers[1]);
            return 2;
        }
        shape_floor(mesh, numbers[0], numbers[1]);
    } else if (strcmp(c->name, "teapot") == 0) {
        shape_teapot(mesh, numbers[0]);
    } else if (strcmp(c->name, "torus-knot") == 0) {
        if (common_divisor(numbers[0], numbers[1]) != 1) {
            fprintf(stderr, "generate-mesh: P and Q are %d and %d, expected numbers without a common divisor\n",
                    numbers[0], numbers[1]);
            return 2;
        }
        shape_torus_knot(mesh, numbers[0], numbers[1], numbers[2], numbers[3]);
    } else if (strcmp(c->name, "box") == 0) {
        shape_box(mesh);
    } else {
        shape_plane(mesh, numbers[0]);
    }
    return 0;
}

int main(int argc, char **argv)
{
    const command *c = NULL;
    for (int n = 0; n < COMMAND_COUNT && argc > 1; n++) {
        if (strcmp(argv[1], commands[n].name) == 0) {
            c = &commands[n];
        }
    }
    if (c == NULL || argc != c->count + 3) {
        return usage();
    }
    const char *name = argv[argc - 1];
    char line[256] = "generate-mesh";
    int numbers[4] = {0};
    if (!is_identifier(name) || strlen(name) > 63) {
        fprintf(stderr, "generate-mesh: NAME is '%s', expected a C identifier of at most 63 characters\n", name);
        return 2;
    }
    for (int n = 0; n < c->count; n++) {
        if (read_number(argv[2 + n], &c->numbers[n], &numbers[n]) != 0) {
            return 2;
        }
    }
    for (int n = 1; n < argc; n++) { /* at most a shape, four numbers of 4 digits and a name of 63: fits */
        strcat(strcat(line, " "), argv[n]);
    }

    shape mesh = {0};
    int status = make(c, numbers, &mesh);
    if (status == 0) {
        status = mesh_write(stdout, &mesh, name, line);
    }
    shape_free(&mesh);
    return status;
}
