/* SPDX-License-Identifier: MIT */
/*
 * Prints the C source of a built-in texture. All arithmetic is in integers, so that the bytes are the same everywhere.
 *
 * Usage: generate-textures tiles|planks|globe > examples/textures/NAME.c
 *
 * The pictures are made of value noise: random numbers at the points of a lattice, smoothly blended between, summed
 * over lattices of growing fineness (K. Perlin, "An image synthesizer", SIGGRAPH 1985, has noise of this kind).
 */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* A random number of 0..255 for a lattice point. */
static int32_t lattice(uint32_t x, uint32_t y, uint32_t seed)
{
    uint32_t h = x * 374761393u + y * 668265263u + seed * 2246822519u;
    h = (h ^ (h >> 13)) * 1274126177u;
    h = (h ^ (h >> 15)) * 2654435761u;
    return (int32_t)(h >> 24);
}

/* 3 t^2 - 2 t^3, Q8. */
static int32_t smooth(int32_t t_q8)
{
    return (t_q8 * t_q8 * (3 * 256 - 2 * t_q8)) >> 16;
}

/* Noise of 0..255 at a point of the unit square in Q16, with cells_x x cells_y lattice cells; it repeats in x and y. */
static int32_t noise(uint32_t x_q16, uint32_t y_q16, uint32_t cells_x, uint32_t cells_y, uint32_t seed)
{
    const uint32_t x = x_q16 * cells_x, y = y_q16 * cells_y;
    const uint32_t i = x >> 16, j = y >> 16, right = (i + 1) % cells_x, down = (j + 1) % cells_y;
    const int32_t s = smooth((int32_t)(x >> 8 & 255)), t = smooth((int32_t)(y >> 8 & 255));
    const int32_t top = lattice(i, j, seed) * (256 - s) + lattice(right, j, seed) * s;
    const int32_t bottom = lattice(i, down, seed) * (256 - s) + lattice(right, down, seed) * s;
    return (top * (256 - t) + bottom * t) >> 16;
}

static uint16_t rgb565(int32_t r, int32_t g, int32_t b)
{
    const int32_t k[3] = {r < 0 ? 0 : r > 255 ? 255 : r, g < 0 ? 0 : g > 255 ? 255 : g, b < 0 ? 0 : b > 255 ? 255 : b};
    return (uint16_t)((k[0] * 31 + 127) / 255 << 11 | (k[1] * 63 + 127) / 255 << 5 | (k[2] * 31 + 127) / 255);
}

static void print_head(const char *name, const char *what)
{
    printf("/* SPDX-License-Identifier: MIT */ /* made by: generate-textures %s */\n", name);
    printf("/*\n * %s\n */\n#include <examples/textures/textures.h>\n\n/* clang-format off */\n", what);
}

static void print_numbers(const char *name, const char *what, const char *type, const uint16_t *value, int count)
{
    printf("\nstatic const %s %s_%s[] GLINT_FLASH = {", type, name, what);
    for (int i = 0; i < count; i++) {
        printf("%s%u,", i % 24 == 0 ? "\n    " : " ", (unsigned)value[i]);
    }
    printf("\n};\n");
}

static void print_texture(const char *name, int width, int height, const char *format, const char *filter)
{
    printf("\nconst glint_texture glint_texture_%s = {\n    .texels = %s_texels,\n", name, name);
    printf("    .width_px = %d,\n    .height_px = %d,\n    .format = %s,\n    .filter = %s,\n", width, height, format,
           filter);
}

/* Two kinds of stone, a square of four tiles with joints between them. */
static void print_tiles(void)
{
    enum { SIZE = 32 };
    static const uint16_t palette[] = {0x9cd1, 0xe71a, 0xd677, 0xce35, 0x5aa9, 0x6b0b, 0x4a47, 0x39e5};
    uint16_t texel[SIZE * SIZE];
    for (int y = 0; y < SIZE; y++) {
        for (int x = 0; x < SIZE; x++) {
            const int in_x = x % (SIZE / 2), in_y = y % (SIZE / 2);
            const int dark = ((x / (SIZE / 2)) ^ (y / (SIZE / 2))) & 1;
            const uint32_t u = (uint32_t)x * 65536 / SIZE, v = (uint32_t)y * 65536 / SIZE;
            const int32_t grain = noise(u, v, 8, 8, 5) / 2 + noise(u, v, 16, 16, 9) / 2;
            const int shade =
                dark ? 4 + (grain > 100) + (grain > 145) + (grain > 165) : 1 + (grain > 120) + (grain > 150);
            texel[y * SIZE + x] = (uint16_t)(in_x == 0 || in_y == 0 ? 0 : shade);
        }
    }
    print_head("tiles", "Light and dark tiles with joints: 32 x 32 texels, 8 colours.");
    print_numbers("tiles", "palette", "uint16_t", palette, sizeof palette / sizeof palette[0]);
    print_numbers("tiles", "texels", "uint8_t", texel, SIZE * SIZE);
    print_texture("tiles", SIZE, SIZE, "GLINT_TEXTURE_PALETTE8", "GLINT_NEAREST");
    printf("    .palette = tiles_palette,\n    .palette_count = %d,\n};\n", (int)(sizeof palette / sizeof palette[0]));
}

