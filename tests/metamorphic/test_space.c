/* SPDX-License-Identifier: MIT */
/*
 * What must become of a picture when the whole scene is moved, turned or scaled in a way that its formats can hold.
 *
 * Budgets:
 *   shifted    A display wider by 2 n px shows the same picture n px farther right: the focal length depends on the
 * height alone, and vertices are projected from the display's centre before it is added. Silhouettes: none, both.
 *              Fixed, Gouraud and flat: none, as planes are anchored at their triangle. Fixed, exact: 1 code, for a ray
 * is counted from the display's corner and its scale depends on the width. Float: 1 code, for the same reason and as a
 * span that the display's edge cut begins elsewhere. permuted   x, y, z to y, z, x: none, both. Set-up is integer sums,
 * which may be taken in any order, and the lighting frame (the model's or the view's) does not know the world's axes.
 *   turned     half a turn about an axis (two axes flipped): none in silhouettes and 1 code, as set-up rounds halves
 *              up, which a change of sign turns around (at exact halves only).
 *   mirrored   one axis flipped, which mirrors the picture: 1 code where the reference says that neither edge nor depth
 *              is contested within 2/256 px (each picture may round a vertex by one step, and halves are rounded up).
 *   scaled     all lengths by 2, 4, 8: none, both. Every format of set-up keeps a mantissa and an exponent, or has the
 *              fraction that the object needs.
 */
#define SHIFTED_CODES 1
#define SHIFTED_SHARE 0.0002 /* measured: 0.000003 */
#define TURNED_CODES 1
#define TURNED_SHARE 0.0002 /* measured: 0 */
#define MIRRORED_CODES 1
#define MIRRORED_SHARE 0.0002 /* measured: 0.000003 */
#define CONTESTED_SHARE 0.01  /* measured: 0.0036 */

#include "tests/metamorphic/world.h"

#include "tests/reference/reference.h"

typedef void (*change)(world *w, int number);

static void draw_pair(comparison *sum, const world *a, const world *b, int shading, int backend, int shift)
{
    frame first = world_draw(a, WORLD_WIDTH, shading, backend);
    frame second = world_draw(b, (uint16_t)(WORLD_WIDTH + 2 * shift), shading, backend);
    world_compare(sum, &first, &second, shift, 0, NULL);
    frame_free(&first);
    frame_free(&second);
}

static void test_shifted_by_whole_pixels(void **state)
{
    comparison silhouettes = {0}, linear = {0}, exact = {0}, real = {0}, within[FRAME_BACKENDS] = {{0}};
    (void)world_seed(state);
    for (int n = 0; n < WORLD_SCENES; n++) {
        static world w;
        const int shift = world_between(1, 40);
        world_make(&w);
        draw_pair(&linear, &w, &w, GLINT_SHADING_FLAT, FRAME_FIXED, shift);
        draw_pair(&linear, &w, &w, GLINT_SHADING_GOURAUD, FRAME_FIXED, shift);
        draw_pair(&exact, &w, &w, GLINT_SHADING_EXACT, FRAME_FIXED, shift);
        for (int shading = 0; shading < WORLD_SHADINGS; shading++) {
            draw_pair(&real, &w, &w, shading, FRAME_FLOAT, shift);
        }
        world_compare_within(within, &w, &w, shift, 0, NULL);
        world_silhouette(&w);
        draw_pair(&silhouettes, &w, &w, GLINT_SHADING_FLAT, FRAME_FIXED, shift);
        draw_pair(&silhouettes, &w, &w, GLINT_SHADING_FLAT, FRAME_FLOAT, shift);
    }
    world_expect(&silhouettes, "shifted by whole pixels, silhouettes, both", 0, 0);
    world_expect(&linear, "shifted by whole pixels, fixed, Gouraud and flat", 0, 0);
    world_expect(&exact, "shifted by whole pixels, fixed, exact", SHIFTED_CODES, SHIFTED_SHARE);
    world_expect(&real, "shifted by whole pixels, float", SHIFTED_CODES, SHIFTED_SHARE);
    world_expect_within(within, "shifted by whole pixels", WITHIN_CODES, ANY_SHARE);
}

/* New axis k is old axis source[k], flipped where sign[k] is -1. */
static void move_axes(world *w, const int source[3], const int sign[3])
{
    world old;
    world_copy(&old, w);
    for (int k = 0; k < 3; k++) {
        const int from = source[k];
        w->camera.eye_q16[k] = sign[k] * old.camera.eye_q16[from];
        w->camera.target_q16[k] = sign[k] * old.camera.target_q16[from];
        w->camera.up[k] = (int16_t)(sign[k] * old.camera.up[from]);
        for (int i = 0; i < WORLD_OBJECTS; i++) {
            for (int j = 0; j < 3; j++) {
                w->objects[i].place.linear_q16[k][j] = sign[k] * old.objects[i].place.linear_q16[from][j];
            }
            w->objects[i].place.origin_q16[k] = sign[k] * old.objects[i].place.origin_q16[from];
        }
        for (uint16_t i = 0; i < w->scene.light_count; i++) {
            w->lights[i].direction[k] = (int16_t)(sign[k] * old.lights[i].direction[from]);
            w->lights[i].position_q16[k] = sign[k] * old.lights[i].position_q16[from];
        }
    }
}

static void permute(world *w, int number)
{
    static const int source[][3] = {{1, 2, 0}, {2, 0, 1}}, sign[3] = {1, 1, 1};
    move_axes(w, source[number % 2], sign);
}

