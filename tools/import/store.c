/* SPDX-License-Identifier: MIT */
/*
 * Lifetime of an imported scene: its blocks of memory and its warnings. All that a scene points to is in blocks that
 * are freed with it, so that an import which fails half-way leaks nothing.
 */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/import/internal.h"

imported_scene *store_new(void)
{
    return calloc(1, sizeof(imported_scene));
}

bool store_grow(void **array, size_t count, size_t *room, size_t bytes)
{
    if (count < *room) {
        return true;
    }
    size_t wanted = *room ? *room * 2 : 16;
    if (wanted > SIZE_MAX / 2 / bytes) {
        return false;
    }
    void *larger = realloc(*array, wanted * bytes);
    if (!larger) {
        return false;
    }
    *array = larger;
    *room = wanted;
    return true;
}

void *store_take(imported_scene *scene, size_t count, size_t bytes)
{
    void *blocks = scene->blocks;
    if (!store_grow(&blocks, scene->block_count, &scene->block_room, sizeof *scene->blocks)) {
        return NULL;
    }
    scene->blocks = blocks;
    void *block = calloc(count ? count : 1, bytes);
    if (block) {
        scene->blocks[scene->block_count++] = block;
    }
    return block;
}

void store_warn(imported_scene *scene, const char *format, ...)
{
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (length < 0) {
        return;
    }
    void *warnings = scene->warnings;
    if (!store_grow(&warnings, scene->warning_count, &scene->warning_room, sizeof *scene->warnings)) {
        return;
    }
    scene->warnings = warnings;
    char *copy = store_take(scene, strlen(text) + 1, 1);
    if (copy) {
        memcpy(copy, text, strlen(text) + 1);
        scene->warnings[scene->warning_count++] = copy;
    }
}

const glint_scene *imported_scene_view(const imported_scene *scene)
{
    return &scene->scene;
}

const import_report *imported_scene_report(const imported_scene *scene)
{
    return &scene->report;
}

size_t imported_scene_warning_count(const imported_scene *scene)
{
    return scene->warning_count;
}

const char *imported_scene_warning(const imported_scene *scene, size_t index)
{
    return scene->warnings[index];
}

void imported_scene_free(imported_scene *scene)
{
    if (!scene) {
        return;
    }
    for (size_t i = 0; i < scene->block_count; i++) {
        free(scene->blocks[i]);
    }
    free(scene->blocks);
    free(scene->warnings);
    free(scene);
}
