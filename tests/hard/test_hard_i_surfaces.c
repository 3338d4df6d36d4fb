/* SPDX-License-Identifier: MIT */
/* Hard cases I6 to I12: what a surface does with light beyond reflecting it. See docs/hard-cases.md. */
#include "tests/hard/hard.h"

#define BANDS 33
#define ORDER_CODES 50  /* I7 */
#define AFFINE_TEXELS 4 /* I9 */
#define FOG_CODES 40    /* I10 */
#define SEAM_CODES 100  /* I11 */
#define TEXCOORD_BITS 9

/* A board with others before it, all square to the view; the material of each its own. */
typedef struct panes {
    board b;
    glint_material materials[3];
    glint_object objects[3];
} panes;

/* Surfaces that are lit by themselves alone: an opaque one of `level`, panes that add `own` and let half through. */
static void panes_set_up(panes *p, int16_t level, const int16_t own[2])
{
    board_set_up(&p->b);
    p->b.scene.light_count = 0;
    for (int i = 0; i < 3; i++) {
        memset(&p->materials[i], 0, sizeof p->materials[i]);
        p->materials[i].emission = board_grey(i == 0 ? level : own[i - 1]);
        p->materials[i].transmission_q14 = i == 0 ? 0 : 8192;
        p->objects[i] = p->b.object;
        p->objects[i].material = &p->materials[i];
        p->objects[i].place = glint_shift(0, 0, i * BOARD_Q16(1));
    }
    p->b.scene.objects = p->objects;
    p->b.scene.object_count = 3;
}

static void test_I6_layers_at_the_edges_of_bands(void **state)
{
    (void)state;
    static const uint8_t formats[] = {GLINT_RGB888, GLINT_RGB565, GLINT_GREY8, GLINT_GREY4, GLINT_MONO_PAGES};
    static const int16_t own[2] = {0, 0};
    panes p;
    int pictures = 0;
    panes_set_up(&p, 16384, own);
    p.b.scene.object_count = 2;
    /* white behind, half of it shown; a row that two bands share, both ends included, is drawn twice */
    const int once = 128, naive = (once + 1) / 2;
    for (size_t k = 0; k < sizeof formats; k++) {
        for (int n = 0; n < FRAME_BACKENDS * 2; n++) {
            frame whole = {.display = {.width_px = BOARD_PX, .height_px = BOARD_PX, .format = formats[k]},
                           .tolerance = n & 2 ? GLINT_CODES(1) : 0};
            assert_int_equal(frame_draw(&whole, &p.b.scene, n & 1), GLINT_OK);
            for (size_t i = 0; i < whole.bytes && formats[k] == GLINT_RGB888; i++) {
                assert_int_equal(whole.pixels[i], once); /* also on the diagonal that triangles share */
            }
            for (uint16_t band = 1; band < BANDS; band++) {
                frame f = {.display = whole.display, .tolerance = whole.tolerance, .memory_bytes = band & 1};
                f.display.band_px = formats[k] == GLINT_MONO_PAGES ? (uint16_t)(band / 8 * 8) : band;
                assert_int_equal(frame_draw(&f, &p.b.scene, n & 1), GLINT_OK);
                assert_memory_equal(f.pixels, whole.pixels, whole.bytes);
                frame_free(&f);
                pictures++;
            }
            frame_free(&whole);
        }
    }
    hard_pass("I6", "transparent over opaque at the edges of bands",
              text("a row drawn by both bands: %d instead of %d", naive, once),
              text("%d in all pixels, once each; %d pictures in bands equal the whole", once, pictures));
}

