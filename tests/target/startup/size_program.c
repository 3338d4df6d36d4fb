/* SPDX-License-Identifier: MIT */
/*
 * The program whose size is told for a backend and a processor: a tetrahedron under one light, drawn over and over. The
 * backend's render function is GLINT_SIZE_RENDER, given on the command line. Everything but the call is a few hundred
 * bytes, so the linked size is the library's.
 *
 * 64 x 32 pixels in bands of 8 rows: what an AVR with 16 KB of RAM holds with room to spare.
 */
#include <stdint.h>

#include <glint/fixed.h>
#include <glint/float.h>
#include <glint/place.h>

static const int16_t positions[][3] GLINT_FLASH = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
static const int16_t normals_q14[][3] GLINT_FLASH = {
    {9459, 9459, 9459}, {9459, -9459, -9459}, {-9459, 9459, -9459}, {-9459, -9459, 9459}};
static const uint16_t triangles[][3] GLINT_FLASH = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};

static const glint_mesh mesh = {
    .positions = positions, .normals_q14 = normals_q14, .triangles = triangles, .vertex_count = 4, .triangle_count = 4};
static const glint_material material = {
    .ambient = GLINT_GREY(51), .diffuse = GLINT_RGB(204, 102, 51), .specular = GLINT_GREY(128), .exponent_q4 = 32 * 16};
static const glint_light light = {.kind = GLINT_DIRECTIONAL, .direction = {-5, -6, -10}, .colour = GLINT_WHITE};
static const glint_camera camera = {.eye_q16 = {0, 0, 6 * 65536}, .field_of_view_turn16 = 8192, .near_q16 = 65536};

static uint32_t memory[512];

/* Stands for the panel's data register. */
static volatile uint8_t panel;

static int send(void *context, const glint_band *band)
{
    const uint8_t *pixels = band->pixels;
    (void)context;
    for (uint32_t i = 0; i < band->bytes; i++) {
        panel = pixels[i];
    }
    return 0;
}

int main(void)
{
    static const glint_quality quality = {.shading = GLINT_SHADING_EXACT};
    static const glint_display display = {
        .width_px = 64, .height_px = 32, .band_px = 8, .format = GLINT_RGB565_SWAPPED, .flush = send};
    for (uint16_t turn16 = 0;; turn16 = (uint16_t)(turn16 + 256)) {
        const glint_object object = {.mesh = &mesh, .material = &material, .place = glint_turn_y(turn16)};
        const glint_scene scene = {.camera = &camera,
                                   .objects = &object,
                                   .lights = &light,
                                   .object_count = 1,
                                   .light_count = 1,
                                   .ambient = GLINT_GREY(51)};
        const int error = GLINT_SIZE_RENDER(&scene, &display, &quality, memory, sizeof memory, (glint_report *)0);
        if (error != 0) {
            return error;
        }
    }
}
