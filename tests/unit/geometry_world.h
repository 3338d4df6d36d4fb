/* SPDX-License-Identifier: MIT */
/*
 * Random cameras and places for the tests of the geometry, and what they mean in long double: the formulas of
 * <glint/scene.h> alone.
 */
#ifndef GLINT_TESTS_UNIT_GEOMETRY_WORLD_H
#define GLINT_TESTS_UNIT_GEOMETRY_WORLD_H

#include "tests/unit/numeric.h"

#include <glint/error.h>
#include <glint/place.h>

#include "geometry/place.h"
#include "geometry/view.h"

#define PI 3.14159265358979323846L
#define ONE_Q16 ((int32_t)1 << 16)
#define Q16(x) ((int32_t)roundl((x)*65536.0L))

typedef struct exact_view {
    long double basis[3][3], eye[3], focal, near;
    long double up_sine; /* of the angle between up and the view direction: a small one makes the basis uncertain */
} exact_view;

static inline long double dot(const long double a[3], const long double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross_product(const long double a[3], const long double b[3], long double out[3])
{
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        out[k] = a[i] * b[j] - a[j] * b[i];
    }
}

static inline long double normalise(long double v[3])
{
    const long double length = sqrtl(dot(v, v));
    for (int k = 0; k < 3; k++) {
        v[k] /= length;
    }
    return length;
}

static inline exact_view exact_view_of(const glint_camera *camera, int height_px)
{
    exact_view e;
    long double up[3];
    for (int k = 0; k < 3; k++) {
        e.basis[2][k] = (long double)camera->target_q16[k] - camera->eye_q16[k];
        e.eye[k] = camera->eye_q16[k] / 65536.0L;
        up[k] = camera->up[k];
    }
    if (dot(up, up) == 0) {
        up[1] = 1;
    }
    (void)normalise(e.basis[2]);
    (void)normalise(up);
    cross_product(e.basis[2], up, e.basis[0]);
    e.up_sine = normalise(e.basis[0]);
    cross_product(e.basis[2], e.basis[0], e.basis[1]);
    e.focal = height_px / 2.0L / tanl(camera->field_of_view_turn16 * PI / 65536);
    e.near = camera->near_q16 / 65536.0L;
    return e;
}

/* The matrix of a place; all zero is the identity. */
static inline void exact_linear_of(const glint_place *place, long double out[3][3])
{
    int32_t any = 0;
    for (int i = 0; i < 9; i++) {
        out[i / 3][i % 3] = place->linear_q16[i / 3][i % 3] / 65536.0L;
        any |= place->linear_q16[i / 3][i % 3];
    }
    for (int i = 0; !any && i < 3; i++) {
        out[i][i] = 1;
    }
}

static inline void multiply_exactly(long double a[3][3], long double b[3][3], long double out[3][3])
{
    for (int i = 0; i < 9; i++) {
        out[i / 3][i % 3] = a[i / 3][0] * b[0][i % 3] + a[i / 3][1] * b[1][i % 3] + a[i / 3][2] * b[2][i % 3];
    }
}

/* A rotation from a random unit quaternion. */
static inline void random_rotation(long double r[3][3])
{
    long double q[4], square = 0;
    do {
        square = 0;
        for (int i = 0; i < 4; i++) {
            q[i] = 2 * random_unit() - 1;
            square += q[i] * q[i];
        }
    } while (square > 1 || square < 0.01L);
    const long double s = 2 / square, w = q[0], x = q[1], y = q[2], z = q[3];
    const long double m[3][3] = {{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
                                 {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
                                 {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}};
    memcpy(r, m, sizeof m);
}

/* A rotation times scales along the model's axes, rounded to Q16. */
static inline glint_place place_of(long double r[3][3], const long double scale[3])
{
    glint_place place = {{{0}}, {0}};
    for (int i = 0; i < 9; i++) {
        place.linear_q16[i / 3][i % 3] = Q16(r[i / 3][i % 3] * scale[i % 3]);
    }
    return place;
}

/* Rotation times a uniform scale of 1/2..1000 (mirrored at times), or scales that differ up to 30 times, or sheared. */
static inline glint_place random_place(bool uniform)
{
    long double r[3][3], scale[3];
    random_rotation(r);
    scale[0] = exp2l(-1 + 10 * random_unit());
    for (int k = 1; k < 3; k++) {
        scale[k] = uniform ? scale[0] : fminl(scale[0] * exp2l(5 * random_unit() - 3), 1000);
    }
    if (random_u32() & 1) {
        scale[2] = -scale[2];
    }
    glint_place place = place_of(r, scale);
    if (!uniform && random_u32() & 1) {
        for (int i = 0; i < 3; i++) {
            place.linear_q16[i][0] += place.linear_q16[i][1] / 4;
        }
    }
    return place;
}

/* A direction of random_between() parts that is not nearly zero. */
static inline void random_direction(long double v[3])
{
    long double r[3][3];
    random_rotation(r);
    memcpy(v, r[0], sizeof r[0]);
}

/* Eye up to 16000 units away, looking anywhere, with an up that is at least 3 degrees off. */
static inline glint_camera random_camera(void)
{
    glint_camera camera;
    memset(&camera, 0, sizeof camera);
    do {
        long double direction[3];
        const long double distance = exp2l(13 * random_unit());
        random_direction(direction);
        for (int k = 0; k < 3; k++) {
            camera.eye_q16[k] = random_any_size(29);
            camera.target_q16[k] = camera.eye_q16[k] + Q16(direction[k] * distance);
            camera.up[k] = (int16_t)random_between(-32768, 32767);
        }
    } while (exact_view_of(&camera, 1).up_sine < 0.05L);
    camera.field_of_view_turn16 = (uint16_t)random_between(182, 30947);
    camera.near_q16 = (int32_t)(64 * exp2l(14 * random_unit()));
    return camera;
}

#endif
