/* SPDX-License-Identifier: MIT */
/*
 * Polynomials on the screen through values at points of a triangle, in fixed point: of degree 2 through those at the
 * corners and the middles of the edges, of degree 3 through those at the corners, the thirds of the edges and the
 * centroid.
 *
 * In the barycentric coordinates b1, b2 of corners 1 and 2 the coefficients are small combinations of the values; and
 * on the screen b1 and b2 are linear, see gradients.h. All arithmetic is modulo 2^32 like that of plane.h: a value
 * inside the triangle is right, and does not depend on where the steps to it began. With values below 2^30 (2^26 for
 * degree 3), coefficients are below 2^31. Rounding of the coefficients on the screen, n = |dx| + |dy| pixels from the
 * anchor and with gradients `up` bits below 1/2 a pixel, costs a polynomial of degree 2 at most (1/2 + 3 2^(2 - 2 up))
 * (n + 1)^2 + (3 + 2 2^(2 - up)) (n + 1) units; glint_bound_cubic() has what it costs one of degree 3.
 */
#ifndef GLINT_RASTER_LATTICE_FIXED_H
#define GLINT_RASTER_LATTICE_FIXED_H

#include "raster/field_fixed.h"

/* Gradients of b1 and b2, Q(30 + up), and of b1^2, b1 b2, b2^2, Q(30 + 2 up), halved where they are of one direction.
 */
typedef struct lattice_gradients {
    int32_t x[2], y[2];
    int32_t xx[3], xy[3], yy[3];
    int up;
    int16_t offset_x, offset_y; /* from corner 0 to the anchor's centre, 1/4096 px */
} lattice_gradients;

static inline void lattice_prepare(lattice_gradients *to, const glint_gradients *from)
{
    to->up = glint_gradients_spare_bits(from); /* brings all just below 2^30 */
    for (int i = 0; i < 2; i++) {
        to->x[i] = (int32_t)((uint32_t)from->x[i] << to->up);
        to->y[i] = (int32_t)((uint32_t)from->y[i] << to->up);
    }
    const int32_t x1 = 2 * to->x[0], x2 = 2 * to->x[1], y1 = 2 * to->y[0], y2 = 2 * to->y[1];
    to->xx[0] = multiply_high_s32(x1, x1);
    to->xx[1] = multiply_high_s32(x1, x2);
    to->xx[2] = multiply_high_s32(x2, x2);
    to->xy[0] = 2 * multiply_high_s32(x1, y1);
    to->xy[1] = multiply_high_s32(x1, y2) + multiply_high_s32(x2, y1);
    to->xy[2] = 2 * multiply_high_s32(x2, y2);
    to->yy[0] = multiply_high_s32(y1, y1);
    to->yy[1] = multiply_high_s32(y1, y2);
    to->yy[2] = multiply_high_s32(y2, y2);
    to->offset_x = from->offset_x;
    to->offset_y = from->offset_y;
}

/* a1 b1 + a2 b2 per pixel, and the second-order terms a[0] b1^2 + a[1] b1 b2 + a[2] b2^2: in the unit of a */
static inline uint32_t lattice_first(int32_t a1, int32_t a2, const int32_t gradient[2], int down)
{
    return (uint32_t)shift_round32(multiply_high_s32(a1, gradient[0]) + multiply_high_s32(a2, gradient[1]), down);
}

static inline uint32_t lattice_second(const int32_t a[3], const int32_t gradient[3], int down)
{
    const uint32_t sum = (uint32_t)multiply_high_s32(a[0], gradient[0]) +
                         (uint32_t)multiply_high_s32(a[1], gradient[1]) +
                         (uint32_t)multiply_high_s32(a[2], gradient[2]);
    return (uint32_t)shift_round32((int32_t)sum, down);
}

