/* SPDX-License-Identifier: MIT */
/*
 * Prints src/number/tables.c, the constant tables of the number routines. Each entry is computed in double precision
 * from the formula beside it; none is typed in.
 *
 * Usage: generate-tables > src/number/tables.c
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>

typedef double (*entry_function)(int index, int cells);

static double nearest(double value)
{
    return floor(value + 0.5);
}

static double reciprocal_seed(int i, int cells)
{
    /* 1/x on the cell [1 + i/cells, 1 + (i+1)/cells]: 2 / (lo + hi) makes the relative error equal at both ends, in
     * Q15 */
    const double low = 1.0 + (double)i / cells;
    return nearest(32768.0 * 2.0 / (low + low + 1.0 / cells));
}

static double root_seed(int i, int cells)
{
    /* 1/sqrt(x) on the cell [1 + 3i/cells, 1 + 3(i+1)/cells]: 2 / (sqrt(lo) + sqrt(hi)), in Q16 */
    const double width = 3.0 / cells, low = 1.0 + i * width;
    return nearest(65536.0 * 2.0 / (sqrt(low) + sqrt(low + width)));
}

static double root(int i, int cells)
{
    /* 1/sqrt(x) at x = 1 + 3i/cells, in Q16. The chord between two entries lies above the curve by up to
     * width^2 / 8 f''(x), f'' = 3/4 x^(-5/2): half of that is taken off, so that the errors to both sides are equal.
     * The interpolation drops a fraction that it subtracts, so its result lies 1/2 too high on average: the entry is
     * rounded down for that. */
    const double width = 3.0 / cells, x = 1.0 + i * width;
    return floor(65536.0 * (1.0 / sqrt(x) - 0.5 * width * width / 8.0 * 0.75 * pow(x, -2.5)));
}

static double log_slope(int i, int cells)
{
    /* -log2(1 - y) / y at y = i/(2 cells), in Q14 */
    const double y = 0.5 * i / cells;
    return nearest(16384.0 * (i == 0 ? 1.0 / log(2.0) : -log2(1.0 - y) / y));
}

static double exp_fraction(int i, int cells)
{
    /* 2^(-i/cells), in Q15 */
    return nearest(32768.0 * exp2(-(double)i / cells));
}

static double clz_u4(int i, int cells)
{
    /* leading zeros of a number of four bits */
    (void)cells;
    return i ? 3 - (int)log2(i) : 4;
}

/*
 * Approximations of x^(-1/2) by polynomials in y = 1 - x, for a relative error that is the least possible on the range
 * of y (E. Remez's exchange on the alternating extremes). A range begins a little below 0, for stored unit normals that
 * rounding has made longer than 1.
 */
#define CURVE_CLASSES 14
#define CURVE_LOW (-1.0 / 2048)

static double curve_limit(int class, int classes)
{
    /* ranges of y: 2^-10, and from 2^-8.5 to 2^-1 by powers of sqrt(1/2), but for the first few, which are of no use */
    (void)classes;
    return class == 0 ? 65.0 : nearest(65536.0 * exp2(0.5 * (class - 1) - 7.0));
}

/* sqrt(x) p(y) - 1 */
static double curve_error(const double c[3], double y)
{
    return sqrt(1.0 - y) * (c[0] + y * (c[1] + y * c[2])) - 1.0;
}

/* Solves the `count` equations sum_k c_k f_k(y_i) + (-1)^i e = 1 by elimination. */
static void curve_through(const double node[4], int count, double c[3])
{
    double row[4][5];
    for (int i = 0; i < count; i++) {
        for (int k = 0; k + 1 < count; k++) {
            row[i][k] = sqrt(1.0 - node[i]) * pow(node[i], k);
        }
        row[i][count - 1] = i & 1 ? -1.0 : 1.0;
        row[i][count] = 1.0;
    }
    for (int pivot = 0; pivot < count; pivot++) {
        for (int i = 0; i < count; i++) {
            const double factor = row[i][pivot] / row[pivot][pivot];
            for (int k = pivot; i != pivot && k <= count; k++) {
                row[i][k] -= factor * row[pivot][k];
            }
        }
    }
    for (int k = 0; k < 3; k++) {
        c[k] = k + 1 < count ? row[k][count] / row[k][k] : 0.0;
    }
}

