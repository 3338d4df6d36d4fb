/* SPDX-License-Identifier: MIT */
/*
 * A widget of LVGL: a canvas in which a teapot turns. Compiled against LVGL 8.3 (LV_COLOR_DEPTH 16) by `make
 * lvgl-check`; what LVGL 9 names otherwise is here by its documentation.
 */
#ifndef EXAMPLES_LVGL_CANVAS_TEAPOT_CANVAS_H
#define EXAMPLES_LVGL_CANVAS_TEAPOT_CANVAS_H

#include <lvgl.h>

#if LVGL_VERSION_MAJOR >= 9
#define TEAPOT_CANVAS_LVGL_FORMAT LV_COLOR_FORMAT_RGB565
#define TEAPOT_CANVAS_OF_TIMER(timer) lv_timer_get_user_data(timer)
#else
#define TEAPOT_CANVAS_LVGL_FORMAT LV_IMG_CF_TRUE_COLOR
#define TEAPOT_CANVAS_OF_TIMER(timer) ((timer)->user_data)
#endif

/* In LVGL 8 the pixels of all pictures are in the display's byte order. */
#if LVGL_VERSION_MAJOR < 9 && LV_COLOR_16_SWAP
#define TEAPOT_CANVAS_FORMAT GLINT_RGB565_SWAPPED
#else
#define TEAPOT_CANVAS_FORMAT GLINT_RGB565
#endif

/* Call it from LVGL's task, as all of LVGL, and once: there is one buffer of pixels. */
lv_obj_t *teapot_canvas_create(lv_obj_t *parent);

#endif
