/* SPDX-License-Identifier: MIT */
/*
 * Coverage against the reference's exact one, on the library's own snapped vertices: each triangle's spans hold just
 * the pixels that the fill rule gives, and the frame shows something just where one of them is.
 *
 * A test file includes the backend's source, for its static functions, and then this.
 */
#include "tests/image/frame.h"

#include <stdio.h>

#include "examples/scenes/scenes.h"
#include "tests/reference/reference.h"

#define MOST_PIXELS (320 * 240)
#define MOST_OBJECTS 64

static uint8_t expected[MOST_PIXELS], spanned[MOST_PIXELS];
static int frame_width;
static unsigned triangles_seen, clipped_seen;

static void mark_expected(void *context, int x, int y)
{
    uint8_t *triangle = context;
    expected[y * frame_width + x] = 1;
    triangle[y * frame_width + x] = 1;
}

static void check_triangle(const frame_state *state, const object_state *object,
                           const glint_screen_vertex *const screen[3])
{
    static uint8_t triangle[MOST_PIXELS];
    const int width = state->view.width_px, height = state->view.height_px;
    snapped s;
    if (triangle_snap(state, object, screen, &s) != TRIANGLE_DRAWN) {
        return;
    }
    const int32_t corners[3][2] = {
        {s.corner[0].x, s.corner[0].y}, {s.corner[1].x, s.corner[1].y}, {s.corner[2].x, s.corner[2].y}};
    memset(triangle, 0, (size_t)width * (size_t)height);
    memset(spanned, 0, (size_t)width * (size_t)height);
    assert_true(reference_cover(corners, width, height, mark_expected, triangle) >= 0);

    glint_edges edges;
    glint_spans spans;
    int16_t y, first, last;
    glint_edges_set_up(&edges, s.corner, s.clockwise, s.box);
    glint_spans_begin(&spans, &edges, s.box.y_first, s.box.y_last);
    while (glint_spans_next(&spans, &y, &first, &last)) {
        for (int16_t x = first; x <= last; x++) {
            spanned[y * width + x] = 1;
        }
    }
    assert_memory_equal(spanned, triangle, (size_t)width * (size_t)height);
    triangles_seen++;
}

static void check_object(frame_state *state, const object_state *object)
{
    for (uint16_t t = 0; t < object->mesh->triangle_count; t++) {
        triangle_corners corners;
        corner polygon[CLIP_MOST];
        triangle_extent extent = {.clipped = false};
        real attribute[3][3] = {{0}};
        const enum triangle_fate drawn = do_triangle(state, object, t, false, &extent);
        if (drawn != TRIANGLE_DRAWN && drawn != TRIANGLE_OTHER_PASS) {
            continue;
        }
        triangle_fetch(state, object, t, &corners);
        if (!extent.clipped) {
            check_triangle(state, object, corners.screen);
            continue;
        }
        const int count = clip_triangle(object, &state->view, corners.vertex, attribute, polygon);
        clipped_seen++;
        for (int i = 2; i < count; i++) {
            const glint_screen_vertex *const fan[3] = {&polygon[0].screen, &polygon[i - 1].screen, &polygon[i].screen};
            check_triangle(state, object, fan);
        }
    }
}

/* The same shapes, all white in ambient light, on black: what is not black is covered. */
static void check_frame(const glint_scene *source, uint16_t width, uint16_t height, int backend)
{
    static glint_material white[MOST_OBJECTS];
    static const glint_fog clear = {.end_q16 = 0};
    static const glint_colour full = GLINT_WHITE, none = GLINT_BLACK;
    glint_object objects[MOST_OBJECTS];
    glint_scene scene = *source;
    assert_true(scene.object_count <= MOST_OBJECTS);
    for (uint16_t i = 0; i < scene.object_count; i++) {
        objects[i] = source->objects[i];
        white[i].ambient = full;
        white[i].sides = source->objects[i].material->sides;
        objects[i].material = &white[i];
    }
    scene.objects = objects;
    scene.light_count = 0;
    scene.ambient = full;
    scene.background = none;
    scene.fog = clear;
    frame f = {.display = {.width_px = width, .height_px = height, .format = GLINT_GREY8}};
    assert_int_equal(frame_draw(&f, &scene, backend), 0);
    for (int i = 0; i < width * height; i++) {
        assert_int_equal(f.pixels[i], expected[i] ? 255 : 0);
    }
    frame_free(&f);
}

static void check_scene(const glint_scene *scene, uint16_t width, uint16_t height, int backend)
{
    frame_state state;
    static shade_state shade;
    object_state *objects = calloc(scene->object_count, sizeof *objects);
    const glint_display display = {.width_px = width, .height_px = height};
    glint_needs needs;
    memory_needs(&needs, scene, &display);
    light_state *lights = calloc((size_t)scene->object_count * needs.light_count + 1, sizeof *lights);
    light_reach *reaches = calloc((size_t)scene->object_count * needs.reach_count + 1, sizeof *reaches);
    light_mirror *mirrors = calloc((size_t)scene->object_count + 1, sizeof *mirrors);
    assert_non_null(objects);
    assert_non_null(mirrors);
    assert_non_null(lights);
    assert_non_null(reaches);
    assert_true(width * height <= MOST_PIXELS);
    memset(&state, 0, sizeof state);
    memset(expected, 0, sizeof expected);
    frame_width = width;
    glint_view_set_up(&state.view, scene->camera, width, height);
    state.objects = objects;
    state.shade = &shade;
    state.object_count = scene->object_count;
    prepare_objects(&state, scene, objects, lights, reaches, mirrors, &needs, NULL, NULL, false);
    for (uint16_t i = 0; i < scene->object_count; i++) {
        check_object(&state, &objects[i]);
    }
    check_frame(scene, width, height, backend);
    free(lights);
    free(reaches);
    free(mirrors);
    free(objects);
}

static void check_all(int backend)
{
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        check_scene(demo_scenes[i].scene, demo_scenes[i].width_px, demo_scenes[i].height_px, backend);
    }
    printf("%u triangles\n", triangles_seen);
    assert_true(triangles_seen > 5000);
}

/* From the eye towards the target, into and through the objects: near plane and guard band cut. */
static void check_close(int backend)
{
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        for (int step = 1; step <= 8; step++) {
            glint_scene scene = *demo_scenes[i].scene;
            glint_camera camera = *scene.camera;
            for (int k = 0; k < 3; k++) {
                camera.eye_q16[k] += (camera.target_q16[k] - camera.eye_q16[k]) / 9 * step + 77;
            }
            camera.near_q16 = 1 << (10 + step);
            scene.camera = &camera;
            check_scene(&scene, 120, 90, backend);
        }
    }
    printf("%u clipped\n", clipped_seen);
    assert_true(clipped_seen > 100);
}
