/* SPDX-License-Identifier: MIT */
/*
 * Mirrors against <glint/scene.h> in long double: the direction r, the map's place for it, its continuity over the
 * octahedron's edges, and what an error of the direction comes to (lighting/mirror.h).
 *
 * A test file defines the budgets, `random_real(v, out)`, which makes a vector of the backend's numbers and says what
 * it is after rounding, and `colour_of(mirror, d, rgb)`.
 */
#include <stdio.h>

#define ROUNDS 200000
#define SIDE_MOST 128

typedef struct environment_case {
    uint16_t texels[SIDE_MOST * SIDE_MOST];
    glint_environment map;
    light_mirror mirror;
    glint_frame frame;
} environment_case;

/* Any colours, or a slope in each. */
static void case_set_up(environment_case *c, uint8_t side, bool noise)
{
    static const glint_colour white = {16384, 16384, 16384};
    for (int j = 0; j < side; j++) {
        for (int i = 0; i < side; i++) {
            c->texels[j * side + i] = (uint16_t)random_u32();
            if (!noise) {
                c->texels[j * side + i] =
                    (uint16_t)(((i * 31 / side) << 11) | ((j * 63 / side) << 5) | ((i + j) * 15 / side));
            }
        }
    }
    c->map.texels = c->texels;
    c->map.side = side;
    c->map.steepest = 0;
    /* a turn about a random axis: the rows of an orthonormal matrix */
    long double row[3][3];
    random_direction(row[0]);
    random_direction(row[2]);
    cross_product(row[0], row[2], row[1]);
    (void)normalise(row[1]);
    cross_product(row[0], row[1], row[2]);
    memset(&c->frame, 0, sizeof c->frame);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            c->frame.from_world_q30[i][k] = (int32_t)lrintl(row[i][k] * 1073741824.0L);
        }
    }
    light_mirror_set_up(&c->mirror, &c->map, &white, &c->frame);
}

/* Directions with zeros, ties and components of very different size too. */
static void any_direction(long double out[3])
{
    random_direction(out);
    const uint32_t how = random_u32();
    for (int k = 0; k < 3; k++) {
        if (how % 5 == 0 && (how >> 8 >> k & 1)) {
            out[k] = 0;
        } else if (how % 5 == 1 && (how >> 8 >> k & 1)) {
            out[k] *= exp2l(-20 * random_unit());
        }
    }
    out[0] = dot(out, out) > 0 ? out[0] : 1;
    (void)normalise(out);
}

/* The angle between r of the model and what the backend makes of it. */
static void test_direction(void **state)
{
    (void)state;
    static environment_case c;
    long double worst = 0;
    for (int round = 0; round < ROUNDS; round++) {
        long double n[3], v[3], r[3], got[3], cosine, apart = 0;
        real normal[3], ray[3], d[3];
        if (round % 1000 == 0) {
            case_set_up(&c, 8, true);
        }
        any_direction(n);
        any_direction(v);
        random_real(n, normal);
        random_real(v, ray);
        (void)normalise(n);
        (void)normalise(v);
        mirror_direction(&c.mirror, normal, ray, d);
        cosine = dot(n, v);
        for (int i = 0; i < 3; i++) {
            r[i] = 0;
            for (int k = 0; k < 3; k++) {
                r[i] += (v[k] - 2 * cosine * n[k]) * c.frame.from_world_q30[k][i] / 1073741824.0L;
            }
            got[i] = (long double)d[i];
        }
        (void)normalise(r);
        assert_true(normalise(got) > 0);
        for (int k = 0; k < 3; k++) {
            apart += (r[k] - got[k]) * (r[k] - got[k]);
        }
        worst = worse(worst, sqrtl(apart));
    }
    expect_bound("direction of a mirrored ray, radians", worst, DIRECTION_ERROR);
}

