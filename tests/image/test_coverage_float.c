/* SPDX-License-Identifier: MIT */
/*
 * Coverage of the float backend, see coverage_body.h.
 */
#include "backend/float.c" /* for its static functions; it takes the place of the library's own copy */

#include "tests/image/coverage_body.h"

static void test_built_in_scenes(void **state)
{
    (void)state;
    check_all(FRAME_FLOAT);
}

static void test_clipped_scenes(void **state)
{
    (void)state;
    check_close(FRAME_FLOAT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_built_in_scenes),
        cmocka_unit_test(test_clipped_scenes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
