/* SPDX-License-Identifier: MIT */
/*
 * The cases of test_validate.c: small changes to one valid scene, each with the code that it gets.
 */
#ifndef GLINT_TESTS_UNIT_TEST_VALIDATE_CASES_H
#define GLINT_TESTS_UNIT_TEST_VALIDATE_CASES_H

#include "tests/unit/backends.h"
#include "tests/unit/board.h"

#define SPARE 64
#define LIGHTS (GLINT_MAX_LIGHTS + 1)
#define LARGEST_MEMORY (1 << 20)

/* As much as there is; the least for the scene; one byte less; what the scene without its effect takes, all told. */
enum { FULL_MEMORY = 0, LEAST_MEMORY = 1, SHORT_MEMORY = 2, PLAIN_MEMORY = 3 };

typedef struct world {
    board b;
    glint_environment environment;
    glint_display display;
    glint_quality quality;
    glint_transfers transfers;
    glint_texture texture;
    const glint_scene *scene_argument;
    const glint_display *display_argument;
    const glint_quality *quality_argument;
    bool no_memory;
    uint8_t memory_kind, misaligned;
    size_t plain_bytes[BACKENDS];
    unsigned flushed;
} world;

/* All lights alike; more than the library takes. */
static glint_light many_lights[LIGHTS];
static uint32_t memory_words[LARGEST_MEMORY / 4];

static int count_flush(void *context, const glint_band *band)
{
    world *w = context;
    (void)band;
    w->flushed++;
    if (w->display.transfers) {
        glint_flush_done(&w->transfers);
    }
    return 0;
}

static void set_up(world *w)
{
    memset(w, 0, sizeof *w);
    board_set_up(&w->b);
    w->b.scene.light_count = 2;
    w->b.light[1].kind = GLINT_POINT;
    w->display.width_px = 9;
    w->display.height_px = 10;
    w->display.flush = count_flush;
    w->display.context = w;
    w->scene_argument = &w->b.scene;
    w->display_argument = &w->display;
    w->quality_argument = &w->quality;
    for (int i = 0; i < LIGHTS; i++) {
        many_lights[i] = w->b.light[0];
    }
}

static void set_mirror(world *w, uint8_t side)
{
    static const uint16_t texels[128 * 128];
    w->environment.texels = texels;
    w->environment.side = side;
    w->b.scene.environment = &w->environment;
    w->b.material.mirror = board_grey(16384);
}

static void set_ball(world *w, int32_t radius_q16, int32_t x_q16)
{
    w->b.light[1].kind = GLINT_BALL;
    w->b.light[1].radius_q16 = radius_q16;
    w->b.light[1].position_q16[0] = x_q16;
}

/* `balls` of 13 points each, which is what 16 samples come to, and so many directional lights. */
static void set_balls(world *w, uint16_t balls, uint16_t others)
{
    w->b.scene.lights = many_lights;
    w->b.scene.light_count = (uint16_t)(balls + others - 24);
    for (uint16_t i = 0; i < balls; i++) {
        many_lights[i].kind = GLINT_BALL;
        many_lights[i].radius_q16 = 1 << 16;
    }
}

static void set_panel(world *w, int32_t first_q16, int32_t second_q16, int32_t y_q16)
{
    w->b.light[1].kind = GLINT_PANEL;
    w->b.light[1].edge_q16[0][1] = first_q16;
    w->b.light[1].edge_q16[1][1] = second_q16;
    w->b.light[1].position_q16[1] = y_q16;
}

static void set_place(world *w, int32_t a, int32_t b, int32_t c)
{
    int32_t(*linear)[3] = w->b.object.place.linear_q16;
    memset(w->b.object.place.linear_q16, 0, sizeof w->b.object.place.linear_q16);
    linear[0][0] = a;
    linear[1][1] = b;
    linear[2][2] = c;
}

static void set_shear(world *w, int32_t a, int32_t b)
{
    set_place(w, a, b, 1 << 16);
    w->b.object.place.linear_q16[0][1] = a;
    w->b.object.place.linear_q16[1][0] = a;
}

static void set_up_vector(world *w, int16_t x, int16_t y, int16_t z)
{
    w->b.camera.up[0] = x;
    w->b.camera.up[1] = y;
    w->b.camera.up[2] = z;
}

static void set_pages(world *w, uint16_t height_px, uint16_t band_px)
{
    w->display.format = GLINT_MONO_PAGES;
    w->display.height_px = height_px;
    w->display.band_px = band_px;
}

static void set_area(world *w, uint16_t height_px, uint16_t y_px, uint16_t rows)
{
    w->display.height_px = height_px;
    w->display.area_y_px = y_px;
    w->display.area_height_px = rows;
}

static void set_page_area(world *w, uint16_t height_px, uint16_t y_px, uint16_t rows)
{
    w->display.format = GLINT_MONO_PAGES;
    set_area(w, height_px, y_px, rows);
}

static void set_stride(world *w, uint8_t format, uint16_t width_px, uint32_t stride_bytes)
{
    w->display.format = format;
    w->display.width_px = width_px;
    w->display.stride_bytes = stride_bytes;
}

/* Light 1 as a spot light. */
static void set_spot(world *w, uint16_t inner_turn16, uint16_t outer_turn16)
{
    w->b.light[1].kind = GLINT_SPOT;
    w->b.light[1].direction[2] = -1;
    w->b.light[1].inner_turn16 = inner_turn16;
    w->b.light[1].outer_turn16 = outer_turn16;
}

