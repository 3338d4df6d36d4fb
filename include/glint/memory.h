/* SPDX-License-Identifier: MIT */
/*
 * How much working memory a frame takes, at compile time. glint_fixed_memory_bytes() and glint_float_memory_bytes()
 * give the exact number at run time, never more than this. What would take 4 GiB or more is not drawn by any memory.
 */
#ifndef GLINT_MEMORY_WORDS

#include <stdint.h>

/* Upper bounds of what either backend keeps of the frame and the triangle being drawn, of an object, and of a light for
 * each object. */
#define GLINT_DRAWING_BYTES 1856
#define GLINT_OBJECT_BYTES 464
#define GLINT_LIGHT_BYTES 96

/* And of a spot light or an attenuated one for each object, beside that: so many words more than GLINT_MEMORY_WORDS for
 * each object times each of these lights, of an extended source for each of its samples. */
#define GLINT_REACH_BYTES 72
#define GLINT_REACH_WORDS (GLINT_REACH_BYTES / 4)

/* And of an object that mirrors the environment: so many words more for each of these. */
#define GLINT_MIRROR_BYTES 64
#define GLINT_MIRROR_WORDS (GLINT_MIRROR_BYTES / 4)

/* And this many words more once, if any material has a texture. */
#define GLINT_TEXTURE_WORDS 120

/* With lights that cast shadows: of the frame, of each such light, of each object, and of 8 triangles of a mesh. */
#define GLINT_SHADOW_STATE_BYTES 880
#define GLINT_SHADOW_LIGHT_BYTES 24
#define GLINT_SHADOW_OBJECT_BYTES 96
#define GLINT_SHADOW_BOX_BYTES 12

/*
 * uint32_t words more that a scene takes in which `casting` of its lights cast shadows, at least one; the other
 * arguments are those of GLINT_MEMORY_WORDS. The greatest part is one bit for each pixel of a band and casting light.
 */
#define GLINT_SHADOW_WORDS(width_px, band_px, vertices, triangles, objects, lights, casting)                           \
    (GLINT_SHADOW_STATE_BYTES / 4 + (uint32_t)(lights) * (GLINT_LIGHT_BYTES / 4) +                                     \
     (uint32_t)(casting) * (GLINT_SHADOW_LIGHT_BYTES / 4 + ((uint32_t)(width_px) + 31) / 32 * (uint32_t)(band_px)) +   \
     (uint32_t)(objects) * (GLINT_SHADOW_OBJECT_BYTES / 4) +                                                           \
     ((uint32_t)(triangles) / 4 + (uint32_t)(objects)*16) * (GLINT_SHADOW_BOX_BYTES / 4) +                             \
     ((uint32_t)(vertices)*3 + (uint32_t)(objects)) / 2)

/* With a tolerance, this many words more for each object let its material keep a ramp of pixels (RGB565 without dither)
 * and a table of its highlight: faster, the same image. */
#define GLINT_RAMP_WORDS 769

/*
 * With bands, this many words more for each triangle that reaches from one band into the next let what was set up of it
 * be kept: faster, the same image. So much takes one under one light with its highlight; one without a highlight takes
 * two thirds of it. As many reach over the border of two bands as a horizontal line crosses at most, in a round body
 * about the square root of its triangles. memory_used_bytes of the report counts what use was made of.
 */
#define GLINT_KEPT_WORDS 64

/* Bytes of a row of pixels; of a page of 8 rows for GLINT_MONO_PAGES. `format` is a constant GLINT_RGB888 ... */
#define GLINT_ROW_BYTES(format, width_px)                                                                              \
    ((format) == GLINT_RGB888                                       ? (uint32_t)(width_px)*3                           \
     : (format) == GLINT_RGB565 || (format) == GLINT_RGB565_SWAPPED ? (uint32_t)(width_px)*2                           \
     : (format) == GLINT_GREY4                                      ? ((uint32_t)(width_px) + 1) / 2                   \
                                                                    : (uint32_t)(width_px))

/*
 * uint32_t words that let each vertex be transformed once a frame and each triangle be sorted into bands, for
 *   width_px, height_px, band_px, format, buffers   of the display (rows without gap)
 *   vertices, triangles   sums over all objects; triangles of a see-through object of which both sides are drawn twice
 *   objects, lights       of the scene; an extended source counts as many lights as it has samples (16 for 0)
 * For example: static uint32_t memory[GLINT_MEMORY_WORDS(240, 240, 16, GLINT_RGB565_SWAPPED, 1, 512, 960, 1, 1)];
 */
#define GLINT_MEMORY_WORDS(width_px, height_px, band_px, format, buffers, vertices, triangles, objects, lights)        \
    (GLINT_DRAWING_BYTES / 4 +                                                                                         \
     (uint32_t)(objects) * (GLINT_OBJECT_BYTES / 4 + (uint32_t)(lights) * (GLINT_LIGHT_BYTES / 4)) +                   \
     (uint32_t)(buffers) *                                                                                             \
         ((GLINT_ROW_BYTES(format, width_px) *                                                                         \
               ((format) == GLINT_MONO_PAGES ? ((uint32_t)(band_px) + 7) / 8 : (uint32_t)(band_px)) +                  \
           3) /                                                                                                        \
          4) +                                                                                                         \
     ((uint32_t)(width_px) * (uint32_t)(band_px) + 1) / 2 +                                                            \
     ((uint32_t)(band_px) < (uint32_t)(height_px)                                                                      \
          ? ((uint32_t)(triangles) + ((uint32_t)(height_px) + (uint32_t)(band_px)-1) / (uint32_t)(band_px) + 1) / 2    \
          : 0) +                                                                                                       \
     (uint32_t)(vertices)*3)

#endif
