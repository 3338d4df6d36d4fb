/* SPDX-License-Identifier: MIT */
/*
 * The panel model's SSD0323 and SSD1306: what they refuse, and what is seen.
 */
#include "tests/unit/panel_stream.h"

/* A command whose arguments are commands too. */
static void commands(int count, ...)
{
    va_list bytes;
    va_start(bytes, count);
    for (int i = 0; i < count; i++) {
        command((uint8_t)va_arg(bytes, int));
    }
    va_end(bytes);
}

/* As the usual module wants them, on. */
static void open_grey(void)
{
    open_panel(PANEL_SSD0323, 128, 64);
    commands(7, 0xa0, 0x52, 0xa2, 76, 0xa8, 63, 0xaf);
}

static void open_mono(void)
{
    open_panel(PANEL_SSD1306, 128, 64);
    commands(3, 0xa1, 0xc8, 0xaf);
}

static void assert_grey(unsigned x, unsigned y, uint8_t grey)
{
    assert_pixel(x, y, 128, grey, grey, grey);
}

static void greys_are_read(void **state)
{
    (void)state;
    open_grey();
    commands(6, 0x15, 1, 2, 0x75, 10, 11);
    data(0x5f);
    data(0x10);
    data(0x23);
    data(0x00);
    assert_grey(2, 10, 5 * 17);
    assert_grey(3, 10, 255);
    assert_grey(4, 10, 17);
    assert_grey(2, 11, 2 * 17);
    panel_end(p, now);
    assert_clean();
}

static void the_ssd0323_re_maps(void **state)
{
    (void)state;
    open_grey();
    commands(8, 0xa0, 0x50, 0x15, 0, 0, 0x75, 0, 0); /* without the nibble re-map the low half is left */
    data(0x5f);
    assert_grey(0, 0, 255);
    assert_grey(1, 0, 5 * 17);
    commands(2, 0xa0, 0x51); /* mirrored */
    assert_grey(127, 0, 255);
    commands(2, 0xa0, 0x42); /* upside down */
    assert_grey(0, 63, 255);
    commands(2, 0xa0, 0x12); /* rows interleaved: row 1 of the glass shows what is in row 32 */
    assert_grey(0, 0, 255);
    commands(8, 0xa0, 0x12, 0x15, 0, 0, 0x75, 32, 32);
    data(0xf0);
    assert_grey(0, 1, 255);
    assert_clean();
    commands(2, 0xa0, 0x80);
    assert_refused("re-map 80");
}

static void the_ssd0323_counts_down_columns(void **state)
{
    (void)state;
    open_grey();
    commands(8, 0xa0, 0x56, 0x15, 0, 1, 0x75, 0, 1);
    data(0x10);
    data(0x20);
    data(0x30);
    data(0x40);
    assert_grey(0, 1, 2 * 17);
    assert_grey(2, 0, 3 * 17);
    assert_clean();
}

static void the_ssd0323_shifts_and_inverts(void **state)
{
    (void)state;
    open_grey();
    commands(6, 0x15, 0, 0, 0x75, 5, 5);
    data(0xf0);
    commands(2, 0xa1, 5);
    assert_grey(0, 0, 255);
    commands(4, 0xa1, 0, 0xa2, 76 - 4);
    assert_grey(0, 9, 255);
    commands(3, 0xa2, 76, 0xa7);
    assert_grey(0, 5, 0);
    assert_grey(0, 6, 255);
    command(0xa5);
    assert_grey(9, 9, 255); /* whatever was before */
    command(0xa6);
    assert_grey(9, 9, 0);
    commands(3, 0xa4, 0xa8, 31);
    assert_grey(0, 5, 255);
    assert_grey(0, 32, 0); /* not driven */
    command(0xae);
    assert_grey(0, 5, 0);
    assert_clean();
}

static void pages_are_read(void **state)
{
    (void)state;
    open_mono();
    commands(8, 0x20, 0, 0x21, 0, 127, 0x22, 0, 7);
    for (int i = 0; i < 1024; i++) {
        data(i == 129 ? 0x82 : 0x00);
    }
    assert_int_equal(panel_frames(p), 1);
    assert_grey(1, 9, 255);
    assert_grey(1, 15, 255);
    assert_grey(1, 8, 0);
    panel_end(p, now);
    assert_clean();
}

static void the_ssd1306_has_three_orders(void **state)
{
    (void)state;
    open_mono();
    commands(8, 0x20, 1, 0x21, 3, 4, 0x22, 1, 2); /* down the pages */
    data(0x01);
    data(0x02);
    data(0x04);
    data(0x08);
    assert_grey(3, 8, 255);
    assert_grey(3, 17, 255);
    assert_grey(4, 10, 255);
    assert_grey(4, 19, 255);
    commands(5, 0x20, 2, 0xb7, 0x1f, 0x0f); /* page 7, column 127 */
    data(0x01);
    data(0x01); /* round to column 0 of the same page */
    assert_grey(127, 56, 255);
    assert_grey(0, 56, 255);
    panel_end(p, now);
    assert_clean();
}

