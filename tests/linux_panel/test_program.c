/* SPDX-License-Identifier: MIT */
/*
 * The whole program on a board of fakes with a model of the panel: the pictures that the panel shows, buttons, signals
 * at any moment, and every failure. Whatever happens, lines and device are released, the data sheet is kept to, and
 * unless the program ended of itself the panel is dark.
 */
#include "tests/linux_panel/check.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <glint/glint.h>

#include "examples/linux_panel/program.h"
#include "tests/linux_panel/expected.h"
#include "tests/linux_panel/fake_board.h"
#include "tools/picture/picture.h"

#define LINES "--dc DC --reset RESET --backlight BACKLIGHT"
#define SMALL "sphere-10x6 --controller st7789 --size 40x40 " LINES

static failure why;
static char output[2000];

static int begin(void **state)
{
    (void)state;
    fake_board_begin();
    memset(&why, 0, sizeof why);
    return 0;
}

static int end(void **state)
{
    (void)state;
    fake_board_end();
    return 0;
}

static void all_is_released(void)
{
    assert_int_equal(the_board.lines_held, 0);
    assert_int_equal(the_board.chips_open, 0);
    assert_int_equal(the_board.files_open, 0);
}

/* Runs a command line, then looks at what holds however it ended. */
static int run(const char *line)
{
    static char text[400];
    static char *words[40];
    options o;
    int count = 1;
    words[0] = (char *)(uintptr_t) "glint-panel";
    (void)snprintf(text, sizeof text, "%s", line);
    for (char *word = strtok(text, " "); word != NULL; word = strtok(NULL, " ")) {
        words[count++] = word;
    }
    words[count] = NULL;
    if (options_parse(count, words, &o, &why) != 0) {
        fail_msg("%s", why.text);
    }
    const unsigned fail_allocation = the_board.fail_allocation;
    the_board.fail_allocation = 0; /* not of the test's own */
    const enum panel_kind kind = strstr(line, "ili9341") != NULL ? PANEL_ILI9341 : PANEL_ST7789;
    panel_glass glass = panel_usual_glass(kind);
    glass.x_px = o.glass.x_px;
    glass.y_px = o.glass.y_px;
    panel_close(the_board.panel);
    the_board.panel = panel_open(kind, o.glass.width_px, o.glass.height_px);
    panel_set_glass(the_board.panel, &glass);
    memset(output, 0, sizeof output);
    FILE *out = fmemopen(output, sizeof output, "w");
    the_board.allocations = 0;
    the_board.fail_allocation = fail_allocation;
    const int result = program_run(&o, out, &why);
    the_board.fail_allocation = 0;
    (void)fclose(out);
    panel_end(the_board.panel, the_board.now_ns);
    /* a panel to which half a command was sent has reason to complain */
    const bool whole = the_board.fail_message == 0 && the_board.fail_set == 0;
    for (size_t i = 0; whole && i < panel_violations(the_board.panel); i++) {
        fail_msg("%s", panel_violation(the_board.panel, i));
    }
    all_is_released();
    return result;
}

static bool is_dark(unsigned pixels)
{
    const uint8_t *rgb = panel_picture(the_board.panel);
    uint8_t any = 0;
    for (unsigned i = 0; i < pixels * 3; i++) {
        any |= rgb[i];
    }
    return any == 0;
}

static void shows(const expected_picture *e)
{
    assert_memory_equal(panel_picture(the_board.panel), expected_on_glass(e), (size_t)e->width_px * e->height_px * 3);
}

/* ------------------------------------------------------------------------------------------------------------ pictures
 */

static void a_frame_stays_on_the_panel(void **state)
{
    (void)state;
    assert_int_equal(run(SMALL " --frames 1"), 0);
    shows(&(expected_picture){"sphere-10x6", 40, 40, .tolerance = 16});
    assert_true(the_board.lines[FAKE_BACKLIGHT].level);
    assert_string_equal(output, "");
    assert_true(the_board.longest_delay_ns >= 120000000);
}

static void frames_turn_the_model(void **state)
{
    (void)state;
    assert_int_equal(run(SMALL " --frames 4 --tolerance exact --fps"), 0);
    shows(&(expected_picture){"sphere-10x6", 40, 40, .turn16 = 3 * 512});
    assert_says(output, "fps ");
    assert_says(output, "of the bands");
}

