/* SPDX-License-Identifier: MIT */
/*
 * Hard case A2: a normal that vanishes between two corners. docs/hard-cases.md has the defined behaviour; hard.h the
 * form of a test.
 */
#include "tests/hard/hard.h"

/* Left corners point to -x, right ones to +x: in the middle column the sum is zero. */
static void test_A2_interpolated_normal_through_zero(void **state)
{
    (void)state;
    int naive = 0;
    for (int y = 0; y < BOARD_PX; y++) {
        const volatile float left = -0.5f, right = 0.5f;
        const float sum = left + right, component = sum / sqrtf(sum * sum);
        naive += isnan(component) ? 1 : 0;
    }
    assert_int_equal(naive, BOARD_PX);
    long column = 0;
    for (int across = 0; across < 2; across++) {
        board b;
        board_set_up(&b);
        b.material.diffuse = board_grey(16384);
        board_light(&b, 0, -3, 0, -4); /* s = (0.6, 0, 0.8): +x is 153, -x is 0, the face normal 204 */
        for (int i = 0; i < 4; i++) {
            const int right = b.positions[i][across] > 0;
            b.normals[i][0] = (int16_t)(right ? 16384 : -16384);
            b.normals[i][2] = 0;
        }
        for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
            frame f = board_draw(&b, GLINT_SHADING_EXACT, backend);
            for (int i = 0; i < BOARD_PX * BOARD_PX; i++) {
                const int x = across ? BOARD_PX - 1 - i / BOARD_PX : i % BOARD_PX, code = f.pixels[3 * i];
                const int expected = x < BOARD_PX / 2 ? 0 : x > BOARD_PX / 2 ? 153 : 204;
                if (abs(code - expected) > 1) {
                    fail_msg("%s, %d: pixel %d, %d is %d, expected %d", frame_backend_name[backend], across,
                             i % BOARD_PX, i / BOARD_PX, code, expected);
                }
                column += x == BOARD_PX / 2;
            }
            frame_free(&f);
        }
    }
    hard_pass("A2", "interpolated normal passes through zero", text("NaN at %d px of the middle column", naive),
              text("the face normal at all %ld px of the middle lines, no speckle beside them", column));
}

int main(void)
{
    const struct CMUnitTest tests[] = {hard_test(test_A2_interpolated_normal_through_zero)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
