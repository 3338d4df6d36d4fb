/* SPDX-License-Identifier: MIT */
/*
 * The least that a RISC-V program needs before main() on an emulator that loads .data itself: the stack pointer, and
 * .bss cleared. RISC-V ABIs specification 1.0: the stack is aligned to 16 bytes. Limit: no trap handler.
 */
#include <stdint.h>

/* From riscv.ld. */
extern uint32_t link_bss_start[], link_bss_end[];

int main(void);
void start(void);

__asm(".section .text.reset,\"ax\"\n"
      ".globl reset\n"
      "reset:\n"
      "    la sp, link_stack_top\n"
      "    j start\n"
      ".text\n");

void start(void)
{
    for (uint32_t *to = link_bss_start; to != link_bss_end; to++) {
        *to = 0;
    }
    (void)main();
    for (;;) {
    }
}
