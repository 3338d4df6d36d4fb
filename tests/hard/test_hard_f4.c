/* SPDX-License-Identifier: MIT */
/*
 * Hard case F4: triangles with nothing beyond the near plane. docs/hard-cases.md has the defined behaviour; hard.h the
 * form of a test.
 */
#include "tests/hard/hard.h"

/* A triangle before an eye at the origin that looks along -z, near distance 1. */
static void triangle_at(board *b, const double distance[3])
{
    static const double corner[3][2] = {{-0.4, -0.3}, {0.45, -0.35}, {0.1, 0.4}};
    board_set_up(b);
    b->camera.eye_q16[2] = 0;
    b->camera.target_q16[2] = -65536;
    b->material.ambient = b->scene.ambient = board_grey(16384);
    b->mesh.triangle_count = 1;
    for (int i = 0; i < 3; i++) {
        b->positions[i][0] = (int16_t)lround(corner[i][0] * BOARD_UNIT);
        b->positions[i][1] = (int16_t)lround(corner[i][1] * BOARD_UNIT);
        b->positions[i][2] = (int16_t)lround(-distance[i] * BOARD_UNIT);
    }
}

static void test_F4_all_behind_or_all_on_the_plane(void **state)
{
    (void)state;
    int naive = 0;
    for (int round = 0; round < 500; round++) {
        board b;
        double distance[3];
        for (int i = 0; i < 3; i++) {
            distance[i] = round == 0 ? 1 : round % 2 ? -hard_between(1, 15000) / 1000.0 : hard_between(0, 999) / 1000.0;
            naive += distance[i] < 0; /* projected all the same */
        }
        triangle_at(&b, distance);
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame f = hard_draw(&b.scene, 64, 48, GLINT_GREY8, GLINT_SHADING_EXACT, backend);
            if (f.report.pixels_shaded != 0) {
                fail_msg("%s: %u px of a triangle at %.3f, %.3f, %.3f before the eye, near plane at 1",
                         frame_backend_name[backend], f.report.pixels_shaded, distance[0], distance[1], distance[2]);
            }
            frame_free(&f);
        }
    }
    hard_pass("F4", "all vertices behind, or all on the plane", text("%d vertices behind the eye projected", naive),
              "nothing drawn: 499 triangles behind the plane, one in it");
}

int main(void)
{
    const struct CMUnitTest tests[] = {hard_test(test_F4_all_behind_or_all_on_the_plane)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
