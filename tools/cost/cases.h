/* SPDX-License-Identifier: MIT */
/*
 * The frames whose cost is counted (cases.c), and how one of them is drawn (frames.c). Both are compiled for the
 * emulated targets, where cost.c counts, and for the host, where judge.c measures how exact the same frames are.
 */
#ifndef TOOLS_COST_CASES_H
#define TOOLS_COST_CASES_H

#include <stddef.h>
#include <stdint.h>

#include <glint/display.h>
#include <glint/quality.h>
#include <glint/scene.h>

/* Room for the words that name a case. */
#define COST_NAME_BYTES 64

enum { COST_FIXED, COST_FLOAT, COST_BACKENDS };
extern const char *const cost_backend_names[COST_BACKENDS];

typedef struct cost_case {
    const char *scene; /* as in cost.csv */
    const glint_scene *data;
    const glint_light *lights; /* instead of the scene's own; NULL: those */
    uint16_t light_count;
    uint16_t width_px, height_px, band_px; /* band 0: the whole frame */
    const char *shading;                   /* as in cost.csv; one word */
    const char *tolerance;                 /* in codes, as in cost.csv; "-": the shading is forced */
    glint_quality quality;
} cost_case;

extern const cost_case cost_cases[];
extern const uint16_t cost_case_count;

/* The case's scene: `data`, with `lights` in place of its own if there are any. */
glint_scene cost_scene(const cost_case *c);

/* Working memory for frame `c` in `format`: every vertex transformed once, every triangle sorted. */
size_t cost_frame_full_bytes(const cost_case *c, int backend, uint8_t format);

/* What it can make use of: besides, in bands, what is set up of triangles kept; with a tolerance, each object's tables.
 */
size_t cost_frame_bytes(const cost_case *c, int backend, uint8_t format);

/* What it cannot be drawn without. */
size_t cost_frame_least_bytes(const cost_case *c, int backend, uint8_t format);

/* Draws the frame; returns what the library returned. */
int cost_draw(const cost_case *c, int backend, uint8_t format, glint_flush flush, void *context, void *memory,
              size_t memory_bytes, glint_report *report);

/* program.c */
extern uint32_t cost_memory[];
extern const size_t cost_memory_bytes;
extern const uint8_t cost_backends;

/* Takes a band of RGB565: FNV-1a 64 over the pixels by value, low byte first, into the uint64_t at `context`, which
 * begins as HASH_START (tests/target/selftest.h). Equal on big-endian processors too. */
int cost_hash_band(void *context, const glint_band *band);

#endif
