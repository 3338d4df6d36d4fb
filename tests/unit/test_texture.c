/* SPDX-License-Identifier: MIT */
/*
 * Textures: the coordinates of pixels in random triangles against perspective-correct ones in long double, the colours
 * of both filters against <glint/texture.h>, and what is promised for them.
 */
#include "effects/texture.h"

#include "tests/unit/numeric.h"

#include "geometry/view.h"

/* Budgets, as stated in src/effects/texture.h. In Q22: */
#define COORDINATE_ROUNDING 0.5L
#define COORDINATE_OF_RANGE exp2l(-26) /* of half the corners' range */
#define MOVED exp2l(-28.3L)            /* a pixel's centre, of its distance from the first corner */
#define SLIVER_OF_RANGE exp2l(-24)     /* times the corners' ratio of depths: clamped barycentric coordinates */
/* In Q15: */
#define NEAREST_ERROR 0.51L
#define BILINEAR_ERROR 1.1L
#define BILINEAR_WEIGHTS exp2l(-13) /* of the contrast: 2^-14 of either axis */

#define ROUNDS 300000
#define MOST_PX 2048

typedef struct drawn {
    glint_screen_vertex vertex[3];
    int32_t texcoord_q22[3][2];
    uint8_t order[3];
    glint_gradients gradients;
    glint_texture_map map;
} drawn;

static int32_t any_coordinate(int32_t size_px, int32_t beyond_px)
{
    return random_between(-beyond_px * GLINT_FINE, (size_px + beyond_px) * GLINT_FINE);
}

/* Any size, depths near together and far apart, texture coordinates of any range. False: turned away, or flat. */
static bool any_triangle(drawn *t, const glint_texture *texture, bool thin)
{
    const glint_screen_vertex *corner[3];
    const int32_t size_px = 1 << random_between(2, 11), near = random_between(6, 29);
    const int spread = random_between(0, 9), bits = random_between(3, 28);
    for (int i = 0; i < 3; i++) {
        t->vertex[i].x = any_coordinate(size_px, size_px / 2);
        t->vertex[i].y = any_coordinate(thin ? 0 : size_px, thin ? 1 : size_px / 2);
        const int32_t most = (int32_t)1 << near;
        t->vertex[i].depth_q30 =
            GLINT_DEPTH_BIAS + random_between((most >> spread) > 0 ? most >> spread : 1, most > 1 ? most - 1 : 1);
        for (int k = 0; k < 2; k++) {
            t->texcoord_q22[i][k] = random_between(-((int32_t)1 << bits), (int32_t)1 << bits);
        }
    }
    const int64_t area = (int64_t)(t->vertex[1].x - t->vertex[0].x) * (t->vertex[2].y - t->vertex[0].y) -
                         (int64_t)(t->vertex[1].y - t->vertex[0].y) * (t->vertex[2].x - t->vertex[0].x);
    t->order[0] = 0;
    t->order[1] = area > 0 ? 1 : 2;
    t->order[2] = area > 0 ? 2 : 1;
    for (int i = 0; i < 3; i++) {
        corner[i] = &t->vertex[i];
    }
    if (area == 0) {
        return false;
    }
    glint_gradients_set_up(&t->gradients, corner, t->order);
    glint_texture_map_set_up(&t->map, texture, &t->gradients, t->texcoord_q22, t->order, false);
    return true;
}

/* Perspective-correct texture coordinates at a point of the screen in 1/4096 px, Q22; false outside of the triangle. */
static bool exact_at(const drawn *t, long double x, long double y, long double uv[2])
{
    long double b[3], sum = 0;
    bool inside = true;
    for (int i = 0; i < 3; i++) {
        const glint_screen_vertex *const from = &t->vertex[(i + 1) % 3], *const to = &t->vertex[(i + 2) % 3];
        b[i] = ((long double)to->x - from->x) * (y - from->y) - ((long double)to->y - from->y) * (x - from->x);
        sum += b[i];
    }
    uv[0] = uv[1] = 0;
    long double weights = 0;
    for (int i = 0; i < 3; i++) {
        inside = inside && b[i] / sum >= 0;
        const long double weight = b[i] / sum * (t->vertex[i].depth_q30 - GLINT_DEPTH_BIAS);
        weights += weight;
        uv[0] += weight * t->texcoord_q22[i][0];
        uv[1] += weight * t->texcoord_q22[i][1];
    }
    uv[0] /= weights;
    uv[1] /= weights;
    return inside;
}

