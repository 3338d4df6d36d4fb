/* SPDX-License-Identifier: MIT */
/*
 * The drivers of the SSD0323 and the SSD1306 against the panel model: what they send is as the data sheets want it,
 * shows upright and turned, and errors of the board come through.
 */
#include "tests/unit/panel_stream.h"

#include "examples/panels/ssd0323.h"
#include "examples/panels/ssd1306.h"

#define BYTE_NS 4000
#define PORT_ERROR 77

/* The board: its calls reach the model; after `calls_left` of them they fail. */
static int calls_left;

static int call(void)
{
    return calls_left-- > 0 ? 0 : PORT_ERROR;
}

static int send(bool dc, const uint8_t *bytes, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        wait_ns(BYTE_NS);
        panel_line(p, now, PANEL_DC, dc);
        panel_byte(p, now, bytes[i]);
    }
    return call();
}

static int send_command(void *context, const uint8_t *bytes, uint32_t count)
{
    (void)context;
    return send(false, bytes, count);
}

static int send_data(void *context, const uint8_t *bytes, uint32_t count)
{
    (void)context;
    return send(true, bytes, count);
}

static int set_reset(void *context, bool high)
{
    (void)context;
    panel_line(p, now, PANEL_RESET, high);
    return call();
}

static int delay_us(void *context, uint32_t us)
{
    (void)context;
    wait_ns(us * US);
    return call();
}

static const panel_port port = {send_command, send_data, set_reset, delay_us, NULL};
static const panel_port port_without_reset = {send_command, send_data, NULL, delay_us, NULL};

static void open_board(enum panel_kind kind, uint16_t height_px)
{
    calls_left = 1000;
    open_panel(kind, 128, height_px);
}

/* Two pixels on a dark picture. */
static void send_grey_picture(const ssd0323 *oled, uint8_t *pixels, uint8_t height_px)
{
    assert_int_equal(ssd0323_window(oled, 0, 0, 128, height_px), 0);
    memset(pixels, 0, (size_t)64 * height_px);
    pixels[0] = 0x50;      /* (0, 0) */
    pixels[64 * 1] = 0x0f; /* (1, 1) */
    assert_int_equal(oled->port->send_data(oled->port->context, pixels, 64u * height_px), 0);
}

static void the_ssd0323_shows_its_picture(void **state)
{
    (void)state;
    static uint8_t pixels[64 * 64];
    for (int turned = 0; turned < 2; turned++) {
        open_board(PANEL_SSD0323, 64);
        const ssd0323 oled = {.port = turned ? &port_without_reset : &port, .display_offset = 76, .turned = turned};
        assert_int_equal(ssd0323_begin(&oled), 0);
        send_grey_picture(&oled, pixels, 64);
        assert_pixel(0, 0, 128, 0, 0, 0); /* not yet shown */
        assert_int_equal(ssd0323_show(&oled), 0);
        assert_pixel(turned ? 127 : 0, turned ? 63 : 0, 128, 85, 85, 85);
        assert_pixel(turned ? 126 : 1, turned ? 62 : 1, 128, 255, 255, 255);
        assert_int_equal(panel_frames(p), 1);
        assert_int_equal(ssd0323_end(&oled), 0);
        assert_pixel(1, 1, 128, 0, 0, 0);
        panel_end(p, now);
        assert_clean();
        (void)close_panel(NULL);
    }
}

static void the_ssd0323_takes_a_part(void **state)
{
    (void)state;
    static const uint8_t part[4] = {0x12, 0x34, 0x56, 0x78};
    open_board(PANEL_SSD0323, 64);
    const ssd0323 oled = {.port = &port, .display_offset = 76};
    assert_int_equal(ssd0323_begin(&oled), 0);
    assert_int_equal(ssd0323_show(&oled), 0);
    assert_int_equal(ssd0323_window(&oled, 10, 20, 4, 2), 0);
    assert_int_equal(port.send_data(NULL, part, sizeof part), 0);
    assert_pixel(13, 20, 128, 4 * 17, 4 * 17, 4 * 17);
    assert_pixel(10, 21, 128, 5 * 17, 5 * 17, 5 * 17);
    panel_end(p, now);
    assert_clean();
}

