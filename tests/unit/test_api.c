/* SPDX-License-Identifier: MIT */
/*
 * What one call promises as a whole: the same picture for any band height, memory and number of buffers; a report that
 * adds up; calls inside calls and beside calls; scenes with nothing to see; the eye inside objects.
 *
 * Budgets for the eye among triangles, against the double-precision reference (tests/reference/reference.h):
 */
#define PLAIN_CODES 1.0 /* greatest |code - 255 L| of a plain pixel, the rounding to a code (0.5) included */
#define UNMATCHED 0     /* contested pixels that agree with none of their candidates */

#include "tests/unit/backends.h"
#include "tests/unit/board.h"

#include <pthread.h>
#include <stdio.h>

#include "examples/meshes/meshes.h"
#include "examples/scenes/scenes.h"
#include "tests/reference/reference.h"

static frame frame_of(uint16_t width_px, uint16_t height_px)
{
    const frame f = {.display = {.width_px = width_px, .height_px = height_px}};
    return f;
}

static uint32_t vertices_of(const glint_scene *scene)
{
    uint32_t count = 0;
    for (uint16_t i = 0; i < scene->object_count; i++) {
        count += scene->objects[i].mesh->vertex_count;
    }
    return count;
}

static uint32_t triangles_of(const glint_scene *scene)
{
    uint32_t count = 0;
    for (uint16_t i = 0; i < scene->object_count; i++) {
        count += scene->objects[i].mesh->triangle_count;
    }
    return count;
}

/* The eye between the room's objects: triangles cross the near plane and the picture's edges. */
static void set_close_room(glint_scene *scene, glint_camera *camera)
{
    *camera = *demo_room.camera;
    for (int k = 0; k < 3; k++) {
        camera->eye_q16[k] = camera->eye_q16[k] / 16 + camera->target_q16[k] / 16 * 15;
    }
    camera->near_q16 = 6554;
    *scene = demo_room;
    scene->camera = camera;
}

static void expect_consistent(const frame *f, const glint_scene *scene)
{
    const glint_report *const r = &f->report;
    const uint32_t pixels = (uint32_t)f->display.width_px * f->display.height_px;
    const uint16_t band = f->display.band_px;
    const bool whole = band == 0 || band > f->display.height_px;
    assert_int_equal(r->triangles, triangles_of(scene));
    assert_int_equal(r->triangles, r->triangles_drawn + r->triangles_facing_away + r->triangles_outside +
                                       r->triangles_empty + r->triangles_refused);
    assert_int_equal(r->triangles_refused, 0);
    assert_true(r->triangles_clipped <= r->triangles_drawn);
    assert_true(r->pixels_specular <= r->pixels_shaded);
    assert_true(r->pixels_shaded <= pixels * r->triangles_drawn);
    assert_int_equal(r->bands, whole ? 1 : (f->display.height_px + band - 1) / band);
    assert_int_equal(r->bands, f->bands_seen);
    assert_true(r->memory_used_bytes <= f->memory_given);
}

/* All band heights, each with the least, a middling and the full memory and with one and two buffers. */
static void test_same_picture_for_bands_memory_and_buffers(void **state)
{
    (void)state;
    glint_scene close;
    glint_camera camera;
    set_close_room(&close, &camera);
    const glint_scene *const scenes[] = {&demo_room, &close, &demo_point_light};
    for (int n = 0; n < 3 * BACKENDS * 3; n++) {
        const glint_scene *const scene = scenes[n % 3];
        const int which = n / 3 % 2;
        frame whole = frame_of(40, 31);
        whole.shading = (uint8_t)(n / 6);
        assert_int_equal(frame_draw(&whole, scene, which), 0);
        expect_consistent(&whole, scene);
        assert_int_equal(whole.report.vertices_transformed, vertices_of(scene));
        assert_true(scene != &close || whole.report.triangles_clipped > 0);
        for (uint16_t band_px = 1; band_px <= 32; band_px++) {
            frame f = frame_of(40, 31);
            f.shading = whole.shading;
            f.display.band_px = band_px;
            f.display.buffer_count = (uint8_t)(band_px % 3); /* 0, 1 or 2 */
            f.display.transfers = &f.transfers;
            const size_t least = backends[which].memory_least_bytes(scene, &f.display);
            const size_t full = backends[which].memory_bytes(scene, &f.display);
            const size_t memory[] = {full, full - 4, (least + 3 * full) / 4, (3 * least + full) / 4, least};
            uint32_t transformed = 0;
            for (int m = 0; m < 5; m++) {
                f.memory_bytes = memory[m];
                assert_int_equal(frame_draw(&f, scene, which), 0);
                assert_memory_equal(f.pixels, whole.pixels, whole.bytes);
                expect_consistent(&f, scene);
                assert_int_equal(f.report.triangles_drawn, whole.report.triangles_drawn);
                assert_int_equal(f.report.triangles_clipped, whole.report.triangles_clipped);
                assert_int_equal(f.report.pixels_shaded, whole.report.pixels_shaded);
                assert_int_equal(f.report.pixels_specular, whole.report.pixels_specular);
                if (m == 0) {
                    assert_int_equal(f.report.vertices_transformed, vertices_of(scene));
                    assert_int_equal(f.report.memory_used_bytes, full);
                } else if (m == 4) {
                    assert_true(f.report.vertices_transformed > vertices_of(scene));
                    assert_int_equal(f.report.memory_used_bytes, least);
                }
                assert_true(f.report.vertices_transformed >= transformed); /* grows as the memory shrinks */
                transformed = m == 0 ? f.report.vertices_transformed : transformed;
                frame_free(&f);
            }
        }
        frame_free(&whole);
    }
}