/* Four planks along u, each with rings of its own. */
static void print_planks(void)
{
    enum { WIDTH = 64, HEIGHT = 64, PLANKS = 4 };
    uint16_t texel[WIDTH * HEIGHT];
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            const int plank = y / (HEIGHT / PLANKS), in_y = y % (HEIGHT / PLANKS);
            const uint32_t u = (uint32_t)x * 65536 / WIDTH, v = (uint32_t)y * 65536 / HEIGHT;
            const uint32_t seed = 20 + 7 * (uint32_t)plank;
            /* rings: a saw of the distance from the heart, bent by slow noise along the plank */
            const int32_t bent = in_y * 22 + noise(u, v, 2, 8, seed) / 2 + noise(u, v, 4, 16, seed + 1) / 4;
            const int32_t ring = bent % 64 < 32 ? bent % 64 : 63 - bent % 64;
            const int32_t fibre = noise(u, v, 16, 64, seed + 2) / 8;
            const int32_t tone = lattice((uint32_t)plank, 0, 77) / 6;
            const int32_t light =
                105 + tone + fibre + ring - (in_y == 0 ? 70 : 0) - (x == (plank * 27 + 9) % WIDTH ? 60 : 0);
            texel[y * WIDTH + x] = rgb565(light + 25, light * 3 / 4 + 5, light / 2 - 5);
        }
    }
    print_head("planks", "Four planks of wood: 64 x 64 texels.");
    print_numbers("planks", "texels", "uint16_t", texel, WIDTH * HEIGHT);
    print_texture("planks", WIDTH, HEIGHT, "GLINT_TEXTURE_RGB565", "GLINT_BILINEAR");
    printf("};\n");
}

/* Seas, shores, land, mountains and ice of a planet. */
static void print_globe(void)
{
    enum { WIDTH = 128, HEIGHT = 64, SEA = 128 };
    static const uint16_t palette[] = {0x10cc, 0x1970, 0x2213, 0x3376, 0xd652, 0x4ca6,
                                       0x3c05, 0x5485, 0x8429, 0x6b0a, 0xef7d, 0xffff};
    uint16_t texel[WIDTH * HEIGHT];
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            const uint32_t u = (uint32_t)x * 65536 / WIDTH, v = (uint32_t)y * 65536 / HEIGHT;
            const int32_t height = (noise(u, v, 5, 4, 3) * 8 + noise(u, v, 10, 8, 4) * 4 + noise(u, v, 20, 16, 5) * 2 +
                                    noise(u, v, 40, 32, 6) + 7) /
                                   15;
            const int pole = y < HEIGHT / 2 ? y : HEIGHT - 1 - y;
            const int32_t ice = noise(u, v, 12, 8, 11) / 64 + 4 + (height > SEA ? 1 : 0);
            int colour = height < SEA - 30   ? 0
                         : height < SEA - 12 ? 1
                         : height < SEA - 4  ? 2
                         : height < SEA      ? 3
                         : height < SEA + 4  ? 4
                         : height < SEA + 14 ? 5
                         : height < SEA + 26 ? 6
                         : height < SEA + 38 ? 7
                         : height < SEA + 50 ? 8
                                             : 9;
            if (pole < ice) {
                colour = height > SEA ? 11 : 10;
            }
            texel[y * WIDTH + x] = (uint16_t)colour;
        }
    }
    print_head("globe", "A planet, by longitude and latitude: 128 x 64 texels, 12 colours.");
    print_numbers("globe", "palette", "uint16_t", palette, sizeof palette / sizeof palette[0]);
    print_numbers("globe", "texels", "uint8_t", texel, WIDTH * HEIGHT);
    print_texture("globe", WIDTH, HEIGHT, "GLINT_TEXTURE_PALETTE8", "GLINT_BILINEAR");
    printf("    .wrap_v = GLINT_CLAMP,\n    .palette = globe_palette,\n    .palette_count = %d,\n};\n",
           (int)(sizeof palette / sizeof palette[0]));
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        void (*print)(void);
    } textures[] = {{"tiles", print_tiles}, {"planks", print_planks}, {"globe", print_globe}};
    for (size_t i = 0; argc == 2 && i < sizeof textures / sizeof textures[0]; i++) {
        if (strcmp(argv[1], textures[i].name) == 0) {
            textures[i].print();
            return fflush(stdout) != 0 || ferror(stdout) ? 1 : 0;
        }
    }
    fprintf(stderr, "usage: generate-textures tiles|planks|globe > NAME.c\n");
    return 2;
}
