/* SPDX-License-Identifier: MIT */
/*
 * glint-compare: how far two pictures of one size are apart, in codes of 1/255, on one line.
 *
 * max and mean are of |a - b| over all three channels of the pixels that count; psnr is 20 log10(255 / rms) in dB, inf
 * for equal pictures; differing is the number of pixels with any difference, pixels the number that count. The line is
 * stable: scripts read it.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/picture/picture.h"

static const char usage[] =
    "usage: glint-compare A B [--max CODES] [--apart MASK] [--picture FILE] [--amplify N]\n"
    "\n"
    "Compares two pictures (PPM, PGM; PNG by the ending .png) and prints\n"
    "  max=CODES mean=CODES psnr=DB differing=PIXELS pixels=PIXELS\n"
    "  --max CODES    exit 1 when max is above CODES (0..255)\n"
    "  --apart MASK   leave out the pixels that are not black in the picture MASK of the same size;\n"
    "                 their number and share are added to the line: apart=PIXELS apart_share=PERCENT%\n"
    "  --picture FILE write the difference of all pixels: min(255, N |a - b|) in each channel\n"
    "  --amplify N    the N of --picture, 1..255 (32)\n"
    "exit: 0, 1 when max is above --max, 2 for pictures or options that cannot be used\n";

typedef struct options {
    const char *a, *b, *apart, *picture;
    double limit; /* below 0: none */
    long amplify; /* 0: not given */
} options;

typedef struct figures {
    int max;
    double sum, square;
    unsigned long differing, pixels, apart;
} figures;

static int complain(const char *text, const char *what)
{
    fprintf(stderr, "glint-compare: %s%s\n", text, what);
    return 2;
}

static int read_option(options *o, const char *name, const char *value)
{
    char *end = NULL;
    if (strcmp(name, "--max") == 0) {
        if (o->limit >= 0.0) {
            return complain("--max was given twice", "");
        }
        o->limit = strtod(value, &end);
        if (end == value || *end || !(o->limit >= 0.0 && o->limit <= 255.0)) {
            return complain("--max: a number of codes from 0 to 255 was expected, not ", value);
        }
    } else if (strcmp(name, "--amplify") == 0) {
        if (o->amplify > 0) {
            return complain("--amplify was given twice", "");
        }
        o->amplify = strtol(value, &end, 10);
        if (end == value || *end || o->amplify < 1 || o->amplify > 255) {
            return complain("--amplify: a whole number from 1 to 255 was expected, not ", value);
        }
    } else {
        const char **place = strcmp(name, "--apart") == 0 ? &o->apart : &o->picture;
        if (*place) {
            fprintf(stderr, "glint-compare: %s was given twice\n", name);
            return 2;
        }
        *place = value;
    }
    return 0;
}

static int read_arguments(options *o, int count, char **words)
{
    static const char *const names[] = {"--max", "--apart", "--picture", "--amplify"};
    memset(o, 0, sizeof *o);
    o->limit = -1.0;
    for (int i = 1; i < count; i++) {
        if (words[i][0] == '-' && words[i][1] != '\0') {
            size_t n = 0;
            while (n < sizeof names / sizeof *names && strcmp(words[i], names[n]) != 0) {
                n++;
            }
            if (n == sizeof names / sizeof *names) {
                return complain("--max, --apart, --picture or --amplify was expected, not ", words[i]);
            }
            if (i + 1 == count) {
                return complain("a value was expected after ", words[i]);
            }
            if (read_option(o, words[i], words[i + 1])) {
                return 2;
            }
            i++;
        } else if (!o->a) {
            o->a = words[i];
        } else if (!o->b) {
            o->b = words[i];
        } else {
            return complain("two pictures were expected; one too many: ", words[i]);
        }
    }
    if (!o->b) {
        fprintf(stderr, "glint-compare: two pictures were expected\n%s", usage);
        return 2;
    }
    if (o->amplify > 0 && !o->picture) {
        return complain("--amplify is for the picture that --picture writes; --picture FILE was expected beside it",
                        "");
    }
    return 0;
}

