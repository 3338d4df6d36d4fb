/* SPDX-License-Identifier: MIT */
/*
 * What a board draws, apart from how it reaches its panel: the same source is compiled into the firmware and into a
 * program of the host, which draws the picture that the panel has to show.
 */
#ifndef EXAMPLES_FIRMWARE_PICTURE_H
#define EXAMPLES_FIRMWARE_PICTURE_H

#include <stddef.h>
#include <stdint.h>

#include <glint/glint.h>

/* Frames until the animation begins again. */
extern const uint16_t picture_frames;

/* The board's display, without flush, context and transfers. */
extern const glint_display picture_display;

/* Draws frame 0 .. picture_frames - 1. Returns 0, an error of the library, or that of display->flush. */
int picture_draw(uint16_t frame, const glint_display *display, void *memory, size_t memory_bytes, glint_report *report);

#endif
