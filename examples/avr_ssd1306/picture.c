/* SPDX-License-Identifier: MIT */
/*
 * A glossy sphere in black and white, dithered; its lamp goes round in 16 frames.
 */
#include "examples/firmware/picture.h"

#include <examples/scenes/parts.h>

#define FRAMES 16

static const glint_camera camera = {
    .eye_q16 = POINT(0, 0, 6000),
    .target_q16 = POINT(0, 0, 0),
    .field_of_view_turn16 = DEGREES_TURN16(21),
    .near_q16 = MILLI_Q16(4500),
};

static const glint_material glossy = {
    .ambient = COLOUR(700, 700, 700),
    .diffuse = COLOUR(600, 600, 600),
    .specular = COLOUR(600, 600, 600),
    .exponent_q4 = 20 * 16,
};
static const glint_object sphere = {.mesh = &glint_mesh_sphere_24x12, .material = &glossy};

/* 100 cos of 0, 1/16, 2/16, 3/16 of a turn */
static const int8_t quarter[4] = {100, 92, 71, 38};

static int16_t cosine(uint16_t sixteenths)
{
    const uint16_t within = sixteenths % 4;
    switch (sixteenths / 4 % 4) {
    case 0:
        return quarter[within];
    case 1:
        return (int16_t)(within ? -quarter[4 - within] : 0);
    case 2:
        return (int16_t)-quarter[within];
    default:
        return (int16_t)(within ? quarter[4 - within] : 0);
    }
}

const uint16_t picture_frames = FRAMES;

/* Bands of one page: what the processor's 16 KB have room for. */
const glint_display picture_display = {
    .width_px = 128, .height_px = 64, .band_px = 8, .format = GLINT_MONO_PAGES, .dither = GLINT_DITHER_BAYER};

int picture_draw(uint16_t frame, const glint_display *display, void *memory, size_t memory_bytes, glint_report *report)
{
    const glint_light lamp = {
        .kind = GLINT_DIRECTIONAL,
        .direction = {cosine(frame), (int16_t)-cosine((uint16_t)(frame + 12)), -100},
        .colour = GLINT_WHITE,
    };
    const glint_scene scene = {
        .camera = &camera,
        .objects = &sphere,
        .object_count = 1,
        .lights = &lamp,
        .light_count = 1,
        .ambient = COLOUR(80, 80, 80),
        .background = GLINT_BLACK,
    };
    const glint_quality quality = {.shading = GLINT_SHADING_EXACT};
    return glint_fixed_parts_render(&scene, display, &quality, memory, memory_bytes, report);
}
