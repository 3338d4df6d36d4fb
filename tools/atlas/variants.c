/* SPDX-License-Identifier: MIT */
/*
 * The library's routines beside what one might write instead. Variants that are not the library's stand here alone, for
 * comparison: nothing draws with them. Their tables are made when the program starts and lie in RAM.
 *
 * With GLINT_SMALL_TABLES, which is for the whole library, only the routines that it changes are here.
 */
#include "tools/atlas/routines.h"

#include <math.h>

#include "number/fixed.h"
#include "number/integer.h"
#include "number/real.h"

const char *const routine_names[ROUTINES] = {"reciprocal-root", "unit-vector", "power-32", "sine"};

static uint32_t next_u32(uint32_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return *state;
}

routine_input routine_next(uint32_t *state)
{
    routine_input in;
    in.x_q30 = next_u32(state);
    in.x_q30 = in.x_q30 < (uint32_t)1 << 30 ? in.x_q30 + ((uint32_t)1 << 30) : in.x_q30;
    in.x = (float)in.x_q30 * 0x1p-30f;
    if (in.x >= 4.0f) { /* rounded up */
        in.x = 1.0f;
    }
    const int shift = (int)(1 + next_u32(state) % 16);
    for (int k = 0; k < 3; k++) {
        in.v[k] = (int32_t)next_u32(state) >> shift;
        in.v_real[k] = (float)in.v[k];
    }
    in.v[0] |= 1; /* never the zero vector */
    in.v_real[0] = (float)in.v[0];
    in.gap_q31 = next_u32(state) % 644245095; /* 0.3 2^31 */
    in.gap = (float)in.gap_q31 * 0x1p-31f;
    in.angle_turn16 = (uint16_t)next_u32(state);
    in.angle_radians = (float)in.angle_turn16 * 9.58737992e-5f; /* 2 pi / 65536 */
    return in;
}

/* -------------------------------------------------------------------------------------------------- reciprocal root */

static bool root_library(const routine_input *in, routine_result *out)
{
    out->fixed[0] = (int32_t)glint_inverse_root_q16(in->x_q30);
    return true;
}

static bool unit_library_q15(const routine_input *in, routine_result *out)
{
    return glint_unit_q15(in->v, out->fixed);
}

static bool power_library(const routine_input *in, routine_result *out)
{
    out->fixed[0] = glint_power_q15(in->gap_q31, ROUTINE_EXPONENT * 16);
    return true;
}

#if GLINT_SMALL_TABLES

void routine_begin(void)
{
}

#define TABLE_BYTES(cells) ((uint16_t)((cells) * sizeof(uint16_t)))

const routine_variant routine_variants[] = {
    {"library-24-cells-2-steps", "library", root_library, TABLE_BYTES(24), ROUTINE_ROOT, 16},
    {"library-24-cells-2-steps", "library", unit_library_q15, TABLE_BYTES(24), ROUTINE_UNIT, 15},
    {"library-16-cells", "library", power_library, TABLE_BYTES(2 * 17), ROUTINE_POWER, 15},
};

#else

/* 2^bits cells an unit of x in [1, 4): the reciprocal root in Q16 at their middles. */
enum { COARSE_BITS = 3, MIDDLE_BITS = 5, FINE_BITS = 7 };
#define CELLS(bits) ((size_t)3 << (bits))
static uint16_t coarse_q16[CELLS(COARSE_BITS)], middle_q16[CELLS(MIDDLE_BITS)], fine_q16[CELLS(FINE_BITS)];

/* x^32 in Q15 at i / 256 for the power's tables; the sine of i / 1024 turn in Q15, a quarter of a turn. */
enum { POWER_CELLS = 256, SINE_CELLS = 256, FEW_CELLS = 64 };
static uint16_t power_q15[POWER_CELLS + 1], sine_q15[SINE_CELLS + 1];

static void fill_roots(uint16_t *table, int bits)
{
    for (size_t cell = 0; cell < CELLS(bits); cell++) {
        const uint32_t middle_q30 =
            ((uint32_t)1 << 30) + ((uint32_t)cell << (30 - bits)) + ((uint32_t)1 << (29 - bits));
        const uint32_t root = glint_square_root_u64(((uint64_t)1 << 62) / middle_q30);
        table[cell] = (uint16_t)(root > 65535 ? 65535 : root);
    }
}

static uint32_t squared_q31(uint32_t x_q31)
{
    const uint32_t high = multiply_high_u32(x_q31, x_q31);
    return high << 1;
}

