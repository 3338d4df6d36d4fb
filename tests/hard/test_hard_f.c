/* SPDX-License-Identifier: MIT */
/*
 * Hard cases F: the near plane, clipping and depth. docs/hard-cases.md has the defined behaviour; hard.h the form of a
 * test.
 *
 * Budgets: those of hard.h. Coverage and the choice between surfaces are exact.
 */
#include "examples/scenes/scenes.h"
#include "tests/hard/hard.h"

#define WIDE 64
#define HIGH 48

/* Three or four corners before an eye at the origin that looks along -z, 90 degrees, near distance 1; diffuse white
 * under a light from the eye, ambient so that nothing drawn is black. Positions in 1/1024. */
static void open_world(board *b)
{
    board_set_up(b);
    b->camera.eye_q16[2] = 0;
    b->camera.target_q16[2] = -65536;
    b->material.ambient = b->scene.ambient = board_grey(8192);
    b->material.diffuse = board_grey(12000);
}

static void set_corner(board *b, int i, double x, double y, double distance)
{
    b->positions[i][0] = (int16_t)lround(x * BOARD_UNIT);
    b->positions[i][1] = (int16_t)lround(y * BOARD_UNIT);
    b->positions[i][2] = (int16_t)lround(-distance * BOARD_UNIT);
    b->normals[i][2] = 16384;
}

/* A floor a unit below the eye, from `behind` to `before` it. */
static void set_floor(board *b, double behind, double before)
{
    set_corner(b, 0, -20, -1, behind);
    set_corner(b, 1, 20, -1, behind);
    set_corner(b, 2, 20, -1, before);
    set_corner(b, 3, -20, -1, before);
    board_normals(b, 0, 16384, 0);
    board_light(b, 0, 1, -2, -1);
}

static frame world_draw(const board *b, int backend)
{
    return hard_draw(&b->scene, WIDE, HIGH, GLINT_RGB888, GLINT_SHADING_EXACT, backend);
}

static long lit_pixels(const frame *f)
{
    long count = 0;
    for (size_t i = 0; i < f->bytes; i += 3) {
        count += f->pixels[i] != 0;
    }
    return count;
}

/* Pixels that are not black, in both backends alike. */
static long drawn_pixels(const board *b)
{
    long count[FRAME_BACKENDS];
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame f = world_draw(b, backend);
        count[backend] = lit_pixels(&f);
        frame_free(&f);
    }
    assert_int_equal(count[0], count[1]);
    return count[0];
}

static void test_F1_w_to_zero(void **state)
{
    (void)state;
    const int64_t naive = (int64_t)24 * 65536 * 65536 * 256; /* focal 24 px, 1/w = 2^32 in Q16 at w = 2^-16, 1/256 px */
    assert_true(naive > INT32_MAX);
    double worst = 0;
    long clipped = 0;
    for (int32_t near_q16 = 64; near_q16 <= 65536; near_q16 *= 2) {
        for (int end = 0; end < 3; end++) {
            board b;
            open_world(&b);
            b.camera.near_q16 = near_q16;
            set_floor(&b,
                      end == 0   ? 0
                      : end == 1 ? 1 / 1024.0
                                 : -15,
                      20); /* w is 0 at an end, next to it, or passes it */
            worst = worse_of(worst, expect_reference(&b.scene, WIDE, HIGH, GLINT_SHADING_EXACT, "w to 0"));
            for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
                frame f = world_draw(&b, backend);
                clipped += (long)f.report.triangles_clipped;
                frame_free(&f);
            }
        }
    }
    assert_true(clipped > 20);
    hard_pass("F1", "w to 0 from above", text("a coordinate of %lld sub-pixels at w = 2^-16", (long long)naive),
              text("clipped at the near plane first: %ld triangles, within %.2f codes", clipped, worst));
}

