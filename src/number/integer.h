/* SPDX-License-Identifier: MIT */
/*
 * Integer operations that C leaves to the programmer: leading zeros, wide products, rounding shifts.
 *
 * Q-format: a name that ends in _qN holds a real number times 2^N.
 *
 * int is 16 bits on some targets: every operand here is widened before an operation that needs the width.
 */
#ifndef GLINT_NUMBER_INTEGER_H
#define GLINT_NUMBER_INTEGER_H

#include <limits.h>
#include <stdbool.h>
#include <stdint.h>

#include <glint/config.h>

#include "number/tables.h"

/* >> of a negative number is taken to be arithmetic, and int32_t to wrap when converted from uint32_t, as on every
 * compiler for the targets of this library. C99 leaves both to the implementation, hence this check. */
typedef char glint_assert_arithmetic_shift[(-3 >> 1) == -2 && (int32_t)0xfffffffdu == -3 ? 1 : -1];

/*
 * Does the processor multiply 32 x 32 -> 64 bits in an instruction or two? Without (ARMv6-M, AVR) the same product is
 * put together from 16 x 16 bit ones, which is cheaper there than the compiler's 64 x 64 bit routine. The results are
 * identical; tests/unit compares them. Define GLINT_WIDE_MULTIPLY as 0 or 1 to overrule.
 */
#ifndef GLINT_WIDE_MULTIPLY
#if defined(__AVR__) || (defined(__ARM_ARCH_6M__) && __ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__)
#define GLINT_WIDE_MULTIPLY 0
#else
#define GLINT_WIDE_MULTIPLY 1
#endif
#endif

/*
 * Notes the range of a named quantity, as it is before it is narrowed. The checking build (make ranges) defines this
 * and holds what it saw against the documented ranges; in every other build it is nothing, and `value` is not computed.
 */
#ifndef GLINT_TRACE
#define GLINT_TRACE(quantity, value) ((void)0)
#endif

/*
 * Shows a triangle whose pixels are about to be shaded: its shade_state, complete, and the error promised for its
 * pixels in 1/256 code. What runs its pixels is in shade_state.run, so the tolerance's test, which defines this, puts a
 * function of its own there, and knows of each pixel whose promise it stands under. In every other build it is nothing.
 */
#ifndef GLINT_OBSERVE
#define GLINT_OBSERVE(shade, promise) ((void)0)
#endif

/*
 * Tells of what a frame evaluates, for copies of a backend that count it (glint-render --explain); in every other build
 * it is nothing, and the arguments are not computed. A light is told by its light_state:
 *
 * object, number         the object from which what follows is drawn
 * light, l, number       l stands for this light of the scene
 * copy, to, l            so does this copy of it
 * diffuse, l, times      n.s of the light is found
 * specular, l, times     r.c or n.h of the light; gaps, l, gap_q28, count: wherever the gap found is not UINT32_MAX
 * folded, l; culled, l   found of a triangle: the light may go into one sum with others; does not reach it
 * set_up, shade          a triangle, or a part of one that is clipped, is ready for the first of its bands
 * shadow, l, tests       shadows of single triangles that the light throws on a triangle, and the lights before it
 * mirror, times          the environment is looked up
 */
#ifndef GLINT_COUNT
#define GLINT_COUNT(...) ((void)0)
#endif

/* Reads constant data that may live in program memory. */
#if defined(__AVR__)
static inline uint8_t flash_u8(const uint8_t *address)
{
    return pgm_read_byte(address);
}
static inline uint16_t flash_u16(const uint16_t *address)
{
    return pgm_read_word(address);
}
static inline int16_t flash_s16(const int16_t *address)
{
    return (int16_t)pgm_read_word(address);
}
#else
static inline uint8_t flash_u8(const uint8_t *address)
{
    return *address;
}
static inline uint16_t flash_u16(const uint16_t *address)
{
    return *address;
}
static inline int16_t flash_s16(const int16_t *address)
{
    return *address;
}
#endif

/* Does the processor count leading zeros, or have a short library routine for it (AVR)? Else a search in C, inline,
 * takes half the time of the compiler's routine. */
#if !defined(__GNUC__) || (defined(__arm__) && !defined(__ARM_FEATURE_CLZ)) ||                                         \
    (defined(__riscv) && !defined(__riscv_zbb))
#define GLINT_SEARCH_LEADING_ZEROS 1
#else
#define GLINT_SEARCH_LEADING_ZEROS 0
#endif

/* Number of leading zero bits, 32 for 0: halving down to four bits, then from a table. */
static inline int clz32_search(uint32_t value)
{
    int zeros = 0;
    if (!(value >> 16)) {
        value <<= 16;
        zeros = 16;
    }
    if (!(value >> 24)) {
        value <<= 8;
        zeros += 8;
    }
    if (!(value >> 28)) {
        value <<= 4;
        zeros += 4;
    }
    return zeros + flash_u8(&glint_clz_u4[value >> 28]);
}

/*
 * Compiled for size, one copy of these in number/fixed.c serves all files: what has `search`, `narrow` or `inline` in
 * its name; and a division.
 */
