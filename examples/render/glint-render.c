/* SPDX-License-Identifier: MIT */
/*
 * glint-render: draws a built-in scene or a model file into a picture, with either backend of the library or with the
 * double-precision reference of the tests. Also the example of how a program on a host uses the library: see draw().
 *
 * Exit status: 0; 1 when a scene cannot be read, drawn or written; 2 when the command line is not understood. An error
 * leaves no output behind.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <glint/error.h>
#include <glint/fixed.h>
#include <glint/float.h>

#include "examples/scenes/scenes.h"
#include "explain.h"
#include "observe.h"
#include "options.h"
#include "output.h"
#include "panel.h"
#include "tests/reference/reference.h"
#include "tools/import/import.h"
#include "tools/picture/picture.h"
#include "without.h"

enum { STATUS_GOOD = 0, STATUS_FAILED = 1, STATUS_USAGE = 2 };

enum { MESSAGE_BYTES = 512 };
static const uint16_t default_width_px = 320, default_height_px = 240;

static int complain(int status, const char *message)
{
    fprintf(stderr, "glint-render: %s\n", message);
    return status;
}

static void list_scenes(void)
{
    for (unsigned i = 0; i < demo_scene_count; i++) {
        char size[16];
        (void)snprintf(size, sizeof size, "%ux%u", (unsigned)demo_scenes[i].width_px,
                       (unsigned)demo_scenes[i].height_px);
        printf("%-24s %-9s %s\n", demo_scenes[i].name, size, demo_scenes[i].title);
    }
}

/* ------------------------------------------------------------------------------------------------------------- scenes
 */

/* The scene to draw, with what has to be freed. */
typedef struct loaded_scene {
    glint_scene scene;
    uint16_t width_px, height_px;
    imported_scene *imported; /* NULL for a built-in scene */
    without_copy bare;        /* the copy without some effects */
    glint_object *objects;    /* the turned copy */
} loaded_scene;

static void free_scene(loaded_scene *loaded)
{
    imported_scene_free(loaded->imported);
    without_free(&loaded->bare);
    free(loaded->objects);
    *loaded = (loaded_scene){0};
}

/* A file can be told from a mistyped name by the folder or the ending in it. */
static int looks_like_file(const char *name)
{
    return strpbrk(name, "/.") != NULL;
}

static int load_scene(const options *o, loaded_scene *out, char *error, size_t error_bytes)
{
    const demo_scene *built_in = demo_scene_named(o->scene);
    const glint_scene *scene = NULL;

    *out = (loaded_scene){.width_px = default_width_px, .height_px = default_height_px};
    if (built_in != NULL) {
        scene = built_in->scene;
        out->width_px = built_in->width_px;
        out->height_px = built_in->height_px;
    } else if (!looks_like_file(o->scene)) {
        (void)snprintf(error, error_bytes,
                       "%s: no built-in scene of this name (glint-render --list names them), and no model file",
                       o->scene);
        return STATUS_USAGE;
    } else {
        if (import_scene(o->scene, &out->imported, error, error_bytes) != 0) {
            return STATUS_FAILED;
        }
        for (size_t i = 0; i < imported_scene_warning_count(out->imported); i++) {
            fprintf(stderr, "glint-render: warning: %s\n", imported_scene_warning(out->imported, i));
        }
        scene = imported_scene_view(out->imported);
    }
    if (o->width_px != 0) {
        out->width_px = o->width_px;
        out->height_px = o->height_px;
    }
    out->scene = *scene;
    if (o->without != 0 && without(scene, o->without, &out->bare, &out->scene, error, error_bytes) != 0) {
        return STATUS_USAGE;
    }
    if (o->turn16 == 0) {
        return STATUS_GOOD;
    }
    out->objects = calloc((size_t)scene->object_count + 1, sizeof *out->objects);
    if (out->objects == NULL) {
        (void)snprintf(error, error_bytes, "out of memory");
        return STATUS_FAILED;
    }
    const int result = demo_scene_turn(&out->scene, o->turn16, out->objects, &out->scene);
    if (result != 0) {
        (void)snprintf(error, error_bytes, "%s: %s", o->scene, glint_error_text(result));
        return STATUS_FAILED;
    }
    return STATUS_GOOD;
}

/* ------------------------------------------------------------------------------------------------------------ drawing
 */

