/* SPDX-License-Identifier: MIT */
/*
 * The program pico-uf2: the checksum that the RP2040's boot ROM wants, blocks that its USB drive takes, and what it
 * refuses. examples/pico_st7789/emulate.js takes its files as well, with zlib's CRC.
 */
#include "render_cli.h"

enum {
    BLOCK_BYTES = 512,
    PAYLOAD_BYTES = 256,
    BOOT2_BYTES = 256,
    CHECKSUM_AT = 252,
    IMAGE_BYTES = 700,
    IMAGE_BLOCKS = 3
};

/* Of the first 252 bytes of image(); by zlib: its CRC of the bytes with their bits reversed, inverted and reversed. */
#define CHECKSUM UINT32_C(0x5a98f928)

static uint8_t image[IMAGE_BYTES];

static void fill_image(void)
{
    for (int i = 0; i < IMAGE_BYTES; i++) {
        image[i] = i >= CHECKSUM_AT && i < BOOT2_BYTES ? 0 : (uint8_t)(7 * i + 1);
    }
}

static void write_bytes(const char *name, const uint8_t *bytes, size_t count)
{
    FILE *file = fopen(in_folder(name), "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, count, file), count);
    assert_int_equal(fclose(file), 0);
}

static size_t read_bytes(const char *name, uint8_t *bytes, size_t most)
{
    FILE *file = fopen(in_folder(name), "rb");
    assert_non_null(file);
    const size_t count = fread(bytes, 1, most, file);
    assert_int_equal(fclose(file), 0);
    return count;
}

static uint32_t word_at(const uint8_t *bytes)
{
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

static void packs_blocks_with_the_checksum(void **state)
{
    (void)state;
    uint8_t uf2[(IMAGE_BLOCKS + 1) * BLOCK_BYTES], bin[IMAGE_BYTES * 2];
    fill_image();
    write_bytes("image.bin", image, sizeof image);
    assert_good(RUN(in_folder("image.bin"), "-o", in_folder("out.uf2"), "--bin", in_folder("out.bin")));

    assert_int_equal(read_bytes("out.bin", bin, sizeof bin), IMAGE_BLOCKS * PAYLOAD_BYTES);
    assert_memory_equal(bin, image, CHECKSUM_AT);
    assert_int_equal(word_at(bin + CHECKSUM_AT), CHECKSUM);
    assert_memory_equal(bin + BOOT2_BYTES, image + BOOT2_BYTES, IMAGE_BYTES - BOOT2_BYTES);
    for (int i = IMAGE_BYTES; i < IMAGE_BLOCKS * PAYLOAD_BYTES; i++) {
        assert_int_equal(bin[i], 0);
    }

    assert_int_equal(read_bytes("out.uf2", uf2, sizeof uf2), IMAGE_BLOCKS * BLOCK_BYTES);
    for (uint32_t i = 0; i < IMAGE_BLOCKS; i++) {
        const uint8_t *block = uf2 + i * BLOCK_BYTES;
        assert_memory_equal(block, "UF2\n", 4);
        assert_int_equal(word_at(block + 4), 0x9e5d5157);
        assert_int_equal(word_at(block + 8), 0x2000);
        assert_int_equal(word_at(block + 12), 0x10000000 + i * PAYLOAD_BYTES);
        assert_int_equal(word_at(block + 16), PAYLOAD_BYTES);
        assert_int_equal(word_at(block + 20), i);
        assert_int_equal(word_at(block + 24), IMAGE_BLOCKS);
        assert_int_equal(word_at(block + 28), 0xe48bff56);
        assert_memory_equal(block + 32, bin + i * PAYLOAD_BYTES, PAYLOAD_BYTES);
        for (int k = 32 + PAYLOAD_BYTES; k < BLOCK_BYTES - 4; k++) {
            assert_int_equal(block[k], 0);
        }
        assert_int_equal(word_at(block + BLOCK_BYTES - 4), 0x0ab16f30);
    }
}

static void refuses_what_is_no_image(void **state)
{
    (void)state;
    fill_image();
    write_bytes("short.bin", image, BOOT2_BYTES);
    assert_refused(RUN(in_folder("short.bin"), "-o", in_folder("a.uf2")), 1, "no image of an RP2040's flash");
    image[CHECKSUM_AT + 2] = 1;
    write_bytes("sealed.bin", image, sizeof image);
    assert_refused(RUN(in_folder("sealed.bin"), "-o", in_folder("a.uf2")), 1, "bytes 252..255 are to be zero");
    write_bytes("empty.bin", image, 0);
    assert_refused(RUN(in_folder("empty.bin"), "-o", in_folder("a.uf2")), 1, "no image of an RP2040's flash");
    assert_refused(RUN(in_folder("not-there.bin"), "-o", in_folder("a.uf2")), 1, "can't be read");
    assert_nothing_at("a.uf2");
}

static void refuses_an_image_beyond_the_flash(void **state)
{
    (void)state;
    enum { MOST = 16 * 1024 * 1024 };
    uint8_t *large = calloc(1, MOST + 1);
    assert_non_null(large);
    write_bytes("large.bin", large, MOST + 1);
    assert_refused(RUN(in_folder("large.bin"), "-o", in_folder("b.uf2")), 1, "longer than the 16 MB");
    assert_nothing_at("b.uf2");
    write_bytes("large.bin", large, MOST);
    assert_good(RUN(in_folder("large.bin"), "-o", in_folder("b.uf2")));
    free(large);
}

static void refuses_where_it_cannot_write(void **state)
{
    (void)state;
    fill_image();
    write_bytes("image.bin", image, sizeof image);
    assert_refused(RUN(in_folder("image.bin"), "-o", in_folder("no/such/folder.uf2")), 1, "can't be written");
    assert_refused(RUN(in_folder("image.bin"), "-o", "/dev/full"), 1, "/dev/full: can't be written");
}

static void tells_the_usage(void **state)
{
    (void)state;
    assert_refused(RUN("-o", "x.uf2"), 2, "usage: pico-uf2");
    assert_refused(RUN("image.bin"), 2, "usage: pico-uf2");
    assert_refused(RUN("image.bin", "-o"), 2, "usage: pico-uf2");
    assert_refused(RUN("image.bin", "another.bin", "-o", "x.uf2"), 2, "usage: pico-uf2");
    assert_refused(RUN("image.bin", "--wrong", "-o", "x.uf2"), 2, "usage: pico-uf2");
}

/* render_cli.h runs the program that GLINT_RENDER names. */
static int begin(void **state)
{
    (void)state;
    char program[PATH_BYTES];
    const char *build = getenv("GLINT_BUILD");
    (void)snprintf(program, sizeof program, "%s/pico-uf2", build != NULL ? build : "build");
    return mkdtemp(folder) == NULL || setenv("GLINT_RENDER", program, 1) != 0;
}

static int end(void **state)
{
    static const char *const names[] = {"image.bin", "out.uf2",   "out.bin", "short.bin", "sealed.bin",
                                        "empty.bin", "large.bin", "b.uf2",   "stdout",    "stderr"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        (void)remove(in_folder(names[i]));
    }
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(packs_blocks_with_the_checksum),
        cmocka_unit_test(refuses_what_is_no_image),
        cmocka_unit_test(refuses_an_image_beyond_the_flash),
        cmocka_unit_test(refuses_where_it_cannot_write),
        cmocka_unit_test(tells_the_usage),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
