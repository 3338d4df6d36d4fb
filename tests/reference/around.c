/* SPDX-License-Identifier: MIT */
/*
 * What a mirror shows: the octahedral map of <glint/scene.h>, by its formulas in double precision.
 */
#include <stdlib.h>

#include "internal.h"

int around_load(surroundings *out, const glint_environment *in)
{
    if (!in || !in->texels || in->side == 0) {
        return 0;
    }
    out->side = in->side;
    out->texel = malloc((size_t)in->side * in->side * sizeof *out->texel);
    if (!out->texel) {
        return -1;
    }
    for (int i = 0; i < in->side * in->side; i++) {
        out->texel[i][0] = (in->texels[i] >> 11) / 31.0;
        out->texel[i][1] = (in->texels[i] >> 5 & 63) / 63.0;
        out->texel[i][2] = (in->texels[i] & 31) / 31.0;
    }
    return 0;
}

static const double *texel(const surroundings *around, int column, int row)
{
    int side = around->side;
    if (column < 0 || column >= side) { /* over the left or right edge: back in where v is the other way round */
        column = column < 0 ? -1 - column : 2 * side - 1 - column;
        row = side - 1 - row;
    }
    if (row < 0 || row >= side) {
        row = row < 0 ? -1 - row : 2 * side - 1 - row;
        column = side - 1 - column;
    }
    return around->texel[row * side + column];
}

void around_colour(const surroundings *around, vector d, double rgb[3])
{
    double sum = fabs(d.x) + fabs(d.y) + fabs(d.z), u = d.x / sum, v = d.z / sum;
    if (d.y < 0.0) {
        double x = u, z = v;
        u = copysign(1.0 - fabs(z), x);
        v = copysign(1.0 - fabs(x), z);
    }
    double x = (u + 1.0) / 2.0 * around->side - 0.5, y = (v + 1.0) / 2.0 * around->side - 0.5;
    int i = (int)floor(x), j = (int)floor(y);
    for (int k = 0; k < 3; k++) {
        double upper = (i + 1 - x) * texel(around, i, j)[k] + (x - i) * texel(around, i + 1, j)[k];
        double lower = (i + 1 - x) * texel(around, i, j + 1)[k] + (x - i) * texel(around, i + 1, j + 1)[k];
        rgb[k] = (j + 1 - y) * upper + (y - j) * lower;
    }
}
