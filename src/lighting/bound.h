/* SPDX-License-Identifier: MIT */
/*
 * How far cheap shading may be off on one triangle, and which tier of it fits a tolerance. Integers, compiled once for
 * both backends.
 *
 * N, the interpolated normal, is linear over the triangle and shorter than 1: with corner normals n_i of unit length
 * and D the greatest |n_i - n_j|^2, 1 - D/3 <= |N|^2 <= 1. With corners weighted by u_i = (1/w_i) / (greatest 1/w), M =
 * sum of u_i n_i on the screen has the direction of the perspective-correct normal exactly, and u^2 (1 - D/3) <= |M|^2
 * <= 1 with u the least weight. So a cosine is s |M|^-1 with s = M.l linear on the screen, and only the function
 * x^(-1/2) of x = |M|^2, a quadratic on the screen, has to be approximated, once for all lights: by a constant
 * (Gouraud), a polynomial of first degree (q1) or of second degree (q2) in 1 - x. A table gives each approximation, and
 * its greatest relative error, for the range of 1 - x that it is used on.
 */
#ifndef GLINT_LIGHTING_BOUND_H
#define GLINT_LIGHTING_BOUND_H

#include <stdbool.h>
#include <stdint.h>

#include <glint/quality.h>

#include "number/integer.h"

/* Errors and peaks are in 1/256 code. */
#define GLINT_CODE_UNITS 256

/* The polynomial c0 + c1 y + c2 y^2, y = 1 - x, and its relative error. */
typedef struct glint_curve {
    uint16_t c_q15[3];
    uint16_t error_q16;
} glint_curve;

/* A curve that errs by more, 1/25, is not used, however dark the light: steps of a ramp have room for so much. */
#define GLINT_CURVE_MOST_Q16 2600

/* D of a right angle between normals, and of 117 degrees: up to it |N| is above 0.18, so that rounding of the corners'
 * normals counts for at most 5.5 times as much. Beyond, no error is promised. */
#define GLINT_CHORD_BENT_Q16 (2u * 65536)
#define GLINT_CHORD_MOST_Q16 (29u * 65536 / 10)

#define GLINT_CURVE_DEGREES 3 /* 0: Gouraud, 1: q1, 2: q2 */

/* The class of a range of y, 0..GLINT_CURVE_CLASSES - 1, or GLINT_CURVE_CLASSES beyond the last. */
uint8_t glint_curve_class(uint32_t y_q16);
void glint_curve_of(uint8_t class, uint8_t degree, glint_curve *curve);

/* A reflected light in 1/256 code: 255 of them are 1 (32768). */
static inline uint32_t glint_bound_codes(uint32_t light_q15)
{
    return (light_q15 * 255 + 127) >> 7;
}

/* What a left out highlight may add: 1/16 code. */
#define GLINT_HIGHLIGHT_LEFT (GLINT_CODE_UNITS / 16)

/*
 * Rounding: that of a cosine is at most 3 2^-14 (1.8e-4): light direction 2.6e-5, corner normals and weights 3.5e-5,
 * the cosine's field and its cut to Q15 2.5e-5, the length's field and its cuts 7.5e-5. Each of `terms` products
 * of a light and a reflectance is rounded to half a unit of Q15, 1/256 code, and its addition to half of that; 2 more
 * are for the sum.
 */
static inline uint32_t glint_bound_rounding(uint32_t bright, uint32_t terms)
{
    return (3 * (bright >> 1) >> 13) + (3 * terms + 1) / 2 + 3;
}

/*
 * Fields err by their coefficients' rounding the more the farther a pixel is from their anchor, `reach` = |dx| + |dy|
 * pixels: a linear one by at most 8 units of Q28 a pixel (2^-25), the square by half a unit of Q30 of each square
 * coefficient (2^-31 of reach^2).
 */
static inline uint32_t glint_bound_reach(uint32_t bright, uint32_t reach)
{
    const uint32_t units = reach * reach + 64 * reach; /* of 2^-31; reach < 2^13 */
    if (reach < 64 && bright >> 18 == 0) {
        return 1; /* 2^1 2^18 2^13 / 2^32 rounds down to 0: spares small processors the wide product */
    }
    return multiply_high_u32(bright << 1, units) + 1;
}

/*
 * The same of curves, by `up`, how many bits the steepest gradient is below 1/2 a pixel: at most 4.2 times that for
 * gradients below 1/16 a pixel, and 46 times for any (measured on thin triangles up to 2048 pixels long).
 */
static inline uint32_t glint_bound_curve_reach(uint32_t bright, uint32_t reach, int up)
{
    const uint32_t units = reach * reach + 64 * reach;
    if (reach < 64 && up >= 3 && bright >> 18 == 0) {
        return (((bright >> 8) + 1) * (units * 5) >> 23) + 1; /* 2^10 5 2^13, as below but for the rounding up */
    }
    return reach > 3000 ? UINT16_MAX : multiply_high_u32(bright << 1, units * (up >= 3 ? 5 : 64)) + 1;
}

/* Where M changes by more than this from the anchor to a pixel, rounding of 2^-22 of its square would count. */
#define GLINT_REACH_MOST 8

