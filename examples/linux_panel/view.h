/* SPDX-License-Identifier: MIT */
/*
 * What is drawn: a built-in scene, turned, within a tolerance.
 */
#ifndef EXAMPLES_LINUX_PANEL_VIEW_H
#define EXAMPLES_LINUX_PANEL_VIEW_H

#include <stddef.h>
#include <stdint.h>

#include <glint/glint.h>

#include "examples/scenes/scenes.h"

#include "failure.h"

typedef struct view {
    const demo_scene *demo;
    uint16_t turn16;   /* of the objects about the vertical, 1/65536 turn */
    uint8_t tolerance; /* 1/16 code; 0: none, every triangle exact */
    glint_object *objects;
    void *memory;
    size_t memory_bytes;
} view;

/* Takes the memory that drawing to this display can make use of. 0, or -1 and why. */
int view_open(view *v, const demo_scene *demo, uint8_t tolerance, const glint_display *display, failure *f);
void view_close(view *v); /* zeroed is fine */

/* The next of the tolerances that a button switches through: coarser ones, then exact, then from 1 code again. */
void view_switch_tolerance(view *v);

/* Draws to the display. 0, or what its flush function returned; or, -1 and why. */
int view_draw(view *v, const glint_display *display, glint_report *report, failure *f);

#endif
