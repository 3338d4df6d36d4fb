/* SPDX-License-Identifier: MIT */
/*
 * What a part of the library costs on a target: the yardstick scene without the effect and with it, drawn by a backend
 * that has the part or has it not. The command line names the parts, GLINT_PARTS, the one in question, EFFECT, and the
 * backend, EFFECT_IN_FLOAT 0 or 1. Lines:
 *
 *     plain|on SHADING STEPS|refused    a frame of 240 x 240, RGB565; refused: the backend has not the part
 *     memory plain|on BYTES             the least that such a frame takes
 *     end
 *
 * "on" of Gouraud and flat shading is the scene drawn flat; of the tiers, within a tolerance of 1.
 */
#include <stddef.h>

#include <glint/error.h>
#include <glint/fixed.h>
#include <glint/float.h>
#include <glint/parts.h>

#include "examples/meshes/meshes.h"
#include "examples/scenes/environments.h"
#include "examples/scenes/scenes.h"
#include "examples/textures/textures.h"
#include "tests/target/platform.h"
#include "tests/target/selftest.h"
#include "tools/cost/calibrate.h"

#if EFFECT_IN_FLOAT
#define RENDER glint_float_parts_render
#define LEAST_BYTES glint_float_parts_memory_least_bytes
#else
#define RENDER glint_fixed_parts_render
#define LEAST_BYTES glint_fixed_parts_memory_least_bytes
#endif

/* The whole picture is one band. */
enum { WIDTH_PX = 240, HEIGHT_PX = 240, MEMORY_BYTES = 512 * 1024 };

static uint32_t memory[MEMORY_BYTES / sizeof(uint32_t)];

/* The yardstick scene; points into itself, so it is not copied. */
typedef struct stage {
    glint_scene scene;
    glint_object object;
    glint_material material;
    glint_light light;
    glint_quality quality;
} stage;

static void set_up(stage *s)
{
    s->scene = demo_sphere_32x16;
    s->object = s->scene.objects[0];
    s->material = *s->object.material;
    s->light = s->scene.lights[0];
    s->quality.shading = GLINT_SHADING_EXACT;
    s->quality.tolerance = 0;
    s->object.material = &s->material;
    s->scene.objects = &s->object;
    s->scene.lights = &s->light;
    if (EFFECT == GLINT_PART_SPECULAR) {
        const glint_colour black = GLINT_BLACK;
        s->material.specular = black;
    }
}

/* The same direction and, nearly, the same light as the scene's own. */
static void hang_lamp(stage *s, uint8_t kind)
{
    static const int32_t at_q16[3] = {5 << 16, 6 << 16, 10 << 16};
    s->light.kind = kind;
    for (int k = 0; k < 3; k++) {
        s->light.position_q16[k] = at_q16[k];
    }
}

/* Asks for the effect. */
static void turn_on(stage *s)
{
    static const glint_colour dim = GLINT_GREY(60), bright = GLINT_GREY(160);
    switch (EFFECT) {
    case GLINT_PART_SPECULAR:
        s->material.specular = demo_sphere_32x16.objects[0].material->specular;
        break;
    case GLINT_PART_POINTS:
        hang_lamp(s, GLINT_POINT);
        break;
    case GLINT_PART_CORNERS:
        s->quality.shading = GLINT_SHADING_FLAT;
        break;
    case GLINT_PART_TIERS:
        s->quality.tolerance = GLINT_CODES(1);
        break;
    case GLINT_PART_REACH:
        hang_lamp(s, GLINT_SPOT);
        s->light.outer_turn16 = 1000;
        s->light.attenuation.k_q14[0] = 16384;
        s->light.attenuation.k_q14[2] = 16;
        break;
    case GLINT_PART_EXTENTS:
        hang_lamp(s, GLINT_BALL);
        s->light.radius_q16 = 1 << 16;
        break;
    case GLINT_PART_SKY:
        s->scene.sky = bright;
        s->scene.ground = dim;
        break;
    case GLINT_PART_MIRRORS:
        s->material.mirror = bright;
        s->scene.environment = &demo_environment_sky;
        break;
    case GLINT_PART_SIDES:
        s->material.sides = GLINT_TWO_SIDED;
        break;
    case GLINT_PART_FOG:
        s->scene.fog.begin_q16 = 1 << 16;
        s->scene.fog.end_q16 = 4 << 16;
        s->scene.fog.colour = bright;
        break;
    case GLINT_PART_TRANSMISSION:
        s->material.transmission_q14 = 8192;
        break;
    case GLINT_PART_WIRE:
        s->material.wire_width_q4 = 16;
        break;
    case GLINT_PART_TEXTURES:
        s->object.mesh = &glint_mesh_globe_32x16;
        s->material.texture = &glint_texture_globe;
        break;
    case GLINT_PART_SHADOWS:
        s->light.casts_shadows = true;
        break;
    default:
        break;
    }
}

static int discard(void *context, const glint_band *band)
{
    (void)context;
    (void)band;
    return 0;
}

static const glint_display display = {
    .width_px = WIDTH_PX, .height_px = HEIGHT_PX, .format = GLINT_RGB565, .flush = discard};

/* One copy of the code, so that frames alike cost the same. */
__attribute__((noinline)) static uint32_t frame(const stage *s, int *error)
{
    const uint32_t start = platform_count();
    *error = RENDER(&s->scene, &display, &s->quality, memory, sizeof memory, NULL);
    return platform_count() - start;
}

static void draw(const char *kind, const stage *s)
{
    int error;
    const uint32_t steps = frame(s, &error);
    report_begin(error == GLINT_OK || error == GLINT_ERROR_PART ? kind : "failed");
    report_word(s->quality.tolerance ? "tolerance" : "exact");
    if (error == GLINT_OK) {
        report_decimal(steps);
    } else {
        report_word(error == GLINT_ERROR_PART ? "refused" : "error");
    }
    report_end();
    report_begin("memory");
    report_word(kind);
    report_decimal((uint32_t)LEAST_BYTES(&s->scene, &display));
    report_end();
}

int main(void)
{
    static stage s;
    platform_begin();
    cost_calibrate();
    set_up(&s);
    draw("plain", &s);
    if (GLINT_PARTS & GLINT_PART_TIERS & ~EFFECT) {
        s.quality.tolerance = GLINT_CODES(1);
        draw("plain", &s);
        s.quality.tolerance = 0;
    }
    turn_on(&s);
    draw("on", &s);
    report_begin("end");
    report_end();
    platform_end();
    return 0;
}
