/* SPDX-License-Identifier: MIT */
/*
 * Ramps of colours: which scenes they serve, and each entry against the colour in long double.
 */
#include "tests/unit/numeric.h"

#include <string.h>

#include <glint/display.h>
#include <glint/scene.h>

#include "lighting/ramp.h"

/* Budgets, as lighting/ramp.h states them; an entry is the middle of its step, and rounded to Q15. */
#define SHARE_ULP 0.51L /* of Q15: rounding to nearest, and the reciprocal */
#define ENTRY_Q15 0.6L  /* rounding of an entry to Q15, and of base and step at the last of them */
#define UNITS_OF_Q15 (255 * 256 / 32768.0L)
#define LEAST_FULL_Q15 65 /* a light: dimmer ones would be rounded too coarsely */
#define MOST_LIGHTS 6

typedef struct ramp_case {
    glint_light lights[MOST_LIGHTS];
    glint_material material;
    glint_scene scene;
    glint_ramp ramp;
    long double light[MOST_LIGHTS][3], diffuse[3], specular[3], ambient[3]; /* ambient: by its light */
} ramp_case;

static void real_of(const glint_colour *colour, long double out[3])
{
    out[0] = colour->r_q14 / 16384.0L;
    out[1] = colour->g_q14 / 16384.0L;
    out[2] = colour->b_q14 / 16384.0L;
}

static glint_colour random_colour(int32_t most)
{
    const glint_colour colour = {(int16_t)random_between(0, most), (int16_t)random_between(0, most),
                                 (int16_t)random_between(0, most)};
    return random_u32() % 8 ? colour : (glint_colour){colour.r_q14, 0, 0};
}

static glint_colour times(glint_colour colour, int32_t factor)
{
    const glint_colour product = {(int16_t)(colour.r_q14 * factor), (int16_t)(colour.g_q14 * factor),
                                  (int16_t)(colour.b_q14 * factor)};
    return product;
}

static glint_colour near(glint_colour colour, long double factor, int off)
{
    const int16_t c[3] = {colour.r_q14, colour.g_q14, colour.b_q14};
    int16_t out[3];
    for (int k = 0; k < 3; k++) {
        const long double v = rintl(c[k] * factor) + random_between(-off, off);
        out[k] = (int16_t)(v < 0 ? 0 : v > 16384 ? 16384 : v);
    }
    return (glint_colour){out[0], out[1], out[2]};
}

/* Lights that are whole multiples of one colour, some of them black; materials whose specular colour is that of the
 * diffuse one but for a few units, or any. */
static void random_ramp(ramp_case *c, int round)
{
    const glint_colour common = random_colour(32767 / 8);
    memset(c, 0, sizeof *c);
    c->scene.lights = c->lights;
    c->scene.light_count = (uint16_t)random_between(1, MOST_LIGHTS);
    for (uint16_t i = 0; i < c->scene.light_count; i++) {
        c->lights[i].colour = times(common, random_between(round & 1 ? 0 : 1, round & 2 ? 2 : 8));
        real_of(&c->lights[i].colour, c->light[i]);
    }
    c->scene.ambient = random_colour(32767);
    c->material.ambient = random_colour(16384);
    c->material.diffuse = random_colour(random_u32() & 1 ? 16384 : 4000);
    c->material.specular =
        round & 4 ? near(c->material.diffuse, random_unit() * 2, random_between(0, 3)) : random_colour(16384);
    glint_ramp_set_up(&c->ramp, &c->scene, &c->material);
    long double ambient[3];
    real_of(&c->material.diffuse, c->diffuse);
    real_of(&c->material.specular, c->specular);
    real_of(&c->material.ambient, c->ambient);
    real_of(&c->scene.ambient, ambient);
    for (int k = 0; k < 3; k++) {
        c->ambient[k] *= ambient[k];
    }
}

/* Intensity times reflectance in Q15 as the renderer rounds it. */
static uint32_t product_q15(long double reflectance, long double intensity)
{
    return (uint32_t)floorl(reflectance * intensity * 32768 + 0.5L);
}

/* The colour as the ramp has it and in real numbers, for random cosines and specular factors. Returns the greatest
 * error in 1/256 code beyond that of the clamp. */