static void set_fog(world *w, int32_t begin_q16, int32_t end_q16)
{
    w->b.scene.fog.begin_q16 = begin_q16;
    w->b.scene.fog.end_q16 = end_q16;
}

/* A texture that is all right. */
static glint_texture *set_texture(world *w)
{
    static const uint16_t texels[4] = {0, 1, 2, 3};
    static const int16_t texcoords[4][2] = {{0, 0}, {512, 0}, {512, 512}, {0, 512}};
    const glint_texture texture = {
        .texels = texels, .palette = texels, .palette_count = 4, .width_px = 1, .height_px = 2};
    w->texture = texture;
    w->b.material.texture = &w->texture;
    w->b.mesh.texcoords = texcoords;
    w->b.mesh.texcoord_bits = 9;
    return &w->texture;
}

static void set_palette(world *w, const uint16_t *palette, uint16_t count)
{
    set_texture(w)->format = GLINT_TEXTURE_PALETTE8;
    w->texture.palette = palette;
    w->texture.palette_count = count;
}

static void set_texcoords(world *w, const int16_t (*texcoords)[2], int8_t bits)
{
    (void)set_texture(w);
    w->b.mesh.texcoords = texcoords;
    w->b.mesh.texcoord_bits = bits;
}

static void set_buffers(world *w, uint8_t count, bool transfers)
{
    w->display.buffer_count = count;
    w->display.transfers = transfers ? &w->transfers : NULL;
}

static void set_shadows(world *w)
{
    w->b.light[0].casts_shadows = true;
}

/* Memory that is enough, the vertices kept and all, before the scene gets an effect. */
static void keep_memory(world *w)
{
    w->memory_kind = PLAIN_MEMORY;
    for (int i = 0; i < BACKENDS; i++) {
        w->plain_bytes[i] = backends[i].memory_bytes(&w->b.scene, &w->display);
    }
}

/* X(what, change, expected) */
#define NULL_CASES(X)                                                                                                  \
    X(null_scene, w->scene_argument = NULL, GLINT_ERROR_NULL_ARGUMENT)                                                 \
    X(null_display, w->display_argument = NULL, GLINT_ERROR_NULL_ARGUMENT)                                             \
    X(null_objects, w->b.scene.objects = NULL, GLINT_ERROR_NULL_OBJECTS)                                               \
    X(null_lights, w->b.scene.lights = NULL, GLINT_ERROR_NULL_LIGHTS)                                                  \
    X(null_mesh, w->b.object.mesh = NULL, GLINT_ERROR_NULL_MESH)                                                       \
    X(null_positions, w->b.mesh.positions = NULL, GLINT_ERROR_NULL_MESH)                                               \
    X(null_normals, w->b.mesh.normals_q14 = NULL, GLINT_ERROR_NULL_MESH)                                               \
    X(null_triangles, w->b.mesh.triangles = NULL, GLINT_ERROR_NULL_MESH)

/* What the size functions have to look at: they give 0 for these and for the NULL pointers above. */
#define SIZE_CASES(X)                                                                                                  \
    X(two_vertices, w->b.mesh.vertex_count = 2, GLINT_ERROR_MESH_EMPTY)                                                \
    X(no_vertex, w->b.mesh.vertex_count = 0, GLINT_ERROR_MESH_EMPTY)                                                   \
    X(no_triangle, w->b.mesh.triangle_count = 0, GLINT_ERROR_MESH_EMPTY)                                               \
    X(fraction_25, w->b.mesh.fraction_bits = 25, GLINT_ERROR_MESH_FRACTION)                                            \
    X(fraction_below_0, w->b.mesh.fraction_bits = -1, GLINT_ERROR_MESH_FRACTION)                                       \
    X(lights_4097, (w->b.scene.lights = many_lights, w->b.scene.light_count = 4097), GLINT_ERROR_LIGHT_COUNT)          \
    X(width_0, w->display.width_px = 0, GLINT_ERROR_DISPLAY_SIZE)                                                      \
    X(width_2049, w->display.width_px = 2049, GLINT_ERROR_DISPLAY_SIZE)                                                \
    X(height_0, w->display.height_px = 0, GLINT_ERROR_DISPLAY_SIZE)                                                    \
    X(height_2049, w->display.height_px = 2049, GLINT_ERROR_DISPLAY_SIZE)                                              \
    X(format_6, w->display.format = GLINT_MONO_PAGES + 1, GLINT_ERROR_DISPLAY_FORMAT)                                  \
    X(format_255, w->display.format = 255, GLINT_ERROR_DISPLAY_FORMAT)                                                 \
    X(pages_band_1, set_pages(w, 10, 1), GLINT_ERROR_DISPLAY_BAND)                                                     \
    X(pages_band_9_of_10, set_pages(w, 10, 9), GLINT_ERROR_DISPLAY_BAND)                                               \
    X(pages_band_12_of_16, set_pages(w, 16, 12), GLINT_ERROR_DISPLAY_BAND)                                             \
    X(dither_2, w->display.dither = GLINT_DITHER_BAYER + 1, GLINT_ERROR_DISPLAY_DITHER)                                \
    X(buffers_3, set_buffers(w, 3, true), GLINT_ERROR_DISPLAY_BUFFERS)                                                 \
    X(buffers_255, set_buffers(w, 255, true), GLINT_ERROR_DISPLAY_BUFFERS)                                             \
    X(buffers_2_without_transfers, set_buffers(w, 2, false), GLINT_ERROR_DISPLAY_BUFFERS)                              \
    X(stride_1, w->display.stride_bytes = 1, GLINT_ERROR_DISPLAY_STRIDE)                                               \
    X(stride_short_888, set_stride(w, GLINT_RGB888, 9, 26), GLINT_ERROR_DISPLAY_STRIDE)                                \
    X(stride_short_565, set_stride(w, GLINT_RGB565, 9, 17), GLINT_ERROR_DISPLAY_STRIDE)                                \
    X(stride_short_swapped, set_stride(w, GLINT_RGB565_SWAPPED, 9, 17), GLINT_ERROR_DISPLAY_STRIDE)                    \
    X(stride_short_grey8, set_stride(w, GLINT_GREY8, 9, 8), GLINT_ERROR_DISPLAY_STRIDE)                                \
    X(stride_short_grey4, set_stride(w, GLINT_GREY4, 9, 4), GLINT_ERROR_DISPLAY_STRIDE)                                \
    X(stride_short_pages, set_stride(w, GLINT_MONO_PAGES, 9, 8), GLINT_ERROR_DISPLAY_STRIDE)                           \
    X(area_beyond, set_area(w, 10, 8, 3), GLINT_ERROR_DISPLAY_AREA)                                                    \
    X(area_wraps, set_area(w, 10, 65535, 65535), GLINT_ERROR_DISPLAY_AREA)                                             \
    X(area_of_no_rows, set_area(w, 10, 4, 0), GLINT_ERROR_DISPLAY_AREA)                                                \
    X(area_from_within_page, set_page_area(w, 24, 4, 12), GLINT_ERROR_DISPLAY_AREA)                                    \
    X(area_to_within_page, set_page_area(w, 24, 8, 12), GLINT_ERROR_DISPLAY_AREA)

