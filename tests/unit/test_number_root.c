/* SPDX-License-Identifier: MIT */
/*
 * Roots and the rounding shift of 32 bits: each bound that number/fixed.h and number/integer.h state, measured again.
 */
#include "tests/unit/numeric.h"

#include "number/fixed.h"
#include "number/integer.h"
#include "number/tables.h"

/* Budgets, as number/fixed.h and number/fixed.c state them. */
#if GLINT_SMALL_TABLES
#define INVERSE_ROOT_LOG2 (-15.98L)
#else
#define INVERSE_ROOT_LOG2 (-15.01L)
#endif
#define ROOT_SHORT_LOG2 (-13.4L) /* the square root is too small by this part of it, */
#define ROOT_SHORT 1.0L          /* and one, */
#define ROOT_ABOVE_LOG2 (-15.0L) /* or too large by this part of it */

typedef struct root_worst {
    long double above, below; /* above the root; below it, beyond 1; as parts of it */
} root_worst;

static void check_root(uint32_t x, root_worst *worst)
{
    const long double root = sqrtl(x), got = glint_square_root_u32(x);
    if (x == 0) {
        assert_int_equal(got, 0);
        return;
    }
    worst->above = worse(worst->above, (got - root) / root);
    worst->below = worse(worst->below, (root - ROOT_SHORT - got) / root);
}

static void the_square_root_keeps_its_bound(void **state)
{
    root_worst worst = {0, 0};
    (void)state;
    for (uint32_t x = 0; x < (uint32_t)1 << 22; x++) {
        check_root(x, &worst);
    }
    for (uint32_t x = (uint32_t)1 << 22; x >= (uint32_t)1 << 22; x += 1021) { /* until it wraps */
        check_root(x, &worst);
    }
    for (uint32_t root = 1; root <= UINT16_MAX; root++) { /* where the whole part changes */
        check_root(root * root, &worst);
        check_root(root * root - 1, &worst);
    }
    for (unsigned i = 0; i < EDGE_CASES; i++) {
        check_root(edge_case_u32(i), &worst);
    }
    expect_at_most("glint_square_root_u32, above the root by this part", worst.above, exp2l(ROOT_ABOVE_LOG2));
    expect_bound_log2("glint_square_root_u32, below it by 1 and this part", worst.below, ROOT_SHORT_LOG2);
}

static void the_inverse_root_keeps_its_bound(void **state)
{
    long double worst = 0;
    uint32_t least = UINT32_MAX, most = 0;
    (void)state;
    for (uint64_t x = (uint64_t)1 << 30; x < (uint64_t)1 << 32; x += 97) {
        const uint32_t y = glint_inverse_root_q16((uint32_t)x);
        worst = worse(worst, fabsl(y / 65536.0L * sqrtl(ldexpl((long double)x, -30)) - 1));
        least = y < least ? y : least;
        most = y > most ? y : most;
    }
    assert_true(least >= 32767 && most <= 65535);
    assert_true(glint_inverse_root_q16(UINT32_MAX) >= 32767 && glint_inverse_root_q16((uint32_t)1 << 30) == 65535);
    expect_bound_log2("glint_inverse_root_q16", worst, INVERSE_ROOT_LOG2);
}

/* floor(value 2^-down + 1/2) modulo 2^32, from 128 bits */
static int32_t shifted(int32_t value, int down)
{
    if (down <= 0) {
        return (int32_t)(uint32_t)((wide)value * ((wide)1 << -down));
    }
    return down > 31 ? 0 : (int32_t)(((wide)value + ((wide)1 << (down - 1))) >> down);
}

static void a_rounding_shift_rounds(void **state)
{
    (void)state;
    for (int down = -31; down <= 80; down++) {
        for (unsigned i = 0; i < 2 * EDGE_CASES + 4000; i++) {
            const uint32_t bits = i < EDGE_CASES       ? edge_case_u32(i)
                                  : i < 2 * EDGE_CASES ? 0u - edge_case_u32(i - EDGE_CASES)
                                                       : (uint32_t)random_any_size(31);
            const int32_t value = (int32_t)bits;
            if (shift_round32(value, down) != shifted(value, down)) {
                fail_msg("shift_round32(%d, %d) is %d, not %d", value, down, shift_round32(value, down),
                         shifted(value, down));
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(the_square_root_keeps_its_bound),
        numeric_test(the_inverse_root_keeps_its_bound),
        numeric_test(a_rounding_shift_rounds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
