/* SPDX-License-Identifier: MIT */
/*
 * See pico_panel.h. RP2040 data sheet: 2.5 (DMA), 2.19 (GPIO), 4.4 (SPI).
 */
#include "examples/pico_st7789/pico_panel.h"

#include <stddef.h>

#include "examples/pico_st7789/clocks.h"
#include "examples/pico_st7789/rp2040.h"

enum { PIN_DC = 16, PIN_CS = 17, PIN_SCK = 18, PIN_MOSI = 19, PIN_BACKLIGHT = 20, PIN_RESET = 21 };

#define CPSDVSR 2u /* the least even divisor */
#define MOST_SCR 256u

static struct {
    void (*done)(void *context); /* may be NULL */
    void *context;
    volatile bool sending;
    volatile bool failed;
} transfer;

static void set_pin(uint32_t pin, bool high)
{
    if (high) {
        SIO_GPIO_OUT_SET = 1u << pin;
    } else {
        SIO_GPIO_OUT_CLR = 1u << pin;
    }
}

/* The level first, so that the pin begins with it. */
static void make_output(uint32_t pin, bool high)
{
    set_pin(pin, high);
    SIO_GPIO_OE_SET = 1u << pin;
    GPIO_CTRL(pin) = GPIO_CTRL_FUNCSEL_SIO;
}

/* 62.5 MHz want the pad's fast edges. */
static void make_spi(uint32_t pin)
{
    PADS_BANK0_GPIO(pin) = PADS_IE | PADS_DRIVE_8MA | PADS_SLEWFAST;
    GPIO_CTRL(pin) = GPIO_CTRL_FUNCSEL_SPI;
}

void pico_panel_set_speed(uint32_t spi_hz)
{
    const uint32_t fastest = CLK_PERI_HZ / CPSDVSR;
    uint32_t divisor = spi_hz ? (fastest + spi_hz - 1) / spi_hz : MOST_SCR;
    divisor = divisor < 1 ? 1 : divisor > MOST_SCR ? MOST_SCR : divisor;
    SPI0_SSPCR1 = 0;
    SPI0_SSPCPSR = CPSDVSR;
    SPI0_SSPCR0 = SSPCR0_SCR(divisor) | SSPCR0_SPO | SSPCR0_SPH | SSPCR0_DSS(8u);
    SPI0_SSPCR1 = SSPCR1_SSE;
}

int pico_panel_begin(uint32_t spi_hz)
{
    const int error = clocks_release(RESETS_IO_BANK0 | RESETS_PADS_BANK0 | RESETS_SPI0 | RESETS_DMA);
    if (error) {
        return error;
    }
    make_output(PIN_BACKLIGHT, false);
    make_output(PIN_CS, true);
    make_output(PIN_RESET, true);
    make_output(PIN_DC, true);
    make_spi(PIN_SCK);
    make_spi(PIN_MOSI);
    pico_panel_set_speed(spi_hz);
    SPI0_SSPDMACR = SSPDMACR_TXDMAE;

    DMA_CH0_WRITE_ADDR = (uint32_t)(uintptr_t)&SPI0_SSPDR;
    DMA_INTE0 = DMA_CHANNEL_0;
    NVIC_ISER = NVIC_DMA_IRQ_0;
    return 0;
}

static void wait_until_sent(void)
{
    while (SPI0_SSPSR & SSPSR_BSY) {
    }
}

/* WFE returns at once when an interrupt has been since the last one: none is slept through. */
void pico_panel_wait(void)
{
    while (transfer.sending) {
        __asm volatile("wfe");
    }
}

/* Waits for the transfer under way. */
static int take_error(void)
{
    pico_panel_wait();
    const int error = transfer.failed ? PICO_PANEL_ERROR_DMA : 0;
    transfer.failed = false;
    return error;
}

int pico_panel_send(const void *pixels, uint32_t bytes, void (*done)(void *context), void *context)
{
    const int error = take_error();
    if (error) {
        return error;
    }
    transfer.done = done;
    transfer.context = context;
    transfer.sending = true;
    set_pin(PIN_DC, true);
    set_pin(PIN_CS, false);
    DMA_CH0_READ_ADDR = (uint32_t)(uintptr_t)pixels;
    DMA_CH0_TRANS_COUNT = bytes;
    DMA_CH0_CTRL_TRIG = DMA_CTRL_EN | DMA_CTRL_DATA_SIZE_BYTE | DMA_CTRL_INCR_READ | DMA_CTRL_CHAIN_TO(0u) |
                        DMA_CTRL_TREQ_SEL(DMA_DREQ_SPI0_TX);
    return 0;
}

/* All bytes are in SPI0's FIFO: the last 9 are still to be sent, 1.2 us at 62.5 MHz. What comes back is not read: the
 * receive FIFO is full and stays so, which SPI0 only notes. */
void pico_panel_interrupt(void)
{
    DMA_INTS0 = DMA_CHANNEL_0;
    if (DMA_CH0_CTRL_TRIG & DMA_CTRL_AHB_ERROR) {
        transfer.failed = true;
        /* which holds the channel until it is cleared */
        DMA_CH0_CTRL_TRIG = DMA_CTRL_READ_ERROR | DMA_CTRL_WRITE_ERROR;
    }
    wait_until_sent();
    set_pin(PIN_CS, true);
    transfer.sending = false;
    if (transfer.done) {
        transfer.done(transfer.context);
    }
}

void pico_panel_backlight(bool on)
{
    set_pin(PIN_BACKLIGHT, on);
}

static int send(bool data, const uint8_t *bytes, uint32_t count)
{
    const int error = take_error();
    if (error) {
        return error;
    }
    set_pin(PIN_DC, data);
    set_pin(PIN_CS, false);
    for (uint32_t i = 0; i < count; i++) {
        while (!(SPI0_SSPSR & SSPSR_TNF)) {
        }
        SPI0_SSPDR = bytes[i];
    }
    wait_until_sent();
    set_pin(PIN_CS, true);
    return 0;
}

static int send_command(void *context, const uint8_t *bytes, uint32_t count)
{
    (void)context;
    return send(false, bytes, count);
}

static int send_data(void *context, const uint8_t *bytes, uint32_t count)
{
    (void)context;
    return send(true, bytes, count);
}

static int set_reset(void *context, bool high)
{
    (void)context;
    set_pin(PIN_RESET, high);
    return 0;
}

static int port_delay_us(void *context, uint32_t us)
{
    (void)context;
    delay_us(us);
    return 0;
}

const panel_port pico_panel_port = {send_command, send_data, set_reset, port_delay_us, NULL};