static int copy_flush(void *context, const glint_band *band)
{
    memcpy((uint8_t *)context + (size_t)band->y_px * band->stride_bytes, band->pixels, band->bytes);
    return 0;
}

/* A quality of zeros, no report, and more memory than can be used: what is not used keeps its bytes. */
static void test_memory_that_is_not_used_stays(void **state)
{
    (void)state;
    for (int which = 0; which < BACKENDS; which++) {
        frame expected = frame_of(48, 48);
        assert_int_equal(frame_draw(&expected, &demo_room, which), 0);
        const glint_quality quality = {0};
        static uint8_t picture[48 * 48 * 3];
        const glint_display display = {
            .width_px = 48, .height_px = 48, .band_px = 10, .flush = copy_flush, .context = picture};
        const size_t full = backends[which].memory_bytes(&demo_room, &display);
        const size_t least = backends[which].memory_least_bytes(&demo_room, &display);
        uint8_t *const memory = malloc(2 * full);
        assert_non_null(memory);
        for (size_t bytes = least; bytes <= 2 * full; bytes += full / 37) {
            glint_report report;
            memset(memory, FRAME_CANARY_BYTE, 2 * full);
            memset(picture, 0, sizeof picture);
            assert_int_equal(backends[which].render(&demo_room, &display, &quality, memory, bytes, &report), 0);
            assert_memory_equal(picture, expected.pixels, sizeof picture);
            assert_true(report.memory_used_bytes <= bytes);
            for (size_t i = report.memory_used_bytes; i < 2 * full; i++) {
                assert_int_equal(memory[i], FRAME_CANARY_BYTE);
            }
            /* without a report, into memory that holds what the last frame left */
            memset(picture, 0, sizeof picture);
            assert_int_equal(backends[which].render(&demo_room, &display, &quality, memory, bytes, NULL), 0);
            assert_memory_equal(picture, expected.pixels, sizeof picture);
        }
        free(memory);
        frame_free(&expected);
    }
}

/* A frame that draws another one, of the other backend, in each flush. */
typedef struct nested {
    frame outer;
    const frame *inner_expected;
    int inner_backend;
    unsigned drawn;
} nested;

static int nested_flush(void *context, const glint_band *band)
{
    nested *n = context;
    frame inner = frame_of(30, 20);
    inner.display.band_px = 7;
    assert_int_equal(frame_draw(&inner, &demo_three_lights, n->inner_backend), 0);
    assert_memory_equal(inner.pixels, n->inner_expected->pixels, inner.bytes);
    assert_memory_equal(&inner.report, &n->inner_expected->report, sizeof inner.report);
    frame_free(&inner);
    n->drawn++;
    return frame_flush(&n->outer, band);
}

