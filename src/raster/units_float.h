/* SPDX-License-Identifier: MIT */
/*
 * Unit vectors along a row of pixels, in float. See units_fixed.h for what each is.
 */
#ifndef GLINT_RASTER_UNITS_FLOAT_H
#define GLINT_RASTER_UNITS_FLOAT_H

#include "raster/field_float.h"

typedef struct unit_row {
    float value[3], step[3];
} unit_row;

typedef int unit_scale; /* numbers in float have their own */

#define UNIT_SCALE_OF_NORMALS 0

static inline unit_row unit_row_of_planes(const attribute_plane plane[3], const glint_gradients *gradients, int16_t x,
                                          int16_t y)
{
    unit_row row;
    for (int k = 0; k < 3; k++) {
        row.value[k] = attribute_at(&plane[k], gradients, x, y);
        row.step[k] = plane[k].step_x;
    }
    return row;
}

static inline unit_row unit_row_of_rays(const pixel_rays *rays, int16_t x, int16_t y)
{
    unit_row row;
    surface at;
    surface_set_ray(&at, rays, x, y);
    for (int k = 0; k < 3; k++) {
        row.value[k] = at.ray[k];
        row.step[k] = rays->v[1][k];
    }
    return row;
}

static inline unit_scale unit_scale_of_rays(const pixel_rays *rays)
{
    (void)rays;
    return 0;
}

static inline unit_scale unit_scale_of_corners(real component[3][3])
{
    (void)component;
    return 0;
}

static inline void unit_row_next(unit_row *row)
{
    row->value[0] += row->step[0];
    row->value[1] += row->step[1];
    row->value[2] += row->step[2];
}

static GLINT_SPECIALISED void units_along(unit_row row, unit_scale down, bool shortened, uint16_t count, real (*out)[3])
{
    (void)down;
    (void)shortened;
    for (uint16_t i = 0; i < count; i++) {
        if (!unit(row.value, out[i])) {
            out[i][0] = out[i][1] = out[i][2] = 0.0f;
        }
        unit_row_next(&row);
    }
}

static inline uint32_t mirrored_gap_q28(const real n[3], const real s[3], real cosine, const real ray[3])
{
    const float twice = 2.0f * cosine;
    const float x = twice * n[0] - s[0] + ray[0], y = twice * n[1] - s[1] + ray[1], z = twice * n[2] - s[2] + ray[2];
    return wide_gap_q28(0.5f * (x * x + y * y + z * z));
}

static inline void direction_fine(const light_place *place, real out[3])
{
    out[0] = place->v[0];
    out[1] = place->v[1];
    out[2] = place->v[2];
}

static inline void unit_fine_at(const unit_row *row, real out[3])
{
    if (!unit(row->value, out)) {
        out[0] = out[1] = out[2] = 0.0f;
    }
}

static inline real fine_cosine(const real n[3], const real s[3])
{
    return cosine_of(n, s);
}

static inline uint32_t fine_gap_q28(const real n[3], const real s[3], const real ray[3])
{
    return mirrored_gap_q28(n, s, cosine_of(n, s), ray);
}

static inline real normal_weigh_fine(real component, int32_t depth_q30, inverse_scale scale)
{
    return normal_weigh(component, depth_q30, scale);
}

static inline bool unit_fine(const real v[3], real out[3])
{
    return unit(v, out);
}

#endif
