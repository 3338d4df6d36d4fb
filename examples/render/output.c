/* SPDX-License-Identifier: MIT */
/*
 * Files beside the picture: see output.h. JSON (RFC 8259) is written field by field, without a library, so that the
 * renderer needs nothing but a C compiler; the mask and the promises are Netpbm's P5, pgm(5).
 */
#include "output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static int fail(const char *path, char *error, size_t error_bytes)
{
    (void)snprintf(error, error_bytes, "cannot write %s: %s", path, strerror(errno));
    return -1;
}

/* Not there, or an ordinary file. */
static bool takes_part(const char *path)
{
    struct stat status;
    return stat(path, &status) != 0 || S_ISREG(status.st_mode);
}

static int open_with(output *out, const char *path, const char *ending, char *error, size_t error_bytes)
{
    *out = (output){.path = path};
    if (takes_part(path)) {
        const size_t bytes = strlen(path) + strlen(ending) + 1;
        out->part = malloc(bytes);
        if (out->part == NULL) {
            return fail(path, error, error_bytes);
        }
        (void)snprintf(out->part, bytes, "%s%s", path, ending);
    }
    out->file = fopen(out->part != NULL ? out->part : path, "wb");
    if (out->file == NULL) {
        fail(path, error, error_bytes);
        free(out->part);
        *out = (output){0};
        return -1;
    }
    return 0;
}

int output_open(output *out, const char *path, char *error, size_t error_bytes)
{
    return open_with(out, path, ".part", error, error_bytes);
}

int output_close(output *out, char *error, size_t error_bytes)
{
    const int bad = ferror(out->file);
    const int closed = fclose(out->file);
    out->file = NULL;
    return bad != 0 || closed != 0 ? fail(out->path, error, error_bytes) : 0;
}

/* The part's name has to end as the picture's does, for picture_write() to write the same format. */
int output_picture(output *out, const char *path, const picture *image, char *error, size_t error_bytes)
{
    if (!takes_part(path)) {
        return picture_write(path, image, error, error_bytes);
    }
    /* opened here first, for an error that names the file as the user does */
    if (open_with(out, path, options_is_png(path) ? ".part.png" : ".part", error, error_bytes) != 0 ||
        output_close(out, error, error_bytes) != 0) {
        return -1;
    }
    return picture_write(out->part, image, error, error_bytes);
}

int output_place(output *out, char *error, size_t error_bytes)
{
    if (out->part != NULL && rename(out->part, out->path) != 0) {
        return fail(out->path, error, error_bytes);
    }
    free(out->part);
    out->part = NULL;
    return 0;
}

void output_drop(output *out)
{
    if (out->file != NULL) {
        (void)fclose(out->file);
    }
    if (out->part != NULL) {
        (void)remove(out->part);
        free(out->part);
    }
    *out = (output){0};
}

/* text: NULL for null. */
static void write_string(FILE *file, const char *key, const char *text)
{
    if (text == NULL) {
        fprintf(file, "  \"%s\": null,\n", key);
        return;
    }
    fprintf(file, "  \"%s\": \"", key);
    for (; *text != '\0'; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\') {
            fprintf(file, "\\%c", c);
        } else if (c < 0x20) {
            fprintf(file, "\\u%04x", c);
        } else {
            fputc(c, file);
        }
    }
    fputs("\",\n", file);
}

/* "key": codes in 1/`units`, or null. */
static void write_codes(FILE *file, const char *key, bool given, unsigned value, unsigned units)
{
    fprintf(file, given ? "  \"%s\": %.11g,\n" : "  \"%s\": null,\n", key, (double)value / units);
}

/* "key": {"unlit": 0, ...} */
static void write_tiers(FILE *file, const char *key, const uint32_t *counts)
{
    fprintf(file, "  \"%s\": {", key);
    for (int tier = 0; tier < GLINT_TIERS; tier++) {
        fprintf(file, "%s\"%s\": %lu", tier == 0 ? "" : ", ", options_tier_word((uint8_t)tier),
                (unsigned long)counts[tier]);
    }
    fputs("},\n", file);
}