/* A pixel near a random point of the triangle. */
static void any_pixel(const drawn *t, int16_t *x, int16_t *y)
{
    long double b0 = random_unit(), b1 = random_unit();
    if (b0 + b1 > 1) {
        b0 = 1 - b0;
        b1 = 1 - b1;
    }
    const long double at_x = b0 * t->vertex[0].x + b1 * t->vertex[1].x + (1 - b0 - b1) * t->vertex[2].x;
    const long double at_y = b0 * t->vertex[0].y + b1 * t->vertex[1].y + (1 - b0 - b1) * t->vertex[2].y;
    *x = (int16_t)floorl(at_x / GLINT_FINE);
    *y = (int16_t)floorl(at_y / GLINT_FINE);
}

static long double half_range(const drawn *t, int k)
{
    int32_t low = t->texcoord_q22[0][k], high = low;
    for (int i = 1; i < 3; i++) {
        low = t->texcoord_q22[i][k] < low ? t->texcoord_q22[i][k] : low;
        high = t->texcoord_q22[i][k] > high ? t->texcoord_q22[i][k] : high;
    }
    return (high - (long double)low) / 2;
}

static long double depth_ratio(const drawn *t)
{
    int32_t low = INT32_MAX, high = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t depth = t->vertex[i].depth_q30 - GLINT_DEPTH_BIAS;
        low = depth < low ? depth : low;
        high = depth > high ? depth : high;
    }
    return (long double)high / low;
}

static const uint16_t grey_texel[1] = {0x8410};
static const glint_texture one_texel = {.texels = grey_texel, .width_px = 1, .height_px = 1};

static void test_coordinates(void **state)
{
    (void)state;
    static drawn t;
    long double worst = 0, worst_wide = 0, worst_sliver = 0;
    long seen = 0, slivers = 0, steep = 0;
    for (int round = 0; round < ROUNDS; round++) {
        int16_t x, y;
        long double exact[2], beside[2], below[2];
        int32_t found[1][2];
        if (!any_triangle(&t, &one_texel, round % 8 == 0)) {
            continue;
        }
        any_pixel(&t, &x, &y);
        const long double at_x = (x + 0.5L) * GLINT_FINE, at_y = (y + 0.5L) * GLINT_FINE;
        if (x < 0 || y < 0 || x >= MOST_PX || y >= MOST_PX || !exact_at(&t, at_x, at_y, exact)) {
            continue;
        }
        (void)exact_at(&t, at_x + 1, at_y, beside);
        (void)exact_at(&t, at_x, at_y + 1, below);
        glint_texture_coordinates(&t.map, x, y, 1, found);
        const glint_screen_vertex *const first = t.gradients.corner[0];
        const long double way = fabsl(at_x - first->x) + fabsl(at_y - first->y);
        for (int k = 0; k < 2; k++) {
            const long double error = fabsl(found[0][k] - exact[k]), half = half_range(&t, k);
            if (t.gradients.sliver) {
                worst_sliver = worse(worst_sliver, error / (1 + half * SLIVER_OF_RANGE * depth_ratio(&t)));
                continue;
            }
            const long double moved = (fabsl(beside[k] - exact[k]) + fabsl(below[k] - exact[k])) * way * MOVED;
            const long double of_range = half * COORDINATE_OF_RANGE;
            worst = worse(worst, error / (COORDINATE_ROUNDING + of_range + moved));
            if (of_range > 2 * moved && of_range > 2) {
                worst_wide = worse(worst_wide, (error - COORDINATE_ROUNDING - moved) / of_range);
            }
        }
        seen++;
        slivers += t.gradients.sliver;
        steep += t.map.steep;
    }
    print_message("%ld pixels, %ld of slivers, %ld with depths far apart\n", seen, slivers, steep);
    expect_bound("coordinate, of its budget", worst, 1);
    expect_at_most("the part that goes with the corners' range", worst_wide, 1); /* derived, not found */
    assert_true(worst_wide > 0.3L);
    expect_at_most("coordinate in a sliver, of its budget", worst_sliver, 1);
    assert_true(seen > ROUNDS / 8 && slivers > 1000 && steep > 1000);
}

