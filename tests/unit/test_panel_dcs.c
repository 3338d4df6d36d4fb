/* SPDX-License-Identifier: MIT */
/*
 * The panel model's ST7789 and ILI9341: what they refuse, and what is seen.
 */
#include "tests/unit/panel_stream.h"

enum { SWRESET = 0x01, RDDID = 0x04, SLPIN = 0x10, SLPOUT = 0x11, INVON = 0x21, DISPOFF = 0x28, DISPON = 0x29 };
enum { CASET = 0x2a, RASET = 0x2b, RAMWR = 0x2c, MADCTL = 0x36, COLMOD = 0x3a, RAMWRC = 0x3c };

/* Awake, on, its colours right, 16 bits a pixel. */
static void open_ready(enum panel_kind kind, uint16_t width_px, uint16_t height_px)
{
    open_panel(kind, width_px, height_px);
    command(SLPOUT);
    wait_ns(120 * MS);
    command_with(COLMOD, 1, 0x55);
    if (kind == PANEL_ST7789) {
        command(INVON);
    } else {
        command_with(MADCTL, 1, 0x08);
    }
    command(DISPON);
}

static void window(int x_first, int y_first, int x_last, int y_last)
{
    command_with(CASET, 4, x_first >> 8, x_first & 255, x_last >> 8, x_last & 255);
    command_with(RASET, 4, y_first >> 8, y_first & 255, y_last >> 8, y_last & 255);
    command(RAMWR);
}

static void pixel(unsigned value)
{
    data((uint8_t)(value >> 8));
    data((uint8_t)value);
}

static void commands_wait_for_sleep_out(void **state)
{
    (void)state;
    for (uint64_t early = 0; early < 2; early++) {
        open_panel(PANEL_ST7789, 240, 240);
        command(SLPOUT);
        wait_ns(5 * MS - early);
        command(DISPON);
        if (early) {
            assert_refused("too early after SLPOUT");
        } else {
            assert_clean();
        }
        (void)close_panel(NULL);
    }
    for (uint64_t early = 0; early < 2; early++) {
        open_panel(PANEL_ILI9341, 240, 320);
        command(SLPOUT);
        wait_ns(120 * MS - early);
        command(SLPIN);
        if (early) {
            assert_refused("SLPIN 0.000 ms too early after SLPOUT");
        } else {
            assert_clean();
        }
        (void)close_panel(NULL);
    }
}

static void sleep_out_waits_for_reset(void **state)
{
    (void)state;
    for (uint64_t early = 0; early < 2; early++) {
        open_panel(PANEL_ST7789, 240, 240);
        panel_line(p, now, PANEL_RESET, false);
        wait_ns(10 * US);
        panel_line(p, now, PANEL_RESET, true);
        wait_ns(120 * MS - early);
        command(SLPOUT);
        if (early) {
            assert_refused("SLPOUT 0.000 ms too early after reset");
        } else {
            assert_clean();
        }
        (void)close_panel(NULL);
        open_panel(PANEL_ST7789, 240, 240);
        command(SWRESET);
        wait_ns(120 * MS - early);
        command(SLPOUT);
        if (early) {
            assert_refused("after the software reset");
        } else {
            assert_clean();
        }
        (void)close_panel(NULL);
    }
    open_panel(PANEL_ST7789, 240, 240);
    command(SWRESET);
    wait_ns(5 * MS - 1);
    command(0x00);
    assert_refused("byte 00 0.000 ms too early after the software reset");
}

static void unknown_commands_are_refused(void **state)
{
    (void)state;
    open_panel(PANEL_ST7789, 240, 240);
    command_with(0x02, 1, 0x00);
    assert_refused("unknown command 02");
    (void)close_panel(NULL);
    open_panel(PANEL_ILI9341, 240, 320);
    command_with(0xe4, 3, 0, 0, 0); /* the ST7789 has it */
    assert_refused("unknown command e4");
    (void)close_panel(NULL);
    open_panel(PANEL_ST7789, 240, 240);
    data(0x12);
    assert_refused("before any command");
}

static void what_is_not_modelled_is_told_of(void **state)
{
    (void)state;
    open_panel(PANEL_ST7789, 240, 240);
    command(0x39);
    assert_refused("IDMON: not modelled");
    (void)close_panel(NULL);
    open_panel(PANEL_ST7789, 240, 240);
    command_with(0x37, 2, 0, 8);
    assert_refused("scrolling");
    (void)close_panel(NULL);
    open_panel(PANEL_ST7789, 240, 240);
    command_with(0xb0, 2, 0x00, 0xf8);
    assert_refused("low byte first");
    (void)close_panel(NULL);
    open_panel(PANEL_ILI9341, 240, 320);
    command_with(0xf6, 3, 0x01, 0x00, 0x20);
    assert_refused("low byte first");
}

