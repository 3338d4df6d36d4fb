/* SPDX-License-Identifier: MIT */
/*
 * A library that is compiled without shadows refuses a scene that asks for them, before anything is written.
 */
#undef GLINT_SHADOWS
#define GLINT_SHADOWS 0

#include "src/validate.c"

#include "tests/unit/board.h"

static void test_shadows_are_refused(void **state)
{
    (void)state;
    board b;
    board_set_up(&b);
    const glint_display display = {.width_px = 8, .height_px = 8, .flush = frame_flush};
    const glint_quality quality = {.tolerance = 0};
    assert_int_equal(glint_validate(&b.scene, &display, &quality), GLINT_OK);
    b.light[0].casts_shadows = true;
    assert_int_equal(glint_validate(&b.scene, &display, &quality), GLINT_ERROR_NOT_BUILT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_shadows_are_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