/* The same wherever a row begins; and within the corners' range, outside of the triangle too. */
static void test_rows(void **state)
{
    (void)state;
    static drawn t;
    for (int round = 0; round < ROUNDS / 10; round++) {
        int16_t x, y;
        int32_t row[16][2], one[1][2];
        if (!any_triangle(&t, &one_texel, round % 4 == 0)) {
            continue;
        }
        any_pixel(&t, &x, &y);
        if (x < 0 || y < 0 || x >= MOST_PX - 16 || y >= MOST_PX) {
            continue;
        }
        glint_texture_coordinates(&t.map, x, y, 16, row);
        for (int i = 0; i < 16; i++) {
            glint_texture_coordinates(&t.map, (int16_t)(x + i), y, 1, one);
            for (int k = 0; k < 2; k++) {
                assert_int_equal(row[i][k], one[0][k]);
                const long double middle = t.map.axis[k].middle_q22, half = half_range(&t, k);
                assert_true(fabsl(row[i][k] - middle) <= half + 1);
            }
        }
    }
}

/* ---- colours ---- */

static uint16_t texels[1024 * 4];
static uint8_t numbers[1024 * 4];
static uint16_t palette[GLINT_MAX_PALETTE];

static glint_texture any_texture(void)
{
    glint_texture t = {.texels = texels, .palette = palette, .palette_count = (uint16_t)random_between(1, 256)};
    const bool upright = random_u32() & 1;
    const int32_t along = random_u32() & 1 ? 1 << random_between(0, 10) : random_between(1, 1024);
    t.width_px = (uint16_t)(upright ? random_between(1, 4) : along);
    t.height_px = (uint16_t)(upright ? along : random_between(1, 4));
    t.format = random_u32() & 1;
    t.filter = random_u32() & 1;
    t.wrap_u = random_u32() & 1;
    t.wrap_v = random_u32() & 1;
    for (size_t i = 0; i < sizeof texels / sizeof *texels; i++) {
        texels[i] = random_u32() & 1 ? (uint16_t)random_u32() : random_u32() & 1 ? 0xffff : 0;
        numbers[i] = (uint8_t)random_u32();
    }
    for (int i = 0; i < GLINT_MAX_PALETTE; i++) {
        palette[i] = i < t.palette_count ? (uint16_t)random_u32() : 0x1234; /* beyond the last there is none */
    }
    if (t.format == GLINT_TEXTURE_PALETTE8) {
        t.texels = numbers;
    }
    return t;
}

static long wrapped(long i, long size, uint8_t wrap)
{
    return wrap == GLINT_CLAMP ? (i < 0 ? 0 : i >= size ? size - 1 : i) : ((i % size) + size) % size;
}

static void texel_of(const glint_texture *t, long i, long j, long double rgb[3])
{
    const size_t at = (size_t)(wrapped(j, t->height_px, t->wrap_v) * t->width_px + wrapped(i, t->width_px, t->wrap_u));
    const unsigned number = numbers[at], last = t->palette_count - 1u;
    const unsigned k = t->format == GLINT_TEXTURE_RGB565 ? texels[at] : palette[number < last ? number : last];
    rgb[0] = (k >> 11) / 31.0L;
    rgb[1] = (k >> 5 & 63) / 63.0L;
    rgb[2] = (k & 31) / 31.0L;
}

/* By the header, at (u, v) in Q22. */
static void exact_sample(const glint_texture *t, const long double uv_q22[2], long double rgb[3])
{
    long double x = uv_q22[0] * t->width_px / 4194304, y = uv_q22[1] * t->height_px / 4194304;
    if (t->filter == GLINT_NEAREST) {
        texel_of(t, (long)floorl(x), (long)floorl(y), rgb);
        return;
    }
    x -= 0.5L;
    y -= 0.5L;
    const long i = (long)floorl(x), j = (long)floorl(y);
    const long double s = x - i, r = y - j;
    long double a[3], b[3], c[3], d[3];
    texel_of(t, i, j, a);
    texel_of(t, i + 1, j, b);
    texel_of(t, i, j + 1, c);
    texel_of(t, i + 1, j + 1, d);
    for (int k = 0; k < 3; k++) {
        rgb[k] = (1 - r) * ((1 - s) * a[k] + s * b[k]) + r * ((1 - s) * c[k] + s * d[k]);
    }
}

