/* SPDX-License-Identifier: MIT */
/*
 * shrink N IN.ppm OUT.ppm: a screen dump in which each pixel of the panel is a square of N x N pixels, as one pixel
 * each. Refuses a picture whose squares are not of one colour.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/picture/picture.h"

static int complain(const char *text)
{
    (void)fprintf(stderr, "shrink: %s\n", text);
    return 2;
}

static int shrink(const picture *in, int n, picture *out)
{
    for (int y = 0; y < in->height; y++) {
        for (int x = 0; x < in->width; x++) {
            const uint8_t *from = in->rgb + ((size_t)y * (size_t)in->width + (size_t)x) * 3;
            uint8_t *to = out->rgb + ((size_t)(y / n) * (size_t)out->width + (size_t)(x / n)) * 3;
            if (x % n == 0 && y % n == 0) {
                memcpy(to, from, 3);
            } else if (memcmp(to, from, 3) != 0) {
                return complain("a square is not of one colour");
            }
        }
    }
    return 0;
}

int main(int count, char **words)
{
    picture in, out;
    char error[256];
    const int n = count == 4 ? (int)strtol(words[1], NULL, 10) : 0;
    if (n < 1) {
        return complain("usage: shrink N IN.ppm OUT.ppm");
    }
    if (picture_read(words[2], &in, error, sizeof error)) {
        return complain(error);
    }
    if (in.width % n != 0 || in.height % n != 0) {
        return complain("the picture is not a multiple of N wide and high");
    }
    if (picture_create(&out, in.width / n, in.height / n, error, sizeof error)) {
        return complain(error);
    }
    int status = shrink(&in, n, &out);
    if (status == 0 && picture_write(words[3], &out, error, sizeof error)) {
        status = complain(error);
    }
    picture_free(&in);
    picture_free(&out);
    return status;
}
