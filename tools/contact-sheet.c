/* SPDX-License-Identifier: MIT */
/*
 * contact-sheet: sets pictures side by side into one, each with its file's name below it, for a person to look over.
 *
 *     contact-sheet -o OUT.ppm [--columns N] [--tile PIXELS] FILE...
 *
 * A picture that is larger than a tile is made smaller by averaging, so that thin defects fade but do not vanish; one
 * that is smaller stays as it is, in the middle. The lettering is a 5x7 matrix font of capitals, digits and a few
 * signs, all that scene names need: drawn for this file, so that the sheet needs no font library.
 */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tools/picture/picture.h"

enum { GLYPH_WIDTH = 5, GLYPH_HEIGHT = 7, LETTER_SCALE = 2, LETTER_STEP = (GLYPH_WIDTH + 1) * LETTER_SCALE };
enum { GAP_PX = 12, LABEL_PX = GLYPH_HEIGHT * LETTER_SCALE + 8 };
enum { DEFAULT_TILE_PX = 320, MAX_TILE_PX = 2048, MAX_COLUMNS = 64, MESSAGE_BYTES = 512 };

static const uint8_t paper[3] = {38, 38, 42}, ink[3] = {225, 225, 225};

/* Rows from the top; bit 4 is the left column. */
static const struct {
    char letter;
    uint8_t rows[GLYPH_HEIGHT];
} font[] = {
    {'A', {0x0E, 0x11, 0x11, 0x1F, 0x11, 0x11, 0x11}}, {'B', {0x1E, 0x11, 0x11, 0x1E, 0x11, 0x11, 0x1E}},
    {'C', {0x0E, 0x11, 0x10, 0x10, 0x10, 0x11, 0x0E}}, {'D', {0x1E, 0x11, 0x11, 0x11, 0x11, 0x11, 0x1E}},
    {'E', {0x1F, 0x10, 0x10, 0x1E, 0x10, 0x10, 0x1F}}, {'F', {0x1F, 0x10, 0x10, 0x1E, 0x10, 0x10, 0x10}},
    {'G', {0x0E, 0x11, 0x10, 0x17, 0x11, 0x11, 0x0F}}, {'H', {0x11, 0x11, 0x11, 0x1F, 0x11, 0x11, 0x11}},
    {'I', {0x0E, 0x04, 0x04, 0x04, 0x04, 0x04, 0x0E}}, {'J', {0x07, 0x02, 0x02, 0x02, 0x02, 0x12, 0x0C}},
    {'K', {0x11, 0x12, 0x14, 0x18, 0x14, 0x12, 0x11}}, {'L', {0x10, 0x10, 0x10, 0x10, 0x10, 0x10, 0x1F}},
    {'M', {0x11, 0x1B, 0x15, 0x15, 0x11, 0x11, 0x11}}, {'N', {0x11, 0x19, 0x15, 0x13, 0x11, 0x11, 0x11}},
    {'O', {0x0E, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0E}}, {'P', {0x1E, 0x11, 0x11, 0x1E, 0x10, 0x10, 0x10}},
    {'Q', {0x0E, 0x11, 0x11, 0x11, 0x15, 0x12, 0x0D}}, {'R', {0x1E, 0x11, 0x11, 0x1E, 0x14, 0x12, 0x11}},
    {'S', {0x0F, 0x10, 0x10, 0x0E, 0x01, 0x01, 0x1E}}, {'T', {0x1F, 0x04, 0x04, 0x04, 0x04, 0x04, 0x04}},
    {'U', {0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x0E}}, {'V', {0x11, 0x11, 0x11, 0x11, 0x11, 0x0A, 0x04}},
    {'W', {0x11, 0x11, 0x11, 0x15, 0x15, 0x1B, 0x11}}, {'X', {0x11, 0x11, 0x0A, 0x04, 0x0A, 0x11, 0x11}},
    {'Y', {0x11, 0x11, 0x0A, 0x04, 0x04, 0x04, 0x04}}, {'Z', {0x1F, 0x01, 0x02, 0x04, 0x08, 0x10, 0x1F}},
    {'0', {0x0E, 0x11, 0x13, 0x15, 0x19, 0x11, 0x0E}}, {'1', {0x04, 0x0C, 0x04, 0x04, 0x04, 0x04, 0x0E}},
    {'2', {0x0E, 0x11, 0x01, 0x06, 0x08, 0x10, 0x1F}}, {'3', {0x1F, 0x02, 0x04, 0x02, 0x01, 0x11, 0x0E}},
    {'4', {0x02, 0x06, 0x0A, 0x12, 0x1F, 0x02, 0x02}}, {'5', {0x1F, 0x10, 0x1E, 0x01, 0x01, 0x11, 0x0E}},
    {'6', {0x06, 0x08, 0x10, 0x1E, 0x11, 0x11, 0x0E}}, {'7', {0x1F, 0x01, 0x02, 0x04, 0x08, 0x08, 0x08}},
    {'8', {0x0E, 0x11, 0x11, 0x0E, 0x11, 0x11, 0x0E}}, {'9', {0x0E, 0x11, 0x11, 0x0F, 0x01, 0x02, 0x0C}},
    {'-', {0x00, 0x00, 0x00, 0x0E, 0x00, 0x00, 0x00}}, {'_', {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x1F}},
    {'.', {0x00, 0x00, 0x00, 0x00, 0x00, 0x0C, 0x0C}}, {'+', {0x00, 0x04, 0x04, 0x1F, 0x04, 0x04, 0x00}},
    {' ', {0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00}}, {'?', {0x0E, 0x11, 0x01, 0x02, 0x04, 0x00, 0x04}},
};
enum { GLYPH_COUNT = sizeof font / sizeof font[0] };

