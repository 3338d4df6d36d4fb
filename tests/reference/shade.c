/* SPDX-License-Identifier: MIT */
/*
 * The reflectance model of <glint/scene.h> and the three shadings of <glint/quality.h>, written out term by term.
 */
#include <string.h>

#include "internal.h"

/* A texture's colour that changes the pixel by more than this is contested: see reference.h. */
#define TEXEL_CODES 0.3
/* A change of colour that counts for none. */
#define NOTHING (0.001 / 255.0)

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

static bool light_seen(const reference_detail *d, const triangle *on, vector point, const undecided *u, int light)
{
    if (on == NULL || !d->lamps[light].casts) {
        return true;
    }
    for (int k = 0; k < u->shadow_count; k++) {
        if (u->shadow[k] == light) {
            return (u->on >> (u->terminator_count + k) & 1u) != 0;
        }
    }
    return !shadow_hides(d, on, point, light);
}

/* The model in two parts: what a texture multiplies, and the rest. */
static void light_parts(const reference_detail *d, const surface *f, const triangle *on, vector point, vector normal,
                        const undecided *u, double coloured[3], double plain[3])
{
    vector c = unit(minus(d->eye, point));
    if (length(normal) == 0.0) {
        normal = c;
    }
    for (int k = 0; k < 3; k++) {
        double above = dot(normal, d->up);
        plain[k] = f->emission[k];
        coloured[k] = f->ambient[k] + f->sky[k] * (1.0 + above) / 2.0 + f->ground[k] * (1.0 - above) / 2.0;
    }
    if (d->around.side > 0) {
        double mirrored[3];
        around_colour(&d->around, minus(times(2.0 * dot(normal, c), normal), c), mirrored);
        for (int k = 0; k < 3; k++) {
            plain[k] += f->mirror[k] * mirrored[k];
        }
    }
    for (int j = 0; j < d->lamp_count; j++) {
        const lamp *l = &d->lamps[j];
        vector s;
        if (l->is_area) {
            area_mean mean = area_light(l, f, point, normal, c);
            for (int k = 0; k < 3; k++) {
                coloured[k] += l->colour[k] * f->diffuse[k] * mean.diffuse;
                plain[k] += l->colour[k] * f->specular[k] * mean.specular;
            }
            continue;
        }
        if (!lamp_toward(l, point, &s)) {
            continue;
        }
        double ns = dot(normal, s);
        bool lit = ns > 0.0;
        for (int k = 0; k < u->terminator_count; k++) {
            if (u->terminator[k] == j) {
                lit = (u->on >> k & 1u) != 0;
            }
        }
        if ((ns <= 0.0 && !lit) || !light_seen(d, on, point, u, j)) {
            continue;
        }
        double specular = lit ? shade_highlight(f, normal, s, c) : 0.0, factor = lamp_factor(l, point, s);
        for (int k = 0; k < 3; k++) {
            coloured[k] += factor * l->colour[k] * f->diffuse[k] * (ns > 0.0 ? ns : 0.0);
            plain[k] += factor * l->colour[k] * f->specular[k] * specular;
        }
    }
}

void shade_point(const reference_detail *d, const surface *f, const triangle *on, vector point, vector normal,
                 const undecided *u, const double *texel, double rgb[3])
{
    double coloured[3], plain[3];
    light_parts(d, f, on, point, normal, u, coloured, plain);
    for (int k = 0; k < 3; k++) {
        rgb[k] = clamp01((texel ? texel[k] : 1.0) * coloured[k] + plain[k]);
    }
}

/* For shadings that light a triangle's corners or its centroid: both parts, each clamped. Without a texture the sum. */
static void shade_face(const reference_detail *d, const surface *f, vector point, vector normal, const undecided *u,
                       double coloured[3], double plain[3])
{
    light_parts(d, f, NULL, point, normal, u, coloured, plain);
    for (int k = 0; k < 3; k++) {
        if (f->texture.rgb) {
            coloured[k] = clamp01(coloured[k]);
            plain[k] = clamp01(plain[k]);
        } else {
            coloured[k] = clamp01(coloured[k] + plain[k]);
            plain[k] = 0.0;
        }
    }
}