/* floor(step offset / 2^12) for |offset| <= 2^11 */
static inline uint32_t lattice_part(uint32_t step, int16_t offset)
{
    return (uint32_t)(((int32_t)step >> GLINT_FINE_BITS) * offset +
                      (((int32_t)(step & (GLINT_FINE - 1)) * (int32_t)offset) >> GLINT_FINE_BITS));
}

/* 1/|M| in the middle of an edge with M = u n at its ends, Q15: |2 M|^2 = (u + v)^2 - u v D, with D of bound.h. Below
 * sqrt(2). */
static inline real lattice_inverse_length(uint16_t u_q15, uint16_t v_q15, uint32_t chord_q16)
{
    const uint32_t sum = (uint32_t)u_q15 + v_q15; /* 2^16 at most, whose square wraps to 0 */
    const uint32_t square_q30 = sum * sum - multiply_high_u32((uint32_t)u_q15 * v_q15, chord_q16 << 16);
    return (real)glint_inverse_root_q16(square_q30 == 0 ? UINT32_MAX : square_q30);
}

/* How many bits smaller than 1/2 per pixel the gradients are. */
static inline int lattice_spare_bits(const lattice_gradients *gradients)
{
    return gradients->up;
}

static inline real lattice_weigh(real value, uint16_t weight_q15)
{
    return weight_q15 == 32768 ? value : value + 2 * multiply_q16(value, (int32_t)weight_q15 - 32768);
}

/* A cosine, or a sum of cosines by constants, in the middle of an edge. */
static inline real lattice_middle(real a, uint16_t u_q15, real b, uint16_t v_q15, real inverse_length_q15)
{
    const real mean = (lattice_weigh(a, u_q15) + lattice_weigh(b, v_q15)) >> 1;
    return mean + 2 * multiply_q16(mean, inverse_length_q15 - 32768);
}

static inline uint32_t lattice_mean(uint32_t sum)
{
    return (uint32_t)((int32_t)sum >> 1);
}

/* `middle`: of the edges from corner 0 to 1, 1 to 2, 2 to 0. */
static inline void lattice_quadratic(field_quadratic *field, const lattice_gradients *gradients, const real corner[3],
                                     const real middle[3])
{
    for (int k = 0; k < 3; k++) {
        GLINT_TRACE("value at a lattice point", corner[k]);
        GLINT_TRACE("value at a lattice point", middle[k]);
    }
    const uint32_t v = (uint32_t)corner[0], v1 = (uint32_t)corner[1] - v, v2 = (uint32_t)corner[2] - v;
    const uint32_t m1 = (uint32_t)middle[0] - v, m12 = (uint32_t)middle[1] - v, m2 = (uint32_t)middle[2] - v;
    const int32_t a[3] = {(int32_t)(2 * v1 - 4 * m1), (int32_t)(4 * (m12 - m1 - m2)), (int32_t)(2 * v2 - 4 * m2)};
    const int32_t a1 = (int32_t)(4 * m1 - v1), a2 = (int32_t)(4 * m2 - v2);
    const int up = gradients->up;
    const int16_t offset_x = gradients->offset_x, offset_y = gradients->offset_y;
    const uint32_t x = lattice_first(a1, a2, gradients->x, up - 2), y = lattice_first(a1, a2, gradients->y, up - 2);
    field->xx = lattice_second(a, gradients->xx, 2 * up - 2);
    field->xy = lattice_second(a, gradients->xy, 2 * up - 2);
    field->yy = lattice_second(a, gradients->yy, 2 * up - 2);
    /* from corner 0 to the anchor's centre */
    const uint32_t half_x = lattice_part(field->xx, offset_x), half_y = lattice_part(field->yy, offset_y);
    const uint32_t cross_x = lattice_part(field->xy, offset_x);
    field->value = v + lattice_part(x + half_x, offset_x) + lattice_part(y + half_y + cross_x, offset_y);
    field->x = x + 2 * half_x + lattice_part(field->xy, offset_y);
    field->y = y + 2 * half_y + cross_x;
}

