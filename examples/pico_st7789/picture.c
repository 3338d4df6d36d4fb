/* SPDX-License-Identifier: MIT */
/*
 * A (2,3) torus knot in polished gold turns once in 128 frames: under a warm lamp from the upper left, and a blue one
 * low behind it on the right.
 */
#include "examples/firmware/picture.h"

#include <examples/scenes/parts.h>

#include "examples/pico_st7789/picture_size.h"

#define FRAMES 128

static const glint_camera camera = {
    .eye_q16 = POINT(0, 2400, 5400),
    .target_q16 = POINT(0, 0, 0),
    .field_of_view_turn16 = DEGREES_TURN16(36),
    .near_q16 = MILLI_Q16(4100), /* 5.91 away, 1.72 about the target */
};

static const glint_material gold = {
    .ambient = COLOUR(830, 620, 250),
    .diffuse = COLOUR(780, 560, 180),
    .specular = COLOUR(630, 560, 370),
    .exponent_q4 = 40 * 16,
};

static const glint_light lamps[PICTURE_LIGHTS] = {
    {.kind = GLINT_DIRECTIONAL, .direction = {6, -8, -7}, .colour = COLOUR(1000, 960, 880)},
    {.kind = GLINT_DIRECTIONAL, .direction = {-9, 3, 1}, .colour = COLOUR(250, 400, 900)},
};

const uint16_t picture_frames = FRAMES;
const glint_display picture_display = {.width_px = PICTURE_WIDTH_PX,
                                       .height_px = PICTURE_HEIGHT_PX,
                                       .band_px = PICTURE_BAND_PX,
                                       .format = PICTURE_FORMAT,
                                       .buffer_count = PICTURE_BUFFERS};

int picture_draw(uint16_t frame, const glint_display *display, void *memory, size_t memory_bytes, glint_report *report)
{
    const glint_quality quality = {.tolerance = GLINT_CODES(1)};
    const glint_object knot = {&glint_mesh_torus_knot_small, &gold, glint_turn_y((uint16_t)(frame * (65536 / FRAMES)))};
    const glint_scene scene = {
        .camera = &camera,
        .objects = &knot,
        .object_count = PICTURE_OBJECTS,
        .lights = lamps,
        .light_count = PICTURE_LIGHTS,
        .ambient = COLOUR(160, 150, 170),
        .background = COLOUR(35, 40, 70),
    };
    return glint_fixed_parts_render(&scene, display, &quality, memory, memory_bytes, report);
}
