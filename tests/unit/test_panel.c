/* SPDX-License-Identifier: MIT */
/*
 * The panel model's bus: clock and bytes, select, D/C, reset, I2C, and the text of event streams. What the controllers
 * refuse is in test_panel_dcs.c and test_panel_oled.c.
 */
#include "tests/unit/panel_stream.h"

#include <stdio.h>

/* A byte over clock and data, with this half period; D/C as it is. */
static void clock_bits(uint8_t byte, int bits, uint64_t half_ns)
{
    for (int i = 0; i < bits; i++) {
        panel_line(p, now, PANEL_MOSI, byte >> (7 - i) & 1);
        wait_ns(half_ns);
        panel_line(p, now, PANEL_SCK, true);
        wait_ns(half_ns);
        panel_line(p, now, PANEL_SCK, false);
    }
}

static void bytes_come_over_the_clock(void **state)
{
    (void)state;
    open_panel(PANEL_ST7789, 240, 240);
    panel_line(p, now, PANEL_DC, false);
    clock_bits(0x36, 8, 33); /* MADCTL */
    panel_line(p, now, PANEL_DC, true);
    clock_bits(0x00, 8, 33);
    assert_int_equal(panel_bytes(p), 2);
    panel_end(p, now);
    assert_clean();
}

static void other_panels_bytes_are_not_taken(void **state)
{
    (void)state;
    open_panel(PANEL_ST7789, 240, 240);
    panel_line(p, now, PANEL_CS, true);
    clock_bits(0x02, 8, 5);
    panel_byte(p, now, 0x02);
    assert_int_equal(panel_bytes(p), 0);
    assert_clean();
}

static void a_clock_above_the_limit_is_refused(void **state)
{
    (void)state;
    static const struct {
        enum panel_kind kind;
        uint16_t width_px, height_px;
        uint64_t half_ns; /* just allowed */
        uint8_t nop;
    } cases[] = {{PANEL_ST7789, 240, 240, 8, 0x00},
                 {PANEL_ILI9341, 240, 320, 50, 0x00},
                 {PANEL_SSD0323, 128, 64, 125, 0xe3},
                 {PANEL_SSD1306, 128, 64, 50, 0xe3}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        open_panel(cases[i].kind, cases[i].width_px, cases[i].height_px);
        clock_bits(cases[i].nop, 8, cases[i].half_ns);
        assert_clean();
        clock_bits(cases[i].nop, 8, cases[i].half_ns - 1);
        assert_refused("clock too fast: cycle");
        (void)close_panel(NULL);
    }
}

static void clock_pulses_too_short_are_refused(void **state)
{
    (void)state;
    open_panel(PANEL_ST7789, 240, 240);
    panel_line(p, now, PANEL_SCK, true);
    wait_ns(6);
    panel_line(p, now, PANEL_SCK, false);
    assert_refused("high of 6 ns");
    (void)close_panel(NULL);
    open_panel(PANEL_ST7789, 240, 240);
    panel_line(p, now, PANEL_SCK, true);
    wait_ns(60);
    panel_line(p, now, PANEL_SCK, false);
    wait_ns(6);
    panel_line(p, now, PANEL_SCK, true);
    assert_refused("low of 6 ns");
}

static void select_raised_within_a_byte_is_refused(void **state)
{
    (void)state;
    open_panel(PANEL_ST7789, 240, 240);
    clock_bits(0xff, 5, 50);
    panel_line(p, now, PANEL_CS, true);
    assert_refused("select raised after 5 bits");
    panel_line(p, now, PANEL_CS, false);
    clock_bits(0x00, 8, 50); /* begins anew: NOP */
    assert_int_equal(panel_violations(p), 1);
}

static void dc_changed_within_a_byte_is_refused(void **state)
{
    (void)state;
    open_panel(PANEL_ST7789, 240, 240);
    clock_bits(0x00, 3, 50);
    panel_line(p, now, PANEL_DC, true);
    assert_refused("D/C changes after 3 bits");
}

static void a_stream_that_ends_within_a_byte_is_refused(void **state)
{
    (void)state;
    open_panel(PANEL_SSD1306, 128, 64);
    clock_bits(0xe3, 7, 50);
    panel_end(p, now);
    assert_refused("ends after 7 bits");
}

static void reset_needs_its_pulse(void **state)
{
    (void)state;
    static const struct {
        enum panel_kind kind;
        uint64_t pulse_ns;
    } cases[] = {{PANEL_ST7789, 10 * US}, {PANEL_ILI9341, 10 * US}, {PANEL_SSD0323, 3 * US}, {PANEL_SSD1306, 3 * US}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        open_panel(cases[i].kind, 64, 64);
        panel_line(p, now, PANEL_RESET, false);
        wait_ns(cases[i].pulse_ns);
        panel_line(p, now, PANEL_RESET, true);
        assert_clean();
        wait_ns(1 * MS);
        panel_line(p, now, PANEL_RESET, false);
        wait_ns(cases[i].pulse_ns - 1);
        panel_line(p, now, PANEL_RESET, true);
        assert_refused("too short");
        (void)close_panel(NULL);
    }
}

