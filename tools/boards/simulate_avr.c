/* SPDX-License-Identifier: MIT */
/*
 * simulate FIRMWARE.elf FOLDER: runs examples/avr_ssd1306 in simavr, an ATmega1284P at 16 MHz, with two panels on its
 * two-wire interface: simavr's own model of the SSD1306, and ours of tests/panel. Ends when the firmware says that its
 * lamp has gone round. Writes what each panel shows, simavr.panel.ppm and decoder.panel.ppm, and prints as lines
 * "name value" what the firmware said, cycles by its marks, the bytes that the panel took, and violations.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <avr_ioport.h>
#include <avr_twi.h>
#include <avr_uart.h>
#include <sim_avr.h>
#include <sim_elf.h>
#include <ssd1306_virt.h>

#include "examples/avr_ssd1306/board.h"
#include "tests/panel/panel.h"
#include "tools/picture/picture.h"

#define WIDTH_PX 128
#define HEIGHT_PX 64
#define RESET_PIN 2 /* of port B */
#define TWBR_ADDRESS 0xb8
#define TWSR_ADDRESS 0xb9
#define MOST_CYCLES ((avr_cycle_count_t)BOARD_CLOCK_HZ * 600) /* ten minutes of the processor's time */

typedef struct simulation {
    avr_t *avr;
    ssd1306_t part;
    panel *decoder;
    uint8_t marks;
    avr_cycle_count_t marked_at, drawing, sending, bus_at;
    char line[80];
    size_t line_length;
    bool finished, failed;
} simulation;

static uint64_t now_ns(const simulation *s)
{
    return s->avr->cycle * 1000 / (BOARD_CLOCK_HZ / 1000000);
}

static void on_mark(struct avr_irq_t *irq, uint32_t value, void *context)
{
    simulation *s = context;
    const avr_cycle_count_t since = s->avr->cycle - s->marked_at;
    if (s->marks & 1 << MARK_SENDING) {
        s->sending += since;
    } else if (s->marks & 1 << MARK_DRAWING) {
        s->drawing += since;
    }
    s->marked_at = s->avr->cycle;
    s->marks = (uint8_t)(value ? s->marks | 1 << irq->irq : s->marks & ~(1 << irq->irq));
}

static void on_reset_line(struct avr_irq_t *irq, uint32_t value, void *context)
{
    (void)irq;
    simulation *s = context;
    panel_line(s->decoder, now_ns(s), PANEL_RESET, value != 0);
}

/*
 * simavr 1.6 has bytes leave in no time. So the processor's clock is put forward by what is missing of `bits` at the
 * rate that the firmware has set (ATmega1284P data sheet, 22.5.2) since the message before.
 */
static void take_bus_time(simulation *s, uint32_t bits)
{
    const uint32_t prescaler = UINT32_C(1) << 2 * (s->avr->data[TWSR_ADDRESS] & 3);
    const uint32_t cycles = bits * (16 + 2 * s->avr->data[TWBR_ADDRESS] * prescaler);
    const avr_cycle_count_t since = s->avr->cycle - s->bus_at;
    s->avr->cycle += since < cycles ? cycles - since : 0;
    s->bus_at = s->avr->cycle;
}

/* A start comes together with the address behind it. */
static void on_bus(struct avr_irq_t *irq, uint32_t value, void *context)
{
    (void)irq;
    simulation *s = context;
    avr_twi_msg_irq_t message;
    message.u.v = value;
    if (message.u.twi.msg & TWI_COND_START) {
        s->bus_at = s->avr->cycle;
        take_bus_time(s, 10);
        panel_i2c_start(s->decoder, now_ns(s));
        panel_i2c_byte(s->decoder, now_ns(s), (uint8_t)message.u.twi.addr);
    }
    if (message.u.twi.msg & TWI_COND_WRITE) {
        take_bus_time(s, 9);
        panel_i2c_byte(s->decoder, now_ns(s), (uint8_t)message.u.twi.data);
    }
    if (message.u.twi.msg & TWI_COND_STOP) {
        take_bus_time(s, 1);
        panel_i2c_stop(s->decoder, now_ns(s));
    }
}

static void on_text(struct avr_irq_t *irq, uint32_t value, void *context)
{
    (void)irq;
    simulation *s = context;
    if (value == '\r') {
        return;
    }
    if (value != '\n') {
        if (s->line_length + 1 < sizeof s->line) {
            s->line[s->line_length++] = (char)value;
        }
        return;
    }
    s->line[s->line_length] = '\0';
    s->line_length = 0;
    puts(s->line);
    s->failed = s->failed || strncmp(s->line, "error", 5) == 0;
    s->finished = s->failed || strcmp(s->line, "round") == 0;
}