/* The same of a specular term at the exact tier: its slope, at most 0.607 sqrt(exponent + 1.72), times the angle
 * between two directions that rounding moves by at most 2.5e-4. */
uint32_t glint_bound_gloss(uint32_t specular, uint16_t exponent_q4);

/*
 * The error of a specular term where lighting/precise.inc draws it: the slope by an angle of 3.2e-4, that of the table,
 * and a gap to 2^-23 for the ray's length. The angle is twice that of the normal, 7.9e-5 (raster/units_fixed.h), for r
 * turns twice as far; 2.6e-5 each for s and for r, 3e-5 for the cosine, and 7.9e-5 for the ray.
 */
uint32_t glint_bound_precise(uint32_t specular, uint16_t exponent_q4, uint8_t bits);
/* The same with vectors of Q28: an angle of 4e-5, which is that of the planes, and a gap to 2^-23. */
uint32_t glint_bound_fine(uint32_t specular, uint16_t exponent_q4, uint8_t bits);

/* What a highlight changes when the normal turns by a radian: r turns twice as far. */
uint32_t glint_bound_turned(uint32_t specular, uint16_t exponent_q4);

/* Angles in radians, Q15. A right angle is 51472. */
#define GLINT_FAR_Q15 ((uint32_t)1 << 17)

/* The greatest angle at which specular cos^exponent is above GLINT_HIGHLIGHT_LEFT: cos a <= exp(-a^2 / 2). */
uint32_t glint_bound_highlight_q15(uint32_t specular, uint16_t exponent_q4);
/* Is an angle whose cosine is 1 - gap certainly greater than one given? It is at least sqrt(2 gap); 2 at most is made
 * use of. */
static inline bool glint_bound_is_beyond(uint32_t gap_q15, uint32_t angle_q15)
{
    return angle_q15 <= 65535 && (gap_q15 > 65535 ? (uint32_t)65535 : gap_q15) << 16 > angle_q15 * angle_q15;
}

/* Twice the distance from any point of the triangle on the unit sphere to the nearest corner: with sides of at most a =
 * 2 asin(sqrt(D) / 2) <= sqrt(D) (1 + D / 20) for D <= 1, at most 0.6 a. */
uint32_t glint_bound_spread_q15(uint32_t chord_q16);
/* (1 - D/3)^(-1/2) - 1, at least */
uint32_t glint_bound_longer_q15(uint32_t chord_q16);

/* A table of cos^exponent by 1 - cosine, up to the gap of an angle: a / 2 in cells of 2^bits, Q28. */
#define GLINT_GLOSS_CELLS 512
void glint_bound_gloss_table(uint32_t angle_q15, uint8_t *bits, uint16_t *cells);

/* What linear interpolation in it errs by: (exponent cell)^2 / 8 of the specular peak; and a unit of rounding. */
uint32_t glint_bound_gloss_error(uint32_t specular, uint16_t exponent_q4, uint8_t bits);

/* An angle beyond which 1 - cosine is above `gap` although it errs by as much as costs `error`, at `gloss` a unit:
 * acos(1 - g) <= sqrt(2 g) (1 + g / 8) for g <= 1. */
uint32_t glint_bound_shows_q15(uint32_t gap_q28, uint32_t error, uint32_t gloss);

/* rate times factor (Q15), rounded up; saturates. */
static inline uint32_t glint_bound_scale(uint32_t rate, uint32_t factor_q15)
{
    return rate >> 26 ? UINT32_MAX : ((rate >> 4) + 1) * ((factor_q15 >> 7) + 1) >> 4;
}

/* Pixels that are clear of a highlight: what the angle of a cosine 1 - gap is beyond `highlight`, over `turn` (Q20) a
 * pixel; the latter as its inverse, pixels a unit of Q15 in Q20; 0 for more than 32
 * radians. */
uint32_t glint_bound_per_turn_q20(uint32_t turn_q20);
int32_t glint_bound_clear(uint32_t gap_q31, uint32_t highlight_q15, uint32_t per_turn_q20);

/*
 * The specular term's error when 1 - cosine is taken at every 2^log2th pixel and is quadratic between: 1/256 code.
 *
 * Along a row M is linear, so n runs along a great circle; with psi its angle from the point of the line nearest to the
 * origin and k >= |M'| / |M|, the first three derivatives of its angle are k cos psi, k^2 sin 2 psi and k^3 cos psi
 * (6 sin^2 psi - 2 cos^2 psi). r runs along a circle at twice that angle; its derivatives are at most 2 k, 4 k^2 and
 * 12 k^3. Those of c, at its own angle, are at most v, 1.16 v^2 and 3 v^3. So the third derivative of r.c is at most
 * 12 k^3 + 12 k^2 v + 7 k v^2 + 3 v^3. With h = (s + c) / |s + c|, |s + c| >= 1, that of n.h is at most 3 k^3 +
 * 4 k^2 v + 10 k v^2 + 20 v^3. The polynomial errs by 0.0642 of it times the cube of the distance, the power by
 * `exponent` times that. UINT32_MAX where the turns are too great. gloss = specular peak times exponent.
 */