static int same_size(const char *name, const picture *p, const char *first_name, const picture *first)
{
    if (p->width == first->width && p->height == first->height) {
        return 1;
    }
    fprintf(stderr, "glint-compare: pictures of one size were expected: %s is %d x %d px, %s is %d x %d px\n",
            first_name, first->width, first->height, name, p->width, p->height);
    return 0;
}

static figures measure(const picture *a, const picture *b, const picture *mask)
{
    figures f = {0, 0.0, 0.0, 0, 0, 0};
    size_t pixels = (size_t)a->width * (size_t)a->height;
    for (size_t i = 0; i < pixels; i++) {
        const uint8_t *p = &a->rgb[i * 3], *q = &b->rgb[i * 3], *m = mask->rgb ? &mask->rgb[i * 3] : NULL;
        int worst = 0;
        if (m && (m[0] || m[1] || m[2])) {
            f.apart++;
            continue;
        }
        for (int k = 0; k < 3; k++) {
            int difference = abs(p[k] - q[k]);
            worst = difference > worst ? difference : worst;
            f.sum += difference;
            f.square += difference * difference;
        }
        f.max = worst > f.max ? worst : f.max;
        f.differing += worst > 0;
        f.pixels++;
    }
    return f;
}

static void print_figures(const figures *f, int with_apart)
{
    double values = 3.0 * (double)f->pixels;
    printf("max=%d mean=%.4f psnr=", f->max, f->pixels > 0 ? f->sum / values : 0.0);
    if (f->square > 0.0) {
        printf("%.2f", 10.0 * log10(255.0 * 255.0 * values / f->square));
    } else {
        printf("inf");
    }
    printf(" differing=%lu pixels=%lu", f->differing, f->pixels);
    if (with_apart) {
        printf(" apart=%lu apart_share=%.4f%%", f->apart, 100.0 * (double)f->apart / (double)(f->apart + f->pixels));
    }
    printf("\n");
}

static int write_difference(const options *o, const picture *a, const picture *b)
{
    picture out;
    char error[512] = "";
    long amplify = o->amplify > 0 ? o->amplify : 32;
    if (picture_create(&out, a->width, a->height, error, sizeof error)) {
        return complain(error, "");
    }
    size_t values = (size_t)a->width * (size_t)a->height * 3;
    for (size_t i = 0; i < values; i++) {
        long difference = amplify * abs(a->rgb[i] - b->rgb[i]);
        out.rgb[i] = (uint8_t)(difference > 255 ? 255 : difference);
    }
    int status = picture_write(o->picture, &out, error, sizeof error);
    picture_free(&out);
    return status ? complain(error, "") : 0;
}

int main(int count, char **words)
{
    options o;
    picture a = {0, 0, NULL}, b = {0, 0, NULL}, mask = {0, 0, NULL};
    char error[512] = "";
    int status = 2;
    if (count == 2 && strcmp(words[1], "--help") == 0) {
        fputs(usage, stdout);
        return 0;
    }
    if (read_arguments(&o, count, words)) {
        return 2;
    }
    if (picture_read(o.a, &a, error, sizeof error) || picture_read(o.b, &b, error, sizeof error) ||
        (o.apart && picture_read(o.apart, &mask, error, sizeof error))) {
        complain(error, "");
    } else if (same_size(o.b, &b, o.a, &a) && (!o.apart || same_size(o.apart, &mask, o.a, &a)) &&
               !(o.picture && write_difference(&o, &a, &b))) {
        figures f = measure(&a, &b, &mask);
        print_figures(&f, o.apart != NULL);
        status = o.limit >= 0.0 && f.max > o.limit ? 1 : 0;
    }
    picture_free(&a);
    picture_free(&b);
    picture_free(&mask);
    return status;
}
