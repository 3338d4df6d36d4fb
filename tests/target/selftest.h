/* SPDX-License-Identifier: MIT */
/*
 * The parts of the self-test, and how its report is written: lines of words, which check.c reads.
 *
 *     target INT_BITS POINTER_BITS little|big
 *     kernel ROUTINE HASH                     fixed-point number routine, FNV-1a 64 over its results
 *     frame NAME HASH                         fixed backend, FNV-1a 64 over the pixels
 *     pixels NAME fixed|float ROW COLUMN HEX  part of a row of RGB888; simavr breaks lines of 256 characters
 *     real ROUTINE HEX ...                    float number routine: arguments and result as bits
 *     calibration KNOWN COUNTED               see platform_known_loop()
 *     count NAME AVERAGE WORST UNIT           in tenths
 *     stack fixed|float BYTES
 *     float-frames none                       they have been left out
 *     textured-frames none                    likewise
 *     failed TEXT
 *     end
 *
 * Hashes take each number in a fixed byte order, low byte first, and 16-bit pixels by value, so that the lines of all
 * targets must be equal. FNV-1a: G. Fowler, L. C. Noll, K.-P. Vo.
 */
#ifndef TESTS_TARGET_SELFTEST_H
#define TESTS_TARGET_SELFTEST_H

/* 0 leaves the float backend's frames out, for where both backends do not fit. */
#ifndef SELFTEST_FLOAT_FRAMES
#define SELFTEST_FLOAT_FRAMES 1
#endif

/* 0 leaves shadows out, for a backend without that part. */
#ifndef SELFTEST_SHADOWS
#define SELFTEST_SHADOWS 1
#endif

#include <stdbool.h>
#include <stdint.h>

#include <glint/scene.h>

/* selftest_report.c: a line is begun, added to, ended. */
void report_begin(const char *kind);
void report_word(const char *text);
void report_decimal(uint32_t value);
void report_hex(uint64_t value, int digits);
void report_bytes(const uint8_t *bytes, uint16_t count);
void report_end(void);

#define HASH_START UINT64_C(0xcbf29ce484222325)
uint64_t hash_bytes(uint64_t hash, uint64_t value, int bytes);

/* What each part prints is told above. */
void selftest_numbers(void);
void selftest_frames(void);
void selftest_counts(void);

/* selftest_frames.c: draws the frame that selftest_counts() counts, 48 x 32 RGB565 in bands of 8, and drops it. */
void selftest_draw_counted(bool in_float);

/* selftest_scenes.c */
extern const glint_scene selftest_room, selftest_mirror, selftest_shadows;

/* The pictures whose pixels are printed, for check.c to compare with the reference. */
typedef struct selftest_picture {
    const char *name;
    const glint_scene *scene;
    uint16_t width_px, height_px, band_px;
    uint8_t shading;
} selftest_picture;

/* Those of textures, last, are left out where SELFTEST_TEXTURES is 0. */
#ifndef SELFTEST_TEXTURES
#define SELFTEST_TEXTURES 1
#endif
enum { SELFTEST_PICTURES = SELFTEST_TEXTURES ? 7 : 5 };
extern const selftest_picture selftest_pictures[SELFTEST_PICTURES];

#endif