static void test_a_frame_within_a_flush(void **state)
{
    (void)state;
    for (int c = 0; c < BACKENDS * BACKENDS; c++) {
        const int which = c / 2;
        nested n = {.outer = frame_of(40, 40), .inner_backend = c % 2};
        frame inner = frame_of(30, 20), separate = frame_of(40, 40);
        inner.display.band_px = 7;
        separate.display.band_px = 9;
        assert_int_equal(frame_draw(&inner, &demo_three_lights, n.inner_backend), 0);
        assert_int_equal(frame_draw(&separate, &demo_room, which), 0);
        n.inner_expected = &inner;
        n.outer.row_bytes = separate.row_bytes;
        n.outer.bytes = separate.bytes;
        n.outer.pixels = malloc(separate.bytes);
        assert_non_null(n.outer.pixels);
        glint_display display = separate.display;
        display.flush = nested_flush;
        display.context = &n;
        const glint_quality quality = {.shading = GLINT_SHADING_EXACT};
        const size_t bytes = backends[which].memory_bytes(&demo_room, &display);
        void *const memory = malloc(bytes);
        assert_non_null(memory);
        assert_int_equal(backends[which].render(&demo_room, &display, &quality, memory, bytes, &n.outer.report), 0);
        assert_memory_equal(n.outer.pixels, separate.pixels, separate.bytes);
        assert_memory_equal(&n.outer.report, &separate.report, sizeof separate.report);
        assert_int_equal(n.drawn, 5);
        free(memory);
        frame_free(&n.outer);
        frame_free(&inner);
        frame_free(&separate);
    }
}

#define ROUNDS 12

typedef struct worker {
    const glint_scene *scene;
    int which;
    frame expected;
    unsigned differing; /* cmocka's assertions belong to the main thread */
} worker;

static void *work(void *context)
{
    worker *w = context;
    const glint_quality quality = {.shading = GLINT_SHADING_EXACT};
    uint8_t *const picture = malloc(w->expected.bytes);
    const glint_display display = {
        .width_px = 64, .height_px = 64, .band_px = 5, .flush = copy_flush, .context = picture};
    const size_t bytes = backends[w->which].memory_bytes(w->scene, &display);
    void *const memory = malloc(bytes);
    for (int i = 0; i < ROUNDS; i++) {
        const bool same = picture && memory &&
                          backends[w->which].render(w->scene, &display, &quality, memory, bytes, NULL) == 0 &&
                          memcmp(picture, w->expected.pixels, w->expected.bytes) == 0;
        w->differing += !same;
    }
    free(memory);
    free(picture);
    return NULL;
}

static void test_frames_in_two_threads(void **state)
{
    (void)state;
    for (int c = 0; c < BACKENDS * BACKENDS; c++) {
        worker workers[2] = {{.scene = &demo_room, .which = c / 2}, {.scene = &demo_point_light, .which = c % 2}};
        pthread_t thread[2];
        for (int i = 0; i < 2; i++) {
            workers[i].expected = frame_of(64, 64);
            assert_int_equal(frame_draw(&workers[i].expected, workers[i].scene, workers[i].which), 0);
        }
        for (int i = 0; i < 2; i++) {
            assert_int_equal(pthread_create(&thread[i], NULL, work, &workers[i]), 0);
        }
        for (int i = 0; i < 2; i++) {
            assert_int_equal(pthread_join(thread[i], NULL), 0);
            assert_int_equal(workers[i].differing, 0);
            frame_free(&workers[i].expected);
        }
    }
}

static void expect_background(const glint_scene *scene, int which, glint_report *report)
{
    frame f = frame_of(25, 19);
    f.display.band_px = 4;
    assert_int_equal(frame_draw(&f, scene, which), 0);
    for (int i = 0; i < 25 * 19; i++) {
        static const uint8_t background[3] = {51, 102, 204};
        assert_memory_equal(f.pixels + 3 * i, background, 3);
    }
    assert_int_equal(f.report.pixels_shaded, 0);
    assert_int_equal(f.report.triangles_drawn, 0);
    expect_consistent(&f, scene);
    *report = f.report;
    frame_free(&f);
}

static void test_scenes_with_nothing_to_see(void **state)
{
    (void)state;
    static const glint_colour background = GLINT_RGB(51, 102, 204);
    for (int which = 0; which < BACKENDS; which++) {
        glint_report report;
        board b;
        board_set_up(&b);
        b.scene.background = background;
        b.material.ambient = b.material.diffuse = b.scene.ambient = board_grey(16384);
        glint_scene empty = {.camera = &b.camera, .background = background};
        expect_background(&empty, which, &report);
        assert_int_equal(report.vertices_transformed, 0);
        /* behind the eye, face towards it */
        b.object.place = glint_turn_y(32768);
        b.object.place.origin_q16[2] = BOARD_Q16(9);
        expect_background(&b.scene, which, &report);
        assert_int_equal(report.triangles_outside, 2);
        /* before the eye, but before the near plane as well */
        b.object.place = glint_shift(0, 0, BOARD_Q16(4.001));
        expect_background(&b.scene, which, &report);
        assert_int_equal(report.triangles_outside, 2);
        /* beyond each edge of the picture */
        for (int edge = 0; edge < 4; edge++) {
            const int32_t away = (edge % 2 ? 1 : -1) * BOARD_Q16(30);
            b.object.place = glint_shift(edge / 2 ? away : 0, edge / 2 ? 0 : away, 0);
            expect_background(&b.scene, which, &report);
            assert_int_equal(report.triangles_outside, 2);
        }
        /* its back to the eye */
        b.object.place = glint_turn_y(32768);
        expect_background(&b.scene, which, &report);
        assert_int_equal(report.triangles_facing_away, 2);
        /* its edge to the eye */
        b.object.place = glint_turn_y(16384);
        expect_background(&b.scene, which, &report);
        assert_int_equal(report.triangles_drawn, 0);
        /* smaller than the sub-pixel grid */
        b.object.place = glint_scale(1, 1, 1);
        expect_background(&b.scene, which, &report);
        assert_int_equal(report.triangles_empty, 2);
    }
}