static long double colour_error(const ramp_case *c)
{
    const glint_ramp *ramp = &c->ramp;
    long double t = 0, real[3], worst = 0;
    memcpy(real, c->ambient, sizeof real);
    for (uint16_t i = 0; i < c->scene.light_count; i++) {
        const long double cosine = random_u32() % 4 ? random_unit() : random_u32() & 1,
                          factor = ramp->specular && random_u32() & 1 ? random_unit() * cosine : 0;
        const int k = ramp->channel;
        const uint16_t diffuse = glint_ramp_share_q15(ramp, product_q15(c->diffuse[k], c->light[i][k])),
                       specular = glint_ramp_share_q15(ramp, product_q15(c->specular[k], c->light[i][k]));
        t += cosine * diffuse + factor * specular;
        for (int n = 0; n < 3; n++) {
            real[n] += c->light[i][n] * (c->diffuse[n] * cosine + c->specular[n] * factor);
        }
    }
    const glint_shade shade = glint_ramp_colour(ramp, (uint32_t)(t * GLINT_RAMP_ENTRIES / 32768));
    const uint16_t got[3] = {shade.r_q15, shade.g_q15, shade.b_q15};
    for (int n = 0; n < 3; n++) {
        worst = worse(worst, fabsl(got[n] / 32768.0L - fminl(real[n], 1)) * 255 * 256);
    }
    return worst;
}

static void colours_err_by_what_is_stated(void **state)
{
    long double worst = 0, fullest = 0;
    long usable = 0, specular = 0;
    (void)state;
    for (int round = 0; round < 100000; round++) {
        ramp_case c;
        random_ramp(&c, round);
        usable += c.ramp.usable;
        specular += c.ramp.usable && c.ramp.specular;
        for (int i = 0; i < 20 && c.ramp.usable; i++) {
            /* an entry is rounded to Q15, and each share, of which the strongest channel has `full` */
            const long double shares = 2 * c.scene.light_count * SHARE_ULP * c.ramp.full_q15 / 32768 * 16 / 15;
            const long double rounding = UNITS_OF_Q15 * (ENTRY_Q15 + shares + c.scene.light_count);
            const long double error = colour_error(&c);
            worst = worse(worst, error - rounding - c.ramp.error_q8);
            fullest = worse(fullest, error / (c.ramp.error_q8 + rounding));
        }
    }
    print_message("    %ld of 100000 usable, %ld with specular terms\n", usable, specular);
    assert_true(usable > 20000 && specular > 3000);
    expect_at_most("a colour's error beyond error_q8 and rounding, 1/256 code", worst, 0);
    expect_bound("a colour's error over error_q8 and rounding", fullest, 1);
}

static void shares_fill_the_ramp(void **state)
{
    long double worst = 0, sum_worst = 0;
    (void)state;
    for (int round = 0; round < 100000; round++) {
        ramp_case c;
        random_ramp(&c, round);
        long double sum = 0;
        for (uint16_t i = 0; i < c.scene.light_count && c.ramp.usable; i++) {
            const int k = c.ramp.channel;
            const uint32_t product[2] = {product_q15(c.diffuse[k], c.light[i][k]),
                                         c.ramp.specular ? product_q15(c.specular[k], c.light[i][k]) : 0};
            for (int n = 0; n < 2; n++) {
                const uint16_t share = glint_ramp_share_q15(&c.ramp, product[n]);
                const long double exact = (long double)product[n] / c.ramp.full_q15 * GLINT_RAMP_STEPS * 32;
                worst = worse(worst, fabsl(share - exact));
                sum += share;
            }
        }
        sum_worst = c.ramp.usable ? worse(sum_worst, sum) : sum_worst;
    }
    expect_bound("shares, ulp of Q15", worst, SHARE_ULP);
    /* the products are rounded one by one: half of the room above 960 of 1024 is for that */
    expect_at_most("the shares' sum, steps of the ramp", sum_worst / 32, (GLINT_RAMP_STEPS + GLINT_RAMP_ENTRIES) / 2);
}

static bool alike(const long double a[3], const long double b[3])
{
    return a[0] * b[1] == a[1] * b[0] && a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2];
}

/* Of lights of any kind: usable just when those that are not black have one chromaticity, some light is reflected and
 * it is not too bright. */
