/* SPDX-License-Identifier: MIT */
/*
 * The self-test's second scene (the first is sphere-10x6 of examples/scenes): small, and with what the first lacks.
 * Blinn's cosine, a point light beside a directional one, unequal scale, a turned box, and a floor that runs through
 * the near plane and out of the guard band. And a third: a floor with a texture, cut by the near plane.
 */
#include <examples/scenes/parts.h>

#include <glint/quality.h>

#include "tests/target/selftest.h"

static const glint_camera camera = {
    .eye_q16 = POINT(0, 1300, 4200),
    .target_q16 = POINT(100, 300, 0),
    .field_of_view_turn16 = DEGREES_TURN16(50),
    .near_q16 = MILLI_Q16(700),
};

static const glint_material ground = {.ambient = COLOUR(480, 470, 500),
                                      .diffuse = COLOUR(480, 470, 500),
                                      .specular = COLOUR(300, 300, 300),
                                      .exponent_q4 = 12 * 16,
                                      .specular_model = GLINT_BLINN};
static const glint_material brick = {.ambient = COLOUR(620, 260, 180),
                                     .diffuse = COLOUR(620, 260, 180),
                                     .specular = COLOUR(200, 200, 200),
                                     .exponent_q4 = 20 * 16 + 7};
static const glint_material pearl = {.ambient = COLOUR(300, 400, 500),
                                     .diffuse = COLOUR(300, 400, 500),
                                     .specular = COLOUR(700, 700, 700),
                                     .exponent_q4 = 90 * 16,
                                     .specular_model = GLINT_BLINN};

static const glint_object objects[] = {
    {&glint_mesh_box, &ground, PLACE_SCALED(40000, 100, 9000, 0, -100, 0)},
    {&glint_mesh_box, &brick, PLACE_TURNED(4, 3, 5, 550, -1000, 550, -300)},
    {&glint_mesh_sphere_10x6, &pearl, PLACE_SCALED(600, 900, 500, 700, 900, 200)},
};

static const glint_light lights[] = {
    {.kind = GLINT_POINT, .position_q16 = POINT(-200, 1900, 1300), .colour = COLOUR(900, 850, 700)},
    {.kind = GLINT_DIRECTIONAL, .direction = {-5, -6, -10}, .colour = COLOUR(250, 300, 450)},
};

const glint_scene selftest_room = {
    .camera = &camera,
    .objects = objects,
    .lights = lights,
    .object_count = LENGTH_OF(objects),
    .light_count = LENGTH_OF(lights),
    .ambient = COLOUR(130, 130, 150),
    .background = COLOUR(100, 140, 200),
};

/* A mirror under a map of few colours, lit by a ball whose light falls off. */
static const GLINT_FLASH uint16_t texels[8 * 8] = {
    0x39c7, 0x39c7, 0x4208, 0x528a, 0x528a, 0x4208, 0x39c7, 0x39c7, 0x39c7, 0x528a, 0x7bcf, 0x8c71, 0x8c71,
    0x7bcf, 0x528a, 0x39c7, 0x4208, 0x7bcf, 0xa5b4, 0x8d17, 0x8d17, 0xa5b4, 0x7bcf, 0x4208, 0x528a, 0x8c71,
    0x8d17, 0x5c9a, 0x5c9a, 0x8d17, 0x8c71, 0x528a, 0x528a, 0x8c71, 0x8d17, 0x5c9a, 0x5c9a, 0x8d17, 0x8c71,
    0x528a, 0x4208, 0x7bcf, 0xa5b4, 0x8d17, 0x8d17, 0xa5b4, 0x7bcf, 0x4208, 0x39c7, 0x528a, 0x7bcf, 0x8c71,
    0x8c71, 0x7bcf, 0x528a, 0x39c7, 0x39c7, 0x39c7, 0x4208, 0x528a, 0x528a, 0x4208, 0x39c7, 0x39c7};
static const glint_environment around = {.texels = texels, .side = 8, .steepest = 60};
static const glint_material steel = {.diffuse = COLOUR(300, 300, 320),
                                     .specular = COLOUR(200, 200, 200),
                                     .exponent_q4 = 10 * 16,
                                     .mirror = COLOUR(600, 620, 650)};
static const glint_object mirrors[] = {
    {&glint_mesh_sphere_10x6, &steel, PLACE_SCALED(900, 1200, 800, 300, 700, 200)},
    {&glint_mesh_box, &brick, PLACE_TURNED(4, 3, 5, 550, -1200, 550, -300)},
};
static const glint_light ball = {.kind = GLINT_BALL,
                                 .position_q16 = POINT(-1500, 3000, 3000),
                                 .radius_q16 = MILLI_Q16(300),
                                 .colour = COLOUR(1200, 1100, 900),
                                 .attenuation = {.k_q14 = {0, 0, 16384}, .unit_q16 = MILLI_Q16(4000)},
                                 .samples = 5};

