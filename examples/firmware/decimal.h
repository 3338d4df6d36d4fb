/* SPDX-License-Identifier: MIT */
/*
 * A number as decimal text, for processors whose printf is larger than all the rest of the program.
 */
#ifndef EXAMPLES_FIRMWARE_DECIMAL_H
#define EXAMPLES_FIRMWARE_DECIMAL_H

#include <stdint.h>

#define DECIMAL_CHARS 11

/* Writes the digits and a closing 0 to the end of `text`; returns where they begin. */
static inline const char *decimal(uint32_t value, char text[DECIMAL_CHARS])
{
    char *digit = &text[DECIMAL_CHARS - 1];
    *digit = '\0';
    do {
        *--digit = (char)('0' + value % 10);
        value /= 10;
    } while (value > 0);
    return digit;
}

#endif