static void curve_fit(double high, int degree, double c[3])
{
    enum { GRID = 4096 };
    const int count = degree + 2;
    double node[4];
    for (int i = 0; i < count; i++) {
        node[i] = CURVE_LOW + (high - CURVE_LOW) * (0.5 - 0.5 * cos(acos(-1.0) * i / (count - 1)));
    }
    for (int round = 0; round < 12; round++) {
        curve_through(node, count, c);
        /* the greatest error between each two of its zeros */
        int at = 0;
        double greatest = -1.0, last = 0.0;
        for (int i = 0; i <= GRID && at < count; i++) {
            const double y = CURVE_LOW + (high - CURVE_LOW) * i / GRID, error = curve_error(c, y);
            if (greatest >= 0.0 && (error < 0.0) != (last < 0.0)) {
                at++;
                greatest = -1.0;
            }
            if (at < count && fabs(error) > greatest) {
                greatest = fabs(error);
                node[at] = y;
            }
            last = error;
        }
    }
}

/* Four numbers: the coefficients in Q15, and the greatest error of the rounded ones in Q16, rounded up. */
static double curve_entry(int i, int classes)
{
    enum { GRID = 65536 };
    const int degree = i / 4 % 3;
    const double high = curve_limit(i / 12, classes) / 65536.0;
    double c[3], worst = 0.0;
    curve_fit(high, degree, c);
    for (int k = 0; k < 3; k++) {
        c[k] = nearest(c[k] * 32768.0) / 32768.0;
    }
    if (i % 4 < 3) {
        return c[i % 4] * 32768.0;
    }
    for (int k = 0; k <= GRID; k++) {
        worst = fmax(worst, fabs(curve_error(c, CURVE_LOW + (high - CURVE_LOW) * k / GRID)));
    }
    return ceil(worst * 65536.0 + 0.01);
}

static double bayer(int i, int cells)
{
    /* rank of cell (x, y) in the 8x8 ordered dither: the bits of x ^ y and y, interleaved, in reverse order */
    const int x = i & 7, y = i >> 3;
    int rank = 0;
    (void)cells;
    for (int bit = 0; bit < 3; bit++) {
        rank |= (((x ^ y) >> bit) & 1) << (5 - 2 * bit);
        rank |= ((y >> bit) & 1) << (4 - 2 * bit);
    }
    return rank;
}

/* cells and points: the number of intervals, and of entries, which is one more where entries stand for their ends. */
static void print_table(const char *type, const char *name, int cells, int points, entry_function entry, double limit)
{
    printf("\nconst %s %s[%d] GLINT_FLASH = {", type, name, points);
    for (int i = 0; i < points; i++) {
        const double value = entry(i, cells);
        printf("%s%.0f", i % 12 ? ", " : i ? ",\n    " : "\n    ", value < limit ? value : limit);
    }
    printf("};\n");
}

static void print_power_tables(int cells)
{
    print_table("uint16_t", "glint_log_slope_q14", cells, cells + 1, log_slope, 65535);
    print_table("uint16_t", "glint_exp_fraction_q15", cells, cells + 1, exp_fraction, 65535);
}

int main(void)
{
    printf("/* SPDX-License-Identifier: MIT */\n"
           "/* Made by: build/generate-tables > src/number/tables.c */\n"
           "/* clang-format off */\n"
           "#include \"number/tables.h\"\n");
    print_table("uint16_t", "glint_reciprocal_seed_q15", 64, 64, reciprocal_seed, 65535);
    printf("\n#if GLINT_SMALL_TABLES\n");
    print_table("uint16_t", "glint_root_seed_q16", 24, 24, root_seed, 65535);
    print_power_tables(16);
    printf("\n#else\n");
    print_table("uint16_t", "glint_root_q16", 192, 193, root, 65535);
    print_power_tables(32);
    printf("\n#endif\n");
    print_table("uint16_t", "glint_curve_limit_q16", CURVE_CLASSES, CURVE_CLASSES, curve_limit, 65535);
    print_table("uint16_t", "glint_curves", CURVE_CLASSES, CURVE_CLASSES * 12, curve_entry, 65535);
    print_table("uint8_t", "glint_clz_u4", 16, 16, clz_u4, 255);
    print_table("uint8_t", "glint_bayer_rank", 64, 64, bayer, 63);
    return ferror(stdout) || fflush(stdout) ? 1 : 0;
}
