/* SPDX-License-Identifier: MIT */
/*
 * A teapot turns once in 16 frames, in 16 greys on 128x64 pixels.
 */
#include "examples/firmware/picture.h"

#include <examples/scenes/parts.h>

#define FRAMES 16

static const glint_camera camera = {
    .eye_q16 = POINT(0, 5000, 11000),
    .target_q16 = POINT(0, 1500, 0),
    .field_of_view_turn16 = DEGREES_TURN16(22),
    .near_q16 = MILLI_Q16(7000),
};

static const glint_material glazed = {
    .ambient = COLOUR(800, 800, 800),
    .diffuse = COLOUR(700, 700, 700),
    .specular = COLOUR(450, 450, 450),
    .exponent_q4 = 30 * 16,
};
static const glint_light lamps[] = {
    {.kind = GLINT_DIRECTIONAL, .direction = {6, -7, -7}, .colour = GLINT_WHITE},
    {.kind = GLINT_DIRECTIONAL, .direction = {-9, -3, 2}, .colour = COLOUR(300, 300, 300)},
};

const uint16_t picture_frames = FRAMES;
const glint_display picture_display = {.width_px = 128, .height_px = 64, .format = GLINT_GREY4};

int picture_draw(uint16_t frame, const glint_display *display, void *memory, size_t memory_bytes, glint_report *report)
{
    /* Four codes of 255 are a quarter of the step from one of 16 greys to the next. */
    const glint_quality quality = {.tolerance = GLINT_CODES(4)};
    const glint_object teapot = {&glint_mesh_teapot_small, &glazed, glint_turn_y((uint16_t)(frame * (65536 / FRAMES)))};
    const glint_scene scene = {
        .camera = &camera,
        .objects = &teapot,
        .object_count = 1,
        .lights = lamps,
        .light_count = LENGTH_OF(lamps),
        .ambient = COLOUR(120, 120, 120),
        .background = GLINT_BLACK,
    };
    return glint_fixed_parts_render(&scene, display, &quality, memory, memory_bytes, report);
}