const glint_scene selftest_mirror = {
    .camera = &camera,
    .objects = mirrors,
    .lights = &ball,
    .object_count = LENGTH_OF(mirrors),
    .light_count = 1,
    .ambient = COLOUR(130, 130, 150),
    .background = COLOUR(100, 140, 200),
    .environment = &around,
};

#if SELFTEST_TEXTURES
static const int16_t floor_positions[][3] GLINT_FLASH = {
    {-16384, 0, -16384}, {-16384, 0, 16384}, {16384, 0, 16384}, {16384, 0, -16384}};
static const int16_t floor_normals_q14[][3] GLINT_FLASH = {{0, 16384, 0}, {0, 16384, 0}, {0, 16384, 0}, {0, 16384, 0}};
static const int16_t floor_texcoords[][2] GLINT_FLASH = {{-2048, -2048}, {-2048, 4096}, {4096, 4096}, {4096, -2048}};
static const uint16_t floor_triangles[][3] GLINT_FLASH = {{0, 1, 2}, {0, 2, 3}};
static const uint8_t floor_texels[] GLINT_FLASH = {0, 1, 2, 3, 2, 1, 4, 0, 2, 1, 0, 3, 4, 2, 1, 9, 0, 2, 1, 4};
static const uint16_t floor_palette[] GLINT_FLASH = {0x39c7, 0xbdf7, 0x8b27, 0xffff, 0x5c60};

static const glint_mesh floor_mesh = {
    .positions = floor_positions,
    .normals_q14 = floor_normals_q14,
    .triangles = floor_triangles,
    .vertex_count = 4,
    .triangle_count = 2,
    .fraction_bits = 14,
    .texcoord_bits = 11,
    .texcoords = floor_texcoords,
};
static const glint_texture floor_texture = {
    .texels = floor_texels,
    .palette = floor_palette,
    .palette_count = 5,
    .width_px = 5,
    .height_px = 4,
    .format = GLINT_TEXTURE_PALETTE8,
    .filter = GLINT_BILINEAR,
    .wrap_v = GLINT_CLAMP,
};
static const glint_material floor_material = {
    .ambient = COLOUR(900, 900, 900),
    .diffuse = COLOUR(900, 900, 900),
    .specular = COLOUR(200, 200, 200),
    .exponent_q4 = 30 * 16,
    .texture = &floor_texture,
};
static const glint_object floor_object = {&floor_mesh, &floor_material, PLACE_SCALED(3500, 1000, 4500, 0, 0, 0)};

static const glint_scene selftest_floor = {
    .camera = &camera,
    .objects = &floor_object,
    .lights = lights,
    .object_count = 1,
    .light_count = LENGTH_OF(lights),
    .ambient = COLOUR(130, 130, 150),
    .background = COLOUR(100, 140, 200),
};
#endif

/* The same with shadows of both lights: the floor runs behind the eye. */
static const glint_light casting_lights[] = {
    {.kind = GLINT_POINT,
     .position_q16 = POINT(-200, 1900, 1300),
     .colour = COLOUR(900, 850, 700),
     .casts_shadows = true},
    {.kind = GLINT_DIRECTIONAL, .direction = {-5, -6, -10}, .colour = COLOUR(250, 300, 450), .casts_shadows = true},
};

const glint_scene selftest_shadows = {
    .camera = &camera,
    .objects = objects,
    .lights = casting_lights,
    .object_count = LENGTH_OF(objects),
    .light_count = LENGTH_OF(casting_lights),
    .ambient = COLOUR(130, 130, 150),
    .background = COLOUR(100, 140, 200),
};

const selftest_picture selftest_pictures[SELFTEST_PICTURES] = {
    {"sphere-exact", &demo_sphere_10x6, 48, 32, 0, GLINT_SHADING_EXACT},
    {"room-exact", &selftest_room, 48, 32, 16, GLINT_SHADING_EXACT},
    {"mirror-exact", &selftest_mirror, 48, 32, 16, GLINT_SHADING_EXACT},
    {"room-gouraud", &selftest_room, 48, 32, 7, GLINT_SHADING_GOURAUD},
    {"room-flat", &selftest_room, 48, 32, 1, GLINT_SHADING_FLAT},
#if SELFTEST_TEXTURES
    {"floor-exact", &selftest_floor, 48, 32, 8, GLINT_SHADING_EXACT},
    {"floor-gouraud", &selftest_floor, 48, 32, 32, GLINT_SHADING_GOURAUD},
#endif
};
