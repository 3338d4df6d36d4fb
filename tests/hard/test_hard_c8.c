/* SPDX-License-Identifier: MIT */
/*
 * Hard case C8, the neighbourhood: light all but opposite to the viewer, so that the half vector is short and its
 * direction ill-conditioned. Both backends are held to the reference with the budgets of hard.h.
 */
#include "tests/hard/hard.h"

static void test_C8_half_vector_nearly_undefined(void **state)
{
    (void)state;
    double worst = 0;
    for (int degrees = 95; degrees < 180; degrees += 3) {
        const double angle = degrees * 3.14159265358979 / 180;
        for (int tilt = -89; tilt <= 89; tilt += 3) {
            const double at = angle + tilt * 3.14159265358979 / 180;
            board b;
            board_set_up(&b);
            b.material.specular = board_grey(16384);
            b.material.exponent_q4 = 20 * 16;
            b.material.specular_model = GLINT_BLINN;
            board_normals(&b, (int)lround(16384 * sin(angle)), 0, (int)lround(16384 * cos(angle)));
            board_light(&b, 0, (int)lround(-30000 * sin(at)), 0, (int)lround(-30000 * cos(at)));
            worst = worse_of(worst, expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT,
                                                     text("normal at %d, light %d from it", degrees, tilt)));
        }
    }
    printf("l all but -v: within %.2f codes\n", worst);
}

int main(void)
{
    const struct CMUnitTest tests[] = {hard_test(test_C8_half_vector_nearly_undefined)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
