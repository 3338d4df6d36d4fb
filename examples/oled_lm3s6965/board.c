/* SPDX-License-Identifier: MIT */
/*
 * See board.h. LM3S6965 data sheet: 6.4.2 (changing the clock), 9 (GPIO), 12 (UART).
 */
#include "examples/oled_lm3s6965/board.h"

#include "examples/firmware/decimal.h"
#include "examples/oled_lm3s6965/lm3s6965.h"

#define UART0_PINS (PIN(0) | PIN(1)) /* of port A */
#define BUTTON PIN(1)                /* of port F */

/* 50 MHz / (16 x 115200) in 1/64: 27 8/64, off by 0.006 % */
#define BAUD UINT32_C(115200)
#define DIVISOR_64 ((BOARD_CLOCK_HZ * 8 / BAUD + 1) / 2)

/* The PLL locks within 0.5 ms: 6000 cycles of the internal oscillator; a turn of the loop takes several. */
#define PLL_TURNS 100000

static uint32_t counted, last_value;

static int clock_begin(void)
{
    LDOPCTL = LDOPCTL_2V75; /* the first revisions of the chip want it for 50 MHz from the PLL */
    uint32_t rcc = (RCC | RCC_BYPASS) & ~RCC_USESYSDIV;
    RCC = rcc;
    rcc &= ~(RCC_XTAL_MASK | RCC_OSCSRC_MASK | RCC_MOSCDIS | RCC_PWRDN | RCC_OEN);
    rcc |= RCC_XTAL_8MHZ;
    RCC = rcc;
    rcc = (rcc & ~RCC_SYSDIV_MASK) | RCC_SYSDIV_4 | RCC_USESYSDIV; /* 200 MHz / 4 */
    RCC = rcc;
    for (uint32_t turns = 0; !(RIS & RIS_PLLLRIS); turns++) {
        if (turns == PLL_TURNS) {
            return BOARD_ERROR_PLL;
        }
    }
    RCC = rcc & ~RCC_BYPASS;
    return 0;
}

static void uart_begin(void)
{
    GPIOAFSEL(GPIO_A) |= UART0_PINS;
    GPIODEN(GPIO_A) |= UART0_PINS;
    UARTCTL = 0;
    UARTIBRD = DIVISOR_64 / 64;
    UARTFBRD = DIVISOR_64 % 64;
    UARTLCRH = UARTLCRH_WLEN_8 | UARTLCRH_FEN;
    UARTCTL = UARTCTL_UARTEN | UARTCTL_TXE;
}

int board_begin(void)
{
    const int error = clock_begin();
    RCGC1 |= RCGC1_UART0 | RCGC1_SSI0;
    RCGC2 |= RCGC2_GPIOA | RCGC2_GPIOC | RCGC2_GPIOD | RCGC2_GPIOF;
    (void)RCGC2; /* three cycles pass before the blocks may be used */
    (void)RCGC2;
    uart_begin();
    GPIOPUR(GPIO_F) |= BUTTON;
    GPIODEN(GPIO_F) |= BUTTON;
    SYST_RVR = SYST_BITS;
    SYST_CVR = 0;
    SYST_CSR = SYST_CSR_CLKSOURCE | SYST_CSR_ENABLE;
    last_value = SYST_CVR;
    return error;
}

uint32_t board_cycles(void)
{
    const uint32_t value = SYST_CVR;
    counted += (last_value - value) & SYST_BITS;
    last_value = value;
    return counted;
}

void board_delay_us(uint32_t us)
{
    const uint32_t start = board_cycles();
    while (board_cycles() - start < us * (BOARD_CLOCK_HZ / 1000000)) {
    }
}

bool board_button_pressed(void)
{
    return GPIODATA(GPIO_F, BUTTON) == 0;
}

void board_text(const char *text)
{
    for (; *text; text++) {
        while (UARTFR & UARTFR_TXFF) {
        }
        UARTDR = (uint8_t)*text;
    }
}

void board_value(const char *name, uint32_t value)
{
    char digits[DECIMAL_CHARS];
    board_text(name);
    board_text(" ");
    board_text(decimal(value, digits));
    board_text("\r\n");
}
