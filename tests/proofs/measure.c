/* SPDX-License-Identifier: MIT */
/*
 * What `make proofs` measures beside what it proves: the worst error of each routine over all inputs where that is
 * affordable, over adversarial ones elsewhere; and the hypotheses of the proofs, found over every entry of a table.
 *
 * Usage: measure reciprocal-cells | root-cells | power-cells    one proof a line: NAME=value of each parameter
 *        measure table-bounds | bounds                          routine, worst, what was tried
 *
 * Compiled twice, the second time with GLINT_SMALL_TABLES: root-cells, power-cells and table-bounds are about what
 * depends on that. Sources are included as text, since some of the routines are local to them, and the tables follow
 * the choice. Oracles: integers where the error can be told exactly, else long double.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "display/pack.c"
#include "lighting/light_fixed.h"
#include "number/fixed.c"
#include "number/tables.c"
#include "raster/edges.c"

static uint64_t random_state = 20240607;

/* xorshift64* (S. Vigna, 2016) */
static uint32_t random_u32(void)
{
    random_state ^= random_state >> 12;
    random_state ^= random_state << 25;
    random_state ^= random_state >> 27;
    return (uint32_t)((random_state * 2685821657736338717u) >> 32);
}

static double random_within(double low, double high)
{
    return low + (high - low) * random_u32() / 4294967296.0;
}

static double larger(double a, double b)
{
    return b > a ? b : a;
}

#include "tests/proofs/measure_unit.h"

/* ------------------------------------------------------------------------------------------- parameters of the proofs
 */

static void reciprocal_cells(void)
{
    for (int cell = 0; cell < 64; cell++) {
        printf("LOW=%db-6 HIGH=%lldb-31 SEED=%db-15\n", 64 + cell, ((64LL + cell + 1) << 25) - 1,
               glint_reciprocal_seed_q15[cell]);
    }
}

/* A square root in decimal, rounded down or up. */
static double root_below(double x)
{
    return floor(sqrt(x) * 1e12) / 1e12;
}

static double root_above(double x)
{
    return ceil(sqrt(x) * 1e12) / 1e12;
}

#if GLINT_SMALL_TABLES

static void root_cell(double low, double high, int cell)
{
    printf("ROOT_LOW=%.12f ROOT_HIGH=%.12f LOW=%.12f HIGH=%.12f SEED=%db-16\n", root_below(low), root_above(high), low,
           high, glint_root_seed_q16[cell]);
}

/* The bounds are all whole multiples of 2^-12 and so exact in decimal. Where 1/sqrt(S) rounds to 1 is a part by itself.
 */
static void root_cells(void)
{
    enum { PARTS = 4 };
    const double step = 1.0 / 8 / PARTS, first = 1.0 + 1.0 / 4096;
    root_cell(1, first, 0);
    for (int cell = 0; cell < 24; cell++) {
        for (int part = 0; part < PARTS; part++) {
            const double low = 1 + cell / 8.0 + part * step;
            root_cell(low < first ? first : low, low + step, cell);
        }
    }
}

#else

/* The last cell takes more pieces: only where the fraction nears 1, does what is subtracted stay a whole unit below. */
static void root_cells(void)
{
    for (int cell = 0; cell < 192; cell++) {
        const double low = 1 + cell / 64.0, high = low + 1 / 64.0;
        printf("QA_LOW=%.12f QA_HIGH=%.12f QB_LOW=%.12f QB_HIGH=%.12f LEFT=%db-16 RIGHT=%db-16 PIECES=%d\n",
               root_below(low), root_above(low), root_below(high), root_above(high), glint_root_q16[cell],
               glint_root_q16[cell + 1], cell == 191 ? 256 : 16);
    }
}

#endif

/* The interpolated slope against -log2(1 - y) / y, which rises with y: both ends of each run of y that it is used for.
 */
static void slope_errors(double *low, double *high)
{
    *low = *high = 0;
    for (uint32_t index = 0; index < 1 << 15; index++) {
        const long double slope = interpolate(glint_log_slope_q14, index, LOG_BITS) / 16384.0L;
        for (uint32_t end = 0; end < 2; end++) {
            const long double y = (long double)(index + end) / 65536;
            const long double exact = y > 0 ? -log1pl(-y) / logl(2) / y : 1 / logl(2);
            *low = fmin(*low, (double)(slope / exact - 1));
            *high = fmax(*high, (double)(slope / exact - 1));
        }
    }
}

