/* SPDX-License-Identifier: MIT */
/*
 * NOT LVGL: a stand-in with the few declarations of LVGL 8.3 that the sketch uses, so that it is compiled even where
 * LVGL is not to be had. Nothing links with it.
 */
#ifndef EXAMPLES_LVGL_CANVAS_STAND_IN_LVGL_H
#define EXAMPLES_LVGL_CANVAS_STAND_IN_LVGL_H

#include <stdint.h>

#define LVGL_VERSION_MAJOR 8
#define LV_COLOR_16_SWAP 0

typedef int16_t lv_coord_t;
typedef uint8_t lv_img_cf_t;
typedef struct _lv_obj_t lv_obj_t;
typedef struct _lv_timer_t {
    void *user_data; /* others come before it */
} lv_timer_t;
typedef void (*lv_timer_cb_t)(lv_timer_t *timer);

enum { LV_IMG_CF_TRUE_COLOR = 4 };

lv_obj_t *lv_canvas_create(lv_obj_t *parent);
void lv_canvas_set_buffer(lv_obj_t *canvas, void *buf, lv_coord_t w, lv_coord_t h, lv_img_cf_t cf);
void lv_obj_invalidate(const lv_obj_t *obj);
lv_timer_t *lv_timer_create(lv_timer_cb_t timer_xcb, uint32_t period, void *user_data);

#endif