static void usable_for_one_chromaticity(void **state)
{
    long counts[2] = {0, 0};
    (void)state;
    for (int round = 0; round < 200000; round++) {
        ramp_case c;
        long double total[3] = {0, 0, 0}, full_q15 = 0, most_total = 0;
        int first = -1;
        bool one = true;
        random_ramp(&c, round);
        if (c.scene.light_count > 1 && round % 3 == 0) {
            glint_light *light = &c.lights[random_between(0, c.scene.light_count - 1)];
            light->colour = near(light->colour, 1, 1); /* a unit off, or not */
            real_of(&light->colour, c.light[light - c.lights]);
            glint_ramp_set_up(&c.ramp, &c.scene, &c.material);
        }
        for (uint16_t i = 0; i < c.scene.light_count; i++) {
            const bool black = c.light[i][0] + c.light[i][1] + c.light[i][2] == 0;
            first = first < 0 && !black ? i : first;
            one = one && (black || alike(c.light[first], c.light[i]));
            for (int k = 0; k < 3; k++) {
                total[k] += c.light[i][k];
            }
        }
        for (int k = 0; k < 3; k++) {
            const long double full = total[k] * (c.diffuse[k] + (c.ramp.specular ? c.specular[k] : 0));
            full_q15 = worse(full_q15, full * 32768);
            most_total = worse(most_total, total[k] * 16384);
        }
        /* what is neither clearly dark nor clearly too bright is left to rounding */
        if (!one || most_total > 65535 || full_q15 >= 65537) {
            assert_false(c.ramp.usable);
            counts[0]++;
        } else if (full_q15 >= LEAST_FULL_Q15 * c.scene.light_count && full_q15 <= 65536) {
            long double diffuse = 0;
            for (int k = 0; k < 3; k++) {
                diffuse = worse(diffuse, total[k] * c.diffuse[k] * 32768);
            }
            if (diffuse >= LEAST_FULL_Q15 * c.scene.light_count) {
                assert_true(c.ramp.usable);
                counts[1]++;
            }
        }
    }
    print_message("    usable %ld, not %ld\n", counts[1], counts[0]);
    assert_true(counts[0] > 20000 && counts[1] > 20000);
}

static void a_black_light_changes_nothing(void **state)
{
    static const glint_colour red = {16384, 0, 0}, blue = {0, 0, 16384}, black = {0, 0, 0};
    ramp_case c;
    (void)state;
    memset(&c, 0, sizeof c);
    c.scene.lights = c.lights;
    c.material.diffuse = (glint_colour){9000, 9000, 9000};
    c.scene.light_count = 3;
    c.lights[0].colour = black, c.lights[1].colour = red, c.lights[2].colour = blue;
    glint_ramp_set_up(&c.ramp, &c.scene, &c.material);
    assert_false(c.ramp.usable);
    c.lights[2].colour = black;
    glint_ramp_set_up(&c.ramp, &c.scene, &c.material);
    assert_true(c.ramp.usable && c.ramp.channel == 0);
    c.lights[1].colour = black;
    glint_ramp_set_up(&c.ramp, &c.scene, &c.material);
    assert_false(c.ramp.usable); /* nothing to divide by */
    assert_true(c.ramp.channel < 3);
    c.scene.light_count = 0;
    glint_ramp_set_up(&c.ramp, &c.scene, &c.material);
    assert_false(c.ramp.usable);
}

static void entries_rise_and_stop_at_1(void **state)
{
    (void)state;
    for (int round = 0; round < 3000; round++) {
        ramp_case c;
        uint16_t last[3] = {0, 0, 0};
        random_ramp(&c, round);
        for (uint32_t index = 0; index < GLINT_RAMP_ENTRIES && c.ramp.usable; index++) {
            const glint_shade shade = glint_ramp_colour(&c.ramp, index);
            const uint16_t now[3] = {shade.r_q15, shade.g_q15, shade.b_q15};
            for (int k = 0; k < 3; k++) {
                assert_true(now[k] >= last[k] && now[k] <= 32768);
                last[k] = now[k];
            }
        }
    }
}

/* The ramp in the display's format is the packed colours, entry by entry, and nothing behind it is touched. */
static void pixels_of_a_ramp_are_its_colours(void **state)
{
    (void)state;
    for (int round = 0; round < 3000; round++) {
        ramp_case c;
        const glint_target target = {.format = round & 1 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED,
                                     .dither = GLINT_DITHER_NONE};
        uint16_t pixel[GLINT_RAMP_ENTRIES + 1];
        random_ramp(&c, round);
        if (!c.ramp.usable) {
            continue;
        }
        memset(pixel, 0xa5, sizeof pixel);
        glint_pack_steps(&target, c.ramp.base_q27, c.ramp.step_q27, pixel, GLINT_RAMP_ENTRIES);
        for (uint32_t index = 0; index < GLINT_RAMP_ENTRIES; index++) {
            const glint_shade shade = glint_ramp_colour(&c.ramp, index);
            assert_int_equal(pixel[index], glint_pack_pixel(&target, &shade));
        }
        assert_int_equal(pixel[GLINT_RAMP_ENTRIES], 0xa5a5);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(colours_err_by_what_is_stated), numeric_test(shares_fill_the_ramp),
        numeric_test(usable_for_one_chromaticity),   numeric_test(a_black_light_changes_nothing),
        numeric_test(entries_rise_and_stop_at_1),    numeric_test(pixels_of_a_ramp_are_its_colours),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
