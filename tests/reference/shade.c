/* SPDX-License-Identifier: MIT */
/*
 * The reflectance model of <glint/scene.h> and the three shadings of <glint/quality.h>, written out term by term.
 */
#include <string.h>

#include "internal.h"

static double clamp01(double v)
{
    return v < 0.0 ? 0.0 : v > 1.0 ? 1.0 : v;
}

double shade_highlight(const surface *f, vector n, vector s, vector c)
{
    double cosine;
    if (f->blinn) {
        vector h = plus(s, c);
        if (length(h) < NORMAL_LEAST) {
            return 0.0;
        }
        cosine = dot(n, unit(h));
    } else {
        cosine = dot(minus(times(2.0 * dot(n, s), n), s), c);
    }
    return pow(cosine > 0.0 ? cosine : 0.0, f->exponent); /* C99: pow(0, 0) is 1 */
}

void shade_point(const reference_detail *d, const surface *f, vector point, vector normal, const int *lights, int count,
                 unsigned on, double rgb[3])
{
    vector c = unit(minus(d->eye, point));
    if (length(normal) == 0.0) {
        normal = c;
    }
    for (int k = 0; k < 3; k++) {
        double above = dot(normal, d->up);
        rgb[k] = f->emission[k] + f->ambient[k] + f->sky[k] * (1.0 + above) / 2.0 + f->ground[k] * (1.0 - above) / 2.0;
    }
    if (d->around.side > 0) {
        double mirrored[3];
        around_colour(&d->around, minus(times(2.0 * dot(normal, c), normal), c), mirrored);
        for (int k = 0; k < 3; k++) {
            rgb[k] += f->mirror[k] * mirrored[k];
        }
    }
    for (int j = 0; j < d->lamp_count; j++) {
        const lamp *l = &d->lamps[j];
        vector s;
        if (l->is_area) {
            area_mean mean = area_light(l, f, point, normal, c);
            for (int k = 0; k < 3; k++) {
                rgb[k] += l->colour[k] * (f->diffuse[k] * mean.diffuse + f->specular[k] * mean.specular);
            }
            continue;
        }
        if (!lamp_toward(l, point, &s)) {
            continue;
        }
        double ns = dot(normal, s);
        bool lit = ns > 0.0;
        for (int k = 0; k < count; k++) {
            if (lights[k] == j) {
                lit = (on >> k & 1u) != 0;
            }
        }
        double specular = lit ? shade_highlight(f, normal, s, c) : 0.0, factor = lamp_factor(l, point, s);
        for (int k = 0; k < 3; k++) {
            rgb[k] += factor * l->colour[k] * (f->diffuse[k] * (ns > 0.0 ? ns : 0.0) + f->specular[k] * specular);
        }
    }
    for (int k = 0; k < 3; k++) {
        rgb[k] = clamp01(rgb[k]);
    }
}

int shade_terminators(const reference_detail *d, const surface *f, vector point, vector normal,
                      int lights[TERMINATOR_MAX])
{
    int count = 0;
    if (length(normal) == 0.0) {
        return 0;
    }
    for (int j = 0; j < d->lamp_count && count < TERMINATOR_MAX; j++) {
        vector s;
        /* over an extended source the term ends gradually */
        if (!d->lamps[j].is_area && lamp_toward(&d->lamps[j], point, &s) &&
            fabs(dot(normal, s)) < d->options.terminator) {
            double with[3], without[3], change = 0.0;
            shade_point(d, f, point, normal, &j, 1, 1u, with);
            shade_point(d, f, point, normal, &j, 1, 0u, without);
            for (int k = 0; k < 3; k++) {
                change = fmax(change, with[k] - without[k]);
            }
            if (change > 0.001 / 255.0) {
                lights[count++] = j;
            }
        }
    }
    return count;
}

static vector blend(const double weight[3], const vector v[3])
{
    return plus(plus(times(weight[0], v[0]), times(weight[1], v[1])), times(weight[2], v[2]));
}

static vector centroid(const triangle *t)
{
    return times(1.0 / 3.0, plus(plus(t->world[0], t->world[1]), t->world[2]));
}

/* Point and normal of the exact shading at a place on the screen. */
static void exact_point(const triangle *t, const corner *where, vector *point, vector *normal)
{
    double b[3], sum = 0.0;
    for (int i = 0; i < 3; i++) {
        b[i] = fmax(0.0, where->share[i]);
        sum += b[i];
    }
    for (int i = 0; i < 3; i++) {
        b[i] /= sum;
    }
    *point = blend(b, t->world);
    *normal = blend(b, t->normal);
    *normal = length(*normal) < NORMAL_LEAST ? t->face : unit(*normal);
}

static int gouraud_terminators(const reference_detail *d, const triangle *t, int i, int lights[TERMINATOR_MAX])
{
    return shade_terminators(d, &d->surfaces[t->object], t->world[i], t->normal[i], lights);
}

void shade_triangle(const reference_detail *d, triangle *t)
{
    const surface *f = &d->surfaces[t->object];
    int lights[TERMINATOR_MAX];
    t->has_terminator = false;
    if (d->shading == GLINT_SHADING_GOURAUD) {
        for (int i = 0; i < 3; i++) {
            shade_point(d, f, t->world[i], t->normal[i], NULL, 0, 0u, t->corner_colour[i]);
            t->has_terminator = t->has_terminator || gouraud_terminators(d, t, i, lights) > 0;
        }
    } else if (d->shading == GLINT_SHADING_FLAT) {
        shade_point(d, f, centroid(t), t->face, NULL, 0, 0u, t->flat_colour);
        t->has_terminator = shade_terminators(d, f, centroid(t), t->face, lights) > 0;
    }
}

