/* SPDX-License-Identifier: MIT */
/*
 * See clocks.h. RP2040 data sheet: 2.15.6.1 (order of the steps), 2.16 (crystal), 2.18 (PLL), 4.7.2 (tick).
 */
#include "examples/pico_st7789/clocks.h"

#include <stdbool.h>

#include "examples/pico_st7789/rp2040.h"

/* 12 MHz x 125 = 1500 MHz, within the PLL's 750..1600; / 6 / 2 = 125 MHz. */
#define PLL_REFDIV 1u
#define PLL_FBDIV 125u
#define PLL_POSTDIV1 6u
#define PLL_POSTDIV2 2u
typedef char assert_pll[CLK_REF_HZ / PLL_REFDIV * PLL_FBDIV / PLL_POSTDIV1 / PLL_POSTDIV2 == CLK_SYS_HZ ? 1 : -1];

/* The crystal needs about 1 ms: in units of 256 of its cycles, rounded up. */
#define XOSC_STARTUP_DELAY ((CLK_REF_HZ / 1000 + 255) / 256)

#define TICK_CYCLES (CLK_REF_HZ / 1000000)

/* Each of what is waited for takes a few ms at most; this is a second or so at the ring oscillator's clock, 1.8..12
 * MHz. */
#define MOST_POLLS UINT32_C(500000)

static bool come(const volatile uint32_t *status, uint32_t bits)
{
    for (uint32_t polls = 0; polls < MOST_POLLS; polls++) {
        if ((*status & bits) == bits) {
            return true;
        }
    }
    return false;
}

int clocks_release(uint32_t blocks)
{
    REGISTER_CLEAR(RESETS_RESET) = blocks;
    return come(&RESETS_RESET_DONE, blocks) ? 0 : CLOCKS_ERROR_RESET;
}

static int start_crystal(void)
{
    XOSC_STARTUP = XOSC_STARTUP_DELAY;
    XOSC_CTRL = XOSC_CTRL_FREQ_RANGE_1_15MHZ | XOSC_CTRL_ENABLE;
    return come(&XOSC_STATUS, XOSC_STATUS_STABLE) ? 0 : CLOCKS_ERROR_CRYSTAL;
}

/* A reset of the processor alone leaves the PLL running: it is put into reset first. */
static int start_pll(void)
{
    REGISTER_SET(RESETS_RESET) = RESETS_PLL_SYS;
    const int error = clocks_release(RESETS_PLL_SYS);
    if (error) {
        return error;
    }
    PLL_SYS_CS = PLL_CS_REFDIV(PLL_REFDIV);
    PLL_SYS_FBDIV_INT = PLL_FBDIV;
    REGISTER_CLEAR(PLL_SYS_PWR) = PLL_PWR_PD | PLL_PWR_VCOPD;
    if (!come(&PLL_SYS_CS, PLL_CS_LOCK)) {
        return CLOCKS_ERROR_PLL;
    }
    PLL_SYS_PRIM = PLL_PRIM_POSTDIV1(PLL_POSTDIV1) | PLL_PRIM_POSTDIV2(PLL_POSTDIV2);
    REGISTER_CLEAR(PLL_SYS_PWR) = PLL_PWR_POSTDIVPD;
    return 0;
}

/* A clock's SELECTED register shows its source as one bit. */
static int select_source(volatile uint32_t *control, const volatile uint32_t *selected, uint32_t source, uint32_t rest)
{
    *control = rest | source;
    return come(selected, 1u << source) ? 0 : CLOCKS_ERROR_SWITCH;
}

int clocks_begin(void)
{
    int error = start_crystal();
    error = error ? error : select_source(&CLK_REF_CTRL, &CLK_REF_SELECTED, CLK_REF_CTRL_SRC_XOSC_CLKSRC, 0);
    /* away from the PLL before that stops, and to it only when it runs */
    error = error ? error : select_source(&CLK_SYS_CTRL, &CLK_SYS_SELECTED, CLK_SYS_CTRL_SRC_CLK_REF, 0);
    error = error ? error : start_pll();
    error = error ? error
                  : select_source(&CLK_SYS_CTRL, &CLK_SYS_SELECTED, CLK_SYS_CTRL_SRC_CLKSRC_CLK_SYS_AUX,
                                  CLK_SYS_CTRL_AUXSRC_CLKSRC_PLL_SYS);
    if (error) {
        return error;
    }
    CLK_PERI_CTRL = CLK_PERI_CTRL_ENABLE | CLK_PERI_CTRL_AUXSRC_CLK_SYS;
    WATCHDOG_TICK = WATCHDOG_TICK_CYCLES(TICK_CYCLES) | WATCHDOG_TICK_ENABLE;
    return clocks_release(RESETS_TIMER);
}

uint32_t time_us(void)
{
    return TIMER_TIMERAWL;
}

void delay_us(uint32_t us)
{
    const uint32_t start = time_us();
    while (time_us() - start <= us) { /* the first of them may have been nearly over */
    }
}
