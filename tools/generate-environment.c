/* SPDX-License-Identifier: MIT */
/*
 * Prints an environment for mirrors as a C file: a sky that is bright at the horizon and about the sun, and a ground of
 * large tiles that fades into haze, in the octahedral map of <glint/scene.h>. Each texel is the mean over its area of
 * the map, so that far tiles blur and neighbouring texels do not differ much.
 *
 * Usage: generate-environment SIDE > examples/scenes/environment_sky.c      SIDE 8, 16, 32, 64 or 128
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#define SAMPLES 16     /* in each direction of a texel */
#define EYE_HEIGHT 1.0 /* above the tiles, in tiles of 1.6 */
#define TILE 1.6
#define SIDE_MOST 128

static const double zenith[3] = {0.16, 0.34, 0.72}, horizon[3] = {0.86, 0.90, 0.94}, haze[3] = {0.62, 0.62, 0.60};
static const double light_tile[3] = {0.62, 0.56, 0.48}, dark_tile[3] = {0.40, 0.36, 0.32}, glow[3] = {1.0, 0.93, 0.78};
static const double sun[3] = {0.424, 0.566, 0.707}; /* towards it */

static double mix(double a, double b, double share)
{
    return a + (b - a) * share;
}

static void sky(const double d[3], double rgb[3])
{
    const double up = sqrt(d[1]), towards = d[0] * sun[0] + d[1] * sun[1] + d[2] * sun[2];
    const double near = exp((towards - 1.0) * 18.0);
    for (int k = 0; k < 3; k++) {
        rgb[k] = mix(mix(horizon[k], zenith[k], up), glow[k], 0.85 * near);
    }
}

static void ground(const double d[3], double rgb[3])
{
    const double far = EYE_HEIGHT / -d[1], x = d[0] * far / TILE, z = d[2] * far / TILE;
    const int dark = ((int)floor(x) + (int)floor(z)) & 1;
    const double clear = exp(-0.22 * far);
    for (int k = 0; k < 3; k++) {
        rgb[k] = mix(haze[k], dark ? dark_tile[k] : light_tile[k], clear);
    }
}

/* The colour that the point (u, v) of the map stands for. */
static void colour_at(double u, double v, double rgb[3])
{
    double d[3] = {u, 1.0 - fabs(u) - fabs(v), v}, length = 0.0;
    if (d[1] < 0.0) {
        d[0] = copysign(1.0 - fabs(v), u);
        d[2] = copysign(1.0 - fabs(u), v);
    }
    for (int k = 0; k < 3; k++) {
        length += d[k] * d[k];
    }
    for (int k = 0; k < 3; k++) {
        d[k] /= sqrt(length);
    }
    if (d[1] >= 0.0) {
        sky(d, rgb);
    } else {
        ground(d, rgb);
    }
}

static uint16_t texel_at(int side, int i, int j)
{
    double sum[3] = {0.0, 0.0, 0.0};
    for (int k = 0; k < SAMPLES * SAMPLES; k++) {
        const int right = k % SAMPLES, below = k / SAMPLES;
        const double x = i + (right + 0.5) / SAMPLES, y = j + (below + 0.5) / SAMPLES;
        double rgb[3];
        colour_at(2.0 * x / side - 1.0, 2.0 * y / side - 1.0, rgb);
        for (int c = 0; c < 3; c++) {
            sum[c] += rgb[c] / (SAMPLES * SAMPLES);
        }
    }
    return (uint16_t)(((unsigned)lrint(sum[0] * 31.0) << 11) | ((unsigned)lrint(sum[1] * 63.0) << 5) |
                      (unsigned)lrint(sum[2] * 31.0));
}

static double difference(uint16_t a, uint16_t b)
{
    const double red = abs((a >> 11) - (b >> 11)) / 31.0, green = abs((a >> 5 & 63) - (b >> 5 & 63)) / 63.0;
    const double blue = abs((a & 31) - (b & 31)) / 31.0;
    return fmax(red, fmax(green, blue));
}

/* The greatest difference of neighbours, in 1/255, rounded up. At the edges a texel's neighbour is the one that the
 * fold brings there. */
static unsigned steepest(int side, uint16_t texel[SIDE_MOST][SIDE_MOST])
{
    double most = 0.0;
    for (int j = 0; j < side; j++) {
        for (int i = 0; i < side; i++) {
            const uint16_t right = i + 1 < side ? texel[j][i + 1] : texel[side - 1 - j][i];
            const uint16_t below = j + 1 < side ? texel[j + 1][i] : texel[j][side - 1 - i];
            most = fmax(most, fmax(difference(texel[j][i], right), difference(texel[j][i], below)));
        }
        most = fmax(most, fmax(difference(texel[j][0], texel[side - 1 - j][0]),
                               difference(texel[0][j], texel[0][side - 1 - j])));
    }
    return (unsigned)ceil(most * 255.0 - 1e-9);
}

int main(int argc, char **argv)
{
    static uint16_t texel[SIDE_MOST][SIDE_MOST];
    const int side = argc == 2 ? (int)strtol(argv[1], NULL, 10) : 0;
    if (side < 8 || side > SIDE_MOST || (side & (side - 1)) != 0) {
        fprintf(stderr, "usage: generate-environment SIDE, of 8, 16, 32, 64 or 128\n");
        return 2;
    }
    for (int j = 0; j < side; j++) {
        for (int i = 0; i < side; i++) {
            texel[j][i] = texel_at(side, i, j);
        }
    }
    printf("/* Made by: build/generate-environment %d > examples/scenes/environment_sky.c */\n", side);
    printf("/* SPDX-License-Identifier: MIT */\n/* clang-format off */\n");
    printf("#include <examples/scenes/environments.h>\n\n");
    printf("static const GLINT_FLASH uint16_t texels[%d] = {\n", side * side);
    for (int k = 0; k < side * side; k++) {
        printf("%s0x%04x,%s", k % 12 == 0 ? "    " : " ", (unsigned)texel[k / side][k % side],
               k % 12 == 11 || k + 1 == side * side ? "\n" : "");
    }
    printf("};\n\nconst glint_environment demo_environment_sky = {.texels = texels, .side = %d, .steepest = %u};\n",
           side, steepest(side, texel));
    return 0;
}
