/* SPDX-License-Identifier: MIT */
/*
 * A Raspberry Pi Pico draws a turning torus knot on an ST7789 panel of 240x240 pixels. One band is sent by DMA while
 * the next is drawn.
 *
 * Before the panel lights up it measures what a frame costs: drawn without being sent; sent without being drawn; drawn
 * and sent in turn; and both at once, as it goes on to do. The figures go to the UART as lines of a name and a value,
 * and after them a line for each frame.
 */
#include <stddef.h>

#include <glint/glint.h>

#include "examples/firmware/picture.h"
#include "examples/panels/st7789.h"
#include "examples/pico_st7789/clocks.h"
#include "examples/pico_st7789/pico_panel.h"
#include "examples/pico_st7789/picture_size.h"
#include "examples/pico_st7789/startup.h"
#include "examples/pico_st7789/uart.h"

#define BAND_BYTES (GLINT_ROW_BYTES(PICTURE_FORMAT, PICTURE_WIDTH_PX) * PICTURE_BAND_PX)
#define FRAME_BYTES (GLINT_ROW_BYTES(PICTURE_FORMAT, PICTURE_WIDTH_PX) * PICTURE_HEIGHT_PX)

/* 16 ns a bit, the least that the ST7789's data sheet asks for; and an eighth of it, for wires too long for that. */
#define SPI_HZ UINT32_C(62500000)
#define SLOW_SPI_HZ (SPI_HZ / 8)

static uint32_t
    memory[GLINT_MEMORY_WORDS(PICTURE_WIDTH_PX, PICTURE_HEIGHT_PX, PICTURE_BAND_PX, PICTURE_FORMAT, PICTURE_BUFFERS,
                              PICTURE_VERTICES, PICTURE_TRIANGLES, PICTURE_OBJECTS, PICTURE_LIGHTS)];

static const st7789 panel = {.port = &pico_panel_port, .width_px = PICTURE_WIDTH_PX, .height_px = PICTURE_HEIGHT_PX};
static glint_transfers transfers;

static void transfer_done(void *context)
{
    glint_flush_done(context);
}

/* What becomes of the bands. */
static int send_band(const glint_band *band)
{
    int error = 0;
    if (band->y_px == 0) { /* one window for the frame: a band goes on where the one before ended */
        error = st7789_window(&panel, 0, 0, band->width_px, PICTURE_HEIGHT_PX);
    }
    return error ? error : pico_panel_send(band->pixels, band->bytes, transfer_done, &transfers);
}

static int send_at_once(void *context, const glint_band *band)
{
    (void)context;
    return send_band(band);
}

static int send_in_turn(void *context, const glint_band *band)
{
    (void)context;
    const int error = send_band(band);
    pico_panel_wait();
    return error;
}

static int send_nothing(void *context, const glint_band *band)
{
    (void)context;
    (void)band;
    glint_flush_done(&transfers);
    return 0;
}

static void sleep_until_sent(void *context)
{
    (void)context;
    pico_panel_wait();
}

static int draw(uint16_t frame, glint_flush flush, uint32_t *us)
{
    glint_display display = picture_display;
    display.flush = flush;
    display.transfers = &transfers;
    display.wait = sleep_until_sent;
    const uint32_t start_us = time_us();
    const int error = picture_draw(frame, &display, memory, sizeof memory, NULL);
    *us = time_us() - start_us;
    return error;
}

/* As many bytes as a frame has, whatever they are: the display is still off. */
static int send_only(uint32_t *us)
{
    const uint32_t start_us = time_us();
    int error = st7789_window(&panel, 0, 0, PICTURE_WIDTH_PX, PICTURE_HEIGHT_PX);
    for (uint32_t sent = 0; sent < FRAME_BYTES && error == 0; sent += BAND_BYTES) {
        error = pico_panel_send(memory, BAND_BYTES, NULL, NULL);
    }
    pico_panel_wait();
    *us = time_us() - start_us;
    return error;
}

/* Draws and sends one frame in each way, at one speed. */
static int measure(uint32_t spi_hz)
{
    uint32_t sending_us = 0, drawing_us = 0, in_turn_us = 0, at_once_us = 0;
    pico_panel_set_speed(spi_hz);
    int error = send_only(&sending_us);
    error = error ? error : draw(0, send_nothing, &drawing_us);
    error = error ? error : draw(0, send_in_turn, &in_turn_us);
    error = error ? error : draw(0, send_at_once, &at_once_us);
    if (error == 0) {
        uart_value("spi_khz", spi_hz / 1000);
        uart_value("sending_us", sending_us);
        uart_value("drawing_us", drawing_us);
        uart_value("in_turn_us", in_turn_us);
        uart_value("at_once_us", at_once_us);
    }
    return error;
}

static int begin(void)
{
    int error = st7789_begin(&panel);
    error = error ? error : measure(SLOW_SPI_HZ);
    error = error ? error : measure(SPI_HZ); /* the last frame is the first picture */
    error = error ? error : st7789_show(&panel);
    if (error == 0) {
        pico_panel_backlight(true);
        uart_value("flash_bytes", flash_used_bytes());
        uart_value("ram_bytes", ram_used_bytes());
        uart_value("stack_bytes", stack_used_bytes());
    }
    return error;
}

/* Until something fails. The lines fit the UART's FIFO, so that they cost no time. */
static int animate(void)
{
    for (uint16_t frame = 1;; frame = (uint16_t)((frame + 1) % picture_frames)) {
        uint32_t us = 0;
        const int error = draw(frame, send_at_once, &us);
        if (error) {
            return error;
        }
        uart_value("frame", frame);
        uart_value("frame_us", us);
    }
}

static const char *error_text(int error)
{
    switch (error) {
    case CLOCKS_ERROR_RESET:
        return "a block of the chip does not come out of reset";
    case PICO_PANEL_ERROR_DMA:
        return "the DMA could not read the pixels or write them to SPI0";
    case ST7789_ERROR_GLASS:
        return "the glass reaches beyond the ST7789's memory";
    default:
        return glint_error_text(error);
    }
}

int main(void)
{
    int error = clocks_begin();
    error = error ? error : uart_begin();
    if (error) { /* nothing to tell it with but the LED */
        stop();
    }
    error = pico_panel_begin(SPI_HZ);
    error = error ? error : begin();
    error = error ? error : animate();
    pico_panel_backlight(false);
    uart_text("error ");
    uart_text(error_text(error));
    uart_text("\r\n");
    stop();
}
