/* SPDX-License-Identifier: MIT */
/*
 * Textures by <glint/texture.h>, in double precision: the colour at a point of a texture, and the range of colours over
 * a box of them.
 */
#include <stdlib.h>

#include "internal.h"

/* Cells that a box is looked at in along an axis; in a box that has more, nothing is known. */
#define CELLS_MAX 64

int picture_load(picture *out, const glint_texture *in)
{
    size_t count = (size_t)in->width_px * in->height_px;
    out->size[0] = in->width_px;
    out->size[1] = in->height_px;
    out->bilinear = in->filter == GLINT_BILINEAR;
    out->clamped[0] = in->wrap_u == GLINT_CLAMP;
    out->clamped[1] = in->wrap_v == GLINT_CLAMP;
    out->rgb = calloc(count + 1, 3 * sizeof *out->rgb);
    if (!out->rgb) {
        return -1;
    }
    for (size_t i = 0; i < count; i++) {
        unsigned k;
        if (in->format == GLINT_TEXTURE_PALETTE8) {
            unsigned number = ((const uint8_t *)in->texels)[i];
            k = in->palette[number < in->palette_count ? number : in->palette_count - 1u];
        } else {
            k = ((const uint16_t *)in->texels)[i];
        }
        out->rgb[i * 3] = (k >> 11) / 31.0;
        out->rgb[i * 3 + 1] = (k >> 5 & 63u) / 63.0;
        out->rgb[i * 3 + 2] = (k & 31u) / 31.0;
    }
    return 0;
}

/* The texel of column i and row j of the plane that the picture is laid out on. */
static const double *texel(const picture *p, double i, double j)
{
    const double at[2] = {i, j};
    long index[2];
    for (int k = 0; k < 2; k++) {
        double size = p->size[k];
        index[k] = (long)(p->clamped[k] ? fmin(fmax(at[k], 0.0), size - 1.0) : at[k] - size * floor(at[k] / size));
    }
    return &p->rgb[3 * (index[1] * p->size[0] + index[0])];
}

void picture_at(const picture *p, const double uv[2], double rgb[3])
{
    double x = uv[0] * p->size[0], y = uv[1] * p->size[1];
    if (!p->bilinear) {
        const double *t = texel(p, floor(x), floor(y));
        rgb[0] = t[0];
        rgb[1] = t[1];
        rgb[2] = t[2];
        return;
    }
    x -= 0.5;
    y -= 0.5;
    double i = floor(x), j = floor(y), s = x - i, t = y - j;
    for (int k = 0; k < 3; k++) {
        rgb[k] = (1.0 - t) * ((1.0 - s) * texel(p, i, j)[k] + s * texel(p, i + 1.0, j)[k]) +
                 t * ((1.0 - s) * texel(p, i, j + 1.0)[k] + s * texel(p, i + 1.0, j + 1.0)[k]);
    }
}

/* Where along an axis extremes can be: the box's ends, and for each line between them at which a cell of the filter
 * begins, the line or, where the colour jumps there, the middle of the cell. Returns their number, 0 for too many. */
static int places(const picture *p, int axis, double low, double high, double out[CELLS_MAX + 2])
{
    double size = p->size[axis], shift = p->bilinear ? 0.5 : 0.0;
    double first = floor(low * size - shift) + 1.0, last = floor(high * size - shift);
    int count = 0;
    if (last - first >= CELLS_MAX) {
        return 0;
    }
    out[count++] = low;
    out[count++] = high;
    for (int i = 0; i <= (int)(last - first); i++) {
        double line = first + i;
        out[count++] = p->bilinear ? (line + shift) / size : fmin(high, (line + 0.5) / size);
    }
    return count;
}

void picture_range(const picture *p, const double low[2], const double high[2], double least[3], double most[3])
{
    double x[CELLS_MAX + 2], y[CELLS_MAX + 2];
    int columns = places(p, 0, low[0], high[0], x), rows = places(p, 1, low[1], high[1], y);
    for (int k = 0; k < 3; k++) {
        least[k] = columns == 0 || rows == 0 ? 0.0 : 1.0;
        most[k] = 1.0 - least[k];
    }
    for (int i = 0; i < columns; i++) {
        for (int j = 0; j < rows; j++) {
            const double uv[2] = {x[i], y[j]};
            double rgb[3];
            picture_at(p, uv, rgb);
            for (int k = 0; k < 3; k++) {
                least[k] = fmin(least[k], rgb[k]);
                most[k] = fmax(most[k], rgb[k]);
            }
        }
    }
}
