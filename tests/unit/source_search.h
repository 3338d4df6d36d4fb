/* SPDX-License-Identifier: MIT */
/*
 * Searches for the greatest difference between the point lights that stand for an extended source and the integral over
 * it: a surface point and what it sees, changed at random as long as the difference grows. The integral is the
 * reference's (tests/reference/area.c), the points are the library's.
 */
#ifndef GLINT_TESTS_UNIT_SOURCE_SEARCH_H
#define GLINT_TESTS_UNIT_SOURCE_SEARCH_H

#include "tests/unit/numeric.h"

#include "lighting/source.h"
#include "tests/reference/internal.h"

/* World units from the surface point, which is the origin, to the source's centre: so many that Q16 is fine. */
#define AWAY 4096.0

enum { DIFFUSE, SPECULAR, GATED };

/* What is searched: by a rule for a kind of light, at a size over the distance; for specular terms that is any, and
 * `spread` is size times the root of the exponent. */
typedef struct search {
    uint8_t kind, rule;
    int term;
    bool fades, blinn;
    double size, spread;
} search;

/* What is seen. Directions of unit length. */
typedef struct sight {
    vector n, c, toward, edge[2];
    double size, reach, k[3]; /* reach: the attenuation's range over the distance, 0: none */
} sight;

static double random_step(void)
{
    return (double)(random_unit() + random_unit() + random_unit() + random_unit() - 2) * 1.73;
}

static vector random_vector(void)
{
    const double x = random_step(), y = random_step(), z = random_step();
    return vector_of(x, y, z);
}

static inline vector moved(vector v, double by)
{
    return unit(plus(v, times(by, random_vector())));
}

/* So that the exponent is at least 2: below that it has a kink, as the cosine has. */
static inline double most_size(const search *what)
{
    return fmin(0.98, what->spread / sqrt(2.0));
}

static inline void sight_random(sight *at, const search *what)
{
    at->toward = unit(random_vector());
    at->n = unit(random_vector());
    at->c = unit(random_vector());
    at->edge[0] = unit(random_vector());
    at->edge[1] = times(random_u32() & 1 ? 1.0 : (double)random_unit(), unit(random_vector()));
    if (random_u32() & 1) { /* a rectangle */
        at->edge[1] = times(length(at->edge[1]), unit(cross(at->edge[0], at->edge[1])));
    }
    if (what->term != DIFFUSE && random_u32() & 1) { /* in the middle of the highlight */
        at->n = unit(plus(at->c, at->toward));
    }
    at->size = what->size > 0.0 ? what->size : most_size(what) * exp2(-5.0 * (double)random_unit());
    at->reach = random_u32() & 1 ? 0.0 : 0.3 + 1.5 * (double)random_unit();
    for (int i = 0; i < 3; i++) {
        at->k[i] = random_u32() & 1 ? 0.0 : 2.0 * (double)random_unit();
    }
}

static inline void sight_change(sight *at, const search *what, double by)
{
    const uint32_t of = random_u32();
    at->toward = of & 1 ? moved(at->toward, by) : at->toward;
    at->n = of & 2 ? moved(at->n, by) : at->n;
    at->c = of & 4 ? moved(at->c, by) : at->c;
    for (int i = 0; i < 2; i++) {
        at->edge[i] = of & 8 ? plus(at->edge[i], times(by, random_vector())) : at->edge[i];
    }
    if (what->size == 0.0 && of & 16) {
        at->size = fmin(most_size(what), at->size * exp2(by * random_step()));
    }
    at->reach = of & 32 ? fmax(0.0, at->reach + by * random_step()) : at->reach;
    for (int i = 0; i < 3; i++) {
        at->k[i] = of & 64 ? fmin(3.9, fmax(0.0, at->k[i] + by * random_step())) : at->k[i];
    }
}