static void without_reset_and_backlight(void **state)
{
    (void)state;
    assert_int_equal(run("sphere-10x6 --controller ili9341 --size 40x40 --dc 4 --frames 1"), 0);
    shows(&(expected_picture){"sphere-10x6", 40, 40, .tolerance = 16});
}

static void each_rotation_of_each_controller(void **state)
{
    (void)state;
    static const char *const controllers[] = {"st7789", "ili9341"};
    char line[200];
    for (unsigned i = 0; i < 8; i++) {
        fake_board_begin();
        (void)snprintf(line, sizeof line,
                       "teapot --controller %s --size 50x70 --offset 52,40 --rotate %u --frames 1 " LINES,
                       controllers[i / 4], i % 4 * 90);
        assert_int_equal(run(line), 0);
        shows(&(expected_picture){"teapot", 50, 70, .quarter_turns = i % 4, .tolerance = 16});
    }
}

static void the_dump_shows_what_the_panel_shows(void **state)
{
    (void)state;
    char path[] = "/tmp/glint-panel-XXXXXX", line[300], error[200];
    picture dumped;
    const int file = mkstemp(path);
    assert_true(file >= 0);
    (void)close(file);
    (void)snprintf(line, sizeof line, SMALL " --frames 3 --dump %s", path);
    assert_int_equal(run(line), 0);
    assert_int_equal(picture_read(path, &dumped, error, sizeof error), 0);
    (void)unlink(path);
    assert_int_equal(dumped.width, 40);
    assert_memory_equal(dumped.rgb, panel_picture(the_board.panel), 40 * 40 * 3);
    picture_free(&dumped);
}

/* The bands of the picture's middle change, those at its ends do not; each transfer takes its time. */
static void a_band_is_left_alone_while_it_is_sent(void **state)
{
    (void)state;
    the_board.slow_us = 3000;
    assert_int_equal(run("teapot --controller st7789 --size 60x240 --frames 3 " LINES), 0);
    shows(&(expected_picture){"teapot", 60, 240, .turn16 = 2 * 512, .tolerance = 16});
    assert_int_equal(the_board.torn, 0);
}

/* ------------------------------------------------------------------------------------------------------------- buttons
 */

static void presses(const char *line, const fake_wait *waits, unsigned count)
{
    the_board.waits = waits;
    the_board.wait_count = count;
    the_board.lines[FAKE_BUTTON].level = the_board.lines[FAKE_BUTTON_2].level = the_board.lines[FAKE_BUTTON_3].level =
        true;
    assert_int_equal(run(line), 0);
    assert_int_equal(the_board.waited, count);
}

static void one_button_turns_and_switches(void **state)
{
    (void)state;
    static const fake_wait waits[] = {
        {FAKE_STRAY_SIGNAL, .line = 0},
        {FAKE_EDGE, .line = FAKE_BUTTON, .level = false, .after_ms = 50},
        {FAKE_EDGE, .line = FAKE_BUTTON, .level = true, .after_ms = 100},
        {FAKE_EDGE, .line = FAKE_BUTTON, .level = false, .after_ms = 300},
        {FAKE_EDGE, .line = FAKE_BUTTON, .level = true, .after_ms = 700},
    };
    presses(SMALL " --button KEY1 --frames 3", waits, 5);
    shows(&(expected_picture){"sphere-10x6", 40, 40, .turn16 = 4096, .tolerance = 64});
    assert_says(output, "frame 1: turned 0.0 degrees, tolerance 1: ");
    assert_says(output, "frame 2: turned 22.5 degrees, tolerance 1: ");
    assert_says(output, "frame 3: turned 22.5 degrees, tolerance 4: ");
}

