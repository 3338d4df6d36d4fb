/* SPDX-License-Identifier: MIT */
/*
 * Cortex-M0+ under tools/cost/rp2040.js, which answers semihosting calls and counts cycles. As platform_arm.c, but the
 * counter is SYS_ELAPSED (release 3.0 of semihosting, 6.3): the emulator's cycles since it began. The frames are too
 * long for SysTick's 24 bits.
 */
#include "tests/target/platform.h"

#include "tests/target/stack_paint.h"

#define SYS_WRITE0 0x04
#define SYS_EXIT 0x18
#define SYS_ELAPSED 0x30
#define APPLICATION_EXIT 0x20026u

/* From cortex_m.ld. */
extern uint8_t link_bss_end[], link_stack_top[];

const char *const platform_count_unit = "cycles";
const uint16_t platform_count_repeat = 1;
const uint8_t platform_empty_cost = 4; /* movs 1, bx 3 */

static void semihosting(uint32_t operation, uintptr_t argument)
{
    register uint32_t r0 __asm("r0") = operation;
    register uintptr_t r1 __asm("r1") = argument;
    __asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void platform_begin(void)
{
}

void platform_write(const char *text)
{
    semihosting(SYS_WRITE0, (uintptr_t)text);
}

void platform_end(void)
{
    semihosting(SYS_EXIT, APPLICATION_EXIT);
}

uint32_t platform_count(void)
{
    uint32_t elapsed[2] = {0, 0};
    semihosting(SYS_ELAPSED, (uintptr_t)elapsed);
    return elapsed[0];
}

/* subs takes 1 cycle; bne 2 when taken and 1 at the end (Cortex-M0+ Technical Reference Manual, 3.3). */
uint32_t platform_known_loop(void)
{
    uint32_t rounds = 100000;
    __asm volatile(".syntax unified\n1: subs %0, %0, #1\n\tbne 1b" : "+l"(rounds) : : "cc");
    return 3 * UINT32_C(100000) - 1;
}

void platform_stack_paint(void)
{
    stack_paint(link_bss_end);
}

uint32_t platform_stack_used(void)
{
    return stack_used(link_bss_end, link_stack_top);
}
