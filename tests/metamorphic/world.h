/* SPDX-License-Identifier: MIT */
/*
 * Random scenes for the metamorphic tests: tests of what must become of a picture when its scene is changed in a way
 * whose effect is known (T. Y. Chen et al., "Metamorphic testing: a new approach for generating next test cases",
 * 1998). They need no reference, so their budgets are the rounding of one backend against itself.
 *
 * A scene has three objects in layers of depth that do not touch, all beyond the near plane and within the guard band:
 * nothing is clipped, and no two surfaces that cover one pixel have equal depth. So the order of drawing decides
 * nothing. Lights shine from the viewer's side: where the model ends a highlight abruptly, at n.s = 0, it is black.
 *
 * GLINT_SEED=N takes other scenes; the seed is printed.
 */
#ifndef GLINT_TESTS_METAMORPHIC_WORLD_H
#define GLINT_TESTS_METAMORPHIC_WORLD_H

#include "tests/image/frame.h"

#include <math.h>
#include <stdio.h>

#include "examples/meshes/meshes.h"
#include "tests/unit/backends.h"

enum {
    WORLD_OBJECTS = 3,
    WORLD_LIGHTS = 6,
    WORLD_SCENES = 100,
    WORLD_SHADINGS = 3,
    WORLD_WIDTH = 72,
    WORLD_HEIGHT = 56
};

/* At tolerance 1, where nothing more is known of a change than that the true colour stays: each picture is within a
 * code of it, in however many pixels. */
#define WITHIN_CODES 2
#define ANY_SHARE 1.0

#define WORLD_SEED 20240611u
#define ONE_Q16 65536.0

typedef struct world {
    glint_camera camera;
    glint_object objects[WORLD_OBJECTS];
    glint_material materials[WORLD_OBJECTS];
    glint_light lights[2 * WORLD_LIGHTS];
    glint_scene scene;
} world;

static uint64_t world_random_state;

static inline int world_seed(void **state)
{
    (void)state;
    const char *given = getenv("GLINT_SEED");
    const unsigned long seed = given && *given ? strtoul(given, NULL, 0) : WORLD_SEED;
    world_random_state = seed;
    print_message("GLINT_SEED=%lu\n", seed);
    return 0;
}

/* low..high, both included; high - low < 2^24. */
static inline int32_t world_between(int32_t low, int32_t high)
{
    return low + (int32_t)((uint64_t)random_u24(&world_random_state) * (uint32_t)(high - low + 1) >> 24);
}

static inline double world_real(double low, double high)
{
    return low + (high - low) * random_u24(&world_random_state) / 16777215.0;
}

static inline glint_colour world_colour(int32_t low, int32_t high)
{
    const glint_colour colour = {(int16_t)world_between(low, high), (int16_t)world_between(low, high),
                                 (int16_t)world_between(low, high)};
    return colour;
}

static inline void world_unit(double v[3])
{
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int k = 0; k < 3; k++) {
        v[k] /= length;
    }
}

static inline void world_cross(const double a[3], const double b[3], double out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    }
}

/* Any turn; every second object keeps angles, the others are stretched, every fourth is mirrored. */
static inline glint_place world_place(const double centre[3], int number)
{
    const int32_t size = world_between(40000, 78000);
    const int32_t other = number % 2 ? size : world_between(40000, 78000);
    const glint_place scale = glint_scale(number % 4 == 2 ? -size : size, other, size);
    glint_place turn = glint_turn_x((uint16_t)world_between(0, 65535));
    const glint_place turn_y = glint_turn_y((uint16_t)world_between(0, 65535));
    const glint_place turn_z = glint_turn_z((uint16_t)world_between(0, 65535));
    const glint_place shift = glint_shift((int32_t)lrint(centre[0] * ONE_Q16), (int32_t)lrint(centre[1] * ONE_Q16),
                                          (int32_t)lrint(centre[2] * ONE_Q16));
    turn = glint_then(&turn, &turn_y);
    turn = glint_then(&turn, &turn_z);
    turn = glint_then(&scale, &turn);
    return glint_then(&turn, &shift);
}

static inline void world_light(world *w, glint_light *light, const double eye[3], const double axes[3][3])
{
    const double right = world_real(-0.7, 0.7), down = world_real(-0.7, 0.7);
    light->kind = (uint8_t)world_between(GLINT_DIRECTIONAL, GLINT_POINT);
    for (int k = 0; k < 3; k++) {
        const double sideways = right * axes[0][k] + down * axes[1][k];
        light->direction[k] = (int16_t)lrint(8000 * (axes[2][k] + sideways));
        light->position_q16[k] = (int32_t)lrint(ONE_Q16 * (eye[k] + 2 * sideways));
    }
    light->colour = world_colour(0, 8000);
    (void)w;
}

