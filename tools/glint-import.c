/* SPDX-License-Identifier: MIT */
/*
 * glint-import: turns a model file into C source that firmware compiles, and prints what the quantisation costs.
 *
 * Exit status: 0; 1 when the file cannot be read or the output not written; 2 for wrong options. Outputs are written to
 * a file beside them and renamed when complete, so that a failure leaves what was there.
 */
#include <ctype.h>
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/import/import.h"

static const char usage[] =
    "usage: glint-import FILE -o OUT.c [--name PREFIX] [--header OUT.h]\n"
    "\n"
    "Reads a model (.obj with .mtl, .gltf, .glb, .dae) and writes C source that defines\n"
    "const glint_scene PREFIX_scene. PREFIX is a C identifier; without --name it is FILE's name.\n"
    "--header writes a header that declares the scene. Prints the quantisation error and the size.\n";

typedef struct options {
    const char *input, *output, *header;
    char prefix[64];
} options;

static int wrong(const char *what, const char *which)
{
    fprintf(stderr, "glint-import: %s%s%s\n%s", what, *which ? ": " : "", which, usage);
    return 2;
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

static bool identifier(const char *text)
{
    if (!isalpha((unsigned char)*text)) {
        return false;
    }
    for (; *text; text++) {
        if (!isalnum((unsigned char)*text) && *text != '_') {
            return false;
        }
    }
    return true;
}

/* The file's name up to its ending, with '_' for what an identifier cannot have. */
static void default_prefix(const char *path, char *prefix, size_t room)
{
    const char *name = base_name(path);
    const char *ending = strrchr(name, '.');
    size_t bytes = ending && ending != name ? (size_t)(ending - name) : strlen(name);
    size_t used = 0;
    if (!isalpha((unsigned char)*name)) {
        used = (size_t)snprintf(prefix, room, "model_");
    }
    for (size_t i = 0; i < bytes && used + 1 < room; i++) {
        prefix[used++] = (char)(isalnum((unsigned char)name[i]) ? name[i] : '_');
    }
    prefix[used] = '\0';
}

/* Returns 0, or the exit status. */
static int parse(int count, char **arguments, options *given)
{
    const char *prefix = NULL;
    for (int i = 1; i < count; i++) {
        const char *argument = arguments[i];
        const char **value = strcmp(argument, "-o") == 0         ? &given->output
                             : strcmp(argument, "--name") == 0   ? &prefix
                             : strcmp(argument, "--header") == 0 ? &given->header
                                                                 : NULL;
        if (value) {
            if (i + 1 == count) {
                return wrong("a value is expected after", argument);
            }
            if (*value) {
                return wrong("given twice", argument);
            }
            *value = arguments[++i];
        } else if (argument[0] == '-' && argument[1]) {
            return wrong("unknown option", argument);
        } else if (given->input) {
            return wrong("one FILE expected, a second one given", argument);
        } else {
            given->input = argument;
        }
    }
    if (!given->input) {
        return wrong("FILE expected", "");
    }
    if (!given->output) {
        return wrong("-o OUT.c expected", "");
    }
    if (given->header && strcmp(given->header, given->output) == 0) {
        return wrong("-o and --header name the same file", given->header);
    }
    if (strcmp(given->input, given->output) == 0 || (given->header && strcmp(given->input, given->header) == 0)) {
        return wrong("an output would overwrite FILE", given->input);
    }
    if (!prefix) {
        default_prefix(given->input, given->prefix, sizeof given->prefix);
        return 0;
    }
    if (!identifier(prefix) || strlen(prefix) >= sizeof given->prefix) {
        return wrong("--name expects a C identifier of at most 63 letters, digits and '_', a letter first", prefix);
    }
    snprintf(given->prefix, sizeof given->prefix, "%s", prefix);
    return 0;
}

/* The command for the first line: the same for every machine, so without the folders that the program stands in. */
static char *command_text(int count, char **arguments)
{
    size_t bytes = sizeof "glint-import";
    for (int i = 1; i < count; i++) {
        bytes += strlen(arguments[i]) + 1;
    }
    char *text = malloc(bytes);
    if (!text) {
        return NULL;
    }
    size_t used = (size_t)snprintf(text, bytes, "glint-import");
    for (int i = 1; i < count; i++) {
        used += (size_t)snprintf(text + used, bytes - used, " %s", arguments[i]);
    }
    return text;
}

static char *temporary_name(const char *path)
{
    size_t bytes = strlen(path) + sizeof ".part";
    char *name = malloc(bytes);
    if (name) {
        snprintf(name, bytes, "%s.part", path);
    }
    return name;
}

/* Writes the source, or the header when `scene` is NULL, to a temporary file; returns its name, or NULL with a message.
 */
static char *write_temporary(const options *given, const char *path, const glint_scene *scene, const char *command)
{
    char *temporary = temporary_name(path);
    errno = 0;
    FILE *file = temporary ? fopen(temporary, "w") : NULL;
    if (!file) {
        fprintf(stderr, "glint-import: %s: cannot write: %s\n", path, strerror(errno ? errno : ENOMEM));
        free(temporary);
        return NULL;
    }
    int result =
        scene ? import_write_c(file, scene, given->prefix, command, given->header ? base_name(given->header) : NULL)
              : import_write_header(file, given->prefix, command);
    int problem = result ? errno : 0;
    if (fclose(file) != 0 && !result) {
        result = -1;
        problem = errno;
    }
    if (result) {
        fprintf(stderr, "glint-import: %s: cannot write: %s\n", path, strerror(problem ? problem : ENOMEM));
        remove(temporary);
        free(temporary);
        return NULL;
    }
    return temporary;
}

static int put_in_place(const char *temporary, const char *path)
{
    if (rename(temporary, path) != 0) {
        fprintf(stderr, "glint-import: %s: cannot write: %s\n", path, strerror(errno));
        remove(temporary);
        return 1;
    }
    return 0;
}

static int write_outputs(const options *given, const glint_scene *scene, const char *command)
{
    char *source = write_temporary(given, given->output, scene, command);
    if (!source) {
        return 1;
    }
    int result = 0;
    if (given->header) {
        char *header = write_temporary(given, given->header, NULL, command);
        result = header ? put_in_place(header, given->header) : 1;
        free(header);
    }
    if (!result) {
        result = put_in_place(source, given->output);
    } else {
        remove(source);
    }
    free(source);
    return result;
}

static void print_report(const options *given, const import_report *report)
{
    printf("%s: %u objects, %u meshes, %u materials, %u lights, %llu vertices, %llu triangles, %llu bytes of flash\n",
           given->output, report->objects, report->meshes, report->materials, report->lights,
           (unsigned long long)report->vertices, (unsigned long long)report->triangles,
           (unsigned long long)report->flash_bytes);
    printf("position error: max %.3g units (%.3g of the mesh's size), rms %.3g units (%.3g of the mesh's size)\n",
           report->position_max_units, report->position_max_relative, report->position_rms_units,
           report->position_rms_relative);
    printf("normal error: max %.3g degrees, rms %.3g degrees\n", report->normal_max_degrees,
           report->normal_rms_degrees);
}

int main(int count, char **arguments)
{
    if (count == 2 && strcmp(arguments[1], "--help") == 0) {
        fputs(usage, stdout);
        return 0;
    }
    options given = {0};
    int status = parse(count, arguments, &given);
    if (status) {
        return status;
    }
    imported_scene *scene;
    char error[1024];
    if (import_scene(given.input, &scene, error, sizeof error)) {
        fprintf(stderr, "glint-import: %s\n", error);
        return 1;
    }
    for (size_t i = 0; i < imported_scene_warning_count(scene); i++) {
        fprintf(stderr, "glint-import: warning: %s\n", imported_scene_warning(scene, i));
    }
    char *command = command_text(count, arguments);
    if (command) {
        status = write_outputs(&given, imported_scene_view(scene), command);
    } else {
        fprintf(stderr, "glint-import: not enough memory\n");
        status = 1;
    }
    if (!status) {
        print_report(&given, imported_scene_report(scene));
    }
    free(command);
    imported_scene_free(scene);
    return status;
}
