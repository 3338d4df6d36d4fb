/* SPDX-License-Identifier: MIT */
/* Hard cases I1 to I5: light that does not arrive everywhere alike. See docs/hard-cases.md. */
#include "tests/hard/hard.h"

#define DEGREE 0.01745329251994330
#define CONE_CODES 20    /* I1: what Q15 makes of the edge of a cone of one degree */
#define STEP_CODES 30    /* I2: of a light cut off at its range */
#define ACNE_PX 200      /* I3: of 33 x 33 */
#define LEAK_PX 5        /* I4 */
#define HORIZON_CODES 25 /* I5 */

static void diffuse_board(board *b)
{
    board_set_up(b);
    b->material.diffuse = board_grey(16384);
}

static void spot(glint_light *light, double z, double inner_degrees, double outer_degrees)
{
    memset(light, 0, sizeof *light);
    light->kind = GLINT_SPOT;
    light->direction[2] = -1;
    light->position_q16[2] = BOARD_Q16(z);
    light->colour = board_grey(16384);
    light->inner_turn16 = (uint16_t)lround(inner_degrees / 360 * 65536);
    light->outer_turn16 = (uint16_t)lround(outer_degrees / 360 * 65536);
}

/* The soft edge of a cone, by cosines rounded to Q15. */
static double naive_cone(double angle, double inner, double outer)
{
    const double cosine = floor(cos(angle) * 32768 + 0.5), in = floor(cos(inner) * 32768 + 0.5),
                 out = floor(cos(outer) * 32768 + 0.5);
    const double share = (cosine - out) / (in - out), within = share < 0 ? 0 : share > 1 ? 1 : share;
    return within * within;
}

static void test_I1_edge_of_a_narrow_cone(void **state)
{
    (void)state;
    const double outer = 182 / 65536.0 * 360 * DEGREE;
    double naive = 0, worst = 0;
    for (int i = 0; i <= 1000; i++) {
        const double x = outer * i / 1000, share = (cos(x) - cos(outer)) / (1 - cos(outer));
        naive = worse_of(naive, 255 * fabs(naive_cone(x, 0, outer) - share * share));
    }
    assert_true(naive > CONE_CODES);
    static const double heights[] = {280, 400, 600, 1500};
    for (size_t i = 0; i < sizeof heights / sizeof *heights; i++) {
        board b;
        diffuse_board(&b);
        spot(&b.light[0], heights[i], 0, 182 / 65536.0 * 360);
        worst = worse_of(worst, expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "narrow cone"));
        frame f = board_draw(&b, GLINT_SHADING_EXACT, FRAME_FIXED);
        assert_true(f.pixels[3 * HARD_CENTRE] == 255 && f.pixels[0] < (i == 0 ? 1 : 255)); /* the edge is seen */
        frame_free(&f);
    }
    /* as wide as may be, and with an edge as sharp as may be, which ends within the board */
    for (int sharp = 0; sharp < 2; sharp++) {
        board b;
        diffuse_board(&b);
        spot(&b.light[0], 3, sharp ? 44 : 0, sharp ? 45 : 90);
        worst = worse_of(worst, expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "cone"));
    }
    hard_pass("I1", "edge of a spot light's cone of one degree", text("cosines in Q15: %.0f codes off", naive),
              text("within %.2f codes, from there to a right angle", worst));
}

static void test_I2_end_of_a_light_s_range(void **state)
{
    (void)state;
    const double range = 4, height = 1;
    const double naive = 255 * (height / range) / 1; /* n.s there; the light just beyond has none */
    assert_true(naive > STEP_CODES);
    board b;
    int beyond = 0;
    diffuse_board(&b);
    b.material.ambient = board_grey(4096);
    b.scene.ambient = board_grey(16384);
    b.light[0].kind = GLINT_POINT;
    b.light[0].position_q16[2] = BOARD_Q16(height);
    b.light[0].attenuation.range_q16 = (uint32_t)BOARD_Q16(range);
    const double worst = expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "range");
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame f = board_draw(&b, GLINT_SHADING_EXACT, backend);
        int step = 0;
        for (int x = 0; x < BOARD_PX; x++) { /* the middle row: a pixel is 10/33 units */
            const int code = f.pixels[3 * (BOARD_PX / 2 * BOARD_PX + x)];
            const double from_middle = fabs((x - BOARD_PX / 2) * 10.0 / BOARD_PX);
            if (from_middle * from_middle + height * height > range * range) {
                assert_int_equal(code, 64); /* ambient light alone, to the bit */
                beyond++;
            } else if (from_middle > 3.4) {
                step = code - 64 > step ? code - 64 : step;
            }
        }
        assert_true(step > 0 && step < STEP_CODES / 2);
        frame_free(&f);
    }
    hard_pass("I2", "end of a light's range", text("cut off at the range: a step of %.0f codes", naive),
              text("fades to 0 within %.2f codes; ambient light alone at all %d px beyond", worst, beyond));
}