void output_report(FILE *file, const options *o, uint16_t width_px, uint16_t height_px, size_t memory_bytes,
                   const glint_report *report)
{
    const struct {
        const char *key;
        unsigned long value;
    } numbers[] = {
        {"width_px", width_px},
        {"height_px", height_px},
        {"band_px", o->band_px},
        {"buffers", o->buffer_count},
        {"turn16", o->turn16},
        {"memory_bytes", (unsigned long)memory_bytes},
        {"triangles", report->triangles},
        {"triangles_drawn", report->triangles_drawn},
        {"triangles_facing_away", report->triangles_facing_away},
        {"triangles_outside", report->triangles_outside},
        {"triangles_empty", report->triangles_empty},
        {"triangles_refused", report->triangles_refused},
        {"triangles_clipped", report->triangles_clipped},
        {"vertices_transformed", report->vertices_transformed},
        {"pixels_shaded", report->pixels_shaded},
        {"pixels_specular", report->pixels_specular},
        {"bands", report->bands},
        {"memory_used_bytes", report->memory_used_bytes},
        {"lights_folded", report->lights_folded},
        {"lights_culled", report->lights_culled},
        {"specular_triangles", report->specular_triangles},
        {"shadow_triangles", report->shadow_triangles},
        {"shadow_tests", report->shadow_tests},
        {"pixels_shadowed", report->pixels_shadowed},
    };
    const size_t count = sizeof numbers / sizeof numbers[0];

    fputs("{\n", file);
    write_string(file, "scene", o->scene);
    write_string(file, "backend", options_backend_word(o->backend));
    write_string(file, "shading", o->tolerance == 0 ? options_shading_word(o->shading) : NULL);
    write_codes(file, "tolerance_codes", o->tolerance != 0, o->tolerance, 16);
    write_codes(file, "promise_codes", report->promise_q8 != UINT16_MAX, report->promise_q8, 256);
    write_string(file, "format", options_format_word(o->format));
    write_string(file, "dither", options_dither_word(o->dither));
    write_tiers(file, "tier_triangles", report->tier_triangles);
    write_tiers(file, "tier_pixels", report->tier_pixels);
    for (size_t i = 0; i < count; i++) {
        fprintf(file, "  \"%s\": %lu%s\n", numbers[i].key, numbers[i].value, i + 1 < count ? "," : "");
    }
    fputs("}\n", file);
}

static void write_pgm_header(FILE *file, int width_px, int height_px)
{
    fprintf(file, "P5\n%d %d\n255\n", width_px, height_px);
}

static const uint8_t tier_rgb[][3] = {
    [GLINT_TIER_UNLIT] = {72, 72, 72},    [GLINT_TIER_FLAT] = {176, 176, 176}, [GLINT_TIER_GOURAUD] = {64, 112, 232},
    [GLINT_TIER_CURVED] = {72, 208, 208}, [GLINT_TIER_Q1] = {56, 176, 80},     [GLINT_TIER_Q2] = {248, 216, 56},
    [GLINT_TIER_EXACT] = {216, 48, 48},   [OBSERVED_BACKGROUND] = {0, 0, 0},
};

void output_tiers(const observation *seen, picture *image)
{
    for (size_t i = 0; i < (size_t)seen->width_px * seen->height_px; i++) {
        memcpy(image->rgb + 3 * i, tier_rgb[seen->tier[i]], 3);
    }
}

/* Rounded up: a level is never less than what is promised. */
static uint8_t promise_level(uint16_t promise_q8)
{
    const unsigned level = (promise_q8 + 15u) / 16;
    return (uint8_t)(level < 255 ? level : 255);
}

void output_promise(const observation *seen, picture *image)
{
    for (size_t i = 0; i < (size_t)seen->width_px * seen->height_px; i++) {
        memset(image->rgb + 3 * i, promise_level(seen->promise_q8[i]), 3);
    }
}

void output_promise_pgm(FILE *file, const observation *seen)
{
    write_pgm_header(file, seen->width_px, seen->height_px);
    for (size_t i = 0; i < (size_t)seen->width_px * seen->height_px; i++) {
        fputc(promise_level(seen->promise_q8[i]), file);
    }
}

void output_mask(FILE *file, const uint8_t *mask, int width_px, int height_px)
{
    write_pgm_header(file, width_px, height_px);
    for (size_t i = 0; i < (size_t)width_px * (size_t)height_px; i++) {
        fputc(mask[i] != 0 ? 255 : 0, file);
    }
}
