/* SPDX-License-Identifier: MIT */
#include "tests/linux_panel/expected.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include <glint/glint.h>

#include "examples/render/panel.h"
#include "examples/scenes/scenes.h"

#define MOST_PX (240 * 320)

static uint8_t upright[MOST_PX * 3], on_glass[MOST_PX * 3];

static void draw(const expected_picture *e, uint16_t width_px, uint16_t height_px)
{
    static uint32_t memory[1 << 18];
    static glint_object objects[64];
    const demo_scene *demo = demo_scene_named(e->scene);
    const glint_quality quality = {.tolerance = e->tolerance};
    panel p = {.rgb = upright, .width_px = width_px, .height_px = height_px, .format = GLINT_RGB565};
    const glint_display display = panel_display(&p, 0, GLINT_DITHER_NONE, 1);
    glint_scene scene;
    memset(upright, 0x55, sizeof upright);
    if (demo_scene_turn(demo->scene, e->turn16, objects, &scene) != GLINT_OK ||
        glint_fixed_render(&scene, &display, &quality, memory, sizeof memory, NULL) != GLINT_OK) {
        memset(upright, 0xAA, sizeof upright); /* like no picture */
    }
}

/* The pixel of the glass where a pixel of the picture comes to lie when it is turned clockwise. */
static size_t place(const expected_picture *e, unsigned x, unsigned y)
{
    switch (e->quarter_turns) {
    case 1: /* its left edge is the glass's top */
        return (size_t)x * e->width_px + (e->width_px - 1 - y);
    case 2:
        return (size_t)(e->height_px - 1 - y) * e->width_px + (e->width_px - 1 - x);
    case 3: /* its left edge is the glass's bottom */
        return (size_t)(e->height_px - 1 - x) * e->width_px + y;
    default:
        return (size_t)y * e->width_px + x;
    }
}

const uint8_t *expected_on_glass(const expected_picture *e)
{
    const bool on_its_side = e->quarter_turns % 2 != 0;
    const unsigned width = on_its_side ? e->height_px : e->width_px;
    const unsigned height = on_its_side ? e->width_px : e->height_px;
    draw(e, (uint16_t)width, (uint16_t)height);
    for (unsigned y = 0; y < height; y++) {
        for (unsigned x = 0; x < width; x++) {
            memcpy(on_glass + place(e, x, y) * 3, upright + ((size_t)y * width + x) * 3, 3);
        }
    }
    return on_glass;
}