/* One proof a quarter of each octave of the result. Widened by far more than the oracle's rounding. |computed z - exact
 * z| is at most delta, which the proof shows. */
static void power_cells(void)
{
    const double wider = 1e-12, delta = GLINT_SMALL_TABLES ? 1.0 / 128 : 1.0 / 512;
    double slope_low, slope_high;
    slope_errors(&slope_low, &slope_high);
    for (int cell = 0; cell < 17 * 4; cell++) {
        const int whole = cell / 4, quarter = cell % 4;
        double x_low = 1, x_high = -1;
        for (uint32_t at = (uint32_t)quarter << 12; at < (uint32_t)(quarter + 1) << 12; at++) {
            const double error = (double)(interpolate(glint_exp_fraction_q15, at, EXP_BITS) / 32768.0L -
                                          exp2l(-(long double)at / 16384));
            x_low = fmin(x_low, error);
            x_high = fmax(x_high, error);
        }
        const double z_low = fmax(whole + quarter / 4.0 - delta, 0), z_high = whole + (quarter + 1) / 4.0 + delta;
        const double peak = 1 / log(2); /* of z 2^-z */
        const double zg = z_low > peak ? z_low * exp2(-z_low) : z_high < peak ? z_high * exp2(-z_high) : 0.5308;
        printf("WEIGHT=1b-%d SLOPE_LOW=%.15f SLOPE_HIGH=%.15f X_ERROR_LOW=%.15f X_ERROR_HIGH=%.15f "
               "G_LOW=%.15f G_HIGH=%.15f ZG_HIGH=%.15f Z_HIGH=%.15f DELTA=%.15f C_LOW=%.15f C_HIGH=%.15f\n",
               whole, slope_low - wider, slope_high + wider, x_low - wider, x_high + wider, exp2(-z_high) - wider,
               exp2(-z_low) + wider, zg + wider, z_high, delta, (1 - exp2(-delta)) / delta - wider,
               (exp2(delta) - 1) / delta + wider);
    }
}

/* ------------------------------------------------------------------------------------------------------ measured worst
 */

static double worst_reciprocal(void)
{
    uint64_t worst = 0;
    uint32_t x = (uint32_t)1 << 31;
    do {
        const uint32_t r = glint_reciprocal_q31(x);
        const uint64_t residual = magnitude64((int64_t)((uint64_t)x * r - ((uint64_t)1 << 62)));
        /* beyond 31 bits it is as wrong as can be */
        worst = r >> 31 ? (uint64_t)1 << 62 : residual > worst ? residual : worst;
    } while (++x);
    return ldexp((double)worst, -62);
}

/* y sqrt(S) - 1 rises with y^2 s, which fits 64 bits. */
static double worst_inverse_root(void)
{
    uint64_t least_square = UINT64_MAX, greatest_square = 0;
    uint32_t s = (uint32_t)1 << 30;
    do {
        const uint64_t y = inverse_root_q16(s), square = y * y * s;
        least_square = square < least_square ? square : least_square;
        greatest_square = square > greatest_square ? square : greatest_square;
    } while (++s);
    return (double)fmaxl(sqrtl(ldexpl((long double)greatest_square, -62)) - 1,
                         1 - sqrtl(ldexpl((long double)least_square, -62)));
}

static double worst_power(void)
{
    double worst = 0;
    for (long trial = 0; trial < 150000000; trial++) {
        const uint16_t exponent_q4 = (uint16_t)(1 + (random_u32() >> (16 + random_u32() % 16)) % 65535);
        uint32_t gap;
        if (trial & 1) {
            gap = random_u32() >> (1 + random_u32() % 30);
        } else { /* a result above 2^-1, where errors are greatest */
            const double log_x = -0.7 * random_u32() / 4294967296.0 * 16 / exponent_q4;
            gap = (uint32_t)(-expm1(log_x) * 2147483648.0);
        }
        if (gap >= (uint32_t)1 << 31) {
            continue;
        }
        const double exact = exp(log1p(-(double)gap / 2147483648.0) * exponent_q4 / 16);
        worst = larger(worst, fabs(glint_power_q15(gap, exponent_q4) / 32768.0 - exact));
    }
    return worst;
}