static void set_pixel(picture *sheet, int x, int y, const uint8_t rgb[3])
{
    if (x >= 0 && y >= 0 && x < sheet->width && y < sheet->height) {
        memcpy(sheet->rgb + ((size_t)y * (size_t)sheet->width + (size_t)x) * 3, rgb, 3);
    }
}

/* A letter without glyph is drawn as the last one, the question mark. */
static const uint8_t *glyph_of(char letter)
{
    const char capital = (char)toupper((unsigned char)letter);
    int i = 0;
    while (i < GLYPH_COUNT - 1 && font[i].letter != capital) {
        i++;
    }
    return font[i].rows;
}

static void draw_letter(picture *sheet, char letter, int left, int top)
{
    const uint8_t *rows = glyph_of(letter);
    for (int y = 0; y < GLYPH_HEIGHT * LETTER_SCALE; y++) {
        for (int x = 0; x < GLYPH_WIDTH * LETTER_SCALE; x++) {
            if ((rows[y / LETTER_SCALE] >> (GLYPH_WIDTH - 1 - x / LETTER_SCALE) & 1) != 0) {
                set_pixel(sheet, left + x, top + y, ink);
            }
        }
    }
}

/* The file's name without folder and ending, in the middle of the tile; cut where the tile ends. */
static void draw_label(picture *sheet, const char *path, int left, int top, int width)
{
    const char *slash = strrchr(path, '/');
    const char *name = slash == NULL ? path : slash + 1;
    const char *dot = strrchr(name, '.');
    int length = (int)(dot == NULL || dot == name ? strlen(name) : (size_t)(dot - name));
    const int most = width / LETTER_STEP;
    length = length < most ? length : most;
    left += (width - length * LETTER_STEP + LETTER_SCALE) / 2;
    for (int i = 0; i < length; i++) {
        draw_letter(sheet, name[i], left + i * LETTER_STEP, top);
    }
}

/* The mean colour of a rectangle, which is within the picture and not empty. */
static void mean_colour(const picture *from, int x0, int x1, int y0, int y1, uint8_t rgb[3])
{
    unsigned long sum[3] = {0, 0, 0};
    const unsigned long count = (unsigned long)(x1 - x0) * (unsigned long)(y1 - y0);
    for (int y = y0; y < y1; y++) {
        const uint8_t *pixel = from->rgb + ((size_t)y * (size_t)from->width + (size_t)x0) * 3;
        for (int x = x0; x < x1; x++, pixel += 3) {
            for (int k = 0; k < 3; k++) {
                sum[k] += pixel[k];
            }
        }
    }
    for (int k = 0; k < 3; k++) {
        rgb[k] = (uint8_t)((sum[k] + count / 2) / count);
    }
}

/* A side of a picture as it is on the sheet: the longer one is at most tile_px, and no picture grows. */
static int shown_px(const picture *p, int side_px, int tile_px)
{
    const int longer = p->width > p->height ? p->width : p->height;
    /* side <= PICTURE_MAX_SIZE_PX = 2^14, tile <= 2^11: the product stays below 2^26 */
    const int shown = longer <= tile_px ? side_px : side_px * tile_px / longer;
    return shown > 0 ? shown : 1;
}

/* Draws a picture in the middle of a place of tile_px x row_px. */
static void draw_tile(picture *sheet, const picture *from, int left, int top, int tile_px, int row_px)
{
    const int width = shown_px(from, from->width, tile_px), height = shown_px(from, from->height, tile_px);
    left += (tile_px - width) / 2;
    top += (row_px - height) / 2;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            uint8_t rgb[3];
            mean_colour(from, x * from->width / width, (x + 1) * from->width / width, y * from->height / height,
                        (y + 1) * from->height / height, rgb);
            set_pixel(sheet, left + x, top + y, rgb);
        }
    }
}

