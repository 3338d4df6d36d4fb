/* SPDX-License-Identifier: MIT */
/*
 * Cortex-M under an emulator: text and end by semihosting, SysTick as the counter. With PLATFORM_MPS2 defined the
 * counter is timer 0 of the MPS2 boards instead (Cortex-M System Design Kit, APB timer): it has 32 bits, so that whole
 * frames of a software floating-point unit fit.
 *
 * Semihosting for AArch32 and AArch64, release 3.0: BKPT 0xAB, operation in r0, argument in r1. SysTick: Armv7-M
 * Architecture Reference Manual, B3.3 (Armv6-M has the same). Start-up code is startup/cortex_m_startup.c.
 */
#include "tests/target/platform.h"

#include "tests/target/stack_paint.h"

#define SYS_WRITE0 0x04
#define SYS_EXIT 0x18
#define APPLICATION_EXIT 0x20026u

#if defined(PLATFORM_MPS2)
#define COUNTER_CONTROL (*(volatile uint32_t *)0x40000000U)
#define COUNTER_VALUE (*(volatile uint32_t *)0x40000004U)
#define COUNTER_RELOAD (*(volatile uint32_t *)0x40000008U)
#define COUNTER_BITS 0xffffffffU
#define COUNTER_ON 1 /* no interrupt */
#else
#define COUNTER_CONTROL (*(volatile uint32_t *)0xE000E010U)
#define COUNTER_RELOAD (*(volatile uint32_t *)0xE000E014U)
#define COUNTER_VALUE (*(volatile uint32_t *)0xE000E018U)
#define COUNTER_BITS 0xffffffU
#define COUNTER_ON 5 /* the processor's clock, no interrupt */
#endif

/* From cortex_m.ld. */
extern uint8_t link_bss_end[], link_stack_top[];

const char *const platform_count_unit = "instructions";
const uint16_t platform_count_repeat = 400;
const uint8_t platform_empty_cost = 2; /* movs, bx */

static uint32_t counted, last_value;

static void semihosting(uint32_t operation, uintptr_t argument)
{
    register uint32_t r0 __asm("r0") = operation;
    register uintptr_t r1 __asm("r1") = argument;
    __asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void platform_begin(void)
{
    COUNTER_RELOAD = COUNTER_BITS;
    COUNTER_VALUE = 0;
    COUNTER_CONTROL = COUNTER_ON;
    last_value = COUNTER_VALUE;
}

void platform_write(const char *text)
{
    semihosting(SYS_WRITE0, (uintptr_t)text);
}

void platform_end(void)
{
    semihosting(SYS_EXIT, APPLICATION_EXIT);
}

/* Either counts down. */
uint32_t platform_count(void)
{
    const uint32_t value = COUNTER_VALUE;
    counted += (last_value - value) & COUNTER_BITS;
    last_value = value;
    return counted;
}

uint32_t platform_known_loop(void)
{
    uint32_t rounds = 1000000;
    __asm volatile(".syntax unified\n1: subs %0, %0, #1\n\tbne 1b" : "+l"(rounds) : : "cc");
    return 2 * UINT32_C(1000000);
}

void platform_stack_paint(void)
{
    stack_paint(link_bss_end);
}

uint32_t platform_stack_used(void)
{
    return stack_used(link_bss_end, link_stack_top);
}
