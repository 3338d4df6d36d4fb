/* SPDX-License-Identifier: MIT */
/*
 * Polynomials on the screen through values at points of a triangle, in float. See lattice_fixed.h for what each is.
 */
#ifndef GLINT_RASTER_LATTICE_FLOAT_H
#define GLINT_RASTER_LATTICE_FLOAT_H

#include "raster/field_float.h"

/* Gradients of b1 and b2, and of b1^2, b1 b2, b2^2, halved where they are of one direction. */
typedef struct lattice_gradients {
    float x[2], y[2];
    float xx[3], xy[3], yy[3];
    float offset_x, offset_y; /* from corner 0 to the anchor's centre, px */
} lattice_gradients;

static inline void lattice_prepare(lattice_gradients *to, const glint_gradients *from)
{
    for (int i = 0; i < 2; i++) {
        to->x[i] = float_from_scaled(from->x[i], 30);
        to->y[i] = float_from_scaled(from->y[i], 30);
    }
    to->xx[0] = to->x[0] * to->x[0];
    to->xx[1] = to->x[0] * to->x[1];
    to->xx[2] = to->x[1] * to->x[1];
    to->xy[0] = 2.0f * to->x[0] * to->y[0];
    to->xy[1] = to->x[0] * to->y[1] + to->x[1] * to->y[0];
    to->xy[2] = 2.0f * to->x[1] * to->y[1];
    to->yy[0] = to->y[0] * to->y[0];
    to->yy[1] = to->y[0] * to->y[1];
    to->yy[2] = to->y[1] * to->y[1];
    to->offset_x = (float)from->offset_x * (1.0f / GLINT_FINE);
    to->offset_y = (float)from->offset_y * (1.0f / GLINT_FINE);
}

static inline float lattice_second(const float a[3], const float gradient[3])
{
    return a[0] * gradient[0] + a[1] * gradient[1] + a[2] * gradient[2];
}

static inline real lattice_inverse_length(uint16_t u_q15, uint16_t v_q15, uint32_t chord_q16)
{
    const float u = (float)u_q15 * (1.0f / 32768), v = (float)v_q15 * (1.0f / 32768);
    return 2.0f * glint_inverse_root((u + v) * (u + v) - u * v * ((float)chord_q16 * (1.0f / 65536)));
}

/* How many bits smaller than 1/2 per pixel the gradients are. */
static inline int lattice_spare_bits(const lattice_gradients *gradients)
{
    (void)gradients;
    return 28;
}

static inline real lattice_weigh(real value, uint16_t weight_q15)
{
    return value * ((float)weight_q15 * (1.0f / 32768));
}

static inline real lattice_middle(real a, uint16_t u_q15, real b, uint16_t v_q15, real inverse_length)
{
    return 0.5f * (lattice_weigh(a, u_q15) + lattice_weigh(b, v_q15)) * inverse_length;
}

static inline void lattice_quadratic(field_quadratic *field, const lattice_gradients *gradients, const real corner[3],
                                     const real middle[3])
{
    const float v = corner[0], v1 = corner[1] - v, v2 = corner[2] - v;
    const float m1 = middle[0] - v, m12 = middle[1] - v, m2 = middle[2] - v;
    const float a[3] = {2.0f * v1 - 4.0f * m1, 4.0f * (m12 - m1 - m2), 2.0f * v2 - 4.0f * m2};
    const float a1 = 4.0f * m1 - v1, a2 = 4.0f * m2 - v2;
    const float offset_x = gradients->offset_x, offset_y = gradients->offset_y;
    const float x = a1 * gradients->x[0] + a2 * gradients->x[1], y = a1 * gradients->y[0] + a2 * gradients->y[1];
    field->xx = lattice_second(a, gradients->xx);
    field->xy = lattice_second(a, gradients->xy);
    field->yy = lattice_second(a, gradients->yy);
    field->value =
        v + offset_x * (x + offset_x * field->xx) + offset_y * (y + offset_y * field->yy + offset_x * field->xy);
    field->x = x + 2.0f * offset_x * field->xx + offset_y * field->xy;
    field->y = y + 2.0f * offset_y * field->yy + offset_x * field->xy;
}