static void test_F2_w_below_zero(void **state)
{
    (void)state;
    int naive = 0;
    double worst = 0;
    for (int round = 0; round < 400; round++) {
        board b;
        bool behind = true;
        open_world(&b);
        for (int i = 0; i < 4; i++) {
            const double distance = hard_between(-15000, round % 2 ? 0 : 9000) / 1000.0;
            const double x = hard_between(-9000, 9000) / 1000.0, y = hard_between(-9000, 9000) / 1000.0;
            set_corner(&b, i, x, y, distance);
            behind = behind && distance < 0.99;
            /* x / w and y / w of a point behind the eye, mirrored on the display */
            naive += distance < 0 && fabs(x / distance) < WIDE / (double)HIGH && fabs(y / distance) < 1;
        }
        if (behind) {
            assert_int_equal(drawn_pixels(&b), 0);
        } else {
            worst = worse_of(worst, expect_reference(&b.scene, WIDE, HIGH, GLINT_SHADING_EXACT, "partly behind"));
        }
    }
    assert_true(naive > 100);
    hard_pass("F2", "w < 0", text("%d of 1600 vertices are seen as ghosts from behind", naive),
              text("nothing drawn from behind, the rest within %.2f codes", worst));
}

static void test_F3_vertex_on_the_near_plane(void **state)
{
    (void)state;
    const volatile double on = 0;
    const double naive = on / (on - on); /* the crossing of an edge that lies in the plane */
    assert_true(isnan(naive));
    long drawn[27], tried = 0;
    double worst = 0;
    for (int code = 0; code < 27; code++) { /* each corner behind (0.5), on (1) or beyond (2) the plane */
        static const double distance[3] = {0.5, 1, 2};
        const int beyond = (code % 3 == 2) + (code / 3 % 3 == 2) + (code / 9 == 2);
        board b;
        open_world(&b);
        b.mesh.triangle_count = 1;
        set_corner(&b, 0, -0.4, -0.3, distance[code % 3]);
        set_corner(&b, 1, 0.45, -0.35, distance[code / 3 % 3]);
        set_corner(&b, 2, 0.1, 0.4, distance[code / 9]);
        if (code == 13) {
            continue; /* all on the plane: F4 */
        }
        drawn[code] = drawn_pixels(&b);
        assert_true(beyond > 0 ? drawn[code] > 0 : drawn[code] == 0);
        worst = worse_of(worst, expect_reference(&b.scene, WIDE, HIGH, GLINT_SHADING_EXACT, "on the plane"));
        tried++;
    }
    hard_pass(
        "F3", "vertex exactly on the near plane", text("the crossing of an edge in the plane is %s", "NaN"),
        text("counts as outside: %ld triangles with corners on it, within %.2f codes of the reference", tried, worst));
}

static void test_F5_clipped_quad_split_either_way(void **state)
{
    (void)state;
    /* colours 0, 255, 0, 255 around a quad: the middle is on one diagonal or on the other */
    const double naive = fabs((0 + 0) / 2.0 - (255 + 255) / 2.0);
    assert_true(naive > 250);
    long clipped = 0, frames = 0;
    double worst = 0;
    for (int round = 0; round < 60; round++) {
        board b;
        open_world(&b);
        b.mesh.triangle_count = 1;
        for (int i = 0; i < 3; i++) {
            set_corner(&b, i, hard_between(-6000, 6000) / 1000.0, hard_between(-6000, 6000) / 1000.0,
                       hard_between(i == 0 ? -9000 : 1000, i == 0 ? 500 : 9000) / 1000.0);
            b.normals[i][0] = (int16_t)hard_between(-16000, 16000);
        }
        for (int n = 0; n < FRAME_BACKENDS * (HARD_SHADINGS + 1); n++) {
            frame whole = {.display = {.width_px = WIDE, .height_px = HIGH},
                           .shading = (uint8_t)(n / FRAME_BACKENDS % HARD_SHADINGS),
                           .tolerance = n / FRAME_BACKENDS == HARD_SHADINGS ? GLINT_CODES(1) : 0};
            assert_int_equal(frame_draw(&whole, &b.scene, n % FRAME_BACKENDS), 0);
            clipped += (long)whole.report.triangles_clipped;
            for (uint16_t band = 1; band < HIGH; band = (uint16_t)(band + 3)) {
                frame f = {.display = whole.display, .shading = whole.shading, .tolerance = whole.tolerance};
                f.display.band_px = band;
                assert_int_equal(frame_draw(&f, &b.scene, n % FRAME_BACKENDS), 0);
                assert_memory_equal(f.pixels, whole.pixels, whole.bytes);
                frame_free(&f);
                frames++;
            }
            frame_free(&whole);
        }
        worst = worse_of(worst, expect_reference(&b.scene, WIDE, HIGH, GLINT_SHADING_EXACT, "clipped"));
        worst = worse_of(worst, expect_reference(&b.scene, WIDE, HIGH, GLINT_SHADING_GOURAUD, "clipped"));
    }
    assert_true(clipped > 60);
    hard_pass("F5", "clipped quad split either way", text("%.0f codes in the middle between the two ways", naive),
              text("a fan from the first corner: identical in %ld banded frames, within %.2f codes", frames, worst));
}

