/* SPDX-License-Identifier: MIT
 *
 * Second stage of the boot: the first 256 bytes of the flash. The boot ROM copies them to the end of SRAM, checks their
 * CRC-32 in the last four (tools/pico-uf2 puts it there) and calls them, with the flash readable only by commands. Here
 * the flash is made readable at 0x10000000, and the program behind these bytes is entered through its vector table.
 *
 * Each access to the flash becomes the plain serial read 03h: 8 bits of command, 24 of address, 32 of data, on one
 * wire. Every flash of this kind knows it, at up to 50 MHz (W25Q16JV, on the Pico), without dummy cycles, and without
 * modes that a reset of the processor alone would leave the flash in. It is slow: the 16 KB cache before it and code in
 * RAM (hot_code.ld) keep most reads from it.
 *
 * RP2040 data sheet: 2.8.1 (boot), 4.10.13 (SSI registers), 2.6.3 (execute in place).
 */
        .syntax unified
        .cpu    cortex-m0plus
        .thumb

        .equ    XIP_SSI_BASE, 0x18000000
        .equ    SSI_CTRLR0, 0x00
        .equ    SSI_CTRLR1, 0x04
        .equ    SSI_SSIENR, 0x08
        .equ    SSI_SER, 0x10
        .equ    SSI_BAUDR, 0x14
        .equ    SSI_SPI_CTRLR0, 0xf4

        /* 125 MHz / 4 = 31.25 MHz. */
        .equ    BAUDR_SCKDV, 4

        /* TMOD 3 writes command and address, then reads; DFS_32: data of 32 bits. */
        .equ    CTRLR0_TMOD_EEPROM_READ, 3 << 8
        .equ    CTRLR0_DFS_32, (32 - 1) << 16

        .equ    SPI_CTRLR0_ADDR_L_24, (24 / 4) << 2
        .equ    SPI_CTRLR0_INST_L_8, 2 << 8
        .equ    SPI_CTRLR0_XIP_CMD_READ, 0x03 << 24

        .equ    VECTOR_TABLE, 0x10000100
        .equ    VTOR, 0xe000ed08

        .section .boot2, "ax"
        .global boot2
        .type   boot2, %function
        .thumb_func
boot2:
        ldr     r0, =XIP_SSI_BASE
        movs    r1, #0
        str     r1, [r0, #SSI_SSIENR]           /* its settings change only while it is off */
        str     r1, [r0, #SSI_CTRLR1]           /* one frame of data an access */
        movs    r2, #BAUDR_SCKDV
        str     r2, [r0, #SSI_BAUDR]
        ldr     r2, =CTRLR0_TMOD_EEPROM_READ | CTRLR0_DFS_32
        str     r2, [r0, #SSI_CTRLR0]
        ldr     r2, =SPI_CTRLR0_ADDR_L_24 | SPI_CTRLR0_INST_L_8 | SPI_CTRLR0_XIP_CMD_READ
        ldr     r3, =XIP_SSI_BASE + SSI_SPI_CTRLR0
        str     r2, [r3]
        movs    r1, #1
        str     r1, [r0, #SSI_SER]              /* the only select line */
        str     r1, [r0, #SSI_SSIENR]

        ldr     r0, =VECTOR_TABLE
        ldr     r1, =VTOR
        str     r0, [r1]
        ldmia   r0!, {r1, r2}
        msr     msp, r1
        bx      r2
        .ltorg
        .size   boot2, . - boot2
