/* SPDX-License-Identifier: MIT */
/*
 * The lines of the self-test's report, without stdio: selftest.h has their form.
 */
#include "tests/target/selftest.h"

#include "tests/target/platform.h"

#define WORD_BYTES 80

/* Text goes out in pieces: a row of pixels would make a buffer of its own on a processor with 16 KB of RAM. */
static char piece[WORD_BYTES];
static uint8_t length;

static void flush(void)
{
    piece[length] = '\0';
    platform_write(piece);
    length = 0;
}

static void put(char c)
{
    if (length == WORD_BYTES - 1) {
        flush();
    }
    piece[length++] = c;
}

static void put_text(const char *text)
{
    while (*text) {
        put(*text++);
    }
}

void report_begin(const char *kind)
{
    put_text(kind);
}

void report_word(const char *text)
{
    put(' ');
    put_text(text);
}

void report_decimal(uint32_t value)
{
    char digits[11];
    uint8_t at = sizeof digits;
    digits[--at] = '\0';
    do {
        digits[--at] = (char)('0' + value % 10);
        value /= 10;
    } while (value);
    report_word(digits + at);
}

static void put_hex(uint64_t value, int digits)
{
    while (digits-- > 0) {
        put("0123456789abcdef"[(value >> (4 * digits)) & 15]);
    }
}

void report_hex(uint64_t value, int digits)
{
    put(' ');
    put_hex(value, digits);
}

void report_bytes(const uint8_t *bytes, uint16_t count)
{
    put(' ');
    while (count--) {
        put_hex(*bytes++, 2);
    }
}

void report_end(void)
{
    put('\n');
    flush();
}

uint64_t hash_bytes(uint64_t hash, uint64_t value, int bytes)
{
    while (bytes-- > 0) {
        hash = (hash ^ (value & 0xff)) * UINT64_C(0x100000001b3);
        value >>= 8;
    }
    return hash;
}
