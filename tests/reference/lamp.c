/* SPDX-License-Identifier: MIT */
/*
 * Light sources: where their light comes from at a point, and how much of it, by <glint/scene.h>.
 */
#include "internal.h"

#define PI 3.14159265358979323846

void lamp_load(lamp *out, const glint_light *in)
{
    const glint_attenuation *a = &in->attenuation;
    out->casts = in->casts_shadows;
    out->is_spot = in->kind == GLINT_SPOT;
    out->has_place = in->kind != GLINT_DIRECTIONAL;
    out->is_ball = in->kind == GLINT_BALL;
    out->radius = out->is_ball ? in->radius_q16 / 65536.0 : 0.0;
    for (int i = 0; i < 2 && in->kind == GLINT_PANEL; i++) {
        out->edge[i] =
            vector_of(in->edge_q16[i][0] / 65536.0, in->edge_q16[i][1] / 65536.0, in->edge_q16[i][2] / 65536.0);
    }
    out->is_area = out->radius > 0.0 || length(out->edge[0]) > 0.0 || length(out->edge[1]) > 0.0;
    out->toward = unit(vector_of(-in->direction[0], -in->direction[1], -in->direction[2]));
    out->position =
        vector_of(in->position_q16[0] / 65536.0, in->position_q16[1] / 65536.0, in->position_q16[2] / 65536.0);
    out->colour[0] = in->colour.r_q14 / 16384.0;
    out->colour[1] = in->colour.g_q14 / 16384.0;
    out->colour[2] = in->colour.b_q14 / 16384.0;
    for (int i = 0; i < 3; i++) {
        out->k[i] = a->k_q14[i] / 16384.0;
    }
    out->unit = a->unit_q16 ? a->unit_q16 / 65536.0 : 1.0;
    out->range = a->range_q16 / 65536.0;
    out->cos_inner = cos(in->inner_turn16 / 65536.0 * 2.0 * PI);
    out->cos_outer = cos(in->outer_turn16 / 65536.0 * 2.0 * PI);
}

bool lamp_toward(const lamp *l, vector point, vector *s)
{
    *s = l->has_place ? unit(minus(l->position, point)) : l->toward;
    return length(*s) > 0.0;
}

static double attenuation(const lamp *l, double distance)
{
    double t = distance / l->unit, factor = 1.0;
    if (l->k[0] > 0.0 || l->k[1] > 0.0 || l->k[2] > 0.0) {
        double divisor = l->k[0] + l->k[1] * t + l->k[2] * t * t;
        factor = divisor > 1.0 ? 1.0 / divisor : 1.0;
    }
    if (l->range > 0.0) {
        factor *= fmax(0.0, 1.0 - pow(distance / l->range, 4.0));
    }
    return factor;
}

static double cone(const lamp *l, vector s)
{
    double share = (dot(s, l->toward) - l->cos_outer) / (l->cos_inner - l->cos_outer);
    share = fmin(1.0, fmax(0.0, share));
    return share * share;
}

double lamp_factor(const lamp *l, vector point, vector s)
{
    double factor = l->has_place ? attenuation(l, length(minus(l->position, point))) : 1.0;
    return l->is_spot ? factor * cone(l, s) : factor;
}
