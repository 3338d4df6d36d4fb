/* SPDX-License-Identifier: MIT */
/*
 * A fuzzer's bytes as a source of numbers, and the checks that end the program.
 *
 * Each number takes the next bytes. When they run out, a generator goes on that is seeded by the first eight: so a
 * short input is a whole scene too, and a mutation in the middle leaves what comes after as it was.
 */
#ifndef GLINT_TESTS_FUZZ_BYTES_H
#define GLINT_TESTS_FUZZ_BYTES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* Both libFuzzer and the shell see an abort; an assertion could be compiled out. */
#define FUZZ_CHECK(condition, ...)                                                                                     \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            (void)fprintf(stderr, "%s:%d: not so: %s: ", __FILE__, __LINE__, #condition);                              \
            (void)fprintf(stderr, __VA_ARGS__);                                                                        \
            (void)fputc('\n', stderr);                                                                                 \
            abort();                                                                                                   \
        }                                                                                                              \
    } while (0)

typedef struct bytes {
    const uint8_t *next;
    size_t left;
    uint64_t state; /* of the generator: xorshift64*, S. Vigna, "An experimental exploration", 2016 */
} bytes;

static inline bytes bytes_from(const uint8_t *data, size_t size)
{
    bytes b = {data, size, 0x9e3779b97f4a7c15u};
    for (size_t i = 0; i < 8 && i < size; i++) {
        b.state = (b.state ^ data[i]) * 0x100000001b3u;
    }
    b.state = b.state ? b.state : 1;
    return b;
}

static inline uint8_t take_u8(bytes *b)
{
    if (b->left > 0) {
        b->left--;
        return *b->next++;
    }
    b->state ^= b->state >> 12;
    b->state ^= b->state << 25;
    b->state ^= b->state >> 27;
    return (uint8_t)((b->state * 2685821657736338717u) >> 56);
}

static inline uint16_t take_u16(bytes *b)
{
    const uint16_t low = take_u8(b);
    return (uint16_t)(low | take_u8(b) << 8);
}

static inline uint32_t take_u32(bytes *b)
{
    const uint32_t low = take_u16(b);
    return low | (uint32_t)take_u16(b) << 16;
}

static inline int16_t take_s16(bytes *b)
{
    return (int16_t)take_u16(b);
}

/* The same bytes from the last to the first, MOST_FROM_END at most, so that two readers of one input hardly meet.
 * `reversed` is theirs. */
enum { MOST_FROM_END = 256 };

static inline bytes bytes_from_end(const uint8_t *data, size_t size, uint8_t reversed[MOST_FROM_END])
{
    const size_t count = size < MOST_FROM_END ? size : MOST_FROM_END;
    for (size_t i = 0; i < count; i++) {
        reversed[i] = data[size - 1 - i];
    }
    return bytes_from(reversed, count);
}

/* low..high, both included; low where high is less. */
static inline int32_t take_between(bytes *b, int32_t low, int32_t high)
{
    if (high < low) {
        return low;
    }
    const uint64_t count = (uint64_t)((int64_t)high - low) + 1;
    const uint64_t drawn = count <= 256 ? take_u8(b) : count <= 65536 ? take_u16(b) : take_u32(b);
    return (int32_t)(low + (int64_t)(drawn % count));
}

/* True in one of `count` cases. */
static inline bool take_rarely(bytes *b, int count)
{
    return take_between(b, 0, count - 1) == count - 1;
}

/*
 * A number of any size up to `most`, small ones and the ends as likely as large ones. One in sixteen is just beyond,
 * where `wild` allows it.
 */
static inline int32_t take_any_size(bytes *b, int32_t most, bool wild)
{
    static const int32_t beyond[] = {INT32_MIN, INT32_MAX, INT32_MIN + 1};
    const uint8_t kind = take_u8(b);
    const int32_t sign = kind & 1 ? -1 : 1;
    if (kind >= 240 && wild) {
        return kind & 2 ? beyond[kind % 3] : sign * (most + 1);
    }
    if (kind >= 224) {
        return sign * (most - (kind >> 2 & 1));
    }
    if (kind >= 208) {
        return 0;
    }
    const int32_t value = (int32_t)(take_u32(b) >> 1) >> (kind >> 1 & 31);
    return sign * (value > most ? most - value % (most / 2 + 1) : value);
}

#endif