/* A polynomial of degree 3 as the sum of c[i][j] C(dx, i) C(dy, j), C the binomial coefficient, dx and dy from the
 * pixel that holds the centroid; of those of C(n, 3) = n (n - 1) (n - 2) / 6 the third part, modulo 2^32. */
typedef struct field_cubic {
    uint32_t value, x, y, xx, xy, yy, third_xxx, xxy, xyy, third_yyy;
} field_cubic;

/* That pixel, and the way from the centroid to its centre, 1/4096 px. */
typedef struct lattice_centre {
    int16_t x, y, offset_x, offset_y;
} lattice_centre;

static inline lattice_centre lattice_centre_of(const glint_screen_vertex *const corner[3])
{
    /* the guard band keeps the sums below 2^25 */
    const int32_t x = third_part(corner[0]->x + corner[1]->x + corner[2]->x),
                  y = third_part(corner[0]->y + corner[1]->y + corner[2]->y);
    const lattice_centre centre = {(int16_t)(x >> GLINT_FINE_BITS), (int16_t)(y >> GLINT_FINE_BITS),
                                   (int16_t)(GLINT_FINE / 2 - (x & (GLINT_FINE - 1))),
                                   (int16_t)(GLINT_FINE / 2 - (y & (GLINT_FINE - 1)))};
    return centre;
}

/* One row of it from a pixel on: the value and its forward differences, of the last the third part. */
typedef struct cubic_row {
    uint32_t value, step, bend, third;
} cubic_row;

/* The ten points of a cubic: corners 0, 1, 2, then on the edges from 0 to 1, 1 to 2, 2 to 0 at 1/3 and 2/3, then the
 * centroid. */
#define LATTICE_POINTS 10

/* Three times that is 1 modulo 2^32. */
#define THIRD_PART 0xaaaaaaabu

/* How many bits more than the values a cubic has. */
#define CUBIC_FINER 4

