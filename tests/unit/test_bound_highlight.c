/* SPDX-License-Identifier: MIT */
/*
 * Highlights: where they are certain not to show, what they err by when they are looked at now and then, against long
 * double. The choice of a tier is tested in test_bound.c.
 */
#include "tests/unit/numeric.h"

#include <glint/scene.h>

#include "lighting/bound.h"

#define ONE_Q15 32768.0L
#define ONE_Q16 65536.0L
#define ONE_Q20 1048576.0L
#define ONE_Q28 268435456.0L
#define TURN_OF_ROUNDING 2.5e-4L /* radians that rounding moves two directions apart, as bound.h states */
#define TURN_OF_UNITS 3.2e-4L    /* test_units_fixed */
#define TURN_OF_PLANES 4e-5L
#define PEAK 32640           /* 255 codes */
#define LEAST_EXPONENT_Q4 16 /* below 1, cos^a has no slope at a right angle: the tiers leave that to the exact one */
#define MOST_EXPONENT_Q4 (GLINT_MAX_EXPONENT * 16)

static long double right_angle(void)
{
    return acosl(-1) / 2;
}

static long double power_of(long double cosine, uint32_t exponent_q4)
{
    return exponent_q4 == 0 ? 1 : cosine <= 0 ? 0 : powl(cosine, exponent_q4 / 16.0L);
}

/* The greatest slope of cos^a by the angle, radians: a cos^(a-1) sin, at tan^2 = 1 / (a - 1). */
static long double steepest(long double a)
{
    return a <= 1 ? 1 : sqrtl(a) * powl(1 - 1 / a, (a - 1) / 2);
}

static void a_left_out_highlight_is_faint(void **state)
{
    static const uint32_t peaks[] = {16, 17, 18, 20, 25, 32, 33, 100, 511, 512, 1000, 9999, PEAK, 65280, 131071};
    long double worst = 0, widest = 0;
    (void)state;
    for (uint32_t exponent_q4 = 0; exponent_q4 <= MOST_EXPONENT_Q4; exponent_q4++) {
        for (size_t i = 0; i < sizeof peaks / sizeof *peaks; i++) {
            const uint32_t angle_q15 = glint_bound_highlight_q15(peaks[i], (uint16_t)exponent_q4);
            const long double angle = angle_q15 / ONE_Q15;
            if (angle_q15 == GLINT_FAR_Q15) {
                continue; /* farther than any: it is not left out */
            }
            const long double left = peaks[i] * power_of(cosl(angle), exponent_q4);
            worst = worse(worst, left);
            if (exponent_q4 >= 256 && peaks[i] >= 100) {
                widest = worse(widest, angle / acosl(powl(16.0L / peaks[i], 16.0L / exponent_q4)));
            }
        }
    }
    expect_at_most("a highlight that is left out, 1/256 code", worst, GLINT_HIGHLIGHT_LEFT);
    expect_at_most("the angle taken for it, over the least", widest, 1.15L);
}

/* The greatest angle that glint_bound_is_beyond() takes for less than a gap's, Q15; -1 for none. */
static int32_t greatest_below(uint32_t gap_q15)
{
    int32_t below = -1;
    for (int32_t step = 1 << 17; step > 0; step /= 2) {
        below += glint_bound_is_beyond(gap_q15, (uint32_t)(below + step)) ? step : 0;
    }
    return below;
}

static void an_angle_beyond_another_is_beyond_it(void **state)
{
    long double worst = 0, loosest = 0;
    (void)state;
    for (uint32_t gap_q15 = 0; gap_q15 <= 65536; gap_q15++) {
        const long double angle = acosl(1 - fminl(gap_q15 / ONE_Q15, 2)), least = greatest_below(gap_q15) / ONE_Q15;
        worst = worse(worst, least - angle);
        loosest = worse(loosest, sqrtl(2 * fminl(gap_q15, 65535) / ONE_Q15) - least);
        assert_false(glint_bound_is_beyond(gap_q15, GLINT_FAR_Q15));
        assert_false(glint_bound_is_beyond(gap_q15, UINT32_MAX));
    }
    expect_at_most("an angle taken for less than a gap's, beyond that", worst * ONE_Q15, 0);
    expect_at_most("the greatest such angle below sqrt(2 gap), ulp of Q15", loosest * ONE_Q15, 1);
}

