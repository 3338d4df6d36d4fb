/* SPDX-License-Identifier: MIT */
/*
 * A Phong-lit sphere on a mono OLED, drawn by an 8-bit processor with 16 KB of RAM: its lamp goes round once after
 * reset, and again at each press of the button. Two pins tell what a frame's time is spent on.
 */
#include <avr/sleep.h>

#include "examples/avr_ssd1306/board.h"
#include "examples/avr_ssd1306/oled_port.h"
#include "examples/firmware/picture.h"
#include "examples/panels/ssd1306.h"

/* The library's memory: a band of one page, the sphere's vertices and lists of its triangles, one light. */
#define VERTICES 266
#define TRIANGLES 528
static uint32_t memory[GLINT_MEMORY_WORDS(128, 64, 8, GLINT_MONO_PAGES, 1, VERTICES, TRIANGLES, 1, 1)];

static const ssd1306 panel = {.port = &oled_port};

/* Bands come from the top, so one window serves the frame: each goes on where the one before ended. */
static int send_band(void *context, const glint_band *band)
{
    (void)context;
    int error = 0;
    board_mark(1 << MARK_SENDING);
    if (band->y_px == 0) {
        error = ssd1306_window(&panel, 0, 0, (uint8_t)picture_display.width_px, (uint8_t)picture_display.height_px);
    }
    error = error ? error : oled_port.send_data(oled_port.context, band->pixels, band->bytes);
    board_mark(1 << MARK_DRAWING);
    return error;
}

static int show_frame(uint16_t frame)
{
    glint_display display = picture_display;
    display.flush = send_band;
    board_mark(1 << MARK_DRAWING);
    const int error = picture_draw(frame, &display, memory, sizeof memory, NULL);
    board_mark(0);
    board_value("frame", frame);
    return error;
}

/* Once round. The panel is dark until the first frame is on it. */
static int go_round(void)
{
    int error = 0;
    for (uint16_t frame = 0; frame < picture_frames && error == 0; frame++) {
        error = show_frame(frame);
        if (error == 0 && frame == 0) {
            error = ssd1306_show(&panel);
        }
    }
    return error;
}

static const char *error_text(int error)
{
    switch (error) {
    case OLED_ERROR_ABSENT:
        return "no panel answers: is it wired, and is its address 0x3C?";
    case OLED_ERROR_BUS:
        return "the two-wire bus does not move: are both lines pulled up?";
    case OLED_ERROR_REFUSED:
        return "the panel refused a byte";
    case SSD1306_ERROR_WINDOW:
        return "a window is not within the panel";
    default:
        return "the library refused the picture: see glint/error.h";
    }
}

int main(void)
{
    board_begin();
    oled_port_begin();
    int error = ssd1306_begin(&panel);
    while (error == 0) {
        error = go_round();
        if (error == 0) {
            board_value("stack_bytes", board_stack_used());
            board_value("stack_free", (uint32_t)board_stack_size() - board_stack_used());
            board_text("round\r\n");
            board_wait_for_press();
        }
    }
    (void)ssd1306_end(&panel);
    board_value("error", (uint32_t)(error < 0 ? -error : error));
    board_text(error_text(error));
    board_text("\r\n");
    for (;;) {
        sleep_mode();
    }
}