static void the_ssd1306_shows_its_picture(void **state)
{
    (void)state;
    static uint8_t pixels[1024];
    static const struct {
        uint8_t height_px;
        bool turned, external_supply;
    } cases[] = {{64, false, false}, {64, true, false}, {64, false, true}};
    pixels[0] = 0x01;   /* (0, 0) */
    pixels[129] = 0x80; /* (1, 15) */
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        open_board(PANEL_SSD1306, cases[i].height_px);
        const ssd1306 oled = {.port = i == 2 ? &port_without_reset : &port,
                              .turned = cases[i].turned,
                              .external_supply = cases[i].external_supply};
        assert_int_equal(ssd1306_begin(&oled), 0);
        assert_int_equal(ssd1306_window(&oled, 0, 0, 128, 64), 0);
        assert_int_equal(port.send_data(NULL, pixels, sizeof pixels), 0);
        assert_int_equal(ssd1306_show(&oled), 0);
        assert_pixel(cases[i].turned ? 127 : 0, cases[i].turned ? 63 : 0, 128, 255, 255, 255);
        assert_pixel(cases[i].turned ? 126 : 1, cases[i].turned ? 48 : 15, 128, 255, 255, 255);
        assert_pixel(5, 5, 128, 0, 0, 0);
        assert_int_equal(ssd1306_end(&oled), 0);
        panel_end(p, now);
        assert_clean();
        (void)close_panel(NULL);
    }
}

static void windows_beyond_the_memory_are_refused(void **state)
{
    (void)state;
    open_board(PANEL_SSD1306, 64);
    const ssd0323 grey = {.port = &port};
    const ssd1306 mono = {.port = &port};
    static const uint8_t grey_windows[][4] = {{1, 0, 2, 1}, {0, 0, 3, 1},   {0, 0, 0, 1},
                                              {0, 0, 2, 0}, {126, 0, 4, 1}, {0, 79, 2, 2}};
    static const uint8_t mono_windows[][4] = {{0, 4, 8, 8}, {0, 0, 8, 4},   {0, 0, 0, 8},
                                              {0, 0, 8, 0}, {127, 0, 2, 8}, {0, 56, 8, 16}};
    for (size_t i = 0; i < sizeof grey_windows / sizeof *grey_windows; i++) {
        const uint8_t *w = grey_windows[i];
        assert_int_equal(ssd0323_window(&grey, w[0], w[1], w[2], w[3]), SSD0323_ERROR_WINDOW);
    }
    for (size_t i = 0; i < sizeof mono_windows / sizeof *mono_windows; i++) {
        const uint8_t *w = mono_windows[i];
        assert_int_equal(ssd1306_window(&mono, w[0], w[1], w[2], w[3]), SSD1306_ERROR_WINDOW);
    }
    assert_int_equal(panel_bytes(p), 0);
}

/* Whichever call of the board fails, its error comes back, and nothing is called after it. */
static void errors_of_the_board_come_through(void **state)
{
    (void)state;
    for (int kind = 0; kind < 2; kind++) {
        const ssd0323 grey = {.port = &port};
        const ssd1306 mono = {.port = &port};
        for (int allowed = 0;; allowed++) {
            open_board(kind ? PANEL_SSD1306 : PANEL_SSD0323, 64);
            calls_left = allowed;
            const int error = kind ? ssd1306_begin(&mono) : ssd0323_begin(&grey);
            const int after = calls_left;
            (void)close_panel(NULL);
            if (error == 0) {
                assert_true(allowed > 4);
                break;
            }
            assert_int_equal(error, PORT_ERROR);
            assert_int_equal(after, -1);
        }
        open_board(kind ? PANEL_SSD1306 : PANEL_SSD0323, 64);
        calls_left = 0;
        assert_int_equal(kind ? ssd1306_window(&mono, 0, 0, 128, 64) : ssd0323_window(&grey, 0, 0, 128, 64),
                         PORT_ERROR);
        assert_int_equal(kind ? ssd1306_show(&mono) : ssd0323_show(&grey), PORT_ERROR);
        assert_int_equal(kind ? ssd1306_end(&mono) : ssd0323_end(&grey), PORT_ERROR);
        (void)close_panel(NULL);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(the_ssd0323_shows_its_picture, close_panel),
        cmocka_unit_test_teardown(the_ssd0323_takes_a_part, close_panel),
        cmocka_unit_test_teardown(the_ssd1306_shows_its_picture, close_panel),
        cmocka_unit_test_teardown(windows_beyond_the_memory_are_refused, close_panel),
        cmocka_unit_test_teardown(errors_of_the_board_come_through, close_panel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