static void nothing_is_sent_during_reset(void **state)
{
    (void)state;
    open_panel(PANEL_SSD1306, 128, 64);
    panel_line(p, now, PANEL_RESET, false);
    wait_ns(1 * US);
    command(0xe3);
    assert_refused("while reset is low");
}

static void commands_wait_for_reset(void **state)
{
    (void)state;
    static const struct {
        uint64_t wait_ns;
        enum panel_kind kind;
        uint8_t nop;
    } cases[] = {{5 * MS, PANEL_ST7789, 0x00},
                 {5 * MS, PANEL_ILI9341, 0x00},
                 {3 * US, PANEL_SSD0323, 0xe3},
                 {3 * US, PANEL_SSD1306, 0xe3}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        for (uint64_t early = 0; early < 2; early++) {
            open_panel(cases[i].kind, 64, 64);
            panel_line(p, now, PANEL_RESET, false);
            wait_ns(20 * US);
            panel_line(p, now, PANEL_RESET, true);
            wait_ns(cases[i].wait_ns - early);
            command(cases[i].nop);
            if (early) {
                assert_refused("too early after reset");
            } else {
                assert_clean();
            }
            (void)close_panel(NULL);
        }
    }
}

static void the_backlight_is_part_of_the_picture(void **state)
{
    (void)state;
    open_panel(PANEL_SSD1306, 128, 64);
    command(0xa5); /* all on */
    command(0xaf);
    assert_pixel(0, 0, 128, 255, 255, 255);
    panel_line(p, now, PANEL_BACKLIGHT, false);
    assert_pixel(0, 0, 128, 0, 0, 0);
    panel_line(p, now, PANEL_BACKLIGHT, true);
    assert_pixel(0, 0, 128, 255, 255, 255);
}

static void time_does_not_go_back(void **state)
{
    (void)state;
    open_panel(PANEL_ST7789, 240, 240);
    panel_line(p, now - 1, PANEL_DC, true);
    assert_refused("time goes back");
}

/* ------------------------------------------------------------------------------------------------------------- I2C */

#define BYTE_NS 22500

static void i2c_bytes(int count, ...)
{
    va_list bytes;
    va_start(bytes, count);
    panel_i2c_start(p, now);
    for (int i = 0; i < count; i++) {
        wait_ns(BYTE_NS);
        panel_i2c_byte(p, now, (uint8_t)va_arg(bytes, int));
    }
    va_end(bytes);
}

static void i2c_transfers_carry_commands_and_data(void **state)
{
    (void)state;
    open_panel(PANEL_SSD1306, 128, 64);
    i2c_bytes(5, 0x78, 0x00, 0xaf, 0xa1, 0xc8); /* control byte 00: commands to the end */
    panel_i2c_stop(p, now);
    i2c_bytes(7, 0x7a, 0x80, 0xb0, 0x80, 0x00, 0x40, 0x01); /* two commands one by one, then data; second address */
    panel_i2c_stop(p, now);
    panel_end(p, now);
    assert_clean();
    assert_pixel(0, 0, 128, 255, 255, 255);
    assert_pixel(0, 1, 128, 0, 0, 0);
    assert_int_equal(panel_bytes(p), 6);
}

static void i2c_of_other_devices_is_passed_over(void **state)
{
    (void)state;
    open_panel(PANEL_SSD1306, 128, 64);
    i2c_bytes(3, 0xa0, 0xff, 0xff);
    panel_i2c_stop(p, now);
    assert_int_equal(panel_bytes(p), 0);
    assert_clean();
}

static void i2c_mistakes_are_refused(void **state)
{
    (void)state;
    open_panel(PANEL_SSD1306, 128, 64);
    panel_i2c_byte(p, now, 0x78);
    assert_refused("without a start");
    (void)close_panel(NULL);
    open_panel(PANEL_SSD1306, 128, 64);
    panel_i2c_stop(p, now);
    assert_refused("stop without a start");
    (void)close_panel(NULL);
    open_panel(PANEL_SSD1306, 128, 64);
    i2c_bytes(2, 0x78, 0x41);
    assert_refused("control byte 41");
    (void)close_panel(NULL);
    open_panel(PANEL_SSD1306, 128, 64);
    i2c_bytes(2, 0x78, 0x80);
    panel_i2c_stop(p, now);
    assert_refused("announces another");
    (void)close_panel(NULL);
    open_panel(PANEL_SSD1306, 128, 64);
    i2c_bytes(1, 0x79);
    assert_refused("read");
    (void)close_panel(NULL);
    open_panel(PANEL_SSD0323, 128, 64);
    panel_i2c_start(p, now);
    assert_refused("has none");
    (void)close_panel(NULL);
    open_panel(PANEL_SSD1306, 128, 64);
    i2c_bytes(2, 0x78, 0x00);
    wait_ns(BYTE_NS - 1);
    panel_i2c_byte(p, now, 0xe3);
    assert_refused("22.5 at least");
}