/* Points of the board in single precision, and a ray towards the light that may meet the board itself. */
static int naive_acne(double elevation)
{
    int acne = 0;
    const float turn = 0.3f; /* the plane through the origin, turned, as any but the axes' is */
    const float n[3] = {sinf(turn), 0, cosf(turn)};
    const float d[3] = {(float)cos(elevation) * n[2] + (float)sin(elevation) * n[0], 0,
                        (float)-cos(elevation) * n[0] + (float)sin(elevation) * n[2]};
    for (int i = 0; i < BOARD_PX * BOARD_PX; i++) {
        const float along = (float)(i % BOARD_PX) * 0.31f - 5, across = (float)(i / BOARD_PX) * 0.31f - 5;
        const float p[3] = {along * n[2], across, -along * n[0]};
        const float height = n[0] * p[0] + n[1] * p[1] + n[2] * p[2], slope = n[0] * d[0] + n[1] * d[1] + n[2] * d[2];
        acne += -height / slope > 0;
    }
    return acne;
}

static void test_I3_shadows_under_grazing_light(void **state)
{
    (void)state;
    static const double elevations[] = {45, 10, 2, 0.5, 0.1, 0.02};
    const int naive = naive_acne(0.1 * DEGREE);
    assert_true(naive > ACNE_PX);
    int tried = 0;
    for (size_t i = 0; i < sizeof elevations / sizeof *elevations; i++) {
        for (int turn = 0; turn < 6; turn++) {
            board b;
            const double e = elevations[i] * DEGREE, t = turn * 1.1;
            diffuse_board(&b);
            b.material.sides = (uint8_t)(turn % 3);
            /* once more in the same place, divided along the other diagonal; all cast and take shadows */
            static const uint16_t other[2][3] = {{0, 1, 3}, {1, 2, 3}};
            glint_mesh again = b.mesh;
            glint_object objects[2];
            again.triangles = other;
            b.object.place = glint_turn_x((uint16_t)(turn * 900));
            objects[0] = objects[1] = b.object;
            objects[1].mesh = &again;
            b.scene.objects = objects;
            b.scene.object_count = 2;
            const double x = turn * 900 / 65536.0 * 360 * DEGREE; /* direction in the board's own axes, turned */
            const double v[3] = {-cos(e) * cos(t), -cos(e) * sin(t), -sin(e)};
            board_light(&b, 0, (int)lround(30000 * v[0]), (int)lround(30000 * (v[1] * cos(x) - v[2] * sin(x))),
                        (int)lround(30000 * (v[1] * sin(x) + v[2] * cos(x))));
            for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
                b.light[0].casts_shadows = false;
                frame without = hard_draw(&b.scene, BOARD_PX, BOARD_PX, GLINT_RGB888, GLINT_SHADING_EXACT, backend);
                b.light[0].casts_shadows = true;
                frame with = hard_draw(&b.scene, BOARD_PX, BOARD_PX, GLINT_RGB888, GLINT_SHADING_EXACT, backend);
                assert_int_equal(with.report.pixels_shadowed, 0);
                assert_memory_equal(with.pixels, without.pixels, with.bytes);
                frame_free(&with);
                frame_free(&without);
                tried++;
            }
        }
    }
    hard_pass("I3", "a surface's shadow on itself under grazing light",
              text("rays from points in single precision: %d of %d px in their own shadow", naive, BOARD_PX * BOARD_PX),
              text("none in %d pictures of a surface twice in one plane, from 45 to 0.02 degrees", tried));
}

/* A wall that stands on the board, its foot in the board's plane, and a light that comes over it. */
typedef struct wall_world {
    board b;
    int16_t positions[4][3];
    glint_mesh mesh;
    glint_object objects[2];
} wall_world;

