/* SPDX-License-Identifier: MIT */
/*
 * Files beside the picture: see output.h. JSON (RFC 8259) is written field by field, without a library, so that the
 * renderer needs nothing but a C compiler; the mask is Netpbm's P5, pgm(5).
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

int output_open(output *out, const char *path, char *error, size_t error_bytes)
{
    static const char ending[] = ".part";
    struct stat status;

    *out = (output){.path = path};
    if (stat(path, &status) != 0 || S_ISREG(status.st_mode)) {
        const size_t bytes = strlen(path) + sizeof ending;
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

int output_close(output *out, char *error, size_t error_bytes)
{
    const int bad = ferror(out->file);
    const int closed = fclose(out->file);
    out->file = NULL;
    return bad != 0 || closed != 0 ? fail(out->path, error, error_bytes) : 0;
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

static void write_string(FILE *file, const char *key, const char *text)
{
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
    };
    const size_t count = sizeof numbers / sizeof numbers[0];

    fputs("{\n", file);
    write_string(file, "scene", o->scene);
    write_string(file, "backend", options_backend_word(o->backend));
    write_string(file, "shading", options_shading_word(o->shading));
    write_string(file, "format", options_format_word(o->format));
    write_string(file, "dither", options_dither_word(o->dither));
    for (size_t i = 0; i < count; i++) {
        fprintf(file, "  \"%s\": %lu%s\n", numbers[i].key, numbers[i].value, i + 1 < count ? "," : "");
    }
    fputs("}\n", file);
}

void output_mask(FILE *file, const uint8_t *mask, int width_px, int height_px)
{
    fprintf(file, "P5\n%d %d\n255\n", width_px, height_px);
    for (size_t i = 0; i < (size_t)width_px * (size_t)height_px; i++) {
        fputc(mask[i] != 0 ? 255 : 0, file);
    }
}