static void the_ssd1306_turns_and_shifts(void **state)
{
    (void)state;
    open_mono();
    commands(3, 0xb0, 0x00, 0x10);
    data(0x01);
    command(0xa0);
    assert_grey(127, 0, 255);
    command(0xc0);
    assert_grey(127, 63, 255);
    commands(3, 0xa1, 0xc8, 0x41);
    assert_grey(0, 63, 255);
    commands(3, 0x40, 0xd3, 2);
    assert_grey(0, 62, 255);
    commands(2, 0xd3, 0);
    commands(2, 0xda, 0x02); /* rows one after the other on an interleaved glass */
    assert_grey(0, 0, 255);
    assert_grey(0, 1, 0);
    commands(3, 0xda, 0x12, 0xa7);
    assert_grey(0, 0, 0);
    assert_grey(1, 1, 255);
    assert_clean();
    commands(2, 0xda, 0x10);
    assert_refused("COM pins 10");
}

static void areas_are_checked(void **state)
{
    (void)state;
    static const struct {
        enum panel_kind kind;
        int command, first, last;
        const char *words;
    } cases[] = {{PANEL_SSD0323, 0x15, 3, 2, "reversed: 3 to 2"},  {PANEL_SSD0323, 0x15, 0, 64, "the last is 63"},
                 {PANEL_SSD0323, 0x75, 0, 80, "the last is 79"},   {PANEL_SSD1306, 0x21, 9, 8, "reversed: 9 to 8"},
                 {PANEL_SSD1306, 0x21, 0, 128, "the last is 127"}, {PANEL_SSD1306, 0x22, 0, 8, "the last is 7"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        open_panel(cases[i].kind, 128, 64);
        commands(3, cases[i].command, cases[i].first, cases[i].last);
        assert_refused(cases[i].words);
        (void)close_panel(NULL);
    }
}

static void values_are_checked(void **state)
{
    (void)state;
    static const struct {
        enum panel_kind kind;
        int command, value;
        const char *words;
    } cases[] = {{PANEL_SSD0323, 0xa8, 14, "multiplex ratio 14"}, {PANEL_SSD1306, 0xa8, 64, "multiplex ratio 64"},
                 {PANEL_SSD0323, 0xa1, 80, "start line 80"},      {PANEL_SSD0323, 0xa2, 80, "display offset 80"},
                 {PANEL_SSD1306, 0xd3, 64, "display offset 64"},  {PANEL_SSD1306, 0x20, 3, "addressing mode 3"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        open_panel(cases[i].kind, 128, 64);
        commands(2, cases[i].command, cases[i].value);
        assert_refused(cases[i].words);
        (void)close_panel(NULL);
    }
}

static void areas_are_filled(void **state)
{
    (void)state;
    open_grey();
    commands(6, 0x15, 0, 63, 0x75, 0, 0);
    data(0);
    commands(3, 0x75, 0, 0);
    assert_refused("area of 64 bytes was left after 1");
    (void)close_panel(NULL);
    open_mono();
    commands(2, 0x20, 0);
    data(0);
    panel_end(p, now);
    assert_refused("area of 1024 bytes was left after 1");
}

static void commands_are_whole_and_known(void **state)
{
    (void)state;
    open_panel(PANEL_SSD0323, 128, 64);
    commands(2, 0x15, 0);
    data(0);
    assert_refused("data 00 within the command column address");
    (void)close_panel(NULL);
    open_panel(PANEL_SSD0323, 128, 64);
    command(0x15);
    panel_end(p, now);
    assert_refused("ends within the command column address");
    (void)close_panel(NULL);
    open_panel(PANEL_SSD0323, 128, 64);
    command(0x21); /* the SSD1306 has it */
    assert_refused("unknown command 21");
    (void)close_panel(NULL);
    open_panel(PANEL_SSD1306, 128, 64);
    command(0x90);
    assert_refused("unknown command 90");
    (void)close_panel(NULL);
    open_panel(PANEL_SSD1306, 128, 64);
    command(0x2f);
    assert_refused("scroll on: not modelled");
    (void)close_panel(NULL);
    open_panel(PANEL_SSD1306, 128, 64);
    commands(3, 0x20, 0, 0xb0);
    assert_refused("page: for the page addressing mode only");
}

static void a_reset_keeps_the_memory(void **state)
{
    (void)state;
    open_mono();
    commands(3, 0xb0, 0x00, 0x10);
    data(0x01);
    panel_line(p, now, PANEL_RESET, false);
    wait_ns(3 * US);
    panel_line(p, now, PANEL_RESET, true);
    wait_ns(3 * US);
    assert_grey(0, 0, 0); /* off */
    commands(3, 0xa1, 0xc8, 0xaf);
    assert_grey(0, 0, 255);
    assert_clean();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(greys_are_read, close_panel),
        cmocka_unit_test_teardown(the_ssd0323_re_maps, close_panel),
        cmocka_unit_test_teardown(the_ssd0323_counts_down_columns, close_panel),
        cmocka_unit_test_teardown(the_ssd0323_shifts_and_inverts, close_panel),
        cmocka_unit_test_teardown(pages_are_read, close_panel),
        cmocka_unit_test_teardown(the_ssd1306_has_three_orders, close_panel),
        cmocka_unit_test_teardown(the_ssd1306_turns_and_shifts, close_panel),
        cmocka_unit_test_teardown(areas_are_checked, close_panel),
        cmocka_unit_test_teardown(values_are_checked, close_panel),
        cmocka_unit_test_teardown(areas_are_filled, close_panel),
        cmocka_unit_test_teardown(commands_are_whole_and_known, close_panel),
        cmocka_unit_test_teardown(a_reset_keeps_the_memory, close_panel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