void routine_begin(void)
{
    fill_roots(coarse_q16, COARSE_BITS);
    fill_roots(middle_q16, MIDDLE_BITS);
    fill_roots(fine_q16, FINE_BITS);
    for (int i = 0; i <= POWER_CELLS; i++) {
        uint32_t x_q31 = (uint32_t)i << 23;
        for (int power = 1; power < ROUTINE_EXPONENT; power *= 2) {
            x_q31 = squared_q31(x_q31);
        }
        power_q15[i] = (uint16_t)((x_q31 + ((uint32_t)1 << 15)) >> 16);
    }
    for (int i = 0; i <= SINE_CELLS; i++) {
        int32_t sine_q30, cosine_q30;
        glint_sine_cosine_q30((uint16_t)(i * (16384 / SINE_CELLS)), &sine_q30, &cosine_q30);
        sine_q15[i] = (uint16_t)((sine_q30 + ((int32_t)1 << 14)) >> 15);
    }
}

static inline uint32_t seed_q16(const uint16_t *table, int bits, uint32_t x_q30)
{
    return table[(x_q30 >> (30 - bits)) - ((uint32_t)1 << bits)];
}

/* A Newton step in residual form, y + y (1 - x y^2) / 2; the seed's relative error is below 2^-5, so the residual is
 * below 2^-3.9. */
static inline uint32_t step_q16(uint32_t y_q16, uint32_t x_q30)
{
    const int32_t residual_q30 = ((int32_t)1 << 30) - (int32_t)multiply_high_u32(y_q16 * y_q16, x_q30);
    const int32_t part_q15 = residual_q30 >> 15;                                      /* |part| < 2^11.1 */
    const uint32_t y = y_q16 + (uint32_t)(((int32_t)y_q16 * part_q15 + 32768) >> 16); /* the product below 2^27.2 */
    return y > 65535 ? 65535 : y;
}

#define TABLE_ROOT(name, table, bits, steps)                                                                           \
    static inline uint32_t name##_q16(uint32_t x_q30)                                                                  \
    {                                                                                                                  \
        uint32_t y_q16 = seed_q16(table, bits, x_q30);                                                                 \
        for (int step = 0; step < (steps); step++) {                                                                   \
            y_q16 = step_q16(y_q16, x_q30);                                                                            \
        }                                                                                                              \
        return y_q16;                                                                                                  \
    }                                                                                                                  \
    static bool name(const routine_input *in, routine_result *out)                                                     \
    {                                                                                                                  \
        out->fixed[0] = (int32_t)name##_q16(in->x_q30);                                                                \
        return true;                                                                                                   \
    }
TABLE_ROOT(root_coarse, coarse_q16, COARSE_BITS, 0)
TABLE_ROOT(root_coarse_1, coarse_q16, COARSE_BITS, 1)
TABLE_ROOT(root_coarse_2, coarse_q16, COARSE_BITS, 2)
TABLE_ROOT(root_middle, middle_q16, MIDDLE_BITS, 0)
TABLE_ROOT(root_middle_1, middle_q16, MIDDLE_BITS, 1)
TABLE_ROOT(root_fine, fine_q16, FINE_BITS, 0)
TABLE_ROOT(root_fine_1, fine_q16, FINE_BITS, 1)

static inline float newton(float x, int steps)
{
    float y = float_from_bits(0x5f375a86u - (bits_from_float(x) >> 1)); /* C. Lomont, see number/real.c */
    for (int step = 0; step < steps; step++) {
        y += 0.5f * y * (1.0f - x * y * y);
    }
    return y;
}

static bool root_float_1(const routine_input *in, routine_result *out)
{
    out->real[0] = newton(in->x, 1);
    return true;
}

static bool root_float_2(const routine_input *in, routine_result *out)
{
    out->real[0] = newton(in->x, 2);
    return true;
}

static bool root_float_library(const routine_input *in, routine_result *out)
{
    out->real[0] = glint_inverse_root(in->x);
    return true;
}

static bool root_libm(const routine_input *in, routine_result *out)
{
    out->real[0] = 1.0f / sqrtf(in->x);
    return true;
}

/* ------------------------------------------------------------------------------------------------------ unit vector */

