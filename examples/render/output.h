/* SPDX-License-Identifier: MIT */
/*
 * The files that glint-render writes beside the picture. Each is written under its name with `.part` appended and put
 * in place only when all outputs are complete, so that an error leaves nothing behind. A path that is there and is no
 * ordinary file (a device, a pipe) is written directly.
 *
 * All functions return 0, or -1 with a sentence in `error`.
 */
#ifndef EXAMPLES_RENDER_OUTPUT_H
#define EXAMPLES_RENDER_OUTPUT_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <glint/quality.h>

#include "observe.h"
#include "options.h"
#include "tools/picture/picture.h"

typedef struct output {
    const char *path;
    char *part; /* the file being written; NULL when `path` itself is, or when there is nothing to put in place */
    FILE *file; /* while it is open */
} output;

int output_open(output *out, const char *path, char *error, size_t error_bytes);

/* Closes the file; an error of any write before shows here. */
int output_close(output *out, char *error, size_t error_bytes);

/* Opens, writes and closes a picture; PNG when the path ends in .png. */
int output_picture(output *out, const char *path, const picture *image, char *error, size_t error_bytes);

/* Puts a closed file in its place. */
int output_place(output *out, char *error, size_t error_bytes);

/* Removes what has not been put in place. Does nothing on a zeroed or placed output. */
void output_drop(output *out);

/* The counts of a frame and how it was drawn, as one JSON object. */
void output_report(FILE *file, const options *o, uint16_t width_px, uint16_t height_px, size_t memory_bytes,
                   const glint_report *report);

/* The tier of each pixel in colour; --help has the legend. `image` has the observation's size. */
void output_tiers(const observation *seen, picture *image);

/* The promise of each pixel in grey, 1/16 code a level: as a picture, whose size is the observation's; or as PGM. */
void output_promise(const observation *seen, picture *image);
void output_promise_pgm(FILE *file, const observation *seen);

/* A mask as PGM: 255 where a byte is not 0. */
void output_mask(FILE *file, const uint8_t *mask, int width_px, int height_px);

#endif