typedef struct field_cubic {
    float value, x, y, xx, xy, yy, third_xxx, xxy, xyy, third_yyy;
} field_cubic;

typedef struct lattice_centre {
    int16_t x, y;
    float offset_x, offset_y;
} lattice_centre;

static inline lattice_centre lattice_centre_of(const glint_screen_vertex *const corner[3])
{
    const int32_t x = (corner[0]->x + corner[1]->x + corner[2]->x) / 3,
                  y = (corner[0]->y + corner[1]->y + corner[2]->y) / 3;
    const lattice_centre centre = {(int16_t)(x >> GLINT_FINE_BITS), (int16_t)(y >> GLINT_FINE_BITS),
                                   (float)((GLINT_FINE >> 1) - (x & (GLINT_FINE - 1))) * (1.0f / GLINT_FINE),
                                   (float)((GLINT_FINE >> 1) - (y & (GLINT_FINE - 1))) * (1.0f / GLINT_FINE)};
    return centre;
}

typedef struct cubic_row {
    float value, step, bend, third;
} cubic_row;

#define LATTICE_POINTS 10

static inline void lattice_cubic(field_cubic *field, const lattice_gradients *gradients, const lattice_centre *centre,
                                 const float value[LATTICE_POINTS])
{
    const float v = value[0], v1 = value[1] - v, v2 = value[2] - v;
    const float p1 = value[3] - v, q1 = value[4] - v, q2 = value[7] - v, p2 = value[8] - v;
    const float c = value[9] - v - p1 - p2, c1 = value[5] - v - q1 - p2, c2 = value[6] - v - p1 - q2;
    const float a1 = 1.5f * (c1 - p1) + 3.0f * q1 - 0.5f * v1, a2 = 1.5f * (c2 - p2) + 3.0f * q2 - 0.5f * v2;
    const float second[3] = {4.5f * (q1 + c1) - 9.0f * (p1 + c), 4.5f * (c1 + c2) - 9.0f * c,
                             4.5f * (q2 + c2) - 9.0f * (p2 + c)};
    /* of the third-order terms, the outer ones thrice */
    const float third[4] = {40.5f * (p1 - q1) + 13.5f * v1, 13.5f * c1 - 27.0f * c, 13.5f * c2 - 27.0f * c,
                            40.5f * (p2 - q2) + 13.5f * v2};
    const float offset_x = centre->offset_x, offset_y = centre->offset_y;
    float p[3], q[3];
    for (int k = 0; k < 3; k++) {
        const float times = k == 1 ? 2.0f : 1.0f;
        p[k] = times * (third[k] * gradients->x[0] + third[k + 1] * gradients->x[1]);
        q[k] = times * (third[k] * gradients->y[0] + third[k + 1] * gradients->y[1]);
    }
    const float xxx = 2.0f * lattice_second(p, gradients->xx), xxy = lattice_second(p, gradients->xy);
    const float xyy = 2.0f * lattice_second(p, gradients->yy), yyy = 2.0f * lattice_second(q, gradients->yy);
    const float x_0 = a1 * gradients->x[0] + a2 * gradients->x[1], y_0 = a1 * gradients->y[0] + a2 * gradients->y[1];
    const float xx_0 = 2.0f * lattice_second(second, gradients->xx), xy_0 = lattice_second(second, gradients->xy);
    const float yy_0 = 2.0f * lattice_second(second, gradients->yy);
    /* what the second derivatives change by from the centroid to the pixel's centre */
    const float xx_more = offset_x * xxx + offset_y * xxy, xy_more = offset_x * xxy + offset_y * xyy;
    const float yy_more = offset_x * xyy + offset_y * yyy;
    const float xx = xx_0 + xx_more, xy = xy_0 + xy_more, yy = yy_0 + yy_more;
    const float x = x_0 + 0.5f * (offset_x * (xx_0 + xx) + offset_y * (xy_0 + xy));
    const float y = y_0 + 0.5f * (offset_x * (xy_0 + xy) + offset_y * (yy_0 + yy));
    const float turned = offset_x * (offset_x * xx_more + 2.0f * offset_y * xy_more) + offset_y * offset_y * yy_more;
    field->value = value[9] + 0.5f * (offset_x * (x_0 + x) + offset_y * (y_0 + y)) - turned * (1.0f / 12);
    field->x = x + 0.5f * xx + xxx * (1.0f / 6);
    field->y = y + 0.5f * yy + yyy * (1.0f / 6);
    field->xx = xx + xxx;
    field->xy = xy + 0.5f * (xxy + xyy);
    field->yy = yy + yyy;
    field->third_xxx = xxx * (1.0f / 3);
    field->xxy = xxy;
    field->xyy = xyy;
    field->third_yyy = yyy * (1.0f / 3);
}