static bool connect(simulation *s)
{
    avr_t *avr = s->avr;
    ssd1306_wiring_t wiring = {.reset = {'B', RESET_PIN}};
    uint32_t flags = 0; /* no copy of the text on the terminal */
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    ssd1306_init(avr, &s->part, WIDTH_PX, HEIGHT_PX);
    ssd1306_connect_twi(&s->part, &wiring);
    avr_irq_t *const uart = avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT);
    avr_irq_t *const bus = avr_io_getirq(avr, AVR_IOCTL_TWI_GETIRQ(0), TWI_IRQ_OUTPUT);
    if (uart == NULL || bus == NULL) {
        return false;
    }
    avr_irq_register_notify(uart, on_text, s);
    avr_irq_register_notify(bus, on_bus, s);
    for (uint32_t pin = MARK_DRAWING; pin <= MARK_SENDING; pin++) {
        avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('B'), (int)pin), on_mark, s);
    }
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('B'), RESET_PIN), on_reset_line, s);
    return true;
}

/* What simavr's model shows: its flags say which way the module's wires are to be read, as its own window on a desktop
 * does: upright with segments and COMs reversed. */
static void simavr_picture(ssd1306_t *part, uint8_t *rgb)
{
    const bool mirrored = ssd1306_get_flag(part, SSD1306_FLAG_SEGMENT_REMAP_0);
    const bool upside_down = ssd1306_get_flag(part, SSD1306_FLAG_COM_SCAN_NORMAL);
    const bool inverted = ssd1306_get_flag(part, SSD1306_FLAG_DISPLAY_INVERTED);
    for (unsigned y = 0; y < HEIGHT_PX; y++) {
        for (unsigned x = 0; x < WIDTH_PX; x++, rgb += 3) {
            const unsigned column = mirrored ? WIDTH_PX - 1 - x : x, row = upside_down ? HEIGHT_PX - 1 - y : y;
            const bool lit = (part->vram[row / 8][column] >> row % 8 & 1) != inverted;
            memset(rgb, ssd1306_get_flag(part, SSD1306_FLAG_DISPLAY_ON) && lit ? 255 : 0, 3);
        }
    }
}

static int write_picture(const char *folder, const char *name, picture *p)
{
    char path[512], error[256];
    (void)snprintf(path, sizeof path, "%s/%s.panel.ppm", folder, name);
    if (picture_write(path, p, error, sizeof error)) {
        (void)fprintf(stderr, "simulate: %s\n", error);
        return 1;
    }
    return 0;
}

static int finish(simulation *s, const char *folder)
{
    picture p;
    char error[256];
    panel_end(s->decoder, now_ns(s));
    if (picture_create(&p, WIDTH_PX, HEIGHT_PX, error, sizeof error)) {
        (void)fprintf(stderr, "simulate: %s\n", error);
        return 1;
    }
    simavr_picture(&s->part, p.rgb);
    int status = write_picture(folder, "simavr", &p);
    memcpy(p.rgb, panel_picture(s->decoder), (size_t)WIDTH_PX * HEIGHT_PX * 3);
    status |= write_picture(folder, "decoder", &p);
    picture_free(&p);
    printf("frames %lu\ndraw_cycles %llu\nsend_cycles %llu\nbytes %llu\nviolations %lu\n",
           (unsigned long)panel_frames(s->decoder), (unsigned long long)s->drawing, (unsigned long long)s->sending,
           (unsigned long long)panel_bytes(s->decoder), (unsigned long)panel_violations(s->decoder));
    for (size_t i = 0; i < panel_violations(s->decoder) && i < 20; i++) {
        (void)fprintf(stderr, "violation %s\n", panel_violation(s->decoder, i));
    }
    return status || s->failed;
}

int main(int count, char **words)
{
    static simulation s;
    elf_firmware_t firmware = {0};
    if (count != 3 || elf_read_firmware(words[1], &firmware) != 0) {
        (void)fputs("usage: simulate FIRMWARE.elf FOLDER\n", stderr);
        return 2;
    }
    s.avr = avr_make_mcu_by_name("atmega1284p");
    s.decoder = panel_open(PANEL_SSD1306, WIDTH_PX, HEIGHT_PX);
    if (s.avr == NULL || s.decoder == NULL) {
        (void)fputs("simulate: this simavr has no ATmega1284P\n", stderr);
        return 2;
    }
    avr_init(s.avr);
    firmware.frequency = BOARD_CLOCK_HZ;
    avr_load_firmware(s.avr, &firmware);
    if (!connect(&s)) {
        (void)fputs("simulate: this simavr has no such UART or bus\n", stderr);
        return 2;
    }
    int state = cpu_Running;
    while (!s.finished && state != cpu_Done && state != cpu_Crashed && s.avr->cycle < MOST_CYCLES) {
        state = avr_run(s.avr);
    }
    if (!s.finished) {
        (void)fputs("simulate: the lamp did not come round\n", stderr);
        return 1;
    }
    return finish(&s, words[2]);
}