static int usage(const char *wrong)
{
    fprintf(stderr,
            "contact-sheet: %s\n"
            "usage: contact-sheet -o OUT.ppm [--columns 1..%d] [--tile 16..%d] FILE...\n",
            wrong, MAX_COLUMNS, MAX_TILE_PX);
    return 2;
}

static int parse_number(const char *text, int least, int most, int *out)
{
    char *end;
    const long value = strtol(text, &end, 10);
    if (end == text || *end != '\0' || value < least || value > most) {
        return -1;
    }
    *out = (int)value;
    return 0;
}

/* The height of the highest picture from `first` on, at most `columns` of them. */
static int row_height(const picture *tiles, int count, int first, int columns, int tile_px)
{
    int most = 0;
    for (int i = first; i < count && i < first + columns; i++) {
        const int height = shown_px(&tiles[i], tiles[i].height, tile_px);
        most = height > most ? height : most;
    }
    return most;
}

static int draw_sheet(const char *output, char **files, const picture *tiles, int count, int columns, int tile_px,
                      char *error, size_t error_bytes)
{
    picture sheet = {0};
    int height = GAP_PX, top = GAP_PX;

    for (int i = 0; i < count; i += columns) {
        height += row_height(tiles, count, i, columns, tile_px) + LABEL_PX + GAP_PX;
    }
    if (picture_create(&sheet, columns * (tile_px + GAP_PX) + GAP_PX, height, error, error_bytes) != 0) {
        return -1;
    }
    for (int y = 0; y < sheet.height; y++) {
        for (int x = 0; x < sheet.width; x++) {
            set_pixel(&sheet, x, y, paper);
        }
    }
    for (int i = 0; i < count; i += columns) {
        const int row_px = row_height(tiles, count, i, columns, tile_px);
        for (int k = 0; k < columns && i + k < count; k++) {
            const int left = GAP_PX + k * (tile_px + GAP_PX);
            draw_tile(&sheet, &tiles[i + k], left, top, tile_px, row_px);
            draw_label(&sheet, files[i + k], left, top + row_px + 6, tile_px);
        }
        top += row_px + LABEL_PX + GAP_PX;
    }
    const int result = picture_write(output, &sheet, error, error_bytes);
    picture_free(&sheet);
    return result;
}

/* columns 0: as many as make the sheet about a half wider than high. */
static int make_sheet(const char *output, char **files, int count, int columns, int tile_px, char *error,
                      size_t error_bytes)
{
    picture *tiles = calloc((size_t)count, sizeof *tiles);
    int result = 0;

    if (tiles == NULL) {
        (void)snprintf(error, error_bytes, "out of memory");
        return -1;
    }
    if (columns == 0) {
        columns = 1;
        while (columns * columns * 2 < count * 3 && columns < MAX_COLUMNS) {
            columns++;
        }
    }
    columns = columns < count ? columns : count;
    for (int i = 0; result == 0 && i < count; i++) {
        result = picture_read(files[i], &tiles[i], error, error_bytes);
    }
    if (result == 0) {
        result = draw_sheet(output, files, tiles, count, columns, tile_px, error, error_bytes);
    }
    for (int i = 0; i < count; i++) {
        picture_free(&tiles[i]);
    }
    free(tiles);
    return result;
}

int main(int argc, char **argv)
{
    const char *output = NULL;
    int columns = 0, tile_px = DEFAULT_TILE_PX, i = 1;

    for (; i < argc && argv[i][0] == '-'; i += 2) {
        if (i + 1 == argc) {
            return usage("expected a value after the last option");
        }
        if (strcmp(argv[i], "-o") == 0) {
            output = argv[i + 1];
        } else if (strcmp(argv[i], "--columns") == 0) {
            if (parse_number(argv[i + 1], 1, MAX_COLUMNS, &columns) != 0) {
                return usage("--columns: expected a whole number");
            }
        } else if (strcmp(argv[i], "--tile") == 0) {
            if (parse_number(argv[i + 1], 16, MAX_TILE_PX, &tile_px) != 0) {
                return usage("--tile: expected a whole number");
            }
        } else {
            return usage("unknown option");
        }
    }
    if (output == NULL || i >= argc) {
        return usage("expected -o OUT.ppm and at least one picture");
    }

    char error[MESSAGE_BYTES] = "";
    if (make_sheet(output, argv + i, argc - i, columns, tile_px, error, sizeof error) != 0) {
        fprintf(stderr, "contact-sheet: %s\n", error);
        return 1;
    }
    return 0;
}