/* ------------------------------------------------------------------------------------------------------------ the rest
 */

static void event_lines_are_read(void **state)
{
    (void)state;
    static const char *const good[] = {"1000000000 reset 1",
                                       "# a remark",
                                       "",
                                       "   ",
                                       "1000000001 cs 0",
                                       "1000000001 dc 0",
                                       "1000000002 byte e3",
                                       "1000000003 sck 1",
                                       "1000000103 sck 0",
                                       "1000000104 mosi 1",
                                       "1000000105 backlight 1"};
    static const char *const bad[] = {"sck 1",        "1 sck 2",  "1 byte 1",     "1 byte 123", "1 byte zz", "1 led 1",
                                      "1 i2c middle", "-1 sck 1", "1 sck 1 more", "1 sck",      "x"};
    open_panel(PANEL_SSD1306, 128, 64);
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        assert_true(panel_event(p, good[i]));
    }
    assert_int_equal(panel_bytes(p), 1);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(panel_event(p, bad[i]));
    }
    assert_true(panel_event(p, "1000000200 i2c start"));
    assert_true(panel_event(p, "1000000300 i2c 78"));
    assert_true(panel_event(p, "1000000400 i2c stop"));
    assert_clean();
}

static void a_panel_without_select_events_takes_bytes(void **state)
{
    (void)state;
    p = panel_open(PANEL_SSD1306, 128, 64);
    panel_byte(p, 1, 0xaf);
    assert_int_equal(panel_bytes(p), 1);
}

static void sizes_beyond_the_memory_are_refused(void **state)
{
    (void)state;
    p = NULL;
    assert_null(panel_open(PANEL_ST7789, 241, 240));
    assert_null(panel_open(PANEL_ILI9341, 240, 321));
    assert_null(panel_open(PANEL_SSD0323, 128, 81));
    assert_null(panel_open(PANEL_SSD1306, 129, 64));
    assert_null(panel_open(PANEL_SSD1306, 0, 64));
    panel_close(NULL);
}

static void violations_beyond_those_kept_are_counted(void **state)
{
    (void)state;
    open_panel(PANEL_SSD1306, 128, 64);
    for (int i = 0; i < 1001; i++) {
        command(0xff);
    }
    assert_int_equal(panel_violations(p), 1001);
    assert_string_equal(panel_violation(p, 0), "1000000000: unknown command ff");
    assert_string_equal(panel_violation(p, 1000), "(more than are kept)");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(bytes_come_over_the_clock, close_panel),
        cmocka_unit_test_teardown(other_panels_bytes_are_not_taken, close_panel),
        cmocka_unit_test_teardown(a_clock_above_the_limit_is_refused, close_panel),
        cmocka_unit_test_teardown(clock_pulses_too_short_are_refused, close_panel),
        cmocka_unit_test_teardown(select_raised_within_a_byte_is_refused, close_panel),
        cmocka_unit_test_teardown(dc_changed_within_a_byte_is_refused, close_panel),
        cmocka_unit_test_teardown(a_stream_that_ends_within_a_byte_is_refused, close_panel),
        cmocka_unit_test_teardown(reset_needs_its_pulse, close_panel),
        cmocka_unit_test_teardown(nothing_is_sent_during_reset, close_panel),
        cmocka_unit_test_teardown(commands_wait_for_reset, close_panel),
        cmocka_unit_test_teardown(the_backlight_is_part_of_the_picture, close_panel),
        cmocka_unit_test_teardown(time_does_not_go_back, close_panel),
        cmocka_unit_test_teardown(i2c_transfers_carry_commands_and_data, close_panel),
        cmocka_unit_test_teardown(i2c_of_other_devices_is_passed_over, close_panel),
        cmocka_unit_test_teardown(i2c_mistakes_are_refused, close_panel),
        cmocka_unit_test_teardown(event_lines_are_read, close_panel),
        cmocka_unit_test_teardown(a_panel_without_select_events_takes_bytes, close_panel),
        cmocka_unit_test_teardown(sizes_beyond_the_memory_are_refused, close_panel),
        cmocka_unit_test_teardown(violations_beyond_those_kept_are_counted, close_panel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
