/* SPDX-License-Identifier: MIT */
/*
 * Variants of the backends without textures refuse a scene that has one, and take it without; the whole backends take
 * both.
 */
#include <glint/glint.h>

#include "tests/unit/board.h"

typedef int (*draw_function)(const glint_scene *, const glint_display *, const glint_quality *, void *, size_t,
                             glint_report *);

static uint32_t memory_words[1 << 16];
static unsigned bands;

static int take(void *context, const glint_band *band)
{
    (void)context;
    (void)band;
    bands++;
    return 0;
}

static int draw(draw_function render, const board *b)
{
    const glint_display display = {.width_px = BOARD_PX, .height_px = BOARD_PX, .flush = take};
    const glint_quality quality = {.shading = GLINT_SHADING_EXACT};
    return render(&b->scene, &display, &quality, memory_words, sizeof memory_words, NULL);
}

static void test_a_texture_is_refused(void **state)
{
    static const uint16_t texel[1] = {0};
    static const int16_t texcoords[4][2] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    static const glint_texture texture = {.texels = texel, .width_px = 1, .height_px = 1};
    static const draw_function without[] = {glint_fixed_phong_render, glint_fixed_diffuse_render,
                                            glint_float_phong_render, glint_float_diffuse_render};
    static const draw_function whole[] = {glint_fixed_render, glint_float_render};
    board b;
    (void)state;
    board_set_up(&b);
    b.mesh.texcoords = texcoords;
    b.mesh.texcoord_bits = 9;
    for (size_t i = 0; i < sizeof without / sizeof *without; i++) {
        b.material.texture = NULL;
        assert_int_equal(draw(without[i], &b), GLINT_OK);
        bands = 0;
        b.material.texture = &texture;
        assert_int_equal(draw(without[i], &b), GLINT_ERROR_PART);
        assert_int_equal(bands, 0);
    }
    for (size_t i = 0; i < sizeof whole / sizeof *whole; i++) {
        assert_int_equal(draw(whole[i], &b), GLINT_OK);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_texture_is_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