#if defined(__OPTIMIZE_SIZE__)
#define GLINT_SHARE_CODE 1
#else
#define GLINT_SHARE_CODE 0
#endif
#if GLINT_SHARE_CODE && defined(__ARM_ARCH_6M__)
#define GLINT_SHORT_DIVISION 1
#else
#define GLINT_SHORT_DIVISION 0
#endif
int glint_clz32(uint32_t value);
uint32_t glint_divide_u32(uint32_t a, uint32_t b);
uint32_t glint_multiply_high_u32(uint32_t a, uint32_t b);
int32_t glint_multiply_high_s32(int32_t a, int32_t b);
int64_t glint_multiply_wide_s32(int32_t a, int32_t b);
int glint_bit_length64(uint64_t value);
int64_t glint_shift_round64(int64_t value, int shift);

/* A function whose variables are to leave the stack when it returns, since its caller goes on to call deeper, or whose
 * loops would share the registers with all that is alive in its caller. */
#if defined __GNUC__
#define GLINT_APART __attribute__((noinline))
#else
#define GLINT_APART
#endif

/* A function that is compiled anew for each constant that it is called with, unless code is to be small. */
#if defined __GNUC__ && !defined __OPTIMIZE_SIZE__
#define GLINT_SPECIALISED inline __attribute__((always_inline))
#else
#define GLINT_SPECIALISED
#endif

/* A function that is inline, unless code is to be small and it is called from more than one place. */
#if defined __GNUC__ && defined __OPTIMIZE_SIZE__
#define GLINT_SHARED __attribute__((noinline, unused))
#else
#define GLINT_SHARED inline
#endif

/* A function whose result is a constant in some builds, for which what depends on it is to be left out. */
#if defined __GNUC__
#define GLINT_FOLDED inline __attribute__((always_inline))
#else
#define GLINT_FOLDED inline
#endif

/* Number of leading zero bits; 32 for 0. */
static inline int clz32(uint32_t value)
{
#if GLINT_SEARCH_LEADING_ZEROS && GLINT_SHARE_CODE
    return glint_clz32(value);
#elif GLINT_SEARCH_LEADING_ZEROS
    return clz32_search(value);
#elif ULONG_MAX == 0xffffffff
    return value ? __builtin_clzl(value) : 32;
#else
    return value ? __builtin_clz(value) : 32;
#endif
}

/* a / b, rounded down, b > 0. On a processor without a division the compiler's routine is quick and long. */
static inline uint32_t divide_u32(uint32_t a, uint32_t b)
{
#if GLINT_SHORT_DIVISION
    return glint_divide_u32(a, b);
#else
    return a / b;
#endif
}

/* |value| without overflow: INT32_MIN gives 2^31. */
static inline uint32_t magnitude32(int32_t value)
{
    const uint32_t sign = 0u - ((uint32_t)value >> 31);
    return ((uint32_t)value ^ sign) - sign;
}

/* magnitude, or its negative where value is negative. */
static inline int32_t with_sign_of(int32_t value, uint32_t magnitude)
{
    const uint32_t sign = 0u - ((uint32_t)value >> 31);
    return (int32_t)((magnitude ^ sign) - sign);
}

/* max(0, value), without a branch */
static inline int32_t positive_part(int32_t value)
{
    return (int32_t)((uint32_t)value & ~(0u - ((uint32_t)value >> 31)));
}

static inline uint64_t magnitude64(int64_t value)
{
    return value < 0 ? 0u - (uint64_t)value : (uint64_t)value;
}

/* Number of bits of |value|: 0 for 0, 64 at most. */
static inline int bit_length64_inline(uint64_t value)
{
    const uint32_t high = (uint32_t)(value >> 32);
    return high ? 64 - clz32(high) : 32 - clz32((uint32_t)value);
}

static inline int bit_length64(uint64_t value)
{
#if GLINT_SHARE_CODE
    return glint_bit_length64(value);
#else
    return bit_length64_inline(value);
#endif
}

/* The upper 32 bits of value 2^(64 - bits), bits being its length: from the leading one on, the rest is cut off.
 * value > 0. */
static inline uint32_t normalize64(uint64_t value, int *bits)
{
#if GLINT_SHARE_CODE
    *bits = bit_length64(value);
    return (uint32_t)(value << (64 - *bits) >> 32);
#else
    const uint32_t high = (uint32_t)(value >> 32), low = (uint32_t)value;
    const int zeros = clz32(high ? high : low);
    *bits = (high ? 64 : 32) - zeros;
    return high ? high << zeros | low >> 1 >> (31 - zeros) : low << zeros;
#endif
}

/* floor(a b / 2^32) from four 16 x 16 bit products. */
static inline uint32_t multiply_high_narrow_u32(uint32_t a, uint32_t b)
{
    const uint32_t a_high = a >> 16, a_low = a & 0xffff;
    const uint32_t b_high = b >> 16, b_low = b & 0xffff;
    const uint32_t low = (a_low * b_low) >> 16;
    const uint32_t middle = a_high * b_low + low; /* <= (2^16-1)^2 + 2^16-1 < 2^32 */
    const uint32_t cross = a_low * b_high + (middle & 0xffff);
    return a_high * b_high + (middle >> 16) + (cross >> 16);
}

