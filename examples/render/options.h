/* SPDX-License-Identifier: MIT */
/*
 * The command line of glint-render, parsed and checked for contradictions before anything is drawn.
 */
#ifndef EXAMPLES_RENDER_OPTIONS_H
#define EXAMPLES_RENDER_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { BACKEND_FIXED, BACKEND_FLOAT, BACKEND_REFERENCE };

typedef struct options {
    bool help, list, explain;
    const char *scene;            /* a built-in scene's name, or a file */
    const char *output;           /* .ppm or .png; NULL: none, with `explain` only */
    const char *report, *edges;   /* files to write beside the picture; NULL: none */
    const char *promise, *tiers;  /* the same */
    int backend;                  /* BACKEND_FIXED ... */
    uint8_t shading;              /* GLINT_SHADING_EXACT ... */
    uint8_t tolerance;            /* 1/16 code; 0: every triangle by `shading` */
    uint8_t format, dither;       /* GLINT_RGB888 ..., GLINT_DITHER_NONE ... */
    uint16_t width_px, height_px; /* 0: the size that the scene is designed for */
    uint16_t band_px;             /* 0: the whole frame */
    uint8_t buffer_count;         /* 1 or 2 */
    uint16_t turn16;              /* turn of all objects, in 1/65536 turn */
    uint32_t without;             /* effects to leave out, see without.h */
    size_t memory_bytes;          /* 0: as much as the library can make use of */
} options;

/*
 * Parses the arguments. Returns 0; or -1 with a sentence that says what was expected in `error` (always terminated).
 */
int options_parse(int count, char **arguments, options *out, char *error, size_t error_bytes);

/* The same kind of check for what is known only with the scene: the frame's height. */
int options_check_height(const options *o, uint16_t height_px, char *error, size_t error_bytes);

/* Whether a file is to be PNG by its name. */
bool options_is_png(const char *path);

/* How to call the program, several lines. */
extern const char options_usage[];

/* The words of the command line for the values above. */
const char *options_backend_word(int backend);
const char *options_shading_word(uint8_t shading);
const char *options_tier_word(uint8_t tier);
const char *options_format_word(uint8_t format);
const char *options_dither_word(uint8_t dither);

#endif