static void test_I7_panes_in_any_order(void **state)
{
    (void)state;
    static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    static const int16_t own[2] = {16384,
                                   0}; /* the farther pane shines, by half with half through; the nearer is dark */
    const double right = ((1 * 0.5 + 0.5) * 0.5) * 255, naive = (1 * 0.5 * 0.5 + 0.5) * 255;
    assert_true(fabs(right - naive) > ORDER_CODES);
    double worst = 0;
    for (int order = 0; order < 6; order++) {
        panes p, q;
        panes_set_up(&p, 16384, own);
        panes_set_up(&q, 16384, own);
        for (int i = 0; i < 3; i++) {
            p.objects[i] = q.objects[orders[order][i]];
        }
        worst = worse_of(worst, expect_reference(&p.b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "panes"));
        for (int n = 0; n < FRAME_BACKENDS * HARD_SHADINGS; n++) {
            frame f = hard_draw(&p.b.scene, BOARD_PX, BOARD_PX, GLINT_RGB888, (uint8_t)(n / 2), n % 2);
            assert_true(fabs(f.pixels[3 * HARD_CENTRE] - right) <= HARD_CODES);
            frame_free(&f);
        }
    }
    hard_pass("I7", "transparent surfaces listed from near to far, or before what is behind them",
              text("in the order of the list: %.0f instead of %.0f", naive, right),
              text("the same in all 6 orders, within %.2f codes", worst));
}

/* A floor of two triangles that runs from beneath the eye to far away, where the near plane cuts it. */
static void floor_set_up(board *b)
{
    static const int16_t corner[4][2] = {{-20, 2}, {20, 2}, {20, -30}, {-20, -30}};
    board_set_up(b);
    for (int i = 0; i < 4; i++) {
        b->positions[i][0] = (int16_t)(corner[i][0] * BOARD_UNIT);
        b->positions[i][1] = (int16_t)(-1.5 * BOARD_UNIT);
        b->positions[i][2] = (int16_t)(corner[i][1] * BOARD_UNIT);
    }
    board_normals(b, 0, 16384, 0);
    b->camera.eye_q16[2] = 0;
    b->camera.target_q16[2] = BOARD_Q16(-5);
    b->camera.near_q16 = BOARD_Q16(0.5);
    b->material.diffuse = board_grey(16384);
    board_light(b, 0, 0, -1, 0);
}

typedef struct textured_board {
    board b;
    int16_t texcoords[4][2];
    glint_texture texture;
} textured_board;

static void take_texture(textured_board *t, const uint16_t *texels, uint16_t side, int16_t least, int16_t most)
{
    static const uint8_t corner[4][2] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    memset(&t->texture, 0, sizeof t->texture);
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 2; k++) {
            t->texcoords[i][k] = corner[i][k] ? most : least;
        }
    }
    t->texture.texels = texels;
    t->texture.width_px = t->texture.height_px = side;
    t->b.mesh.texcoords = (const int16_t(*)[2])t->texcoords;
    t->b.mesh.texcoord_bits = TEXCOORD_BITS;
    t->b.material.texture = &t->texture;
}

static void test_I8_texture_below_zero(void **state)
{
    (void)state;
    static const uint16_t texels[4] = {0xffff, 0x0000, 0x8410, 0x4208};
    enum { TILES = 4 };
    int naive = 0;
    double worst = 0;
    /* a row of pixels over -TILES..TILES textures of 4 texels: the column that (int) finds, and floor */
    for (int x = 0; x < BOARD_PX; x++) {
        const double u = ((x + 0.5) / BOARD_PX * 2 - 1) * TILES * 4;
        naive += abs((int)u % 4) != ((int)floor(u) % 4 + 4) % 4;
    }
    assert_true(naive > BOARD_PX / 4);
    for (int way = 0; way < 4; way++) {
        textured_board t;
        board_set_up(&t.b);
        t.b.material.diffuse = board_grey(16384);
        /* the board is 40 units wide, of which 10 are seen: -TILES..TILES over these */
        take_texture(&t, texels, 2, -4 * TILES * 512, 4 * TILES * 512 - 1);
        t.texture.width_px = 4;
        t.texture.height_px = 1;
        t.texture.wrap_u = way & 1 ? GLINT_CLAMP : GLINT_REPEAT;
        t.texture.filter = way & 2 ? GLINT_BILINEAR : GLINT_NEAREST;
        worst = worse_of(worst, expect_reference(&t.b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "tiles"));
    }
    hard_pass("I8", "texture coordinates below 0", text("(int) and %%: %d of %d columns wrong", naive, BOARD_PX),
              text("floor, repeated and clamped, nearest and bilinear: within %.2f codes", worst));
}

