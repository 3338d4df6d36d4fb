/* SPDX-License-Identifier: MIT */
/*
 * The greatest error of built-in scenes within a tolerance of 1, in both backends, against the double-precision
 * reference: effect-errors SCENE... prints for each a line
 *
 *     SCENE FIXED FLOAT APART
 *
 * codes of 1/255 by which the worst plain pixel is off, its rounding included, and the share of pixels in percent that
 * are compared apart since they are at the edge of a triangle, of a texel or of a shadow (tests/reference/reference.h).
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <glint/glint.h>

#include "examples/scenes/scenes.h"
#include "tests/reference/reference.h"

enum { MEMORY_BYTES = 8 << 20 };

static int keep(void *context, const glint_band *band)
{
    memcpy((uint8_t *)context + (size_t)band->y_px * band->stride_bytes, band->pixels, band->bytes);
    return 0;
}

typedef int (*render_function)(const glint_scene *, const glint_display *, const glint_quality *, void *, size_t,
                               glint_report *);

static int check(const demo_scene *demo, const reference_image *image, render_function render, uint8_t *rgb,
                 void *memory, reference_verdict *verdict)
{
    const glint_display display = {
        .width_px = demo->width_px, .height_px = demo->height_px, .flush = keep, .context = rgb};
    const glint_quality quality = {.tolerance = GLINT_CODES(1)};
    const int error = render(demo->scene, &display, &quality, memory, MEMORY_BYTES, NULL);
    if (error != GLINT_OK) {
        fprintf(stderr, "effect-errors: %s: %s\n", demo->name, glint_error_text(error));
        return 1;
    }
    reference_check(image, rgb, 1, verdict);
    return 0;
}

static int tell(const demo_scene *demo)
{
    static uint8_t rgb[320 * 240 * 3];
    reference_image image;
    reference_verdict in_fixed, in_float;
    char error[200];
    void *memory = malloc(MEMORY_BYTES);
    if (memory == NULL || (size_t)demo->width_px * demo->height_px * 3 > sizeof rgb) {
        fprintf(stderr, "effect-errors: no memory for %s\n", demo->name);
        free(memory);
        return 1;
    }
    if (reference_render(demo->scene, demo->width_px, demo->height_px, GLINT_SHADING_EXACT, &image, error,
                         sizeof error) != 0) {
        fprintf(stderr, "effect-errors: %s: %s\n", demo->name, error);
        free(memory);
        return 1;
    }
    int result = check(demo, &image, glint_fixed_render, rgb, memory, &in_fixed);
    result = result ? result : check(demo, &image, glint_float_render, rgb, memory, &in_float);
    if (result == 0) {
        printf("%s %.2f %.2f %.1f\n", demo->name, in_fixed.max_codes, in_float.max_codes,
               100 * (in_fixed.contested_share + in_fixed.shadow_share));
    }
    reference_free(&image);
    free(memory);
    return result;
}

int main(int argc, char **argv)
{
    int failed = argc < 2;
    for (int i = 1; i < argc; i++) {
        const demo_scene *demo = NULL;
        for (uint16_t k = 0; k < demo_scene_count; k++) {
            demo = strcmp(demo_scenes[k].name, argv[i]) == 0 ? &demo_scenes[k] : demo;
        }
        if (demo == NULL) {
            fprintf(stderr, "effect-errors: no scene %s\n", argv[i]);
        }
        failed |= demo == NULL || tell(demo) != 0;
    }
    return failed;
}
