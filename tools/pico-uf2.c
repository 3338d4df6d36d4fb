/* SPDX-License-Identifier: MIT */
/*
 * pico-uf2: makes the image of an RP2040's flash ready to boot, and packs it for the board's USB drive.
 *
 *     pico-uf2 IMAGE.bin -o OUT.uf2 [--bin SEALED.bin]
 *
 * IMAGE.bin is the flash from 0x10000000 on; its first 256 bytes are the second stage of the boot, whose last four are
 * left zero for the checksum that goes there. SEALED.bin is the same image with it, for a debug probe.
 *
 * The checksum: RP2040 data sheet 2.8.1.3.1. The file: the UF2 specification (Microsoft), one block of 512 bytes for
 * 256 bytes of flash; the boot ROM takes the drive's blocks in any order and starts the program when it has all.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BOOT2_BYTES = 256, CHECKSUM_AT = BOOT2_BYTES - 4, PAYLOAD_BYTES = 256, BLOCK_BYTES = 512 };

#define FLASH_START UINT32_C(0x10000000)
#define MOST_IMAGE_BYTES (16 * 1024 * 1024) /* what the RP2040 can address */

#define CRC_POLYNOMIAL UINT32_C(0x04c11db7)
#define CRC_START UINT32_C(0xffffffff)

#define UF2_MAGIC_FIRST UINT32_C(0x0a324655)
#define UF2_MAGIC_SECOND UINT32_C(0x9e5d5157)
#define UF2_MAGIC_LAST UINT32_C(0x0ab16f30)
#define UF2_FLAG_FAMILY UINT32_C(0x00002000)
#define UF2_FAMILY_RP2040 UINT32_C(0xe48bff56)

__attribute__((noreturn)) static void fail(const char *what, const char *which)
{
    (void)fprintf(stderr, "pico-uf2: %s%s%s\n", which ? which : "", which ? ": " : "", what);
    exit(1);
}

/* CRC-32 with its most significant bit first, neither reflected nor inverted at the end. */
static uint32_t boot_checksum(const uint8_t *bytes, size_t count)
{
    uint32_t crc = CRC_START;
    for (size_t i = 0; i < count; i++) {
        crc ^= (uint32_t)bytes[i] << 24;
        for (int bit = 0; bit < 8; bit++) {
            crc = crc & 0x80000000u ? crc << 1 ^ CRC_POLYNOMIAL : crc << 1;
        }
    }
    return crc;
}

static void put32(uint8_t *bytes, uint32_t value)
{
    for (int i = 0; i < 4; i++) {
        bytes[i] = (uint8_t)(value >> 8 * i);
    }
}

/* The image with zeros up to a whole number of payloads; *blocks counts them. */
static uint8_t *read_image(const char *path, uint32_t *blocks)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        fail("can't be read", path);
    }
    uint8_t *image = calloc(1, MOST_IMAGE_BYTES);
    if (image == NULL) {
        fail("no memory", NULL);
    }
    const size_t count = fread(image, 1, MOST_IMAGE_BYTES, file);
    if (ferror(file)) {
        fail("can't be read", path);
    }
    if (count == MOST_IMAGE_BYTES && fgetc(file) != EOF) {
        fail("longer than the 16 MB of flash that an RP2040 has at most", path);
    }
    (void)fclose(file);
    static const uint8_t zeros[4];
    if (count <= BOOT2_BYTES || memcmp(image + CHECKSUM_AT, zeros, sizeof zeros) != 0) {
        fail("no image of an RP2040's flash: bytes 252..255 are to be zero, and the program behind them", path);
    }
    *blocks = (uint32_t)((count + PAYLOAD_BYTES - 1) / PAYLOAD_BYTES);
    return image;
}

static void write_or_fail(FILE *file, const uint8_t *bytes, size_t count, const char *path)
{
    if (fwrite(bytes, 1, count, file) != count) {
        fail("can't be written", path);
    }
}

static FILE *open_output(const char *path)
{
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        fail("can't be written", path);
    }
    return file;
}

static void close_output(FILE *file, const char *path)
{
    if (fclose(file) != 0) {
        fail("can't be written", path);
    }
}

static void write_uf2(const char *path, const uint8_t *image, uint32_t blocks)
{
    FILE *file = open_output(path);
    for (uint32_t i = 0; i < blocks; i++) {
        uint8_t block[BLOCK_BYTES] = {0};
        const uint32_t head[] = {
            UF2_MAGIC_FIRST, UF2_MAGIC_SECOND, UF2_FLAG_FAMILY, FLASH_START + i * PAYLOAD_BYTES, PAYLOAD_BYTES, i,
            blocks,          UF2_FAMILY_RP2040};
        for (size_t k = 0; k < sizeof head / sizeof head[0]; k++) {
            put32(block + 4 * k, head[k]);
        }
        memcpy(block + sizeof head, image + (size_t)i * PAYLOAD_BYTES, PAYLOAD_BYTES);
        put32(block + BLOCK_BYTES - 4, UF2_MAGIC_LAST);
        write_or_fail(file, block, sizeof block, path);
    }
    close_output(file, path);
}

static void write_image(const char *path, const uint8_t *image, uint32_t blocks)
{
    FILE *file = open_output(path);
    write_or_fail(file, image, (size_t)blocks * PAYLOAD_BYTES, path);
    close_output(file, path);
}

int main(int count, char **arguments)
{
    const char *input = NULL, *uf2 = NULL, *sealed = NULL;
    for (int i = 1; i < count; i++) {
        const char **option = strcmp(arguments[i], "-o") == 0      ? &uf2
                              : strcmp(arguments[i], "--bin") == 0 ? &sealed
                                                                   : NULL;
        if (option == NULL && arguments[i][0] != '-' && input == NULL) {
            input = arguments[i];
        } else if (option && i + 1 < count) {
            *option = arguments[++i];
        } else {
            input = NULL;
            break;
        }
    }
    if (input == NULL || uf2 == NULL) {
        (void)fprintf(stderr, "usage: pico-uf2 IMAGE.bin -o OUT.uf2 [--bin SEALED.bin]\n");
        return 2;
    }
    uint32_t blocks = 0;
    uint8_t *image = read_image(input, &blocks);
    put32(image + CHECKSUM_AT, boot_checksum(image, CHECKSUM_AT));
    write_uf2(uf2, image, blocks);
    if (sealed) {
        write_image(sealed, image, blocks);
    }
    free(image);
    return 0;
}
