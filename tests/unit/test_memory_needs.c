/* SPDX-License-Identifier: MIT */
/*
 * The working memory at the limits of what is kept in it (src/memory.h): with 65,535 triangles or more there are no
 * sorted lists, and a row of pixels is at most 1,048,575 bytes; and the bounds at compile time of <glint/memory.h>.
 */
#include "tests/unit/backends.h"
#include "tests/unit/board.h"

#include <stdio.h>

#include <glint/error.h>

#include "examples/scenes/scenes.h"

#define MOST_SORTED 65534u /* triangles; the number 65535 ends a list */
#define VERTEX_BYTES 12
#define BAND_PX 4
#define LONGEST_STRIDE 0xfffffu

/* Budget: how much more than a backend's own number GLINT_MEMORY_WORDS may ask for. */
#define WORDS_FACTOR 1.10
#define WORDS_MORE 1024.0
#define WORDS_A_LIGHT 48.0 /* and for each light of each object, of which the float backend keeps less */

/* Objects that share the board's mesh under other numbers of triangles: of all but the scene's last two, which are the
 * board's, nothing is to be seen. */
#define MOST_OBJECTS 3
typedef struct crowd {
    board b;
    glint_mesh mesh[MOST_OBJECTS];
    glint_object objects[MOST_OBJECTS];
} crowd;

static uint16_t no_area[65535][3]; /* all corners the same vertex */

static void crowd_set_up(crowd *c, uint32_t triangles)
{
    static uint16_t last[65535][3];
    uint32_t left = triangles;
    board_set_up(&c->b);
    board_normals(&c->b, 8000, 3000, 12000);
    c->b.material.diffuse = board_grey(15000);
    c->b.scene.object_count = 0;
    while (left > 0) {
        const uint16_t i = c->b.scene.object_count++;
        /* the last object has two at least */
        const uint16_t count = (uint16_t)(left <= 65535 ? left : left - 65535 < 2 ? 65533 : 65535);
        left -= count;
        assert_true(i < MOST_OBJECTS);
        c->mesh[i] = c->b.mesh;
        c->mesh[i].triangle_count = count;
        c->mesh[i].triangles = (const uint16_t(*)[3])no_area;
        c->objects[i] = c->b.object;
        c->objects[i].mesh = &c->mesh[i];
        if (left == 0) {
            memset(last, 0, sizeof last);
            memcpy(last[count - 2], c->b.triangles, sizeof c->b.triangles);
            c->mesh[i].triangles = (const uint16_t(*)[3])last;
        }
    }
    c->b.scene.objects = c->objects;
}

static const uint32_t counts[] = {2, 3, 40000, MOST_SORTED - 1, MOST_SORTED, MOST_SORTED + 1, 65536, 65537, 131072};
#define COUNTS (sizeof counts / sizeof *counts)

static void test_lists_up_to_65534_triangles(void **state)
{
    static crowd c;
    (void)state;
    for (size_t n = 0; n < COUNTS; n++) {
        crowd_set_up(&c, counts[n]);
        for (uint16_t band_px = 0; band_px <= BOARD_PX; band_px++) {
            const glint_display display = {.width_px = BOARD_PX, .height_px = BOARD_PX, .band_px = band_px};
            const uint32_t bands = band_px == 0 ? 1 : (BOARD_PX + band_px - 1u) / band_px;
            const size_t lists = bands > 1 && counts[n] <= MOST_SORTED ? (counts[n] + bands + 1) / 2 * 4 : 0;
            const size_t vertices = (size_t)c.b.scene.object_count * 4 * VERTEX_BYTES;
            for (int which = 0; which < BACKENDS; which++) {
                const size_t least = backends[which].memory_least_bytes(&c.b.scene, &display);
                assert_int_equal(backends[which].memory_bytes(&c.b.scene, &display), least + lists + vertices);
            }
        }
    }
}

/* What is drawn does not depend on whether there are lists. */
static void test_more_triangles_than_lists_hold(void **state)
{
    static crowd c;
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        frame first = {.bytes = 0};
        for (size_t n = 0; n < COUNTS; n++) {
            frame f = {.display = {.width_px = BOARD_PX, .height_px = BOARD_PX, .band_px = BAND_PX}};
            crowd_set_up(&c, counts[n]);
            assert_int_equal(frame_draw(&f, &c.b.scene, which), 0);
            assert_int_equal(f.report.triangles, counts[n]);
            assert_int_equal(f.report.triangles_drawn, 2);
            assert_int_equal(f.report.triangles_empty, counts[n] - 2);
            assert_int_equal(f.report.pixels_shaded, BOARD_PX * BOARD_PX);
            assert_int_equal(f.report.memory_used_bytes, f.memory_given);
            if (n == 0) {
                first = f;
            } else {
                assert_memory_equal(f.pixels, first.pixels, first.bytes);
                frame_free(&f);
            }
        }
        frame_free(&first);
    }
}