int shade_terminators(const reference_detail *d, const surface *f, vector point, vector normal,
                      int lights[TERMINATOR_MAX])
{
    static const double black[3] = {0.0, 0.0, 0.0};
    int count = 0;
    if (length(normal) == 0.0) {
        return 0;
    }
    /* a dark texel hides no highlight by saturation, as a light one may */
    const double *texel = f->texture.rgb ? black : NULL;
    for (int j = 0; j < d->lamp_count && count < TERMINATOR_MAX; j++) {
        vector s;
        /* over an extended source the term ends gradually */
        if (!d->lamps[j].is_area && lamp_toward(&d->lamps[j], point, &s) &&
            fabs(dot(normal, s)) < d->options.terminator) {
            undecided u = {.terminator = {j}, .terminator_count = 1, .on = 1u};
            double with[3], without[3], change = 0.0;
            shade_point(d, f, NULL, point, normal, &u, texel, with);
            u.on = 0u;
            shade_point(d, f, NULL, point, normal, &u, texel, without);
            for (int k = 0; k < 3; k++) {
                change = fmax(change, with[k] - without[k]);
            }
            if (change > NOTHING) {
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
    const undecided nothing = {.on = 0u};
    int lights[TERMINATOR_MAX];
    t->has_terminator = false;
    if (d->shading == GLINT_SHADING_GOURAUD) {
        for (int i = 0; i < 3; i++) {
            shade_face(d, f, t->world[i], t->normal[i], &nothing, t->corner_colour[i], t->corner_plain[i]);
            t->has_terminator = t->has_terminator || gouraud_terminators(d, t, i, lights) > 0;
        }
    } else if (d->shading == GLINT_SHADING_FLAT) {
        shade_face(d, f, centroid(t), t->face, &nothing, t->flat_colour, t->flat_plain);
        t->has_terminator = shade_terminators(d, f, centroid(t), t->face, lights) > 0;
    }
}

/* Can the light change the colour there? */
static bool light_matters(const reference_detail *d, const surface *f, vector point, vector normal, int light)
{
    const lamp *l = &d->lamps[light];
    vector s;
    double ns = 0.0, most = 0.0;
    if (!lamp_toward(l, point, &s) || (ns = dot(normal, s)) < -d->options.terminator) {
        return false;
    }
    for (int k = 0; k < 3; k++) {
        most = fmax(most, lamp_factor(l, point, s) * l->colour[k] * (f->diffuse[k] * fmax(ns, 0.0) + f->specular[k]));
    }
    return most > NOTHING;
}

/* What is undecided at a point of exact or flat shading. */
static void leave_open(const reference_detail *d, const triangle *t, const corner *anchor, undecided *u)
{
    const surface *f = &d->surfaces[t->object];
    vector point = centroid(t), normal = t->face;
    memset(u, 0, sizeof *u);
    if (d->shading == GLINT_SHADING_EXACT) {
        exact_point(t, anchor, &point, &normal);
    }
    u->terminator_count = shade_terminators(d, f, point, normal, u->terminator);
    for (int j = 0; d->shading == GLINT_SHADING_EXACT && j < d->lamp_count && u->shadow_count < SHADOW_MAX; j++) {
        if (d->lamps[j].casts && light_matters(d, f, point, normal, j) && shadow_contested(d, t, anchor, j)) {
            u->shadow[u->shadow_count++] = j;
        }
    }
}

/* Variants are numbered in bits: exact and flat: those of what is undecided; Gouraud: bit i for all lights together at
 * whose terminator corner i stands. */
int shade_variants(const reference_detail *d, const triangle *t, const corner *anchor, uint8_t *mask)
{
    undecided u = {.terminator_count = d->shading == GLINT_SHADING_GOURAUD && t->has_terminator ? 3 : 0};
    if (d->shading != GLINT_SHADING_GOURAUD) {
        leave_open(d, t, anchor, &u);
    }
    if (mask) {
        *mask = (uint8_t)((u.terminator_count > 0 ? REFERENCE_TERMINATOR : 0) |
                          (u.shadow_count > 0 ? REFERENCE_SHADOW : 0));
    }
    return 1 << (u.terminator_count + u.shadow_count);
}

static void gouraud(const reference_detail *d, const triangle *t, const corner *where, int variant, double rgb[3],
                    double plain[3])
{
    double weight[3], sum = 0.0;
    for (int i = 0; i < 3; i++) {
        weight[i] = fmax(0.0, where->linear[i]);
        sum += weight[i];
    }
    rgb[0] = rgb[1] = rgb[2] = plain[0] = plain[1] = plain[2] = 0.0;
    for (int i = 0; i < 3; i++) {
        double at_corner[3], plain_there[3];
        memcpy(at_corner, t->corner_colour[i], sizeof at_corner);
        memcpy(plain_there, t->corner_plain[i], sizeof plain_there);
        if (variant >= 0 && t->has_terminator) {
            undecided u = {.on = variant >> i & 1 ? ~0u : 0u};
            u.terminator_count = gouraud_terminators(d, t, i, u.terminator);
            shade_face(d, &d->surfaces[t->object], t->world[i], t->normal[i], &u, at_corner, plain_there);
        }
        for (int k = 0; k < 3; k++) {
            rgb[k] += weight[i] / sum * at_corner[k];
            plain[k] += weight[i] / sum * plain_there[k];
        }
    }
}

/* Perspective-correct texture coordinates at a place on the screen. */
static void texcoord_at(const triangle *t, const corner *where, double uv[2])
{
    double sum = 0.0;
    uv[0] = uv[1] = 0.0;
    for (int i = 0; i < 3; i++) {
        double b = fmax(0.0, where->share[i]);
        uv[0] += b * t->texcoord[i][0];
        uv[1] += b * t->texcoord[i][1];
        sum += b;
    }
    uv[0] /= sum;
    uv[1] /= sum;
}

bool shade_texels(const reference_detail *d, const triangle *t, const corner *points, int count, double least[3],
                  double most[3])
{
    const picture *p = &d->surfaces[t->object].texture;
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    if (!p->rgb) {
        return false;
    }
    for (int i = 0; i < count; i++) {
        double uv[2];
        texcoord_at(t, &points[i], uv);
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], uv[k] - d->options.texels / p->size[k]);
            high[k] = fmax(high[k], uv[k] + d->options.texels / p->size[k]);
        }
    }
    picture_range(p, low, high, least, most);
    return true;
}