static long double dot3(const long double a[3], const long double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static long double angle_between(const long double a[3], const long double b[3])
{
    long double d[3];
    for (int k = 0; k < 3; k++) {
        d[k] = a[k] - b[k];
    }
    return 2 * asinl(fminl(1, sqrtl(dot3(d, d)) / 2));
}

static void normalise(long double v[3])
{
    const long double length = sqrtl(dot3(v, v));
    for (int k = 0; k < 3; k++) {
        v[k] /= length;
    }
}

static void random_direction(long double v[3])
{
    do {
        for (int k = 0; k < 3; k++) {
            v[k] = 2 * random_unit() - 1;
        }
    } while (dot3(v, v) > 1 || dot3(v, v) < 0.01L);
    normalise(v);
}

static void no_point_is_farther_from_its_nearest_corner(void **state)
{
    long double worst = 0;
    (void)state;
    for (int round = 0; round < 500000; round++) {
        long double corner[3][3], base[3], one[3], two[3], p[3] = {0, 0, 0}, chord = 0, nearest = 4, d[3];
        const long double size = exp2l(-12 * random_unit()) * 0.58L;
        random_direction(base);
        random_direction(one);
        for (int k = 0; k < 3; k++) {
            two[k] = base[(k + 1) % 3] * one[(k + 2) % 3] - base[(k + 2) % 3] * one[(k + 1) % 3];
        }
        normalise(two);
        for (int k = 0; k < 3; k++) {
            one[k] = two[(k + 1) % 3] * base[(k + 2) % 3] - two[(k + 2) % 3] * base[(k + 1) % 3];
        }
        for (int i = 0; i < 3; i++) { /* about equilateral, or any */
            const long double turn = round & 1 ? i * right_angle() * 4 / 3 : random_unit() * 7;
            for (int k = 0; k < 3; k++) {
                corner[i][k] = base[k] + size * (cosl(turn) * one[k] + sinl(turn) * two[k]);
            }
            normalise(corner[i]);
        }
        long double weight[3] = {random_unit(), random_unit(), random_unit()};
        for (int i = 0; i < 3; i++) {
            weight[i] = round & 2 ? 1 : weight[i];
            for (int k = 0; k < 3; k++) {
                p[k] += weight[i] * corner[i][k];
                d[k] = corner[i][k] - corner[(i + 1) % 3][k];
            }
            chord = worse(chord, dot3(d, d));
        }
        normalise(p);
        for (int i = 0; i < 3; i++) {
            nearest = fminl(nearest, angle_between(p, corner[i]));
        }
        if (chord <= 1) {
            const uint32_t spread = glint_bound_spread_q15((uint32_t)ceill(chord * ONE_Q16));
            worst = worse(worst, 2 * nearest * ONE_Q15 / spread);
        }
    }
    assert_int_equal(glint_bound_spread_q15(65537), GLINT_FAR_Q15);
    expect_bound("twice the way to the nearest corner, over the spread", worst, 1);
}

static void a_normal_is_no_shorter(void **state)
{
    long double worst = 0;
    (void)state;
    for (uint32_t chord_q16 = 0; chord_q16 <= 65536; chord_q16++) {
        const long double longer = 1 / sqrtl(1 - chord_q16 / (3 * ONE_Q16)) - 1,
                          bound = glint_bound_longer_q15(chord_q16) / ONE_Q15;
        worst = worse(worst, longer / bound);
        assert_true(bound <= longer * 1.08L + 3 / ONE_Q15);
    }
    expect_bound("what a normal's inverse length is above 1, over its bound", worst, 1);
}

static void a_turn_changes_no_more(void **state)
{
    long double turned = 0, gloss = 0, loose = 0, precise = -1e9L, fine = -1e9L;
    (void)state;
    for (uint32_t exponent_q4 = LEAST_EXPONENT_Q4; exponent_q4 <= MOST_EXPONENT_Q4; exponent_q4++) {
        for (uint32_t peak = 1; peak <= 65280; peak = peak * 3 + 1) {
            const long double slope = peak * steepest(exponent_q4 / 16.0L);
            turned = worse(turned, 2 * slope / glint_bound_turned(peak, (uint16_t)exponent_q4));
            gloss = worse(gloss, slope * TURN_OF_ROUNDING - glint_bound_gloss(peak, (uint16_t)exponent_q4));
            precise = worse(precise, slope * TURN_OF_UNITS - glint_bound_precise(peak, (uint16_t)exponent_q4, 0));
            fine = worse(fine, slope * TURN_OF_PLANES + peak * exponent_q4 / 16.0L * ldexpl(1, -23) -
                                   glint_bound_fine(peak, (uint16_t)exponent_q4, 0));
            if (peak > 10000) {
                loose = worse(loose, glint_bound_turned(peak, (uint16_t)exponent_q4) / (2 * slope));
            }
        }
    }
    expect_at_most("change of a highlight by a turn, over its bound", turned, 1);
    expect_at_most("the bound over the change", loose, 1.5L);
    expect_at_most("a specular term's rounding above its bound, 1/256 code", gloss, 0);
    expect_at_most("the same along rows", precise, 0);
    expect_at_most("the same with finer vectors", fine, 0);
}

static void the_table_of_factors_errs_by_less(void **state)
{
    long double worst = 0, at = 0, loosest = 1e9L;
    (void)state;
    for (int round = 0; round < 200000; round++) {
        const uint16_t exponent_q4 = (uint16_t)(round & 1 ? random_between(LEAST_EXPONENT_Q4, 64)
                                                          : random_between(LEAST_EXPONENT_Q4, MOST_EXPONENT_Q4));
        const uint32_t peak = (uint32_t)random_between(17, PEAK);
        const uint32_t angle_q15 = glint_bound_highlight_q15(peak, exponent_q4);
        uint8_t bits;
        uint16_t cells;
        glint_bound_gloss_table(angle_q15, &bits, &cells);
        assert_true(cells <= GLINT_GLOSS_CELLS && bits <= 20);
        const long double gap = 1 - cosl(fminl(angle_q15 / ONE_Q15, right_angle()));
        assert_true(ldexpl(cells, bits) >= gap * ONE_Q28); /* the highlight ends in it */
        const uint32_t bound = glint_bound_gloss_error(peak, exponent_q4, bits);
        for (int i = 0; i < 20; i++) {
            const int cell = i < 4 ? i % cells : i < 8 ? cells - 1 - i % cells : random_between(0, cells - 1);
            const long double part = i & 1 ? 0.5L : powl(random_unit(), 4);
            const long double left = power_of(1 - ldexpl(cell, bits) / ONE_Q28, exponent_q4),
                              right = power_of(1 - ldexpl(cell + 1, bits) / ONE_Q28, exponent_q4),
                              middle = power_of(1 - ldexpl(cell + part, bits) / ONE_Q28, exponent_q4);
            const long double error = peak * fabsl(left + part * (right - left) - middle);
            at = error / bound > worst ? exponent_q4 : at;
            worst = worse(worst, error / bound);
        }
        loosest = fminl(loosest, bound);
    }
    print_message("    worst at an exponent of %.4Lf\n", at / 16);
    expect_at_most("linear between the table's entries, over the bound", worst, 1);
}

static void a_gap_shows_up_to_its_angle(void **state)
{
    long double worst = 0, loosest = 0;
    (void)state;
    for (int round = 0; round < 2000000; round++) {
        const uint32_t gap_q28 = (uint32_t)(exp2l(29 * random_unit()) - 1);
        const uint32_t gloss = (uint32_t)exp2l(27 * random_unit()), error = (uint32_t)(exp2l(11 * random_unit()) - 1);
        const uint32_t angle_q15 = glint_bound_shows_q15(gap_q28, error, gloss);
        const long double gap = gap_q28 / ONE_Q28 + (long double)error / gloss;
        if (angle_q15 != GLINT_FAR_Q15) {
            worst = worse(worst, gap - (1 - cosl(angle_q15 / ONE_Q15)));
            if (gap > 1e-4L && error <= 1023) {
                loosest = worse(loosest, angle_q15 / ONE_Q15 / acosl(1 - gap));
            }
        } else {
            assert_true(gap > 0.99L || error > 1023 || gloss < 32 || gloss < 64); /* so faint is it then */
        }
    }
    expect_at_most("a gap beyond the angle at which it shows", worst, 0);
    expect_at_most("the angle over the gap's", loosest, 1.05L);
}

static void pixels_that_are_clear_are(void **state)
{
    long double worst = 0, used = 0;
    (void)state;
    for (int round = 0; round < 2000000; round++) {
        const uint32_t gap_q31 = round % 16 ? (uint32_t)exp2l(31 * random_unit()) : (uint32_t)1 << 31;
        const uint32_t turn_q20 = (uint32_t)exp2l(25.9L * random_unit());
        const uint32_t highlight_q15 = (uint32_t)exp2l(17 * random_unit());
        const long double angle = acosl(1 - gap_q31 / 2147483648.0L), shows = highlight_q15 / ONE_Q15;
        const int32_t clear = glint_bound_clear(gap_q31, highlight_q15, glint_bound_per_turn_q20(turn_q20));
        assert_true(clear >= 0);
        if (clear > 0) {
            worst = worse(worst, clear * (turn_q20 / ONE_Q20) - (angle - shows));
            used = clear > 20 ? worse(used, clear * (turn_q20 / ONE_Q20) / (angle - shows)) : used;
        }
    }
    expect_at_most("radians that clear pixels may turn too far", worst, 0);
    expect_bound("the turn of clear pixels over what there is", used, 1);
}

/* A row of pixels: M and the ray are linear along it. */
typedef struct great_row {
    long double m[3], m_step[3], ray[3], ray_step[3], s[3];
} great_row;

static void along(const long double from[3], const long double step[3], long double i, long double out[3])
{
    for (int k = 0; k < 3; k++) {
        out[k] = from[k] + i * step[k];
    }
    normalise(out);
}

/* 1 - r.c, or 1 - n.h, at pixel i */
static long double gap_at(const great_row *row, long double i, bool blinn)
{
    long double n[3], c[3], other[3];
    along(row->m, row->m_step, i, n);
    along(row->ray, row->ray_step, i, c);
    const long double cosine = dot3(n, row->s);
    for (int k = 0; k < 3; k++) {
        c[k] = -c[k];
        other[k] = blinn ? row->s[k] + c[k] : 2 * cosine * n[k] - row->s[k];
    }
    if (blinn) {
        normalise(other);
        return 1 - dot3(other, n);
    }
    return 1 - dot3(other, c);
}

/* |v'| / |v| at most, over pixels 0..end */
static long double rate_of(const long double from[3], const long double step[3], long double end)
{
    const long double square = dot3(step, step), at = -dot3(from, step) / square;
    const long double i = at < 0 ? 0 : at > end ? end : at; /* where it is shortest */
    long double v[3];
    for (int k = 0; k < 3; k++) {
        v[k] = from[k] + i * step[k];
    }
    return sqrtl(square / dot3(v, v));
}

/* A pixel's angle on the display's axis, at least: |v'| over the distance of the whole line. */
static long double rate_of_line(const long double from[3], const long double step[3])
{
    const long double square = dot3(step, step), at = dot3(from, step);
    return square / sqrtl(dot3(from, from) * square - at * at);
}

static void random_row(great_row *row, int end, bool blinn)
{
    const long double k = exp2l(-10 + 6.5L * random_unit()), v = exp2l(-10 + 6.5L * random_unit());
    long double aside[3], to_eye;
    do { /* |s + c| >= 1 all along, as the tiers see to */
        random_direction(row->m);
        random_direction(row->ray);
        random_direction(row->s);
        to_eye = -dot3(row->ray, row->s);
    } while (dot3(row->m, row->s) < 0 || (blinn && to_eye < -0.4L));
    random_direction(aside);
    const long double shift = (random_unit() - 0.5L) * end * 2;
    for (int i = 0; i < 3; i++) {
        row->m_step[i] = k * aside[i];
        row->m[i] -= random_u32() & 1 ? shift * row->m_step[i] : end / 2.0L * row->m_step[i];
    }
    random_direction(aside);
    for (int i = 0; i < 3; i++) {
        row->ray_step[i] = v * aside[i];
        row->ray[i] -= end / 2.0L * row->ray_step[i];
    }
}

/* The greatest error between three pixels over the bound for its rates. The bound takes an eighth more of the normal's
 * than it is given, for what lies beside the triangle: here it is given that much less. */
static long double row_ratio(const great_row *row, int log2, bool blinn, bool *bound_served)
{
    const uint32_t gloss = (uint32_t)1 << 27;
    const int apart = 1 << log2;
    const long double k = rate_of(row->m, row->m_step, 2.0L * apart), v = rate_of_line(row->ray, row->ray_step);
    const uint32_t bound =
        glint_bound_quadratic(gloss, (uint32_t)ceill(k * ONE_Q20 * 8 / 9), (uint32_t)ceill(v * ONE_Q20), log2);
    *bound_served = bound != UINT32_MAX;
    if (!*bound_served) {
        return 0;
    }
    const long double f[3] = {gap_at(row, 0, blinn), gap_at(row, apart, blinn), gap_at(row, 2 * apart, blinn)};
    const long double bend = f[0] - 2 * f[1] + f[2], slope = f[1] - f[0] - bend / 2;
    long double worst = 0;
    for (int i = 1; i < 2 * apart; i++) {
        const long double t = (long double)i / apart;
        worst = worse(worst, fabsl(f[0] + t * slope + t * t * bend / 2 - gap_at(row, i, blinn)));
    }
    return worst * gloss / bound;
}

/* Random rows, and from the worst of them on by small changes that make it worse. */
static long double worst_row(bool blinn)
{
    long double worst = 0;
    long served = 0;
    for (int start = 0; start < 400; start++) {
        great_row best, row;
        long double ratio = 0;
        const int log2 = 1 + start % 3;
        for (int round = 0; round < 1500; round++) {
            bool bound_served;
            if (round < 300) {
                random_row(&row, 2 << log2, blinn);
            } else {
                const long double size = exp2l(-1 - 12 * random_unit());
                row = best;
                for (int k = 0; k < 3; k++) {
                    row.m[k] += size * (random_unit() - 0.5L);
                    row.s[k] += size * (random_unit() - 0.5L);
                    row.ray[k] += size * (random_unit() - 0.5L);
                    row.m_step[k] *= 1 + size * (random_unit() - 0.5L);
                    row.ray_step[k] *= 1 + size * (random_unit() - 0.5L);
                }
                normalise(row.s);
            }
            long double n[3], c[3];
            along(row.m, row.m_step, 0, n);
            along(row.ray, row.ray_step, 0, c);
            if (blinn && -dot3(c, row.s) < -0.4L) {
                continue;
            }
            const long double now = row_ratio(&row, log2, blinn, &bound_served);
            served += bound_served;
            if (now > ratio || round == 0) {
                ratio = now;
                best = row;
            }
        }
        worst = worse(worst, ratio);
    }
    assert_true(served > 100000);
    return worst;
}

static void highlights_between_three_pixels_are_quadratic(void **state)
{
    (void)state;
    expect_at_most("a highlight (Phong) between three pixels, over its bound", worst_row(false), 1);
    expect_at_most("a highlight (Blinn) between three pixels, over its bound", worst_row(true), 1);
    assert_int_equal(glint_bound_quadratic(1000, (uint32_t)1 << 18, 0, 1), UINT32_MAX);
    assert_int_equal(glint_bound_quadratic(1000, 0, (uint32_t)1 << 18, 1), UINT32_MAX);
    assert_int_equal(glint_bound_quadratic(1000, 0, 0, 3), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(a_left_out_highlight_is_faint),
        numeric_test(an_angle_beyond_another_is_beyond_it),
        numeric_test(no_point_is_farther_from_its_nearest_corner),
        numeric_test(a_normal_is_no_shorter),
        numeric_test(a_turn_changes_no_more),
        numeric_test(the_table_of_factors_errs_by_less),
        numeric_test(a_gap_shows_up_to_its_angle),
        numeric_test(pixels_that_are_clear_are),
        numeric_test(highlights_between_three_pixels_are_quadratic),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