static void test_the_longest_stride(void **state)
{
    board b;
    (void)state;
    board_set_up(&b);
    b.material.diffuse = board_grey(15000);
    for (int which = 0; which < BACKENDS; which++) {
        frame plain = {.display = {.width_px = BOARD_PX, .height_px = BOARD_PX, .band_px = BAND_PX}};
        frame wide = plain, wider = plain;
        const size_t without = backends[which].memory_least_bytes(&b.scene, &plain.display);
        const size_t row = (size_t)BOARD_PX * 3;
        assert_int_equal(frame_draw(&plain, &b.scene, which), 0);
        wide.display.stride_bytes = LONGEST_STRIDE;
        assert_int_equal(frame_draw(&wide, &b.scene, which), 0);
        assert_memory_equal(wide.pixels, plain.pixels, plain.bytes);
        /* a band of 4 rows is a multiple of 4 bytes with either stride */
        assert_int_equal(backends[which].memory_least_bytes(&b.scene, &wide.display) - without,
                         BAND_PX * (LONGEST_STRIDE - row));
        wider.display.stride_bytes = LONGEST_STRIDE + 1;
        assert_int_equal(backends[which].memory_bytes(&b.scene, &wider.display), 0);
        assert_int_equal(backends[which].memory_least_bytes(&b.scene, &wider.display), 0);
        wider.memory_bytes = 64;
        assert_int_equal(frame_draw(&wider, &b.scene, which), GLINT_ERROR_DISPLAY_STRIDE);
        assert_int_equal(wider.bands_seen, 0);
        frame_free(&plain);
        frame_free(&wide);
        frame_free(&wider);
    }
}

/* An extended source takes as much as the points that may stand for it; a mirror is paid for where there is one. */
static void test_extents_and_mirrors(void **state)
{
    static const uint8_t samples[] = {1, 4, 5, 0, 16, 28, 29, 64};
    static const uint8_t points[] = {1, 1, 5, 13, 13, 13, 29, 53};
    static const uint16_t texels[64];
    static const glint_environment around = {.texels = texels, .side = 8};
    const glint_display display = {.width_px = BOARD_PX, .height_px = BOARD_PX};
    board b;
    (void)state;
    board_set_up(&b);
    b.scene.light_count = 2;
    b.light[1] = b.light[0];
    for (int which = 0; which < BACKENDS; which++) {
        size_t (*const bytes)(const glint_scene *, const glint_display *) = backends[which].memory_least_bytes;
        b.light[1].kind = GLINT_POINT;
        b.light[1].attenuation.range_q16 = 0;
        const size_t two = bytes(&b.scene, &display);
        b.scene.light_count = 1;
        const size_t a_light = two - bytes(&b.scene, &display);
        b.scene.light_count = 2;
        b.light[1].attenuation.range_q16 = 1 << 20;
        const size_t a_reach = bytes(&b.scene, &display) - two;
        assert_true(a_light > 0 && a_light <= GLINT_LIGHT_BYTES && a_reach > 0 && a_reach <= GLINT_REACH_BYTES);
        b.light[1].kind = GLINT_BALL;
        b.light[1].radius_q16 = 1 << 16;
        for (size_t i = 0; i < sizeof samples; i++) {
            b.light[1].samples = samples[i];
            b.light[1].attenuation.range_q16 = 0;
            assert_int_equal(bytes(&b.scene, &display), two + (points[i] - 1u) * a_light);
            b.light[1].attenuation.range_q16 = 1 << 20;
            assert_int_equal(bytes(&b.scene, &display), two + (points[i] - 1u) * a_light + points[i] * a_reach);
        }
        b.light[1].radius_q16 = 0;
        assert_int_equal(bytes(&b.scene, &display), two + a_reach);
        b.scene.environment = &around;
        assert_int_equal(bytes(&b.scene, &display), two + a_reach);
        b.material.mirror.r_q14 = 1;
        const size_t a_mirror = bytes(&b.scene, &display) - two - a_reach;
        assert_true(a_mirror > 0 && a_mirror <= GLINT_MIRROR_BYTES);
        b.material.mirror.r_q14 = 0;
    }
}

