/* SPDX-License-Identifier: MIT */
#include "raster/depth.h"

/* Functions, not inline: what they carry just fits the eight registers of a small processor. */

static inline bool pass(uint16_t *pixel, uint32_t depth_q30)
{
    const uint32_t nearness = depth_q30 >> GLINT_DEPTH_SHIFT;
    GLINT_TRACE("interpolated depth q30", depth_q30);
    if (nearness <= *pixel) {
        return false;
    }
    *pixel = (uint16_t)nearness;
    return true;
}

uint32_t glint_depth_write(uint16_t *at, uint32_t count, uint32_t depth_q30, uint32_t step)
{
    uint16_t *const first = at;
    const uint16_t *const end = at + count, *const fours = at + (count & 3);
    /* Most pixels pass. What makes the rest a number of fours comes first, then four at a time: small processors spend
     * more on the loop than on the test. */
    for (; at != fours; at++) {
        if (!pass(at, depth_q30)) {
            return (uint32_t)(at - first);
        }
        depth_q30 += step;
    }
    while (at != end) {
        if (!pass(&at[0], depth_q30)) {
            return (uint32_t)(at - first);
        }
        depth_q30 += step;
        if (!pass(&at[1], depth_q30)) {
            return (uint32_t)(at - first) + 1;
        }
        depth_q30 += step;
        if (!pass(&at[2], depth_q30)) {
            return (uint32_t)(at - first) + 2;
        }
        depth_q30 += step;
        if (!pass(&at[3], depth_q30)) {
            return (uint32_t)(at - first) + 3;
        }
        depth_q30 += step;
        at += 4;
    }
    return count;
}

uint32_t glint_depth_skip(const uint16_t *at, uint32_t count, uint32_t depth_q30, uint32_t step)
{
    uint32_t left = count;
    while (left > 0 && depth_q30 >> GLINT_DEPTH_SHIFT <= *at) {
        GLINT_TRACE("interpolated depth q30", depth_q30);
        depth_q30 += step;
        at++;
        left--;
    }
    return count - left;
}