/* Variants are numbered in bits: exact and flat: bit k for light k of those at their terminator; Gouraud: bit i for all
 * such lights of corner i together. */
int shade_variants(const reference_detail *d, const triangle *t, const corner *anchor)
{
    int lights[TERMINATOR_MAX], count;
    vector point = centroid(t), normal = t->face;
    if (d->shading == GLINT_SHADING_GOURAUD) {
        return t->has_terminator ? 8 : 1;
    }
    if (d->shading == GLINT_SHADING_EXACT) {
        exact_point(t, anchor, &point, &normal);
    }
    count = shade_terminators(d, &d->surfaces[t->object], point, normal, lights);
    return 1 << count;
}

static void gouraud(const reference_detail *d, const triangle *t, const corner *where, int variant, double rgb[3])
{
    double weight[3], sum = 0.0;
    for (int i = 0; i < 3; i++) {
        weight[i] = fmax(0.0, where->linear[i]);
        sum += weight[i];
    }
    rgb[0] = rgb[1] = rgb[2] = 0.0;
    for (int i = 0; i < 3; i++) {
        double at_corner[3];
        memcpy(at_corner, t->corner_colour[i], sizeof at_corner);
        if (variant >= 0 && t->has_terminator) {
            int lights[TERMINATOR_MAX], count = gouraud_terminators(d, t, i, lights);
            shade_point(d, &d->surfaces[t->object], t->world[i], t->normal[i], lights, count,
                        variant >> i & 1 ? ~0u : 0u, at_corner);
        }
        for (int k = 0; k < 3; k++) {
            rgb[k] += weight[i] / sum * at_corner[k];
        }
    }
}

/* The colour before fog. */
static void unfogged(const reference_detail *d, const triangle *t, const corner *where, const corner *anchor,
                     int variant, double rgb[3])
{
    const surface *f = &d->surfaces[t->object];
    int lights[TERMINATOR_MAX], count = 0;
    unsigned on = (unsigned)variant;
    vector point, normal;
    if (d->shading == GLINT_SHADING_GOURAUD) {
        gouraud(d, t, where, variant, rgb);
        return;
    }
    if (d->shading == GLINT_SHADING_FLAT) {
        if (variant < 0 || !t->has_terminator) {
            memcpy(rgb, t->flat_colour, sizeof t->flat_colour);
            return;
        }
        point = centroid(t);
        normal = t->face;
        count = shade_terminators(d, f, point, normal, lights);
    } else {
        if (variant >= 0) {
            exact_point(t, anchor, &point, &normal);
            count = shade_terminators(d, f, point, normal, lights);
        }
        exact_point(t, where, &point, &normal);
    }
    shade_point(d, f, point, normal, lights, count, on, rgb);
}

/* What is mirrored at the pixel instead of let through: (1 - |n.c|)^5. */
static double mirrored(const reference_detail *d, const triangle *t, const corner *where)
{
    vector point, normal;
    exact_point(t, where, &point, &normal);
    normal = d->shading == GLINT_SHADING_EXACT ? normal : t->face;
    double facing = length(normal) > 0.0 ? fabs(dot(normal, unit(minus(d->eye, point)))) : 1.0;
    return pow(clamp01(1.0 - facing), 5.0);
}

/* Rounding moves an end of an edge by up to e, a point of its line beyond the ends by more; and the border is rounded
 * by a sub-pixel over the edge's length in px. */
wire_state shade_wire(const reference_detail *d, const triangle *t, double x, double y)
{
    double half = d->surfaces[t->object].wire_width / 2.0, e = d->options.edge_px;
    bool doubtful = false;
    for (int k = 0; half > 0.0 && k < t->corner_count; k++) {
        const corner *a = &t->corners[k], *b = &t->corners[(k + 1) % t->corner_count];
        double dx = b->x - a->x, dy = b->y - a->y, l = hypot(dx, dy);
        if (t->label[k] == NEAR_EDGE || l == 0.0) {
            continue;
        }
        double along = ((x - a->x) * dx + (y - a->y) * dy) / (l * l);
        double distance = fabs(t->line[k][0] * x + t->line[k][1] * y + t->line[k][2]);
        double border = e * (1.0 + 2.0 * fmax(0.0, fmax(-along, along - 1.0))) + 1.1 / 256.0 / l + e / 16.0;
        if (distance < half - border) {
            return WIRE_ON;
        }
        doubtful = doubtful || distance <= half + border;
    }
    return doubtful ? WIRE_DOUBTFUL : WIRE_OFF;
}

void shade_layer(const reference_detail *d, const triangle *t, const corner *where, const corner *anchor, int variant,
                 bool wire, double rgb[3], double *through)
{
    const surface *f = &d->surfaces[t->object];
    unfogged(d, t, where, anchor, variant, rgb);
    double grazing = f->grazes ? f->transmission * mirrored(d, t, where) : 0.0;
    *through = f->transmission - grazing;
    for (int k = 0; k < 3; k++) {
        rgb[k] = wire ? f->wire[k] : clamp01(rgb[k] + grazing * f->grazing[k]);
    }
    *through = wire ? 0.0 : *through;
    if (d->fog_end > d->fog_begin) {
        double fog = clamp01((1.0 / where->inverse_z - d->fog_begin) / (d->fog_end - d->fog_begin));
        for (int k = 0; k < 3; k++) {
            rgb[k] = (1.0 - fog) * rgb[k] + fog * (1.0 - *through) * d->fog[k];
        }
    }
}

void shade_corner(const reference_detail *d, const triangle *t, const corner *where, const corner *anchor, int variant,
                  double rgb[3])
{
    double through;
    shade_layer(d, t, where, anchor, variant, shade_wire(d, t, where->x, where->y) == WIRE_ON, rgb, &through);
}
