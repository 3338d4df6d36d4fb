/* SPDX-License-Identifier: MIT */
/*
 * What comes between boot2.S and main(): the vector table, the stack painted, .data copied from flash, .bss cleared.
 *
 * Armv6-M Architecture Reference Manual, B1.5.3 (vector table); RP2040 data sheet, 2.3.2 (interrupts).
 */
#include "examples/pico_st7789/startup.h"

#include "examples/pico_st7789/pico_panel.h"
#include "examples/pico_st7789/rp2040.h"

#define STACK_PAINT 0xa5a5a5a5u
#define STACK_MARGIN_WORDS 16 /* below the frame of reset_handler() */

#define EXCEPTION_COUNT 15
#define INTERRUPT_COUNT 26
#define DMA_IRQ_0 11

#define PIN_LED 25u

/* From rp2040.ld. The sizes are the addresses of their symbols. */
extern uint32_t link_stack_bottom[], link_stack_top[], link_data_start[], link_data_end[], link_bss_start[],
    link_bss_end[];
extern const uint32_t link_data_load[];
extern const uint8_t link_flash_bytes[], link_ram_bytes[];

int main(void);
void reset_handler(void);

typedef void handler(void);

typedef struct vector_table {
    uint32_t *stack_top;
    handler *exceptions[EXCEPTION_COUNT]; /* 1 (reset) .. 15 (SysTick) */
    handler *interrupts[INTERRUPT_COUNT];
} vector_table;

static void unexpected(void)
{
    stop();
}

extern const vector_table vectors;
__attribute__((section(".vectors"), used)) const vector_table vectors = {
    .stack_top = link_stack_top,
    .exceptions = {reset_handler, unexpected, unexpected, unexpected, unexpected, unexpected, unexpected, unexpected,
                   unexpected, unexpected, unexpected, unexpected, unexpected, unexpected, unexpected},
    /* the others are never enabled */
    .interrupts = {[DMA_IRQ_0] = pico_panel_interrupt},
};

void reset_handler(void)
{
    const uint32_t *const painted = (const uint32_t *)__builtin_frame_address(0) - STACK_MARGIN_WORDS;
    for (volatile uint32_t *word = link_stack_bottom; word < painted; word++) {
        *word = STACK_PAINT;
    }
    const uint32_t *from = link_data_load;
    for (uint32_t *to = link_data_start; to != link_data_end; to++) {
        *to = *from++;
    }
    for (uint32_t *to = link_bss_start; to != link_bss_end; to++) {
        *to = 0;
    }
    (void)main();
    stop();
}

void stop(void)
{
    __asm volatile("cpsid i");
    REGISTER_CLEAR(RESETS_RESET) = RESETS_IO_BANK0;
    while (!(RESETS_RESET_DONE & RESETS_IO_BANK0)) {
    }
    SIO_GPIO_OUT_SET = 1u << PIN_LED;
    SIO_GPIO_OE_SET = 1u << PIN_LED;
    GPIO_CTRL(PIN_LED) = GPIO_CTRL_FUNCSEL_SIO;
    for (;;) {
        __asm volatile("wfe");
    }
}

uint32_t stack_used_bytes(void)
{
    const uintptr_t top = (uintptr_t)link_stack_top;
    const volatile uint32_t *word = link_stack_bottom;
    while ((uintptr_t)word < top && *word == STACK_PAINT) {
        word++;
    }
    return (uint32_t)(top - (uintptr_t)word);
}

uint32_t flash_used_bytes(void)
{
    return (uint32_t)(uintptr_t)link_flash_bytes;
}

uint32_t ram_used_bytes(void)
{
    return (uint32_t)(uintptr_t)link_ram_bytes;
}
