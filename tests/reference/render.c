/* SPDX-License-Identifier: MIT */
/*
 * Read this first: the reference from the scene to the picture, as calls.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "internal.h"

static void free_detail(reference_detail *d)
{
    if (d) {
        for (int i = 0; d->surfaces && i < d->surface_count; i++) {
            free(d->surfaces[i].texture.rgb);
        }
        free(d->triangles);
        free(d->surfaces);
        free(d->lamps);
        free(d->around.texel);
        free(d->first);
        free(d->meetings);
        free(d->contenders);
        free(d->layers);
        shadow_free(d->shadows);
        free(d);
    }
}

void reference_free(reference_image *image)
{
    free(image->rgb);
    free(image->triangle);
    free(image->depth);
    free(image->mask);
    free(image->rounding);
    free_detail(image->detail);
    memset(image, 0, sizeof *image);
}

static double option(double given, double by_default)
{
    return given == 0.0 ? by_default : fmax(given, 0.0);
}

static corner seen_at(const reference_detail *d, const contender *c, double x, double y)
{
    const triangle *t = &d->triangles[c->triangle];
    return c->inside && t->front ? meet_hit(d, t, x, y) : meet_nearest(t, x, y);
}

/* The surface that is seen, or the background. */
static void draw_opaque(reference_image *image, int x, int y, size_t at, int front)
{
    reference_detail *d = image->detail;
    if (front < 0) {
        image->triangle[at] = -1;
        memcpy(&image->rgb[at * 3], d->background, sizeof d->background);
        return;
    }
    const contender *c = &d->contenders[front];
    const triangle *t = &d->triangles[c->triangle];
    corner hit = seen_at(d, c, x + 0.5, y + 0.5);
    image->triangle[at] = c->triangle;
    image->depth[at] = 1.0 / hit.inverse_z;
    shade_corner(d, t, &hit, &hit, -1, NULL, &image->rgb[at * 3]);
    if (shade_wire(d, t, hit.x, hit.y) == WIRE_DOUBTFUL) {
        image->mask[at] = (uint8_t)(image->mask[at] | REFERENCE_EDGE);
    }
    uint8_t mask;
    if (shade_texel_contested(d, t, &hit)) {
        image->mask[at] = (uint8_t)(image->mask[at] | REFERENCE_TEXEL);
    }
    (void)shade_variants(d, t, &hit, &mask);
    image->mask[at] = (uint8_t)(image->mask[at] | mask);
}

static void draw_pixel(reference_image *image, int x, int y)
{
    reference_detail *d = image->detail;
    size_t at = (size_t)y * (size_t)image->width + (size_t)x;
    int front;
    bool background;
    int opaque = contest(d, x, y, &front, &image->mask[at], &background);
    draw_opaque(image, x, y, at, front);
    if (!d->has_layers) {
        return;
    }
    int count = layers_at(d, x, y, opaque, front, background, d->layers);
    if (layers_show(d, d->layers, count, &image->rgb[at * 3], &image->rounding[at])) {
        image->mask[at] = (uint8_t)(image->mask[at] | REFERENCE_LAYER);
    }
    for (int k = 0; k < count; k++) {
        if (d->layers[k].there) {
            image->triangle[at] = d->layers[k].surface.triangle;
            image->depth[at] = 1.0 / d->layers[k].hit.inverse_z;
            if (shade_texel_contested(d, &d->triangles[d->layers[k].surface.triangle], &d->layers[k].hit)) {
                image->mask[at] = (uint8_t)(image->mask[at] | REFERENCE_TEXEL);
            }
        }
    }
}

static int fail(reference_image *image, char *error, size_t error_bytes, const char *text)
{
    reference_free(image);
    if (text && error_bytes > 0) {
        snprintf(error, error_bytes, "%s", text);
    }
    return -1;
}

int reference_render_with(const glint_scene *scene, int width, int height, int shading,
                          const reference_options *options, reference_image *out, char *error, size_t error_bytes)
{
    memset(out, 0, sizeof *out);
    if (width < 1 || height < 1 || width > GLINT_MAX_SIZE_PX || height > GLINT_MAX_SIZE_PX) {
        return fail(out, error, error_bytes, "a width and height from 1 to GLINT_MAX_SIZE_PX were expected");
    }
    if (shading != GLINT_SHADING_EXACT && shading != GLINT_SHADING_GOURAUD && shading != GLINT_SHADING_FLAT) {
        return fail(out, error, error_bytes, "GLINT_SHADING_EXACT, _GOURAUD or _FLAT was expected");
    }
    size_t pixels = (size_t)width * (size_t)height;
    out->width = width;
    out->height = height;
    out->rgb = calloc(pixels * 3, sizeof *out->rgb);
    out->triangle = calloc(pixels, sizeof *out->triangle);
    out->depth = calloc(pixels, sizeof *out->depth);
    out->mask = calloc(pixels, sizeof *out->mask);
    out->rounding = calloc(pixels, sizeof *out->rounding);
    out->detail = calloc(1, sizeof *out->detail);
    reference_detail *d = out->detail;
    if (!out->rgb || !out->triangle || !out->depth || !out->mask || !out->rounding || !d) {
        return fail(out, error, error_bytes, "no memory for the picture");
    }
    d->width = width;
    d->height = height;
    d->shading = shading;
    d->options.edge_px = option(options ? options->edge_px : 0.0, 1.0 / 256.0);
    d->options.depth_steps = option(options ? options->depth_steps : 0.0, 2.0);
    d->options.terminator = option(options ? options->terminator : 0.0, 1e-4);
    d->options.texel_px = option(options ? options->texel_px : 0.0, 1.0 / 4096.0);
    d->options.texels = option(options ? options->texels : 0.0, 1.0 / 4096.0);
    d->options.shadow_px = option(options ? options->shadow_px : 0.0, 1.0);

    if (view_load(d, scene, error, error_bytes)) {
        return fail(out, error, error_bytes, NULL);
    }
    if (shadow_load(d)) {
        return fail(out, error, error_bytes, "no memory for shadows");
    }
    for (int32_t i = 0; i < d->triangle_count; i++) {
        shade_triangle(d, &d->triangles[i]);
    }
    if (seal_edges(d) || meet_all(d)) {
        return fail(out, error, error_bytes, "no memory for the surfaces of each pixel");
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            draw_pixel(out, x, y);
        }
    }
    return 0;
}

