/* SPDX-License-Identifier: MIT */
/*
 * One still life with more and more of the reflectance model: ambient light alone, diffuse reflection alone, and the
 * whole of it.
 */
#include <examples/scenes/still_life.h>

static const glint_camera camera = STILL_LIFE_CAMERA;

/* Body colour in ambient and diffuse reflection, a white highlight. */
#define SURFACE(r, g, b, gloss, exponent)                                                                              \
    {                                                                                                                  \
        .ambient = COLOUR(r, g, b), .diffuse = COLOUR(r, g, b), .specular = COLOUR(gloss, gloss, gloss),               \
        .exponent_q4 = (exponent)*16                                                                                   \
    }

static const glint_material matt[] = {SURFACE(700, 330, 200, 0, 0), SURFACE(200, 450, 720, 0, 0),
                                      SURFACE(300, 600, 280, 0, 0), SURFACE(420, 400, 380, 0, 0)};
static const glint_material glossy[] = {SURFACE(700, 330, 200, 400, 40), SURFACE(200, 450, 720, 600, 100),
                                        SURFACE(300, 600, 280, 350, 20), SURFACE(420, 400, 380, 120, 10)};

static const glint_object matt_objects[] = STILL_LIFE_OBJECTS(matt[0], matt[1], matt[2], matt[3]);
static const glint_object glossy_objects[] = STILL_LIFE_OBJECTS(glossy[0], glossy[1], glossy[2], glossy[3]);

static const glint_light light = {.kind = GLINT_DIRECTIONAL, .direction = {5, -6, -8}, .colour = COLOUR(900, 900, 900)};

const glint_scene demo_ambient_only = {
    .camera = &camera,
    .objects = glossy_objects,
    .object_count = LENGTH_OF(glossy_objects),
    .ambient = COLOUR(500, 500, 500),
    .background = COLOUR(30, 35, 50),
};

const glint_scene demo_diffuse_only = {
    .camera = &camera,
    .objects = matt_objects,
    .object_count = LENGTH_OF(matt_objects),
    .lights = &light,
    .light_count = 1,
    .background = COLOUR(30, 35, 50),
};

const glint_scene demo_full_phong = {
    .camera = &camera,
    .objects = glossy_objects,
    .object_count = LENGTH_OF(glossy_objects),
    .lights = &light,
    .light_count = 1,
    .ambient = COLOUR(200, 200, 200),
    .background = COLOUR(30, 35, 50),
};