static void three_buttons(void **state)
{
    (void)state;
    static const fake_wait waits[] = {
        {FAKE_EDGE, .line = FAKE_BUTTON_3, .level = false, .after_ms = 50},
        {FAKE_EDGE, .line = FAKE_BUTTON_3, .level = true, .after_ms = 50},
        {FAKE_EDGE, .line = FAKE_BUTTON_3, .level = false, .after_ms = 50},
        {FAKE_EDGE, .line = FAKE_BUTTON_2, .level = false, .after_ms = 50},
        {FAKE_EDGE, .line = FAKE_BUTTON, .level = false, .after_ms = 50},
    };
    presses(SMALL " --button KEY1 --button KEY2 --button KEY3 --frames 5 --tolerance 15", waits, 5);
    shows(&(expected_picture){"sphere-10x6", 40, 40, .turn16 = (uint16_t)-4096, .tolerance = 0});
    assert_says(output, "frame 5: turned 337.5 degrees, exact: ");
}

/* Of 15, as the program says it of a frame. */
static unsigned bands_sent(unsigned frame)
{
    char start[20];
    unsigned bands = 0;
    (void)snprintf(start, sizeof start, "frame %u: ", frame);
    const char *line = strstr(output, start);
    const char *end = line == NULL ? NULL : strstr(line, " of 15 bands");
    if (end == NULL || sscanf(end - 3, "%*[, ]%u", &bands) != 1) { /* NOLINT(cert-err34-c): two digits */
        fail_msg("%s", output);
    }
    return bands;
}

static void only_what_changed_is_sent(void **state)
{
    (void)state;
    static const fake_wait waits[] = {
        {FAKE_EDGE, .line = FAKE_BUTTON, .level = false, .after_ms = 50},
        {FAKE_EDGE, .line = FAKE_BUTTON_3, .level = false, .after_ms = 50},
    };
    assert_int_equal(run("teapot --controller st7789 --size 60x240 --frames 1 " LINES), 0);
    const uint64_t first = the_board.bytes;
    fake_board_begin();
    presses("teapot --controller st7789 --size 60x240 --button KEY1 --button KEY2 --button KEY3 --frames 3 " LINES,
            waits, 2);
    /* there and back again: the same bands twice, and the first picture on the panel */
    assert_true(the_board.bytes < first * 3);
    shows(&(expected_picture){"teapot", 60, 240, .tolerance = 16});
    assert_int_equal(bands_sent(1), 15);
    assert_in_range(bands_sent(2), 1, 14);
    assert_int_equal(bands_sent(3), bands_sent(2));
}

/* ------------------------------------------------------------------------------------------------------------- signals
 */

static void signals_while_it_waits(void **state)
{
    (void)state;
    static const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < 3; i++) {
        const fake_wait waits[] = {{FAKE_SIGNAL, .number = numbers[i]}};
        fake_board_begin();
        presses(i == 0 ? "sphere-10x6 --controller ili9341 --size 40x40 --button KEY1 " LINES : SMALL " --button KEY1",
                waits, 1);
        assert_true(is_dark(40 * 40));
        assert_false(the_board.lines[FAKE_BACKLIGHT].level);
    }
}

/* At each transfer of two frames, those of begin and show included, until it comes too late. */
static void signals_at_any_moment(void **state)
{
    (void)state;
    unsigned stopped = 0, frames = 1;
    for (unsigned message = 1; message < 200; message++) {
        fake_board_begin();
        the_board.signal_message = message;
        the_board.signal_number = message % 2 != 0 ? SIGINT : SIGTERM;
        assert_int_equal(run(SMALL " --frames 2"), 0);
        if (the_board.messages < message) {
            break;
        }
        if (is_dark(40 * 40)) {
            stopped++;
            assert_false(the_board.lines[FAKE_BACKLIGHT].level);
            frames += panel_frames(the_board.panel) == 0 ? 1 : 0;
        }
    }
    assert_true(stopped > 20); /* only at the end of the last frame is it too late */
    assert_true(frames > 5);   /* many of them within the first frame */
}

/* ------------------------------------------------------------------------------------------------------------ failures
 */

static void fails(const char *line, const char *says)
{
    assert_int_equal(run(line), -1);
    assert_says(why.text, says);
    if (the_board.panel != NULL) {
        assert_true(is_dark(40 * 40));
    }
}