static void test_F6_two_triangles_clipped_along_a_shared_edge(void **state)
{
    (void)state;
    int naive = 0;
    for (int round = 0; round < 10000; round++) { /* the crossing, from one end and from the other */
        const float a = (float)hard_between(1, 99999) * 1e-4f, b = -(float)hard_between(1, 99999) * 1e-4f;
        const float x = (float)hard_between(-99999, 99999) * 1e-4f, y = (float)hard_between(-99999, 99999) * 1e-4f;
        const float there = x + (y - x) * (a / (a - b)), back = y + (x - y) * (b / (b - a));
        naive += there < back || there > back;
    }
    assert_true(naive > 1000);
    long pairs = 0, shared = 0;
    double worst = 0;
    for (int round = 0; round < 400; round++) {
        board b;
        open_world(&b);
        set_corner(&b, 0, hard_between(-3000, 3000) / 1000.0, hard_between(-3000, 3000) / 1000.0, 0.3);
        set_corner(&b, 2, hard_between(-9000, 9000) / 1000.0, hard_between(-9000, 9000) / 1000.0, 7);
        for (int i = 1; i < 4; i += 2) {
            set_corner(&b, i, hard_between(-9000, 9000) / 1000.0, hard_between(-9000, 9000) / 1000.0,
                       hard_between(-4000, 9000) / 1000.0);
        }
        worst = worse_of(worst, expect_reference(&b.scene, WIDE, HIGH, GLINT_SHADING_EXACT, "pair"));
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame both = world_draw(&b, backend);
            board one = b, other = b;
            one.object.mesh = &one.mesh;
            other.object.mesh = &other.mesh;
            one.scene.objects = &one.object;
            other.scene.objects = &other.object;
            one.mesh.triangle_count = other.mesh.triangle_count = 1;
            other.mesh.triangles++;
            frame f = world_draw(&one, backend), g = world_draw(&other, backend);
            pairs += both.report.triangles_clipped == 2;
            for (size_t i = 0; i < both.bytes; i += 3) {
                assert_false(f.pixels[i] != 0 && g.pixels[i] != 0); /* no pixel twice */
                assert_int_equal(both.pixels[i] != 0, f.pixels[i] != 0 || g.pixels[i] != 0);
                shared += both.report.triangles_clipped == 2 && both.pixels[i] != 0;
            }
            frame_free(&both);
            frame_free(&f);
            frame_free(&g);
        }
    }
    assert_true(pairs > 50);
    hard_pass("F6", "two triangles clipped along a shared edge",
              text("%d of 10000 crossings differ by the direction they are taken in", naive),
              text("from inside to outside always: %ld clipped pairs, %ld px, none twice, no gap (within %.2f codes)",
                   pairs, shared, worst));
}