/* The components' magnitudes in 15 bits, so that the squares add up to less than 2^32. */
static inline uint32_t in_15_bits(const int32_t v[3], uint32_t w[3])
{
    const uint32_t any = magnitude32(v[0]) | magnitude32(v[1]) | magnitude32(v[2]);
    const int shift = clz32(any);
    uint32_t sum = 0;
    for (int k = 0; k < 3; k++) {
        w[k] = magnitude32(v[k]) << shift >> 17;
        sum += w[k] * w[k];
    }
    return sum;
}

static inline void by_root(const int32_t v[3], uint32_t (*root_q16)(uint32_t), int32_t unit[3])
{
    uint32_t w[3], sum = in_15_bits(v, w); /* 2^28 <= sum < 2^31.6: sqrt(sum) = 2^15 sqrt(sum / 2^30) */
    int down = 16;
    if (sum >> 30 == 0) {
        sum <<= 2;
        down = 15;
    }
    const uint32_t inverse = root_q16(sum);
    for (int k = 0; k < 3; k++) {
        unit[k] = with_sign_of(v[k], (w[k] * inverse + ((uint32_t)1 << (down - 1))) >> down);
    }
}

static bool unit_coarse_1(const routine_input *in, routine_result *out)
{
    by_root(in->v, root_coarse_1_q16, out->fixed);
    return true;
}

static bool unit_fine(const routine_input *in, routine_result *out)
{
    by_root(in->v, root_fine_q16, out->fixed);
    return true;
}

static bool unit_divisions(const routine_input *in, routine_result *out)
{
    uint32_t w[3], rest = in_15_bits(in->v, w), root = 0;
    for (uint32_t bit = (uint32_t)1 << 30; bit; bit >>= 2) { /* floor(sqrt(sum)), digit by digit */
        if (rest >= root + bit) {
            rest -= root + bit;
            root = (root >> 1) + bit;
        } else {
            root >>= 1;
        }
    }
    for (int k = 0; k < 3; k++) {
        out->fixed[k] = with_sign_of(in->v[k], ((w[k] << 15) + root / 2) / root);
    }
    return true;
}

static bool unit_library_q28(const routine_input *in, routine_result *out)
{
    return glint_unit_q28(in->v, out->fixed);
}

static bool unit_float_2(const routine_input *in, routine_result *out)
{
    const float *v = in->v_real;
    const float inverse = newton(v[0] * v[0] + v[1] * v[1] + v[2] * v[2], 2);
    for (int k = 0; k < 3; k++) {
        out->real[k] = v[k] * inverse;
    }
    return true;
}

static bool unit_float_library(const routine_input *in, routine_result *out)
{
    return glint_unit(in->v_real, out->real);
}

static bool unit_libm(const routine_input *in, routine_result *out)
{
    const float *v = in->v_real;
    const float inverse = 1.0f / sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int k = 0; k < 3; k++) {
        out->real[k] = v[k] * inverse;
    }
    return true;
}

/* ------------------------------------------------------------------------------------------------------------ power */

static bool power_squarings_q15(const routine_input *in, routine_result *out)
{
    uint32_t x_q15 = 32768 - (in->gap_q31 >> 16);
    for (int power = 1; power < ROUTINE_EXPONENT; power *= 2) {
        x_q15 = (x_q15 * x_q15 + 16384) >> 15;
    }
    out->fixed[0] = (int32_t)x_q15;
    return true;
}

static bool power_squarings_q31(const routine_input *in, routine_result *out)
{
    uint32_t x_q31 = ((uint32_t)1 << 31) - in->gap_q31;
    for (int power = 1; power < ROUTINE_EXPONENT; power *= 2) {
        x_q31 = squared_q31(x_q31);
    }
    out->fixed[0] = (int32_t)((x_q31 + 32768) >> 16);
    return true;
}

static bool power_nearest(const routine_input *in, routine_result *out)
{
    out->fixed[0] = power_q15[POWER_CELLS - ((in->gap_q31 + ((uint32_t)1 << 22)) >> 23)];
    return true;
}

static bool power_linear(const routine_input *in, routine_result *out)
{
    const uint32_t x_q15 = 32768 - (in->gap_q31 >> 16), cell = x_q15 >> 7;
    const int32_t left = power_q15[cell], right = power_q15[cell < POWER_CELLS ? cell + 1 : cell];
    out->fixed[0] = left + (((right - left) * (int32_t)(x_q15 & 127) + 64) >> 7);
    return true;
}

static bool power_float_squarings(const routine_input *in, routine_result *out)
{
    float x = 1.0f - in->gap;
    for (int power = 1; power < ROUTINE_EXPONENT; power *= 2) {
        x *= x;
    }
    out->real[0] = x;
    return true;
}