/* Next random scene. Pointers go into *w, so it must stay where it is. */
static inline void world_make(world *w)
{
    static const glint_mesh *const meshes[] = {&glint_mesh_sphere_10x6, &glint_mesh_box, &glint_mesh_sphere_24x12};
    double eye[3], axes[3][3]; /* right, down, forward */
    double up[3];
    memset(w, 0, sizeof *w);
    do {
        for (int k = 0; k < 3; k++) {
            eye[k] = world_real(-20, 20);
            axes[2][k] = world_real(-1, 1);
            up[k] = world_real(-1, 1);
        }
        world_unit(axes[2]);
        world_unit(up);
        world_cross(axes[2], up, axes[0]);
    } while (axes[0][0] * axes[0][0] + axes[0][1] * axes[0][1] + axes[0][2] * axes[0][2] < 0.1);
    world_unit(axes[0]);
    world_cross(axes[2], axes[0], axes[1]);
    for (int k = 0; k < 3; k++) {
        w->camera.eye_q16[k] = (int32_t)lrint(eye[k] * ONE_Q16);
        w->camera.target_q16[k] = (int32_t)lrint((eye[k] + 9 * axes[2][k]) * ONE_Q16);
        w->camera.up[k] = (int16_t)lrint(up[k] * 32000);
    }
    w->camera.field_of_view_turn16 = (uint16_t)world_between(5000, 10000);
    w->camera.near_q16 = world_between(40000, 90000); /* the nearest surface is 2.4 units away */
    for (int i = 0; i < WORLD_OBJECTS; i++) {
        /* extents: sqrt(3) 78000 / 65536 = 2.07, so layers 4.5 apart do not touch */
        const double depth = 4.5 * (i + 1), right = world_real(-0.25, 0.25), down = world_real(-0.2, 0.2);
        double centre[3];
        for (int k = 0; k < 3; k++) {
            centre[k] = eye[k] + depth * (axes[2][k] + right * axes[0][k] + down * axes[1][k]);
        }
        glint_material *m = &w->materials[i];
        m->ambient = world_colour(0, 16384);
        m->diffuse = world_colour(0, 12000);
        m->specular = world_colour(0, 12000);
        m->exponent_q4 = (uint16_t)world_between(16, 100 * 16);
        m->specular_model = (uint8_t)world_between(GLINT_PHONG, GLINT_BLINN);
        w->objects[i].mesh = meshes[world_between(0, 2)];
        w->objects[i].material = m;
        w->objects[i].place = world_place(centre, world_between(0, 3));
    }
    w->scene.light_count = (uint16_t)world_between(1, WORLD_LIGHTS);
    for (uint16_t i = 0; i < w->scene.light_count; i++) {
        world_light(w, &w->lights[i], eye, (const double(*)[3])axes);
    }
    w->scene.camera = &w->camera;
    w->scene.objects = w->objects;
    w->scene.object_count = WORLD_OBJECTS;
    w->scene.lights = w->lights;
    w->scene.ambient = world_colour(0, 4000);
    w->scene.background = world_colour(0, 16384);
}

/* A copy that may be changed on its own. */
static inline void world_copy(world *to, const world *from)
{
    *to = *from;
    to->scene.camera = &to->camera;
    to->scene.objects = to->objects;
    to->scene.lights = to->lights;
    for (int i = 0; i < WORLD_OBJECTS; i++) {
        for (int k = 0; k < WORLD_OBJECTS; k++) {
            if (from->objects[i].material == &from->materials[k]) {
                to->objects[i].material = &to->materials[k];
            }
        }
    }
}

/* Every object in its own one colour, without lights: what is left of the picture is coverage and depth. */
static inline void world_silhouette(world *w)
{
    static const glint_colour bright = {16384, 16384, 16384};
    w->scene.light_count = 0;
    w->scene.ambient = bright;
    for (int i = 0; i < WORLD_OBJECTS; i++) {
        const glint_colour own = {(int16_t)(i == 0 ? 16384 : 0), (int16_t)(i == 1 ? 16384 : 0),
                                  (int16_t)(i == 2 ? 16384 : 0)};
        w->materials[i].ambient = own;
    }
    w->scene.background = bright;
}

static inline frame world_draw(const world *w, uint16_t width, int shading, int backend)
{
    frame f = {.display = {.width_px = width, .height_px = WORLD_HEIGHT}, .shading = (uint8_t)shading};
    assert_int_equal(frame_draw(&f, &w->scene, backend), 0);
    assert_int_equal(f.report.triangles_clipped, 0);
    return f;
}

