/* SPDX-License-Identifier: MIT */
/*
 * The choice of the tier of curves: what it promises, against long double at points of random triangles; which turns it
 * takes; what a greater tolerance changes. The other tiers are in test_bound.c, the constants in test_curve_bounds.c.
 */
#include "tests/unit/bound_triangle.h"

/* What is left of a promise of the tier of curves for its curves and for weights that are left out. */
static long double curved_room(const glint_bound *bound, const glint_choice *choice)
{
    const uint32_t highlights = bound->left > bound->gloss ? bound->left : bound->gloss;
    const int32_t room = (int32_t)choice->promise - HALF_CODE;
    return (long double)room - bound->fixed - bound->curve_reach - highlights;
}

static bool weights_are_left_out(const case_triangle *t, const glint_choice *choice)
{
    const int32_t *depth = t->inverse_depth;
    return choice->weight_q15[0] == 32768 && choice->weight_q15[1] == 32768 && choice->weight_q15[2] == 32768 &&
           (depth[0] != depth[1] || depth[1] != depth[2]);
}

/* The unit vector of a sum of the normals. */
static void direction_at(const case_triangle *t, const long double b[3], const long double weight[3], long double n[3])
{
    weighted(t->normal, b, weight, n);
    const long double length = sqrtl(dot3(n, n));
    for (int k = 0; k < 3; k++) {
        n[k] /= length;
    }
}

typedef struct curved_worst {
    long double turn, loose, promised, moved;
    long chosen, affine_chosen;
} curved_worst;