static inline cubic_row field_cubic_at(const field_cubic *field, const lattice_centre *centre, int16_t x, int16_t y)
{
    const float n = (float)(x - centre->x), m = (float)(y - centre->y);
    const float n2 = 0.5f * n * (n - 1.0f), m2 = 0.5f * m * (m - 1.0f);
    const float n3 = n2 * (n - 2.0f), m3 = m2 * (m - 2.0f), twist = 3.0f * field->third_xxx; /* n3: thrice C(n, 3) */
    const float step = field->x + m * field->xy + m2 * field->xyy, bend = field->xx + m * field->xxy;
    const cubic_row row = {field->value + m * field->y + m2 * field->yy + m3 * field->third_yyy + n * step + n2 * bend +
                               n3 * field->third_xxx,
                           step + n * bend + n2 * twist, bend + n * twist, field->third_xxx};
    return row;
}

/* Rows are taken afresh: sums of steps would depend on where they began. */
typedef struct cubic_column {
    const field_cubic *field;
    const lattice_centre *centre;
    int16_t y;
} cubic_column;

static inline cubic_column cubic_column_at(const field_cubic *field, const lattice_centre *centre, int16_t y)
{
    const cubic_column column = {field, centre, y};
    return column;
}

static inline void cubic_column_next(cubic_column *column)
{
    column->y = (int16_t)(column->y + 1);
}

static inline cubic_row cubic_column_row(const cubic_column *column, int32_t dx)
{
    return field_cubic_at(column->field, column->centre, (int16_t)(column->centre->x + dx), column->y);
}

static inline void cubic_row_next(cubic_row *row)
{
    row->value += row->step;
    row->step += row->bend;
    row->bend += 3.0f * row->third;
}

static inline bool cubic_row_above(const cubic_row *row, uint16_t count, float limit)
{
    const float n = (float)count - 1.0f, n2 = 0.5f * n * (n - 1.0f), n3 = n2 * (n - 2.0f);
    const float last = row->value + n * row->step + n2 * row->bend + n3 * row->third;
    const float bend_first = row->bend < 0.0f ? -row->bend : row->bend, at_last = row->bend + n * 3.0f * row->third;
    const float bend_last = at_last < 0.0f ? -at_last : at_last;
    const float bend = bend_first > bend_last ? bend_first : bend_last;
    const float least = (row->value < last ? row->value : last) - limit;
    return 0.125f * bend * n * n < least;
}

static inline void cubic_row_skip(cubic_row *row, uint16_t count)
{
    const float n = (float)count, n2 = 0.5f * n * (n - 1.0f), n3 = n2 * (n - 2.0f);
    row->value += n * row->step + n2 * row->bend + n3 * row->third;
    row->step += n * row->bend + n2 * 3.0f * row->third;
    row->bend += n * 3.0f * row->third;
}

#endif
