/* SPDX-License-Identifier: MIT */
/*
 * The worst error of the unit vectors that measure.c finds. A part of that file.
 */
#ifndef GLINT_TESTS_PROOFS_MEASURE_UNIT_H
#define GLINT_TESTS_PROOFS_MEASURE_UNIT_H

typedef bool (*unit_routine)(const int32_t v[3], int32_t unit[3]);

/* In units of the result's last place, 1/one. */
static double unit_error(unit_routine routine, long double one, const int32_t v[3])
{
    int32_t unit[3];
    double worst = 0;
    (void)routine(v, unit);
    /* long double: in Q28 an error of 2^-52 would count */
    const long double x = v[0], y = v[1], z = v[2], length = sqrtl(x * x + y * y + z * z);
    for (int k = 0; k < 3; k++) {
        worst = larger(worst, (double)fabsl(unit[k] - one * v[k] / length));
    }
    return worst;
}

/* Components of 16 bits of a vector about as long as `length`, the first `part` of it, the others by the angle. */
static void components(double length, double part, double angle, uint32_t w[3])
{
    const double rest = sqrt(1 - part * part), share[3] = {part, rest * cos(angle), rest * sin(angle)};
    for (int k = 0; k < 3; k++) {
        w[k] = share[k] * length < 65535 ? (uint32_t)(share[k] * length) : 65535;
    }
}

/* About where the proof has its maximum. */
#if GLINT_SMALL_TABLES
static const int32_t worst_found[3] = {493748223, 204537856, 1074659328};

/* Another component is the largest, and no larger than it must be: there the rounding weighs most. */
static void weak_components(uint32_t w[3])
{
    w[0] = 13000 + random_u32() % 6000;
    w[1] = 6000 + random_u32() % 8192;
    w[2] = 32768 + random_u32() % 256;
}
#else
static const int32_t worst_found[3] = {1922400256, 648904703, 650313727};

/* The length is where the root is worst, and its error weighs by the component. */
static void weak_components(uint32_t w[3])
{
    components(32768 * sqrt(random_within(3.93, 4)), random_within(0.8, 0.95), acos(-1) / 4 + random_within(-0.2, 0.2),
               w);
}
#endif

/* Vectors whose components all lie half a unit off what stands for them, in the directions that add up: the first one
 * way, the others the other way. Half of the trials goes all over. */
static double worst_unit_q15(void)
{
    double worst = unit_error(glint_unit_q15, 32768, worst_found);
    for (long trial = 0; trial < 40000000; trial++) {
        uint32_t w[3];
        int32_t v[3];
        if (trial % 4 < 2) {
            components(32768 * sqrt(random_within(1, 12)), random_within(0, 1), random_within(0, acos(-1) / 2), w);
        } else {
            weak_components(w);
        }
        for (int k = 0; k < 3; k++) {
            /* halved, to fit int32_t; the routine shifts it back */
            v[k] = (int32_t)((w[k] << 16 | ((k == 0) == (trial % 2 == 0) ? 0 : 0xffff)) >> 1);
        }
        worst = larger(worst, unit_error(glint_unit_q15, 32768, v));
    }
    return worst;
}

/* The largest component just above 2^31 after the shift, where what the sum loses weighs most. */
static double worst_unit_q28(void)
{
    double worst = 0;
    for (long trial = 0; trial < 20000000; trial++) {
        const uint32_t large = (uint32_t)1 << 30, small = trial % 4 == 0 ? 29 : 1 + random_u32() % 14;
        const int32_t v[3] = {(int32_t)(large + (random_u32() >> (2 + small))), (int32_t)(random_u32() >> (1 + small)),
                              (int32_t)(random_u32() >> (1 + small))};
        worst = larger(worst, unit_error(glint_unit_q28, 268435456, v));
    }
    return worst;
}

#endif