typedef int (*render_function)(const glint_scene *, const glint_display *, const glint_quality *, void *, size_t,
                               glint_report *);

/* What there is of each of the library's backends, and the copy of it that tells of each pixel. */
static const struct {
    render_function render, render_observed;
    size_t (*memory_bytes)(const glint_scene *, const glint_display *);
    size_t (*memory_least_bytes)(const glint_scene *, const glint_display *);
} backends[] = {
    [BACKEND_FIXED] = {glint_fixed_render, observed_fixed_render, glint_fixed_memory_bytes,
                       glint_fixed_memory_least_bytes},
    [BACKEND_FLOAT] = {glint_float_render, observed_float_render, glint_float_memory_bytes,
                       glint_float_memory_least_bytes},
};

/* Draws with a backend of the library. *memory_bytes: in: 0, or the memory to give; out: the memory given. `seen` is
 * filled only if the options ask for what it has. */
static int draw(const options *o, const loaded_scene *loaded, uint8_t *rgb, size_t *memory_bytes, glint_report *report,
                observation *seen, char *error, size_t error_bytes)
{
    const bool observed = o->tiers != NULL || o->promise != NULL || o->explain;
    const render_function render = observed ? backends[o->backend].render_observed : backends[o->backend].render;
    const glint_quality quality = {.shading = o->shading, .tolerance = o->tolerance};
    panel screen = {.rgb = rgb, .width_px = loaded->width_px, .height_px = loaded->height_px, .format = o->format};
    const glint_display display = panel_display(&screen, o->band_px, o->dither, o->buffer_count);

    if (*memory_bytes == 0) {
        *memory_bytes = backends[o->backend].memory_bytes(&loaded->scene, &display);
    }
    /* The size functions give 0 for a scene that is not valid; rendering then says what is wrong with it. */
    void *memory = malloc(*memory_bytes == 0 ? sizeof(uint32_t) : *memory_bytes);
    if (memory == NULL || (observed && observe_begin(seen, &loaded->scene, loaded->width_px, loaded->height_px) != 0)) {
        (void)snprintf(error, error_bytes, "out of memory: %zu bytes", *memory_bytes);
        free(memory);
        return STATUS_FAILED;
    }
    const int result = render(&loaded->scene, &display, &quality, memory, *memory_bytes, report);
    observe_end();
    panel_finish(&screen);
    free(memory);

    if (result == GLINT_ERROR_MEMORY_SIZE) {
        (void)snprintf(error, error_bytes, "%s: %s: %zu bytes given, at least %zu needed, up to %zu of use", o->scene,
                       glint_error_text(result), *memory_bytes,
                       backends[o->backend].memory_least_bytes(&loaded->scene, &display),
                       backends[o->backend].memory_bytes(&loaded->scene, &display));
    } else if (result == PANEL_ERROR_BAND) {
        (void)snprintf(error, error_bytes, "%s: the library sent a band that the display cannot take", o->scene);
    } else if (result != GLINT_OK) {
        (void)snprintf(error, error_bytes, "%s: %s", o->scene, glint_error_text(result));
    }
    return result == GLINT_OK ? STATUS_GOOD : STATUS_FAILED;
}

/* Draws with the reference; opens and writes the mask of contested pixels if it is asked for. */
static int draw_reference(const options *o, const loaded_scene *loaded, uint8_t *rgb, output *edges, char *error,
                          size_t error_bytes)
{
    reference_image image = {0};
    int result =
        reference_render(&loaded->scene, loaded->width_px, loaded->height_px, o->shading, &image, error, error_bytes);
    if (result == 0) {
        reference_codes(&image, rgb);
        if (o->edges != NULL) {
            result = output_open(edges, o->edges, error, error_bytes);
            if (result == 0) {
                output_mask(edges->file, image.mask, image.width, image.height);
                result = output_close(edges, error, error_bytes);
            }
        }
    }
    reference_free(&image);
    return result == 0 ? STATUS_GOOD : STATUS_FAILED;
}

/* ------------------------------------------------------------------------------------------------------------ writing
 */

/* What is written beside the picture, each in its own file. */
enum { FILE_REPORT, FILE_EDGES, FILE_TIERS, FILE_PROMISE, FILE_COUNT };