int reference_render(const glint_scene *scene, int width, int height, int shading, reference_image *out, char *error,
                     size_t error_bytes)
{
    return reference_render_with(scene, width, height, shading, NULL, out, error, error_bytes);
}

static void widen(reference_candidate *c, const double rgb[3])
{
    for (int k = 0; k < 3; k++) {
        c->low[k] = fmin(c->low[k], rgb[k]);
        c->high[k] = fmax(c->high[k], rgb[k]);
    }
}

/* All variants of one triangle at a pixel, with its wire and without it where that is doubtful. */
static int triangle_candidates(const reference_detail *d, const contender *c, int x, int y, reference_candidate *out,
                               int count, int max)
{
    const triangle *t = &d->triangles[c->triangle];
    corner region[MEET_REGION_MAX + 1], anchor = seen_at(d, c, x + 0.5, y + 0.5);
    int points = meet_region(t, x + 0.5, y + 0.5, d->options.edge_px, region);
    int variants = shade_variants(d, t, &anchor, NULL);
    double texel[2][3];
    region[points++] = anchor;
    wire_state wire = shade_wire(d, t, anchor.x, anchor.y);
    bool textured = shade_texels(d, t, region, points, texel[0], texel[1]);
    for (int v = 0; v < variants * 2; v++) {
        bool on = v >= variants;
        if (wire != WIRE_DOUBTFUL && on != (wire == WIRE_ON)) {
            continue;
        }
        reference_candidate one = {c->triangle, {HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
        for (int k = 0; k < points; k++) {
            /* more of each channel of the texture is more of the pixel */
            for (int m = 0; m < (textured ? 2 : 1); m++) {
                double rgb[3], through;
                shade_layer(d, t, &region[k], &anchor, variants > 1 ? v % variants : -1, on, textured ? texel[m] : NULL,
                            rgb, &through);
                widen(&one, rgb);
            }
        }
        if (count < max) {
            out[count] = one;
        }
        count++;
    }
    return count;
}

/* The opaque surfaces, of which contest() has found so many. */
static int opaque_candidates(const reference_image *image, int x, int y, int contenders, int front, bool background,
                             reference_candidate *out, int max)
{
    const reference_detail *d = image->detail;
    int count = 0;
    if (front >= 0) {
        count = triangle_candidates(d, &d->contenders[front], x, y, out, count, max);
    }
    if (background) {
        reference_candidate one = {-1, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
        memcpy(one.low, d->background, sizeof one.low);
        memcpy(one.high, d->background, sizeof one.high);
        if (count < max) {
            out[count] = one;
        }
        count++;
    }
    for (int k = 0; k < contenders; k++) {
        if (k != front && d->contenders[k].candidate) {
            count = triangle_candidates(d, &d->contenders[k], x, y, out, count, max);
        }
    }
    return count;
}

/* Opaque surfaces that are looked at behind layers. */
#define BEHIND_MAX 64

int reference_candidates(const reference_image *image, int x, int y, reference_candidate *out, int max)
{
    reference_detail *d = image->detail;
    reference_candidate behind[BEHIND_MAX];
    int front;
    uint8_t mask;
    bool background;
    int opaque = contest(d, x, y, &front, &mask, &background);
    int layers = d->has_layers ? layers_at(d, x, y, opaque, front, background, d->layers) : 0;
    if (layers == 0) {
        return opaque_candidates(image, x, y, opaque, front, background, out, max);
    }
    int count = opaque_candidates(image, x, y, opaque, front, background, behind, BEHIND_MAX);
    for (int k = 0; k < count && k < BEHIND_MAX && k < max; k++) {
        out[k] = behind[k];
        out[k].triangle = image->triangle[(size_t)y * (size_t)image->width + (size_t)x];
        layers_range(d, d->layers, layers, x, y, &out[k]);
    }
    return count;
}