static double worst_level(bool dither)
{
    double worst = 0;
    for (int16_t place = 0; place < (dither ? 64 : 1); place++) {
        const glint_target target = {.dither = dither ? GLINT_DITHER_BAYER : GLINT_DITHER_NONE};
        const uint32_t threshold = threshold_q15(&target, place & 7, (int16_t)(place >> 3));
        for (uint32_t greatest_level = 1; greatest_level <= 255; greatest_level += greatest_level + 1) {
            for (uint32_t value = 0; value <= 32768; value++) {
                const double exact = value * greatest_level / 32768.0;
                worst = larger(worst, fabs(level(value, greatest_level, threshold) - exact));
            }
        }
    }
    return worst;
}

static double worst_luma(void)
{
    double worst = 0;
    for (long trial = 0; trial < 10000000; trial++) {
        const glint_shade shade = {(uint16_t)(random_u32() % 32769), (uint16_t)(random_u32() % 32769),
                                   (uint16_t)(random_u32() % 32769)};
        const double exact = (77.0 * shade.r_q15 + 150.0 * shade.g_q15 + 29.0 * shade.b_q15) / 256;
        worst = larger(worst, fabs(luma_q15(&shade) - exact));
    }
    return worst;
}

static double worst_light_multiply(void)
{
    double worst = 0;
    for (int32_t reflectance = 0; reflectance <= 16384; reflectance++) {
        for (int32_t intensity = 0; intensity <= 32767 - 2; intensity += 3) {
            const glint_colour a = {(int16_t)reflectance, (int16_t)reflectance, (int16_t)reflectance};
            const glint_colour b = {(int16_t)intensity, (int16_t)(intensity + 1), (int16_t)(intensity + 2)};
            const light_product product = light_multiply(&a, &b);
            for (int k = 0; k < 3; k++) {
                worst = larger(worst, fabs(product.q15[k] - (double)reflectance * (intensity + k) / 8192));
            }
        }
    }
    return worst;
}

static double worst_light_add(void)
{
    double worst = 0;
    for (uint32_t a = 0; a <= 65534 - 2; a += 3) {
        const light_product product = {{a, a + 1, a + 2}};
        for (int32_t factor = 0; factor <= 32768; factor += 7) {
            light_sum sum = {{0, 0, 0}};
            light_add(&sum, &product, factor);
            for (int k = 0; k < 3; k++) {
                worst = larger(worst, fabs(sum.q16[k] - (double)product.q15[k] * factor / 16384));
            }
        }
    }
    return worst;
}

static double worst_clamp(void)
{
    double worst = 0;
    for (uint32_t sum = 0; sum <= 65536; sum++) {
        worst = larger(worst, fabs(light_clamp(sum) - sum / 2.0));
    }
    return worst;
}

/* Reflectance and intensity whose product lies nearly half a unit above or below what light_multiply() makes of it. */
static void half_off(bool above, int16_t *reflectance, int16_t *intensity)
{
    uint32_t rest;
    do {
        *reflectance = (int16_t)(1 + random_u32() % 16384);
        *intensity = (int16_t)(random_u32() % (uint32_t)(*reflectance < 9000 ? 9000 : 8192));
        rest = (uint32_t)*reflectance * (uint32_t)*intensity % 8192;
    } while (above ? rest < 4096 || rest > 4220 : rest > 4095 || rest < 3980);
}