static void what_cannot_be_had(void **state)
{
    (void)state;
    fails(SMALL " --chip gpiochip3", "no such GPIO chip");
    fails(SMALL " --button KEY9", "no line of /dev/gpiochip0 has this name");
    fails(SMALL " --spi /dev/spidev0.1", "SPI is not enabled");
    for (unsigned line = FAKE_BUTTON; line <= FAKE_BACKLIGHT; line++) {
        fake_board_begin();
        the_board.lines[line].request_error = EINVAL;
        fails(SMALL " --button KEY1", "the request failed");
    }
    fake_board_begin();
    the_board.thread_error = EAGAIN;
    fails(SMALL, "cannot start a thread");
    fake_board_begin();
    fails(SMALL " --dump /nonexistent/a.ppm", "/nonexistent/a.ppm");
}

static void transfers_that_fail(void **state)
{
    (void)state;
    unsigned failed = 0;
    for (unsigned message = 1; message < 200; message++) {
        fake_board_begin();
        the_board.fail_message = message;
        the_board.fail_error = EIO;
        if (run(SMALL " --frames 2") == 0) {
            break; /* so many are not sent */
        }
        failed++;
        assert_says(why.text, "/dev/spidev0.0: sending ");
        assert_false(the_board.lines[FAKE_BACKLIGHT].level);
    }
    assert_true(failed > 30);
    assert_true(failed < 199);
}

static void lines_that_fail(void **state)
{
    (void)state;
    unsigned failed = 0;
    for (unsigned set = 1; set < 200; set++) {
        fake_board_begin();
        the_board.fail_set = set;
        if (run(SMALL " --frames 2") == 0) {
            break;
        }
        failed++;
        assert_says(why.text, "cannot set it");
    }
    assert_true(failed > 30);
    assert_true(failed < 199);
}

static void buttons_that_fail(void **state)
{
    (void)state;
    static const fake_wait edge[] = {{FAKE_EDGE, .line = FAKE_BUTTON, .level = false, .after_ms = 50}};
    static const fake_wait error[] = {{FAKE_POLL_ERROR, .number = ENOMEM}};
    the_board.waits = error;
    the_board.wait_count = 1;
    fails(SMALL " --button KEY1", "cannot wait for the buttons");
    fake_board_begin();
    the_board.waits = edge;
    the_board.wait_count = 1;
    the_board.fail_read = 1;
    fails(SMALL " --button KEY1", "line KEY1: cannot read it");
}

static void what_the_panel_answers(void **state)
{
    (void)state;
    the_board.answer = 0x00;
    fails(SMALL " --ask", "does not answer (MISO stays low)");
    fake_board_begin();
    the_board.answer = 0xFF;
    fails(SMALL " --ask", "does not answer (MISO stays high)");
    fake_board_begin();
    the_board.answer = 0x08;
    fails(SMALL " --ask", "that it sleeps (power mode 0x08)");
    fake_board_begin();
    the_board.answer = 0x98;
    assert_int_equal(run(SMALL " --ask --frames 1"), 0);
    fake_board_begin();
    the_board.answer = 0x98;
    the_board.fail_message = 8;
    the_board.fail_error = EIO;
    fails(SMALL " --ask --frames 1", "failed");
}

static void memory_that_cannot_be_had(void **state)
{
    (void)state;
    unsigned failed = 0;
    for (unsigned number = 1; number < 300; number++) {
        fake_board_begin();
        the_board.fail_allocation = number;
        if (run(SMALL " --frames 1 --button KEY1 --dump /dev/null") == 0) {
            break; /* so many are not taken */
        }
        failed++;
        assert_says(why.text, "emory");
    }
    assert_true(failed >= 10);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_frame_stays_on_the_panel),
        TEST(frames_turn_the_model),
        TEST(without_reset_and_backlight),
        TEST(each_rotation_of_each_controller),
        TEST(the_dump_shows_what_the_panel_shows),
        TEST(a_band_is_left_alone_while_it_is_sent),
        TEST(one_button_turns_and_switches),
        TEST(three_buttons),
        TEST(only_what_changed_is_sent),
        TEST(signals_while_it_waits),
        TEST(signals_at_any_moment),
        TEST(what_cannot_be_had),
        TEST(transfers_that_fail),
        TEST(lines_that_fail),
        TEST(buttons_that_fail),
        TEST(what_the_panel_answers),
        TEST(memory_that_cannot_be_had),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