static bool power_float_library(const routine_input *in, routine_result *out)
{
    out->real[0] = glint_power(in->gap, (float)ROUTINE_EXPONENT);
    return true;
}

static bool power_libm(const routine_input *in, routine_result *out)
{
    out->real[0] = powf(1.0f - in->gap, (float)ROUTINE_EXPONENT);
    return true;
}

/* ------------------------------------------------------------------------------------------------------------- sine */

/* The place in the rising quarter, 0..2^14, of an angle; the sine's sign is that of `turn`. */
static inline uint16_t quarter(uint16_t angle_turn16)
{
    const uint16_t within = angle_turn16 & 0x3fff;
    return angle_turn16 & 0x4000 ? (uint16_t)(0x4000 - within) : within;
}

static inline int32_t signed_by(uint16_t angle_turn16, int32_t sine)
{
    return angle_turn16 & 0x8000 ? -sine : sine;
}

#define TABLE_SINE(name, cells)                                                                                        \
    static bool name##_nearest(const routine_input *in, routine_result *out)                                           \
    {                                                                                                                  \
        const uint16_t at = quarter(in->angle_turn16), cell = 16384 / (cells);                                         \
        const uint16_t index = (uint16_t)((uint16_t)(at + cell / 2) / cell * (SINE_CELLS / (cells)));                  \
        out->fixed[0] = signed_by(in->angle_turn16, sine_q15[index]);                                                  \
        return true;                                                                                                   \
    }                                                                                                                  \
    static bool name##_linear(const routine_input *in, routine_result *out)                                            \
    {                                                                                                                  \
        const uint16_t at = quarter(in->angle_turn16), cell = 16384 / (cells);                                         \
        const uint16_t index = (uint16_t)(at / cell * (SINE_CELLS / (cells)));                                         \
        const int32_t left = sine_q15[index];                                                                          \
        const int32_t right = sine_q15[index < SINE_CELLS ? index + SINE_CELLS / (cells) : index];                     \
        const int32_t sine = left + ((right - left) * (int32_t)(at % cell) + cell / 2) / cell;                         \
        out->fixed[0] = signed_by(in->angle_turn16, sine);                                                             \
        return true;                                                                                                   \
    }
TABLE_SINE(sine_64, FEW_CELLS)
TABLE_SINE(sine_256, SINE_CELLS)

/* 4 t (1 - t) over half a turn, t in 0..1. */
static bool sine_parabola(const routine_input *in, routine_result *out)
{
    const uint32_t t_q15 = in->angle_turn16 & 0x7fff;
    out->fixed[0] = signed_by(in->angle_turn16, (int32_t)((t_q15 * (32768 - t_q15)) >> 13));
    return true;
}

/* t (a - t^2 (b - c t^2)) over a quarter, t in 0..1; right in value and slope at the end: a = pi/2, b = pi - 5/2,
 * c = pi/2 - 3/2. */
static bool sine_fifth(const routine_input *in, routine_result *out)
{
    static const int32_t a_q14 = 25736, b_q14 = 10512, c_q14 = 1160;
    const int32_t t_q14 = quarter(in->angle_turn16), tt_q14 = (t_q14 * t_q14) >> 14;
    const int32_t inner_q14 = b_q14 - ((c_q14 * tt_q14) >> 14);
    const int32_t outer_q14 = a_q14 - ((inner_q14 * tt_q14) >> 14);
    out->fixed[0] = signed_by(in->angle_turn16, (t_q14 * outer_q14 + 4096) >> 13);
    return true;
}

static bool sine_library(const routine_input *in, routine_result *out)
{
    int32_t cosine_q30;
    glint_sine_cosine_q30(in->angle_turn16, &out->fixed[0], &cosine_q30);
    return true;
}

static bool sine_float_library(const routine_input *in, routine_result *out)
{
    float cosine;
    glint_sine_cosine(in->angle_turn16, &out->real[0], &cosine);
    return true;
}

static bool sine_libm(const routine_input *in, routine_result *out)
{
    out->real[0] = sinf(in->angle_radians);
    return true;
}

#define ENTRIES(count) ((uint16_t)((count) * sizeof(uint16_t)))

