/* SPDX-License-Identifier: MIT */
/*
 * memset and memcpy of a program of little flash: 300 bytes shorter than a C library's, which are quick.
 */
#include <stddef.h>
#include <stdint.h>

void *memset(void *to, int value, size_t count)
{
    uint8_t *byte = to;
    while (count-- > 0) {
        *byte++ = (uint8_t)value;
    }
    return to;
}

void *memcpy(void *restrict to, const void *restrict from, size_t count)
{
    uint8_t *byte = to;
    const uint8_t *next = from;
    while (count-- > 0) {
        *byte++ = *next++;
    }
    return to;
}