static void test_F7_coplanar_faces(void **state)
{
    (void)state;
    /* Naive: depth in float with the nearer or equal one winning, the same plane through other corners. */
    int naive = 0;
    for (int i = 0; i < 1000; i++) {
        const float x = (float)i * 0.001f, a = 0.1f + x * (0.7f - 0.1f), b = 0.7f + (1 - x) * (0.1f - 0.7f);
        naive += b < a || b > a;
    }
    assert_true(naive > 50);
    long pixels = 0, other_corners = 0;
    for (int round = 0; round < 60; round++) {
        board b, c;
        glint_object objects[2];
        const int lean[2] = {round % 7 - 3, round / 7 - 4};
        open_world(&b);
        for (int i = 0; i < 4; i++) {
            const double x = i == 0 || i == 3 ? -6 : 6, y = i < 2 ? -6 : 6;
            set_corner(&b, i, x, y, 6 + lean[0] * 0.125 * x + lean[1] * 0.125 * y);
        }
        c = b;
        c.mesh.positions = (const int16_t(*)[3])c.positions;
        c.material.ambient = (glint_colour){16384, 0, 0};
        c.material.diffuse = (glint_colour){0, 0, 0};
        if (round % 2) { /* the other diagonal */
            static const uint16_t triangles[2][3] = {{1, 2, 3}, {1, 3, 0}};
            c.mesh.triangles = triangles;
        }
        objects[0] = b.object;
        objects[0].material = &c.material; /* red first */
        objects[1] = b.object;
        objects[1].mesh = &c.mesh;
        b.scene.objects = objects;
        b.scene.object_count = 2;
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame f = world_draw(&b, backend);
            for (size_t i = 0; i < f.bytes; i += 3) {
                const bool second = f.pixels[i + 1] != 0;
                assert_true(round % 2 || !second);
                pixels += round % 2 == 0 && f.pixels[i] != 0;
                other_corners += second;
            }
            frame g = {.display = {.width_px = WIDE, .height_px = HIGH, .band_px = 5}};
            assert_int_equal(frame_draw(&g, &b.scene, backend), 0);
            assert_memory_equal(f.pixels, g.pixels, f.bytes);
            frame_free(&f);
            frame_free(&g);
        }
    }
    hard_pass("F7", "coplanar faces", text("depths differ at %d of 1000 points of the same plane", naive),
              text("equal depth: the first drawn stays at all %ld px; of planes through other corners %ld px show the "
                   "second, alike in bands",
                   pixels, other_corners));
}

static void test_F8_depth_at_the_near_plane(void **state)
{
    (void)state;
    const uint16_t naive = (uint16_t)(uint32_t)(65536.0 * 1 / 1);
    assert_int_equal(naive, 0);
    long pixels = 0;
    for (int order = 0; order < 2; order++) {
        for (int tilt = 0; tilt < 5; tilt++) {
            board b, far;
            glint_object objects[2];
            open_world(&b);
            open_world(&far);
            for (int i = 0; i < 4; i++) {
                const double x = i == 0 || i == 3 ? -3 : 3, y = i < 2 ? -3 : 3;
                set_corner(&b, i, x, y,
                           1 + 1 / 1024.0 + tilt * 0.01 * (x + 3)); /* at the near plane, and away from it */
                set_corner(&far, i, 4 * x, 4 * y, 1.3 + tilt * 0.06);
            }
            far.material.ambient = (glint_colour){16384, 0, 0};
            far.material.diffuse = (glint_colour){0, 0, 0};
            objects[order] = b.object;
            objects[1 - order] = far.object;
            b.scene.objects = objects;
            b.scene.object_count = 2;
            for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
                frame f = world_draw(&b, backend);
                for (size_t i = 0; i < f.bytes; i += 3) {
                    assert_true(f.pixels[i + 1] != 0); /* never the red board behind */
                    pixels++;
                }
                frame_free(&f);
            }
        }
    }
    hard_pass("F8", "depth at the near plane", text("65536 near / Z is %u in 16 bits", naive),
              text("saturates: the nearest surface wins at %ld px, in both orders", pixels));
}

static void test_F9_triangle_seen_edge_on(void **state)
{
    (void)state;
    double naive = 0, worst = 0;
    long drawn = 0;
    for (int round = 0; round < 300; round++) {
        board b;
        open_world(&b);
        const double lean = hard_between(-3000, 3000) / 1e6, x = hard_between(-3000, 3000) / 1000.0;
        set_corner(&b, 0, x, -4, 4);
        set_corner(&b, 1, 4 * x + lean * 60, -4, 16);
        set_corner(&b, 2, 4 * x + lean * 60, 4, 16);
        set_corner(&b, 3, x, 4, 4);
        /* depth across the board's width on the display, which is a small part of a pixel */
        const double width = 24 * fabs((4 * x + lean * 60) / 16 - x / 4);
        naive = worse_of(naive, width > 0 ? 65408.0 * 16384 * (1.0 / 4 - 1.0 / 16) / width : 0);
        worst = worse_of(worst, expect_reference(&b.scene, WIDE, HIGH, GLINT_SHADING_EXACT, "edge-on"));
        frame f = world_draw(&b, round % 2);
        drawn += lit_pixels(&f);
        frame_free(&f);
    }
    assert_true(naive > INT32_MAX && drawn > 0);
    hard_pass("F9", "triangle seen edge-on", text("a depth step of %.0e in a pixel, beyond 32 bits", naive),
              text("clamped to the corners' range: 300 boards, %ld px, within %.2f codes", drawn, worst));
}