static void arguments_are_counted(void **state)
{
    (void)state;
    open_panel(PANEL_ST7789, 240, 240);
    command_with(CASET, 3, 0, 0, 0);
    command(0x00);
    assert_refused("CASET ends after 3 of 4");
    (void)close_panel(NULL);
    open_panel(PANEL_ST7789, 240, 240);
    command_with(MADCTL, 2, 0, 0);
    assert_refused("MADCTL takes 1 arguments, here is another");
    (void)close_panel(NULL);
    open_panel(PANEL_ST7789, 240, 240);
    command(COLMOD);
    panel_end(p, now);
    assert_refused("COLMOD ends after 0 of 1");
}

static void windows_are_checked(void **state)
{
    (void)state;
    open_panel(PANEL_ST7789, 240, 240);
    command_with(CASET, 4, 0, 10, 0, 9);
    assert_refused("reversed: 10 to 9");
    (void)close_panel(NULL);
    open_panel(PANEL_ST7789, 240, 240);
    command_with(CASET, 4, 0, 0, 0, 239);
    command_with(RASET, 4, 0, 0, 1, 63);
    assert_clean();
    command_with(CASET, 4, 0, 0, 0, 240);
    assert_refused("the last is 239");
    (void)close_panel(NULL);
    open_panel(PANEL_ILI9341, 240, 320);
    command_with(MADCTL, 1, 0x28);
    command_with(CASET, 4, 0, 0, 1, 63);
    assert_clean();
    command_with(RASET, 4, 0, 0, 0, 240);
    assert_refused("the last is 239");
}

static void the_window_holds_no_more(void **state)
{
    (void)state;
    open_ready(PANEL_ST7789, 240, 240);
    window(0, 0, 1, 1);
    for (int i = 0; i < 4; i++) {
        pixel(0xffff);
    }
    assert_clean();
    pixel(0xffff);
    pixel(0xffff);
    assert_refused("window of 4");
}

static void a_rotation_after_the_window_is_refused(void **state)
{
    (void)state;
    open_ready(PANEL_ST7789, 240, 240);
    command_with(RASET, 4, 1, 0, 1, 0); /* row 256 ... */
    command_with(MADCTL, 1, 0x20);      /* ... becomes a column */
    command(RAMWR);
    pixel(0);
    assert_refused("outside of the memory");
}

static void pixels_are_whole(void **state)
{
    (void)state;
    open_ready(PANEL_ST7789, 240, 240);
    window(0, 0, 0, 0);
    data(0xff);
    command(0x00);
    assert_refused("ends within a pixel of 16 bits");
    (void)close_panel(NULL);
    open_ready(PANEL_ST7789, 240, 240);
    window(0, 0, 1, 0);
    pixel(0xffff);
    command(0x00);
    command(RAMWRC); /* goes on */
    pixel(0xffff);
    panel_end(p, now);
    assert_clean();
}

/* 16-bit pixels while COLMOD is still at its 18 bits of reset: the window is left part filled. */
static void a_wrong_pixel_size_is_seen(void **state)
{
    (void)state;
    open_panel(PANEL_ST7789, 240, 240);
    command(SLPOUT);
    wait_ns(120 * MS);
    window(0, 0, 2, 0);
    for (int i = 0; i < 3; i++) {
        pixel(0xffff);
    }
    window(0, 0, 2, 0);
    assert_refused("after 2 of 3 pixels: is COLMOD right?");
    (void)close_panel(NULL);
    open_panel(PANEL_ILI9341, 240, 320);
    command_with(COLMOD, 1, 0x53);
    assert_refused("COLMOD 53");
}

static void pixel_formats_are_read(void **state)
{
    (void)state;
    open_ready(PANEL_ST7789, 240, 240);
    window(0, 0, 1, 0);
    pixel(0x8410);
    pixel(0xf800);
    assert_pixel(0, 0, 240, 132, 130, 132);
    assert_pixel(1, 0, 240, 255, 0, 0);
    command_with(COLMOD, 1, 0x66);
    window(0, 0, 0, 0);
    data(0xfc);
    data(0x80);
    data(0x04);
    assert_pixel(0, 0, 240, 255, 130, 4);
    command_with(COLMOD, 1, 0x53);
    window(0, 0, 1, 0);
    data(0x12);
    data(0x3f);
    data(0x0a);
    assert_pixel(0, 0, 240, 17, 34, 51);
    assert_pixel(1, 0, 240, 255, 0, 170);
    window(0, 0, 0, 0); /* one pixel of 12 bits: its second byte is half used */
    data(0x12);
    data(0x30);
    panel_end(p, now);
    assert_clean();
}

