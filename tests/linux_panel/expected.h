/* SPDX-License-Identifier: MIT */
/*
 * What a panel should show: drawn by the library as one frame, without bands, threads or devices.
 */
#ifndef TESTS_LINUX_PANEL_EXPECTED_H
#define TESTS_LINUX_PANEL_EXPECTED_H

#include <stdint.h>

typedef struct expected_picture {
    const char *scene;
    unsigned width_px, height_px; /* of the glass as mounted */
    unsigned quarter_turns;       /* of the picture on it, clockwise */
    uint16_t turn16;              /* of the model */
    uint8_t tolerance;
} expected_picture;

/* RGB888 as it lies on the glass. Valid until the next call. */
const uint8_t *expected_on_glass(const expected_picture *e);

#endif