static double worst_colour(void)
{
    double worst = 0;
    for (long trial = 0; trial < 1000000; trial++) {
        const bool above = trial & 1;
        glint_colour r[3], i[3];
        light_product product[3];
        memset(r, 0, sizeof r);
        memset(i, 0, sizeof i);
        for (int k = 0; k < 3; k++) {
            half_off(above, &r[k].r_q14, &i[k].r_q14);
            product[k] = light_multiply(&r[k], &i[k]);
        }
        /* large factors, since an error of the product counts by its factor */
        for (int near = 0; near < 24; near++) {
            const int32_t diffuse = 32768 - (int32_t)(random_u32() % 3000),
                          specular = 32768 - (int32_t)(random_u32() % 3000);
            light_sum sum;
            light_start(&sum, &product[0]);
            light_add(&sum, &product[1], diffuse);
            light_add(&sum, &product[2], specular);
            if (sum.q16[0] <= 65536) {
                const double exact = (double)r[0].r_q14 * i[0].r_q14 +
                                     (double)r[1].r_q14 * i[1].r_q14 * diffuse / 32768 +
                                     (double)r[2].r_q14 * i[2].r_q14 * specular / 32768;
                worst = larger(worst, 255 * fabs(light_finish(&sum).r_q15 / 32768.0 - exact / 268435456.0));
            }
        }
    }
    return worst;
}

/* The error of rounding to nearest, halves up, lies in (-1/2, 1/2]. */
static double mistakes_in_shifts(void)
{
    double mistakes = 0;
    for (long trial = 0; trial < 20000000; trial++) {
        const int shift = -1 - (int)(random_u32() % 70), half_bit = -shift - 1;
        int64_t value = (int64_t)(((uint64_t)random_u32() << 32 | random_u32()) >> (2 + random_u32() % 40));
        if (trial & 1 && half_bit < 61) { /* a half or beside it */
            value = ((value >> half_bit) << half_bit) + (int64_t)(random_u32() % 3) - 1;
        }
        value = trial & 2 ? -value : value;
        const long double error = (long double)shift_round64(value, shift) - ldexpl((long double)value, shift);
        mistakes += !(error > -0.5L && error <= 0.5L);
    }
    return mistakes;
}

/* ------------------------------------------------------------------------------------- identities: count of mistakes
 */

/* Values with the bit patterns at which carries between halves go wrong: each half near 0, 2^8, 2^15 or 2^16. */
static uint32_t carry_case(uint32_t index)
{
    static const uint16_t half[32] = {0,      1,      2,      3,      0x7f,   0x80,   0xff,   0x100,
                                      0x101,  0x1234, 0x3fff, 0x4000, 0x5555, 0x7ffe, 0x7fff, 0x8000,
                                      0x8001, 0x8002, 0x9999, 0xaaaa, 0xb504, 0xb505, 0xbfff, 0xc000,
                                      0xcafe, 0xf000, 0xff00, 0xfffb, 0xfffc, 0xfffd, 0xfffe, 0xffff};
    return index < 1024 ? (uint32_t)half[index >> 5] << 16 | half[index & 31] : random_u32();
}

static double mistakes_in_products(bool high)
{
    double mistakes = 0;
    for (uint32_t i = 0; i < 8192; i++) {
        const uint32_t a = carry_case(i);
        for (uint32_t k = 0; k < 8192; k++) {
            const uint32_t b = carry_case(k);
            const int32_t sa = (int32_t)a, sb = (int32_t)b, sixteen = (int16_t)(b & 0xffff);
            mistakes += high ? multiply_high_narrow_u32(a, b) != (uint32_t)(((uint64_t)a * b) >> 32) ||
                                   multiply_high_narrow_s32(sa, sb) != (int32_t)(((int64_t)sa * sb) >> 32)
                             : multiply_q16(sa, sixteen) != (int32_t)(((int64_t)sa * sixteen) >> 16);
        }
    }
    return mistakes;
}

/* glint_edges_set_up() on one edge against the exact edge function at one pixel. */
static int edge_mistake(glint_point from, glint_point to, int16_t x, int16_t y)
{
    const glint_point corner[3] = {from, from, to};
    const glint_box box = {x, x, y, y};
    glint_edges edges;
    glint_edges_set_up(&edges, corner, true, box);
    const int64_t dx = to.x - from.x, dy = to.y - from.y;
    const int64_t exact = dx * (y * 256 + 128 - from.y) - dy * (x * 256 + 128 - from.x);
    const bool left_or_top = dy < 0 || (dy == 0 && dx > 0);
    return ((int32_t)edges.value[0] >= 0) != (left_or_top ? exact >= 0 : exact > 0);
}

/* Every edge on 32 x 32 points in 1/8 px, at every pixel of the 4 x 4 that they span; then edges across the whole guard
 * band and pixels near them. */
