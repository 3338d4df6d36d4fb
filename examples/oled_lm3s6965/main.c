/* SPDX-License-Identifier: MIT */
/*
 * A teapot turns on the OLED of the EK-LM3S6965 board: once after reset, and again at each press of the select button.
 * What a frame takes goes to the UART.
 */
#include "examples/firmware/picture.h"
#include "examples/oled_lm3s6965/board.h"
#include "examples/oled_lm3s6965/oled_port.h"
#include "examples/panels/ssd0323.h"
#include "tests/target/stack_paint.h"

/* The library's memory: the whole picture as one band, the teapot's vertices, two lights. */
#define VERTICES 514
#define TRIANGLES 928
static uint32_t memory[GLINT_MEMORY_WORDS(128, 64, 64, GLINT_GREY4, 1, VERTICES, TRIANGLES, 1, 2)];

static const ssd0323 panel = {.port = &oled_port, .display_offset = 76};

/* Of the frame under way. */
static struct sending {
    uint32_t cycles, bytes;
} sending;

/* From the linker script. */
extern uint8_t link_bss_end[], link_stack_top[];

static int send_band(void *context, const glint_band *band)
{
    struct sending *const sum = context;
    const uint32_t start = board_cycles();
    int error = ssd0323_window(&panel, 0, (uint8_t)band->y_px, (uint8_t)band->width_px, (uint8_t)band->height_px);
    error = error ? error : oled_port.send_data(oled_port.context, band->pixels, band->bytes);
    sum->cycles += board_cycles() - start;
    sum->bytes += band->bytes;
    return error;
}

static int show_frame(uint16_t frame)
{
    glint_display display = picture_display;
    display.flush = send_band;
    display.context = &sending;
    sending = (struct sending){0, 0};
    const uint32_t start = board_cycles();
    const int error = picture_draw(frame, &display, memory, sizeof memory, NULL);
    const uint32_t cycles = board_cycles() - start;
    if (error == 0) {
        board_value("frame", frame);
        board_value("draw_cycles", cycles - sending.cycles);
        board_value("send_cycles", sending.cycles);
        board_value("frame_bytes", sending.bytes);
        board_value("stack_bytes", stack_used(link_bss_end, link_stack_top));
    }
    return error;
}

/* One turn. The panel is dark until the first frame is on it. */
static int turn(void)
{
    int error = 0;
    for (uint16_t frame = 0; frame < picture_frames && error == 0; frame++) {
        error = show_frame(frame);
        if (error == 0 && frame == 0) {
            error = ssd0323_show(&panel);
        }
    }
    return error;
}

static const char *error_text(int error)
{
    switch (error) {
    case BOARD_ERROR_PLL:
        return "the PLL does not lock: is the crystal one of 8 MHz?";
    case BOARD_ERROR_SSI:
        return "SSI 0 does not send";
    case SSD0323_ERROR_WINDOW:
        return "a band is not within the panel";
    default:
        return glint_error_text(error);
    }
}

/* A press is a change: the button has been seen up before. */
static void wait_for_press(void)
{
    while (board_button_pressed()) {
    }
    while (!board_button_pressed()) {
    }
}

int main(void)
{
    stack_paint(link_bss_end);
    int error = board_begin();
    oled_port_begin();
    error = error ? error : ssd0323_begin(&panel);
    while (error == 0) {
        error = turn();
        if (error == 0) {
            board_text("turned\r\n");
            wait_for_press();
        }
    }
    board_value("error", (uint32_t)error);
    board_text(error_text(error));
    board_text("\r\n");
    (void)ssd0323_end(&panel);
    return error;
}