/* E by the header's formulas. */
static void exact_colour(const glint_environment *map, const long double d[3], long double rgb[3])
{
    const long double sum = fabsl(d[0]) + fabsl(d[1]) + fabsl(d[2]);
    long double u = d[0] / sum, v = d[2] / sum;
    if (d[1] < 0) {
        const long double x = (1 - fabsl(v)) * copysignl(1, u);
        v = (1 - fabsl(u)) * copysignl(1, v);
        u = x;
    }
    const long double x = (u + 1) / 2 * map->side - 0.5L, y = (v + 1) / 2 * map->side - 0.5L;
    rgb[0] = rgb[1] = rgb[2] = 0;
    for (int corner = 0; corner < 4; corner++) {
        int i = (int)floorl(x) + (corner & 1), j = (int)floorl(y) + (corner >> 1);
        const long double weight = (1 - fabsl(x - i)) * (1 - fabsl(y - j));
        if (i < 0 || i >= map->side) {
            i = i < 0 ? 0 : map->side - 1;
            j = map->side - 1 - j;
        }
        if (j < 0 || j >= map->side) {
            j = j < 0 ? 0 : map->side - 1;
            i = map->side - 1 - i;
        }
        const uint16_t texel = map->texels[j * map->side + i];
        rgb[0] += weight * (texel >> 11) / 31;
        rgb[1] += weight * (texel >> 5 & 63) / 63;
        rgb[2] += weight * (texel & 31) / 31;
    }
}

static void test_map(void **state)
{
    (void)state;
    static environment_case c;
    for (uint8_t side = 8; side != 0 && side <= SIDE_MOST; side = (uint8_t)(side * 2)) {
        long double worst = 0;
        for (int round = 0; round < ROUNDS / 4; round++) {
            long double d[3], exact[3], got[3];
            real to[3];
            if (round % 1000 == 0) {
                case_set_up(&c, side, round & 1000);
            }
            any_direction(d);
            random_real(d, to);
            exact_colour(&c.map, d, exact);
            colour_of(&c.mirror, to, got);
            for (int k = 0; k < 3; k++) {
                worst = worse(worst, fabsl(exact[k] - got[k]));
            }
        }
        /* noise: neighbours differ by up to 1, so this is the place's error in texels, both ways, and a channel's */
        printf("side %d: ", side);
        expect_at_most("a channel, of 1", worst, PLACE_ERROR(side) + CHANNEL_ERROR);
        assert_true(worst > (PLACE_ERROR(side) + CHANNEL_ERROR) / 4);
    }
}

/* Two directions close to each other, many across an edge of the octahedron, show nearly the same; and how far apart
 * their places may be for an angle, over what lighting/mirror.h says. */
static void test_continuity(void **state)
{
    (void)state;
    static environment_case c;
    const long double angle = 1e-3L;
    long double worst = 0;
    case_set_up(&c, 64, true);
    for (int round = 0; round < ROUNDS; round++) {
        long double d[3], e[3], aside[3], a[3], b[3];
        any_direction(d);
        if (round & 1) { /* at an edge, or a corner */
            d[random_between(0, 2)] *= 0.5e-3L;
            d[random_between(0, 2)] *= 0.5e-3L;
        }
        (void)normalise(d);
        random_direction(aside);
        for (int k = 0; k < 3; k++) {
            e[k] = d[k] + angle * aside[k];
        }
        exact_colour(&c.map, d, a);
        exact_colour(&c.map, e, b);
        for (int k = 0; k < 3; k++) {
            worst = worse(worst, fabsl(a[k] - b[k]));
        }
    }
    /* of neighbours that differ by 1 */
    expect_bound("change of a colour over what the angle allows", worst / (angle * sqrtl(5) / 2 * 64), 1.01L);
}

/* glint_mirror_error_q8() in real numbers. */
static void test_error(void **state)
{
    (void)state;
    for (int round = 0; round < 10000; round++) {
        const glint_environment map = {.side = (uint8_t)(8 << random_between(0, 4)),
                                       .steepest = (uint8_t)random_between(0, 255)};
        const glint_colour colour = {(int16_t)random_between(0, 16384), (int16_t)random_between(0, 16384), 77};
        const int strongest = colour.r_q14 > colour.g_q14 ? colour.r_q14 : colour.g_q14;
        const long double texels = map.side * 2.4e-4L * sqrtl(5) / 2 + 2 * exp2l(-13);
        const long double q8 =
            256 * texels * (map.steepest ? map.steepest : 255) * (strongest > 77 ? strongest : 77) / 16384.0L;
        const uint32_t stated = glint_mirror_error_q8(&map, &colour);
        assert_true(stated >= q8 && stated <= 1.01L * q8 + 3);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(test_direction),
        numeric_test(test_map),
        numeric_test(test_continuity),
        numeric_test(test_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
