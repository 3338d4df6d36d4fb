/* SPDX-License-Identifier: MIT */
/*
 * Prints src/number/tables.c, the constant tables of the number routines. Each entry is computed in double precision
 * from the formula beside it and rounded to nearest; none is typed in.
 *
 * Usage: generate-tables > src/number/tables.c
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>

typedef double (*entry_function)(int index);

static double reciprocal_seed(int i)
{
    /* 1/x on the cell [1 + i/64, 1 + (i+1)/64]: 2 / (lo + hi) makes the relative error equal at both ends, in Q15 */
    const double low = 1.0 + i / 64.0;
    return 32768.0 * 2.0 / (low + low + 1.0 / 64.0);
}

static double root_seed(int i)
{
    /* 1/sqrt(x) on the cell [1 + i/8, 1 + (i+1)/8]: 2 / (sqrt(lo) + sqrt(hi)), in Q16 */
    const double low = 1.0 + i / 8.0;
    return 65536.0 * 2.0 / (sqrt(low) + sqrt(low + 1.0 / 8.0));
}

static double log_slope(int i)
{
    /* -log2(1 - y) / y at y = i/64, in Q14 */
    const double y = i / 64.0;
    return 16384.0 * (i == 0 ? 1.0 / log(2.0) : -log2(1.0 - y) / y);
}

static double exp_fraction(int i)
{
    /* 2^(-i/32), in Q15 */
    return 32768.0 * exp2(-i / 32.0);
}

static double bayer(int i)
{
    /* rank of cell (x, y) in the 8x8 ordered dither: the bits of x ^ y and y, interleaved, in reverse order */
    const int x = i & 7, y = i >> 3;
    int rank = 0;
    for (int bit = 0; bit < 3; bit++) {
        rank |= (((x ^ y) >> bit) & 1) << (5 - 2 * bit);
        rank |= ((y >> bit) & 1) << (4 - 2 * bit);
    }
    return rank;
}

static void print_table(const char *type, const char *name, int count, entry_function entry, double limit)
{
    printf("\nconst %s %s[%d] GLINT_FLASH = {", type, name, count);
    for (int i = 0; i < count; i++) {
        double value = floor(entry(i) + 0.5);
        printf("%s%.0f", i % 12 ? ", " : i ? ",\n    " : "\n    ", value < limit ? value : limit);
    }
    printf("};\n");
}

int main(void)
{
    printf("/* SPDX-License-Identifier: MIT */\n"
           "/* Made by: build/generate-tables > src/number/tables.c */\n"
           "/* clang-format off */\n"
           "#include \"number/tables.h\"\n");
    print_table("uint16_t", "glint_reciprocal_seed_q15", 64, reciprocal_seed, 65535);
    print_table("uint16_t", "glint_root_seed_q16", 24, root_seed, 65535);
    print_table("uint16_t", "glint_log_slope_q14", 33, log_slope, 65535);
    print_table("uint16_t", "glint_exp_fraction_q15", 33, exp_fraction, 65535);
    print_table("uint8_t", "glint_bayer_rank", 64, bayer, 63);
    return ferror(stdout) || fflush(stdout) ? 1 : 0;
}