static void half_turn(world *w, int number)
{
    static const int source[3] = {0, 1, 2}, sign[][3] = {{1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    move_axes(w, source, sign[number % 3]);
}

static void mirror(world *w, int number)
{
    static const int source[3] = {0, 1, 2}, sign[][3] = {{-1, 1, 1}, {1, -1, 1}, {1, 1, -1}};
    move_axes(w, source, sign[number % 3]);
}

/* Lengths of up to 40 units, times 8, are well within their ranges. */
static void scale(world *w, int number)
{
    const int32_t factor = (int32_t)2 << (number % 3);
    w->camera.near_q16 *= factor;
    for (int k = 0; k < 3; k++) {
        w->camera.eye_q16[k] *= factor;
        w->camera.target_q16[k] *= factor;
        for (int i = 0; i < WORLD_OBJECTS; i++) {
            for (int j = 0; j < 3; j++) {
                w->objects[i].place.linear_q16[k][j] *= factor;
            }
            w->objects[i].place.origin_q16[k] *= factor;
        }
        for (uint16_t i = 0; i < w->scene.light_count; i++) {
            w->lights[i].position_q16[k] *= factor;
        }
    }
}

static void compare_changed(change by, comparison *silhouettes, comparison *shaded, comparison within[FRAME_BACKENDS])
{
    for (int n = 0; n < WORLD_SCENES; n++) {
        static world w, changed;
        world_make(&w);
        world_copy(&changed, &w);
        by(&changed, n);
        world_compare_within(within, &w, &changed, 0, 0, NULL);
        for (int i = 0; i < FRAME_BACKENDS * WORLD_SHADINGS; i++) {
            draw_pair(shaded, &w, &changed, i / FRAME_BACKENDS, i % FRAME_BACKENDS, 0);
        }
        world_silhouette(&w);
        world_silhouette(&changed);
        draw_pair(silhouettes, &w, &changed, GLINT_SHADING_FLAT, FRAME_FIXED, 0);
        draw_pair(silhouettes, &w, &changed, GLINT_SHADING_FLAT, FRAME_FLOAT, 0);
    }
}

static void test_permuted_axes(void **state)
{
    comparison silhouettes = {0}, shaded = {0}, within[FRAME_BACKENDS] = {{0}};
    (void)world_seed(state);
    compare_changed(permute, &silhouettes, &shaded, within);
    world_expect(&silhouettes, "axes permuted, silhouettes, both", 0, 0);
    world_expect(&shaded, "axes permuted, both", 0, 0);
    world_expect_within(within, "axes permuted", 0, 0);
}

static void test_two_axes_flipped(void **state)
{
    comparison silhouettes = {0}, shaded = {0}, within[FRAME_BACKENDS] = {{0}};
    (void)world_seed(state);
    compare_changed(half_turn, &silhouettes, &shaded, within);
    world_expect(&silhouettes, "two axes flipped, silhouettes, both", 0, 0);
    world_expect(&shaded, "two axes flipped, both", TURNED_CODES, TURNED_SHARE);
    world_expect_within(within, "two axes flipped", WITHIN_CODES, ANY_SHARE);
}

static void test_scaled_units(void **state)
{
    comparison silhouettes = {0}, shaded = {0}, within[FRAME_BACKENDS] = {{0}};
    (void)world_seed(state);
    compare_changed(scale, &silhouettes, &shaded, within);
    world_expect(&silhouettes, "units scaled by a power of two, silhouettes, both", 0, 0);
    world_expect(&shaded, "units scaled by a power of two, both", 0, 0);
    world_expect_within(within, "units scaled by a power of two", 0, 0);
}

static void test_mirrored_world(void **state)
{
    static const reference_options options = {.edge_px = 2.0 / 256};
    comparison shaded = {0}, within[FRAME_BACKENDS] = {{0}};
    uint32_t contested = 0, pixels = 0;
    (void)world_seed(state);
    for (int n = 0; n < WORLD_SCENES; n++) {
        static world w, mirrored;
        reference_image image;
        char error[200];
        world_make(&w);
        world_copy(&mirrored, &w);
        mirror(&mirrored, n);
        for (int i = 0; i < FRAME_BACKENDS * WORLD_SHADINGS; i++) {
            const int shading = i / FRAME_BACKENDS, backend = i % FRAME_BACKENDS;
            if (reference_render_with(&w.scene, WORLD_WIDTH, WORLD_HEIGHT, shading, &options, &image, error,
                                      sizeof error) != 0) {
                fail_msg("%s", error);
            }
            frame a = world_draw(&w, WORLD_WIDTH, shading, backend);
            frame b = world_draw(&mirrored, WORLD_WIDTH, shading, backend);
            world_compare(&shaded, &a, &b, 0, 1, image.mask);
            pixels += WORLD_WIDTH * WORLD_HEIGHT;
            for (int p = 0; p < WORLD_WIDTH * WORLD_HEIGHT; p++) {
                contested += image.mask[p] != 0;
            }
            frame_free(&a);
            frame_free(&b);
            if (shading == GLINT_SHADING_EXACT && backend == FRAME_FIXED) {
                world_compare_within(within, &w, &mirrored, 0, 1, image.mask);
            }
            reference_free(&image);
        }
    }
    print_message("contested: %.3f %% of %u pixels\n", 100.0 * contested / pixels, pixels);
    assert_true(contested <= CONTESTED_SHARE * pixels);
    world_expect(&shaded, "one axis flipped, both", MIRRORED_CODES, MIRRORED_SHARE);
    world_expect_within(within, "one axis flipped", WITHIN_CODES, ANY_SHARE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shifted_by_whole_pixels), cmocka_unit_test(test_permuted_axes),
        cmocka_unit_test(test_two_axes_flipped),        cmocka_unit_test(test_scaled_units),
        cmocka_unit_test(test_mirrored_world),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
