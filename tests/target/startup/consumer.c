/* SPDX-License-Identifier: MIT */
/*
 * A user's program, valid as C99 and as C++11: built against the installed library, it draws an empty scene with each
 * backend and looks at the pixels that arrive. Shows that the installed headers are complete, that they are usable from
 * C++, that both backends link together, and that a choice of parts of the user's own (consumer_parts.c) draws what it
 * has and refuses the rest.
 */
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <glint/glint.h>

enum { WIDTH = 16, HEIGHT = 8, MEMORY_WORDS = 4096 };

static int count_white(void *context, const glint_band *band)
{
    const uint8_t *pixels = (const uint8_t *)band->pixels;
    for (uint32_t i = 0; i < band->bytes; i++) {
        *(uint32_t *)context += pixels[i] == 255;
    }
    return 0;
}

typedef int (*render_function)(const glint_scene *, const glint_display *, const glint_quality *, void *, size_t,
                               glint_report *);

static int is_white(const char *backend, render_function render, uint8_t shading, int expected)
{
    static uint32_t memory[MEMORY_WORDS];
    const glint_colour white = GLINT_WHITE;
    static glint_camera camera; /* static: all fields zero, in either language */
    static glint_scene scene;
    static glint_display display;
    const glint_quality quality = {shading, 0};
    uint32_t white_bytes = 0;
    int error;

    camera.eye_q16[2] = 4 * 65536;
    camera.field_of_view_turn16 = 8192;
    camera.near_q16 = 65536;
    scene.camera = &camera;
    scene.background = white;
    display.width_px = WIDTH;
    display.height_px = HEIGHT;
    display.format = GLINT_GREY8;
    display.flush = count_white;
    display.context = &white_bytes;
    error = render(&scene, &display, &quality, memory, sizeof memory, NULL);
    if (error != expected || white_bytes != (error == GLINT_OK ? (uint32_t)WIDTH * HEIGHT : 0)) {
        fprintf(stderr, "%s: %s, %lu white bytes\n", backend, glint_error_text(error), (unsigned long)white_bytes);
        return 0;
    }
    return 1;
}

int main(void)
{
    return is_white("fixed", glint_fixed_render, GLINT_SHADING_EXACT, GLINT_OK) &&
                   is_white("float", glint_float_render, GLINT_SHADING_EXACT, GLINT_OK) &&
                   is_white("parts", glint_fixed_parts_render, GLINT_SHADING_EXACT, GLINT_OK) &&
                   is_white("parts", glint_fixed_parts_render, GLINT_SHADING_FLAT, GLINT_ERROR_PART)
               ? 0
               : 1;
}