/* Of values below 2^26. */
static inline void lattice_cubic(field_cubic *field, const lattice_gradients *gradients, const lattice_centre *centre,
                                 const int32_t value[LATTICE_POINTS])
{
    const uint32_t v = (uint32_t)value[0], v1 = (uint32_t)value[1] - v, v2 = (uint32_t)value[2] - v;
    const uint32_t p1 = (uint32_t)value[3] - v, q1 = (uint32_t)value[4] - v;
    const uint32_t q2 = (uint32_t)value[7] - v, p2 = (uint32_t)value[8] - v;
    /* Along the edges from corner 0 the polynomial is a cubic of v, p, q and v1 or v2; what is left is b1 b2 (s + t1 b1
     * + t2 b2), which is c at the centroid and c1 and c2 on the edge opposite. Taken about the centroid, all twice: */
    const uint32_t c = (uint32_t)value[9] - v - p1 - p2;
    const uint32_t c1 = (uint32_t)value[5] - v - q1 - p2, c2 = (uint32_t)value[6] - v - p1 - q2;
    const int32_t a1 = (int32_t)(3 * (c1 - p1) + 6 * q1 - v1), a2 = (int32_t)(3 * (c2 - p2) + 6 * q2 - v2);
    const int32_t second[3] = {(int32_t)(9 * (q1 + c1 - 2 * (p1 + c))), (int32_t)(9 * (c1 + c2 - 2 * c)),
                               (int32_t)(9 * (q2 + c2 - 2 * (p2 + c)))};
    const int32_t third[4] = {(int32_t)(81 * (p1 - q1) + 27 * v1), (int32_t)(27 * (c1 - 2 * c)),
                              (int32_t)(27 * (c2 - 2 * c)), (int32_t)(81 * (p2 - q2) + 27 * v2)};
    const int up = gradients->up;
    const int16_t offset_x = centre->offset_x, offset_y = centre->offset_y;
    const uint32_t x_0 = lattice_first(a1, a2, gradients->x, up - 1 - CUBIC_FINER);
    const uint32_t y_0 = lattice_first(a1, a2, gradients->y, up - 1 - CUBIC_FINER);
    /* derivatives: a second-order term a b1^2 has 2 a b1'^2 */
    const uint32_t xx_0 = lattice_second(second, gradients->xx, 2 * up - 2 - CUBIC_FINER);
    const uint32_t xy_0 = lattice_second(second, gradients->xy, 2 * up - 1 - CUBIC_FINER);
    const uint32_t yy_0 = lattice_second(second, gradients->yy, 2 * up - 2 - CUBIC_FINER);
    /* of the third-order terms along x, p[0] b1^2 + p[1] b1 b2 + p[2] b2^2, and along y; the outer terms are thrice
     * what they are, for their derivatives */
    int32_t p[3], q[3];
    for (int k = 0; k < 3; k++) {
        const uint32_t times = k == 1 ? 2 : 1;
        p[k] = (int32_t)(times * (uint32_t)(multiply_high_s32(third[k], gradients->x[0]) +
                                            multiply_high_s32(third[k + 1], gradients->x[1])));
        q[k] = (int32_t)(times * (uint32_t)(multiply_high_s32(third[k], gradients->y[0]) +
                                            multiply_high_s32(third[k + 1], gradients->y[1])));
    }
    const uint32_t xxx = lattice_second(p, gradients->xx, 3 * up - 4 - CUBIC_FINER);
    const uint32_t xxy = lattice_second(p, gradients->xy, 3 * up - 3 - CUBIC_FINER);
    const uint32_t xyy = lattice_second(p, gradients->yy, 3 * up - 4 - CUBIC_FINER);
    const uint32_t yyy = lattice_second(q, gradients->yy, 3 * up - 4 - CUBIC_FINER);
    /* From the centroid to the pixel's centre: a derivative's change is its own derivative's mean times the way, less a
     * twelfth of what that derivative's own derivative changes by on the way. */
    const uint32_t xx = xx_0 + lattice_part(xxx, offset_x) + lattice_part(xxy, offset_y);
    const uint32_t xy = xy_0 + lattice_part(xxy, offset_x) + lattice_part(xyy, offset_y);
    const uint32_t yy = yy_0 + lattice_part(xyy, offset_x) + lattice_part(yyy, offset_y);
    const uint32_t x = x_0 + lattice_mean(lattice_part(xx_0 + xx, offset_x) + lattice_part(xy_0 + xy, offset_y));
    const uint32_t y = y_0 + lattice_mean(lattice_part(xy_0 + xy, offset_x) + lattice_part(yy_0 + yy, offset_y));
    const uint32_t along_x = lattice_part(xx - xx_0, offset_x) + 2 * lattice_part(xy - xy_0, offset_y);
    const uint32_t turned = lattice_part(along_x, offset_x) + lattice_part(lattice_part(yy - yy_0, offset_y), offset_y);
    const int32_t third_q16 = 21845, sixth_q16 = 10923; /* a twelfth is a quarter of a third: 2 bits more exact */
    field->value = ((uint32_t)value[9] << CUBIC_FINER) +
                   lattice_mean(lattice_part(x_0 + x, offset_x) + lattice_part(y_0 + y, offset_y)) -
                   (uint32_t)(multiply_q16((int32_t)turned, third_q16) >> 2);
    /* from derivatives to differences: n^2 / 2 = C(n, 2) + n / 2, n^3 / 6 = C(n, 3) + C(n, 2) + n / 6 */
    field->x = x + lattice_mean(xx) + (uint32_t)multiply_q16((int32_t)xxx, sixth_q16);
    field->y = y + lattice_mean(yy) + (uint32_t)multiply_q16((int32_t)yyy, sixth_q16);
    field->xx = xx + xxx;
    field->xy = xy + lattice_mean(xxy + xyy);
    field->yy = yy + yyy;
    field->third_xxx = xxx * THIRD_PART;
    field->xxy = xxy;
    field->xyy = xyy;
    field->third_yyy = yyy * THIRD_PART;
}

