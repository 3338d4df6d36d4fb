/* SPDX-License-Identifier: MIT */
/*
 * Judges a picture against the reference; the figures are defined in reference.h.
 */
#include <stdlib.h>
#include <string.h>

#include "internal.h"

/* Candidates that are looked at in one pixel: beyond a pile of this many surfaces the rest are not tried. */
#define CANDIDATES_MAX 64

static double rounded(double level)
{
    return floor(255.0 * level + 0.5);
}

void reference_codes(const reference_image *image, uint8_t *rgb8)
{
    size_t values = (size_t)image->width * (size_t)image->height * 3;
    for (size_t i = 0; i < values; i++) {
        rgb8[i] = (uint8_t)rounded(image->rgb[i]);
    }
}

void reference_mask_codes(const reference_image *image, uint8_t *rgb8)
{
    size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < pixels; i++) {
        rgb8[i * 3] = image->mask[i] & REFERENCE_EDGE ? 255 : 0;
        rgb8[i * 3 + 1] = image->mask[i] & REFERENCE_DEPTH ? 255 : 0;
        rgb8[i * 3 + 2] = image->mask[i] & (REFERENCE_TERMINATOR | REFERENCE_TEXEL) ? 255 : 0;
        if ((image->mask[i] & REFERENCE_SHADOW) != 0) {
            rgb8[i * 3 + 1] |= 128;
            rgb8[i * 3 + 2] |= 128;
        }
    }
}

static bool agrees(const reference_candidate *c, const uint8_t actual[3], double slack)
{
    for (int k = 0; k < 3; k++) {
        if (actual[k] < 255.0 * c->low[k] - slack || actual[k] > 255.0 * c->high[k] + slack) {
            return false;
        }
    }
    return true;
}

static bool agrees_with_any(const reference_image *image, int x, int y, const uint8_t actual[3], double max_codes)
{
    max_codes += image->rounding[(size_t)y * (size_t)image->width + (size_t)x];
    reference_candidate list[CANDIDATES_MAX];
    int count = reference_candidates(image, x, y, list, CANDIDATES_MAX);
    for (int k = 0; k < count && k < CANDIDATES_MAX; k++) {
        if (agrees(&list[k], actual, max_codes + 0.5)) {
            return true;
        }
    }
    return false;
}

void reference_check(const reference_image *image, const uint8_t *rgb8, double max_codes, reference_verdict *v)
{
    double sum = 0.0, square = 0.0;
    uint32_t shadow_only = 0;
    memset(v, 0, sizeof *v);
    v->worst_x = v->worst_y = v->unmatched_x = v->unmatched_y = -1;
    v->max_codes = -1.0;
    v->pixels = (uint32_t)image->width * (uint32_t)image->height;
    for (uint32_t i = 0; i < v->pixels; i++) {
        int x = (int)(i % (uint32_t)image->width), y = (int)(i / (uint32_t)image->width);
        const uint8_t *actual = &rgb8[(size_t)i * 3];
        double worst_rounded = 0.0;
        if (image->mask[i]) {
            v->contested++;
            v->contested_edge += (image->mask[i] & REFERENCE_EDGE) != 0;
            v->contested_depth += (image->mask[i] & REFERENCE_DEPTH) != 0;
            v->contested_terminator += (image->mask[i] & REFERENCE_TERMINATOR) != 0;
            v->contested_texel += (image->mask[i] & REFERENCE_TEXEL) != 0;
            v->contested_shadow += (image->mask[i] & REFERENCE_SHADOW) != 0;
            shadow_only += image->mask[i] == REFERENCE_SHADOW;
            if (!agrees_with_any(image, x, y, actual, max_codes) && v->unmatched++ == 0) {
                v->unmatched_x = x;
                v->unmatched_y = y;
            }
            continue;
        }
        for (int k = 0; k < 3; k++) {
            double level = image->rgb[(size_t)i * 3 + (size_t)k];
            double error = fmax(0.0, fabs(actual[k] - 255.0 * level) - image->rounding[i]);
            double to_code = fmax(0.0, fabs(actual[k] - rounded(level)) - image->rounding[i]);
            sum += error;
            square += to_code * to_code;
            worst_rounded = fmax(worst_rounded, to_code);
            if (error > v->max_codes) {
                v->max_codes = error;
                v->worst_x = x;
                v->worst_y = y;
            }
        }
        v->differing += worst_rounded > 0.0;
        if (worst_rounded > max_codes) {
            v->above++;
            v->above_unexplained += !agrees_with_any(image, x, y, actual, max_codes);
        }
    }
    double values = 3.0 * (v->pixels - v->contested);
    v->max_codes = fmax(v->max_codes, 0.0);
    v->mean_codes = values > 0.0 ? sum / values : 0.0;
    v->psnr_db = square > 0.0 ? 10.0 * log10(255.0 * 255.0 * values / square) : (double)INFINITY;
    v->contested_share = (double)(v->contested - shadow_only) / v->pixels;
    v->shadow_share = (double)shadow_only / v->pixels;
}
