/* SPDX-License-Identifier: MIT */
/*
 * See oled_port.h. LM3S6965 data sheet: 13 (SSI). The panel's reset is that of the whole board.
 */
#include "examples/oled_lm3s6965/oled_port.h"

#include <stddef.h>

#include "examples/oled_lm3s6965/board.h"
#include "examples/oled_lm3s6965/lm3s6965.h"

#define SSI_PINS (PIN(2) | PIN(3) | PIN(5)) /* of port A: clock, select, data */
#define DC PIN(7)                           /* of port C */
#define CARD_SELECT PIN(0)                  /* of port D: the memory card is on the same wires */

/* SSI clock = 50 MHz / (CPSDVSR (1 + SCR)) */
#define CPSDVSR 2

/* A byte takes 112 cycles; more turns than the eight of the FIFO can take mean that it does not send. */
#define SSI_TURNS 10000

void oled_port_begin(void)
{
    GPIODATA(GPIO_D, CARD_SELECT) = CARD_SELECT;
    GPIODIR(GPIO_D) |= CARD_SELECT;
    GPIODEN(GPIO_D) |= CARD_SELECT;
    GPIODIR(GPIO_C) |= DC;
    GPIODEN(GPIO_C) |= DC;
    GPIOAFSEL(GPIO_A) |= SSI_PINS;
    GPIODEN(GPIO_A) |= SSI_PINS;
    SSICR1 = 0;
    SSICPSR = CPSDVSR;
    /* The clock rests high and bits are taken as it rises (mode 3): select stays low from byte to byte. */
    SSICR0 = SSICR0_SCR(OLED_CLOCK_DIVIDE / CPSDVSR - 1) | SSICR0_SPH | SSICR0_SPO | SSICR0_DSS_8;
    SSICR1 = SSICR1_SSE;
}

static int wait_until(uint32_t flag, uint32_t level)
{
    for (uint32_t turns = 0; (SSISR & flag) != level; turns++) {
        if (turns == SSI_TURNS) {
            return BOARD_ERROR_SSI;
        }
    }
    return 0;
}

/* What comes in while bytes go out. QEMU's interface stops when eight of them are waiting. */
static void drop_received(void)
{
    while (SSISR & SSISR_RNE) {
        (void)SSIDR;
    }
}

/* D/C holds for all bytes, so that the last has left before it may change. */
static int send(uint32_t dc, const uint8_t *bytes, uint32_t count)
{
    int error = 0;
    GPIODATA(GPIO_C, DC) = dc;
    for (uint32_t i = 0; i < count && error == 0; i++) {
        error = wait_until(SSISR_TNF, SSISR_TNF);
        SSIDR = bytes[i];
        drop_received();
    }
    error = error ? error : wait_until(SSISR_BSY, 0);
    drop_received();
    return error;
}

static int send_command(void *context, const uint8_t *bytes, uint32_t count)
{
    (void)context;
    return send(0, bytes, count);
}

static int send_data(void *context, const uint8_t *bytes, uint32_t count)
{
    (void)context;
    return send(DC, bytes, count);
}

static int delay_us(void *context, uint32_t us)
{
    (void)context;
    board_delay_us(us);
    return 0;
}

const panel_port oled_port = {.send_command = send_command, .send_data = send_data, .delay_us = delay_us};