static void test_colours(void **state)
{
    (void)state;
    long double nearest = 0, bilinear = 0;
    for (int round = 0; round < 400; round++) {
        const glint_texture t = any_texture();
        for (int i = 0; i < 500; i++) {
            int32_t uv[2];
            long double exact_uv[2], rgb[3];
            glint_texel texel;
            for (int k = 0; k < 2; k++) {
                uv[k] = random_u32() & 1 ? random_between(-10, (1 << 22) + 10) : random_any_size(29);
                /* on the edges of texels and between their centres */
                const int32_t size = k == 0 ? t.width_px : t.height_px;
                uv[k] = random_u32() % 4
                            ? uv[k]
                            : (int32_t)((int64_t)random_between(-1, 2 * size + 1) * ((int32_t)1 << 21) / size) +
                                  random_between(-1, 1);
                exact_uv[k] = uv[k];
            }
            glint_texture_sample(&t, uv, &texel);
            exact_sample(&t, exact_uv, rgb);
            for (int k = 0; k < 3; k++) {
                const long double error = fabsl(texel.q15[k] - 32768 * rgb[k]);
                assert_true(texel.q15[k] <= 32768);
                if (t.filter == GLINT_NEAREST) {
                    nearest = worse(nearest, error);
                } else {
                    bilinear = worse(bilinear, error / (BILINEAR_ERROR + 32768 * BILINEAR_WEIGHTS));
                }
            }
        }
    }
    expect_bound("nearest, Q15", nearest, NEAREST_ERROR);
    expect_bound("bilinear, of its budget", bilinear, 1);
}

/* 0 stays 0, the greatest is 1, and equal texels give their own colour whatever the weights; so do texels of which one
 * differs and has no weight, but for the filter's rounding. */
static void test_even_colours(void **state)
{
    (void)state;
    for (unsigned k = 0; k < 65536; k++) {
        const uint16_t colour[4] = {(uint16_t)k, (uint16_t)k, (uint16_t)k, (uint16_t)k};
        glint_texture t = {.texels = colour, .width_px = 2, .height_px = 2};
        const int32_t uv[2] = {(int32_t)random_u32() >> 4, (int32_t)random_u32() >> 4};
        glint_texel plain, filtered;
        glint_texture_sample(&t, uv, &plain);
        t.filter = GLINT_BILINEAR;
        glint_texture_sample(&t, uv, &filtered);
        const uint32_t channel[3] = {k >> 11, k >> 5 & 63, k & 31}, most[3] = {31, 63, 31};
        for (int c = 0; c < 3; c++) {
            assert_int_equal(plain.q15[c], filtered.q15[c]);
            if (channel[c] == 0 || channel[c] == most[c]) {
                assert_int_equal(plain.q15[c], channel[c] == 0 ? 0 : 32768);
            }
        }
        const uint16_t two[2] = {(uint16_t)k, (uint16_t)~k};
        const glint_texture row = {.texels = two, .width_px = 2, .height_px = 1, .filter = GLINT_BILINEAR};
        const int32_t centre[2] = {1 << 20, 0};
        glint_texture_sample(&row, centre, &filtered);
        for (int c = 0; c < 3; c++) {
            assert_true(abs(plain.q15[c] - filtered.q15[c]) <= 1);
            assert_true((channel[c] != 0 && channel[c] != most[c]) || filtered.q15[c] == plain.q15[c]);
        }
    }
}

/* Where the texels of a 3 x 2 picture lie: the conventions of the header, in numbers. */
static void test_conventions(void **state)
{
    (void)state;
    static const uint16_t row[6] = {0xf800, 0x07e0, 0x001f, 0, 0xffff, 0};
    glint_texture t = {.texels = row, .width_px = 3, .height_px = 2};
    glint_texel texel;
    const int32_t third = (1 << 22) / 3, one = 1 << 22;
    static const struct {
        int32_t u, v;
        uint8_t wrap;
        uint16_t rgb[3];
    } cases[] = {
        {0, 0, GLINT_REPEAT, {32768, 0, 0}},                       /* the first texel of the first row */
        {third + 1, 0, GLINT_REPEAT, {0, 32768, 0}},               /* u goes along the row */
        {third + 1, one / 2, GLINT_REPEAT, {32768, 32768, 32768}}, /* v from row to row */
        {third + 1, one / 2 - 1, GLINT_REPEAT, {0, 32768, 0}},     /* and a texel has its first edge, not its last */
        {one, 0, GLINT_REPEAT, {32768, 0, 0}},                     /* u = 1 is the next tile, */
        {one, 0, GLINT_CLAMP, {0, 0, 32768}},                      /* or still the last texel */
        {-1, 0, GLINT_REPEAT, {0, 0, 32768}},                      /* left of 0 */
        {-5 * one, 0, GLINT_CLAMP, {32768, 0, 0}},                 /* far left */
        {-5 * one + third + 1, 0, GLINT_REPEAT, {0, 32768, 0}},    /* five tiles to the left */
        {third + 1, 3 * one, GLINT_CLAMP, {32768, 32768, 32768}},  /* below the last row */
        {third + 1, 3 * one, GLINT_REPEAT, {0, 32768, 0}},         /* a tile's first row again */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const int32_t uv[2] = {cases[i].u, cases[i].v};
        t.wrap_u = t.wrap_v = cases[i].wrap;
        glint_texture_sample(&t, uv, &texel);
        assert_memory_equal(texel.q15, cases[i].rgb, sizeof texel.q15);
    }
    /* bilinear: at a centre the texel itself, half way to the next the mean, beyond the edge by the wrapping */
    t.filter = GLINT_BILINEAR;
    t.wrap_u = t.wrap_v = GLINT_CLAMP;
    const int32_t centre[2] = {third / 2, one / 4}, between[2] = {third, one / 4}, edge[2] = {0, one / 4};
    glint_texture_sample(&t, centre, &texel);
    assert_in_range(texel.q15[0], 32760, 32768);
    glint_texture_sample(&t, between, &texel);
    assert_in_range(texel.q15[0], 16380, 16388);
    assert_in_range(texel.q15[1], 16380, 16388);
    glint_texture_sample(&t, edge, &texel);
    assert_int_equal(texel.q15[0], 32768);
    t.wrap_u = GLINT_REPEAT;
    glint_texture_sample(&t, edge, &texel); /* half red, half the blue of the tile on the left */
    assert_in_range(texel.q15[0], 16380, 16388);
    assert_in_range(texel.q15[2], 16380, 16388);
}

