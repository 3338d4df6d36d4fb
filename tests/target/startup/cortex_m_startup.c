/* SPDX-License-Identifier: MIT */
/*
 * The least that a Cortex-M needs before main(): vector table, .data copied from flash, .bss cleared. Links the
 * firmware example and the size programs, so that their figures are those of the library and not of a vendor's start-up
 * code.
 *
 * Armv7-M Architecture Reference Manual, B1.5.3 (the vector table: initial stack pointer, then the handlers; Armv6-M
 * has the same first 16 entries). Limits: no device interrupts; any fault stops in an endless loop.
 */
#include <stdint.h>

/* From cortex_m.ld. */
extern uint32_t link_data_start[], link_data_end[], link_bss_start[], link_bss_end[], link_stack_top[];
extern const uint32_t link_data_load[];

int main(void);
void reset_handler(void);

static void stop(void)
{
    for (;;) {
    }
}

#define EXCEPTION_COUNT 15

typedef struct vector_table {
    uint32_t *stack_top;
    void (*handlers[EXCEPTION_COUNT])(void); /* exceptions 1 (reset) .. 15 (SysTick) */
} vector_table;

extern const vector_table vectors;
__attribute__((section(".vectors"), used)) const vector_table vectors = {
    link_stack_top,
    {reset_handler, stop, stop, stop, stop, stop, stop, stop, stop, stop, stop, stop, stop, stop, stop},
};

void reset_handler(void)
{
    const uint32_t *from = link_data_load;
    for (uint32_t *to = link_data_start; to != link_data_end; to++) {
        *to = *from++;
    }
    for (uint32_t *to = link_bss_start; to != link_bss_end; to++) {
        *to = 0;
    }
#if defined(__ARM_FP)
    /* The floating-point unit is off after reset: full access to coprocessors 10 and 11 (B3.2.20, CPACR). */
    *(volatile uint32_t *)0xE000ED88U |= UINT32_C(0xF) << 20;
    __asm volatile("dsb\n\tisb");
#endif
    (void)main();
    stop();
}
