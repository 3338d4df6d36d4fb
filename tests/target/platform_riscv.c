/* SPDX-License-Identifier: MIT */
/*
 * RISC-V on QEMU's `virt` machine: a 16550 UART for text, the test finisher to end, retired instructions as the
 * counter. QEMU documentation, "virt generic virtual platform". Start-up code is startup/riscv_startup.c.
 */
#include "tests/target/platform.h"

#include "tests/target/stack_paint.h"

#define UART_TRANSMIT (*(volatile uint8_t *)0x10000000U)
#define FINISHER (*(volatile uint32_t *)0x100000U)
#define FINISHER_PASS 0x5555U

/* From riscv.ld. */
extern uint8_t link_bss_end[], link_stack_top[];

const char *const platform_count_unit = "instructions";
const uint16_t platform_count_repeat = 10;
const uint8_t platform_empty_cost = 2; /* li, ret */

void platform_begin(void)
{
}

void platform_write(const char *text)
{
    while (*text) {
        UART_TRANSMIT = (uint8_t)*text++;
    }
}

void platform_end(void)
{
    FINISHER = FINISHER_PASS;
}

uint32_t platform_count(void)
{
    uint32_t count;
    __asm volatile(".option push\n\t.option arch, +zicsr\n\tcsrr %0, minstret\n\t.option pop" : "=r"(count));
    return count;
}

uint32_t platform_known_loop(void)
{
    uint32_t rounds = 1000000;
    __asm volatile("1: addi %0, %0, -1\n\tbnez %0, 1b" : "+r"(rounds));
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
