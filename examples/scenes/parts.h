/* SPDX-License-Identifier: MIT */
/*
 * Constants of the scenes' formats from decimal values, in integer arithmetic: the same bits whatever the compiler
 * makes of floating point. Lengths, factors and colours are written in thousandths: 2500 is 2.5. All are constant
 * expressions for initialisers, arguments must be constants.
 */
#ifndef EXAMPLES_SCENES_PARTS_H
#define EXAMPLES_SCENES_PARTS_H

#include <stdint.h>

#include <examples/meshes/meshes.h>
#include <examples/scenes/scenes.h>

/* The fraction n / d in units of 1 / one, rounded to nearest, halves away from zero; d > 0. */
#define PARTS_ROUNDED(n, d, one)                                                                                       \
    ((2 * (int64_t)(n) * (one) + ((n) < 0 ? -(int64_t)(d) : (int64_t)(d))) / (2 * (int64_t)(d)))

#define Q14(n, d) ((int16_t)PARTS_ROUNDED(n, d, 16384))
#define Q16(n, d) ((int32_t)PARTS_ROUNDED(n, d, 65536))
#define MILLI_Q16(thousandths) Q16(thousandths, 1000)

/* 182.04 parts of a turn to the degree */
#define DEGREES_TURN16(degrees) ((uint16_t)PARTS_ROUNDED(degrees, 360, 65536))

/* A glint_colour, and one of `share` thousandths of that colour. */
#define COLOUR(r, g, b)                                                                                                \
    {                                                                                                                  \
        Q14(r, 1000), Q14(g, 1000), Q14(b, 1000)                                                                       \
    }
#define SHARE(share, r, g, b)                                                                                          \
    {                                                                                                                  \
        Q14((int32_t)(share) * (r), 1000000), Q14((int32_t)(share) * (g), 1000000),                                    \
            Q14((int32_t)(share) * (b), 1000000)                                                                       \
    }

/* A point. */
#define POINT(x, y, z)                                                                                                 \
    {                                                                                                                  \
        MILLI_Q16(x), MILLI_Q16(y), MILLI_Q16(z)                                                                       \
    }

/* Places: the model's axes scaled, then shifted. */
#define PLACE_SCALED(sx, sy, sz, x, y, z)                                                                              \
    {                                                                                                                  \
        .linear_q16 = {{MILLI_Q16(sx), 0, 0}, {0, MILLI_Q16(sy), 0}, {0, 0, MILLI_Q16(sz)}},                           \
        .origin_q16 = POINT(x, y, z)                                                                                   \
    }
#define PLACE_AT(x, y, z) PLACE_SCALED(1000, 1000, 1000, x, y, z)

/*
 * Scaled, turned about y by the angle whose cosine is c / h and sine s / h, then shifted. With a Pythagorean triple
 * (c, s, h) these are exact: (15, 8, 17) is 28.07 degrees, (4, 3, 5) 36.87 degrees, (24, 7, 25) 16.26 degrees.
 * A positive sine turns counter-clockwise seen from above.
 */
#define PLACE_TURNED(c, s, h, scale, x, y, z)                                                                          \
    {                                                                                                                  \
        .linear_q16 = {{Q16((int32_t)(c) * (scale), 1000L * (h)), 0, Q16((int32_t)(s) * (scale), 1000L * (h))},        \
                       {0, MILLI_Q16(scale), 0},                                                                       \
                       {Q16(-(int32_t)(s) * (scale), 1000L * (h)), 0, Q16((int32_t)(c) * (scale), 1000L * (h))}},      \
        .origin_q16 = POINT(x, y, z)                                                                                   \
    }

#define LENGTH_OF(array) ((uint16_t)(sizeof(array) / sizeof((array)[0])))

#endif
