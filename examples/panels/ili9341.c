/* SPDX-License-Identifier: MIT */
/*
 * See ili9341.h. Of what a driver needs the two controllers differ only in their usual glass: commands (those of MIPI
 * DCS), size and orders of the memory, the bits of MADCTL and COLMOD, and the least delays (a reset pulse of 10 us, 5
 * ms or, out of sleep, 120 ms after it, 5 ms after SLPOUT, 120 ms between SLPOUT and SLPIN) are the same in both data
 * sheets. Voltages, frame rate and gamma are left as a reset sets them.
 */
#include "examples/panels/ili9341.h"

static st7789 with_its_glass(const ili9341 *panel)
{
    return (st7789){.port = panel->port,
                    .width_px = panel->width_px,
                    .height_px = panel->height_px,
                    .x_px = panel->x_px,
                    .y_px = panel->y_px,
                    .rotation = panel->rotation,
                    .bgr = !panel->rgb,
                    .not_inverted = !panel->inverted};
}

int ili9341_begin(const ili9341 *panel)
{
    const st7789 same = with_its_glass(panel);
    return st7789_begin(&same);
}

int ili9341_window(const ili9341 *panel, uint16_t x_px, uint16_t y_px, uint16_t width_px, uint16_t height_px)
{
    const st7789 same = with_its_glass(panel);
    return st7789_window(&same, x_px, y_px, width_px, height_px);
}

int ili9341_show(const ili9341 *panel)
{
    const st7789 same = with_its_glass(panel);
    return st7789_show(&same);
}

int ili9341_end(const ili9341 *panel)
{
    const st7789 same = with_its_glass(panel);
    return st7789_end(&same);
}