#define REFUSED_CASES(X)                                                                                               \
    X(null_quality, w->quality_argument = NULL, GLINT_ERROR_NULL_ARGUMENT)                                             \
    X(null_memory, w->no_memory = true, GLINT_ERROR_NULL_ARGUMENT)                                                     \
    X(null_camera, w->b.scene.camera = NULL, GLINT_ERROR_NULL_CAMERA)                                                  \
    X(null_material, w->b.object.material = NULL, GLINT_ERROR_NULL_MATERIAL)                                           \
    X(null_flush, w->display.flush = NULL, GLINT_ERROR_NULL_FLUSH)                                                     \
    X(index_is_count, w->b.triangles[1][2] = 4, GLINT_ERROR_MESH_INDEX)                                                \
    X(index_first, w->b.triangles[0][0] = 4, GLINT_ERROR_MESH_INDEX)                                                   \
    X(index_middle, w->b.triangles[0][1] = 65535, GLINT_ERROR_MESH_INDEX)                                              \
    X(flat_x, set_place(w, 0, 1 << 16, 1 << 16), GLINT_ERROR_PLACE_SINGULAR)                                           \
    X(flat_y, set_place(w, 1 << 16, 0, 1 << 16), GLINT_ERROR_PLACE_SINGULAR)                                           \
    X(flat_z, set_place(w, 1 << 16, 1 << 16, 0), GLINT_ERROR_PLACE_SINGULAR)                                           \
    X(equal_rows, set_shear(w, 1 << 16, 1 << 16), GLINT_ERROR_PLACE_SINGULAR)                                          \
    X(nearly_flat, set_place(w, 1 << 26, 1 << 13, 1 << 14), GLINT_ERROR_PLACE_SINGULAR)                                \
    X(linear_high, set_place(w, (1 << 26) + 1, 1 << 26, 1 << 26), GLINT_ERROR_PLACE_RANGE)                             \
    X(linear_low, set_place(w, 1 << 26, 1 << 26, -(1 << 26) - 1), GLINT_ERROR_PLACE_RANGE)                             \
    X(linear_lowest, set_place(w, 1 << 26, INT32_MIN, 1 << 26), GLINT_ERROR_PLACE_RANGE)                               \
    X(origin_high, w->b.object.place.origin_q16[0] = (1 << 30) + 1, GLINT_ERROR_PLACE_RANGE)                           \
    X(origin_low, w->b.object.place.origin_q16[2] = -(1 << 30) - 1, GLINT_ERROR_PLACE_RANGE)                           \
    X(origin_lowest, w->b.object.place.origin_q16[1] = INT32_MIN, GLINT_ERROR_PLACE_RANGE)                             \
    X(ambient_reflectance_high, w->b.material.ambient.r_q14 = 16385, GLINT_ERROR_REFLECTANCE)                          \
    X(diffuse_reflectance_high, w->b.material.diffuse.g_q14 = 16385, GLINT_ERROR_REFLECTANCE)                          \
    X(specular_reflectance_high, w->b.material.specular.b_q14 = 16385, GLINT_ERROR_REFLECTANCE)                        \
    X(ambient_reflectance_low, w->b.material.ambient.g_q14 = -1, GLINT_ERROR_REFLECTANCE)                              \
    X(diffuse_reflectance_low, w->b.material.diffuse.b_q14 = -1, GLINT_ERROR_REFLECTANCE)                              \
    X(specular_reflectance_low, w->b.material.specular.r_q14 = -1, GLINT_ERROR_REFLECTANCE)                            \
    X(exponent_high, w->b.material.exponent_q4 = 1024 * 16 + 1, GLINT_ERROR_EXPONENT)                                  \
    X(specular_model_2, w->b.material.specular_model = GLINT_BLINN + 1, GLINT_ERROR_SPECULAR_MODEL)                    \
    X(light_kind_5, w->b.light[0].kind = GLINT_BALL + 1, GLINT_ERROR_LIGHT_KIND)                                       \
    X(emission_high, w->b.material.emission.g_q14 = 16385, GLINT_ERROR_EMISSION)                                       \
    X(emission_low, w->b.material.emission.r_q14 = -1, GLINT_ERROR_EMISSION)                                           \
    X(mirror_high, (set_mirror(w, 64), w->b.material.mirror.g_q14 = 16385), GLINT_ERROR_MIRROR)                        \
    X(mirror_low, (set_mirror(w, 64), w->b.material.mirror.b_q14 = -1), GLINT_ERROR_MIRROR)                            \
    X(mirror_of_nothing, w->b.material.mirror.r_q14 = 1, GLINT_ERROR_NULL_ENVIRONMENT)                                 \
    X(environment_of_nothing, (set_mirror(w, 64), w->environment.texels = NULL), GLINT_ERROR_NULL_ENVIRONMENT)         \
    X(environment_side_0, set_mirror(w, 0), GLINT_ERROR_ENVIRONMENT_SIDE)                                              \
    X(environment_side_4, set_mirror(w, 4), GLINT_ERROR_ENVIRONMENT_SIDE)                                              \
    X(environment_side_24, set_mirror(w, 24), GLINT_ERROR_ENVIRONMENT_SIDE)                                            \
    X(environment_side_255, (set_mirror(w, 255), w->b.material.mirror = board_grey(0)), GLINT_ERROR_ENVIRONMENT_SIDE)  \
    X(transmission_above_one, w->b.material.transmission_q14 = 16385, GLINT_ERROR_TRANSMISSION)                        \
    X(transmission_most, w->b.material.transmission_q14 = 65535, GLINT_ERROR_TRANSMISSION)                             \
    X(grazing_high, w->b.material.grazing.b_q14 = 16385, GLINT_ERROR_GRAZING)                                          \
    X(grazing_low, w->b.material.grazing.g_q14 = -1, GLINT_ERROR_GRAZING)                                              \
    X(wire_wide, w->b.material.wire_width_q4 = 4097, GLINT_ERROR_WIRE)                                                 \
    X(wire_widest, w->b.material.wire_width_q4 = 65535, GLINT_ERROR_WIRE)                                              \
    X(wire_high, w->b.material.wire.r_q14 = 16385, GLINT_ERROR_WIRE)                                                   \
    X(wire_low, w->b.material.wire.b_q14 = -1, GLINT_ERROR_WIRE)                                                       \
    X(shadows_4, w->b.material.shadows = 4, GLINT_ERROR_SHADOWS)                                                       \
    X(shadows_255, w->b.material.shadows = 255, GLINT_ERROR_SHADOWS)                                                   \
    X(sides_3, w->b.material.sides = GLINT_TWO_SIDED + 1, GLINT_ERROR_SIDES)                                           \
    X(spot_direction_0, (set_spot(w, 0, 16384), w->b.light[1].direction[2] = 0), GLINT_ERROR_LIGHT_DIRECTION)          \
    X(spot_position_high, (set_spot(w, 0, 16384), w->b.light[1].position_q16[1] = (1 << 30) + 1),                      \
      GLINT_ERROR_LIGHT_POSITION)                                                                                      \
    X(cone_reversed, set_spot(w, 8192, 4096), GLINT_ERROR_LIGHT_CONE)                                                  \
    X(cone_equal, set_spot(w, 8192, 8192), GLINT_ERROR_LIGHT_CONE)                                                     \
    X(cone_step_181, set_spot(w, 8192, 8192 + 181), GLINT_ERROR_LIGHT_CONE)                                            \
    X(cone_above_90_degrees, set_spot(w, 8192, 16385), GLINT_ERROR_LIGHT_CONE)                                         \
    X(cone_wraps, set_spot(w, 65535, 100), GLINT_ERROR_LIGHT_CONE)                                                     \
    X(ball_radius_low, set_ball(w, -1, 0), GLINT_ERROR_LIGHT_EXTENT)                                                   \
    X(ball_radius_least, set_ball(w, INT32_MIN, 0), GLINT_ERROR_LIGHT_EXTENT)                                          \
    X(ball_reaches_far, set_ball(w, 1 << 30, 1), GLINT_ERROR_LIGHT_EXTENT)                                             \
    X(ball_position_high, set_ball(w, 0, (1 << 30) + 1), GLINT_ERROR_LIGHT_POSITION)                                   \
    X(ball_with_shadows, (set_ball(w, 1 << 16, 0), w->b.light[1].casts_shadows = true), GLINT_ERROR_LIGHT_SHADOWS)     \
    X(panel_with_shadows, (set_panel(w, 1, 1, 0), w->b.light[1].casts_shadows = true), GLINT_ERROR_LIGHT_SHADOWS)      \
    X(ball_samples_65, (set_ball(w, 1 << 16, 0), w->b.light[1].samples = 65), GLINT_ERROR_LIGHT_SAMPLES)               \
    X(panel_reaches_far, set_panel(w, 1 << 29, -(1 << 29), 1), GLINT_ERROR_LIGHT_EXTENT)                               \
    X(panel_edges_wrap, set_panel(w, INT32_MIN, INT32_MIN, 0), GLINT_ERROR_LIGHT_EXTENT)                               \
    X(panel_samples_255, (set_panel(w, 1, 1, 0), w->b.light[1].samples = 255), GLINT_ERROR_LIGHT_SAMPLES)              \
    X(panel_range_short, (set_panel(w, 1, 1, 0), w->b.light[1].attenuation.range_q16 = 255),                           \
      GLINT_ERROR_LIGHT_DISTANCE)                                                                                      \
    X(range_short, w->b.light[1].attenuation.range_q16 = 255, GLINT_ERROR_LIGHT_DISTANCE)                              \
    X(range_long, w->b.light[1].attenuation.range_q16 = (1 << 30) + 1, GLINT_ERROR_LIGHT_DISTANCE)                     \
    X(unit_short, w->b.light[1].attenuation.unit_q16 = 1, GLINT_ERROR_LIGHT_DISTANCE)                                  \
    X(unit_longest, w->b.light[1].attenuation.unit_q16 = UINT32_MAX, GLINT_ERROR_LIGHT_DISTANCE)                       \
    X(sky_low, w->b.scene.sky.b_q14 = -1, GLINT_ERROR_AMBIENT)                                                         \
    X(ground_low, w->b.scene.ground.r_q14 = INT16_MIN, GLINT_ERROR_AMBIENT)                                            \
    X(fog_reversed, set_fog(w, 4 << 16, 3 << 16), GLINT_ERROR_FOG)                                                     \
    X(fog_equal, set_fog(w, 4 << 16, 4 << 16), GLINT_ERROR_FOG)                                                        \
    X(fog_255, set_fog(w, 1 << 16, (1 << 16) + 255), GLINT_ERROR_FOG)                                                  \
    X(fog_before_the_eye, set_fog(w, -1, 1 << 16), GLINT_ERROR_FOG)                                                    \
    X(fog_begin_least, set_fog(w, INT32_MIN, 0), GLINT_ERROR_FOG)                                                      \
    X(fog_far, set_fog(w, 0, (1 << 30) + 1), GLINT_ERROR_FOG)                                                          \
    X(fog_red_high, (set_fog(w, 0, 1 << 16), w->b.scene.fog.colour.r_q14 = 16385), GLINT_ERROR_FOG)                    \
    X(fog_green_low, (set_fog(w, 0, 1 << 16), w->b.scene.fog.colour.g_q14 = -1), GLINT_ERROR_FOG)                      \
    X(texture_width_0, set_texture(w)->width_px = 0, GLINT_ERROR_TEXTURE_SIZE)                                         \
    X(texture_height_0, set_texture(w)->height_px = 0, GLINT_ERROR_TEXTURE_SIZE)                                       \
    X(texture_width_1025, set_texture(w)->width_px = 1025, GLINT_ERROR_TEXTURE_SIZE)                                   \
    X(texture_height_1025, set_texture(w)->height_px = 1025, GLINT_ERROR_TEXTURE_SIZE)                                 \
    X(texture_texels_null, set_texture(w)->texels = NULL, GLINT_ERROR_TEXTURE_TEXELS)                                  \
    X(texture_palette_null, set_palette(w, NULL, 4), GLINT_ERROR_TEXTURE_PALETTE)                                      \
    X(texture_palette_0, set_palette(w, set_texture(w)->palette, 0), GLINT_ERROR_TEXTURE_PALETTE)                      \
    X(texture_palette_257, set_palette(w, set_texture(w)->palette, 257), GLINT_ERROR_TEXTURE_PALETTE)                  \
    X(texture_format_2, set_texture(w)->format = GLINT_TEXTURE_PALETTE8 + 1, GLINT_ERROR_TEXTURE_FORMAT)               \
    X(texture_filter_2, set_texture(w)->filter = GLINT_BILINEAR + 1, GLINT_ERROR_TEXTURE_FILTER)                       \
    X(texture_wrap_u_2, set_texture(w)->wrap_u = GLINT_CLAMP + 1, GLINT_ERROR_TEXTURE_WRAP)                            \
    X(texture_wrap_v_2, set_texture(w)->wrap_v = GLINT_CLAMP + 1, GLINT_ERROR_TEXTURE_WRAP)                            \
    X(texture_wraps_to_0, (set_texture(w)->width_px = 32768, w->texture.height_px = 2), GLINT_ERROR_TEXTURE_SIZE)      \
    X(texture_of_a_clear_surface, (set_texture(w)->texels = NULL, w->b.material.transmission_q14 = 16384),             \
      GLINT_ERROR_TEXTURE_TEXELS)                                                                                      \
    X(spot_without_cone, set_spot(w, 0, 0), GLINT_ERROR_LIGHT_CONE)                                                    \
    X(texture_texcoords_null, set_texcoords(w, NULL, 9), GLINT_ERROR_TEXTURE_TEXCOORDS)                                \
    X(texcoord_bits_8, (set_texture(w), w->b.mesh.texcoord_bits = 8), GLINT_ERROR_TEXCOORD_BITS)                       \
    X(texcoord_bits_16, (set_texture(w), w->b.mesh.texcoord_bits = 16), GLINT_ERROR_TEXCOORD_BITS)                     \
    X(light_direction_0, w->b.light[0].direction[2] = 0, GLINT_ERROR_LIGHT_DIRECTION)                                  \
    X(light_red_low, w->b.light[0].colour.r_q14 = -1, GLINT_ERROR_LIGHT_COLOUR)                                        \
    X(light_green_low, w->b.light[1].colour.g_q14 = -1, GLINT_ERROR_LIGHT_COLOUR)                                      \
    X(light_blue_low, w->b.light[1].colour.b_q14 = INT16_MIN, GLINT_ERROR_LIGHT_COLOUR)                                \
    X(light_position_high, w->b.light[1].position_q16[0] = (1 << 30) + 1, GLINT_ERROR_LIGHT_POSITION)                  \
    X(light_position_low, w->b.light[1].position_q16[2] = -(1 << 30) - 1, GLINT_ERROR_LIGHT_POSITION)                  \
    X(lights_and_samples_4097, set_balls(w, 315, 26), GLINT_ERROR_LIGHT_COUNT)                                         \
    X(ambient_red_low, w->b.scene.ambient.r_q14 = -1, GLINT_ERROR_AMBIENT)                                             \
    X(ambient_green_low, w->b.scene.ambient.g_q14 = -1, GLINT_ERROR_AMBIENT)                                           \
    X(ambient_blue_low, w->b.scene.ambient.b_q14 = -1, GLINT_ERROR_AMBIENT)                                            \
    X(background_low, w->b.scene.background.b_q14 = -1, GLINT_ERROR_BACKGROUND)                                        \
    X(background_high, w->b.scene.background.r_q14 = 16385, GLINT_ERROR_BACKGROUND)                                    \
    X(eye_is_target, w->b.camera.eye_q16[2] = 0, GLINT_ERROR_CAMERA_DIRECTION)                                         \
    X(up_along_view, set_up_vector(w, 0, 0, 7), GLINT_ERROR_CAMERA_UP)                                                 \
    X(up_against_view, set_up_vector(w, 0, 0, INT16_MIN), GLINT_ERROR_CAMERA_UP)                                       \
    X(field_181, w->b.camera.field_of_view_turn16 = 181, GLINT_ERROR_CAMERA_FIELD)                                     \
    X(field_0, w->b.camera.field_of_view_turn16 = 0, GLINT_ERROR_CAMERA_FIELD)                                         \
    X(field_30948, w->b.camera.field_of_view_turn16 = 30948, GLINT_ERROR_CAMERA_FIELD)                                 \
    X(near_63, w->b.camera.near_q16 = 63, GLINT_ERROR_CAMERA_NEAR)                                                     \
    X(near_0, w->b.camera.near_q16 = 0, GLINT_ERROR_CAMERA_NEAR)                                                       \
    X(near_lowest, w->b.camera.near_q16 = INT32_MIN, GLINT_ERROR_CAMERA_NEAR)                                          \
    X(near_high, w->b.camera.near_q16 = (1 << 30) + 1, GLINT_ERROR_CAMERA_NEAR)                                        \
    X(eye_high, w->b.camera.eye_q16[2] = (1 << 30) + 1, GLINT_ERROR_CAMERA_RANGE)                                      \
    X(target_low, w->b.camera.target_q16[1] = -(1 << 30) - 1, GLINT_ERROR_CAMERA_RANGE)                                \
    X(shading_5, w->quality.shading = GLINT_SHADING_Q2 + 1, GLINT_ERROR_SHADING)                                       \
    X(tolerance_1, w->quality.tolerance = 1, GLINT_ERROR_TOLERANCE)                                                    \
    X(tolerance_11, w->quality.tolerance = GLINT_LEAST_TOLERANCE - 1, GLINT_ERROR_TOLERANCE)                           \
    X(tolerance_and_shading, (w->quality.tolerance = 16, w->quality.shading = GLINT_SHADING_FLAT),                     \
      GLINT_ERROR_TOLERANCE)                                                                                           \
    X(tolerance_12, w->quality.tolerance = GLINT_LEAST_TOLERANCE, GLINT_OK)                                            \
    X(tolerance_255, w->quality.tolerance = 255, GLINT_OK)                                                             \
    X(stride_odd_565, set_stride(w, GLINT_RGB565, 9, 19), GLINT_ERROR_DISPLAY_STRIDE)                                  \
    X(memory_one_byte_short, w->memory_kind = SHORT_MEMORY, GLINT_ERROR_MEMORY_SIZE)                                   \
    X(memory_short_for_shadows, (set_shadows(w), w->memory_kind = SHORT_MEMORY), GLINT_ERROR_MEMORY_SIZE)              \
    X(memory_short_for_mirrors, (set_mirror(w, 8), w->memory_kind = SHORT_MEMORY), GLINT_ERROR_MEMORY_SIZE)            \
    X(memory_short_for_textures, (set_texture(w), w->memory_kind = SHORT_MEMORY), GLINT_ERROR_MEMORY_SIZE)             \
    X(memory_short_for_spots, (set_spot(w, 0, 8192), w->memory_kind = SHORT_MEMORY), GLINT_ERROR_MEMORY_SIZE)          \
    X(memory_short_for_balls, (set_ball(w, 1 << 16, 0), w->memory_kind = SHORT_MEMORY), GLINT_ERROR_MEMORY_SIZE)       \
    X(memory_of_none_for_shadows, (keep_memory(w), set_shadows(w)), GLINT_ERROR_MEMORY_SIZE)                           \
    X(memory_of_none_for_textures, (keep_memory(w), set_texture(w)), GLINT_ERROR_MEMORY_SIZE)                          \
    X(memory_of_none_for_balls, (keep_memory(w), set_ball(w, 1 << 16, 0)), GLINT_ERROR_MEMORY_SIZE)                    \
    X(misaligned_1, w->misaligned = 1, GLINT_ERROR_MEMORY_ALIGNMENT)                                                   \
    X(misaligned_2, w->misaligned = 2, GLINT_ERROR_MEMORY_ALIGNMENT)                                                   \
    X(misaligned_3, w->misaligned = 3, GLINT_ERROR_MEMORY_ALIGNMENT)