/* From the quadratic through six directions, of M as the tier has it, to the true one, in perspective. */
static void check_curved_point(const case_triangle *t, const glint_choice *choice, const long double b[3],
                               curved_worst *worst)
{
    static const long double corner[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const long double middle[3][3] = {{0.5L, 0.5L, 0}, {0, 0.5L, 0.5L}, {0.5L, 0, 0.5L}};
    long double used[3], real[3], n[3], m[3], off[3], moved[3];
    for (int i = 0; i < 3; i++) {
        used[i] = choice->weight_q15[i] / 32768.0L;
        real[i] = t->inverse_depth[i];
    }
    direction_at(t, b, real, n);
    direction_at(t, b, used, m);
    for (int k = 0; k < 3; k++) {
        off[k] = -m[k];
        moved[k] = m[k] - n[k];
    }
    for (int i = 0; i < 3; i++) {
        long double at[3], half[3];
        direction_at(t, corner[i], used, at);
        direction_at(t, middle[i], used, half);
        for (int k = 0; k < 3; k++) {
            off[k] += b[i] * (2 * b[i] - 1) * at[k] + 4 * b[i] * b[(i + 1) % 3] * half[k];
        }
    }
    const bool affine = weights_are_left_out(t, choice);
    const long double moved_units = affine ? t->bound.turned * sqrtl(dot3(moved, moved)) : 0;
    worst->moved = worse(worst->moved, moved_units);
    worst->promised = worse(worst->promised,
                            (t->bound.diffuse * sqrtl(dot3(off, off)) + moved_units) / curved_room(&t->bound, choice));
}

/* The longest edge of M's triangle over the least |M|, which a grid comes near to. */
static long double turn_of(const case_triangle *t, const glint_choice *choice)
{
    enum { GRID = 8 };
    long double weight[3], edge = 0, least = 4;
    for (int i = 0; i < 3; i++) {
        weight[i] = choice->weight_q15[i] / 32768.0L;
    }
    for (int i = 0; i < 3; i++) {
        long double d[3];
        for (int k = 0; k < 3; k++) {
            d[k] = weight[i] * t->normal[i][k] - weight[(i + 1) % 3] * t->normal[(i + 1) % 3][k];
        }
        edge = worse(edge, dot3(d, d));
    }
    for (int i = 0; i <= GRID; i++) {
        for (int j = 0; j <= GRID - i; j++) {
            const long double b[3] = {(long double)i / GRID, (long double)j / GRID, (long double)(GRID - i - j) / GRID};
            long double m[3];
            weighted(t->normal, b, weight, m);
            least = fminl(least, dot3(m, m));
        }
    }
    return sqrtl(edge / least);
}

static void curves_keep_their_promise(void **state)
{
    curved_worst worst;
    (void)state;
    memset(&worst, 0, sizeof worst);
    worst.loose = 10;
    for (int round = 0; round < 200000; round++) {
        case_triangle t;
        glint_choice choice;
        random_triangle(&t);
        glint_bound_choose(&t.bound, t.inverse_depth, 0, GLINT_TIER_CURVED, GLINT_TIER_CURVED, &choice);
        if (choice.tier != GLINT_TIER_CURVED) {
            assert_true(choice.tier > GLINT_TIER_CURVED); /* one that serves it, as `greatest` only asks for a tier */
            continue;
        }
        const long double turn = turn_of(&t, &choice);
        worst.chosen++;
        worst.affine_chosen += weights_are_left_out(&t, &choice);
        worst.turn = worse(worst.turn, turn * ONE_Q16 / choice.turn_q16);
        if (turn > 0.1L) {
            worst.loose = fminl(worst.loose, turn * ONE_Q16 / choice.turn_q16);
        }
        for (int i = 0; i < 12; i++) {
            long double b[3];
            random_point(b, i);
            check_curved_point(&t, &choice, b, &worst);
        }
    }
    print_message("    %ld triangles, %ld of them without perspective correction\n", worst.chosen, worst.affine_chosen);
    assert_true(worst.chosen > 50000 && worst.affine_chosen > 5000);
    expect_bound("turn of M, over what the choice says", worst.turn, 1);
    assert_true(worst.loose > 0.3L); /* edges up to sqrt(D + (1 - u)^2), |M| from u sqrt(1 - D/3) on */
    expect_bound("error of the curve and of weights left out, over the promise", worst.promised, 1);
}

/* A triangle just so flat that perspective is left out, and where that costs most: between two corners whose normals
 * and depths differ. The light hardly counts, but what a turn changes does, as for a sharp highlight. */
static void leaving_perspective_out_costs_its_allowance(void **state)
{
    long double most = 0, promised = 0;
    (void)state;
    for (int round = 0; round < 20000; round++) {
        case_triangle t;
        glint_choice choice;
        random_triangle(&t);
        t.bound = (glint_bound){.diffuse = 1,
                                .turned = (uint32_t)exp2l(12 + 7 * random_unit()),
                                .exact = 200,
                                .flat = 70000,
                                .chord_q16 = t.bound.chord_q16};
        memcpy(t.normal[2], t.normal[1], sizeof t.normal[1]);
        long double d[3];
        for (int k = 0; k < 3; k++) {
            d[k] = t.normal[0][k] - t.normal[1][k];
        }
        t.bound.chord_q16 = (uint32_t)ceill(dot3(d, d) * ONE_Q16);
        if (t.bound.chord_q16 < 300) {
            continue; /* a chord is rounded up to 1/65536 */
        }
        int32_t low = (int32_t)1 << 27, high = (int32_t)1 << 28; /* of the other corners' inverse depth */
        while (high - low > 1000) {
            const int32_t between = low + (high - low) / 2;
            t.inverse_depth[0] = (int32_t)1 << 28;
            t.inverse_depth[1] = t.inverse_depth[2] = between;
            glint_bound_choose(&t.bound, t.inverse_depth, 0, GLINT_TIER_CURVED, GLINT_TIER_CURVED, &choice);
            const bool left_out = choice.weight_q15[1] == 32768;
            low = left_out ? low : between;
            high = left_out ? between : high;
        }
        t.inverse_depth[1] = t.inverse_depth[2] = high;
        glint_bound_choose(&t.bound, t.inverse_depth, 0, GLINT_TIER_CURVED, GLINT_TIER_CURVED, &choice);
        if (choice.tier != GLINT_TIER_CURVED || !weights_are_left_out(&t, &choice)) {
            continue;
        }
        curved_worst worst;
        memset(&worst, 0, sizeof worst);
        for (int i = 0; i <= 32; i++) {
            const long double b[3] = {i / 32.0L, 1 - i / 32.0L, 0};
            check_curved_point(&t, &choice, b, &worst);
        }
        most = worse(most, worst.moved);
        promised = worse(promised, worst.promised);
    }
    expect_bound("perspective left out, 1/256 code", most, AFFINE_UNITS);
    expect_at_most("that and the curve's error, over the promise", promised, 1);
}

/* A light at a point adds its own turn: to curves only, and no tier but the exact one is left where they do not serve.
 */
static void point_lights_count_their_turn(void **state)
{
    long curved = 0, refused = 0;
    (void)state;
    for (int round = 0; round < 100000; round++) {
        case_triangle t;
        glint_choice choice, far;
        random_triangle(&t);
        t.bound.point_diffuse = (uint32_t)random_between(1, (int32_t)t.bound.diffuse);
        t.bound.point_turn_q16 = (uint32_t)random_between(0, 60000);
        glint_bound_choose(&t.bound, t.inverse_depth, 0, GLINT_TIER_CURVED, GLINT_TIER_Q2, &choice);
        if (choice.tier != GLINT_TIER_CURVED) {
            assert_int_equal(choice.tier, GLINT_TIER_EXACT);
            refused++;
            continue;
        }
        curved++;
        assert_true(choice.turn_q16 + t.bound.point_turn_q16 <= GLINT_TURN_MOST_Q16);
        glint_bound direction = t.bound;
        direction.point_diffuse = direction.point_turn_q16 = 0;
        glint_bound_choose(&direction, t.inverse_depth, 0, GLINT_TIER_CURVED, GLINT_TIER_CURVED, &far);
        const long double alone = curved_room(&direction, &far), both = curved_room(&t.bound, &choice);
        const long double turn = choice.turn_q16 / ONE_Q16, more = turn + t.bound.point_turn_q16 / ONE_Q16;
        const long double added = 0.0262L * t.bound.point_diffuse * (powl(more, 3) - powl(turn, 3));
        assert_true(both > alone + added * 0.99L - 3 && both < alone + added * 1.01L + 20);
    }
    assert_true(curved > 5000 && refused > 5000);
}

/* A greater tolerance never takes a dearer tier; and a tier outside of least..greatest is not taken. */
static void more_tolerance_is_no_dearer(void **state)
{
    (void)state;
    for (int round = 0; round < 20000; round++) {
        case_triangle t;
        uint8_t before = GLINT_TIER_EXACT;
        random_triangle(&t);
        t.bound.point_diffuse = round % 4 ? 0 : t.bound.diffuse / 2;
        t.bound.flat = round % 3 ? t.bound.flat : 70000;
        for (int tolerance = GLINT_LEAST_TOLERANCE; tolerance <= 255; tolerance++) {
            glint_choice choice;
            glint_bound_choose(&t.bound, t.inverse_depth, (uint8_t)tolerance, GLINT_TIER_UNLIT, GLINT_TIER_EXACT,
                               &choice);
            assert_true(choice.tier <= before);
            assert_true(choice.tier == GLINT_TIER_EXACT || choice.promise <= tolerance * (GLINT_CODE_UNITS / 16));
            before = choice.tier;
        }
        for (int least = GLINT_TIER_CURVED; least <= GLINT_TIER_Q2; least++) {
            for (int greatest = least; greatest <= GLINT_TIER_EXACT; greatest++) {
                glint_choice choice;
                glint_bound_choose(&t.bound, t.inverse_depth, 0, (uint8_t)least, (uint8_t)greatest, &choice);
                assert_true(choice.tier >= least);
                assert_true(choice.tier != GLINT_TIER_CURVED || least == GLINT_TIER_CURVED);
            }
        }
        glint_choice choice;
        glint_bound_choose(&t.bound, t.inverse_depth, 0, GLINT_TIER_FLAT, GLINT_TIER_GOURAUD, &choice);
        assert_true(choice.tier != GLINT_TIER_CURVED && choice.tier != GLINT_TIER_GOURAUD);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(curves_keep_their_promise),
        numeric_test(leaving_perspective_out_costs_its_allowance),
        numeric_test(point_lights_count_their_turn),
        numeric_test(more_tolerance_is_no_dearer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