/* floor(a b / 2^32). */
static inline uint32_t multiply_high_u32(uint32_t a, uint32_t b)
{
#if GLINT_WIDE_MULTIPLY
    return (uint32_t)(((uint64_t)a * b) >> 32);
#elif GLINT_SHARE_CODE
    return glint_multiply_high_u32(a, b);
#else
    return multiply_high_narrow_u32(a, b);
#endif
}

/* floor(a b / 2^32), signed, from four 16 x 16 bit products: the upper halves are signed, -2^15..2^15 - 1, the lower
 * ones are not. */
static inline int32_t multiply_high_narrow_s32(int32_t a, int32_t b)
{
    const int32_t a_high = a >> 16, b_high = b >> 16;
    const uint32_t a_low = (uint32_t)a & 0xffff, b_low = (uint32_t)b & 0xffff;
    const int32_t low = (int32_t)((a_low * b_low) >> 16);
    /* each at least -2^15 (2^16-1), at most (2^15-1)(2^16-1) + 2^16-1 = 2^15 (2^16-1) < 2^31 */
    const int32_t middle = a_high * (int32_t)b_low + low;
    const int32_t cross = b_high * (int32_t)a_low + (middle & 0xffff);
    return a_high * b_high + (middle >> 16) + (cross >> 16);
}

static inline int32_t multiply_high_s32(int32_t a, int32_t b)
{
#if GLINT_WIDE_MULTIPLY
    return (int32_t)(((int64_t)a * b) >> 32);
#elif GLINT_SHARE_CODE
    return glint_multiply_high_s32(a, b);
#else
    return multiply_high_narrow_s32(a, b);
#endif
}

/* The same for a factor below 2^31 that is kept unsigned. */
static inline int32_t multiply_high_s32_u31(int32_t a, uint32_t b)
{
    return multiply_high_s32(a, (int32_t)b);
}

/* a b, all 64 bits of it. */
static inline int64_t multiply_wide_narrow_s32(int32_t a, int32_t b)
{
    const uint32_t high = (uint32_t)multiply_high_s32(a, b);
    return (int64_t)((uint64_t)high << 32 | (uint32_t)a * (uint32_t)b);
}

static inline int64_t multiply_wide_s32(int32_t a, int32_t b)
{
#if GLINT_WIDE_MULTIPLY
    return (int64_t)a * b;
#elif GLINT_SHARE_CODE
    return glint_multiply_wide_s32(a, b);
#else
    return multiply_wide_narrow_s32(a, b);
#endif
}

/* floor(a b / 2^16) for any a and a 16-bit b, two 32-bit products:
 * |a >> 16| <= 2^15 and |b| <= 2^15, so the first is at most 2^30; the second at most 2^15 (2^16 - 1) < 2^31. */
static inline int32_t multiply_q16(int32_t a, int32_t b_s16)
{
    GLINT_TRACE("16-bit factor", b_s16);
    return (a >> 16) * b_s16 + (((int32_t)(a & 0xffff) * b_s16) >> 16);
}

/* value = high 2^16 + low with low in -2^15..2^15 - 1; |high| <= 2^14 for |value| <= 2^30. value < 2^31 - 2^15. */
static inline int32_t low_half(int32_t value)
{
    return (int16_t)(uint16_t)value;
}

static inline int32_t high_half(int32_t value)
{
    return (value - low_half(value)) >> 16;
}

/* value 2^shift for |value| < 2^62, rounded to nearest, halves up; 0 when every bit is shifted out. The caller sees to
 * it that a left shift does not overflow. */
static inline int64_t shift_round64_inline(int64_t value, int shift)
{
    if (shift >= 0) {
        GLINT_TRACE("shifted left, bits", value ? bit_length64(magnitude64(value)) + shift : 0);
        return (int64_t)((uint64_t)value << shift);
    }
    GLINT_TRACE("shifted right", value);
    if (shift < -62) {
        return 0;
    }
    return (value + ((int64_t)1 << (-shift - 1))) >> -shift;
}

static inline int64_t shift_round64(int64_t value, int shift)
{
#if GLINT_SHARE_CODE
    return glint_shift_round64(value, shift);
#else
    return shift_round64_inline(value, shift);
#endif
}

/* value 2^-down, rounded to nearest, halves up, modulo 2^32; down > -32; 0 when every bit is shifted out. */
static GLINT_SHARED int32_t shift_round32(int32_t value, int down)
{
    if (down <= 0) {
        return (int32_t)((uint32_t)value << -down);
    }
    if (down > 31) {
        return 0;
    }
    const int32_t twice = value >> (down - 1);
    return (twice >> 1) + (twice & 1);
}

static inline int32_t saturate_s32(int64_t value)
{
    return value > INT32_MAX ? INT32_MAX : value < INT32_MIN ? INT32_MIN : (int32_t)value;
}

#endif
