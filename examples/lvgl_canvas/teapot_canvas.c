/* SPDX-License-Identifier: MIT */
/*
 * A sketch: a teapot turns in an LVGL canvas. Glint draws bands of the canvas, each is copied where it belongs, and
 * LVGL takes the picture to the display together with all else that is on the screen.
 */
#include "examples/lvgl_canvas/teapot_canvas.h"

#include <string.h>

#include <examples/scenes/scenes.h>
#include <glint/glint.h>

#define SIZE_PX 120
#define BAND_PX 24

/* With the teapot's vertices, triangles, object and light. */
static uint32_t memory[GLINT_MEMORY_WORDS(SIZE_PX, SIZE_PX, BAND_PX, GLINT_RGB565, 1, 1922, 3648, 1, 1)];
static uint16_t pixels[SIZE_PX * SIZE_PX];

static int copy_band(void *canvas, const glint_band *band)
{
    memcpy(pixels + (size_t)band->y_px * SIZE_PX, band->pixels, band->bytes);
    if (band->last) {
        lv_obj_invalidate(canvas);
    }
    return 0;
}

static void draw(lv_timer_t *timer)
{
    static uint16_t angle_turn16;
    glint_object teapot;
    glint_scene scene;
    const glint_display display = {.width_px = SIZE_PX,
                                   .height_px = SIZE_PX,
                                   .band_px = BAND_PX,
                                   .format = TEAPOT_CANVAS_FORMAT,
                                   .flush = copy_band,
                                   .context = TEAPOT_CANVAS_OF_TIMER(timer)};
    const glint_quality quality = {.tolerance = GLINT_CODES(1)};
    (void)demo_scene_turn(&demo_teapot, angle_turn16, &teapot, &scene); /* neither can fail with this scene */
    (void)glint_fixed_render(&scene, &display, &quality, memory, sizeof memory, NULL);
    angle_turn16 = (uint16_t)(angle_turn16 + 512);
}

lv_obj_t *teapot_canvas_create(lv_obj_t *parent)
{
    lv_obj_t *const canvas = lv_canvas_create(parent);
    lv_canvas_set_buffer(canvas, pixels, SIZE_PX, SIZE_PX, TEAPOT_CANVAS_LVGL_FORMAT);
    (void)lv_timer_create(draw, 40, canvas);
    return canvas;
}
