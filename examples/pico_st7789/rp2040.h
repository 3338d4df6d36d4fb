/* SPDX-License-Identifier: MIT */
/*
 * The registers of the RP2040 that this firmware uses, under the names of the RP2040 data sheet; the chapter that
 * describes each block stands beside it. Those of the processor: Armv6-M Architecture Reference Manual, B3.
 */
#ifndef EXAMPLES_PICO_ST7789_RP2040_H
#define EXAMPLES_PICO_ST7789_RP2040_H

#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))

/* 2.1.2: aliases of each register, but for those of SIO and the processor, that set or clear bits in one write. */
#define REGISTER_SET(name) REGISTER((uintptr_t)(&(name)) + 0x2000u)
#define REGISTER_CLEAR(name) REGISTER((uintptr_t)(&(name)) + 0x3000u)

/* 2.14 subsystem resets: one bit a block, in both registers */
#define RESETS_RESET REGISTER(0x4000c000u)
#define RESETS_RESET_DONE REGISTER(0x4000c008u)
#define RESETS_DMA (1u << 2)
#define RESETS_IO_BANK0 (1u << 5)
#define RESETS_PADS_BANK0 (1u << 8)
#define RESETS_PLL_SYS (1u << 12)
#define RESETS_SPI0 (1u << 16)
#define RESETS_TIMER (1u << 21)
#define RESETS_UART0 (1u << 22)

/* 2.15 clocks */
#define CLK_REF_CTRL REGISTER(0x40008030u)
#define CLK_REF_CTRL_SRC_XOSC_CLKSRC 2u
#define CLK_REF_SELECTED REGISTER(0x40008038u)
#define CLK_SYS_CTRL REGISTER(0x4000803cu)
#define CLK_SYS_CTRL_SRC_CLK_REF 0u
#define CLK_SYS_CTRL_SRC_CLKSRC_CLK_SYS_AUX 1u
#define CLK_SYS_CTRL_AUXSRC_CLKSRC_PLL_SYS (0u << 5)
#define CLK_SYS_SELECTED REGISTER(0x40008044u)
#define CLK_PERI_CTRL REGISTER(0x40008048u)
#define CLK_PERI_CTRL_ENABLE (1u << 11)
#define CLK_PERI_CTRL_AUXSRC_CLK_SYS (0u << 5)

/* 2.16 crystal oscillator */
#define XOSC_CTRL REGISTER(0x40024000u)
#define XOSC_CTRL_FREQ_RANGE_1_15MHZ 0xaa0u
#define XOSC_CTRL_ENABLE (0xfabu << 12)
#define XOSC_STATUS REGISTER(0x40024004u)
#define XOSC_STATUS_STABLE (1u << 31)
#define XOSC_STARTUP REGISTER(0x4002400cu) /* in 256 cycles of the crystal */

/* 2.18 PLL */
#define PLL_SYS_CS REGISTER(0x40028000u)
#define PLL_CS_LOCK (1u << 31)
#define PLL_CS_REFDIV(divisor) (divisor)
#define PLL_SYS_PWR REGISTER(0x40028004u)
#define PLL_PWR_PD (1u << 0)
#define PLL_PWR_POSTDIVPD (1u << 3)
#define PLL_PWR_VCOPD (1u << 5)
#define PLL_SYS_FBDIV_INT REGISTER(0x40028008u)
#define PLL_SYS_PRIM REGISTER(0x4002800cu)
#define PLL_PRIM_POSTDIV1(divisor) ((divisor) << 16)
#define PLL_PRIM_POSTDIV2(divisor) ((divisor) << 12)

/* 2.19 GPIO: functions and pads */
#define GPIO_CTRL(pin) REGISTER(0x40014004u + 8u * (pin))
#define GPIO_CTRL_FUNCSEL_SPI 1u
#define GPIO_CTRL_FUNCSEL_UART 2u
#define GPIO_CTRL_FUNCSEL_SIO 5u
#define PADS_BANK0_GPIO(pin) REGISTER(0x4001c004u + 4u * (pin))
#define PADS_SLEWFAST (1u << 0)
#define PADS_DRIVE_8MA (2u << 4)
#define PADS_IE (1u << 6)

