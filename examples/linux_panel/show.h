/* SPDX-License-Identifier: MIT */
/*
 * Brings frames to the screen: bands are drawn into two buffers, the second thread sends one while the next is drawn,
 * and rows that the panel holds already are left out.
 */
#ifndef EXAMPLES_LINUX_PANEL_SHOW_H
#define EXAMPLES_LINUX_PANEL_SHOW_H

#include <stdbool.h>
#include <stdint.h>

#include <glint/display.h>

#include "examples/render/panel.h"
#include "tools/picture/picture.h"

#include "changes.h"
#include "failure.h"
#include "screen.h"
#include "sender.h"
#include "view.h"

/* What a frame took. */
typedef struct show_frame {
    uint64_t draw_ns, send_ns, whole_ns; /* drawing (without waiting for the panel), sending, both overlapped */
    unsigned bands, bands_sent;
    uint32_t bytes_sent;
} show_frame;

typedef struct show {
    screen *screen;
    const char *dump; /* NULL, or the file that shows what the panel should show */
    glint_display display;
    glint_transfers transfers;
    sender sender;
    bool sending; /* the sender's thread runs */
    changes changes;
    picture picture; /* for the dump */
    panel mirror;
    view view;
    uint64_t waited_ns;
    show_frame frame;
    failure *failure; /* of the frame under way */
} show;

enum { SHOW_STOPPED = 1 }; /* a signal asked for the end */

/* The calls return 0, or -1 and why; show_draw() also SHOW_STOPPED. `width_px`, `height_px`: of the picture. */
int show_open(show *s, screen *on, const demo_scene *demo, uint8_t tolerance, uint16_t width_px, uint16_t height_px,
              const char *dump, failure *f);
int show_draw(show *s, show_frame *took, failure *f);

/* Waits for what is being sent, then frees all. Zeroed is fine. */
void show_close(show *s);

#endif