/* What two pictures have in common, over all tests of a kind. */
typedef struct comparison {
    uint32_t pixels, differing; /* in any channel */
    int greatest;               /* difference of a channel in codes */
    uint32_t shaded;            /* pixels that were not background, with repetitions */
    uint32_t below;             /* of those: by a tier below exact */
} comparison;

/* Pixel (x, y) of a beside pixel (x + shift, y) of b, or (width - 1 - x, y) of b where mirrored. `skip` may be NULL. */
static inline void world_compare(comparison *sum, const frame *a, const frame *b, int shift, int mirrored,
                                 const uint8_t *skip)
{
    const int width = a->display.width_px, wide = b->display.width_px;
    sum->shaded += a->report.pixels_shaded;
    for (int y = 0; y < a->display.height_px; y++) {
        for (int x = 0; x < width; x++) {
            const uint8_t *p = a->pixels + 3 * (y * width + x);
            const uint8_t *q = b->pixels + 3 * (y * wide + (mirrored ? width - 1 - x : x + shift));
            int most = 0;
            if (skip && skip[y * width + x]) {
                continue;
            }
            for (int k = 0; k < 3; k++) {
                const int difference = abs(p[k] - q[k]);
                most = difference > most ? difference : most;
            }
            sum->pixels++;
            sum->differing += most > 0;
            sum->greatest = most > sum->greatest ? most : sum->greatest;
        }
    }
}

/*
 * At tolerance 1, in both backends: sum[0] and sum[1]. Each pixel of either picture is within what its report promises
 * of the true colour, and a change that leaves the true colour alone therefore moves a pixel by no more than the sum of
 * both promises; that much is asserted here for each pair of pictures. Lights are taken as directional in both worlds,
 * since a point light leaves nothing for the cheaper tiers; sum[].below counts the pixels that those drew.
 */
static inline void world_compare_within(comparison sum[FRAME_BACKENDS], const world *a, const world *b, int shift,
                                        int mirrored, const uint8_t *skip)
{
    static world first, second;
    world_copy(&first, a);
    world_copy(&second, b);
    for (int i = 0; i < 2 * WORLD_LIGHTS; i++) {
        first.lights[i].kind = second.lights[i].kind = GLINT_DIRECTIONAL;
    }
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        comparison pair = {0};
        frame f = {.display = {.width_px = WORLD_WIDTH, .height_px = WORLD_HEIGHT}, .tolerance = GLINT_CODES(1)};
        frame g = {.display = {.width_px = (uint16_t)(WORLD_WIDTH + 2 * shift), .height_px = WORLD_HEIGHT},
                   .tolerance = GLINT_CODES(1)};
        assert_int_equal(frame_draw(&f, &first.scene, backend), 0);
        assert_int_equal(frame_draw(&g, &second.scene, backend), 0);
        world_compare(&pair, &f, &g, shift, mirrored, skip);
        const unsigned promised = (unsigned)f.report.promise_q8 + g.report.promise_q8;
        if ((unsigned)pair.greatest * 256 > promised) {
            fail_msg("%s: %d codes apart, promised are %u / 256", frame_backend_name[backend], pair.greatest, promised);
        }
        sum[backend].pixels += pair.pixels;
        sum[backend].differing += pair.differing;
        sum[backend].shaded += pair.shaded;
        sum[backend].greatest = pair.greatest > sum[backend].greatest ? pair.greatest : sum[backend].greatest;
        sum[backend].below += f.report.pixels_shaded - f.report.tier_pixels[GLINT_TIER_EXACT];
        frame_free(&f);
        frame_free(&g);
    }
}

/* Prints and asserts. A comparison of empty pictures proves nothing. */
static inline void world_expect(const comparison *c, const char *what, int codes, double share)
{
    print_message("%-58s greatest %d codes, %.4f %% of %u pixels\n", what, c->greatest,
                  100.0 * c->differing / (c->pixels ? c->pixels : 1), c->pixels);
    assert_true(c->pixels > 0 && c->shaded > c->pixels / 20);
    assert_true(c->greatest <= codes);
    assert_true(c->differing <= share * c->pixels);
}

/* The same of what world_compare_within() found, `name` the change. Were few pixels drawn by the cheaper tiers, it
 * would prove little of them. */
static inline void world_expect_within(const comparison sum[FRAME_BACKENDS], const char *name, int codes, double share)
{
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        char what[80];
        (void)snprintf(what, sizeof what, "%s, %s, tolerance 1 (%.0f %% cheaper)", name, frame_backend_name[backend],
                       100.0 * sum[backend].below / (sum[backend].shaded ? sum[backend].shaded : 1));
        world_expect(&sum[backend], what, codes, share);
        assert_true(sum[backend].below > sum[backend].shaded / 10);
    }
}

#endif
