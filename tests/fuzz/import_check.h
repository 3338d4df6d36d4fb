/* SPDX-License-Identifier: MIT */
/*
 * Imports a model file made of bytes and checks what tools/import/import.h promises:
 *
 *   - a failure gives one sentence without newline, and no scene;
 *   - a success gives a scene that both backends draw without error, finite numbers in the report, warnings that can be
 *     printed, and C source that can be written.
 *
 * The bytes are the file itself, so that any model can be put into the corpus. Its beginning tells its kind: "glTF"
 * GLB, { glTF, < COLLADA, anything else OBJ. What follows a line "#mtl" is the material library, fuzz.mtl.
 */
#ifndef GLINT_TESTS_FUZZ_IMPORT_CHECK_H
#define GLINT_TESTS_FUZZ_IMPORT_CHECK_H

#include <ctype.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "tests/fuzz/bytes.h"

#include "tests/unit/backends.h"
#include "tools/import/import.h"

static inline const char *ending_for(const uint8_t *data, size_t size)
{
    size_t first = 0;
    if (size >= 4 && memcmp(data, "glTF", 4) == 0) {
        return ".glb";
    }
    while (first < size && isspace(data[first])) {
        first++;
    }
    return first < size && data[first] == '{' ? ".gltf" : first < size && data[first] == '<' ? ".dae" : ".obj";
}

static inline void write_bytes(const char *path, const uint8_t *data, size_t size)
{
    FILE *file = fopen(path, "wb");
    FUZZ_CHECK(file != NULL, "cannot write %s", path);
    FUZZ_CHECK(size == 0 || fwrite(data, 1, size, file) == size, "cannot write %s", path);
    FUZZ_CHECK(fclose(file) == 0, "cannot write %s", path);
}

static inline int ignore_band(void *context, const glint_band *band)
{
    (void)context;
    (void)band;
    return 0;
}

static inline void draw_imported(const glint_scene *scene)
{
    static const glint_quality quality = {.shading = GLINT_SHADING_EXACT};
    const glint_display display = {.width_px = 16, .height_px = 12, .flush = ignore_band};
    for (int i = 0; i < BACKENDS; i++) {
        const size_t bytes_given = backends[i].memory_bytes(scene, &display);
        FUZZ_CHECK(bytes_given > 0, "%s: no memory size", backends[i].name);
        void *memory = malloc(bytes_given);
        FUZZ_CHECK(memory != NULL, "out of memory");
        const int result = backends[i].render(scene, &display, &quality, memory, bytes_given, NULL);
        FUZZ_CHECK(result == 0, "%s: imported, but not valid: %s", backends[i].name, glint_error_text(result));
        free(memory);
    }
}

static inline void check_sentence(const char *sentence)
{
    FUZZ_CHECK(*sentence != '\0' && strchr(sentence, '\n') == NULL, "no sentence: \"%s\"", sentence);
}

static inline void check_imported(const imported_scene *imported)
{
    const import_report *r = imported_scene_report(imported);
    const double numbers[] = {r->position_max_units,
                              r->position_rms_units,
                              r->position_max_relative,
                              r->position_rms_relative,
                              r->normal_max_degrees,
                              r->normal_rms_degrees,
                              r->world_scale,
                              r->centre[0],
                              r->centre[1],
                              r->centre[2],
                              r->radius};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        FUZZ_CHECK(isfinite(numbers[i]), "number %zu of the report is not finite", i);
    }
    for (size_t i = 0; i < imported_scene_warning_count(imported); i++) {
        check_sentence(imported_scene_warning(imported, i));
    }
    draw_imported(imported_scene_view(imported));
    FILE *nowhere = fopen("/dev/null", "w");
    FUZZ_CHECK(nowhere != NULL, "cannot open /dev/null");
    FUZZ_CHECK(import_write_c(nowhere, imported_scene_view(imported), "fuzz", "fuzz", NULL) == 0, "cannot write C");
    FUZZ_CHECK(fclose(nowhere) == 0, "cannot write C");
}

/* The body of the fuzzer. `folder` is where the model's files may be put. */
static inline void check_import_bytes(const char *folder, const uint8_t *data, size_t size)
{
    static const char mark[] = "\n#mtl\n";
    char model[256], library[256], error[512];
    size_t model_bytes = size;
    for (size_t i = 0; i + sizeof mark - 1 <= size; i++) {
        if (memcmp(data + i, mark, sizeof mark - 1) == 0) {
            model_bytes = i + 1;
            break;
        }
    }
    (void)snprintf(model, sizeof model, "%s/fuzz%s", folder, ending_for(data, size));
    (void)snprintf(library, sizeof library, "%s/fuzz.mtl", folder);
    write_bytes(model, data, model_bytes);
    const size_t skipped = model_bytes + sizeof mark - 2;
    if (model_bytes < size) {
        write_bytes(library, data + skipped, size - skipped);
    }
    imported_scene *imported = NULL;
    memset(error, 'x', sizeof error);
    const int result = import_scene(model, &imported, error, sizeof error);
    if (result == 0) {
        FUZZ_CHECK(imported != NULL, "no scene");
        check_imported(imported);
        imported_scene_free(imported);
    } else {
        FUZZ_CHECK(result == -1 && imported == NULL, "result %d", result);
        FUZZ_CHECK(memchr(error, '\0', sizeof error) != NULL, "error text without end");
        check_sentence(error);
    }
    (void)unlink(model);
    (void)unlink(library);
}

/* A folder for this process, in memory where the system has one for that. */
static inline void make_folder(char *path, size_t path_bytes)
{
    (void)snprintf(path, path_bytes, "%s/glint-fuzz-XXXXXX", access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp");
    FUZZ_CHECK(mkdtemp(path) != NULL, "cannot make %s", path);
}

#endif