/* Draws with both backends and compares with the reference, contested pixels by their candidates. */
static uint32_t expect_reference(const glint_scene *scene, const char *name)
{
    reference_image image;
    reference_verdict verdict;
    uint32_t shaded = 0;
    char error[200] = "";
    if (reference_render(scene, 96, 72, GLINT_SHADING_EXACT, &image, error, sizeof error) != 0) {
        fail_msg("%s: %s", name, error);
    }
    for (int which = 0; which < BACKENDS; which++) {
        frame f = frame_of(96, 72);
        f.display.band_px = 11;
        assert_int_equal(frame_draw(&f, scene, which), 0);
        expect_consistent(&f, scene);
        reference_check(&image, f.pixels, PLAIN_CODES, &verdict);
        printf("%-24s %s: max=%.3f above=%u contested=%.2f%% unmatched=%u clipped=%u\n", name, backends[which].name,
               verdict.max_codes, verdict.above, 100 * verdict.contested_share, verdict.unmatched,
               f.report.triangles_clipped);
        if (verdict.max_codes > PLAIN_CODES || verdict.unmatched > UNMATCHED) {
            fail_msg("%s, %s: %.3f codes at %d %d; %u unmatched, the first at %d %d", name, backends[which].name,
                     verdict.max_codes, verdict.worst_x, verdict.worst_y, verdict.unmatched, verdict.unmatched_x,
                     verdict.unmatched_y);
        }
        shaded += f.report.pixels_shaded;
        frame_free(&f);
    }
    reference_free(&image);
    return shaded;
}

/* The eye inside a closed mesh sees none of it; halfway out, the near plane cuts it. */
static void test_the_eye_inside_an_object(void **state)
{
    (void)state;
    board b;
    board_set_up(&b);
    b.material.ambient = board_grey(3000);
    b.material.diffuse = board_grey(9000);
    b.material.specular = board_grey(5000);
    b.material.exponent_q4 = 20 * 16;
    b.scene.ambient = board_grey(16384);
    b.scene.background = board_grey(2000);
    b.camera.near_q16 = BOARD_Q16(0.05);
    b.object.mesh = &glint_mesh_sphere_32x16;
    board_light(&b, 0, 3, -5, -4);
    b.object.place = glint_shift(0, 0, BOARD_Q16(5));
    assert_int_equal(expect_reference(&b.scene, "inside a sphere"), 0);
    b.object.place = glint_shift(BOARD_Q16(0.3), BOARD_Q16(0.2), BOARD_Q16(4.02));
    assert_true(expect_reference(&b.scene, "at a sphere's face") > 0);
    b.object.mesh = &glint_mesh_torus_knot;
    for (int step = -4; step <= 4; step++) {
        char name[40];
        (void)snprintf(name, sizeof name, "within the knot, %d", step);
        b.object.place = glint_shift(BOARD_Q16(0.37) * step, BOARD_Q16(0.11) * step, BOARD_Q16(4.6));
        (void)expect_reference(&b.scene, name);
    }
    glint_scene close;
    glint_camera camera;
    set_close_room(&close, &camera);
    assert_true(expect_reference(&close, "among the room's objects") > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_same_picture_for_bands_memory_and_buffers),
        cmocka_unit_test(test_memory_that_is_not_used_stays),
        cmocka_unit_test(test_a_frame_within_a_flush),
        cmocka_unit_test(test_frames_in_two_threads),
        cmocka_unit_test(test_scenes_with_nothing_to_see),
        cmocka_unit_test(test_the_eye_inside_an_object),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