uint32_t glint_bound_quadratic(uint32_t gloss, uint32_t normal_q20, uint32_t view_q20, int log2);

/*
 * Curves over a triangle: a cosine n.l is interpolated by the polynomial of degree 2 through its values at the corners
 * and the middles of the edges. With turn = (the longest edge of the triangle of M) / (the least |M| on it), the vector
 * from the interpolated n to the true one is at most 0.0262 turn^3 + 1.2e-5 long for turns up to 0.69 (found by
 * searching over shapes, tests/unit/test_curve_bounds.c; the third derivative's part of its Taylor formula alone would
 * prove 0.1), so the sum of lights errs by that times their sum, which is to be below 2^20.
 */
#define GLINT_TURN_MOST_Q16 45000 /* 0.69 */
uint32_t glint_bound_curve(uint32_t diffuse, uint32_t turn_q16);

/* By how much a gap may be off where it counts `together` times only: 2^-11. */
#define GLINT_GAP_OFF_Q28 ((uint32_t)1 << 17)

/* What the errors of cubics depend on. */
typedef struct glint_cubic_size {
    uint32_t together;     /* what all the gaps at one place cost in 1/256 code a unit, if that is less than `gloss` */
    uint32_t view_q16;     /* the longest edge of the triangle of rays R, over the least |R| on it: their turn */
    uint32_t part_q15;     /* |M|^2 lies within 1 - part..1 + part times a constant; at most 1/3 */
    uint32_t inverse_q22;  /* the relative error of the polynomial for 1/|M|^2 */
    uint32_t reach;        /* the greatest |dx| + |dy| from the centroid to a pixel, */
    uint32_t anchor_reach; /* and from the gradients' anchor */
    uint32_t end_q28;      /* where the table of the specular term ends */
    int up, down; /* of raster/lattice_fixed.h: spare bits of the gradients, and bits that the values have less */
} glint_cubic_size;

/*
 * A highlight's |M|^2 (1 - r.c) by a polynomial of degree 3 through ten points errs by at most |M|^2 view^2 (0.0103
 * turn^2 + 0.0136 turn view + 0.0064 view^2) (searched for like the above). Rounding adds to the former at n pixels
 * from the centroid C(n, 3) units of 2^(down - 32) (1 + 3/2 part) for the rounding of a third difference, C(n, 2) for
 * that of a second and n for a first, each half a unit and what its products were cut by; and the table's argument is
 * rounded to 1.5 2^-15 of its end. All of it counts `gloss` times, the specular peak times the exponent. The relative
 * errors of 1/|M|^2, with 1e-4 and (n + 5)^2 3 2^-31 at n pixels from the anchor for rounding (see
 * raster/lattice_fixed.h), are of a gap g, and g exponent (1 - g)^(exponent - 1) is at most 1 for exponents from 1 on,
 * 1/2 from 2 on, which `specular` is to account for. UINT32_MAX where there is no bound: coefficients may not fit where
 * `up` is below 2.
 */
uint32_t glint_bound_cubic(const glint_cubic_size *size, uint32_t gloss, uint32_t specular, uint32_t turn_q16);

/* What is known of a triangle before it is drawn. */
typedef struct glint_bound {
    uint32_t diffuse;       /* 1/256 code: what the lights that reach it can add, the channel with the most */
    uint32_t point_diffuse; /* 1/256 code: the part of it of point lights, */
    uint32_t
        point_turn_q16;   /* and the greatest turn of the direction to one: only curves and the exact tier serve them */
    uint32_t turned;      /* 1/256 code: what a turn of the normal by a radian changes at most, highlights included */
    uint32_t left, gloss; /* 1/256 code: highlights where they are left out, and errors of them where they are not */
    uint32_t reach;       /* 1/256 code: rounding of fields by the distance from their anchor, */
    uint32_t curve_reach; /* and of curves */
    uint32_t fixed;       /* 1/256 code: rounding and table errors of the tiers below exact */
    uint32_t exact;       /* 1/256 code: error of the exact tier, rounding of the result included */
    uint32_t flat;        /* the same of one colour for all of it; where above the tolerance, at least */
    uint32_t chord_q16;   /* D, rounded up */
} glint_bound;

/* The choice for a triangle. */
typedef struct glint_choice {
    uint8_t tier;
    uint16_t promise;       /* 1/256 code */
    uint16_t weight_q15[3]; /* u of each corner; all 32768 where perspective need not be corrected */
    glint_curve curve;      /* of tiers Gouraud to q2 */
    uint32_t longest_q15;   /* 1/|M| at most; for tiers q1 and q2 */
    uint32_t turn_q16;      /* see glint_bound_curve(); for the tier of curves */
} glint_choice;

/*
 * The cheapest tier for corners of these inverse depths (in any common scale, > 0), within `tolerance` (1/16 code; 0:
 * any); not below `least` nor above GLINT_TIER_EXACT. When none below exact fits, it is exact.
 */
void glint_bound_choose(const glint_bound *bound, const int32_t inverse_depth[3], uint8_t tolerance, uint8_t least,
                        uint8_t greatest, glint_choice *choice);

#endif
