/* SPDX-License-Identifier: MIT */
/*
 * A library made without textures (GLINT_TEXTURES 0) refuses a scene that has one, and takes all others.
 */
#define GLINT_TEXTURES 0
#define glint_validate validate_without_textures
#define glint_validate_sizes validate_sizes_without_textures
#include "validate.c"

#include "tests/unit/board.h"

static int take_nothing(void *context, const glint_band *band)
{
    (void)context;
    (void)band;
    return 0;
}

static void test_a_texture_is_refused(void **state)
{
    static const uint16_t texel[1] = {0};
    static const int16_t texcoords[4][2] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    static const glint_texture texture = {.texels = texel, .width_px = 1, .height_px = 1};
    const glint_display display = {.width_px = BOARD_PX, .height_px = BOARD_PX, .flush = take_nothing};
    const glint_quality quality = {.shading = GLINT_SHADING_EXACT};
    board b;
    (void)state;
    board_set_up(&b);
    b.mesh.texcoords = texcoords;
    b.mesh.texcoord_bits = 9;
    assert_int_equal(validate_without_textures(&b.scene, &display, &quality), GLINT_OK);
    b.material.texture = &texture;
    assert_int_equal(validate_without_textures(&b.scene, &display, &quality), GLINT_ERROR_TEXTURE_ABSENT);
    assert_non_null(strstr(glint_error_text(GLINT_ERROR_TEXTURE_ABSENT), "GLINT_TEXTURES"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_texture_is_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