/* A number beyond the palette's end has its last colour. */
static void test_palette_end(void **state)
{
    (void)state;
    static const uint8_t number[3] = {1, 2, 255};
    static const uint16_t colours[2] = {0x001f, 0xf800};
    const glint_texture t = {.texels = number,
                             .palette = colours,
                             .palette_count = 2,
                             .width_px = 3,
                             .height_px = 1,
                             .format = GLINT_TEXTURE_PALETTE8};
    for (int i = 0; i < 3; i++) {
        const int32_t uv[2] = {(1 << 22) / 3 * i + 10, 0};
        glint_texel texel;
        glint_texture_sample(&t, uv, &texel);
        assert_int_equal(texel.q15[0], 32768);
        assert_int_equal(texel.q15[2], 0);
    }
}

/* What is promised for a bilinear texture: the colour at the exact coordinates, of light as bright as 1. */
static void test_promise(void **state)
{
    (void)state;
    static drawn t;
    long double worst = 0;
    long seen = 0, within = 0;
    for (int round = 0; round < 3000; round++) {
        glint_texture texture = any_texture();
        texture.filter = GLINT_BILINEAR;
        for (int i = 0; i < 40; i++) {
            int16_t x, y;
            int32_t found[1][2];
            long double exact[2], moved[2], rgb[3];
            glint_texel texel;
            if (!any_triangle(&t, &texture, false) || t.gradients.sliver) {
                continue;
            }
            any_pixel(&t, &x, &y);
            const long double at_x = (x + 0.5L) * GLINT_FINE, at_y = (y + 0.5L) * GLINT_FINE;
            if (x < 0 || y < 0 || x >= MOST_PX || y >= MOST_PX || !exact_at(&t, at_x, at_y, exact)) {
                continue;
            }
            /* what moving by 2^-12 px changes is not promised: here by what the gradients' error moves */
            (void)exact_at(&t, at_x + 0.1L, at_y + 0.1L, moved);
            const uint32_t one_q8 = 255 * 256;
            const long double promised = glint_texture_error_q8(&t.map, one_q8) + 4; /* and the colour's rounding */
            long double slack = 0;
            for (int k = 0; k < 2; k++) {
                const long double size = k == 0 ? texture.width_px : texture.height_px;
                slack += fabsl(moved[k] - exact[k]) * size / 4194304 * one_q8;
            }
            glint_texture_coordinates(&t.map, x, y, 1, found);
            glint_texture_sample(&texture, found[0], &texel);
            exact_sample(&texture, exact, rgb);
            for (int k = 0; k < 3; k++) {
                const long double error = fabsl(texel.q15[k] / 32768.0L - rgb[k]) * one_q8;
                worst = worse(worst, error / (promised + slack));
            }
            seen++;
            within += promised < 64;
        }
    }
    print_message("%ld pixels, %ld of them promised within a quarter of a code\n", seen, within);
    expect_at_most("bilinear colour, of the promise", worst, 1);
    assert_true(worst > 0.2L && seen > 10000 && within > seen / 8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(test_coordinates),  numeric_test(test_rows),        numeric_test(test_colours),
        numeric_test(test_even_colours), numeric_test(test_conventions), numeric_test(test_palette_end),
        numeric_test(test_promise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