/* C(n, 2) and, of that, 3 C(n, 3). */
static inline uint32_t choose_two(uint32_t n)
{
    return (uint32_t)((int32_t)(n * (n - 1)) >> 1);
}

static inline uint32_t thrice_choose_three(uint32_t two, uint32_t n)
{
    return two * (n - 2);
}

/* A cubic's column at its centre, from row to row; and the row from a pixel on. */
typedef struct cubic_column {
    uint32_t value, down, fall, drop, along, along_down, along_fall, bend, bend_down, third;
} cubic_column;

static inline cubic_column cubic_column_at(const field_cubic *field, const lattice_centre *centre, int16_t y)
{
    const uint32_t m = (uint32_t)((int32_t)y - centre->y), m2 = choose_two(m), yyy = 3 * field->third_yyy;
    const cubic_column column = {
        field->value + m * field->y + m2 * field->yy + thrice_choose_three(m2, m) * field->third_yyy,
        field->y + m * field->yy + m2 * yyy,
        field->yy + m * yyy,
        yyy,
        field->x + m * field->xy + m2 * field->xyy,
        field->xy + m * field->xyy,
        field->xyy,
        field->xx + m * field->xxy,
        field->xxy,
        field->third_xxx,
    };
    return column;
}

static inline void cubic_column_next(cubic_column *column)
{
    column->value += column->down;
    column->down += column->fall;
    column->fall += column->drop;
    column->along += column->along_down;
    column->along_down += column->along_fall;
    column->bend += column->bend_down;
}

static inline cubic_row cubic_column_row(const cubic_column *column, int32_t dx)
{
    const uint32_t n = (uint32_t)dx, n2 = choose_two(n), third = column->third, twist = 3 * third;
    const cubic_row row = {column->value + n * column->along + n2 * column->bend + thrice_choose_three(n2, n) * third,
                           column->along + n * column->bend + n2 * twist, column->bend + n * twist, third};
    return row;
}

static inline cubic_row field_cubic_at(const field_cubic *field, const lattice_centre *centre, int16_t x, int16_t y)
{
    const cubic_column column = cubic_column_at(field, centre, y);
    return cubic_column_row(&column, (int32_t)x - centre->x);
}

static inline void cubic_row_next(cubic_row *row)
{
    row->value += row->step;
    row->step += row->bend;
    row->bend += 3 * row->third;
}

/* Is the row certainly above a limit at `count` pixels? Its second difference is linear: between its ends the row
 * stays above the lesser end less count^2 / 8 of the greatest one. */
static inline bool cubic_row_above(const cubic_row *row, uint16_t count, int32_t limit)
{
    const uint32_t n = (uint32_t)count - 1, n2 = choose_two(n), twist = 3 * row->third;
    const int32_t first = (int32_t)row->value;
    const int32_t last =
        (int32_t)(row->value + n * row->step + n2 * row->bend + thrice_choose_three(n2, n) * row->third);
    const uint32_t bend_first = magnitude32((int32_t)row->bend),
                   bend_last = magnitude32((int32_t)(row->bend + n * twist));
    const uint32_t bend = bend_first > bend_last ? bend_first : bend_last;
    const int32_t least = (first < last ? first : last) - limit;
    /* n < 2^4 and below 2^23, or n < 2^6 and below 2^19 */
    return least > 0 && n < 64 && bend >> (n < 16 ? 23 : 19) == 0 && bend * n * n / 8 < (uint32_t)least;
}

static inline void cubic_row_skip(cubic_row *row, uint16_t count)
{
    const uint32_t n = count, n2 = choose_two(n), twist = 3 * row->third;
    row->value += n * row->step + n2 * row->bend + thrice_choose_three(n2, n) * row->third;
    row->step += n * row->bend + n2 * twist;
    row->bend += n * twist;
}

#endif
