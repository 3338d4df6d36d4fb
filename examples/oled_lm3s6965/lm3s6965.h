/* SPDX-License-Identifier: MIT */
/*
 * The registers of the LM3S6965 that this example uses, named as in its data sheet (Luminary Micro DS-LM3S6965), and
 * SysTick of the Cortex-M3.
 */
#ifndef EXAMPLES_OLED_LM3S6965_LM3S6965_H
#define EXAMPLES_OLED_LM3S6965_LM3S6965_H

#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t *)(uintptr_t)(address))

/* System control */
#define LDOPCTL REGISTER(0x400FE034U)
#define RIS REGISTER(0x400FE050U)
#define RCC REGISTER(0x400FE060U)
#define RCGC1 REGISTER(0x400FE104U)
#define RCGC2 REGISTER(0x400FE108U)

#define LDOPCTL_2V75 UINT32_C(0x1B)
#define RIS_PLLLRIS (UINT32_C(1) << 6) /* the PLL is locked */
#define RCC_SYSDIV_4 (UINT32_C(3) << 23)
#define RCC_SYSDIV_MASK (UINT32_C(15) << 23)
#define RCC_USESYSDIV (UINT32_C(1) << 22)
#define RCC_PWRDN (UINT32_C(1) << 13)
#define RCC_OEN (UINT32_C(1) << 12)
#define RCC_BYPASS (UINT32_C(1) << 11)
#define RCC_XTAL_8MHZ (UINT32_C(14) << 6)
#define RCC_XTAL_MASK (UINT32_C(15) << 6)
#define RCC_OSCSRC_MASK (UINT32_C(3) << 4) /* 0: the main oscillator */
#define RCC_MOSCDIS (UINT32_C(1) << 0)
#define RCGC1_UART0 (UINT32_C(1) << 0)
#define RCGC1_SSI0 (UINT32_C(1) << 4)
#define RCGC2_GPIOA (UINT32_C(1) << 0)
#define RCGC2_GPIOC (UINT32_C(1) << 2)
#define RCGC2_GPIOD (UINT32_C(1) << 3)
#define RCGC2_GPIOF (UINT32_C(1) << 5)

/* General-purpose inputs and outputs. Address bits 9..2 are a mask of the pins that an access to GPIODATA concerns. */
#define GPIO_A UINT32_C(0x40004000)
#define GPIO_C UINT32_C(0x40006000)
#define GPIO_D UINT32_C(0x40007000)
#define GPIO_F UINT32_C(0x40025000)
#define GPIODATA(port, pins) REGISTER((port) + ((pins) << 2))
#define GPIODIR(port) REGISTER((port) + 0x400U)
#define GPIOAFSEL(port) REGISTER((port) + 0x420U)
#define GPIOPUR(port) REGISTER((port) + 0x510U)
#define GPIODEN(port) REGISTER((port) + 0x51CU)
#define PIN(number) (UINT32_C(1) << (number))

/* Synchronous serial interface 0 */
#define SSICR0 REGISTER(0x40008000U)
#define SSICR1 REGISTER(0x40008004U)
#define SSIDR REGISTER(0x40008008U)
#define SSISR REGISTER(0x4000800CU)
#define SSICPSR REGISTER(0x40008010U)

#define SSICR0_SCR(divide) ((uint32_t)(divide) << 8)
#define SSICR0_SPH (UINT32_C(1) << 7)
#define SSICR0_SPO (UINT32_C(1) << 6)
#define SSICR0_DSS_8 UINT32_C(7)
#define SSICR1_SSE (UINT32_C(1) << 1)
#define SSISR_BSY (UINT32_C(1) << 4)
#define SSISR_RNE (UINT32_C(1) << 2)
#define SSISR_TNF (UINT32_C(1) << 1)

/* UART 0 */
#define UARTDR REGISTER(0x4000C000U)
#define UARTFR REGISTER(0x4000C018U)
#define UARTIBRD REGISTER(0x4000C024U)
#define UARTFBRD REGISTER(0x4000C028U)
#define UARTLCRH REGISTER(0x4000C02CU)
#define UARTCTL REGISTER(0x4000C030U)

#define UARTFR_TXFF (UINT32_C(1) << 5)
#define UARTLCRH_WLEN_8 (UINT32_C(3) << 5)
#define UARTLCRH_FEN (UINT32_C(1) << 4)
#define UARTCTL_TXE (UINT32_C(1) << 8)
#define UARTCTL_UARTEN (UINT32_C(1) << 0)

/* SysTick (Armv7-M Architecture Reference Manual, B3.3): counts down, 24 bits */
#define SYST_CSR REGISTER(0xE000E010U)
#define SYST_RVR REGISTER(0xE000E014U)
#define SYST_CVR REGISTER(0xE000E018U)

#define SYST_CSR_CLKSOURCE (UINT32_C(1) << 2) /* the processor's clock */
#define SYST_CSR_ENABLE (UINT32_C(1) << 0)
#define SYST_BITS UINT32_C(0xFFFFFF)

#endif