static void test_I9_perspective_of_a_texture(void **state)
{
    (void)state;
    enum { SIDE = 64, PX = 64 };
    static uint16_t texels[SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++) { /* broad ramps: 8 texels from black to white and back */
        const unsigned level = (unsigned)abs((i % SIDE) % 16 - 8) * 31 / 8,
                       other = (unsigned)abs(i / SIDE % 16 - 8) * 63 / 8;
        texels[i] = (uint16_t)(level << 11 | other << 5 | level);
    }
    /* the floor's texture row by row of the display, linear on the screen between the rows that see its ends */
    const double focal = PX / 2.0, near = focal * 1.5 / (PX / 2.0), far = 30;
    double naive = 0;
    for (int y = (int)(PX / 2 + focal * 1.5 / far) + 1; y < PX; y++) {
        const double depth = focal * 1.5 / (y + 0.5 - PX / 2.0);
        const double share = (y + 0.5 - (PX / 2.0 + focal * 1.5 / far)) / (PX / 2.0 - focal * 1.5 / far);
        naive = worse_of(naive, fabs((depth - (far + share * (near - far))) / 32 * SIDE));
    }
    assert_true(naive > AFFINE_TEXELS);
    textured_board t;
    floor_set_up(&t.b);
    take_texture(&t, texels, SIDE, 0, 512);
    t.texture.filter = GLINT_BILINEAR;
    double worst = expect_reference(&t.b.scene, PX, PX, GLINT_SHADING_EXACT, "floor");
    t.texture.filter = GLINT_NEAREST;
    worst = worse_of(worst, expect_reference(&t.b.scene, PX, PX, GLINT_SHADING_EXACT, "floor"));
    hard_pass("I9", "texture on a floor of two triangles that the near plane cuts",
              text("linear on the screen: %.0f texels of %d off", naive, SIDE),
              text("perspective-correct: within %.2f codes", worst));
}

static void test_I10_fog_over_a_long_triangle(void **state)
{
    (void)state;
    enum { PX = 64 };
    board b;
    floor_set_up(&b);
    b.material.diffuse = board_grey(0);
    b.scene.fog.colour = board_grey(16384);
    b.scene.fog.begin_q16 = BOARD_Q16(3);
    b.scene.fog.end_q16 = BOARD_Q16(9);
    /* by the corners, f = 0 and 1, and linear in space between */
    double naive = 0;
    for (int i = 0; i < 285; i++) {
        const double depth = 1.5 + i * 0.1;
        const double f = depth < 3 ? 0 : depth > 9 ? 1 : (depth - 3) / 6;
        naive = worse_of(naive, 255 * fabs(f - (depth + 2) / 32));
    }
    assert_true(naive > FOG_CODES);
    double worst = 0;
    for (uint8_t shading = 0; shading < HARD_SHADINGS; shading++) {
        worst = worse_of(worst, expect_reference(&b.scene, PX, PX, shading, "fog"));
    }
    hard_pass("I10", "fog that begins and ends within one triangle", text("by the corners: %.0f codes off", naive),
              text("by each pixel's depth, in every shading: within %.2f codes", worst));
}

/* A map's white share in a direction, bilinear, texels beyond the edge clamped to it. */
static double naive_lookup(const uint16_t *texels, int side, const double d[3])
{
    const double sum = fabs(d[0]) + fabs(d[1]) + fabs(d[2]), x = d[0] / sum, z = d[2] / sum;
    const double u = d[1] >= 0 ? x : copysign(1 - fabs(z), x), v = d[1] >= 0 ? z : copysign(1 - fabs(x), z);
    const double i = (u + 1) * side / 2 - 0.5, j = (v + 1) * side / 2 - 0.5;
    double all = 0;
    for (int n = 0; n < 4; n++) {
        const int column = (int)floor(i) + n % 2, row = (int)floor(j) + n / 2;
        const int c = column < 0       ? 0
                      : column >= side ? side - 1
                                       : column,
                  r = row < 0       ? 0
                      : row >= side ? side - 1
                                    : row;
        all += (1 - fabs(i - column)) * (1 - fabs(j - row)) * (texels[r * side + c] != 0);
    }
    return all;
}