static void rotations_place_pixels(void **state)
{
    (void)state;
    static const struct {
        int madctl, x, y;          /* of the host */
        unsigned glass_x, glass_y; /* on the glass of 240 x 320 */
    } cases[] = {
        {0x00, 3, 5, 3, 5}, {0x40, 3, 5, 236, 5}, {0x80, 3, 5, 3, 314}, {0xc0, 3, 5, 236, 314},
        {0x20, 3, 5, 5, 3}, {0x60, 3, 5, 234, 3}, {0xa0, 3, 5, 5, 316}, {0xe0, 300, 5, 234, 19},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        open_ready(PANEL_ILI9341, 240, 320);
        command_with(MADCTL, 1, cases[i].madctl | 0x08);
        window(cases[i].x, cases[i].y, cases[i].x, cases[i].y);
        pixel(0x001f);
        assert_pixel(cases[i].glass_x, cases[i].glass_y, 240, 0, 0, 255);
        assert_clean();
        (void)close_panel(NULL);
    }
}

static void the_glass_has_a_place_and_colours(void **state)
{
    (void)state;
    open_ready(PANEL_ST7789, 240, 240);
    panel_glass glass = panel_usual_glass(PANEL_ST7789);
    glass.y_px = 80;
    panel_set_glass(p, &glass);
    window(0, 80, 0, 80);
    pixel(0xf800);
    assert_pixel(0, 0, 240, 255, 0, 0);
    command_with(MADCTL, 1, 0x08);
    assert_pixel(0, 0, 240, 0, 0, 255);
    command(0x20); /* INVOFF on an IPS glass */
    assert_pixel(0, 0, 240, 255, 255, 0);
    assert_clean();
}

static void off_and_asleep_is_dark(void **state)
{
    (void)state;
    open_ready(PANEL_ST7789, 240, 240);
    window(0, 0, 0, 0);
    pixel(0xffff);
    command(DISPOFF);
    assert_pixel(0, 0, 240, 0, 0, 0);
    command(DISPON);
    assert_pixel(0, 0, 240, 255, 255, 255);
    command(SLPIN);
    assert_pixel(0, 0, 240, 0, 0, 0);
}

static void frames_end_at_the_last_pixel_of_the_glass(void **state)
{
    (void)state;
    open_ready(PANEL_ST7789, 240, 240);
    window(238, 239, 239, 239);
    pixel(0);
    assert_int_equal(panel_frames(p), 0);
    pixel(0);
    assert_int_equal(panel_frames(p), 1);
    command_with(MADCTL, 1, 0xc0); /* turned by half: the glass is now rows 80 .. 319 of the host */
    window(239, 319, 239, 319);
    pixel(0);
    assert_int_equal(panel_frames(p), 2);
    assert_clean();
}

static void answers_take_any_clocks(void **state)
{
    (void)state;
    open_panel(PANEL_ILI9341, 240, 320);
    command(RDDID);
    for (int i = 0; i < 7; i++) {
        data(0);
    }
    panel_line(p, now, PANEL_SCK, true); /* a dummy clock */
    panel_line(p, now, PANEL_CS, true);
    assert_clean();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(commands_wait_for_sleep_out, close_panel),
        cmocka_unit_test_teardown(sleep_out_waits_for_reset, close_panel),
        cmocka_unit_test_teardown(unknown_commands_are_refused, close_panel),
        cmocka_unit_test_teardown(what_is_not_modelled_is_told_of, close_panel),
        cmocka_unit_test_teardown(arguments_are_counted, close_panel),
        cmocka_unit_test_teardown(windows_are_checked, close_panel),
        cmocka_unit_test_teardown(the_window_holds_no_more, close_panel),
        cmocka_unit_test_teardown(a_rotation_after_the_window_is_refused, close_panel),
        cmocka_unit_test_teardown(pixels_are_whole, close_panel),
        cmocka_unit_test_teardown(a_wrong_pixel_size_is_seen, close_panel),
        cmocka_unit_test_teardown(pixel_formats_are_read, close_panel),
        cmocka_unit_test_teardown(rotations_place_pixels, close_panel),
        cmocka_unit_test_teardown(the_glass_has_a_place_and_colours, close_panel),
        cmocka_unit_test_teardown(off_and_asleep_is_dark, close_panel),
        cmocka_unit_test_teardown(frames_end_at_the_last_pixel_of_the_glass, close_panel),
        cmocka_unit_test_teardown(answers_take_any_clocks, close_panel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
