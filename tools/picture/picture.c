/* SPDX-License-Identifier: MIT */
/*
 * Pictures in files; the contract stands in picture.h. The Netpbm reader is strict where a lenient one would show a
 * damaged file as a picture: a short file, bytes after the picture and any maxval but 255 are errors.
 */
#include "picture.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#ifdef GLINT_HAVE_PNG
#include <png.h>
#endif

#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
static int
fail(char *error, size_t error_bytes, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (error_bytes > 0) {
        vsnprintf(error, error_bytes, format, arguments);
    }
    va_end(arguments);
    return -1;
}

int picture_has_png(void)
{
#ifdef GLINT_HAVE_PNG
    return 1;
#else
    return 0;
#endif
}

int picture_create(picture *out, int width, int height, char *error, size_t error_bytes)
{
    memset(out, 0, sizeof *out);
    if (width < 1 || height < 1 || width > PICTURE_MAX_SIZE_PX || height > PICTURE_MAX_SIZE_PX) {
        return fail(error, error_bytes, "a picture of %d x %d px: 1 to %d was expected for width and height", width,
                    height, PICTURE_MAX_SIZE_PX);
    }
    out->rgb = calloc((size_t)width * (size_t)height, 3);
    if (!out->rgb) {
        return fail(error, error_bytes, "no memory for a picture of %d x %d px", width, height);
    }
    out->width = width;
    out->height = height;
    return 0;
}

void picture_free(picture *p)
{
    free(p->rgb);
    memset(p, 0, sizeof *p);
}

static int is_png_name(const char *path)
{
    size_t l = strlen(path);
    const char *ending = ".png";
    if (l < 4) {
        return 0;
    }
    for (int i = 0; i < 4; i++) {
        char c = path[l - 4 + (size_t)i];
        if (c >= 'A' && c <= 'Z') {
            c = (char)(c - 'A' + 'a');
        }
        if (c != ending[i]) {
            return 0;
        }
    }
    return 1;
}

/* Reads a number of a Netpbm header, after white space and comments, and the one character behind it. Returns -1 where
 * there is no number, and stops at a figure that is beyond any use. */
static long read_number(FILE *file)
{
    long value = -1;
    int c = getc(file);
    while (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '#') {
        if (c == '#') {
            while (c != '\n' && c != '\r' && c != EOF) {
                c = getc(file);
            }
        } else {
            c = getc(file);
        }
    }
    while (c >= '0' && c <= '9') {
        value = value < 0 ? 0 : value;
        if (value <= 100000000L) {
            value = value * 10 + (c - '0');
        }
        c = getc(file);
    }
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' ? value : -1;
}

static int read_netpbm(FILE *file, const char *path, picture *out, char *error, size_t error_bytes)
{
    char magic[2] = {0, 0};
    size_t channels, pixels;
    if (fread(magic, 1, 2, file) != 2 || magic[0] != 'P' || (magic[1] != '6' && magic[1] != '5')) {
        return fail(error, error_bytes, "%s: a PPM (P6) or PGM (P5) picture was expected", path);
    }
    channels = magic[1] == '6' ? 3 : 1;
    long width = read_number(file), height = read_number(file), maxval = read_number(file);
    if (width < 0 || height < 0 || maxval < 0) {
        return fail(error, error_bytes, "%s: after P%c a width, a height and the maxval 255 were expected", path,
                    magic[1]);
    }
    if (width < 1 || height < 1 || width > PICTURE_MAX_SIZE_PX || height > PICTURE_MAX_SIZE_PX) {
        return fail(error, error_bytes, "%s: its header says %ld x %ld px; 1 to %d was expected for each", path, width,
                    height, PICTURE_MAX_SIZE_PX);
    }
    if (maxval != 255) {
        return fail(error, error_bytes, "%s: its maxval is %ld; 255 was expected", path, maxval);
    }
    if (picture_create(out, (int)width, (int)height, error, error_bytes)) {
        return -1;
    }
    pixels = (size_t)width * (size_t)height;
    size_t got = fread(out->rgb, 1, pixels * channels, file);
    if (got != pixels * channels) {
        return fail(error, error_bytes, "%s: cut short: %lu bytes of pixels were expected, %lu are there", path,
                    (unsigned long)(pixels * channels), (unsigned long)got);
    }
    if (getc(file) != EOF) {
        return fail(error, error_bytes, "%s: bytes after the picture; one picture a file was expected", path);
    }
    for (size_t i = pixels; channels == 1 && i-- > 0;) { /* from the end: it widens in place */
        uint8_t grey = out->rgb[i];
        out->rgb[3 * i] = out->rgb[3 * i + 1] = out->rgb[3 * i + 2] = grey;
    }
    return 0;
}

static int write_netpbm(FILE *file, const picture *p)
{
    size_t bytes = (size_t)p->width * (size_t)p->height * 3;
    return fprintf(file, "P6\n%d %d\n255\n", p->width, p->height) < 0 || fwrite(p->rgb, 1, bytes, file) != bytes ? -1
                                                                                                                 : 0;
}