/* 2.3.1 SIO: levels and directions of the pins, with set and clear registers of its own */
#define SIO_GPIO_OUT_SET REGISTER(0xd0000014u)
#define SIO_GPIO_OUT_CLR REGISTER(0xd0000018u)
#define SIO_GPIO_OE_SET REGISTER(0xd0000024u)

/* 4.2 UART */
#define UART0_UARTDR REGISTER(0x40034000u)
#define UART0_UARTFR REGISTER(0x40034018u)
#define UARTFR_TXFF (1u << 5)
#define UART0_UARTIBRD REGISTER(0x40034024u)
#define UART0_UARTFBRD REGISTER(0x40034028u)
#define UART0_UARTLCR_H REGISTER(0x4003402cu)
#define UARTLCR_H_FEN (1u << 4)
#define UARTLCR_H_WLEN_8 (3u << 5)
#define UART0_UARTCR REGISTER(0x40034030u)
#define UARTCR_UARTEN (1u << 0)
#define UARTCR_TXE (1u << 8)

/* 4.4 SPI (PL022) */
#define SPI0_SSPCR0 REGISTER(0x4003c000u)
#define SSPCR0_DSS(bits) ((bits)-1u)
#define SSPCR0_SPO (1u << 6) /* the clock rests high */
#define SSPCR0_SPH (1u << 7) /* data are taken at the second edge */
#define SSPCR0_SCR(divisor) (((divisor)-1u) << 8)
#define SPI0_SSPCR1 REGISTER(0x4003c004u)
#define SSPCR1_SSE (1u << 1)
#define SPI0_SSPDR REGISTER(0x4003c008u)
#define SPI0_SSPSR REGISTER(0x4003c00cu)
#define SSPSR_TNF (1u << 1)
#define SSPSR_BSY (1u << 4)
#define SPI0_SSPCPSR REGISTER(0x4003c010u)
#define SPI0_SSPDMACR REGISTER(0x4003c024u)
#define SSPDMACR_TXDMAE (1u << 1)

/* 4.6 timer: microseconds since it was let out of reset */
#define TIMER_TIMERAWL REGISTER(0x40054028u)

/* 4.7 watchdog, which makes the timer's microseconds from clk_ref */
#define WATCHDOG_TICK REGISTER(0x4005802cu)
#define WATCHDOG_TICK_CYCLES(cycles) (cycles)
#define WATCHDOG_TICK_ENABLE (1u << 9)

/* 2.5 DMA, channel 0 */
#define DMA_CH0_READ_ADDR REGISTER(0x50000000u)
#define DMA_CH0_WRITE_ADDR REGISTER(0x50000004u)
#define DMA_CH0_TRANS_COUNT REGISTER(0x50000008u)
#define DMA_CH0_CTRL_TRIG REGISTER(0x5000000cu)
#define DMA_CTRL_EN (1u << 0)
#define DMA_CTRL_DATA_SIZE_BYTE (0u << 2)
#define DMA_CTRL_INCR_READ (1u << 4)
#define DMA_CTRL_CHAIN_TO(channel) ((channel) << 11) /* to itself: to none */
#define DMA_CTRL_TREQ_SEL(dreq) ((dreq) << 15)
#define DMA_CTRL_WRITE_ERROR (1u << 29) /* a written one clears, as the next */
#define DMA_CTRL_READ_ERROR (1u << 30)
#define DMA_CTRL_AHB_ERROR (1u << 31) /* either: the channel has halted */
#define DMA_DREQ_SPI0_TX 16u
#define DMA_INTE0 REGISTER(0x50000404u)
#define DMA_INTS0 REGISTER(0x5000040cu) /* a written one clears */
#define DMA_CHANNEL_0 (1u << 0)

/* The processor's. */
#define NVIC_ISER REGISTER(0xe000e100u)
#define NVIC_DMA_IRQ_0 (1u << 11) /* 2.3.2 */

#endif