static void test_F10_camera_inside_an_object(void **state)
{
    (void)state;
    double worst = 0;
    long clipped = 0;
    int naive = 0;
    const glint_scene *demo = &demo_sphere_32x16;
    const glint_mesh *mesh = demo->objects[0].mesh;
    for (int step = 0; step <= 48; step++) { /* along z through the unit sphere, in and out again */
        glint_scene scene = *demo;
        glint_camera camera = *scene.camera;
        camera.eye_q16[2] = 78000 - 3250 * step;
        camera.target_q16[2] = camera.eye_q16[2] - 65536;
        camera.field_of_view_turn16 = 24576;
        camera.near_q16 = 6554;
        scene.camera = &camera;
        worst = worse_of(worst, expect_reference(&scene, WIDE, HIGH, GLINT_SHADING_EXACT, "inside"));
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame f = hard_draw(&scene, WIDE, HIGH, GLINT_RGB888, GLINT_SHADING_EXACT, backend);
            clipped += (long)f.report.triangles_clipped;
            frame_free(&f);
        }
    }
    /* in the very middle: every face looks away */
    glint_scene scene = *demo;
    glint_camera camera = *demo->camera;
    for (int k = 0; k < 3; k++) {
        camera.eye_q16[k] = demo->objects[0].place.origin_q16[k];
        camera.target_q16[k] = camera.eye_q16[k] + (k == 2 ? 65536 : 0);
    }
    for (uint16_t v = 0; v < mesh->vertex_count; v++) {
        naive += mesh->positions[v][2] < 0; /* behind, and projected all the same */
    }
    camera.near_q16 = 1 << 10;
    scene.camera = &camera;
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame f = hard_draw(&scene, WIDE, HIGH, GLINT_RGB888, GLINT_SHADING_EXACT, backend);
        assert_int_equal(f.report.pixels_shaded, 0);
        frame_free(&f);
    }
    assert_true(naive > 100 && clipped > 20);
    hard_pass(
        "F10", "camera inside an object", text("%d vertices behind the eye are projected", naive),
        text("clipped (%ld triangles), faces from inside not drawn; 49 places within %.2f codes", clipped, worst));
}

static void test_F11_impossible_cameras(void **state)
{
    (void)state;
    static const uint16_t fields[] = {0, 1, 181, 30948, 32768, 65535};
    static const int32_t nears[] = {0, 63, -1, INT32_MIN, (1 << 30) + 1, INT32_MAX};
    const volatile double angle = 0;
    const double naive = 1 / tan(angle);
    assert_true(isinf(naive));
    const glint_display display = {.width_px = 16, .height_px = 16};
    for (int i = 0; i < 6; i++) {
        board b;
        open_world(&b);
        b.camera.field_of_view_turn16 = fields[i];
        expect_refused(&b.scene, display, GLINT_ERROR_CAMERA_FIELD);
        open_world(&b);
        b.camera.near_q16 = nears[i];
        expect_refused(&b.scene, display, GLINT_ERROR_CAMERA_NEAR);
    }
    board b;
    open_world(&b);
    b.camera.target_q16[2] = b.camera.eye_q16[2];
    expect_refused(&b.scene, display, GLINT_ERROR_CAMERA_DIRECTION);
    b.camera.target_q16[1] = 1 << 16;
    expect_refused(&b.scene, display, GLINT_ERROR_CAMERA_UP);
    hard_pass("F11", "near >= far, field of view 0 or 180", text("the focal length is %f at 0 degrees", naive),
              "6 fields, 6 near distances, no direction, up along it: an error each; there is no far plane");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        hard_test(test_F1_w_to_zero),
        hard_test(test_F2_w_below_zero),
        hard_test(test_F3_vertex_on_the_near_plane),
        hard_test(test_F5_clipped_quad_split_either_way),
        hard_test(test_F6_two_triangles_clipped_along_a_shared_edge),
        hard_test(test_F7_coplanar_faces),
        hard_test(test_F8_depth_at_the_near_plane),
        hard_test(test_F9_triangle_seen_edge_on),
        hard_test(test_F10_camera_inside_an_object),
        hard_test(test_F11_impossible_cameras),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
