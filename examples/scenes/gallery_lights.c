/* SPDX-License-Identifier: MIT */
/*
 * A white still life under a blue light, under a blue and a red one, and under a blue, a red and a green one: light is
 * additive, and where all three fall the sum is white.
 */
#include <examples/scenes/still_life.h>

static const glint_camera camera = STILL_LIFE_CAMERA;

static const glint_material glazed = {
    .ambient = COLOUR(800, 800, 800),
    .diffuse = COLOUR(750, 750, 750),
    .specular = COLOUR(350, 350, 350),
    .exponent_q4 = 40 * 16,
};
static const glint_material ground = {.ambient = COLOUR(500, 500, 500), .diffuse = COLOUR(500, 500, 500)};

static const glint_object objects[] = STILL_LIFE_OBJECTS(glazed, glazed, glazed, ground);

/* Each scene takes the first one, two or three. */
static const glint_light lights[] = {
    {.kind = GLINT_DIRECTIONAL, .direction = {9, -6, -5}, .colour = COLOUR(150, 250, 1000)},
    {.kind = GLINT_DIRECTIONAL, .direction = {-9, -6, -5}, .colour = COLOUR(1000, 200, 150)},
    {.kind = GLINT_DIRECTIONAL, .direction = {0, -5, -9}, .colour = COLOUR(150, 800, 200)},
};

#define UNDER_LIGHTS(count)                                                                                            \
    {                                                                                                                  \
        .camera = &camera, .objects = objects, .object_count = LENGTH_OF(objects), .lights = lights,                   \
        .light_count = (count), .ambient = COLOUR(60, 60, 60), .background = COLOUR(25, 25, 30)                        \
    }

const glint_scene demo_lights_blue = UNDER_LIGHTS(1);
const glint_scene demo_lights_blue_red = UNDER_LIGHTS(2);
const glint_scene demo_lights_blue_red_green = UNDER_LIGHTS(3);
