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

uint16_t *glint_depth_write(uint16_t *at, uint16_t *end, uint32_t depth_q30, uint32_t step)
{
    /* four at a time: most pixels pass, and small processors spend more on the loop than on the test */
    while (end - at >= 4) {
        if (!pass(&at[0], depth_q30)) {
            return at;
        }
        depth_q30 += step;
        if (!pass(&at[1], depth_q30)) {
            return at + 1;
        }
        depth_q30 += step;
        if (!pass(&at[2], depth_q30)) {
            return at + 2;
        }
        depth_q30 += step;
        if (!pass(&at[3], depth_q30)) {
            return at + 3;
        }
        depth_q30 += step;
        at += 4;
    }
    while (at != end && pass(at, depth_q30)) {
        depth_q30 += step;
        at++;
    }
    return at;
}

uint16_t *glint_depth_skip(uint16_t *at, uint16_t *end, uint32_t depth_q30, uint32_t step)
{
    while (at != end && depth_q30 >> GLINT_DEPTH_SHIFT <= *at) {
        GLINT_TRACE("interpolated depth q30", depth_q30);
        depth_q30 += step;
        at++;
    }
    return at;
}
