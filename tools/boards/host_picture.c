/* SPDX-License-Identifier: MIT */
/*
 * host-picture FRAME OUT.ppm: what a board's panel has to show, drawn on the host from the board's own picture.c.
 */
#include <stdio.h>
#include <stdlib.h>

#include "examples/firmware/picture.h"
#include "examples/render/panel.h"
#include "tools/picture/picture.h"

/* More than any board has. */
#define MEMORY_WORDS 0x40000

int main(int count, char **words)
{
    static uint32_t memory[MEMORY_WORDS];
    char error[256] = "";
    if (count != 3) {
        (void)fputs("usage: host-picture FRAME OUT.ppm\n", stderr);
        return 2;
    }
    picture out;
    if (picture_create(&out, picture_display.width_px, picture_display.height_px, error, sizeof error)) {
        (void)fprintf(stderr, "host-picture: %s\n", error);
        return 2;
    }
    panel p = {.rgb = out.rgb,
               .width_px = picture_display.width_px,
               .height_px = picture_display.height_px,
               .format = picture_display.format};
    const glint_display display = panel_display(&p, picture_display.band_px, picture_display.dither, 1);
    const uint16_t frame = (uint16_t)(strtoul(words[1], NULL, 10) % picture_frames);
    const int result = picture_draw(frame, &display, memory, sizeof memory, NULL);
    if (result) {
        (void)fprintf(stderr, "host-picture: %s\n", glint_error_text(result));
    } else if (picture_write(words[2], &out, error, sizeof error)) {
        (void)fprintf(stderr, "host-picture: %s\n", error);
    }
    picture_free(&out);
    return result != 0 || error[0] != '\0';
}