/* A texture takes memory once, however many objects have one. */
static void test_textures(void **state)
{
    static const uint16_t texel[1] = {0x8410};
    static const int16_t texcoords[4][2] = {{0, 0}, {512, 0}, {512, 512}, {0, 512}};
    static const glint_texture texture = {.texels = texel, .width_px = 1, .height_px = 1};
    const glint_display display = {.width_px = BOARD_PX, .height_px = BOARD_PX};
    board b;
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        board_set_up(&b);
        const glint_object objects[2] = {b.object, b.object};
        b.mesh.texcoords = texcoords; /* by themselves nothing */
        b.mesh.texcoord_bits = 9;
        b.scene.objects = objects;
        b.scene.object_count = 2;
        const size_t without = backends[which].memory_least_bytes(&b.scene, &display);
        b.material.texture = &texture;
        const size_t with = backends[which].memory_least_bytes(&b.scene, &display);
        assert_in_range(with - without, 4, 4 * GLINT_TEXTURE_WORDS);
        b.scene.object_count = 1;
        const size_t one = backends[which].memory_least_bytes(&b.scene, &display);
        b.material.texture = NULL;
        assert_int_equal(one - backends[which].memory_least_bytes(&b.scene, &display), with - without);
    }
}

static unsigned words_wrong;

/* GLINT_MEMORY_WORDS is never too little, and not much too much. */
static void expect_words_bound(const demo_scene *demo, const glint_display *d)
{
    const glint_scene *const scene = demo->scene;
    uint32_t vertices = 0, triangles = 0, lights = 0, reaches = 0, mirrors = 0, casting = 0;
    bool textured = false;
    for (uint16_t i = 0; i < scene->object_count; i++) {
        vertices += scene->objects[i].mesh->vertex_count;
        const glint_material *material = scene->objects[i].material;
        const bool twice = material->transmission_q14 != 0 && material->sides != GLINT_FRONT_SIDE;
        triangles += scene->objects[i].mesh->triangle_count * (twice ? 2u : 1u);
        mirrors += material->mirror.r_q14 != 0;
        textured = textured || material->texture != NULL;
    }
    for (uint16_t i = 0; i < scene->light_count; i++) {
        const glint_light *light = &scene->lights[i];
        const glint_attenuation *a = &light->attenuation;
        casting += light->casts_shadows;
        const uint32_t points = light->kind < GLINT_PANEL ? 1 : light->samples ? light->samples : 16;
        lights += points;
        if (light->kind == GLINT_SPOT || a->range_q16 != 0 || (a->k_q14[0] | a->k_q14[1] | a->k_q14[2]) != 0) {
            reaches += points;
        }
    }
    const size_t bound =
        (size_t)4 * (GLINT_MEMORY_WORDS(d->width_px, d->height_px, d->band_px, d->format, d->buffer_count, vertices,
                                        triangles, scene->object_count, lights) +
                     scene->object_count * reaches * GLINT_REACH_WORDS + mirrors * GLINT_MIRROR_WORDS +
                     (textured ? GLINT_TEXTURE_WORDS : 0) +
                     (casting == 0 ? 0
                                   : GLINT_SHADOW_WORDS(d->width_px, d->band_px, vertices, triangles,
                                                        scene->object_count, lights, casting)));
    const double more = WORDS_A_LIGHT * lights * scene->object_count;
    for (int b = 0; b < BACKENDS; b++) {
        const size_t bytes = backends[b].memory_bytes(scene, d);
        if (bytes == 0 || bytes > bound || (double)bound > WORDS_FACTOR * (double)bytes + WORDS_MORE + more) {
            printf("%s, %s: %zu bytes, GLINT_MEMORY_WORDS gives %zu (%u objects, %u lights, format %u, band %u)\n",
                   demo->name, backends[b].name, bytes, bound, scene->object_count, scene->light_count, d->format,
                   d->band_px);
            words_wrong++;
        }
    }
}

static void test_memory_words_bound_the_bytes(void **state)
{
    (void)state;
    static const uint16_t bands[] = {8, 16, 104, 240, 2048};
    static glint_transfers transfers;
    words_wrong = 0;
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        for (uint8_t format = GLINT_RGB888; format <= (uint8_t)GLINT_MONO_PAGES; format++) {
            for (size_t k = 0; k < 2 * sizeof bands / sizeof *bands; k++) {
                glint_display d = {.width_px = k % 3 ? 239 : 240,
                                   .height_px = k % 4 ? 240 : 235,
                                   .band_px = bands[k / 2],
                                   .format = format,
                                   .buffer_count = (uint8_t)(1 + k % 2),
                                   .transfers = &transfers};
                d.band_px = d.band_px > d.height_px ? d.height_px : d.band_px;
                expect_words_bound(&demo_scenes[i], &d);
            }
        }
    }
    assert_int_equal(words_wrong, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lists_up_to_65534_triangles),
        cmocka_unit_test(test_more_triangles_than_lists_hold),
        cmocka_unit_test(test_the_longest_stride),
        cmocka_unit_test(test_extents_and_mirrors),
        cmocka_unit_test(test_textures),
        cmocka_unit_test(test_memory_words_bound_the_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