/* The colour before fog. */
static void unfogged(const reference_detail *d, const triangle *t, const corner *where, const corner *anchor,
                     int variant, const double *texel, double rgb[3])
{
    const surface *f = &d->surfaces[t->object];
    undecided u = {.on = 0u};
    vector point, normal;
    double sampled[3] = {1.0, 1.0, 1.0}, plain[3];
    if (f->texture.rgb && !texel) {
        double uv[2];
        texcoord_at(t, where, uv);
        picture_at(&f->texture, uv, sampled);
    }
    texel = texel ? texel : sampled;
    if (variant >= 0 && d->shading != GLINT_SHADING_GOURAUD) {
        leave_open(d, t, anchor, &u);
        u.on = (unsigned)variant;
    }
    if (d->shading == GLINT_SHADING_EXACT) {
        exact_point(t, where, &point, &normal);
        shade_point(d, f, t, point, normal, &u, texel, rgb);
        return;
    }
    if (d->shading == GLINT_SHADING_GOURAUD) {
        gouraud(d, t, where, variant, rgb, plain);
    } else if (variant < 0 || !t->has_terminator) {
        memcpy(rgb, t->flat_colour, sizeof t->flat_colour);
        memcpy(plain, t->flat_plain, sizeof plain);
    } else {
        shade_face(d, f, centroid(t), t->face, &u, rgb, plain);
    }
    for (int k = 0; k < 3; k++) {
        rgb[k] = clamp01(texel[k] * rgb[k] + plain[k]);
    }
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
                 bool wire, const double *texel, double rgb[3], double *through)
{
    const surface *f = &d->surfaces[t->object];
    unfogged(d, t, where, anchor, variant, texel, rgb);
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
                  const double *texel, double rgb[3])
{
    double through;
    shade_layer(d, t, where, anchor, variant, shade_wire(d, t, where->x, where->y) == WIRE_ON, texel, rgb, &through);
}

bool shade_texel_contested(const reference_detail *d, const triangle *t, const corner *hit)
{
    corner region[MEET_REGION_MAX + 1];
    double least[3], most[3], low[3], high[3], apart = 0.0;
    int count = meet_region(t, hit->x, hit->y, d->options.texel_px, region);
    region[count++] = *hit;
    if (!shade_texels(d, t, region, count, least, most)) {
        return false;
    }
    shade_corner(d, t, hit, hit, -1, least, low);
    shade_corner(d, t, hit, hit, -1, most, high);
    for (int k = 0; k < 3; k++) {
        apart = fmax(apart, high[k] - low[k]);
    }
    return apart > TEXEL_CODES / 255.0;
}