static void wall_set_up(wall_world *w, double elevation_degrees)
{
    static const int16_t corner[4][2] = {{-1, 0}, {1, 0}, {1, 1}, {-1, 1}};
    diffuse_board(&w->b);
    w->b.material.sides = GLINT_TWO_SIDED;
    for (int i = 0; i < 4; i++) {
        w->positions[i][0] = (int16_t)(corner[i][0] * 2 * BOARD_UNIT);
        w->positions[i][1] = 100;
        w->positions[i][2] = (int16_t)(corner[i][1] * BOARD_UNIT);
    }
    w->mesh = w->b.mesh;
    w->mesh.positions = (const int16_t(*)[3])w->positions;
    w->mesh.normals_q14 = (const int16_t(*)[3])w->b.normals;
    w->objects[0] = w->objects[1] = w->b.object;
    w->objects[1].mesh = &w->mesh;
    w->b.scene.objects = w->objects;
    w->b.scene.object_count = 2;
    const double e = elevation_degrees * DEGREE;
    board_light(&w->b, 0, 0, (int)lround(-30000 * cos(e)), (int)lround(-30000 * sin(e)));
    w->b.light[0].casts_shadows = true;
}

static void test_I4_shadow_at_the_foot(void **state)
{
    (void)state;
    enum { PX = 192 };
    const double bias = 0.1; /* a tenth of the wall's height, as shadow maps of that resolution need */
    double worst = 0;
    int naive = 0;
    for (int degrees = 60; degrees >= 15; degrees -= 15) {
        wall_world w;
        int lit = 0, dark = 0;
        wall_set_up(&w, degrees);
        worst = worse_of(worst, expect_reference(&w.b.scene, PX, PX, GLINT_SHADING_EXACT, "wall"));
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame f = hard_draw(&w.b.scene, PX, PX, GLINT_RGB888, GLINT_SHADING_EXACT, backend);
            /* from the foot on, away from the light: a pixel is 10/192 units */
            for (int y = PX / 2; y < PX; y++) {
                const double behind = (y + 0.5 - PX / 2.0) * 10 / PX + 100.0 / BOARD_UNIT;
                const double ends = 1 / tan(degrees * DEGREE);
                const int code = f.pixels[3 * (y * PX + PX / 2)];
                if (behind > 1.5 * 10 / PX && behind < ends - 1.5 * 10 / PX) {
                    assert_int_equal(code, 0);
                    dark++;
                    /* a point lifted towards the light by the bias passes over the wall's lower part */
                    naive += behind < bias / tan(degrees * DEGREE);
                } else if (behind > ends + 1.5 * 10 / PX) {
                    assert_true(code > 0);
                    lit++;
                }
            }
            frame_free(&f);
        }
        assert_true(dark > 0 && lit > 0);
    }
    assert_true(naive > LEAK_PX);
    hard_pass("I4", "shadow at the foot of what throws it",
              text("with a bias of a tenth of its height: %d px of one column lit", naive),
              text("dark from the foot on, within %.2f codes of rays cast in double precision", worst));
}

static void test_I5_panel_across_the_horizon(void **state)
{
    (void)state;
    board b;
    diffuse_board(&b);
    glint_light *light = &b.light[0];
    light->kind = GLINT_PANEL;
    light->position_q16[0] = BOARD_Q16(-40);
    light->position_q16[2] = BOARD_Q16(-3); /* its middle is below the board's plane */
    light->edge_q16[0][2] = BOARD_Q16(16);
    light->edge_q16[1][1] = BOARD_Q16(16);
    light->samples = GLINT_MAX_SAMPLES;
    light->colour = board_grey(32767);
    const double worst = expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "panel");
    const int code = board_centre(&b, GLINT_SHADING_EXACT, FRAME_FIXED); /* by its middle alone: 0 */
    assert_true(code > HORIZON_CODES);
    hard_pass("I5", "extended source that the surface's plane cuts",
              text("one point in its middle: 0 codes, %d off", code), text("within %.2f codes of the integral", worst));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        hard_test(test_I1_edge_of_a_narrow_cone),       hard_test(test_I2_end_of_a_light_s_range),
        hard_test(test_I3_shadows_under_grazing_light), hard_test(test_I4_shadow_at_the_foot),
        hard_test(test_I5_panel_across_the_horizon),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