const routine_variant routine_variants[] = {
    {"library-192-cells-linear", "library", root_library, ENTRIES(193), ROUTINE_ROOT, 16},
    {"24-cells", "atlas", root_coarse, ENTRIES(CELLS(COARSE_BITS)), ROUTINE_ROOT, 16},
    {"24-cells-1-step", "atlas", root_coarse_1, ENTRIES(CELLS(COARSE_BITS)), ROUTINE_ROOT, 16},
    {"24-cells-2-steps", "atlas", root_coarse_2, ENTRIES(CELLS(COARSE_BITS)), ROUTINE_ROOT, 16},
    {"96-cells", "atlas", root_middle, ENTRIES(CELLS(MIDDLE_BITS)), ROUTINE_ROOT, 16},
    {"96-cells-1-step", "atlas", root_middle_1, ENTRIES(CELLS(MIDDLE_BITS)), ROUTINE_ROOT, 16},
    {"384-cells", "atlas", root_fine, ENTRIES(CELLS(FINE_BITS)), ROUTINE_ROOT, 16},
    {"384-cells-1-step", "atlas", root_fine_1, ENTRIES(CELLS(FINE_BITS)), ROUTINE_ROOT, 16},
    {"float-1-step", "atlas", root_float_1, 0, ROUTINE_ROOT, -1},
    {"float-2-steps", "atlas", root_float_2, 0, ROUTINE_ROOT, -1},
    {"library-float-3-steps", "library", root_float_library, 0, ROUTINE_ROOT, -1},
    {"1/sqrtf", "libm", root_libm, 0, ROUTINE_ROOT, -1},

    {"library-192-cells-linear", "library", unit_library_q15, ENTRIES(193), ROUTINE_UNIT, 15},
    {"library-Q28", "library", unit_library_q28, ENTRIES(193), ROUTINE_UNIT, 28},
    {"24-cells-1-step", "atlas", unit_coarse_1, ENTRIES(CELLS(COARSE_BITS)), ROUTINE_UNIT, 15},
    {"384-cells", "atlas", unit_fine, ENTRIES(CELLS(FINE_BITS)), ROUTINE_UNIT, 15},
    {"root-and-3-divisions", "atlas", unit_divisions, 0, ROUTINE_UNIT, 15},
    {"float-2-steps", "atlas", unit_float_2, 0, ROUTINE_UNIT, -1},
    {"library-float-3-steps", "library", unit_float_library, 0, ROUTINE_UNIT, -1},
    {"1/sqrtf", "libm", unit_libm, 0, ROUTINE_UNIT, -1},

    {"library-32-cells", "library", power_library, ENTRIES(2 * 33), ROUTINE_POWER, 15},
    {"5-squarings-Q15", "atlas", power_squarings_q15, 0, ROUTINE_POWER, 15},
    {"5-squarings-Q31", "atlas", power_squarings_q31, 0, ROUTINE_POWER, 15},
    {"256-cells-nearest", "atlas", power_nearest, ENTRIES(POWER_CELLS + 1), ROUTINE_POWER, 15},
    {"256-cells-linear", "atlas", power_linear, ENTRIES(POWER_CELLS + 1), ROUTINE_POWER, 15},
    {"float-5-squarings", "atlas", power_float_squarings, 0, ROUTINE_POWER, -1},
    {"library-float", "library", power_float_library, 0, ROUTINE_POWER, -1},
    {"powf", "libm", power_libm, 0, ROUTINE_POWER, -1},

    {"library-Q30", "library", sine_library, 0, ROUTINE_SINE, 30},
    {"64-cells-nearest", "atlas", sine_64_nearest, ENTRIES(FEW_CELLS + 1), ROUTINE_SINE, 15},
    {"64-cells-linear", "atlas", sine_64_linear, ENTRIES(FEW_CELLS + 1), ROUTINE_SINE, 15},
    {"256-cells-nearest", "atlas", sine_256_nearest, ENTRIES(SINE_CELLS + 1), ROUTINE_SINE, 15},
    {"256-cells-linear", "atlas", sine_256_linear, ENTRIES(SINE_CELLS + 1), ROUTINE_SINE, 15},
    {"parabola", "atlas", sine_parabola, 0, ROUTINE_SINE, 15},
    {"fifth-degree", "atlas", sine_fifth, 0, ROUTINE_SINE, 15},
    {"library-float", "library", sine_float_library, 0, ROUTINE_SINE, -1},
    {"sinf", "libm", sine_libm, 0, ROUTINE_SINE, -1},
};

#endif

const uint8_t routine_variant_count = sizeof routine_variants / sizeof routine_variants[0];