static void test_I11_mirror_over_the_map_s_edge(void **state)
{
    (void)state;
    enum { SIDE = 8 };
    static uint16_t texels[SIDE * SIDE];
    for (int j = 0; j < SIDE; j++) {
        for (int i = 0; i < SIDE; i++) { /* white in one half of the corners, where directions are downwards */
            texels[j * SIDE + i] = i < SIDE / 2 ? 0xffff : 0;
        }
    }
    /* straight down is where all four corners meet; to the left and to the right of it */
    const double sides[2][3] = {{-0.001, -1, 0.3}, {0.001, -1, 0.3}};
    const double naive = 255 * fabs(naive_lookup(texels, SIDE, sides[0]) - naive_lookup(texels, SIDE, sides[1]));
    assert_true(naive > SEAM_CODES);
    const glint_environment around = {.texels = texels, .side = SIDE};
    double worst = 0;
    int step = 0;
    for (int turn = 0; turn < 8; turn++) {
        board b;
        board_set_up(&b);
        b.scene.light_count = 0;
        b.scene.environment = &around;
        b.material.mirror = board_grey(16384);
        /* normals half-way between the way to the eye and straight down: what is mirrored lies all about that */
        const double t = turn * 0.02;
        for (int i = 0; i < 4; i++) {
            const double x = t + (i == 1 || i == 2 ? 0.1 : -0.1);
            const double n[3] = {x, -1, 1}, length = sqrt(dot3(n, n));
            for (int k = 0; k < 3; k++) {
                b.normals[i][k] = (int16_t)lround(16384 * n[k] / length);
            }
        }
        worst = worse_of(worst, expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "fold"));
        frame f = board_draw(&b, GLINT_SHADING_EXACT, FRAME_FIXED);
        for (int i = 1; i < BOARD_PX; i++) {
            const int row = 3 * (BOARD_PX / 2 * BOARD_PX + i), one = abs(f.pixels[row] - f.pixels[row - 3]);
            step = one > step ? one : step;
        }
        frame_free(&f);
    }
    assert_true(step > 0 && step < SEAM_CODES);
    hard_pass("I11", "mirrored directions across the fold of the environment's map",
              text("texels beyond the edge clamped: a step of %.0f codes", naive),
              text("continuous, at most %d codes a pixel; within %.2f codes of the reference", step, worst));
}

static void test_I12_inside_of_a_surface(void **state)
{
    (void)state;
    board b;
    board_set_up(&b);
    b.material.diffuse = board_grey(16384);
    b.material.sides = GLINT_TWO_SIDED;
    board_light(&b, 0, 3000, 0, -4000);
    b.object.place = glint_turn_x(32768); /* its inside to the eye, and to the light */
    const double naive = 0, level = 0.8;
    for (uint8_t shading = 0; shading < HARD_SHADINGS; shading++) {
        expect_centre(&b, shading, level, "inside");
    }
    double worst = expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "inside");
    /* the near plane cuts it, so that which side is seen is told by its parts */
    b.camera.near_q16 = BOARD_Q16(5.5);
    b.camera.eye_q16[1] = BOARD_Q16(4);
    worst = worse_of(worst, expect_reference(&b.scene, BOARD_PX, BOARD_PX, GLINT_SHADING_EXACT, "inside, cut"));
    frame cut = hard_draw(&b.scene, BOARD_PX, BOARD_PX, GLINT_RGB888, GLINT_SHADING_EXACT, FRAME_FIXED);
    assert_true(cut.report.triangles_clipped > 0 && cut.report.pixels_shaded > 0);
    frame_free(&cut);
    b.material.sides = GLINT_FRONT_SIDE;
    frame f = hard_draw(&b.scene, BOARD_PX, BOARD_PX, GLINT_RGB888, GLINT_SHADING_EXACT, FRAME_FIXED);
    assert_int_equal(f.report.pixels_shaded, 0);
    frame_free(&f);
    hard_pass("I12", "inside of a surface, lit from there", text("by the stored normal: %.0f codes", naive),
              text("the normal is taken the other way round: %.0f, within %.2f codes", 255 * level, worst));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        hard_test(test_I6_layers_at_the_edges_of_bands), hard_test(test_I7_panes_in_any_order),
        hard_test(test_I8_texture_below_zero),           hard_test(test_I9_perspective_of_a_texture),
        hard_test(test_I10_fog_over_a_long_triangle),    hard_test(test_I11_mirror_over_the_map_s_edge),
        hard_test(test_I12_inside_of_a_surface),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
