/* SPDX-License-Identifier: MIT */
/*
 * Pictures in files, for the host tools and tests: 8-bit RGB in memory, PPM and (with libpng) PNG on disk.
 *
 * Formats: the Netpbm P6 and P5 formats with maxval 255, ppm(5) and pgm(5), one picture a file; PNG through libpng
 * (https://www.libpng.org) where the program is compiled with GLINT_HAVE_PNG and linked with -lpng. The file's ending
 * decides: `.png` in any case of letters is PNG, all else is PPM. Grey pictures are read as R = G = B.
 *
 * All functions return 0, or -1 with a sentence for the user in `error` (which may be NULL when error_bytes is 0).
 */
#ifndef GLINT_TOOLS_PICTURE_H
#define GLINT_TOOLS_PICTURE_H

#include <stddef.h>
#include <stdint.h>

/* Greatest width and height that are read or made, in pixels: a larger figure in a file's header is taken for damage.
 */
#define PICTURE_MAX_SIZE_PX 16384

typedef struct picture {
    int width, height; /* 1..PICTURE_MAX_SIZE_PX */
    uint8_t *rgb;      /* width x height x 3 bytes, rows from the top, without gap; from malloc */
} picture;

/* Makes a black picture. After an error, and before its first use, a picture is safe to free when it is zeroed. */
int picture_create(picture *out, int width, int height, char *error, size_t error_bytes);

/* Frees the pixels and zeroes the picture. */
void picture_free(picture *p);

/* Reads a file. On error *out is zeroed. */
int picture_read(const char *path, picture *out, char *error, size_t error_bytes);

/* Reads a PNG picture from memory. On error *out is zeroed. */
int picture_read_png(const void *data, size_t bytes, picture *out, char *error, size_t error_bytes);

/* Writes a file: into `path` with `.part` appended, which is renamed to `path` when it is complete. A path that is
 * there and is no ordinary file (a device, a pipe) is written directly. On error nothing remains of the new file. */
int picture_write(const char *path, const picture *p, char *error, size_t error_bytes);

/* 1 where PNG can be read and written, 0 where picture_read() and picture_write() refuse it. */
int picture_has_png(void);

#endif