/* The tiers and promises that were asked for. */
static int write_observation(const options *o, const observation *seen, output *files, char *error, size_t error_bytes)
{
    picture shown = {0};
    int result = picture_create(&shown, seen->width_px, seen->height_px, error, error_bytes);
    if (result == 0 && o->tiers != NULL) {
        output_tiers(seen, &shown);
        result = output_picture(&files[FILE_TIERS], o->tiers, &shown, error, error_bytes);
    }
    if (result == 0 && o->promise != NULL && options_is_png(o->promise)) {
        output_promise(seen, &shown);
        result = output_picture(&files[FILE_PROMISE], o->promise, &shown, error, error_bytes);
    } else if (result == 0 && o->promise != NULL) {
        result = output_open(&files[FILE_PROMISE], o->promise, error, error_bytes);
        if (result == 0) {
            output_promise_pgm(files[FILE_PROMISE].file, seen);
            result = output_close(&files[FILE_PROMISE], error, error_bytes);
        }
    }
    picture_free(&shown);
    return result;
}

/* Draws and writes everything: all files are complete before the first is put in its place. */
static int draw_and_write(const options *o, const loaded_scene *loaded, picture *image, observation *seen,
                          output *files, char *error, size_t error_bytes)
{
    glint_report report = {0};
    size_t memory_bytes = o->memory_bytes;
    int status;

    if (o->backend == BACKEND_REFERENCE) {
        status = draw_reference(o, loaded, image->rgb, &files[FILE_EDGES], error, error_bytes);
    } else {
        status = draw(o, loaded, image->rgb, &memory_bytes, &report, seen, error, error_bytes);
    }
    if (status == STATUS_GOOD && seen->tier != NULL && write_observation(o, seen, files, error, error_bytes) != 0) {
        status = STATUS_FAILED;
    }
    if (status != STATUS_GOOD) {
        return status;
    }
    if (o->report != NULL) {
        output *file = &files[FILE_REPORT];
        if (output_open(file, o->report, error, error_bytes) != 0) {
            return STATUS_FAILED;
        }
        output_report(file->file, o, loaded->width_px, loaded->height_px, memory_bytes, &report);
        if (output_close(file, error, error_bytes) != 0) {
            return STATUS_FAILED;
        }
    }
    if (o->output != NULL && picture_write(o->output, image, error, error_bytes) != 0) {
        return STATUS_FAILED;
    }
    for (int i = 0; i < FILE_COUNT; i++) {
        if (output_place(&files[i], error, error_bytes) != 0) {
            return STATUS_FAILED;
        }
    }
    if (o->explain) {
        const glint_quality quality = {.shading = o->shading, .tolerance = o->tolerance};
        if (explain(stdout, &loaded->scene, &quality, &report, seen) != 0) {
            (void)snprintf(error, error_bytes, "out of memory");
            return STATUS_FAILED;
        }
    }
    return STATUS_GOOD;
}

static int run(const options *o, char *error, size_t error_bytes)
{
    loaded_scene loaded = {0};
    picture image = {0};
    observation seen = {0};
    output files[FILE_COUNT] = {{0}};

    int status = load_scene(o, &loaded, error, error_bytes);
    if (status == STATUS_GOOD && options_check_height(o, loaded.height_px, error, error_bytes) != 0) {
        status = STATUS_USAGE;
    }
    if (status == STATUS_GOOD && picture_create(&image, loaded.width_px, loaded.height_px, error, error_bytes) != 0) {
        status = STATUS_FAILED;
    }
    if (status == STATUS_GOOD) {
        status = draw_and_write(o, &loaded, &image, &seen, files, error, error_bytes);
    }
    for (int i = 0; i < FILE_COUNT; i++) {
        output_drop(&files[i]);
    }
    observation_free(&seen);
    picture_free(&image);
    free_scene(&loaded);
    return status;
}

int main(int argc, char **argv)
{
    char message[MESSAGE_BYTES] = "";
    options o;

    if (options_parse(argc, argv, &o, message, sizeof message) != 0) {
        return complain(STATUS_USAGE, message);
    }
    if (o.help) {
        fputs(options_usage, stdout);
        return STATUS_GOOD;
    }
    if (o.list) {
        list_scenes();
        return STATUS_GOOD;
    }
    const int status = run(&o, message, sizeof message);
    return status == STATUS_GOOD ? STATUS_GOOD : complain(status, message);
}
