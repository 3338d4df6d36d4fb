/* SPDX-License-Identifier: MIT */
/*
 * A hall of eight lamps, of which two reach what stands in its middle: drawing that costs what two lamps cost. The
 * terms that are evaluated for it are counted by the backend's own hooks, with all lamps and with the two alone, and
 * its pixels are compared bit for bit.
 *
 * A test file names the backend in EIGHT_LAMPS_BACKEND, includes counted_terms.h and the backend's source, and this.
 */
#ifndef GLINT_TESTS_IMAGE_TEST_EIGHT_LAMPS_H
#define GLINT_TESTS_IMAGE_TEST_EIGHT_LAMPS_H

#include <stdio.h>

#include "tests/image/frame.h"

#include "examples/scenes/scenes.h"

enum { WIDTH = 320, HEIGHT = 240, KNOT = 0 };

static uint8_t owner[HEIGHT][WIDTH]; /* 1 and the number of the object that a pixel shows; 0: none */
static uint16_t drawn_object;
static shade_function drawn_run;

static void own_run(shade_state *shade, int16_t x, int16_t y, uint16_t count)
{
    memset(&owner[y][x], drawn_object + 1, count);
    drawn_run(shade, x, y, count);
}

static void own_triangle(shade_state *shade)
{
    drawn_object = shade->object->number;
    drawn_run = shade->run;
    shade->run = own_run;
}

typedef struct outcome {
    frame drawn;
    uint32_t diffuse, specular; /* times that n.s and r.c of a light were found for the knot */
    uint8_t owner[HEIGHT][WIDTH];
} outcome;

static void draw(outcome *o, const glint_scene *scene, uint8_t shading, uint8_t tolerance)
{
    memset(o, 0, sizeof *o);
    memset(owner, 0, sizeof owner);
    memset(counted, 0, sizeof counted);
    o->drawn.display = (glint_display){.width_px = WIDTH, .height_px = HEIGHT};
    o->drawn.shading = shading;
    o->drawn.tolerance = tolerance;
    assert_int_equal(frame_draw(&o->drawn, scene, EIGHT_LAMPS_BACKEND), GLINT_OK);
    o->diffuse = counted[KNOT].diffuse;
    o->specular = counted[KNOT].specular;
    memcpy(o->owner, owner, sizeof owner);
}

/* Returns how many pixels show the knot. */
static unsigned compare_knots(const outcome *a, const outcome *b)
{
    unsigned pixels = 0;
    assert_memory_equal(a->owner, b->owner, sizeof a->owner);
    for (unsigned i = 0; i < WIDTH * HEIGHT; i++) {
        if (a->owner[i / WIDTH][i % WIDTH] == KNOT + 1) {
            assert_memory_equal(a->drawn.pixels + (size_t)i * 3, b->drawn.pixels + (size_t)i * 3, 3);
            pixels++;
        }
    }
    return pixels;
}

static void test_cost_is_that_of_two(void **state)
{
    static const struct {
        const char *name;
        uint8_t shading, tolerance;
    } ways[] = {{"exact", GLINT_SHADING_EXACT, 0},
                {"tolerance 1", GLINT_SHADING_EXACT, GLINT_CODES(1)},
                {"gouraud", GLINT_SHADING_GOURAUD, 0},
                {"flat", GLINT_SHADING_FLAT, 0}};
    glint_scene two = demo_eight_lamps, far_reaching = demo_eight_lamps;
    glint_light of_two[2], reaching[8];
    outcome *const o = calloc(3, sizeof *o);
    unsigned count = 0;
    (void)state;
    assert_non_null(o);
    assert_int_equal(demo_eight_lamps.light_count, 8);
    for (unsigned i = 0; i < 8; i++) {
        reaching[i] = demo_eight_lamps.lights[i];
        reaching[i].attenuation.range_q16 = 0;
        if (demo_eight_lamps.lights[i].kind == GLINT_SPOT) {
            assert_true(count < 2);
            of_two[count++] = demo_eight_lamps.lights[i];
        }
    }
    two.lights = of_two;
    two.light_count = 2;
    far_reaching.lights = reaching;
    for (size_t i = 0; i < sizeof ways / sizeof ways[0]; i++) {
        draw(&o[0], &demo_eight_lamps, ways[i].shading, ways[i].tolerance);
        draw(&o[1], &two, ways[i].shading, ways[i].tolerance);
        draw(&o[2], &far_reaching, ways[i].shading, ways[i].tolerance);
        const unsigned pixels = compare_knots(&o[0], &o[1]);
        printf("%-12s the knot, %u pixels: n.s found %u times, r.c %u times; of the two lamps alone %u and %u; "
               "were the others to reach it %u and %u\n",
               ways[i].name, pixels, (unsigned)o[0].diffuse, (unsigned)o[0].specular, (unsigned)o[1].diffuse,
               (unsigned)o[1].specular, (unsigned)o[2].diffuse, (unsigned)o[2].specular);
        assert_true(pixels > 1000);
        assert_true(o[0].diffuse > 0 && o[0].specular > 0);
        assert_int_equal(o[0].diffuse, o[1].diffuse);
        assert_int_equal(o[0].specular, o[1].specular);
        assert_true(o[2].diffuse > 3 * o[0].diffuse); /* the count would see it */
        /* the rest of the hall has the others' light */
        assert_true(memcmp(o[0].drawn.pixels, o[1].drawn.pixels, o[0].drawn.bytes) != 0);
        for (int k = 0; k < 3; k++) {
            frame_free(&o[k].drawn);
        }
    }
    free(o);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_cost_is_that_of_two)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

#endif