#ifdef GLINT_HAVE_PNG
/* The rest, once the header has been read. */
static int finish_png(png_image *image, const char *path, picture *out, char *error, size_t error_bytes)
{
    png_color black = {0, 0, 0};
    image->format = PNG_FORMAT_RGB;
    if (image->width > PICTURE_MAX_SIZE_PX || image->height > PICTURE_MAX_SIZE_PX) {
        png_image_free(image);
        return fail(error, error_bytes, "%s: its header says %lu x %lu px; 1 to %d was expected for each", path,
                    (unsigned long)image->width, (unsigned long)image->height, PICTURE_MAX_SIZE_PX);
    }
    if (picture_create(out, (int)image->width, (int)image->height, error, error_bytes)) {
        png_image_free(image);
        return -1;
    }
    if (!png_image_finish_read(image, &black, out->rgb, 0, NULL)) {
        return fail(error, error_bytes, "%s: a whole PNG picture was expected: %s", path, image->message);
    }
    return 0;
}

static int read_png(FILE *file, const char *path, picture *out, char *error, size_t error_bytes)
{
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_stdio(&image, file)) {
        return fail(error, error_bytes, "%s: a PNG picture was expected: %s", path, image.message);
    }
    return finish_png(&image, path, out, error, error_bytes);
}

static int write_png(FILE *file, const picture *p)
{
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.width = (png_uint_32)p->width;
    image.height = (png_uint_32)p->height;
    image.format = PNG_FORMAT_RGB;
    return png_image_write_to_stdio(&image, file, 0, p->rgb, 0, NULL) ? 0 : -1;
}
#else
static int no_png(const char *path, char *error, size_t error_bytes)
{
    return fail(error, error_bytes,
                "%s: this program was built without PNG: install libpng (package libpng-dev) and build again, or name "
                "a .ppm file",
                path);
}
#endif

int picture_read(const char *path, picture *out, char *error, size_t error_bytes)
{
    int status = -1;
    memset(out, 0, sizeof *out);
#ifndef GLINT_HAVE_PNG
    if (is_png_name(path)) {
        return no_png(path, error, error_bytes);
    }
#endif
    FILE *file = fopen(path, "rb");
    if (!file) {
        return fail(error, error_bytes, "%s: a picture was expected: %s", path, strerror(errno));
    }
    if (is_png_name(path)) {
#ifdef GLINT_HAVE_PNG
        status = read_png(file, path, out, error, error_bytes);
#endif
    } else {
        status = read_netpbm(file, path, out, error, error_bytes);
    }
    fclose(file);
    if (status) {
        picture_free(out);
    }
    return status;
}

static int write_stream(FILE *file, const char *path, const picture *p)
{
#ifdef GLINT_HAVE_PNG
    if (is_png_name(path)) {
        return write_png(file, p);
    }
#else
    (void)path;
#endif
    return write_netpbm(file, p);
}

/* Whether the path is there and a rename would put an ordinary file in the place of a device or pipe. */
static int is_special(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

int picture_write(const char *path, const picture *p, char *error, size_t error_bytes)
{
    int special = is_special(path), status;
    char *part;
#ifndef GLINT_HAVE_PNG
    if (is_png_name(path)) {
        return no_png(path, error, error_bytes);
    }
#endif
    size_t room = strlen(path) + sizeof ".part";
    part = malloc(room);
    if (!part) {
        return fail(error, error_bytes, "%s: no memory", path);
    }
    snprintf(part, room, "%s%s", path, special ? "" : ".part");
    FILE *file = fopen(part, "wb");
    if (!file) {
        status = fail(error, error_bytes, "%s: a file that can be written was expected: %s", path, strerror(errno));
        free(part);
        return status;
    }
    errno = 0;
    status = write_stream(file, path, p);
    if (fclose(file) != 0) {
        status = -1;
    }
    if (status == 0 && !special && rename(part, path) != 0) {
        status = -1;
    }
    if (status) {
        fail(error, error_bytes, "%s: could not be written: %s", path, errno ? strerror(errno) : "the writer failed");
        if (!special) {
            remove(part);
        }
    }
    free(part);
    return status;
}

int picture_read_png(const void *data, size_t bytes, picture *out, char *error, size_t error_bytes)
{
    memset(out, 0, sizeof *out);
#ifdef GLINT_HAVE_PNG
    png_image image;
    int status = -1;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&image, data, bytes)) {
        (void)fail(error, error_bytes, "a PNG picture was expected: %s", image.message);
    } else {
        status = finish_png(&image, "a picture in memory", out, error, error_bytes);
    }
    if (status) {
        picture_free(out);
    }
    return status;
#else
    (void)data;
    (void)bytes;
    return no_png("a picture in memory", error, error_bytes);
#endif
}