static double mistakes_of_edges(void)
{
    const int32_t guard = GLINT_GUARD_PX * GLINT_SUBPIXEL;
    double mistakes = 0;
    for (int32_t points = 0; points < 1 << 20; points++) {
        const glint_point from = {(points & 31) * 32, (points >> 5 & 31) * 32};
        const glint_point to = {(points >> 10 & 31) * 32, (points >> 15) * 32};
        for (int16_t pixel = 0; pixel < 16; pixel++) {
            mistakes += edge_mistake(from, to, pixel & 3, (int16_t)(pixel >> 2));
        }
    }
    for (long trial = 0; trial < 30000000; trial++) {
        glint_point end[2];
        for (int k = 0; k < 2; k++) {
            end[k].x = (int32_t)(random_u32() % (uint32_t)(2 * guard + 1)) - guard;
            end[k].y = (int32_t)(random_u32() % (uint32_t)(2 * guard + 1)) - guard;
        }
        if (trial & 1) { /* along the border */
            end[0].x = -guard;
            end[1].x = trial & 2 ? guard : -guard;
            end[1].y = trial & 4 ? guard : end[1].y;
        }
        int32_t x = (int32_t)(random_u32() % (2 * GLINT_GUARD_PX)) - GLINT_GUARD_PX;
        int32_t y = (int32_t)(random_u32() % (2 * GLINT_GUARD_PX)) - GLINT_GUARD_PX;
        if (trial & 8 && end[1].x != end[0].x) { /* the pixel of the edge's line in this column */
            const int64_t on_line =
                end[0].y + (int64_t)(end[1].y - end[0].y) * (x * 256 + 128 - end[0].x) / (end[1].x - end[0].x);
            y = on_line >= -guard && on_line < guard ? (int32_t)(on_line >> 8) : y;
        }
        mistakes += edge_mistake(end[0], end[1], (int16_t)x, (int16_t)y);
    }
    return mistakes;
}

static void report(const char *routine, double worst, const char *tried)
{
    printf("%s %.17g %s\n", routine, worst, tried);
    (void)fflush(stdout);
}

static void table_bounds(void)
{
    report("inverse_root", worst_inverse_root(), "all 3 2^30 inputs");
    report("unit_q15", worst_unit_q15(), "4 10^7 adversarial vectors and the worst found earlier");
    report("unit_q28", worst_unit_q28(), "2 10^7 adversarial vectors");
    report("power", worst_power(), "1.5 10^8 inputs, half of them with results above 1/2");
}

static void bounds(void)
{
    report("reciprocal", worst_reciprocal(), "all 2^31 inputs");
    report("level_nearest", worst_level(false), "all inputs");
    report("level_dithered", worst_level(true), "all inputs");
    report("luma", worst_luma(), "10^7 inputs");
    report("multiply", worst_light_multiply(), "all inputs");
    report("add", worst_light_add(), "all products, every seventh factor");
    report("clamp", worst_clamp(), "all inputs");
    report("colour", worst_colour(), "2.4 10^7 adversarial inputs");
    report("shift_round64", mistakes_in_shifts(), "2 10^7 inputs, half of them beside a half");
    report("multiply_high", mistakes_in_products(true), "2^26 pairs, 2^20 of them adversarial");
    report("multiply_q16", mistakes_in_products(false), "2^26 pairs, 2^20 of them adversarial");
    report("edges", mistakes_of_edges(), "2^20 edges at 16 pixels, 3 10^7 across the guard band");
}

int main(int count, char **argument)
{
    static const struct {
        const char *name;
        void (*run)(void);
    } part[] = {{"reciprocal-cells", reciprocal_cells},
                {"root-cells", root_cells},
                {"power-cells", power_cells},
                {"table-bounds", table_bounds},
                {"bounds", bounds}};
    for (size_t i = 0; count == 2 && i < sizeof part / sizeof *part; i++) {
        if (strcmp(argument[1], part[i].name) == 0) {
            part[i].run();
            return ferror(stdout) || fflush(stdout) ? 1 : 0;
        }
    }
    (void)fprintf(stderr, "usage: measure reciprocal-cells | root-cells | power-cells | table-bounds | bounds\n");
    return 2;
}