#define ACCEPTED_CASES(X)                                                                                              \
    X(unchanged, (void)w, GLINT_OK)                                                                                    \
    X(memory_least, w->memory_kind = LEAST_MEMORY, GLINT_OK)                                                           \
    X(memory_least_for_shadows, (set_shadows(w), w->memory_kind = LEAST_MEMORY), GLINT_OK)                             \
    X(memory_least_for_mirrors, (set_mirror(w, 8), w->memory_kind = LEAST_MEMORY), GLINT_OK)                           \
    X(memory_least_for_textures, (set_texture(w), w->memory_kind = LEAST_MEMORY), GLINT_OK)                            \
    X(memory_least_for_spots, (set_spot(w, 0, 8192), w->memory_kind = LEAST_MEMORY), GLINT_OK)                         \
    X(memory_least_for_balls, (set_ball(w, 1 << 16, 0), w->memory_kind = LEAST_MEMORY), GLINT_OK)                      \
    X(objects_none, (w->b.scene.objects = NULL, w->b.scene.object_count = 0), GLINT_OK)                                \
    X(lights_none, (w->b.scene.lights = NULL, w->b.scene.light_count = 0), GLINT_OK)                                   \
    X(lights_and_samples_4096, set_balls(w, 315, 25), GLINT_OK)                                                        \
    X(lights_4096, (w->b.scene.lights = many_lights, w->b.scene.light_count = 4096), GLINT_OK)                         \
    X(three_vertices, (w->b.mesh.vertex_count = 3, w->b.mesh.triangle_count = 1), GLINT_OK)                            \
    X(fraction_0, w->b.mesh.fraction_bits = 0, GLINT_OK)                                                               \
    X(fraction_24, w->b.mesh.fraction_bits = 24, GLINT_OK)                                                             \
    X(linear_greatest, set_place(w, 1 << 26, 1 << 26, 1 << 26), GLINT_OK)                                              \
    X(linear_lowest_allowed, set_place(w, -(1 << 26), 1 << 26, -(1 << 26)), GLINT_OK)                                  \
    X(linear_smallest, set_place(w, 1, 1, 1), GLINT_OK)                                                                \
    X(nearly_flat_above, set_place(w, 1 << 26, 1 << 14, 1 << 14), GLINT_OK)                                            \
    X(origin_greatest, w->b.object.place.origin_q16[0] = 1 << 30, GLINT_OK)                                            \
    X(origin_least, w->b.object.place.origin_q16[2] = -(1 << 30), GLINT_OK)                                            \
    X(reflectance_1, w->b.material.ambient = w->b.material.diffuse = w->b.material.specular = board_grey(16384),       \
      GLINT_OK)                                                                                                        \
    X(exponent_greatest, w->b.material.exponent_q4 = 1024 * 16, GLINT_OK)                                              \
    X(blinn, w->b.material.specular_model = GLINT_BLINN, GLINT_OK)                                                     \
    X(light_brightest, w->b.light[0].colour = board_grey(32767), GLINT_OK)                                             \
    X(emission_1, w->b.material.emission = board_grey(16384), GLINT_OK)                                                \
    X(mirror_least_side, set_mirror(w, 8), GLINT_OK)                                                                   \
    X(mirror_greatest_side, set_mirror(w, 128), GLINT_OK)                                                              \
    X(environment_without_mirror, (set_mirror(w, 16), w->b.material.mirror = board_grey(0)), GLINT_OK)                 \
    X(grazing_of_an_opaque_surface, w->b.material.grazing = board_grey(16384), GLINT_OK)                               \
    X(transmission_1, w->b.material.transmission_q14 = 16384, GLINT_OK)                                                \
    X(wire_of_no_width, w->b.material.wire = board_grey(16384), GLINT_OK)                                              \
    X(wire_4096, w->b.material.wire_width_q4 = 4096, GLINT_OK)                                                         \
    X(shadows_3, (set_shadows(w), w->b.material.shadows = 3), GLINT_OK)                                                \
    X(two_sided, w->b.material.sides = GLINT_TWO_SIDED, GLINT_OK)                                                      \
    X(cone_widest, set_spot(w, 0, 16384), GLINT_OK)                                                                    \
    X(cone_narrowest, set_spot(w, 0, 182), GLINT_OK)                                                                   \
    X(cone_of_a_point, (w->b.light[1].inner_turn16 = 9, w->b.light[1].outer_turn16 = 3), GLINT_OK)                     \
    X(range_of_a_direction, w->b.light[0].attenuation.range_q16 = 1, GLINT_OK)                                         \
    X(range_shortest, w->b.light[1].attenuation.range_q16 = 256, GLINT_OK)                                             \
    X(range_longest, w->b.light[1].attenuation.range_q16 = 1 << 30, GLINT_OK)                                          \
    X(attenuation_greatest, w->b.light[1].attenuation.k_q14[2] = 65535, GLINT_OK)                                      \
    X(sky_brightest, w->b.scene.sky = w->b.scene.ground = board_grey(32767), GLINT_OK)                                 \
    X(fog_thinnest, set_fog(w, 0, 1 << 30), GLINT_OK)                                                                  \
    X(fog_thickest, set_fog(w, 1 << 16, (1 << 16) + 256), GLINT_OK)                                                    \
    X(fog_none, w->b.scene.fog.colour.r_q14 = -1, GLINT_OK)                                                            \
    X(ball_radius_0, set_ball(w, 0, 0), GLINT_OK)                                                                      \
    X(ball_greatest, set_ball(w, 1 << 29, -(1 << 29)), GLINT_OK)                                                       \
    X(ball_samples_64, (set_ball(w, 1 << 16, 0), w->b.light[1].samples = 64), GLINT_OK)                                \
    X(panel_edges_0, set_panel(w, 0, 0, 0), GLINT_OK)                                                                  \
    X(panel_greatest, set_panel(w, 1 << 28, -(1 << 28), 1 << 29), GLINT_OK)                                            \
    X(radius_of_a_point, w->b.light[1].radius_q16 = -1, GLINT_OK)                                                      \
    X(samples_of_a_point, w->b.light[1].samples = 255, GLINT_OK)                                                       \
    X(texture, (void)set_texture(w), GLINT_OK)                                                                         \
    X(texture_palette_unused, (set_texture(w)->palette = NULL, w->texture.palette_count = 999), GLINT_OK)              \
    X(texture_palette_256, set_palette(w, set_texture(w)->palette, 256), GLINT_OK)                                     \
    X(texcoord_bits_15, (set_texture(w), w->b.mesh.texcoord_bits = 15), GLINT_OK)                                      \
    X(texcoords_unused, (set_texcoords(w, NULL, 99), w->b.material.texture = NULL), GLINT_OK)                          \
    X(light_black, w->b.light[0].colour = board_grey(0), GLINT_OK)                                                     \
    X(light_direction_longest, board_light(&w->b, 0, INT16_MIN, INT16_MIN, INT16_MIN), GLINT_OK)                       \
    X(light_direction_of_a_point, w->b.light[1].direction[2] = 0, GLINT_OK)                                            \
    X(light_position_of_a_direction, w->b.light[0].position_q16[0] = INT32_MIN, GLINT_OK)                              \
    X(light_position_greatest, w->b.light[1].position_q16[0] = 1 << 30, GLINT_OK)                                      \
    X(light_position_least, w->b.light[1].position_q16[1] = -(1 << 30), GLINT_OK)                                      \
    X(ambient_brightest, w->b.scene.ambient = board_grey(32767), GLINT_OK)                                             \
    X(background_white, w->b.scene.background = board_grey(16384), GLINT_OK)                                           \
    X(eye_one_step_off, w->b.camera.eye_q16[2] = 1, GLINT_OK)                                                          \
    X(eye_greatest, w->b.camera.eye_q16[2] = 1 << 30, GLINT_OK)                                                        \
    X(target_least, w->b.camera.target_q16[2] = -(1 << 30), GLINT_OK)                                                  \
    X(up_longest, set_up_vector(w, INT16_MIN, INT16_MIN, INT16_MIN), GLINT_OK)                                         \
    X(up_shortest, set_up_vector(w, 1, 0, 0), GLINT_OK)                                                                \
    X(field_182, w->b.camera.field_of_view_turn16 = 182, GLINT_OK)                                                     \
    X(field_30947, w->b.camera.field_of_view_turn16 = 30947, GLINT_OK)                                                 \
    X(near_64, w->b.camera.near_q16 = 64, GLINT_OK)                                                                    \
    X(near_greatest, w->b.camera.near_q16 = 1 << 30, GLINT_OK)                                                         \
    X(size_1, w->display.width_px = w->display.height_px = 1, GLINT_OK)                                                \
    X(width_2048, w->display.width_px = 2048, GLINT_OK)                                                                \
    X(height_2048, w->display.height_px = 2048, GLINT_OK)                                                              \
    X(band_higher_than_display, w->display.band_px = 65535, GLINT_OK)                                                  \
    X(pages_band_8, set_pages(w, 10, 8), GLINT_OK)                                                                     \
    X(pages_band_whole, set_pages(w, 10, 0), GLINT_OK)                                                                 \
    X(pages_band_is_height, set_pages(w, 10, 10), GLINT_OK)                                                            \
    X(pages_band_above_height, set_pages(w, 10, 11), GLINT_OK)                                                         \
    X(dither_bayer, w->display.dither = GLINT_DITHER_BAYER, GLINT_OK)                                                  \
    X(buffers_1, set_buffers(w, 1, false), GLINT_OK)                                                                   \
    X(buffers_1_with_transfers, set_buffers(w, 1, true), GLINT_OK)                                                     \
    X(buffers_2, set_buffers(w, 2, true), GLINT_OK)                                                                    \
    X(stride_exact_888, set_stride(w, GLINT_RGB888, 9, 27), GLINT_OK)                                                  \
    X(stride_exact_565, set_stride(w, GLINT_RGB565, 9, 18), GLINT_OK)                                                  \
    X(stride_exact_grey4, set_stride(w, GLINT_GREY4, 9, 5), GLINT_OK)                                                  \
    X(stride_exact_pages, set_stride(w, GLINT_MONO_PAGES, 9, 9), GLINT_OK)

#define DEFINE(what, change, expected)                                                                                 \
    static void what(world *w)                                                                                         \
    {                                                                                                                  \
        change;                                                                                                        \
    }
NULL_CASES(DEFINE)
SIZE_CASES(DEFINE)
REFUSED_CASES(DEFINE)
ACCEPTED_CASES(DEFINE)

#endif