/* The light in the library's format. */
static inline glint_light light_of(const sight *at, const search *what)
{
    glint_light light;
    memset(&light, 0, sizeof light);
    light.kind = what->kind;
    light.samples = GLINT_MAX_SAMPLES;
    const double toward[3] = {at->toward.x, at->toward.y, at->toward.z};
    const double size =
        at->size / fmax(length(plus(at->edge[0], at->edge[1])), length(minus(at->edge[0], at->edge[1])));
    for (int k = 0; k < 3; k++) {
        light.position_q16[k] = (int32_t)lrint(toward[k] * AWAY * 65536.0);
    }
    for (int i = 0; i < 2 && what->kind == GLINT_PANEL; i++) {
        const double edge[3] = {at->edge[i].x, at->edge[i].y, at->edge[i].z};
        for (int k = 0; k < 3; k++) {
            light.edge_q16[i][k] = (int32_t)lrint(edge[k] * size * AWAY * 65536.0);
        }
    }
    light.radius_q16 = (int32_t)lrint(at->size * AWAY * 65536.0);
    if (what->fades) {
        for (int i = 0; i < 3; i++) {
            light.attenuation.k_q14[i] = (uint16_t)lrint(at->k[i] * 16384.0);
        }
        light.attenuation.unit_q16 = (uint32_t)(AWAY * 65536.0);
        light.attenuation.range_q16 = (uint32_t)(at->reach * AWAY * 65536.0);
    }
    return light;
}

static inline double exponent_of(const sight *at, const search *what)
{
    const double x = what->spread / at->size;
    return what->term == DIFFUSE ? 1.0 : fmin(1024.0, x * x);
}

static inline double difference(const sight *at, const search *what)
{
    const glint_light light = light_of(at, what);
    const uint8_t count = glint_source_points(what->rule);
    const surface f = {.exponent = exponent_of(at, what), .blinn = what->blinn};
    const vector origin = {0.0, 0.0, 0.0};
    lamp l, one;
    lamp_load(&l, &light);
    const area_mean exact = area_light(&l, &f, origin, at->n, at->c);
    area_mean sum = {0.0, 0.0};
    for (uint8_t i = 0; i < count; i++) {
        glint_light point;
        vector s;
        lamp_load(&one, glint_source_point(&light, count, i, &point));
        one.is_area = false;
        if (lamp_toward(&one, origin, &s) && dot(at->n, s) > 0.0) {
            const double factor = lamp_factor(&one, origin, s) / count;
            sum.diffuse += factor * dot(at->n, s);
            sum.specular += factor * shade_highlight(&f, at->n, s, at->c);
        }
    }
    return what->term == DIFFUSE ? fabs(sum.diffuse - exact.diffuse) : fabs(sum.specular - exact.specular);
}

/* The greatest angle between s and c over the source, at most; what the gate may cut off of a specular term by it. */
static inline double gate_of(const sight *at, const search *what)
{
    const double widest = acos(fmax(-1.0, fmin(1.0, dot(at->toward, at->c)))) + asin(at->size);
    const double cosine = what->blinn ? sin(fmin(3.14159265, widest) / 2.0) : -cos(fmin(3.14159265, widest));
    return pow(fmax(0.0, cosine), exponent_of(at, what));
}

/* What is looked at: specular terms where the gate cuts off less than 1/1000, or any, less what the gate explains. */
static inline double score(const sight *at, const search *what)
{
    if (what->term == SPECULAR && gate_of(at, what) > 0.001) {
        return 0.0;
    }
    if (what->blinn && dot(at->toward, at->c) < -0.4 + at->size) {
        return 0.0; /* s and c nearly cancel */
    }
    return difference(at, what);
}

static inline double climb(const search *what, int starts, int steps)
{
    double found = 0.0;
    for (int start = 0; start < starts; start++) {
        sight best, now;
        double most = 0.0, by = 0.3;
        for (int round = 0; round < 20; round++) {
            sight_random(&now, what);
            const double there = score(&now, what);
            if (round == 0 || there > most) {
                most = there;
                best = now;
            }
        }
        for (int step = 0; step < steps; step++) {
            now = best;
            sight_change(&now, what, by);
            const double there = score(&now, what);
            if (there > most) {
                most = there;
                best = now;
            } else {
                by *= 0.985;
            }
        }
        found = fmax(found, most);
    }
    return found;
}

#endif
